// Scenes in Node: the golden file, turned lights, glTF materials, tolerances, and wrong input.

import assert from "node:assert/strict";
import { test } from "node:test";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { EFFECTS, Preview, Scene, load, lightPreset, materialPreset, presetNames, sphere } from "../src/index.js";

import { metered } from "../src/exposure.js";
import { weakest } from "../src/window.js";
import { EIGENSHADE } from "./support/own.js";
import { takeRelaxedSimd } from "./support/relaxed.js";

takeRelaxedSimd();
const README = readFileSync(new URL("../README.md", import.meta.url), "utf8");

/** The largest difference from the direct sum, relative to the peak. */
const DIRECT = 1e-4;

const largest = (numbers) => numbers.reduce((most, number) => Math.max(most, Math.abs(number)), 0);

const gold = () => Scene.create({ light: "park", material: "gold-metallic-paint" });
const three = (numbers) => ({ r: numbers, g: numbers, b: numbers });

/** Normals at which the program's direct sum over all modes is compared. */
const NORMALS = [0, 1, 2].map(() => []);
for (let k = 0; k < 60; k++) {
  const [sine, angle] = [Math.sqrt((k + 0.5) / 60), 2.399963 * k];
  const normal = [sine * Math.cos(angle), sine * Math.sin(angle), Math.sqrt(1 - sine * sine)];
  normal.forEach((number, axis) => NORMALS[axis].push(number));
}
const folder = mkdtempSync(join(tmpdir(), "eigenshade-"));
const FILE = join(folder, "normals.csv");
writeFileSync(FILE, ["x,y,z", ...NORMALS[0].map((_, k) => NORMALS.map((axis) => axis[k]).join())].join("\n"));

/** The direct sum in f64 by the program, which shares no code with the module's pixels. */
function directSum(light, material, ...options) {
  const all = ["shade", "--method", "modes", "-l", light, "-m", material, "-n", FILE, ...options];
  const text = execFileSync(EIGENSHADE, all, { encoding: "utf8" });
  const rows = text.trim().split("\n").slice(1).map((line) => line.split(",").slice(3).map(Number));
  return Object.fromEntries(["r", "g", "b"].map((channel, k) => [channel, rows.map((row) => row[k])]));
}

/** The largest difference, relative to the peak. */
function difference(found, expected) {
  const channels = ["r", "g", "b"];
  const peak = Math.max(...channels.map((channel) => largest(expected[channel])));
  return Math.max(...channels.map((channel) => largest(found[channel].map((number, k) => number - expected[channel][k])))) / peak;
}

test("scenes are the direct sum over all modes", async () => {
  const names = await presetNames();
  let most = 0;
  for (let k = 0; k < names.material.length; k += 3) {
    const [light, material] = [names.light[k % names.light.length], names.material[k]];
    const scene = await Scene.create({ light, material });
    const found = difference(scene.shade(...NORMALS), directSum(light, material));
    most = Math.max(most, found);
    assert.ok(found <= DIRECT, `${light}, ${material}: ${found}`);
  }
  console.log(`direct sum: ${most.toExponential(1)}`);
});

test("the program writes the same shaders", async () => {
  const scene = await Scene.create({ light: "park", material: "gold-metallic-paint" });
  for (const [language, text] of [
    ["glsl", () => scene.glsl()],
    ["glsl-block", () => scene.glsl("block")],
    ["glsl-texture", () => scene.glsl("texture")],
    ["wgsl", () => scene.wgsl()],
    ["glsl-block --prefix a_", () => scene.glsl("block", { prefix: "a_" })],
    ["wgsl --prefix b --binding 2,3", () => scene.wgsl({ prefix: "b", group: 2, binding: 3 })],
  ]) {
    for (const tolerance of [undefined, 0.05]) {
      const all = ["shader", "--json", "--lang", ...language.split(" "), "-l", "park", "-m", "gold-metallic-paint"];
      if (tolerance) all.push("--tolerance", String(tolerance));
      const written = JSON.parse(execFileSync(EIGENSHADE, all, { encoding: "utf8" }));
      scene.within(tolerance);
      assert.equal(written.text, text());
      const [vectors, peak] = [written.vectors.flat(), largest(scene.uniforms())];
      assert.equal(vectors.length, scene.uniforms().length);
      scene.uniforms().forEach((number, k) => assert.ok(Math.abs(number - vectors[k]) <= 1e-5 * peak));
    }
  }
});

