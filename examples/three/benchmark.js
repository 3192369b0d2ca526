// node benchmark.js: time of a normal in three channels, on the CPU in this program and in fragment
// shaders by software rendering in Chromium. Writes results/cpu.csv, results/gpu.csv and tables of
// README.md. All rows of a file are of one run, interleaved; read the ratios. Scenes on the CPU have
// relaxed SIMD, as in browsers that have it, except in the row that says so. Needs Linux: for the
// shaders it reads the processor time of Chromium's GPU process, which other programs disturb less.

import { readFileSync } from "node:fs";
import { SphericalHarmonics3, Vector3 } from "three";
import { Scene, load } from "../../packages/eigenshade/src/index.js";
import { engine as shared } from "../../packages/eigenshade/src/engine.js";
import { takeRelaxedSimd } from "../../packages/eigenshade/test/support/relaxed.js";
import { clock } from "./clock.js";
import { open } from "./test/support.js";
import { markdown, putTable, writeRows } from "./tables.js";

const COUNT = 65_536;
const [x, y, z] = [0, 1, 2].map(() => new Float32Array(COUNT));
for (let k = 0; k < COUNT; k++) {
  z[k] = (k + 0.5) / COUNT;
  const [sine, around] = [Math.sqrt(1 - z[k] ** 2), k * Math.PI * (3 - Math.sqrt(5))];
  [x[k], y[k]] = [sine * Math.cos(around), sine * Math.sin(around)];
}

function cpu(scenes, engine, simd) {
  const nine = new SphericalHarmonics3();
  nine.coefficients.forEach((c, k) => c.set(1 / (k + 1), 0.3 / (k + 2), 0.2 / (k + 3)));
  const objects = Array.from({ length: COUNT }, (_, k) => new Vector3(x[k], y[k], z[k]));
  const target = new Vector3();
  const [r, g, b] = [0, 1, 2].map(() => new Float32Array(COUNT));
  // The factors of getIrradianceAt, multiplied in once. In f64 the loop is fastest: V8 computes in
  // f64.
  const c = Float64Array.from(nine.toArray());
  const factors = [0.886227, 1.023328, 1.023328, 1.023328, 0.858086, 0.858086, 0.743125, 0.858086, 0.429043];
  const f = c.map((number, k) => number * factors[Math.floor(k / 3)]);
  for (let k = 0; k < 3; k++) f[k] -= 0.247708 * c[18 + k];
  const handwritten = () => {
    for (let k = 0; k < COUNT; k++) {
      const X = x[k], Y = y[k], Z = z[k];
      const xy = X * Y, yz = Y * Z, zz = Z * Z, xz = X * Z, dd = X * X - Y * Y;
      r[k] = f[0] + f[3] * Y + f[6] * Z + f[9] * X + f[12] * xy + f[15] * yz + f[18] * zz + f[21] * xz + f[24] * dd;
      g[k] = f[1] + f[4] * Y + f[7] * Z + f[10] * X + f[13] * xy + f[16] * yz + f[19] * zz + f[22] * xz + f[25] * dd;
      b[k] = f[2] + f[5] * Y + f[8] * Z + f[11] * X + f[14] * xy + f[17] * yz + f[20] * zz + f[23] * xz + f[26] * dd;
    }
  };
  const called = (nine) => {
    for (let k = 0; k < COUNT; k++) nine.getIrradianceAt(objects[k], target);
  };
  const stored = (nine) => {
    for (let k = 0; k < COUNT; k++) {
      nine.getIrradianceAt(objects[k], target);
      r[k] = target.x;
      g[k] = target.y;
      b[k] = target.z;
    }
  };
  const module = (scene, engine) => {
    scene.shade(x.subarray(0, 1), y.subarray(0, 1), z.subarray(0, 1));
    const { normals, axes } = engine;
    [x, y, z].forEach((axis, which) => axes.set(axis.subarray(0, normals), which * normals));
    return () => engine.wasm.shade(normals);
  };
  return [
    { name: "three.js, `getIrradianceAt`, results stored in arrays", work: () => stored(nine) },
    { name: "three.js, `getIrradianceAt`", work: () => called(nine) },
    { name: "nine terms, written by hand", work: handwritten },
    ...scenes.map((scene) => ({ name: `\`scene.shade\`, ${named(scene)}`, work: () => scene.shade(x, y, z, { r, g, b }) })),
    ...scenes.map((scene) => ({ name: `the module alone, ${named(scene)}`, ready: () => module(scene, engine), count: engine.normals })),
    { name: "the same without relaxed SIMD", ready: () => module(simd.scene, simd.engine), count: engine.normals },
  ];
}

