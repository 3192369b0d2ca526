// Small sources of light: against the program's shaders, the formula of the literature, and turns.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { Scene, lightPreset, load, presetNames } from "../src/index.js";
import { EIGENSHADE } from "./support/own.js";
import { takeRelaxedSimd } from "./support/relaxed.js";

const largest = (numbers) => numbers.reduce((most, number) => Math.max(most, Math.abs(number)), 0);
const three = (numbers) => ({ r: numbers, g: numbers, b: numbers });
const dot = (a, b) => a.reduce((sum, number, k) => sum + number * b[k], 0);
const unit = (a) => a.map((number) => number / Math.sqrt(dot(a, a)));

/** Normals of a sphere's picture, in a spiral. */
const NORMALS = [0, 1, 2].map(() => []);
for (let k = 0; k < 4000; k++) {
  const [sine, angle] = [Math.sqrt((k + 0.5) / 4000), 2.399963 * k];
  const normal = [sine * Math.cos(angle), sine * Math.sin(angle), Math.sqrt(1 - sine * sine)];
  normal.forEach((number, axis) => NORMALS[axis].push(number));
}

test("the program writes the same shaders and vectors", async () => {
  for (const [light, material, sources] of [
    ["studio", "gold-metallic-paint", 4], ["night", "blue-metallic-paint", 8], ["lobby", "chrome", 1], ["park", "pearl-paint", 1],
  ]) {
    const scene = await Scene.create({ light, material, sources });
    assert.equal(scene.sources, sources);
    const all = ["shader", "--json", "--lang", "wgsl", "-l", light, "-m", material, "--sources", sources];
    const written = JSON.parse(execFileSync(EIGENSHADE, all.map(String), { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));
    assert.equal(scene.wgsl(), written.text);
    const found = scene.uniforms();
    assert.equal(found.length, 4 * written.vectors.length);
    // Lobes, directions and colors differ in size: each vector on its own, to the rounding of six
    // digits in the files and of f32. Terms are those of the light less its sources.
    const terms = 4 * written.terms;
    const whole = await Scene.create({ light, material });
    const [scale, expected] = [largest(whole.uniforms()), written.vectors.flat()];
    for (let k = 0; k < found.length; k += 4) {
      const size = k < terms ? scale : largest(expected.slice(k, k + 4));
      for (let at = k; at < k + 4; at++) {
        assert.ok(Math.abs(found[at] - expected[at]) <= 3e-5 * size, `${light}, ${at}: ${found[at]}, ${expected[at]}`);
      }
    }
  }
});

test("points of light are GGX by the textbook, wherever they turn", async () => {
  const scene = await Scene.create({ light: "park", material: "gold-metallic-paint", sources: 1 });
  const [roughness, f0, f90, albedo] = [0.4, [0.04, 0.5, 0.9], [0.7, 0.9, 1], [0.6, 0.2, 0]];
  // Black in harmonics, so that the highlight is all that is there.
  scene.material({ ...three([0]), gloss: [roughness, ...f0, ...f90, ...albedo] });
  const energy = [1, 0.8, 0.5];
  const view = [0, 0, 1];
  let most = 0;
  for (const [yaw, roll, turned] of [
    [0, 0, [0.48, 0.6, 0.64]],
    [Math.PI / 2, 0, [0.64, 0.6, -0.48]],
    [0, Math.PI / 2, [-0.6, 0.48, 0.64]],
  ]) {
    scene.light({ ...three([1]), sources: [0.48, 0.6, 0.64, ...energy, 0] }).turn({ yaw, roll });
    assert.equal(scene.sources, 1);
    const found = scene.shade(...NORMALS);
    const half = unit(turned.map((number, k) => number + view[k]));
    const square = roughness ** 4;
    const root = (cosine) => Math.sqrt(square + (1 - square) * cosine * cosine);
    const rest = (1 - dot(half, view)) ** 5;
    const expected = NORMALS[0].map((_, k) => {
      const normal = NORMALS.map((axis) => axis[k]);
      const [cosine, up, toHalf] = [dot(normal, turned), normal[2], dot(normal, half)];
      if (cosine <= 0) return [0, 0, 0];
      const d = square / (Math.PI * (1 + (square - 1) * toHalf * toHalf) ** 2);
      const v = 0.5 / (cosine * root(up) + up * root(cosine));
      return f0.map((f, c) => {
        const fresnel = f + (f90[c] - f) * rest;
        return energy[c] * cosine * (fresnel * d * v + ((1 - fresnel) * albedo[c]) / Math.PI);
      });
    });
    const peak = largest(expected.flat());
    ["r", "g", "b"].forEach((channel, c) =>
      found[channel].forEach((number, k) => (most = Math.max(most, Math.abs(number - expected[k][c]) / peak))),
    );
  }
  console.log(`GGX: ${most.toExponential(1)}`);
  assert.ok(most <= 1e-5, `${most}`);
});

test("a roll of the light is a roll of the picture", async () => {
  const scene = await Scene.create({ light: "lobby", material: "blue-metallic-paint", sources: 8 });
  const { g } = scene.shade(...NORMALS);
  const [sine, cosine] = [Math.sin(0.7), Math.cos(0.7)];
  const [x, y, z] = NORMALS;
  const rolled = [x.map((_, k) => cosine * x[k] - sine * y[k]), y.map((_, k) => sine * x[k] + cosine * y[k]), z];
  const found = scene.turn({ roll: 0.7 }).shade(...rolled);
  assert.equal(scene.sources, 8);
  const off = largest(found.g.map((number, k) => number - g[k]));
  assert.ok(off <= 2e-5 * largest(g), `${off / largest(g)}`);
  // A sharp picture is another one than without, and as bright.
  const whole = (await Scene.create({ light: "lobby", material: "blue-metallic-paint" })).shade(...NORMALS);
  assert.ok(largest(g) > 1.3 * largest(whole.g));
  const mean = (numbers) => numbers.reduce((sum, number) => sum + number, 0) / numbers.length;
  assert.ok(Math.abs(mean(g) / mean(whole.g) - 1) < 0.05, `${mean(g)}, ${mean(whole.g)}`);
});

test("scenes say how many sources they draw, and draw the whole light without", async () => {
  const inputs = { light: "studio", material: "gold-metallic-paint" };
  const whole = await Scene.create(inputs);
  const scene = await Scene.create({ ...inputs, sources: 4 });
  assert.equal(whole.sources, 0);
  assert.equal(scene.sources, 4);
  assert.equal((await Scene.create({ ...inputs, sources: 3 })).sources, 3);
  // The first of a list are the list of as many.
  const [few, all] = await Promise.all([3, 16].map((sources) => lightPreset("studio", { sources })));
  assert.deepEqual(few.sources, all.sources.subarray(0, 21));
  const same = (one) => {
    assert.equal(one.sources, 0);
    assert.deepEqual(one.shade(...NORMALS), whole.shade(...NORMALS));
    assert.equal(one.glsl(), whole.glsl());
    assert.deepEqual(one.uniforms(), whole.uniforms());
  };
  const sharp = scene.shade(...NORMALS);
  scene.effects(["gloss"]), whole.effects(["gloss"]);
  same(scene);
  scene.effects(), whole.effects();
  assert.equal(scene.sources, 4);
  assert.deepEqual(scene.shade(...NORMALS), sharp);
  // Eigenimages have no highlights.
  assert.deepEqual(scene.eigenimage(3, ...NORMALS), whole.eigenimage(3, ...NORMALS));
  assert.deepEqual(scene.shade(...NORMALS), sharp);
  // A light without a map, a matte material, and one without gloss.
  const { light, material } = await presetNames();
  const mapped = await Promise.all(light.map((name) => lightPreset(name, { sources: 8 })));
  assert.equal(mapped.filter(({ sources }) => sources.length > 0).length, 18);
  const unmapped = mapped.find(({ sources }) => sources.length === 0);
  for (const change of [
    { light: unmapped }, { light: await lightPreset("studio") }, { material: { roughness: 0.7 } }, { material: three([1]) },
  ]) {
    for (const one of [scene, whole]) {
      if (change.light) one.light(change.light);
      if (change.material) one.material(change.material);
    }
    same(scene);
    whole.light(await lightPreset("studio"));
    scene.light(await lightPreset("studio", { sources: 4 }));
  }
  assert.ok(material.includes("ptfe-633nm"));
  assert.equal((await Scene.create({ ...inputs, material: "ptfe-633nm", sources: 4 })).sources, 0);
  // Its roughness is 0.6, where sources change nothing.
  assert.equal((await Scene.create({ ...inputs, material: "yellow-paint", sources: 4 })).sources, 0);
  // A smooth glTF material has a gloss.
  assert.equal(scene.material({ metallic: 1, roughness: 0.3 }).sources, 4);
});

/** Sources and width of the window that `render` chooses. */
function rendered(light, material) {
  const folder = mkdtempSync(join(tmpdir(), "eigenshade-"));
  const all = ["render", "-l", light, "-m", material, "--table", "color", "--size", "8", "--out", join(folder, "out.png")];
  const { stderr } = spawnSync(EIGENSHADE, all, { encoding: "utf8" });
  const [, sources, width] = /components\), (no|\d+) sources?, (?:no window|a window of width ([\d.]+))/.exec(stderr);
  return [Number(sources === "no" ? 0 : sources), Number(width ?? Infinity)];
}

