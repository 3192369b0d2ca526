// Shaders in a browser, on float targets, against the module's own pixels.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, serve } from "./support/browser.js";
import { ownModule } from "./support/own.js";

/** Relative to the peak. */
const TOLERANCE = 1e-5;

let browser, server, page;
const faults = [];

before(async () => {
  server = await serve({
    "/": "<!doctype html><link rel=icon href=data:,><title>Shaders</title>",
    "/long.wasm": ownModule("long"),
  });
  browser = await launch();
  page = await browser.newPage();
  page.on("pageerror", (fault) => faults.push(fault.message));
  await page.goto(`${server.address}/`);
  await page.evaluate(async () => {
    const { Scene, load, presetNames } = await import("/src/index.js");
    const { webgl, webgpu } = await import("/test/support/shaders.js");
    const axes = [0, 1, 2].map(() => new Float32Array(1024));
    for (let k = 0; k < 1024; k++) {
      const [z, angle] = [k === 0 ? 0 : (k + 0.5) / 1024, 2.399963 * k];
      const sine = Math.sqrt(1 - z * z);
      [axes[0][k], axes[1][k], axes[2][k]] = [sine * Math.cos(angle), sine * Math.sin(angle), z];
    }
    /** The largest difference from the module, relative to the peak. */
    const difference = (scene, pixels) => {
      const { r, g, b } = scene.shade(...axes);
      let [most, peak] = [0, 0];
      for (let k = 0; k < 1024; k++) {
        [r, g, b].forEach((channel, which) => {
          peak = Math.max(peak, channel[k]);
          most = Math.max(most, Math.abs(channel[k] - pixels[4 * k + which]));
        });
      }
      return most / peak;
    };
    Object.assign(window, { Scene, load, presetNames, webgl, webgpu, axes, difference });
  });
});

after(async () => {
  await browser?.close();
  server?.close();
  assert.deepEqual(faults, []);
});

for (const storage of ["uniforms", "block", "texture"]) {
  for (const tolerance of [undefined, 1e-3, 1e-2, 0.3]) {
    test(`GLSL with ${storage}, tolerance ${tolerance ?? "none"}`, async () => {
      const found = await page.evaluate(async ([storage, tolerance]) => {
        const scene = await Scene.create({ light: "studio", material: "red-fabric2" });
        scene.turn({ yaw: 0.4, pitch: 0.2, roll: -0.3 }).within(tolerance);
        return difference(scene, webgl(scene, storage, axes));
      }, [storage, tolerance]);
      assert.ok(found <= TOLERANCE, `${found}`);
    });
  }
}

for (const tolerance of [undefined, 1e-2, 0.3]) {
  test(`WGSL, tolerance ${tolerance ?? "none"}`, async () => {
    const found = await page.evaluate(async (tolerance) => {
      const scene = await Scene.create({ light: "studio", material: "red-fabric2" });
      scene.turn({ yaw: 0.4, pitch: 0.2, roll: -0.3 }).within(tolerance);
      return difference(scene, await webgpu(scene, axes));
    }, tolerance);
    assert.ok(found <= TOLERANCE, `${found}`);
  });
}

test("two scenes in one program, one with a prefix, beside a variable of the same name", async () => {
  const found = await page.evaluate(async () => {
    const scene = await Scene.create({ light: "studio", material: "red-fabric2" });
    const other = await Scene.create({ light: "park", material: "gold-metallic-paint" });
    other.within(1e-2);
    const found = [];
    for (const storage of ["uniforms", "block", "texture"]) {
      found.push(difference(scene, webgl(scene, storage, axes, "front_", other.glsl(storage))));
    }
    found.push(difference(scene, await webgpu(scene, axes, "front_", other.wgsl())));
    return found;
  });
  for (const difference of found) assert.ok(difference <= TOLERANCE, `${found}`);
  assert.equal(found.length, 4);
});

test("small sources, in every language", async () => {
  const found = await page.evaluate(async () => {
    const found = [];
    for (const [light, material, sources] of [["studio", "gold-metallic-paint", 4], ["night", { metallic: 1, roughness: 0.3 }, 8]]) {
      const scene = await Scene.create({ light, material, sources });
      scene.turn({ yaw: 0.4, pitch: 0.2, roll: -0.3 }).within(1e-3);
      for (const storage of ["uniforms", "block", "texture"]) found.push(difference(scene, webgl(scene, storage, axes)));
      found.push(difference(scene, await webgpu(scene, axes)));
      if (scene.sources !== sources) throw new Error(`${scene.sources} sources`);
    }
    return found;
  });
  for (const difference of found) assert.ok(difference <= TOLERANCE, `${found}`);
});

test("every shipped material under a light of its own, by one program", async () => {
  const { most, texts } = await page.evaluate(async () => {
    const { light, material } = await presetNames();
    const texts = new Set();
    let most = 0;
    for (const [k, name] of material.entries()) {
      const scene = await Scene.create({ light: light[k % light.length], material: name });
      texts.add(scene.glsl());
      most = Math.max(most, difference(scene, webgl(scene, "uniforms", axes)));
    }
    return { most, texts: texts.size };
  });
  assert.ok(most <= TOLERANCE, `${most}`);
  assert.equal(texts, 1);
});

test("a table of its own, with polynomials of more than 16 terms", async () => {
  const differences = await page.evaluate(async () => {
    const engine = await load(fetch("/long.wasm"));
    const scene = await Scene.create({ light: "studio", material: "red-fabric2", engine });
    const pixels = [webgl(scene, "block", axes), webgl(scene, "texture", axes), await webgpu(scene, axes)];
    return pixels.map((pixels) => difference(scene, pixels));
  });
  for (const found of differences) assert.ok(found <= TOLERANCE, `${differences}`);
});
