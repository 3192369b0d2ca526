// The first sight in a browser, and what is downloaded from the details.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, createReadStream, mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { Readable } from "node:stream";
import { after, before, describe, test } from "node:test";
import { EIGENSHADE } from "../../packages/eigenshade/test/support/own.js";
import { FIRST, began } from "../src/begin.js";
import { toward } from "../src/follow.js";
import { unpacked } from "../src/packed.js";
import { LIGHT, SOURCES } from "../src/parts.js";
import * as egg from "../src/take-egg.js";
import { c, python, rust } from "../src/take.js";
import { NO_WEBGL, ROOT, SITE, launch, open, serve, settled } from "./support.js";

/** A folder of tests' files. */
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

/** In the page: the mean place of the light on the object, each from -1 to 1, and the mean code. */
function brightness() {
  const canvas = document.getElementById("object");
  const side = 96;
  const context = new OffscreenCanvas(side, side).getContext("2d");
  context.drawImage(canvas, 0, 0, side, side);
  const { data } = context.getImageData(0, 0, side, side);
  const sum = { x: 0, y: 0, all: 0 };
  for (let k = 0; k < side * side; k++) {
    const code = data[4 * k] + data[4 * k + 1] + data[4 * k + 2];
    sum.x += code * ((2 * (k % side)) / side - 1);
    sum.y += code * (1 - (2 * Math.floor(k / side)) / side);
    sum.all += code;
  }
  return { x: sum.x / sum.all, y: sum.y / sum.all, mean: sum.all / (3 * side * side) };
}

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

/** The file of the egg. */
const eggFile = () => unpacked(Readable.toWeb(createReadStream(join(SITE, "object/egg.bin"))));

const text = (page, id) => page.locator(`#${id}`).textContent();

