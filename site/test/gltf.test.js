// Objects of glTF, with their own materials.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { glb } from "../../packages/eigenshade/test/support/glb.js";
import { CPU, apart, choose, keep, on, runs, said, slide, tab, text } from "./details.js";
import { drop } from "./files.js";
import { settled } from "./support.js";

const COPPER = { pbrMetallicRoughness: { baseColorFactor: [0.9, 0.5, 0.3, 1], metallicFactor: 1, roughnessFactor: 0.45 } };

on("a .glb is drawn with its own materials, by scripts that are loaded with it", "object=sphere&sources=auto&pose=0,0,0,1", async (page) => {
  const fetched = [];
  page.on("request", (request) => fetched.push(request.url()));
  const before = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
  assert.ok(!before.some((name) => /three|model|gltf/.test(name)), before.join());
  await drop(page, "ball.glb", glb({ material: COPPER }));
  await said(page, "status", /^ball\.glb: 12,?096 triangles with its own materials\.$/);
  await settled(page);
  assert.ok(fetched.some((name) => name.endsWith("/vendor/three.js")));
  assert.match(await page.locator("#picture").getAttribute("aria-label"), /its own materials under the light lobby/);
  /** The mean and the largest difference from the module, in codes, inside of the rim. */
  const off = (turn, stops) => page.evaluate(async ([turn, stops]) => {
    const { Scene, lightPreset } = await import("/eigenshade/src/index.js");
    const { disc } = await import("/src/cpu.js");
    const shown = await pixels("own-picture");
    const size = document.getElementById("own-picture").width;
    const { x, y, z, places, coverage } = disc(size);
    const most = Math.max(...(await lightPreset("lobby", { sources: "auto" })).steps.map(({ count }) => count));
    const scene = await Scene.create({ light: "lobby", material: {}, sources: most, window: "none" });
    scene.material({ baseColor: [0.9, 0.5, 0.3], metallic: 1, roughness: 0.45 });
    // The page meters its own pixels, the module others.
    const metered = scene.exposure() * 2 ** stops;
    const picture = (await pixels()).some((code) => code > 0);
    const differences = Array.from({ length: 25 }, (_, k) => k - 12).map((percent) => {
      const codes = scene.turn(turn).pixels(x, y, z, { exposure: metered * (1 + percent / 100) });
      let [sum, largest, count] = [0, 0, 0];
      places.forEach((place, k) => {
        if (coverage[k] < 1 || z[k] < 0.1) return;
        for (let c = 0; c < 3; c++) {
          const apart = Math.abs(codes[4 * k + c] - shown[4 * place + c]);
          [sum, count, largest] = [sum + apart, count + 1, Math.max(largest, apart)];
        }
      });
      return { mean: sum / count, largest, count, picture, percent };
    });
    return differences.sort((one, other) => one.mean - other.mean)[0];
  }, [turn, stops]);
  const near = ({ mean, largest, count, picture, percent }) => assert.ok(mean < 0.7 && largest <= 8 && count > 10_000 && !picture && Math.abs(percent) < 10, `${mean}, ${largest}, ${count}, ${picture}, ${percent}`);
  near(await off([0, 0, 0, 1], 0));
  await tab(page, "scene");
  await slide(page, "exposure", 1);
  near(await off([0, 0, 0, 1], 1));
  await slide(page, "exposure", 0);
  // The file of the picture has it, too.
  await page.locator("#take summary").click();
  const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("[data-take=png]").click()]);
  const differ = await page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const shown = await pixels("own-picture");
    return shown.length === data.length ? shown.filter((code, k) => Math.abs(code - data[k]) > 1).length : -1;
  }, readFileSync(await saved.path()).toString("base64"));
  assert.equal(differ, 0);
  // A drag turns the object, and the light.
  await keep(page, "own-picture");
  await choose(page, "drag", "light");
  const { x, y, width, height } = await page.locator("#picture").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 40, y + height / 2, { steps: 3 });
  await page.mouse.up();
  await settled(page);
  assert.ok((await apart(page, "own-picture")) > 0.5);
  const turn = await page.evaluate(async () => (await import("/src/state.js")).fromHash(location.hash.slice(1), true).state.turn);
  assert.ok(turn[1] > 0.05, `${turn}`);
  near(await off(turn, 0));
  // The page's own objects, and back.
  await choose(page, "object", "coin");
  assert.equal(await page.locator("#own-picture").isVisible(), false);
  await choose(page, "object", "own");
  assert.equal(await page.locator("#own-picture").isVisible(), true);
  near(await off(turn, 0));
  await drop(page, "corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  await said(page, "status", /corner.obj: 1 triangles/);
  await settled(page);
  assert.equal(await page.locator("#own-picture").isVisible(), false);
});

