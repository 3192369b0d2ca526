// Each wrong input throws an error of one line.

import assert from "node:assert/strict";
import { test } from "node:test";
import { normals, row } from "./support/golden.mjs";
import { bytes } from "./support/modules.mjs";
import { load, normalized } from "../eigenshade.mjs";

const { f32, q15, q31 } = await load(bytes("all", ""));
const LIGHT = row("f32", "light", "park 07-velvet g").numbers;
const MATERIAL = row("f32", "material", "park 07-velvet g").numbers;

const fails = (what, kind, message) => assert.throws(what, { name: kind, message });

test("coefficients", () => {
  for (const format of [f32, q15, q31]) {
    fails(() => format.light(LIGHT.slice(1)), "RangeError",
      "light: 99 coefficients, this table takes 1, 4, 9, 16, 25, 36, 49, 64, 81, 100");
    fails(() => format.light([...LIGHT, ...LIGHT]), "RangeError",
      "light: 200 coefficients, this table takes 1, 4, 9, 16, 25, 36, 49, 64, 81, 100; leave out the rest");
    fails(() => format.material([]), "RangeError",
      "material: 0 coefficients, this table takes 1, 2, 5, 8, 14, 20, 30, 40");
    fails(() => format.material("red"), "TypeError",
      "material: an array of numbers expected, string found");
    for (const bad of [NaN, Infinity, 1e300, 3e38, -1.1e15, undefined, "red"]) {
      fails(() => format.light(LIGHT.with(7, bad)), "RangeError",
        `light: coefficient 7 is ${bad}, expected a number from -1e15 to 1e15`);
    }
  }
});

test("the largest coefficients that are taken are shaded", () => {
  const all = (count) => Array.from({ length: count }, (_, k) => (k % 3 ? -1e15 : 1e15));
  f32.light(all(100)).material(all(40));
  assert.ok(f32.project().every(Number.isFinite));
  assert.ok(f32.collapse().shade([0, 1, 0.6], [0, 0, 0], [1, 0, 0.8]).every(Number.isFinite));
});

test("an order of steps", async () => {
  const fresh = await load(bytes("all", ""));
  for (const format of [fresh.f32, fresh.q15, fresh.q31]) {
    fails(() => format.project(), "Error", "project: no light yet; set one first");
    format.light(LIGHT);
    fails(() => format.project(), "Error", "project: no material yet; set one first");
    fails(() => format.collapse(), "Error",
      "collapse: no coefficients d yet; call project first");
    format.material(MATERIAL).project();
    fails(() => format.shade([0], [0], [1]), "Error", "shade: no scene yet; call collapse first");
  }
});

test("an order of steps with more in floats", async () => {
  const { f32: more } = await load(bytes("floats", ""));
  fails(() => more.relight(), "Error", "relight: no light yet; set one first");
  fails(() => more.light(LIGHT).relight(), "Error", "relight: no material yet; set one first");
  fails(() => more.bake(), "Error", "bake: no scene yet; call collapse first");
  more.material(MATERIAL).relight();
  more.collapse();
  fails(() => more.lookUp([0], [0], [1]), "Error", "lookUp: no map yet; call bake first");
  more.bake();
  fails(() => more.lookUp([0], [0], [2]), "RangeError", "lookUp: normal 0 is (0, 0, 2), expected a unit vector with z >= 0");
  assert.equal(more.exports.f32_look_up(0xffffffff), 0);
  // d of a new light: the map is still that of the old.
  more.relight();
  fails(() => more.lookUp([0], [0], [1]), "Error", "lookUp: no map yet; call bake first");
  const fresh = await load(bytes("floats", ""));
  assert.equal(fresh.exports.f32_bake(), 0);
  fails(() => f32.relight(), "Error", "f32: this module has no f32_relight; use floats.wasm");
  fails(() => f32.bake(), "Error", "f32: this module has no f32_bake; use floats.wasm");
  fails(() => f32.lookUp([0], [0], [1]), "Error", "f32: this module has no f32_look_up; use floats.wasm");
});

test("normals", () => {
  for (const format of [f32, q15, q31]) {
    format.light(LIGHT).material(MATERIAL).project();
    format.collapse();
    fails(() => format.shade([0, 0], [0], [1, 1]), "RangeError", "shade: x has 2 numbers, y has 1");
    fails(() => format.shade([0], [0], [1], new Int32Array(2)), "RangeError",
      "shade: x has 1 numbers, irradiance has 2");
    for (const bad of [[NaN, 0, 1], [0, Infinity, 1], [0, 0, 2], [0, 0, -1], [0, 0, 0]]) {
      const at = (axis) => [0, 0, bad[axis]].with(0, axis === 2 ? 1 : 0).with(1, axis === 2 ? 1 : 0);
      fails(() => format.shade(at(0), at(1), at(2)), "RangeError",
        `shade: normal 2 is (${bad.join(", ")}), expected a unit vector with z >= 0`);
    }
    assert.equal(format.shade([], [], []).length, 0);
  }
  const [x, y, z] = normals("q15", Int16Array);
  fails(() => q15.shade(x.with(1, 0), y.with(1, 0), z), "RangeError",
    "shade: normal 1 is (0, 0, 0), expected a unit vector with z >= 0");
});

test("normals of a map of 8 bits, and behind the rim", () => {
  const [x, y, z] = normalized([254, 255, 0], [0, 0, 3], [0, -31, 4]);
  assert.deepEqual([...x, ...z], [1, 1, 0, 0, 0, Math.fround(0.8)]);
  for (const format of [f32, q15, q31]) {
    format.light(LIGHT).material(MATERIAL).project();
    format.collapse();
    const [first, second] = format.shade(x, y, z);
    assert.equal(first, second);
  }
  for (const bad of [[0, 0, 0], [NaN, 0, 1], [Infinity, 0, 1], [0, 1, -0.2]]) {
    const [a, b, c] = bad;
    fails(() => normalized([0, a], [0, b], [1, c]), "RangeError",
      `normalized: vector 1 is (${bad.join(", ")}), which is zero, not finite, or points away`);
  }
  fails(() => normalized([0, 0], [0], [1, 1]), "RangeError", "normalized: x has 2 numbers, y has 1");
});

test("the module itself stays within its buffers", () => {
  const { exports } = f32;
  for (const format of [q15, q31]) {
    format.light(LIGHT).material(MATERIAL).project();
    format.collapse();
    const z = format.normals.subarray(2 * format.shape.normals);
    for (const usable of [0, 3, 1024]) {
      format.normals.fill(0);
      z.fill(2 ** format.bits - 1, 0, usable);
      assert.equal(exports[`${format.name}_shade`](0xffffffff), usable);
    }
  }
  assert.equal(exports.f32_shade(0xffffffff), 0);
  assert.equal(exports.nine_terms(0xffffffff), 1024);
});

test("a source that is no module", async () => {
  await assert.rejects(load(new Uint8Array([1, 2, 3])), WebAssembly.CompileError);
});
