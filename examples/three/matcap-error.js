// node matcap-error.js [--check]: the error of matcaps by their size, and the time of a new one.
// Writes results/matcap.csv and a table of README.md. Errors are those of a bilinear look-up of a
// sphere seen from far away, in half floats, relative to the peak of `scene.shade`.

import { DataUtils } from "three";
import { Scene } from "../../packages/eigenshade/src/index.js";
import { matcap } from "./matcap.js";
import { checkRows, markdown, percent, putTable, writeRows } from "./tables.js";

const COMMAND = "node matcap-error.js";
const PAIRS = ["lobby", "park", "studio"].flatMap((light) =>
  ["gold-metallic-paint", "red-fabric2", { baseColor: "#a0522d", roughness: 0.5 }].map((material) => ({ light, material })));
const NORMALS = 20_000;
const [x, y, z] = [0, 1, 2].map(() => new Float32Array(NORMALS));
for (let k = 0; k < NORMALS; k++) {
  const [radius, around] = [Math.sqrt((k + 0.5) / NORMALS), k * Math.PI * (3 - Math.sqrt(5))];
  [x[k], y[k], z[k]] = [radius * Math.cos(around), radius * Math.sin(around), Math.sqrt(1 - radius * radius)];
}
const half = (number) => DataUtils.fromHalfFloat(DataUtils.toHalfFloat(Math.max(0, number)));

/** A bilinear look-up, clamped to the edge. */
function lookup(texels, size, u, v) {
  const place = (at) => {
    const shifted = Math.min(size - 1, Math.max(0, at * size - 0.5));
    const low = Math.min(size - 2, Math.floor(shifted));
    return [low, shifted - low];
  };
  const [[column, right], [row, up]] = [place(u), place(v)];
  const texel = (c, r) => half(texels[r * size + c]);
  const mix = (r) => texel(column, r) * (1 - right) + texel(column + 1, r) * right;
  return mix(row) * (1 - up) + mix(row + 1) * up;
}

const rows = [];
for (const size of [32, 64, 128, 256]) {
  const shade = matcap(size);
  const all = { rms: [], worst: [] };
  let time = Infinity;
  for (const pair of PAIRS) {
    const scene = await Scene.create(pair);
    const expected = scene.shade(x, y, z);
    const peak = Math.max(...["r", "g", "b"].map((channel) => expected[channel].reduce((a, b) => Math.max(a, b))));
    let [sum, worst] = [0, 0];
    const texels = shade(scene);
    for (const channel of ["r", "g", "b"]) {
      for (let k = 0; k < NORMALS; k++) {
        const error = Math.abs(lookup(texels[channel], size, 0.495 * x[k] + 0.5, 0.495 * y[k] + 0.5) - Math.max(0, expected[channel][k])) / peak;
        sum += error * error;
        worst = Math.max(worst, error);
      }
    }
    all.rms.push(Math.sqrt(sum / (3 * NORMALS)));
    all.worst.push(worst);
    for (let turn = 0; turn < 5; turn++) {
      const start = performance.now();
      shade(scene.turn({ yaw: 0.1 * turn }));
      time = Math.min(time, performance.now() - start);
    }
  }
  const [rms, worst] = [all.rms, all.worst].map((some) => some.sort((a, b) => a - b));
  rows.push({
    size, bytes: 8 * size * size, rms_median: rms[4].toPrecision(3), rms_largest: rms.at(-1).toPrecision(3),
    worst: worst.at(-1).toPrecision(3), shade_ms: time.toPrecision(2),
  });
}
if (process.argv.includes("--check")) {
  checkRows("matcap", COMMAND, rows, ["size", "bytes", "rms_median", "rms_largest", "worst"]);
} else {
  writeRows("matcap", COMMAND, rows);
  putTable("matcap", markdown(
    ["texels", "bytes", "rms, median, % of the peak", "largest rms", "worst pixel", "ms to shade"],
    rows.map((row) => [`${row.size} × ${row.size}`, row.bytes.toLocaleString("en-US"), percent(row.rms_median), percent(row.rms_largest), percent(row.worst), row.shade_ms]),
  ));
}
