// The golden file in every format, with and without SIMD.

import assert from "node:assert/strict";
import { test } from "node:test";
import { PAIRS, crc32, normals, row } from "./support/golden.mjs";
import { VARIANTS, bytes } from "./support/modules.mjs";
import { load } from "../eigenshade.mjs";

const largest = (numbers) => numbers.reduce((most, number) => Math.max(most, Math.abs(number)), 0);

function assertNear(found, expected, what) {
  const [tolerance] = row("f32", "tolerance").numbers;
  assert.equal(found.length, expected.length, what);
  const most = tolerance * largest(expected);
  expected.forEach((number, k) => {
    assert.ok(Math.abs(found[k] - number) <= most, `${what} ${k}: ${found[k]} for ${number}`);
  });
}

/** Every answer in floats, in the order of the file. */
function floats(format) {
  return PAIRS.flatMap((pair) => {
    format.light(row("f32", "light", pair).numbers).material(row("f32", "material", pair).numbers);
    const d = format.project();
    const irradiance = format.collapse().shade(...normals("f32", Float32Array));
    return [d, irradiance];
  });
}

for (const variant of VARIANTS) {
  for (const name of ["f32", "floats", "all"]) {
    test(`f32 of ${name}${variant}.wasm is within the tolerance`, async () => {
      const { f32 } = await load(bytes(name, variant));
      const found = floats(f32);
      PAIRS.forEach((pair, k) => {
        assertNear(found[2 * k], row("f32", "d", pair).numbers, `${pair} d`);
        assertNear(found[2 * k + 1], row("f32", "irradiance", pair).numbers, `${pair} irradiance`);
      });
    });
  }

  for (const [name, array] of [["q15", Int16Array], ["q31", Int32Array]]) {
    for (const module of [name, "all"]) {
      test(`${name} of ${module}${variant}.wasm is the same bits`, async () => {
        const { [name]: format } = await load(bytes(module, variant));
        const all = [];
        for (const pair of PAIRS) {
          format.light(row("f32", "light", pair).numbers);
          format.material(row("f32", "material", pair).numbers);
          const d = format.project();
          const expected = row(name, "d", pair);
          assert.deepEqual([...d.mantissas], expected.numbers, `${pair} d`);
          assert.deepEqual([d.exponent], expected.exponents, `${pair} d`);
          const irradiance = format.collapse().shade(...normals(name, array));
          const { numbers, exponents } = row(name, "irradiance", pair);
          assert.deepEqual([...irradiance], numbers, `${pair} irradiance`);
          assert.deepEqual([format.exponent], exponents, `${pair} irradiance`);
          all.push(...d.mantissas, d.exponent, ...irradiance, format.exponent);
        }
        assert.deepEqual([crc32(Int32Array.from(all))], row(name, "crc32").numbers);
      });
    }
  }
}

test("f32 gives the same bits with SIMD and without", async () => {
  const [plain, simd] = await Promise.all(VARIANTS.map((variant) => load(bytes("f32", variant))));
  assert.deepEqual(floats(plain.f32), floats(simd.f32));
});

for (const variant of VARIANTS) {
  test(`one transfer for each material, and a baked map, of floats${variant}.wasm`, async () => {
    const { f32 } = await load(bytes("floats", variant));
    const [tolerance] = row("f32", "tolerance").numbers;
    const normal = normals("f32", Float32Array);
    let transfers = 0;
    const count = { get: (exports, name) => (name === "f32_transfer" && transfers++, exports[name]) };
    f32.exports = new Proxy({ ...f32.exports }, count);
    let last;
    for (const pair of PAIRS) {
      const material = row("f32", "material", pair).numbers;
      f32.light(row("f32", "light", pair).numbers);
      if (String(material) !== last) f32.material(material);
      last = String(material);
      const d = f32.relight();
      assertNear(d, row("f32", "d", pair).numbers, `${pair} d`);
      const shaded = f32.collapse().shade(...normal);
      assertNear(shaded, row("f32", "irradiance", pair).numbers, `${pair} irradiance`);
      // docs/method.md: 2e-3 rms of the worst image; single normals are off by more.
      const looked = f32.bake().lookUp(...normal);
      const peak = largest([...shaded]);
      const off = [...looked].map((value, k) => (value - shaded[k]) / peak);
      const rms = Math.sqrt(off.reduce((sum, one) => sum + one * one, 0) / off.length);
      assert.ok(rms > tolerance && rms <= 4e-3, `${pair}: ${rms}`);
      // The material did not change, so its transfer is not computed again.
      const before = transfers;
      assert.deepEqual(f32.relight(), d);
      assert.equal(transfers, before);
    }
    assert.ok(transfers > 0);
  });
}

test("more normals than one call takes, in every kind of array", async () => {
  for (const variant of VARIANTS) {
    const { f32, q15, q31 } = await load(bytes("all", variant));
    const [x, y, z] = normals("f32", Float32Array);
    const many = [x, y, z].map((axis) => Float32Array.from({ length: 2500 }, (_, k) => axis[k % axis.length]));
    for (const format of [f32, q15, q31]) {
      format.light(row("f32", "light", PAIRS[0]).numbers);
      format.material(row("f32", "material", PAIRS[0]).numbers);
      format.project();
      format.collapse();
      const few = format.shade(x, y, z);
      const all = format.shade(...many);
      assert.deepEqual([...all], Array.from(many[0], (_, k) => few[k % few.length]));
      assert.deepEqual(format.shade([...x], [...y], [...z]), few);
      const given = new few.constructor(x.length);
      assert.equal(format.shade(x, y, z, given), given);
      assert.deepEqual(given, few);
    }
  }
});

test("a light of degree 1 on a material of order 0, against the same with zeros", async () => {
  const { f32, q15, q31 } = await load(bytes("all", ""));
  for (const format of [f32, q15, q31]) {
    const short = format.light([3.5, 0, 1, 0]).material([2]).project();
    const zeros = [3.5, 0, 1, ...Array(97).fill(0)];
    const long = format.light(zeros).material([2, ...Array(39).fill(0)]).project();
    const scaled = (d) => (format === f32 ? [...d] : Array.from(d.mantissas, (n) => n * 2 ** d.exponent));
    const most = largest(scaled(short));
    const tolerance = format === q15 ? 1e-4 : 1e-6;
    scaled(short).forEach((number, k) => {
      assert.ok(Math.abs(number - scaled(long)[k]) <= tolerance * most, `${format.name} ${k}`);
    });
  }
});
