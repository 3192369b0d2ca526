// Objects with their shadows: pictures against those of the program, which takes the transport of each
// pixel, and files that are cut or changed.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { metered } from "../src/exposure.js";
import { lightPreset } from "../src/index.js";
import { ShadowedObject } from "../src/shadowed.js";
import { EIGENSHADE } from "./support/own.js";
import { plate } from "./support/plate.js";
import { readPng } from "./support/png.js";

const SIZE = 48;
const MATERIAL = "red-fabric2";

/** The rms of channels in codes, that README.md states of 255. */
const README = readFileSync(new URL("../README.md", import.meta.url), "utf8");
const STATED = Number(/within (\d+) codes? of 255 \(rms\)/.exec(README)[1]);

/** The rows of a shipped light up to degree 9, smoothed as in a packed object. */
const rowsOf = (name) => {
  const lines = readFileSync(new URL("../../../tables/inputs/lights.csv", import.meta.url), "utf8").split("\n");
  const ofLight = lines.map((line) => line.split(",")).filter(([light, l]) => light === name && Number(l) <= 9);
  const rows = ofLight.map(([light, l, m, ...rgb]) => {
    const factor = Math.exp(-l * (Number(l) + 1) * 0.06 ** 2 / 2);
    return [light, l, m, ...rgb.map((number) => factor * number)].join(",");
  });
  return [lines.find((line) => line.startsWith("name,")), ...rows, ""].join("\n");
};

let folder, file;
const run = (...all) => execFileSync(EIGENSHADE, all.map(String), { cwd: folder, stdio: "pipe" });

before(() => {
  folder = mkdtempSync(join(tmpdir(), "eigenshade-"));
  writeFileSync(join(folder, "plate.obj"), plate());
  const codes = SIZE ** 2;
  run("pack-object", "plate.obj", "--shadows", "--material", MATERIAL, "--size", SIZE, "--codes", codes, "--out", "plate.bin");
  file = readFileSync(join(folder, "plate.bin"));
});

after(() => rmSync(folder, { recursive: true }));

test("pictures are those of the program, within what README.md states", async () => {
  const object = await ShadowedObject.load(file);
  assert.deepEqual([object.width, object.height, object.degree], [SIZE, SIZE, 16]);
  for (const [light, exposure, tone, rotation, turn] of [
    ["park", 0.8, "filmic", "0,0,0", {}],
    ["apartment", 0.5, "linear", "0,0.7,0", { yaw: 0.7 }],
    ["venice", 0.3, "reinhard", "0,-0.5,1.1", { yaw: -0.5, roll: 1.1 }],
  ]) {
    writeFileSync(join(folder, "light.csv"), rowsOf(light));
    run(
      "render", "--object", "plate.obj", "--shadows", "--size", SIZE, "--material", MATERIAL, "--light", "light.csv",
      "--window", "none", `--rotate=${rotation}`, "--exposure", exposure, "--tone", tone, "--out", "plate.png",
    );
    const { width, height, pixels } = readPng(readFileSync(join(folder, "plate.png")));
    assert.deepEqual([width, height], [SIZE, SIZE]);
    const found = object.light(await lightPreset(light)).turn(turn).pixels({ exposure, tone });
    const [squares, plain] = [[], object.turn([0, 0, 0, 1]).pixels({ exposure, tone })];
    let turned = 0;
    for (let at = 0; at < pixels.length; at += 4) {
      assert.ok(Math.abs(found[at + 3] - pixels[at + 3]) <= 1, `opacity ${found[at + 3]}, not ${pixels[at + 3]}`);
      if (!pixels[at + 3]) continue;
      for (let channel = at; channel < at + 3; channel++) {
        squares.push((found[channel] - pixels[channel]) ** 2);
        turned += (plain[channel] - pixels[channel]) ** 2;
      }
    }
    const mean = (sum) => Math.sqrt(sum / squares.length);
    const rms = mean(squares.reduce((sum, one) => sum + one));
    console.log(`${light}: ${rms.toFixed(2)} codes, without the turn ${mean(turned).toFixed(2)}`);
    assert.ok(rms <= STATED, `${light}: ${rms}`);
    if (rotation !== "0,0,0") assert.ok(mean(turned) > 2 * STATED);
  }
});

