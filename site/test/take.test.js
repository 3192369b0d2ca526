// Downloads: what each file has, and that shaders and programs compile.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { EFFECTS, Scene, load } from "../eigenshade/src/index.js";
import { EIGENSHADE } from "../../packages/eigenshade/test/support/own.js";
import { FIRST, began } from "../src/begin.js";
import { toward } from "../src/follow.js";
import { GOLD } from "../src/gold.js";
import { LIGHT } from "../src/parts.js";
import { COMPONENTS } from "../src/state.js";
import * as egg from "../src/take-egg.js";
import { SHIPPED, c, python, rust } from "../src/take.js";
import { ROOT, eggFile, launch, open, serve, settled } from "./support.js";

/** Where the programs are compiled. */
const FOLDER = join(ROOT, "target/site-take");

let browser, server;

before(async () => {
  server = await serve();
  browser = await launch();
  mkdirSync(join(FOLDER, "src"), { recursive: true });
});

after(async () => {
  await browser?.close();
  server?.close();
});

/** What an expression of a shader is, by WebGL 2. */
const irradianceOf = (page, glsl, expression) => page.evaluate(([glsl, expression]) => {
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  gl.getExtension("EXT_color_buffer_float");
  const program = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, "#version 300 es\nvoid main() { gl_Position = vec4(0, 0, 0, 1); gl_PointSize = 1.0; }"],
    [gl.FRAGMENT_SHADER, `#version 300 es\nprecision highp float;\n${glsl}\nout vec4 color; void main() { color = vec4(${expression}, 1); }`],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 1, 1);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
  gl.drawArrays(gl.POINTS, 0, 1);
  const pixel = new Float32Array(4);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, pixel);
  return [...pixel.subarray(0, 3)];
}, [glsl, expression]);

/** A program that writes the pixels of `draw`. */
const DRAWS = `#include "eigenshade.h"
#include <stdio.h>

eigenshade_status draw(const eigenshade_target_t *target);

int main(void) {
  static unsigned char pixels[240 * 240 * 3];
  const eigenshade_target_t target = {pixels, sizeof pixels, 240 * 3, 240, 240, 0, 0, EIGENSHADE_ENCODING_RGB888};
  return draw(&target) || fwrite(pixels, sizeof pixels, 1, stdout) != 1;
}
`;
const STRICT = ["-Wall", "-Wextra", "-Werror", "-std=c11"];

const text = (page, id) => page.locator(`#${id}`).textContent();

