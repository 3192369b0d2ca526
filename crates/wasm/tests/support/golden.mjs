// Reads tests/golden/sphere.csv, whose rows docs/formats.md describes.

import { readFileSync } from "node:fs";

const FILE = new URL("../../../../tests/golden/sphere.csv", import.meta.url);

const rows = readFileSync(FILE, "utf8")
  .split("\n")
  .filter((line) => line && !line.startsWith("#"))
  .slice(1)
  .map((line) => {
    const [format, light, material, channel, array, exponents, numbers] = line.split(",");
    const parsed = (text) => text.split(" ").filter(Boolean).map(Number);
    const pair = [light, material, channel].join(" ").trim();
    return { format, pair, array, exponents: parsed(exponents), numbers: parsed(numbers) };
  });

/** The row of an array, of a pair or of all. */
export function row(format, array, pair = "") {
  const found = rows.find((r) => r.format === format && r.array === array && r.pair === pair);
  if (!found) throw new Error(`the golden file has no ${format} ${pair} ${array}`);
  return found;
}

/** The names of the pairs. */
export const PAIRS = rows.filter((r) => r.format === "f32" && r.array === "light").map((r) => r.pair);

/** x, y and z of a format's normals, in its own arrays. */
export function normals(format, array) {
  const { numbers } = row(format, "normals");
  return [0, 1, 2].map((axis) => array.from(numbers.filter((_, k) => k % 3 === axis)));
}

/** The CRC-32 of an array's bytes in memory. Node 20 does not export zlib's. */
export function crc32(array) {
  let sum = 0xffffffff;
  for (const byte of new Uint8Array(array.buffer)) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}