test("turned lights are the program's", async () => {
  const scene = await gold();
  // The program's Rz(a) Ry(b) Rz(c), as a quaternion.
  const [a, b, c] = [0.7, 1.1, -0.4];
  const [half, sum, other] = [b / 2, (a + c) / 2, (a - c) / 2];
  scene.turn([
    -Math.sin(half) * Math.sin(other), Math.sin(half) * Math.cos(other),
    Math.cos(half) * Math.sin(sum), Math.cos(half) * Math.cos(sum),
  ]);
  const expected = directSum("park", "gold-metallic-paint", `--rotate=${[a, b, c]}`);
  assert.ok(difference(scene.shade(...NORMALS), expected) <= DIRECT);
});

test("effects are the program's, and sum to the whole", async () => {
  const scene = await gold();
  const whole = scene.shade(...NORMALS);
  const sum = three(new Float64Array(60));
  for (const effect of EFFECTS) {
    const found = scene.effects([effect]).shade(...NORMALS);
    const expected = directSum("park", "gold-metallic-paint", "--effects", effect);
    // Relative to the whole picture: a part may be dark.
    const peak = (picture) => Math.max(...["r", "g", "b"].map((channel) => largest(picture[channel])));
    const scale = peak(expected) / peak(whole);
    assert.ok(difference(found, expected) * scale <= DIRECT, effect);
    sum.g = sum.g.map((number, k) => number + found.g[k]);
  }
  assert.ok(largest(sum.g.map((number, k) => number - whole.g[k])) <= DIRECT * largest(whole.g));
  scene.effects();
  assert.deepEqual(scene.shade(...NORMALS), whole);
});

test("a picture is the sum of eigenimages", async () => {
  const scene = await gold();
  const [whole, { g: d }] = [scene.shade(...NORMALS), scene.coefficients()];
  const sum = new Float64Array(60);
  let before = scene.components(0).shade(...NORMALS).g;
  for (let k = 0; k < d.length; k++) {
    const image = scene.eigenimage(k, ...NORMALS);
    image.forEach((value, n) => (sum[n] += d[k] * value));
    if (k > 8) continue;
    const { g } = scene.components(k + 1).shade(...NORMALS);
    assert.ok(largest(g.map((number, n) => number - before[n] - d[k] * image[n])) <= 1e-5 * largest(whole.g));
    before = g;
  }
  // The mean image is what no component leaves.
  const mean = scene.components(0).shade(...NORMALS).g;
  assert.ok(largest(whole.g.map((number, n) => number - mean[n] - sum[n])) <= 1e-5 * largest(whole.g));
  assert.deepEqual(scene.components().shade(...NORMALS), whole);
});