test("automatic sources and windows are those of `render`", async () => {
  const counts = new Set();
  for (const [light, material] of [
    ["studio", "gold-metallic-paint"], ["lobby", "chrome"], ["night", "chrome-steel"], ["park", "red-fabric2"],
    ["city", "blue-metallic-paint"], ["hall", "aluminium"], ["esplanade", "chrome"], ["sunset", "gold-metallic-paint2"], ["blender-studio", "chrome"],
  ]) {
    const scene = await Scene.create({ light, material, sources: "auto", window: "auto" });
    const found = [scene.sources, scene.windowWidth];
    assert.deepEqual(found, rendered(light, material), `${light}, ${material}`);
    counts.add(found[0]);
  }
  assert.ok(counts.size >= 4, [...counts].join());
});

test("automatic sources are as few as each material needs", async () => {
  const scene = await Scene.create({ light: "studio", material: { metallic: 1, roughness: 0.2 }, sources: "auto" });
  const of = (material) => scene.material(material).sources;
  const found = [0.2, 0.3, 0.4, 0.5, 0.59, 0.6, 0.8].map((roughness) => of({ metallic: 1, roughness }));
  assert.deepEqual(found, [6, 6, 6, 2, 1, 0, 0]);
  assert.ok(of({ roughness: 0.3 }) < 4);
  assert.equal(of(three([1])), 0);
  // Another light, as it is set.
  of({ metallic: 1, roughness: 0.3 });
  assert.equal(scene.light(await lightPreset("blender-studio", { sources: "auto" })).sources, 0);
  const auto = await lightPreset("studio", { sources: "auto" });
  assert.equal(scene.light(auto).sources, 6);
  const six = await Scene.create({ light: "studio", material: { metallic: 1, roughness: 0.3 }, sources: 6 });
  assert.deepEqual(scene.uniforms(), six.uniforms());
  // A light of one's own has all that it comes with, or none.
  const { sources } = await lightPreset("studio", { sources: 2 });
  assert.equal(scene.light({ ...three([1]), sources }).sources, 2);
  assert.equal(scene.light(three([1])).sources, 0);
  // A scene without sources draws none.
  const inputs = { light: "studio", material: { metallic: 1, roughness: 0.3 } };
  const whole = await Scene.create(inputs);
  assert.equal(whole.light(auto).sources, 0);
  assert.deepEqual(whole.uniforms(), (await Scene.create(inputs)).uniforms());
});

