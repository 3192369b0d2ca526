// The conversion of lights to three.js's light probes and maps, and the direct integral.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { readFileSync } from "node:fs";
import { FloatType } from "three";
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { Scene, presetNames } from "../../../packages/eigenshade/src/index.js";
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

test("a scene of all terms leaves 24 of the uniforms that WebGL 2 promises", async () => {
  const { terms } = await Scene.create({ light: "park", material: "chrome" });
  assert.ok(terms + 24 <= 224, `${terms}`);
});

/** The radiance toward +z by the formula as glTF's specification writes it, with vectors, in one channel. */
function written(map, normal, { baseColor: [base], metallic, roughness }) {
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const [alpha, view] = [roughness ** 2, [0, 0, 1]];
  let sum = 0;
  for (let k = 0; k < map.x.length; k++) {
    const light = [map.x[k], map.y[k], map.z[k]];
    const [nl, nv] = [dot(normal, light), dot(normal, view)];
    if (nl <= 0) continue;
    const middle = light.map((number, axis) => number + view[axis]);
    const half = middle.map((number) => number / Math.hypot(...middle));
    const [nh, vh] = [dot(normal, half), dot(view, half)];
    const D = alpha ** 2 / (Math.PI * (nh ** 2 * (alpha ** 2 - 1) + 1) ** 2);
    const V = 0.5 / (nl * Math.sqrt(nv ** 2 * (1 - alpha ** 2) + alpha ** 2) + nv * Math.sqrt(nl ** 2 * (1 - alpha ** 2) + alpha ** 2));
    const f0 = 0.04 * (1 - metallic) + base * metallic;
    const F = f0 + (1 - f0) * (1 - vh) ** 5;
    sum += map.r[k] * nl * (((1 - F) * base * (1 - metallic)) / Math.PI + F * D * V);
  }
  return sum;
}

test("the direct integral is glTF's formula, and the scene of a matte material", async () => {
  const file = readFileSync(new URL("../../../tables/inputs/maps/park.exr", import.meta.url));
  const map = texels(new EXRLoader().setDataType(FloatType).parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.length)));
  const normals = [[0, 0.6, 0.8], [0.6, 0, 0.8], [-0.48, 0.64, 0.6]];
  for (const roughness of [0.3, 0.8]) {
    for (const metallic of [0, 1]) {
      const material = { baseColor: [0.5, 0.2, 0.08], metallic, roughness };
      for (const normal of normals) {
        const [found] = irradiance(integrals(map, normal, roughness), material);
        const expected = written(map, normal, material);
        assert.ok(Math.abs(found / expected - 1) <= 1e-9, `${found}, ${expected}`);
      }
    }
  }
  // Of a matte material the scene is the integral with the clamped cosine up to degree 9.
  const scene = await Scene.create({ light: "park", material: { r: [2], g: [2], b: [2] } });
  const found = scene.shade(...[0, 1, 2].map((axis) => normals.map((normal) => normal[axis])));
  normals.forEach((normal, k) => {
    let expected = 0;
    for (let at = 0; at < map.x.length; at++) {
      expected += map.r[at] * smooth(normal[0] * map.x[at] + normal[1] * map.y[at] + normal[2] * map.z[at]);
    }
    assert.ok(Math.abs(found.r[k] / expected - 1) <= 1e-4, `${found.r[k]}, ${expected}`);
    // The rest of this light, which has a sun.
    assert.ok(Math.abs(expected / integrals(map, normal, 1)[0] - 1) <= 0.04);
  });
});

/** The clamped cosine over π without the Legendre polynomials beyond degree 9. */
function smooth(cosine) {
  // ∫ c P_l(c) dc over [0, 1] is 1/2, 1/3, 1/8, 0, -1/48, 0, 1/128, 0, -1/256 for l = 0, 1, 2..
  const integrals = [1 / 2, 1 / 3, 1 / 8, 0, -1 / 48, 0, 1 / 128, 0, -1 / 256, 0];
  let [before, now, sum] = [0, 1, 0];
  integrals.forEach((integral, l) => {
    sum += ((2 * l + 1) / (2 * Math.PI)) * integral * now;
    [before, now] = [now, ((2 * l + 1) * cosine * now - l * before) / (l + 1)];
  });
  return sum;
}

test("the sentences of README.md have the figures of the tables' files", () => {
  const read = (path) => readFileSync(new URL(`../${path}`, import.meta.url), "utf8");
  const rows = (name) => {
    const [header, ...lines] = read(`results/${name}.csv`).trim().split("\n").slice(1).map((line) => line.split(","));
    return lines.map((line) => Object.fromEntries(header.map((column, k) => [column, line[k]])));
  };
  const readme = read("README.md").replaceAll("\n", " ");
  const near = (pattern, ...expected) => {
    const found = pattern.exec(readme)?.slice(1).map(Number);
    assert.ok(found, String(pattern));
    found.forEach((number, k) => assert.ok(Math.abs(number - expected[k]) <= 0.03 * expected[k], `${number}: ${expected[k]}`));
  };
  const worst = (radius, view) =>
    100 * rows("perspective").find((row) => row.field === "50" && row.radius === radius && row.view === view).worst;
  near(/is off by (\d+) % of the peak for the smaller sphere and by (\d+) % for the larger one/, worst("0.05", "object"), worst("0.15", "object"));
  near(/`view: "camera"` by (\d+) % and (\d+) %/, worst("0.05", "camera"), worst("0.15", "camera"));
  const brightness = (method, column) => Number(rows("compare").find((row) => row.method.startsWith(method))[`${column}_brightness`]);
  near(/metal of roughness 0.3 is ([\d.]+) times as bright/, brightness("eigenshade", "metal_0.3"));
  near(/With four sources it is ([\d.]+) times as bright/, brightness("eigenshade; 4 sources", "metal_0.3"));
  const [without, sources] = ["eigenshade", "eigenshade; 4 sources"].map((name) => rows("compare").find(({ method }) => method === name));
  for (const column of ["dielectric_0.3_rms", "dielectric_0.5_rms", "metal_0.3_rms", "metal_0.5_rms"]) {
    assert.ok(sources[column] < without[column] / 3, column);
  }
  near(/metal of roughness 0.8 is ([\d.]+) times as bright/, brightness("PMREM", "metal_0.8"));
  const matte = rows("perspective").find((row) => row.field === "50" && row.radius === "0.15" && row.view === "object").matte_largest;
  near(/([\d.]+) % of the peak for a white sphere/, 100 * matte);
});
