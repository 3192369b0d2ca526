// node site/pack.js PACKED FILE: makes the page's file of a symmetric object that `eigenshade pack-object`
// packed. `src/packed.js` reads it.

import { readFileSync, writeFileSync } from "node:fs";
import { deflateSync } from "node:zlib";
import { quantized } from "./quantize.js";
import { FIRST, began } from "./src/begin.js";
import { toByte } from "./src/packed.js";
import { LIGHT } from "./src/parts.js";

const [packed, file] = process.argv.slice(2);
const bytes = readFileSync(packed);
const [width, height, count] = [6, 8, 10].map((at) => bytes.readUInt16LE(at));
if (count > 4) throw new Error(`${packed} has ${count} regions, expected at most 4`);
const share = (at) => bytes.readUInt16LE(at) / 32767;
const regions = Array.from({ length: count }, (_, k) => ({ metallic: share(12 + 6 * k), roughness: share(14 + 6 * k), pixels: 0 }));
const rows = 12 + 6 * count;
const records = rows + 4 * (height + 1);
const record = (row) => records + 6 * bytes.readUInt32LE(rows + 4 * row);

/** Of each pixel its record of six bytes, and its region. */
const pixels = Array.from({ length: width * height }, () => ({ six: Buffer.alloc(6), region: 0 }));
let right = 0;
for (let row = 0; row < height; row++) {
  for (let at = record(row); at < record(row + 1); ) {
    const [start, length, region] = [0, 2, 4].map((k) => bytes.readUInt16LE(at + k));
    at += 6;
    for (let column = start; column < start + length; column++, at += 6) {
      pixels[row * width + column] = { six: bytes.subarray(at, at + 6), region };
      regions[region].pixels++;
      right = Math.max(right, column + 1);
    }
  }
}
const half = right - width / 2;
const kept = Array.from({ length: half * height }, (_, k) => pixels[Math.floor(k / half) * width + width / 2 + (k % half)]);
const { palette, index } = quantized(Buffer.concat(kept.map(({ six }) => six.subarray(2))));
const codes = [0, 1].map((axis) => Buffer.from(kept.map(({ six }) => six.readInt8(axis) + 128)));
const differences = codes.map((plane) => plane.map((code, k) => code - (k < half ? 0 : plane[k - half])));
const colors = Buffer.from(kept.map(({ six }) => index.get(six.readUIntBE(2, 3)) ?? 0));
const covered = Buffer.from(kept.map(({ six, region }) => 4 * Math.round((63 * six[5]) / 255) + region));

/**
 * The screen error of a sphere of all terms against direct integration, mean and 95th percentile, from
 * tables/inputs/sources.errors.csv: between the roughnesses that it has.
 */
const lines = readFileSync(new URL("../tables/inputs/sources.errors.csv", import.meta.url), "utf8").split("\n").filter((line) => !line.startsWith("#"));
const names = lines[0].split(",");
function direct({ metallic, roughness }, sources) {
  const wanted = { light: LIGHT, sources, degree: 9, order: 7, base: metallic < 0.5 ? "dielectric" : "metal" };
  const row = lines.map((line) => line.split(",")).find((fields) => Object.entries(wanted).every(([name, value]) => fields[names.indexOf(name)] === String(value)));
  if (!row) throw new Error(`sources.errors.csv has no row of ${JSON.stringify(wanted)}`);
  const tenth = Math.min(6, Math.max(1, 10 * roughness));
  const below = Math.min(5, Math.floor(tenth));
  return Object.fromEntries([["mean", "mean"], ["most", "p95"]].map(([key, name]) => {
    const [a, b] = [below, below + 1].map((k) => Number(row[names.indexOf(`${name}_0.${k}`)]));
    return [key, a + (tenth - below) * (b - a)];
  }));
}

const { palettes, parts, exposure } = await began(regions);
regions.forEach((region, k) => (region.direct = direct(region, parts.costs[2 * k + 1].sources)));
const nodes = palettes.length / 4;
const first = Buffer.from([0, 1, 2].flatMap((c) => Array.from({ length: nodes }, (_, k) => toByte(palettes[4 * k + c]))));
const about = Buffer.from(`${JSON.stringify({ half, height, regions, ...FIRST, exposure })}\n`);
writeFileSync(file, deflateSync(Buffer.concat([
  about, ...differences, colors, covered, palette, first.map((byte, k) => byte - (k ? first[k - 1] : 0)),
]), { level: 9, memLevel: 9 }));