test("a light of degree 1 on a matte material is linear in the normal, and turns", async () => {
  // The component along x.
  const scene = await gold();
  scene.light(three([3.5, 0, 0, 1])).material(three([2]));
  const at = (x, y, z) => scene.shade([x], [y], [z]).r[0];
  const [mean, up] = [at(0, 1, 0), at(0.6, 0, 0.8)];
  const right = at(1, 0, 0) - mean;
  // Y_11 = √(3/4π) x, convolved with the cosine to 2π/3 of it, on a white matte, 1/π.
  const slope = (((2 * Math.PI) / 3) * Math.sqrt(3 / (4 * Math.PI))) / Math.PI;
  const near = (one, other) => Math.abs(one - other) < 1e-4;
  assert.ok(near(Math.abs(right), slope), `${right}: ${slope}`);
  assert.ok(near(up - mean, 0.6 * right), "linear in n_x");
  // By a quarter about z, what came from the right comes from above.
  scene.turn({ roll: Math.PI / 2 });
  assert.ok(near(at(0, 1, 0) - mean, right) && near(at(1, 0, 0), mean));
  // About y, it comes from behind or from the camera: -z, for R x = -z.
  scene.turn({ yaw: -Math.PI / 2 });
  assert.ok(near(at(0, 0, 1) - mean, right));
  // Roll before pitch before yaw.
  scene.turn({ yaw: Math.PI / 2, roll: Math.PI / 2 });
  assert.ok(near(at(0, 1, 0) - mean, right));
  scene.turn({ pitch: Math.PI / 2, roll: Math.PI / 2 });
  assert.ok(near(at(0, 0, 1) - mean, right));
  scene.turn([0, 0, Math.SQRT1_2, Math.SQRT1_2]);
  assert.ok(near(at(0, 1, 0) - mean, right));
  // The `Quaternion` of three.js has a method `length`.
  scene.turn({ length: () => 1, *[Symbol.iterator]() { yield* [0, -Math.SQRT1_2, 0, Math.SQRT1_2]; } });
  assert.ok(near(at(0, 0, 1) - mean, right));
});

test("the base color of a glTF material enters linearly", async () => {
  const scene = await gold();
  const light = await lightPreset("lobby");
  const at = (material) => scene.light(light).material(material).shade([0], [0.6], [0.8]);
  const [white, gray] = [at({ baseColor: [1, 1, 1] }), at({ baseColor: [0.5, 0.5, 0.5] })];
  const black = at({ baseColor: "#000000" });
  for (const channel of ["r", "g", "b"]) {
    const middle = (white[channel][0] + black[channel][0]) / 2;
    assert.ok(Math.abs(gray[channel][0] - middle) < 1e-5 * white[channel][0]);
  }
  const share = ((188 / 255 + 0.055) / 1.055) ** 2.4;
  const expected = share * white.g[0] + (1 - share) * black.g[0];
  assert.ok(Math.abs(at({ baseColor: "#bcbcbc" }).g[0] / expected - 1) < 1e-5);
});

test("scenes that share the module do not disturb each other", async () => {
  const [one, other] = await Promise.all([gold(), Scene.create({ light: "lobby", material: "red-fabric2" })]);
  const read = (scene) => JSON.stringify([scene.coefficients(), scene.uniforms(), scene.shade([0], [0.6], [0.8])]);
  const [first, second] = [read(one), read(other)];
  other.within(1e-2);
  const [short] = [other.terms];
  assert.equal(read(one), first);
  assert.equal(other.terms, short);
  other.within();
  assert.equal(read(other), second);
  one.material({ metallic: 1 });
  assert.equal(read(other), second);
});

test("the modules with relaxed SIMD and without SIMD draw the same", async () => {
  const file = (name) => load(readFileSync(new URL(`../wasm/${name}`, import.meta.url)));
  const scene = async (name) => Scene.create({ light: "studio", material: "red-fabric2", engine: await file(name) });
  for (const name of ["eigenshade.wasm", "eigenshade.relaxed.wasm"]) {
    const [one, other] = [await scene("eigenshade.simd.wasm"), await scene(name)];
    for (const change of [(scene) => scene, (scene) => scene.turn({ yaw: 1 }), (scene) => scene.within(1e-2)]) {
      const [expected, found] = [one, other].map((scene) => change(scene).shade(...NORMALS));
      assert.ok(difference(found, expected) <= 1e-5);
      assert.equal(other.glsl(), one.glsl());
    }
  }
});

test("half of the pairs of shipped inputs keep as few terms within 0.5 % of white as README.md states", async () => {
  const names = await presetNames();
  const [lights, materials] = await Promise.all([
    Promise.all(names.light.map((name) => lightPreset(name))), Promise.all(names.material.map(materialPreset)),
  ]);
  const scene = (await gold()).within(5e-3);
  const terms = [];
  for (const material of materials) {
    scene.material(material);
    for (const light of lights) terms.push(scene.light(light).terms);
  }
  const middle = terms.sort((a, b) => a - b)[terms.length >> 1];
  assert.equal(middle, Number(/\nkeep at most (\d+)/.exec(README)[1]));
  assert.equal(scene.within().terms, Number(/Of (\d+) terms, half/.exec(README)[1]));
});