/** The least time of many interleaved runs, in nanoseconds for one of `count`. */
function times(tasks) {
  const all = tasks.map(() => Infinity);
  for (let round = 0; round < 30; round++) {
    tasks.forEach(({ work, ready, count = COUNT }, k) => {
      const run = ready?.() ?? work;
      const repeats = Math.ceil(COUNT / count);
      let least = Infinity;
      for (let turn = 0; turn < 10; turn++) {
        const start = process.hrtime.bigint();
        for (let again = 0; again < repeats; again++) run();
        least = Math.min(least, Number(process.hrtime.bigint() - start) / (repeats * count));
      }
      if (round >= 10) all[k] = Math.min(all[k], least);
    });
  }
  return all;
}

const GOLD = { light: "lobby", material: "gold-metallic-paint" };
/** A scene of all terms, or with an error relative to its peak. */
async function made(inputs, tolerance) {
  const scene = (await Scene.create(inputs)).within(tolerance);
  return tolerance ? scene.within(tolerance, 1 / scene.truncation.peak) : scene;
}
const named = (scene) => `${scene.terms} terms, ${scene.truncation ? "1 %" : "all"}`;
const digits = (number) => (number >= 100 ? number.toFixed(0) : number.toPrecision(number >= 10 ? 3 : 2));
const strict = await load(readFileSync(new URL("../../packages/eigenshade/wasm/eigenshade.simd.wasm", import.meta.url)));
takeRelaxedSimd();
const scenes = [
  await made({ light: "workshop", material: "red-fabric2" }, 0.01),
  await made(GOLD, 0.01),
  await made(GOLD),
];
const simd = { engine: strict, scene: await Scene.create({ ...GOLD, engine: strict }) };
const tasks = cpu(scenes, await shared(), simd);

/** Names and nanoseconds a pixel of shaders. */
async function gpu(scenes) {
  const { page, close } = await open();
  const now = await clock(page.context().browser());
  const texts = scenes.map((scene) => ({ name: named(scene), text: scene.glsl(), numbers: [...scene.uniforms()] }));
  const names = await page.evaluate(async (texts) => {
    const { NINE, TRIVIAL, program, draw } = await import("/examples/three/gpu.js");
    window.draw = (k, pictures) => draw(window.made[k].made, pictures);
    window.made = [
      { name: "trivial shader", made: program(TRIVIAL) },
      { name: "nine terms, `vec4` uniforms", made: program(NINE, "nine", new Float32Array(36).fill(0.1)) },
      ...texts.map(({ name, text, numbers }) => ({ name: `\`scene.glsl()\`, ${name}`, made: program(text, "eigenshade", new Float32Array(numbers)) })),
    ];
    return window.made.map(({ name }) => name);
  }, texts);
  const found = names.map(() => Infinity);
  for (let round = 0; round < 6; round++) {
    for (let k = 0; k < names.length; k++) {
      const pictures = Number.isFinite(found[k]) ? Math.ceil(3e8 / (found[k] * 65_536)) : 2;
      const start = now();
      const count = await page.evaluate(([k, pictures]) => window.draw(k, pictures), [k, pictures]);
      found[k] = Math.min(round < 2 ? Infinity : found[k], (now() - start) / count);
    }
  }
  await close();
  return { names, found };
}

/** Writes times with their ratios to some of them, and the table. */
function write(file, names, found, ratios) {
  const columns = (k) => Object.fromEntries(Object.entries(ratios).map(([name, of]) => [name, digits(found[k] / found[of])]));
  const rows = names.map((what, k) => ({ what: what.replaceAll(",", ";"), ns: digits(found[k]), ...columns(k) }));
  writeRows(file, "node benchmark.js", rows);
  console.table(rows);
  putTable(file, markdown(
    ["a normal in three channels", "ns", ...Object.keys(ratios).map((name) => name.replaceAll("_", " "))],
    rows.map(({ what, ...numbers }) => [what.replaceAll(";", ","), ...Object.values(numbers)]),
  ));
}

write("cpu", tasks.map(({ name }) => name), times(tasks), { of_three_js: 1, of_nine_by_hand: 2 });
const { names, found } = await gpu(scenes);
write("gpu", names, found, { of_nine: 1, of_trivial: 0 });
