// Reads a PNG of 8 bits in red, green, blue and opacity.

import assert from "node:assert/strict";
import { inflateSync } from "node:zlib";

/** Width, height, and the pixels row by row from the top. */
export function readPng(file) {
  const parts = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    if (file.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  }
  const [width, height] = [file.readUInt32BE(16), file.readUInt32BE(20)];
  assert.deepEqual([...file.subarray(24, 26)], [8, 6]);
  const [bytes, stride] = [inflateSync(Buffer.concat(parts)), 4 * width];
  const pixels = new Uint8ClampedArray(stride * height);
  for (let row = 0; row < height; row++) {
    const filter = bytes[row * (stride + 1)];
    for (let k = 0; k < stride; k++) {
      const at = row * stride + k;
      const left = k < 4 ? 0 : pixels[at - 4];
      const [above, corner] = row ? [pixels[at - stride], k < 4 ? 0 : pixels[at - stride - 4]] : [0, 0];
      const away = [left, above, corner].map((one) => Math.abs(left + above - corner - one));
      const paeth = away[0] <= away[1] && away[0] <= away[2] ? left : away[1] <= away[2] ? above : corner;
      const predicted = [0, left, above, (left + above) >> 1, paeth][filter];
      pixels[at] = (bytes[row * (stride + 1) + 1 + k] + predicted) & 255;
    }
  }
  return { width, height, pixels };
}
