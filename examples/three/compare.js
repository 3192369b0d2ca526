// node compare.js [--check]: errors, bytes and times of ways to light a glTF material by a map.
// Writes results/compare.csv and a table of README.md. With --check it computes the errors and
// bytes anew and compares them. Times are of software rendering, on Linux.

import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { FloatType } from "three";
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { clock } from "./clock.js";
import { integrals, irradiance, texels } from "./reference.js";
import { checkRows, markdown, percent, putTable, writeRows } from "./tables.js";
import { open } from "./test/support.js";

const COMMAND = "node compare.js";
const check = process.argv.includes("--check");
const { page, close, faults } = await open();
await page.evaluate(async () => (window.measure = await import("/examples/three/measure.js")));
const { methods, lights, materials, normals } = await page.evaluate(() => ({
  methods: Object.keys(measure.METHODS), lights: measure.LIGHTS, materials: measure.MATERIALS, normals: measure.normals(),
}));

// Errors.
const errors = methods.map(() => materials.map(() => ({ squares: [], brightness: [], worst: 0 })));
for (const light of lights) {
  const file = readFileSync(new URL(`../../tables/inputs/maps/${light}.exr`, import.meta.url));
  const map = texels(new EXRLoader().setDataType(FloatType).parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.length)));
  const sums = Object.fromEntries([0.3, 0.5, 0.8].map((roughness) =>
    [roughness, normals.map(({ normal }) => integrals(map, normal, roughness))]));
  for (const [m, material] of materials.entries()) {
    const expected = sums[material.roughness].map((sums) => irradiance(sums, material));
    const peak = Math.max(...expected.flat());
    for (const [k, method] of methods.entries()) {
      const colors = await page.evaluate(([method, light, material, normals]) => measure.colors(method, light, material, normals), [method, light, material, normals]);
      const off = colors.flatMap((color, k) => color.map((number, channel) => Math.abs(number - expected[k][channel]) / peak));
      const [mean, expectedMean] = [colors, expected].map((all) => all.flat().reduce((sum, one) => sum + one));
      errors[k][m].brightness.push(mean / expectedMean);
      errors[k][m].squares.push(off.reduce((sum, one) => sum + one * one, 0) / off.length);
      errors[k][m].worst = Math.max(errors[k][m].worst, ...off);
    }
  }
}

// Bytes: what a page loads beside three.js's core, and what it loads and keeps for each light.
const zipped = (...files) => files.reduce((sum, file) => sum + gzipSync(readFileSync(new URL(file, import.meta.url)), { level: 9 }).length, 0);
const size = (file) => readFileSync(new URL(file, import.meta.url)).length;
const PACKAGE = "../../packages/eigenshade/";
const javascript = zipped(...["index", "shared"].map((name) => `${PACKAGE}dist/${name}.js`));
const exr = zipped("node_modules/three/examples/jsm/loaders/EXRLoader.js", "node_modules/three/examples/jsm/libs/fflate.module.js");
const times = await page.evaluate(() => measure.setUp());
const loaded = (method) => {
  if (method.startsWith("PMREM")) return { code: exr, light: size(`../../tables/inputs/maps/${lights[0]}.exr`), texture: times.texture };
  if (method.startsWith("LightProbe")) return { code: 0, light: 108, texture: 0 };
  const [matcap, images, map] = ["matcap", "images", "map"].map((word) => method.includes(word));
  const few = images || method.includes("sources");
  const module = zipped(`${PACKAGE}wasm/eigenshade.${few ? "sources." : ""}relaxed.wasm`);
  const light = size(`${PACKAGE}presets/light/${lights[0]}.bin`) + (few ? size(`${PACKAGE}presets/sources/${lights[0]}.bin`) : 0);
  return { code: javascript + module + zipped(...(matcap ? ["matcap.js", "unsupported.js"] : [`${PACKAGE}dist/three.js`])), light, texture: matcap ? 8 * 128 * 128 : images ? 8 * 96 * 96 * (map ? 11 : 3) : 0 };
};