test("the modules with relaxed SIMD and without SIMD draw the same highlights", async () => {
  takeRelaxedSimd();
  const [expected, ...others] = await Promise.all(["simd.", "relaxed.", ""].map(async (variant) => {
    const engine = await load(readFileSync(new URL(`../wasm/eigenshade.sources.${variant}wasm`, import.meta.url)));
    const scene = await Scene.create({ light: "studio", material: { metallic: 1, roughness: 0.3 }, sources: 4, engine });
    assert.equal(scene.sources, 4);
    return scene.turn({ yaw: 0.2 }).shade(...NORMALS).g;
  }));
  for (const found of others) {
    assert.ok(largest(found.map((number, k) => number - expected[k])) <= 1e-5 * largest(expected));
  }
});

test("what the program exports is the shipped light and material with their sources", async () => {
  const [light, material] = ["studio", "gold-metallic-paint"];
  const all = ["export", "--lang", "js", "--light", light, "--material", material, "--sources", "4"];
  const text = execFileSync(EIGENSHADE, all, { encoding: "utf8" });
  const { lights, materials } = await import(`data:text/javascript,${encodeURIComponent(text)}`);
  // The sources of the light choose the module that shades them.
  const exported = await Scene.create({ light: lights[light], material: materials[material] });
  const shipped = await Scene.create({ light, material, sources: 4 });
  assert.equal(exported.sources, 4);
  assert.deepEqual(exported.uniforms(), shipped.uniforms());
});