describe("downloads", () => {
  const seen = { light: "park", material: "gold-metallic-paint", turn: [0.1, 0.2, -0.3, Math.sqrt(0.86)], exposure: 1.25, sources: 0, window: "none", effects: [...EFFECTS], components: COMPONENTS, tolerance: 0 };
  const gltf = { ...seen, light: "lobby", material: { baseColor: "#b87333", metallic: 1, roughness: 0.4 }, sources: 2, window: 23 };

  const eggSeen = { turn: seen.turn, exposure: 0.5, tolerance: 0, regions: Array.from({ length: 4 }, () => ({ metallic: 1, roughness: 0.4 })) };

  test("each kind is a file of what is seen, and the shader compiles", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780, hash: "object=sphere&step=6&light=park&sources=1&exposure=1&turn=0.1,0.2,-0.3,0.92736" });
    await page.locator("#take summary").click();
    const file = async (kind) => {
      const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-take=${kind}]`).click()]);
      assert.equal(download.suggestedFilename(), `eigenshade.${kind}`);
      return readFileSync(await download.path());
    };
    assert.deepEqual([...(await file("png")).subarray(0, 8)], [137, 80, 78, 71, 13, 10, 26, 10]);
    const found = JSON.parse(await file("json"));
    const { light, material, degree, order, d, sources, window, effects, components, tolerance } = found;
    assert.deepEqual([light, material, degree, order, d.r.length, sources], ["park", "gold-metallic-paint", 9, 7, 160, 1]);
    assert.deepEqual([effects, components, tolerance], [[...EFFECTS], 160, 10 ** (-0.5 - (5.5 * 6) / 39)]);
    assert.ok(window === "none" || window > 0, window);
    const glsl = String(await file("glsl"));
    const drawn = await irradianceOf(page, glsl, "irradiance(vec3(0.36, 0.48, 0.8))");
    const expected = await page.evaluate(async () => {
      const { Scene } = await import("/eigenshade/src/index.js");
      const inputs = { light: "park", material: "gold-metallic-paint", window: "auto" };
      const [scene, best] = [await Scene.create({ ...inputs, sources: 1 }), await Scene.create({ ...inputs, sources: 16 })];
      const length = Math.hypot(0.1, 0.2, -0.3, 0.92736);
      scene.turn([0.1, 0.2, -0.3, 0.92736].map((along) => along / length)).within(10 ** (-0.5 - (5.5 * 6) / 39), best.exposure());
      const { r, g, b } = scene.shade([0.36], [0.48], [0.8]);
      return [r[0], g[0], b[0]];
    });
    expected.forEach((one, k) => assert.ok(Math.abs(one - drawn[k]) < 1e-3 * Math.abs(one), `${expected} ${drawn}`));
    assert.match(String(await file("rs")), /^\/\/! A sphere of gold-metallic-paint under the light park;\n\/\/! its lamps are blurred[^]*presets::light::PARK;/);
    assert.match(String(await file("c")), /eigenshade_light_park_f32/);
    assert.match(String(await file("py")), /es\.lights\["park"\]/);
    // A program names a shipped light.
    await page.locator("h1").click();
    await page.locator("#light").selectOption("hemisphere", { force: true });
    await settled(page);
    await page.locator("#take summary").click();
    await page.locator("[data-take=rs]").click();
    await page.waitForFunction(() => document.getElementById("take-note").textContent);
    assert.equal(await text(page, "take-note"), "Programs are of captured lights; take the coefficients.");
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("at first sight each kind is a file of the egg, whose shader has the page's irradiance", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780 });
    await page.locator("#take summary").click();
    const file = async (kind) => {
      const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-take=${kind}]`).click()]);
      assert.equal(download.suggestedFilename(), kind === "py" ? "gold-sphere.py" : `egg.${kind}`);
      assert.equal(await text(page, "take-note"), `Saved ${download.suggestedFilename()}`);
      return readFileSync(await download.path());
    };
    assert.deepEqual([...(await file("png")).subarray(1, 4)], [...Buffer.from("PNG")]);
    const { light, turn, regions, tolerance } = JSON.parse(await file("json"));
    assert.equal(tolerance, 10 ** (-0.5 - (5.5 * FIRST.step) / 39));
    assert.deepEqual([light, regions.length, regions[0].white.d.r.length, regions[3].black.d.b.length], [LIGHT, 4, 160, 160]);
    const { parts } = await began((await eggFile()).about.regions);
    // The programs have no window, because the page needs none.
    parts.scenes.forEach(({ sources, terms }, k) => {
      const { d, ...found } = regions[k >> 1][["black", "white"][k % 2]];
      assert.deepEqual(found, { sources, window: "none", degree: 9, order: 7, terms });
    });
    turn.forEach((part, k) => assert.ok(Math.abs(part - toward(FIRST.place)[k]) < 1e-6));
    const found = await irradianceOf(page, String(await file("glsl")), "irradiance(1, vec3(0.25), vec3(0.36, 0.48, 0.8))");
    const [black, white] = parts.shade(1, [[0.36], [0.48], [0.8]].map((axis) => Float32Array.from(axis)));
    ["r", "g", "b"].forEach((channel, k) => {
      const expected = black[channel][0] + 0.25 * (white[channel][0] - black[channel][0]);
      assert.ok(Math.abs(found[k] - expected) < 1e-3 * expected, `${found[k]} ${expected}`);
    });
    assert.match(String(await file("rs")), /presets::light::APARTMENT;/);
    assert.match(String(await file("c")), /page left some out, within 0\.0094 % of white\.\n[^]*REGIONS = 4/);
    // The gold of the file that is packed: its code in sRGB, and its roughness.
    const [, color, roughness] = /es\.Material\.gltf\("#(\w+)", metallic=1\.0, roughness=([\d.]+)\)/.exec(String(await file("py")));
    const linear = (code) => (code <= 0.04045 ? code / 12.92 : ((code + 0.055) / 1.055) ** 2.4);
    GOLD.color.forEach((along, c) => assert.ok(Math.abs(linear(parseInt(color.slice(2 * c, 2 * c + 2), 16) / 255) - along) < 0.004, color));
    assert.equal(Number(roughness), GOLD.roughness);
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("files say which effects, eigenimages and terms the picture has", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780, hash: "object=sphere&step=6&light=park&effects=diffuse,gloss&components=40" });
    await page.locator("#take summary").click();
    const file = async (kind) => {
      const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-take=${kind}]`).click()]);
      return readFileSync(await download.path(), "utf8");
    };
    const { effects, components, tolerance, sources, terms, d } = JSON.parse(await file("json"));
    assert.deepEqual([effects, components, sources], [["diffuse", "gloss"], 40, 0]);
    assert.equal(String(terms), await text(page, "terms"));
    const scene = await Scene.create({ light: "park", material: "gold-metallic-paint", sources: "auto", window: "auto" });
    scene.effects(effects).components(components);
    for (const channel of ["r", "g", "b"]) {
      scene.coefficients()[channel].forEach((expected, k) => assert.ok(Math.abs(expected - d[channel][k]) < 1e-6, `${channel}${k}`));
    }
    assert.equal(tolerance, 10 ** (-0.5 - (5.5 * 6) / 39));
    for (const kind of ["rs", "c", "py"]) {
      const marks = { rs: "//!", c: " *", py: "#" }[kind];
      assert.ok((await file(kind)).includes(`;