// Times: a frame as the processor time of the GPU process, which other programs disturb less.
const frames = [];
if (!check) {
  const now = await clock(page.context().browser());
  await page.evaluate(() => measure.prepareFrames());
  const frame = (which, count) => page.evaluate(([which, count]) => measure.frame(which, count), [which, count]);
  for (let round = 0; round < 4; round++) {
    for (let which = 0; which <= methods.length; which++) {
      const count = round ? Math.ceil(3e8 / frames[which]) : 2;
      const start = now();
      await frame(which, count);
      frames[which] = Math.min(round < 2 ? Infinity : frames[which], (now() - start) / count);
    }
  }
}
await close();
if (faults.length) throw new Error(faults.join("\n"));

const milliseconds = (time) => (time >= 100 ? time.toFixed(0) : time === 0 ? "0" : time.toPrecision(time < 0.001 ? 1 : 2));
const rows = methods.map((method, k) => {
  const { code, light, texture } = loaded(method);
  const set = times[method] ?? (method.startsWith("PMREM") ? times.pmrem : times.probe);
  const row = { method: method.replaceAll(",", ";"), code, light, texture };
  materials.forEach(({ metallic, roughness }, m) => {
    const { squares, brightness, worst } = errors[k][m];
    const name = `${metallic ? "metal" : "dielectric"}_${roughness}`;
    row[`${name}_rms`] = Math.sqrt(squares.reduce((sum, one) => sum + one) / squares.length).toPrecision(3);
    row[`${name}_worst`] = worst.toPrecision(3);
    row[`${name}_brightness`] = (brightness.reduce((sum, one) => sum + one) / brightness.length).toPrecision(3);
  });
  return { ...row, new_light_ms: milliseconds(set.light), turn_ms: milliseconds(set.turn), frame: (frames[k + 1] / frames[0]).toPrecision(2) };
});

const CANNOT = {
  "eigenshade": "sharp gloss; shadows; near lights; perspective is approximate",
  "eigenshade, 4 sources": "sharp gloss of many or large lamps; the rest is the same",
  "eigenshade, 1 %": "as all terms; these change with the light, which compiles a new program",
  "eigenshade, images": "as 4 sources; roughness per pixel",
  "eigenshade, images, roughness map": "as 4 sources",
  "eigenshade, matcap of 128²": "as all terms; roughness and color per pixel",
  "LightProbe, MeshStandardMaterial": "highlights; metals; light beyond degree 2",
  "LightProbe, MeshLambertMaterial": "the same; roughness",
  "PMREM, MeshStandardMaterial": "measured BRDFs; stretched highlights; glTF's formula for rough metals, which it draws brighter",
};
if (check) {
  const stable = Object.keys(rows[0]).filter((name) => !/_ms|^frame/.test(name));
  checkRows("compare", COMMAND, rows, stable);
} else {
  writeRows("compare", COMMAND, rows);
  const thousands = (number) => Number(number).toLocaleString("en-US");
  const cells = (row, kind) => [0.3, 0.5, 0.8].map((roughness) => `${percent(row[`${kind}_${roughness}_rms`])} / ${percent(row[`${kind}_${roughness}_worst`])}`);
  const errorsTable = markdown(
    ["rms / worst pixel, % of the peak", ...["dielectric", "metal"].flatMap((kind) => [0.3, 0.5, 0.8].map((roughness) => `${kind} ${roughness}`)), "cannot do"],
    rows.map((row, k) => [methods[k], ...cells(row, "dielectric"), ...cells(row, "metal"), CANNOT[methods[k]]]), ["cannot do"],
  );
  const costsTable = markdown(
    ["costs", "code, gzip", "a light, bytes", "texture, bytes", "set-up of a new light, ms", "of a turned light, ms", "frame, trivial shader = 1"],
    rows.map((row, k) => [methods[k], ...[row.code, row.light, row.texture].map(thousands), row.new_light_ms, row.turn_ms, row.frame]),
  );
  putTable("compare", `${errorsTable}\n\n${costsTable}`);
}