test("a tolerance holds, and fewer terms suffice for a larger one", async () => {
  const scene = await gold();
  const axes = [0, 1, 2].map(() => []);
  for (let k = 0; k < 20_000; k++) {
    // Uniform over the picture of a sphere, as the error of a truncation is defined.
    const [sine, angle] = [Math.sqrt((k + 0.5) / 20_000), 2.399963 * k];
    const normal = [sine * Math.cos(angle), sine * Math.sin(angle), Math.sqrt(1 - sine * sine)];
    normal.forEach((number, axis) => axes[axis].push(number));
  }
  const whole = scene.shade(...axes);
  const white = 1 / scene.exposure();
  assert.equal(scene.truncation, undefined);
  let before = scene.terms;
  for (const tolerance of [1e-3, 1e-2, 1e-1]) {
    // Half the share of twice the white is as much, under whatever turn of the light.
    assert.equal(scene.within(tolerance / 2, 0.5 / white).terms, scene.within(tolerance, 1 / white).terms);
    scene.within(tolerance);
    const { terms, bound } = scene.truncation;
    assert.ok(terms < before && scene.terms === terms);
    const found = scene.shade(...axes);
    for (const channel of ["r", "g", "b"]) {
      const square = found[channel].reduce((sum, number, k) => sum + (number - whole[channel][k]) ** 2, 0);
      assert.ok(Math.sqrt(square / 20_000) <= 1.02 * bound && bound <= 1.02 * tolerance * white);
    }
    before = terms;
  }
});

test("pixels are encoded by the named curve", async () => {
  const scene = await gold();
  // Ambient light of radiance 1 on white: the irradiance is 1 everywhere.
  scene.light(three([2 * Math.sqrt(Math.PI)])).material(three([2]));
  const level = scene.shade([0], [0], [1]).r[0];
  const exposure = 0.5 / level;
  const of = (tone) => scene.pixels([0], [0], [1], { exposure, tone })[0];
  const srgb = (x) => 255 * (1.055 * x ** (1 / 2.4) - 0.055);
  assert.ok(Math.abs(of("linear") - srgb(0.5)) <= 0.6);
  assert.ok(Math.abs(of("reinhard") - srgb(0.5 * (1 + 0.5 / 256) / 1.5)) <= 0.6);
  assert.ok(Math.abs(of("filmic") - srgb((0.5 * (2.51 * 0.5 + 0.03)) / (0.5 * (2.43 * 0.5 + 0.59) + 0.14))) <= 0.6);
});

test("the exposure is that of the runtime's meter", async () => {
  const of = (shares) => {
    const g = Float32Array.from(shares.flatMap(([count, brightness]) => Array(count).fill(brightness)));
    return metered({ r: new Float32Array(g.length).fill(-1), g, b: g.map((value) => value / 2) });
  };
  for (const [shares, expected] of [
    // An even picture: the brightest hundredth.
    [[[50, 0.5], [49, 1], [1, 50]], 1],
    // A lamp of 5 % and its glow: the median.
    [[[70, 0.1], [25, 0.3], [5, 40]], 1.2],
    // A tenth and more is bright: it is not clipped.
    [[[70, 0.1], [10, 0.3], [20, 4]], 0.25],
    [[[95, 0], [5, 4]], 0.25],
    [[[1, 0], [1, 1e30]], 1e-30],
    [[[3, 0]], 1],
    // What f32 does not hold would show a picture that is all but black.
    [[[3, 1e-39]], 1],
  ]) {
    assert.ok(Math.abs(of(shares) / expected - 1) < 1e-6, `${shares}: ${of(shares)}`);
  }
  // A turn of the light changes the picture and keeps the exposure, and so does a tolerance.
  const scene = await gold();
  const [exposure, before] = [scene.exposure(), scene.turn({ yaw: 2 }).shade(...NORMALS)];
  assert.equal(scene.within(0.1).exposure(), exposure);
  assert.deepEqual(scene.within().shade(...NORMALS), before);
  const { r, g, b } = await lightPreset("park");
  scene.light({ r: r.map((x) => 2 * x), g: g.map((x) => 2 * x), b: b.map((x) => 2 * x) });
  assert.ok(Math.abs((2 * scene.exposure()) / exposure - 1) < 1e-5);
  assert.ok(scene.components(0).exposure() !== scene.components().exposure());
  scene.light(three([0]));
  assert.equal(scene.exposure(), 1);
});