on("a .glb with textures, and a .gltf that holds its data", "object=sphere", async (page) => {
  const checks = { width: 2, height: 2, texels: [255, 0, 0, 255, 0, 0, 255, 255, 0, 0, 255, 255, 255, 0, 0, 255] };
  const material = { pbrMetallicRoughness: { baseColorTexture: { index: "checks" }, metallicFactor: 0, roughnessFactor: 1 }, extensions: { KHR_materials_clearcoat: {} } };
  const file = glb({ shape: "leaf", material, images: { checks }, more: { extensionsUsed: ["KHR_materials_clearcoat"] } });
  await page.evaluate(() => (location.hash = "object=sphere&pose=0,0,0,1&light=park"));
  await settled(page);
  await drop(page, "leaf.glb", file);
  await said(page, "status", /^leaf\.glb: 2 triangles with its own materials, without KHR_materials_clearcoat\.$/);
  await settled(page);
  const corners = await page.evaluate(async () => {
    const [codes, size] = [await pixels("own-picture"), document.getElementById("own-picture").width];
    return [[0.35, 0.35], [0.65, 0.35], [0.35, 0.65], [0.65, 0.65]].map(([x, y]) => {
      const at = 4 * (Math.round(y * size) * size + Math.round(x * size));
      return codes[at] > codes[at + 2] ? "red" : "blue";
    });
  });
  assert.deepEqual(corners, ["red", "blue", "blue", "red"]);
  const [start, size] = [20, file.readUInt32LE(12)];
  const json = JSON.parse(file.subarray(start, start + size));
  json.buffers[0].uri = `data:application/octet-stream;base64,${file.subarray(start + size + 8).toString("base64")}`;
  await drop(page, "leaf.gltf", JSON.stringify(json));
  await said(page, "status", /^leaf\.gltf: 2 triangles/);
});

on("a glTF file that cannot be drawn is said in place, and nothing is lost", "object=coin", async (page) => {
  await keep(page);
  const good = glb({ material: COPPER });
  const other = (change) => {
    const json = { asset: { version: "2.0" }, meshes: [{ primitives: [] }], ...change };
    return JSON.stringify(json);
  };
  for (const [name, bytes, pattern] of [
    ["text.glb", "nothing", /^text.glb cannot be used: it is not a glTF file\. The picture is as it was\.$/],
    ["cut.glb", good.subarray(0, 500), /cut.glb cannot be used: it ends after 500 of \d+ bytes/],
    ["old.gltf", other({ asset: { version: "1.0" } }), /it is glTF of version 1.0; expected 2.0/],
    ["packed.gltf", other({ extensionsUsed: ["KHR_draco_mesh_compression"] }), /it is compressed by Draco; export it without\. The picture/],
    ["new.gltf", other({ extensionsRequired: ["EXT_new"] }), /it needs the extension EXT_new, which is not drawn/],
    ["bare.gltf", other({ meshes: [] }), /it has no mesh\. The picture/],
    ["node.gltf", other({ scene: 0, scenes: [{ nodes: [] }] }), /it has no mesh\. The picture/],
    ["apart.gltf", other({ buffers: [{ byteLength: 4, uri: "apart.bin" }] }), /it refers to the file apart.bin; export a .glb/],
  ]) {
    await drop(page, name, bytes);
    await said(page, "fault", pattern);
    assert.equal(await text(page, "status"), "");
    await settled(page);
    assert.equal(await apart(page), 0, name);
  }
});

on("without WebGL 2 a .glb is not drawn", "object=sphere", async (page) => {
  await drop(page, "ball.glb", glb({ material: COPPER }));
  await said(page, "fault", /ball.glb cannot be used: it needs WebGL 2/);
}, { script: CPU });

runs("glTF");