test("wrong sources throw one clear error and change nothing", async () => {
  const inputs = { light: "studio", material: "gold-metallic-paint" };
  for (const sources of [-1, 1.5, NaN, Infinity, "4", null]) {
    await assert.rejects(Scene.create({ ...inputs, sources }), {
      name: "RangeError", message: `sources: ${sources === "4" ? '"4"' : sources} is neither "auto" nor a whole number, 0 or more`,
    });
  }
  const plain = await load(readFileSync(new URL("../wasm/eigenshade.wasm", import.meta.url)));
  const whole = await Scene.create({ ...inputs, engine: plain });
  const scene = await Scene.create({ ...inputs, sources: 4 });
  const [before, beforeWhole] = [scene.uniforms(), whole.uniforms()];
  const fails = (what, message) => assert.throws(what, { name: "RangeError", message });
  const light = await lightPreset("studio", { sources: 4 });
  fails(() => whole.light(light), "light: the engine has no sources; build the module `color-sources`");
  // Whatever else the page has loaded.
  const plainScene = await Scene.create(inputs);
  fails(() => plainScene.light(light), "light: this scene has no sources; create it with the option `sources`");
  assert.equal(plainScene.isGlossy, false);
  assert.equal(plainScene.light(await lightPreset("studio", { sources: 0 })).sources, 0);
  fails(() => scene.light({ ...light, sources: light.sources.slice(1) }), "light: it has 3.857142857142857 sources, expected up to 32 of seven numbers each");
  fails(() => scene.light({ ...light, sources: new Float32Array(7 * 33) }), "light: it has 33 sources, expected up to 32 of seven numbers each");
  for (const [at, bad] of [[0, 2], [3, -1], [6, 1]]) {
    fails(() => scene.light({ ...light, sources: light.sources.with(at, bad) }), /^light: its sources are not/);
  }
  for (const [at, bad] of [[4, NaN], [6, Infinity], [3, 2 ** 51]]) {
    fails(() => scene.light({ ...light, sources: light.sources.with(at, bad) }),
      `light: sources[${at}] is ${bad}, expected a number from -1e15 to 1e15`);
  }
  assert.throws(() => scene.light({ ...light, sources: 4 }), { message: "light: sources is not an array of numbers" });
  for (const gloss of [[], new Float32Array(10).fill(2), Array(10).fill("0"), "0123456789", 4, 0, false]) {
    fails(() => scene.material({ ...three([1]), gloss }), "material: gloss is not ten numbers from 0 to 1");
  }
  assert.deepEqual(scene.uniforms(), before);
  assert.deepEqual(whole.uniforms(), beforeWhole);
  // JSON has null for what is left out.
  assert.equal(scene.isGlossy, true);
  assert.equal(scene.light({ ...light, sources: null }).sources, 0);
  assert.equal(scene.light(light).material({ ...three([1]), gloss: null }).sources, 0);
  assert.equal(scene.isGlossy, false);
  assert.ok(scene.shade(...NORMALS).r.every(Number.isFinite));
});