test("the window is the weakest without dark rings", async () => {
  // A picture that is dark by this much without a window, and by less the stronger it is.
  const chosen = (dark) => weakest(9, (width) => (width === Infinity ? -dark : -dark * (width / 60)));
  assert.deepEqual([0, 0.02, 0.03, 0.04, 0.05, 10].map(chosen), [Infinity, Infinity, 36, 30, 23, 10]);
  // None suffices: the one that leaves least.
  assert.equal(weakest(9, (width) => -1 - Math.abs(width - 26)), 26);
  const copper = { baseColor: "#b87333", metallic: 1, roughness: 0.4 };
  const scene = await Scene.create({ light: "studio", material: copper });
  const least = () => scene.exposure() * Math.min(...Object.values(scene.shade(...NORMALS)).map((channel) => Math.min(...channel)));
  assert.equal(scene.windowWidth, Infinity);
  const [plain, without] = [scene.shade(...NORMALS), least()];
  const width = scene.window("auto").windowWidth;
  assert.ok(width < Infinity && without < -0.1 && least() > -0.03, `${width}: ${without}, ${least()}`);
  const found = scene.shade(...NORMALS);
  assert.deepEqual(scene.window(width).shade(...NORMALS), found);
  assert.deepEqual(scene.window("none").shade(...NORMALS), plain);
  // A width between two: another picture.
  assert.notDeepEqual(scene.window(2 * width).shade(...NORMALS), found);
  // A light that turns keeps its window; another material, or other light, has another.
  assert.equal(scene.window("auto").turn({ pitch: 1.5 }).windowWidth, width);
  assert.equal(scene.material({ roughness: 1 }).windowWidth, Infinity);
  assert.equal(scene.material(copper).windowWidth, width);
  assert.equal(scene.light(three([1])).windowWidth, Infinity);
  // Effects are parts of the picture that the window is chosen for.
  scene.light(await lightPreset("studio")).turn({});
  const sum = three(new Float64Array(60));
  for (const effect of EFFECTS) {
    const { g } = scene.effects([effect]).shade(...NORMALS);
    assert.equal(scene.windowWidth, width, effect);
    sum.g = sum.g.map((number, k) => number + g[k]);
  }
  assert.ok(largest(sum.g.map((number, k) => number - found.g[k])) <= DIRECT * largest(found.g));
});

test("every preset is there", async () => {
  const names = await presetNames();
  assert.equal(names.light.length, 26);
  assert.ok(names.material.length > 100);
  for (const [all, load] of [[names.light, lightPreset], [names.material, materialPreset]]) {
    for (const { r, g, b } of await Promise.all(all.map((name) => load(name)))) {
      assert.ok([r, g, b].every((channel) => channel.length === r.length && channel.every(Number.isFinite)));
    }
  }
});

test("presets are copies", async () => {
  for (const [load, name] of [[lightPreset, "park"], [materialPreset, "gold-metallic-paint"]]) {
    const one = await load(name);
    const before = structuredClone(one);
    assert.equal(one.name, name);
    for (const numbers of [one.r, one.g, one.b, one.gloss ?? []]) numbers.fill(7);
    assert.deepEqual(await load(name), before);
  }
});