describe("the first sight", { concurrency: 4 }, () => {
  test("before the first picture there are at most ten requests and 200 KB, without compression", async () => {
    const page = await browser.newPage({ viewport: { width: 390, height: 780 } });
    await page.goto(server.address);
    await page.waitForFunction(() => performance.getEntriesByName("first-picture").length);
    const { count, bytes, names } = await page.evaluate(() => {
      const [{ startTime }] = performance.getEntriesByName("first-picture");
      const [whole] = performance.getEntriesByType("navigation");
      const parts = performance.getEntriesByType("resource").filter(({ name, startTime: at }) => at < startTime && !name.endsWith("icon.svg"));
      return { count: 1 + parts.length, bytes: [whole, ...parts].reduce((sum, { transferSize }) => sum + transferSize, 0), names: parts.map(({ name }) => name) };
    });
    // The icon may be asked for later, or not at all.
    const [requests, all] = [count + 1, bytes + statSync(join(SITE, "icon.svg")).size];
    assert.ok(requests <= 10 && all <= 200e3, `${requests} requests, ${all} bytes: ${names}`);
    const [, said, asked] = /^\| before the first picture \| (\d+) \| (\d+) requests/m.exec(readFileSync(join(SITE, "README.md"), "utf8"));
    assert.ok(Math.abs(all / 1e3 - Number(said)) < 2 && requests === Number(asked), `${requests} requests, ${all} bytes`);
    assert.ok(names.some((name) => name.endsWith("egg.bin")) && !names.some((name) => name.endsWith(".wasm")), `${names}`);
    // The picture is there, with the object in the middle and nothing in the corners.
    assert.ok((await page.evaluate(brightness)).mean > 15);
    await page.close();
  });

  for (const [how, script] of [["WebGL 2", undefined], ["the CPU", NO_WEBGL]]) {
    test(`the light follows the pointer and the arrow keys, drawn by ${how}`, async () => {
      const { page, faults } = await open(browser, server.address, { width: 640, height: 700, script });
      const box = await page.locator("#object").boundingBox();
      const at = async (x, y) => {
        await page.mouse.move(box.x + (box.width * (1 + x)) / 2, box.y + (box.height * (1 - y)) / 2);
        await settled(page);
        return page.evaluate(brightness);
      };
      const [left, right, above, below] = [await at(-0.6, 0), await at(0.6, 0), await at(0, 0.6), await at(0, -0.6)];
      assert.ok(right.x > left.x + 0.05, `${left.x} ${right.x}`);
      assert.ok(above.y > below.y + 0.05, `${below.y} ${above.y}`);
      await page.locator("#object").focus();
      for (let k = 0; k < 12; k++) await page.keyboard.press("ArrowUp");
      await settled(page);
      assert.ok((await page.evaluate(brightness)).y > below.y + 0.05);
      assert.deepEqual(faults, []);
      await page.close();
    });
  }

  test("both ways to draw give the same picture, but for scaling", async () => {
    const pictures = [];
    for (const script of [undefined, NO_WEBGL]) {
      const { page } = await open(browser, server.address, { width: 640, height: 700, script });
      pictures.push(await page.evaluate(brightness));
      await page.close();
    }
    for (const key of ["x", "y"]) assert.ok(Math.abs(pictures[0][key] - pictures[1][key]) < 0.01, JSON.stringify(pictures));
    assert.ok(Math.abs(pictures[0].mean - pictures[1].mean) < 1, JSON.stringify(pictures));
  });

  test("a drag of a finger turns the light", async () => {
    const { page } = await open(browser, server.address, { width: 390, height: 780, hasTouch: true, script: NO_WEBGL });
    const { x, y, width } = await page.locator("#object").boundingBox();
    const tap = async (share) => {
      await page.touchscreen.tap(x + share * width, y + width / 2);
      await settled(page);
      return (await page.evaluate(brightness)).x;
    };
    const left = await tap(0.2);
    assert.ok((await tap(0.8)) > left + 0.05);
    await page.close();
  });

  test("until it is led, the light turns slowly, and not at all for who wants less motion", async () => {
    for (const reducedMotion of ["no-preference", "reduce"]) {
      const page = await browser.newPage({ viewport: { width: 390, height: 780 }, reducedMotion });
      await page.addInitScript(NO_WEBGL);
      await page.goto(server.address);
      await settled(page);
      const before = await page.evaluate(brightness);
      await page.waitForTimeout(1500);
      const now = await page.evaluate(brightness);
      const moved = Math.hypot(now.x - before.x, now.y - before.y);
      assert.ok(reducedMotion === "reduce" ? moved === 0 : moved > 0.01, `${reducedMotion}: ${moved}`);
      await page.close();
    }
  });

  test("the slider changes picture, color difference and frames, and the chip the frames", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780, script: NO_WEBGL });
    const slide = async (step) => {
      await page.locator("#first-step").fill(String(step));
      await settled(page);
      return { difference: Number(await text(page, "difference")), seen: await text(page, "seen"), frames: Number(await text(page, "frames")), picture: await page.evaluate(brightness) };
    };
    const [few, some, all] = [await slide(0), await slide(14), await slide(40)];
    assert.ok(few.difference > 4 && few.difference > some.difference && some.difference > all.difference, JSON.stringify([few, some, all]));
    assert.deepEqual([few, some, all].map(({ seen }) => seen), ["visible", "close", "not visible"]);
    assert.ok(few.frames > all.frames && all.frames > 5);
    assert.notDeepEqual(few.picture, all.picture);
    // Chips of one instruction set differ by their clocks.
    const { frameOf, CHIPS } = await import("../src/boards.js");
    const rates = [];
    for (const { name, clock } of CHIPS) {
      await page.locator("#chip").selectOption(name);
      rates.push(Number(await text(page, "frames")));
      assert.match(await text(page, "frame-cost"), new RegExp(`^[\\d.]+ million instructions of a Cortex-M\\S+ at ${clock / 1e6} MHz$`));
    }
    assert.ok(Math.abs(rates[5] / rates[4] - 480 / 150) < 0.2, `${rates}`);
    assert.ok(frameOf(CHIPS[0].board, [], 0) < 1e5);
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("details open with the accuracy of the first sight, by a link and back, and with any state", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780, script: NO_WEBGL });
    assert.ok(!(await page.locator("#page").isVisible()) && !(await page.locator("#copy").isVisible()));
    const { step } = FIRST;
    assert.deepEqual([await page.locator("#first-step").inputValue(), await page.locator("#open-details").getAttribute("href")], [String(step), `#step=${step}`]);
    await page.locator("#first-step").fill("9");
    await page.locator("#open-details").click();
    await page.waitForFunction(() => document.getElementById("terms").textContent);
    await settled(page);
    assert.ok(await page.locator("#page").isVisible());
    assert.equal(await page.locator("#step").inputValue(), "9");
    assert.ok(!(await page.locator("#first").isVisible()));
    // The initial state has a link, too.
    await page.locator("#step").fill("14");
    await page.waitForFunction(() => location.hash === "#details");
    await page.getByRole("link", { name: "Close details" }).click();
    assert.ok(await page.locator("#first").isVisible());
    assert.ok(!(await page.locator("#page").isVisible()));
    await page.goBack();
    assert.ok(await page.locator("#page").isVisible());
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("a file that is missing is said in place", async () => {
    const page = await browser.newPage();
    await page.route("**/egg.bin", (route) => route.fulfill({ status: 404 }));
    await page.goto(server.address);
    await settled(page);
    assert.equal(await text(page, "first-fault"), "The picture cannot be drawn: object/egg.bin: 404; run site/build");
    await page.close();
  });

  test("the file of the egg has the packed pixels, of which the left half mirrors the right one", async () => {
    const { width, height, texels, palettes, about } = await eggFile();
    const packed = readFileSync(join(ROOT, "target/page/egg.packed"));
    const [wide, rows] = [packed.readUInt16LE(6), 12 + 6 * packed.readUInt16LE(10)];
    const [apart, counts] = [[0, 0, 0], [0, 0]];
    for (let row = 0; row < height; row++) {
      const [first, last] = [row, row + 1].map((k) => rows + 4 * (height + 1) + 6 * packed.readUInt32LE(rows + 4 * k));
      for (let at = first; at < last; ) {
        const [start, length] = [packed.readUInt16LE(at), packed.readUInt16LE(at + 2)];
        at += 6;
        for (let column = start; column < start + length; column++, at += 6) {
          const texel = 4 * (row * width + column - (wide - width) / 2);
          const side = Number(column < wide / 2);
          counts[side]++;
          const off = Math.hypot(packed.readInt8(at) + 128 - texels[texel], packed.readInt8(at + 1) + 128 - texels[texel + 1]);
          if (!side) assert.equal(off, 0, `row ${row}, column ${column}`);
          else apart[off > 2 ? 2 : 0]++;
        }
      }
    }
    assert.ok(Math.abs(counts[0] - counts[1]) < 500 && apart[2] < 0.03 * counts[1], `${counts} ${apart}`);
    // The errors of all terms are those of the shipped lights, between two roughnesses.
    const errors = readFileSync(join(ROOT, "tables/inputs/sources.errors.csv"), "utf8").split("\n").map((line) => line.split(","));
    for (const { metallic, roughness, direct } of about.regions) {
      const sources = roughness < 0.6 ? SOURCES : 0;
      const row = errors.find((row) => row.slice(0, 5).join() === `${LIGHT},${sources},9,7,${metallic < 0.5 ? "dielectric" : "metal"}`);
      const tenth = Math.min(5, Math.floor(10 * roughness));
      for (const [value, first] of [[direct.mean, 5], [direct.most, 11]]) {
        const [a, b] = [tenth - 1, tenth].map((k) => Number(row[first + k]));
        assert.ok(value <= Math.max(a, b) + 1e-9 && value >= Math.min(a, b) - 1e-9, `${roughness}: ${value} of ${a} and ${b}`);
      }
    }
    // The palettes of the first light, in 8 bits.
    const exact = (await began(about.regions)).palettes;
    exact.forEach((value, k) => assert.ok(Math.abs(value - palettes[k]) <= 0.012 + 0.02 * value || value > 4, `${k}: ${value} ${palettes[k]}`));
  });
});

