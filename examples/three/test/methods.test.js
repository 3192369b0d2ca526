// The conversion of lights to three.js's light probes and maps, and the direct integral.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { readFileSync } from "node:fs";
import { FloatType } from "three";
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { Scene } from "../../../packages/eigenshade/src/index.js";
import { integrals, irradiance, texels } from "../reference.js";
import { open } from "./support.js";

let page, faults, close;

before(async () => {
  ({ page, faults, close } = await open());
  await page.evaluate(async () => Object.assign(window, await import("/examples/three/test/page.js"), await import("/examples/three/methods.js")));
});

after(async () => {
  await close?.();
  assert.deepEqual(faults, []);
});

test("a light probe on a matte sphere is the scene of the light's first nine coefficients", async () => {
  const most = await page.evaluate(async () => {
    const { lightPreset } = await import("eigenshade");
    const { r, g, b } = await lightPreset("lobby");
    const light = { r: r.slice(0, 9), g: g.slice(0, 9), b: b.slice(0, 9) };
    const camera = orthographic([3, 1, 4]);
    const scene = await Scene.create({ light, material: { r: [2], g: [2], b: [2] } });
    scene.turn(camera.quaternion.clone().invert().toArray());
    const material = new THREE.MeshLambertMaterial();
    const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 96, 64), material);
    mesh.add(lightProbe(light));
    return difference(mesh, camera, scene).most;
  });
  assert.ok(most <= 1, `${most}`);
});

test("the direct integral is the scene of a rough material, up to the degrees that it leaves out", async () => {
  const file = readFileSync(new URL("../../../tables/inputs/maps/park.exr", import.meta.url));
  const map = texels(new EXRLoader().setDataType(FloatType).parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.length)));
  for (const metallic of [0, 1]) {
    const material = { baseColor: [0.5, 0.2, 0.08], metallic, roughness: 1 };
    const scene = await Scene.create({ light: "park", material });
    const normals = [[0, 0, 1], [0.6, 0, 0.8], [-0.48, 0.64, 0.6], [0, -0.8, 0.6], [0.2, 0.9, Math.sqrt(0.15)]];
    const found = scene.shade(...[0, 1, 2].map((axis) => normals.map((normal) => normal[axis])));
    const expected = normals.map((normal) => irradiance(integrals(map, normal, 1), material));
    const peak = Math.max(...expected.flat());
    normals.forEach((_, k) => ["r", "g", "b"].forEach((channel, c) => {
      const off = Math.abs(found[channel][k] - expected[k][c]) / peak;
      assert.ok(off <= 0.03, `${metallic}, normal ${k}: ${off}`);
    }));
  }
  // A matte surface hardly responds to what is beyond degree 9.
  const scene = await Scene.create({ light: "park", material: { r: [2], g: [2], b: [2] } });
  const found = scene.shade([0, 0.6, -0.48], [0.6, 0, 0.64], [0.8, 0.8, 0.6]);
  [[0, 0.6, 0.8], [0.6, 0, 0.8], [-0.48, 0.64, 0.6]].forEach((normal, k) => {
    const expected = integrals(map, normal, 1);
    ["r", "g", "b"].forEach((channel, c) => assert.ok(Math.abs(found[channel][k] / expected[c] - 1) <= 5e-3, `${found[channel][k]}, ${expected[c]}`));
  });
});
