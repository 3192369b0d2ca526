// Modules with your own table, as `crates/wasm/build` makes them.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { load } from "../eigenshade.mjs";

const ROOT = fileURLToPath(new URL("../../../", import.meta.url));
const LAMBERTIAN = join(ROOT, "firmware/tables/lambertian.bin");
const folder = mkdtempSync(join(tmpdir(), "eigenshade-"));

/** Builds modules with the table at `path`: the exit status and the output. */
function build(path, ...modules) {
  const environment = { ...process.env, EIGENSHADE_TABLE: path };
  const { status, stdout, stderr } = spawnSync(join(ROOT, "crates/wasm/build"), ["--to", folder, ...modules],
    { env: environment, encoding: "utf8" });
  return { status, output: stdout + stderr };
}

/** Irradiance of a white matte: A_l / π of its light's zonal coefficients, and of one that is not. */
function matte([ambient, vertical, facing, side, , , zonal], [x, y, z]) {
  const first = Math.sqrt(3 / (4 * Math.PI));
  return ambient * Math.sqrt(1 / (4 * Math.PI))
    + (2 / 3) * first * (facing * z - vertical * y - side * x)
    + (1 / 4) * zonal * Math.sqrt(5 / (16 * Math.PI)) * (3 * z * z - 1);
}

test("a Lambertian table: its sizes, and what it shades", async () => {
  const { status, output } = build(LAMBERTIAN, "floats.simd", "q15");
  assert.equal(status, 0, output);
  for (const [module, name, tolerance] of [["floats.simd", "f32", 2e-6], ["q15", "q15", 1e-3]]) {
    const { [name]: format, ...shape } = await load(readFileSync(join(folder, `${module}.wasm`)));
    assert.deepEqual([shape.degree, shape.order, shape.components], [2, 0, 9]);
    const light = [3.5, 0.4, 1, -0.3, 0, 0, 0.5, 0, 0];
    format.light(light).material([2]);
    format.project();
    const found = format.collapse().shade([0, 0.6, -0.36], [0, 0, 0.48], [1, 0.8, 0.8]);
    [[0, 0, 1], [0.6, 0, 0.8], [-0.36, 0.48, 0.8]].forEach((normal, k) => {
      const value = name === "f32" ? found[k] : found[k] * 2 ** format.exponent;
      const expected = matte(light, normal);
      assert.ok(Math.abs(value - expected) <= tolerance, `${module}: ${value} for ${expected}`);
    });
    assert.throws(() => format.light(Array(16).fill(0)), /this table takes 1, 4, 9; leave out the rest/);
  }
});

test("unsuitable tables", () => {
  const damaged = join(folder, "damaged.bin");
  const whole = readFileSync(LAMBERTIAN);
  writeFileSync(damaged, whole.subarray(0, whole.length >> 1));
  for (const [path, ...words] of [
    ["lambertian.bin", "give the whole path"],
    [join(folder, "nowhere.bin"), "nowhere.bin", "No such file"],
    [damaged, "damaged.bin"],
  ]) {
    const { status, output } = build(path, "f32");
    assert.notEqual(status, 0, path);
    for (const word of ["EIGENSHADE_TABLE", ...words]) assert.ok(output.includes(word), `${word}: ${output}`);
  }
});

test("an unknown module", () => {
  const { status, output } = build(LAMBERTIAN, "f16");
  assert.equal(status, 1);
  assert.ok(output.includes("no module is called `f16`"), output);
});
