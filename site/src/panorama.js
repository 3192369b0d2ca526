// A worker: reads a panorama and projects it. Says { stage, share } as it goes, then { light } or { fault }.

import parseExr from "../vendor/parse-exr.js";
import { project } from "./project.js";
import { parseHdr } from "./rgbe.js";

/** Float samples of parse-exr. */
const FLOAT = 1015;
const ONE_CHANNEL = 1028;

/** @param {ArrayBuffer} buffer */
function exr(buffer) {
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
  return { width, height, stride: 3, data: map };
}

/** A picture: sRGB, white to a radiance of 1. */
async function picture(/** @type {Blob} */ file) {
  const bitmap = await createImageBitmap(file, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("this browser decodes no pictures in workers");
  context.drawImage(bitmap, 0, 0);
  const bytes = context.getImageData(0, 0, width, height).data;
  const linear = Float32Array.from({ length: 256 }, (_, code) => {
    const encoded = code / 255;
    return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
  });
  return { width, height, stride: 4, data: Float32Array.from(bytes, (code) => linear[code]) };
}

/** @param {Blob} file @param {string} name */
async function read(file, name) {
  const buffer = await file.arrayBuffer();
  const [a, b, c, d] = new Uint8Array(buffer, 0, Math.min(4, buffer.byteLength));
  if (a === 0x76 && b === 0x2f && c === 0x31 && d === 0x01) return exr(buffer);
  if (a === 0x23 && b === 0x3f) return parseHdr(buffer);
  if ((a === 0xff && b === 0xd8) || (a === 0x89 && b === 0x50)) return picture(file);
  throw new Error(`${name.split(".").pop()} files are not read; expected .hdr, .exr, .jpg or .png`);
}

addEventListener("message", async ({ data: { file, name } }) => {
  try {
    postMessage({ stage: "decoding", share: 0 });
    const map = await read(file, name);
    let last = 0;
    const light = project(map, (share) => {
      if (share - last < 0.05) return;
      last = share;
      postMessage({ stage: "projecting", share });
    });
    const { width, height } = map;
    postMessage({ light, width, height });
  } catch (fault) {
    postMessage({ fault: fault instanceof Error ? fault.message : String(fault) });
  }
});