test("the element's module can be imported, and a preview says that it needs a page", async () => {
  assert.ok((await import("../src/element.js")).EigenShade);
  for (const make of [() => Preview.create({}, { light: "park", material: "nylon" }), async () => new Preview({}, await gold())]) {
    await assert.rejects(make, { name: "TypeError", message: "Preview: it is [object Object], expected a canvas of a page" });
  }
});

test("wrong input throws one clear error and changes nothing", async () => {
  const scene = await gold();
  const before = scene.uniforms();
  const light = await lightPreset("park");
  const fails = (what, name, message) => assert.throws(what, { name, message });
  for (const [given, said, hint = ""] of [
    [null, "null"], ["red", '"red"'], [[], "[object Array]"], [new Date(), "[object Date]"], [new Map(), "[object Map]"],
    [Promise.resolve(light), "[object Promise]", "; await it"],
  ]) {
    fails(() => scene.light(given), "TypeError",
      `light: it is ${said}, expected { r, g, b } with arrays of coefficients, which lightPreset(name) loads${hint}`);
    fails(() => scene.material(given), "TypeError",
      `material: it is ${said}, expected { r, g, b }, which materialPreset(name) loads, or { baseColor, metallic, roughness }${hint}`);
    if (!Array.isArray(given)) {
      fails(() => scene.turn(given), "TypeError",
        `turn: it is ${said}, expected a quaternion [x, y, z, w] or { yaw, pitch, roll }${hint}`);
    }
    fails(() => scene.pixels([0], [0], [1], given), "TypeError", `pixels: it is ${said}, expected { exposure, tone }${hint}`);
    const options = { name: "TypeError", message: `lightPreset: it is ${said}, expected { sources }${hint}` };
    await assert.rejects(lightPreset("park", given), options);
    const inputs = { name: "TypeError", message: `Scene: it is ${said}, expected { light, material, sources, window, engine, assets }${hint}` };
    await assert.rejects(Scene.create(given), inputs);
    if (given) {
      const engine = { name: "TypeError", message: `engine: it is ${given instanceof Promise ? "[object Object]" : said}, expected what load(module) returns` };
      await assert.rejects(Scene.create({ light: "park", material: "nylon", engine: given }), engine);
    }
  }
  await assert.rejects(Scene.create({ light: "park" }), { name: "TypeError", message: /^material: it is undefined, expected/ });
  await assert.rejects(lightPreset("park", { sorces: 4 }), { name: "TypeError", message: 'lightPreset: "sorces" is unknown; did you mean "sources"?' });
  await assert.rejects(Scene.create({ light: "park", material: "nylon", sorces: 4 }), {
    name: "TypeError", message: 'Scene: "sorces" is unknown; did you mean "sources"?',
  });
  fails(() => scene.pixels([0], [0], [1], { exposur: 1 }), "TypeError", 'pixels: "exposur" is unknown; did you mean "exposure"?');
  fails(() => scene.light({ ...light, g: "red" }), "TypeError", "light: g is not an array of numbers");
  fails(() => scene.light({ ...light, b: light.b.slice(1) }), "RangeError",
    "light: b has 99 coefficients, expected 1, 4, 9, 16, 25, 36, 49, 64, 81, 100");
  fails(() => scene.light(three(new Float32Array(121))), "RangeError",
    "light: r has 121 coefficients, expected 1, 4, 9, 16, 25, 36, 49, 64, 81, 100; leave out the rest");
  const detached = Float32Array.from(light.r);
  structuredClone(detached, { transfer: [detached.buffer] });
  fails(() => scene.light({ ...light, r: detached }), "RangeError",
    "light: r has 0 coefficients, expected 1, 4, 9, 16, 25, 36, 49, 64, 81, 100");
  for (const bad of [NaN, Infinity, 1e300, 3e38, -1.1e15, undefined, null, "1"]) {
    const said = typeof bad === "string" ? `"${bad}"` : bad;
    fails(() => scene.light({ ...light, g: Array.from(light.g).with(7, bad) }), "RangeError",
      `light: g[7] is ${said}, expected a number from -1e15 to 1e15`);
    fails(() => scene.material({ ...three([1, bad]) }), "RangeError",
      `material: r[1] is ${said}, expected a number from -1e15 to 1e15`);
  }
  fails(() => scene.material(three([])), "RangeError",
    "material: r has 0 coefficients, expected 1, 2, 5, 8, 14, 20, 30, 40");
  fails(() => scene.turn({ yow: 1 }), "TypeError", 'turn: "yow" is unknown; did you mean "yaw"?');
  fails(() => scene.turn({ x: 0, y: 0, z: 0, w: 1 }), "TypeError", 'turn: "x" is not one of yaw, pitch, roll');
  fails(() => scene.material({ color: "#ffffff" }), "TypeError",
    "material: \"color\" is not one of baseColor, metallic, roughness");
  fails(() => scene.material({ roughness: 1.1 }), "RangeError",
    "material: roughness is 1.1, expected a number from 0 to 1");
  fails(() => scene.material({ baseColor: "red" }), "RangeError",
    'material: baseColor is "red", expected "#rrggbb" or three numbers');
  fails(() => scene.material({ baseColor: null }), "TypeError",
    'material: baseColor is neither "#rrggbb" nor three numbers');
  fails(() => scene.material({ metallic: null }), "RangeError",
    "material: metallic is null, expected a number from 0 to 1");
  fails(() => scene.material({ baseColor: [1, NaN, 0] }), "RangeError",
    "material: green is NaN, expected a number from 0 to 1");
  fails(() => scene.turn([0, 0, 0, 0]), "RangeError", "turn: [0,0,0,0] is not a quaternion");
  fails(() => scene.turn([0, 0, 0]), "RangeError", "turn: [0,0,0] is not a quaternion");
  fails(() => scene.turn({ yaw: NaN }), "RangeError", "turn: yaw is NaN, expected a number");
  fails(() => scene.turn({ yaw: "1" }), "RangeError", 'turn: yaw is "1", expected a number');
  fails(() => scene.turn(["0", 0, 0, 1]), "RangeError", 'turn: ["0",0,0,1] is not a quaternion');
  fails(() => scene.within(0), "RangeError", "within: the tolerance is 0, expected a number from 1e-30 to less than 1");
  for (const bad of [1e-50, 1, 2, NaN, "0.1", null]) fails(() => scene.within(bad), "RangeError", /^within: /);
  fails(() => scene.within(0.1, 0), "RangeError", "within: the exposure is 0, expected a number from 1.2e-38 to 3.4e38");
  for (const bad of [0, -1, NaN, "20", null, undefined]) {
    fails(() => scene.window(bad), "RangeError", /^window: it is .*, expected a number above 0, "auto" or "none"$/);
  }
  for (const [given, said] of [["gloss", '"gloss"'], [null, "null"], [4, "4"], [{}, "[object Object]"]]) {
    fails(() => scene.effects(given), "TypeError", `effects: it is ${said}, expected a list of names`);
  }
  fails(() => scene.effects(["glos"]), "RangeError",
    'effects: "glos" is unknown; did you mean "gloss"?');
  fails(() => scene.components(161), "RangeError", "components: 161 is not a whole number from 0 to 160");
  fails(() => scene.eigenimage(160, [0], [0], [1]), "RangeError",
    "eigenimage: 160 is not a whole number from 0 to 159");
  await assert.rejects(load(new TextEncoder().encode("<!doctype html>")), {
    name: "TypeError", message: "load: this is no WebAssembly module; give one that crates/wasm/build made",
  });
  fails(() => scene.glsl("buffer"), "RangeError",
    'glsl: "buffer" is not one of uniforms, block, texture');
  for (const prefix of ["1a", "a__b", "gl_a", "a-b", 1, null]) {
    fails(() => scene.glsl("block", { prefix }), "RangeError", /^glsl: the prefix is .*, expected a letter, then letters/);
    fails(() => scene.wgsl({ prefix }), "RangeError", /^wgsl: the prefix is /);
  }
  fails(() => scene.glsl("block", { prefx: "a" }), "TypeError", 'glsl: "prefx" is unknown; did you mean "prefix"?');
  fails(() => scene.wgsl({ binding: -1 }), "RangeError", "wgsl: binding: -1 is not a whole number from 0 to 1000");
  fails(() => scene.shade([0], [0, 0], [1]), "RangeError", "shade: x has 1 numbers, y has 2");
  fails(() => scene.shade([0, 0], [0, 0], [1, -1]), "RangeError",
    "shade: normal 1 is (0, 0, -1), expected a unit vector with z >= 0");
  const [one, two] = [new Float32Array(1), new Float32Array(2)];
  for (const out of [{ r: one, g: one, b: two }, { r: one, g: one, b: [0] }, { r: one, g: one }, 4]) {
    fails(() => scene.shade([0], [0], [1], out), "RangeError",
      "shade: expected { r, g, b }, each a Float32Array of length 1, as x has");
  }
  fails(() => scene.shade(), "TypeError", "shade: x is not an array of numbers");
  fails(() => scene.shade(1, 2, 3), "TypeError", "shade: x is not an array of numbers");
  for (const exposure of [0, -1, NaN, Infinity, 1e39, 3.5e38, 1e-38, 1e-50, "2", null]) {
    fails(() => scene.pixels([0], [0], [1], { exposure }), "RangeError",
      `pixels: the exposure is ${typeof exposure === "string" ? `"${exposure}"` : exposure}, expected a number from 1.2e-38 to 3.4e38`);
  }
  fails(() => scene.pixels([0], [0], [1], { tone: "aces" }), "RangeError",
    'pixels: "aces" is not one of linear, reinhard, filmic');
  fails(() => sphere(scene, 0), "RangeError", "sphere: the size is 0, expected a whole number from 1 to 4096");
  await assert.rejects(Scene.create({ light: "parc", material: "red-fabric2" }), {
    name: "RangeError",
    message: 'no light is called "parc"; did you mean park?',
  });
  for (const [kind, given, said] of [
    ["light", "stduio", "did you mean studio?"],
    ["light", "Park", "did you mean park?"],
    ["light", "kitchen", "there are apartment, "],
    ["material", "gold_metalic-paint", "did you mean gold-metallic-paint, "],
    ["material", "nylonn", "did you mean nylon?"],
  ]) {
    const load = kind === "light" ? lightPreset : materialPreset;
    await assert.rejects(load(given), ({ message }) => message.startsWith(`no ${kind} is called "${given}"; ${said}`));
  }
  await assert.rejects(Scene.create({ light: "park", material: "../light/park" }), {
    message: /^no material is called "..\/light\/park"; /,
  });
  await assert.rejects(Scene.create({ light: "park", material: "fabric-red" }), {
    message: /^no material is called "fabric-red"; did you mean red-fabric2, /,
  });
  assert.deepEqual(scene.uniforms(), before);
});

test("the largest numbers that are taken are drawn, however small the exposure", async () => {
  const scene = await gold();
  for (const sign of [1, -1]) {
    const all = (count) => three(Array.from({ length: count }, (_, k) => (k ? sign : 1) * 1e15));
    scene.light(all(100)).material(all(40)).turn({ yaw: 1 });
    for (const tolerance of [undefined, 1e-3, 1e-30]) {
      const { r } = scene.within(tolerance).shade(...NORMALS);
      assert.ok(r.every(Number.isFinite) && scene.uniforms().every(Number.isFinite));
      assert.equal(scene.pixels(...NORMALS, { exposure: scene.exposure() }).length, 4 * 60);
    }
  }
});

test("irradiances are written where they are wanted", async () => {
  const scene = await gold();
  const [r, g, b] = [0, 1, 2].map(() => new Float32Array(60));
  const to = { r, g, b };
  assert.equal(scene.shade(...NORMALS, to), to);
  assert.deepEqual(to, scene.shade(...NORMALS));
});
