// What the page looks like, as PNG of 256 colors.

import { deflateSync, crc32 as crc } from "node:zlib";
import { launch, open, serve } from "./support.js";

/** Widths and heights of docs/site-WIDTH.png. */
export const SIZES = [[360, 740], [1440, 900]];

/** Takes the pictures: pairs of a width and a PNG. */
export async function screenshots() {
  const [server, browser] = [await serve(), await launch()];
  const pictures = [];
  for (const [width, height] of SIZES) {
    const { page } = await open(browser, server.address, { width, height });
    // Thumbnails are drawn as they come into view.
    await page.waitForTimeout(500);
    const shot = (await page.screenshot()).toString("base64");
    const base64 = await page.evaluate(async (shot) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${shot}`)).blob());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let text = "";
      for (let k = 0; k < data.length; k += 8192) text += String.fromCharCode(...data.subarray(k, k + 8192));
      return btoa(text);
    }, shot);
    pictures.push([width, encode(Buffer.from(base64, "base64"), width, height)]);
  }
  await browser.close();
  server.close();
  return pictures;
}

/** A PNG of at most 256 colors, chosen by halving boxes of colors at the middle of their widest side. */
function encode(pixels, width, height) {
  const counts = new Map();
  const keyOf = (at) => (pixels[at] << 16) | (pixels[at + 1] << 8) | pixels[at + 2];
  for (let at = 0; at < pixels.length; at += 4) counts.set(keyOf(at), (counts.get(keyOf(at)) ?? 0) + 1);
  const channel = (key, c) => (key >> (16 - 8 * c)) & 255;
  const boxOf = (keys) => {
    const spans = [0, 1, 2].map((c) => {
      const values = keys.map((key) => channel(key, c));
      return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
    });
    const widest = spans.indexOf(Math.max(...spans));
    const weight = keys.reduce((sum, key) => sum + counts.get(key), 0);
    return { keys, widest, rank: spans[widest] ** 2 * Math.sqrt(weight) };
  };
  const boxes = [boxOf([...counts.keys()])];
  while (boxes.length < 256) {
    boxes.sort((a, b) => a.rank - b.rank);
    const { keys, widest, rank } = boxes.pop();
    if (rank === 0) break;
    const values = keys.map((key) => channel(key, widest));
    const middle = (values.reduce((a, b) => Math.max(a, b)) + values.reduce((a, b) => Math.min(a, b))) / 2;
    boxes.push(boxOf(keys.filter((_, k) => values[k] <= middle)), boxOf(keys.filter((_, k) => values[k] > middle)));
  }
  const palette = Buffer.alloc(768);
  const index = new Map();
  boxes.forEach(({ keys }, place) => {
    const weight = keys.reduce((sum, key) => sum + counts.get(key), 0);
    for (let c = 0; c < 3; c++) {
      palette[3 * place + c] = Math.round(keys.reduce((sum, key) => sum + counts.get(key) * channel(key, c), 0) / weight);
    }
    keys.forEach((key) => index.set(key, place));
  });
  const rows = Buffer.alloc(height * (width + 1));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) rows[y * (width + 1) + x + 1] = index.get(keyOf(4 * (y * width + x)));
  }
  const chunk = (name, data) => {
    const part = Buffer.concat([Buffer.alloc(4), Buffer.from(name), data, Buffer.alloc(4)]);
    part.writeUInt32BE(data.length, 0);
    part.writeUInt32BE(crc(part.subarray(4, -4)), part.length - 4);
    return part;
  };
  const head = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 3, 0, 0, 0]);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
  return Buffer.concat([signature, chunk("IHDR", head), chunk("PLTE", palette), chunk("IDAT", deflateSync(rows, { level: 9 })), chunk("IEND", Buffer.alloc(0))]);
}