describe("downloads", () => {
  const seen = { light: "park", material: "gold-metallic-paint", turn: [0.1, 0.2, -0.3, Math.sqrt(0.86)], exposure: 1.25, sources: 0 };
  const gltf = { ...seen, light: "lobby", material: { baseColor: "#b87333", metallic: 1, roughness: 0.4 }, sources: 2 };

  const eggSeen = { turn: seen.turn, exposure: 0.5, regions: Array.from({ length: 4 }, () => ({ metallic: 1, roughness: 0.4 })) };

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
    assert.deepEqual([found.light, found.material, found.degree, found.order, found.d.r.length, found.sources], ["park", "gold-metallic-paint", 9, 7, 160, 1]);
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
    assert.match(String(await file("rs")), /park|PARK/);
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
      assert.equal(download.suggestedFilename(), `egg.${kind}`);
      return readFileSync(await download.path());
    };
    assert.deepEqual([...(await file("png")).subarray(1, 4)], [...Buffer.from("PNG")]);
    const { light, turn, regions } = JSON.parse(await file("json"));
    assert.deepEqual([light, regions.length, regions[0].white.r.length, regions[3].black.b.length], [LIGHT, 4, 160, 160]);
    turn.forEach((part, k) => assert.ok(Math.abs(part - toward(FIRST.place)[k]) < 1e-6));
    const found = await irradianceOf(page, String(await file("glsl")), "irradiance(1, vec3(0.25), vec3(0.36, 0.48, 0.8))");
    const { parts } = await began((await eggFile()).about.regions);
    const [black, white] = parts.shade(1, [[0.36], [0.48], [0.8]].map((axis) => Float32Array.from(axis)));
    ["r", "g", "b"].forEach((channel, k) => {
      const expected = black[channel][0] + 0.25 * (white[channel][0] - black[channel][0]);
      assert.ok(Math.abs(found[k] - expected) < 1e-3 * expected, `${found[k]} ${expected}`);
    });
    assert.match(String(await file("rs")), /presets::light::APARTMENT;/);
    assert.match(String(await file("c")), /REGIONS = 4/);
    assert.match(String(await file("py")), /es\.Material\.gltf\("#ffdb95", metallic=1\.0, roughness=0\.4/);
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
      execFileSync("cc", ["-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-std=c11", "-I", join(ROOT, "crates/capi/include"), join(FOLDER, `${name}.c`)], { stdio: "pipe" });
    }
  });

  test("the program in Python is that of the package's page, with its turn", () => {
    const read = (path) => readFileSync(join(ROOT, path), "utf8");
    const [page, stubs] = [read("crates/python/README.md"), read("crates/python/python/eigenshade/__init__.pyi")];
    for (const one of [seen, gltf]) {
      const program = python(one);
      execFileSync("python3", ["-c", "import ast, sys; ast.parse(sys.stdin.read())"], { input: program });
      for (const call of ["import eigenshade as es", "es.Table()", ".rotated(yaw="]) assert.ok(program.includes(call) && page.includes(call), call);
      for (const name of ["yaw", "pitch", "roll", "size", "sources"]) assert.ok(program.includes(`${name}=`) && stubs.includes(`${name}: `), name);
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