${marks} it has ambient, broad, which the page left out;
${marks} it has ${kind === "py" ? 160 : 46} eigenimages, the page's picture 40 of 160;
${marks} it has all terms; the page left some out, within 4.5 % of white.
`), kind);
    }
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("the program in Rust compiles", () => {
    writeFileSync(join(FOLDER, "Cargo.toml"), `[package]\nname = "take"\nedition = "2024"\n[dependencies]\neigenshade = { path = "../..", features = ["presets"] }\n[workspace]\n`);
    copyFileSync(join(ROOT, "Cargo.lock"), join(FOLDER, "Cargo.lock"));
    writeFileSync(join(FOLDER, "src/lib.rs"), "#![deny(warnings)]\npub mod egg;\npub mod gltf;\npub mod named;\n");
    writeFileSync(join(FOLDER, "src/named.rs"), rust(seen));
    writeFileSync(join(FOLDER, "src/gltf.rs"), rust(gltf));
    writeFileSync(join(FOLDER, "src/egg.rs"), egg.rust(eggSeen));
    execFileSync("cargo", ["check", "--quiet", "--offline"], { cwd: FOLDER, stdio: "pipe" });
  });

  test("the program in C compiles", () => {
    execFileSync(EIGENSHADE, ["pack-object", join(ROOT, "target/page/egg.glb"), "--size", "240", "--out", join(FOLDER, "egg.h")], { stdio: "pipe" });
    assert.match(readFileSync(join(FOLDER, "egg.h"), "utf8"), /101, 105, 103, 111, 98, 1, 240, 0, 240, 0, 4, 0/);
    for (const [name, text] of [["named", c(seen)], ["gltf", c(gltf)], ["egg", egg.c(eggSeen)]]) {
      writeFileSync(join(FOLDER, `${name}.c`), text);
      execFileSync("cc", ["-fsyntax-only", ...STRICT, "-I", join(ROOT, "crates/capi/include"), join(FOLDER, `${name}.c`)], { stdio: "pipe" });
    }
  });

  test("the program in C draws what the package draws with its table, to a code", async () => {
    const library = join(FOLDER, "capi");
    execFileSync(join(ROOT, "crates/capi/install"), [library, "host"], { stdio: "pipe" });
    const environment = { ...process.env, EIGENSHADE_TABLE: join(ROOT, "tables/sphere.bin") };
    execFileSync(join(ROOT, "crates/wasm/build"), ["--to", FOLDER, "color.simd"], { env: environment, stdio: "pipe" });
    const engine = await load(readFileSync(join(FOLDER, "color.simd.wasm")));
    assert.equal(engine.components, SHIPPED);
    writeFileSync(join(FOLDER, "main.c"), DRAWS);
    for (const [name, one] of [["drawn-named", seen], ["drawn-gltf", gltf]]) {
      const program = join(FOLDER, name);
      writeFileSync(`${program}.c`, c(one));
      execFileSync("cc", [
        ...STRICT, "-I", join(library, "include"), join(FOLDER, "main.c"), `${program}.c`, "-L", join(library, "lib"), "-leigenshade_capi",
        ..."-lm -lpthread -ldl".split(" "), "-o", program,
      ], { stdio: "pipe" });
      const found = execFileSync(program);
      assert.equal(found.length, 3 * 240 * 240);
      const places = Array.from({ length: 240 * 240 }, (_, k) => k).filter((k) => Math.hypot((k % 240) - 119.5, Math.floor(k / 240) - 119.5) < 119);
      const x = places.map((k) => ((k % 240) - 119.5) / 120);
      const y = places.map((k) => (119.5 - Math.floor(k / 240)) / 120);
      const z = x.map((along, k) => Math.sqrt(1 - along ** 2 - y[k] ** 2));
      // Of all terms, without sources and window.
      const scene = await Scene.create({ light: one.light, material: one.material, engine });
      const expected = scene.turn(one.turn).pixels(x, y, z, { exposure: one.exposure });
      const off = places.flatMap((place, k) => [0, 1, 2].map((channel) => Math.abs(found[3 * place + channel] - expected[4 * k + channel])));
      const [most, lit] = [off.reduce((most, one) => Math.max(most, one)), found.filter((code) => code > 40).length];
      assert.ok(most <= 1 && lit > places.length, `${name}: off by up to ${most} codes, ${lit} are lit`);
    }
  });

  test("the program in Python is that of the package's page, with its turn", () => {
    const read = (path) => readFileSync(join(ROOT, path), "utf8");
    const [page, stubs] = [read("crates/python/README.md"), read("crates/python/python/eigenshade/__init__.pyi")];
    const version = /^version = "(.*)"$/m.exec(read("Cargo.toml"))[1];
    for (const write of [rust, c, python]) assert.ok(write(seen).includes(`eigenshade ${version} (README.md`));
    for (const one of [seen, gltf]) {
      const program = python(one);
      execFileSync("python3", ["-c", "import ast, sys; ast.parse(sys.stdin.read())"], { input: program });
      assert.match(program, /\* image\[\.\.\., :3\].*\n.*\n.*open\("sphere.ppm", "wb"\).*\n.*b"P6 240 240 255\\n" \+/);
      for (const call of ["import eigenshade as es", "es.Table()", ".rotated(yaw="]) assert.ok(program.includes(call) && page.includes(call), call);
      for (const name of ["yaw", "pitch", "roll", "size", "sources"]) assert.ok(program.includes(`${name}=`) && stubs.includes(`${name}: `), name);
    }
    // Differences from the page's picture, one by one.
    assert.match(read("crates/capi/include/eigenshade_table.h"), new RegExp(`^#define EIGENSHADE_COMPONENTS ${SHIPPED}$`, "m"));
    const terms = "it has all terms; the page left some out, within 1.2 % of white";
    const left = "it has broad, which the page left out";
    /** The lines of a title after the first. */
    const saidBy = (program) => /(?:park|apartment)([^.;]*;[^]*?)?\.\n/.exec(program)[1]?.split(/;\n(?:\/\/!| \*|#) /).slice(1) ?? [];
    for (const [write, images] of [[rust, SHIPPED], [c, SHIPPED], [python, COMPONENTS]]) {
      const usual = images < COMPONENTS ? [`it has ${images} eigenimages, the page's picture 160 of 160`] : [];
      assert.deepEqual(saidBy(write(seen)), usual);
      assert.deepEqual(saidBy(write({ ...seen, effects: ["ambient", "diffuse", "gloss"] })), [left, ...usual]);
      assert.deepEqual(saidBy(write({ ...seen, components: 159 })), [`it has ${images} eigenimages, the page's picture 159 of 160`]);
      assert.deepEqual(saidBy(write({ ...seen, tolerance: 0.012 })), [...usual, terms]);
    }
    for (const write of [egg.rust, egg.c]) {
      assert.equal(saidBy(write(eggSeen)).length, 2);
      assert.deepEqual(saidBy(write({ ...eggSeen, tolerance: 0.012 })).slice(2), [terms]);
    }
    const [lamps, rings] = [/; *\n(\/\/!| \*|#) its lamps are blurred/, /;\n(\/\/!| \*|#) no window lessens its dark rings[;.]\n/];
    for (const write of [rust, c, python]) {
      assert.equal(lamps.test(write(gltf)), write !== python);
      assert.match(write(gltf), rings);
      assert.doesNotMatch(write(seen), /blurred|window/);
    }
    assert.match(python(gltf), /es\.Material\.gltf\("#b87333", metallic=1\.0, roughness=0\.4\)/);
    assert.match(page, /es\.Material\.gltf\("#b87333", metallic=1, roughness=0\.4\)/);
  });

  test("angles are those of the turn", async () => {
    const { angles } = await import("../src/take.js");
    const { multiply } = await import("../src/turn.js");
    const { yaw, pitch, roll } = angles(seen.turn);
    const about = (axis, angle) => [0, 1, 2].map((k) => (k === axis ? Math.sin(angle / 2) : 0)).concat(Math.cos(angle / 2));
    const turn = multiply(about(1, yaw), multiply(about(0, pitch), about(2, roll)));
    const sign = Math.sign(turn[3] * seen.turn[3]);
    turn.forEach((part, k) => assert.ok(Math.abs(sign * part - seen.turn[k]) < 1e-5, `${turn}`));
  });
});
