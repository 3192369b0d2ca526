// What the page looks like, as PNG of 256 colors.

import { deflateSync, crc32 as crc } from "node:zlib";
import { quantized } from "../quantize.js";
import { launch, open, serve } from "./support.js";

/** Widths and heights of docs/site-WIDTH.png. */
export const SIZES = [[390, 844], [1440, 900]];

/** Takes the pictures: pairs of a width and a PNG. */
export async function screenshots() {
  const [server, browser] = [await serve(), await launch()];
  const pictures = [];
  for (const [width, height] of SIZES) {
    const { page } = await open(browser, server.address, { width, height });
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

/** A PNG of at most 256 colors. */
function encode(pixels, width, height) {
  const { palette, index } = quantized(pixels);
  const keyOf = (at) => (pixels[at] << 16) | (pixels[at + 1] << 8) | pixels[at + 2];
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
