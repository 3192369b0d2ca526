// A worker: reads a panorama, projects it and finds its sources. Says { stage, share } as it goes,
// then { light } or { fault }.

import parseExr from "../vendor/parse-exr.js";
import { linear } from "./color.js";
import { project, resized } from "./project.js";
import { FINE, pursue } from "./pursuit.js";
import { parseHdr, primariesNote } from "./rgbe.js";

/** Float samples of parse-exr. */
const FLOAT = 1015;
const ONE_CHANNEL = 1028;

/** Rows of a block, by the number of the compression. */
const ROWS = [1, 1, 1, 16, 32, 16, 32, 32, 32, 256];

/**
 * Throws for a file that ends too early: parse-exr would not end. Tiles it checks by itself.
 *
 * @param {ArrayBuffer} buffer
 * @returns {string} what is to be said of it
 */
function checkExr(buffer) {
  const [bytes, view] = [new Uint8Array(buffer), new DataView(buffer)];
  let at = 8;
  const text = () => {
    const end = bytes.indexOf(0, at);
    if (end < 0 || end - at > 255) throw new Error("it ends within its header");
    const found = String.fromCharCode(...bytes.subarray(at, end));
    at = end + 1;
    return found;
  };
  let [rows, height, tiled, note] = [1, 0, false, ""];
  for (let name = text(); name !== ""; name = text()) {
    text();
    const size = view.getUint32(at, true);
    at += 4;
    if (at + size > bytes.length) throw new Error("it ends within its header");
    if (name === "compression") rows = ROWS[bytes[at]] ?? 1;
    if (name === "dataWindow") height = view.getInt32(at + 12, true) - view.getInt32(at + 4, true) + 1;
    if (name === "tiles") tiled = true;
    if (name === "chromaticities") note = primariesNote(Array.from({ length: 8 }, (_, k) => view.getFloat32(at + 4 * k, true)));
    at += size;
  }
  if (tiled) return note;
  for (let block = 0; block < Math.ceil(height / rows); block++, at += 8) {
    const place = at + 8 <= bytes.length ? Number(view.getBigUint64(at, true)) : bytes.length;
    if (place + 8 > bytes.length || place + 8 + view.getUint32(place + 4, true) > bytes.length) {
      throw new Error("it ends within its pixels");
    }
  }
  return note;
}

/** @param {ArrayBuffer} buffer */
function exr(buffer) {
  const note = checkExr(buffer);
  const { width, height, data, format } = parseExr(buffer, FLOAT);
  const stride = format === ONE_CHANNEL ? 1 : 4;
  // Its rows run from the bottom, and a map of one channel is gray.
  const map = new Float32Array(3 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [from, to] = [stride * ((height - 1 - y) * width + x), 3 * (y * width + x)];
      for (let c = 0; c < 3; c++) map[to + c] = data[from + (stride === 1 ? 0 : c)];
    }
  }
  return { width, height, stride: 3, data: map, note };
}

/** A picture: sRGB, white to a radiance of 1. */
async function picture(/** @type {Blob} */ file) {
  const bitmap = await createImageBitmap(file, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("this browser decodes no pictures in workers");
  context.drawImage(bitmap, 0, 0);
  const bytes = context.getImageData(0, 0, width, height).data;
  const table = Float32Array.from({ length: 256 }, (_, code) => linear(code / 255));
  return { width, height, stride: 4, data: bytes, table, note: "" };
}

/** @param {Blob} file @param {string} name */
async function read(file, name) {
  const buffer = await file.arrayBuffer();
  const [a, b, c, d] = new Uint8Array(buffer, 0, Math.min(4, buffer.byteLength));
  if (a === 0x76 && b === 0x2f && c === 0x31 && d === 0x01) return exr(buffer);
  if (a === 0x23 && b === 0x3f) return parseHdr(buffer);
  if ((a === 0xff && b === 0xd8) || (a === 0x89 && b === 0x50)) return picture(file);
  const ending = name.split(".").pop() ?? "";
  if (/^(hdr|exr|jpe?g|png)$/i.test(ending)) throw new Error(`it is not a valid .${ending} file`);
  throw new Error(`${ending} files are not read; expected .hdr, .exr, .jpg or .png`);
}

addEventListener("message", async ({ data: { file, name } }) => {
  try {
    postMessage({ stage: "decoding", share: 0 });
    const map = await read(file, name);
    const progress = (/** @type {string} */ stage, from = 0, to = 1) => {
      let last = 0;
      return (/** @type {number} */ share) => {
        if (share - last < 0.05) return;
        last = share;
        postMessage({ stage, share: from + (to - from) * share });
      };
    };
    const light = project(map, progress("projecting"));
    const fine = project(resized(map), progress("finding sources", 0, 0.3), FINE);
    const sources = pursue(fine, progress("finding sources", 0.3));
    const { width, height, note } = map;
    postMessage({ light: { ...light, sources }, width, height, note });
  } catch (fault) {
    postMessage({ fault: fault instanceof Error ? fault.message : String(fault) });
  }
});