test("the exposure makes one pixel in a hundred brighter than white, or the median a dark gray", async () => {
  const object = (await ShadowedObject.load(file)).light(await lightPreset("park"));
  const exposure = object.exposure();
  assert.equal(object.turn({ yaw: 1 }).exposure(), exposure, "the turn has no part in it");
  // The same rule on pixels that are not clipped.
  const pixels = object.turn({}).pixels({ exposure: exposure / 8, tone: "linear" });
  const linear = (code) => (code <= 10.3 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4);
  const covered = Array.from({ length: pixels.length / 4 }, (_, k) => 4 * k).filter((at) => pixels[at + 3] > 127);
  const [r, g, b] = [0, 1, 2].map((channel) => Float32Array.from(covered, (at) => linear(pixels[at + channel])));
  assert.ok(Math.max(...r, ...g, ...b) < 1);
  const found = metered({ r, g, b }) / 8;
  assert.ok(Math.abs(found - 1) < 0.08, `${found}`);
  // A factor of the light is one of the exposure.
  for (const factor of [1e-9, 1e9]) {
    const light = await lightPreset("park");
    for (const channel of ["r", "g", "b"]) light[channel] = light[channel].map((number) => factor * number);
    object.light(light);
    assert.ok(Math.abs(object.exposure() * factor - exposure) < 0.08 * exposure);
  }
  const black = { r: [0], g: [0], b: [0] };
  assert.equal(object.light(black).exposure(), 1);
  assert.ok(object.pixels().every((code, at) => at % 4 === 3 || code === 0));
});

test("a picture replaces that of an ImageData, whose size is checked", async () => {
  const object = (await ShadowedObject.load(file.buffer.slice(file.byteOffset, file.byteOffset + file.length))).light(await lightPreset("park"));
  const data = new Uint8ClampedArray(4 * SIZE ** 2).fill(7);
  object.draw({ width: SIZE, height: SIZE, data }, { exposure: 0.5 });
  assert.deepEqual(data, object.pixels({ exposure: 0.5 }));
  assert.deepEqual(Object.prototype.toString.call(object), "[object ShadowedObject]");
  const record = { width: SIZE, height: 1, data };
  assert.throws(() => object.draw(record), /draw: the target has 48 x 1 pixels, expected 48 x 48/);
  assert.throws(() => object.pixels({ exposure: 0 }), /pixels: the exposure is 0, expected a number/);
  assert.throws(() => object.pixels({ tone: "aces" }), /pixels: "aces"/);
  assert.throws(() => object.pixels({ size: 1 }), /pixels: "size"/);
  assert.throws(() => object.turn([0, 0, 0, 0]), /turn: .* is not a quaternion/);
  assert.throws(() => object.light({ r: [1, 2], g: [1], b: [1] }), /light: r has 2 coefficients, expected 1, 4/);
  assert.deepEqual(object.pixels({ exposure: 0.5 }), data, "errors change nothing");
});

test("files that are cut, changed or something else give one clear error", async () => {
  const refused = (bytes) => assert.rejects(ShadowedObject.load(bytes), {
    name: "RangeError",
    message: /^ShadowedObject: this is no object with shadows, or was cut or changed; give a file/,
  });
  for (const length of [0, 1, 6, 17, 100, file.length >> 1, file.length - 1]) await refused(file.subarray(0, length));
  await refused(Buffer.from("<!doctype html>"));
  for (const version of ["\x01", "\x03"]) await refused(Buffer.concat([Buffer.from(`eigsh${version}`), file.subarray(6)]));
  await assert.rejects(ShadowedObject.load("plate.bin"), /ShadowedObject: it is "plate.bin", expected the bytes of a file/);
  await assert.rejects(ShadowedObject.load(Promise.resolve(file)), /; await it$/);
  // Any byte: an error, or a picture.
  const light = await lightPreset("park");
  let drawn = 0;
  for (let k = 0; k < 300; k++) {
    const changed = Buffer.from(file);
    // Half of them in the header and the shares of the parts.
    changed[k < 150 ? k % 36 : (k * 7919) % file.length] ^= 1 + ((k * 31) % 255);
    const object = await ShadowedObject.load(changed).catch(({ message }) => assert.match(message, /^ShadowedObject: /));
    if (!object) continue;
    object.light(light).turn({ yaw: 1 }).exposure();
    assert.equal(object.pixels().length, 4 * object.width * object.height);
    drawn++;
  }
  assert.ok(drawn > 100 && drawn < 300, `${drawn}`);
});

test("its calls use at most half of the stack", async () => {
  const STACK = 65536;
  const module = new WebAssembly.Module(readFileSync(new URL("../wasm/eigenshade.shadowed.wasm", import.meta.url)));
  const instance = new WebAssembly.Instance(module);
  const object = new ShadowedObject(instance, file).light(await lightPreset("park")).turn({ yaw: 1, pitch: 1 });
  const stack = () => new Uint8Array(instance.exports.memory.buffer, 0, STACK);
  for (const call of [() => object.pixels(), () => object.exposure()]) {
    stack().fill(0xa5);
    call();
    const used = STACK - stack().findIndex((byte) => byte !== 0xa5);
    assert.ok(used > 1000 && used <= STACK / 2, `${used} bytes`);
  }
});
