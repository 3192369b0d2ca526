// Materials of glTF files in three.js, in floats, against the module's scene of each pixel's material.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { FloatType } from "three";
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { launch, serve } from "./support/browser.js";
import { glb } from "./support/glb.js";
import { EIGENSHADE } from "./support/own.js";

const PAGE = `<!doctype html><link rel=icon href=data:,><script type="importmap">{ "imports": {
  "eigenshade": "/src/index.js", "eigenshade/three": "/src/three.js",
  "three": "/node_modules/three/build/three.module.js", "three/addons/": "/node_modules/three/examples/jsm/"
} }</script>`;

let browser, server, page;
const faults = [];

before(async () => {
  server = await serve({ "/": PAGE });
  browser = await launch();
  page = await browser.newPage();
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !message.text().includes("ReadPixels")) faults.push(message.text());
  });
  await page.goto(`${server.address}/`);
  await page.evaluate(async () => Object.assign(window, await import("/test/support/three.js")));
});

after(async () => {
  await browser?.close();
  server?.close();
  assert.deepEqual(faults, []);
});

const file = (options) => glb(options).toString("base64");

/** Texels of an image, a function of the column and the row. */
const image = (width, height, texel) => ({
  width, height, texels: Array.from({ length: width * height }, (_, k) => [...texel(k % width, Math.floor(k / width)), 255]).flat(),
});

/** Asserts the error of a picture, as a share of white. */
function close({ rms, most, lit, count }, [rmsBound, mostBound], what = "") {
  assert.ok(rms <= rmsBound && most <= mostBound, `${what} rms ${rms}, most ${most}`);
  assert.ok(lit > 0.05 && count > 1000, `${what} ${lit}, ${count}`);
}

// Of white. A white metal of roughness 0.2 is up to 7 times as bright as white here without sources.
for (const [roughness, metallic, bounds] of [[1, 0, [2e-4, 1e-3]], [0.55, 0.5, [3e-4, 3e-3]], [0.4, 0, [5e-4, 7e-3]], [0.2, 1, [3e-3, 4e-2]]]) {
  test(`images of roughness ${roughness}, metalness ${metallic}`, async () => {
    const found = await page.evaluate(async ([file, material]) => {
      const found = [];
      for (const inputs of ["lobby", "park", "studio"].flatMap((light) => [{ light }, { light, sources: 4 }])) {
        // Beyond, the module's scene draws no sources.
        if (inputs.sources && material.roughness > 0.6) continue;
        const object = await loaded(file);
        const scene = await Scene.create({ ...inputs, material: {} });
        const [made] = EigenMaterial.convert(object, scene);
        made.lightRotation.set(0.1, 0.4, -0.2, 0.8).normalize();
        const camera = orthographic(2, 1, 3);
        const turn = camera.quaternion.clone().invert().multiply(made.lightRotation).toArray();
        const pixels = surface(object, camera);
        const expected = await window.module(inputs, turn, pixels, () => material);
        found.push(difference(picture(object, camera), pixels, expected, scene.exposure()));
      }
      return found;
    }, [
      file({ material: { pbrMetallicRoughness: { baseColorFactor: [0.8, 0.4, 0.2, 1], metallicFactor: metallic, roughnessFactor: roughness } } }),
      { baseColor: [0.8, 0.4, 0.2], metallic, roughness },
    ]);
    for (const one of found) close(one, bounds);
  });
}

const decoded = (code) => (code / 255 <= 0.04045 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4);
const COLORS = image(5, 3, (column, row) => [50 * column, 255 - 80 * row, 90]);
const LOBES = image(4, 4, (column, row) => [255 - 60 * row, 51 + 68 * column, 85 * row]);
const BUMPS = image(8, 8, (column, row) => [128 + 40 * ((column % 3) - 1), 128 + 40 * ((row % 3) - 1), 235]);
const GLOW = image(2, 2, (column, row) => [40 * column, 0, 60 * row]);

test("color, roughness, metalness, normal, occlusion and emission by textures, vertex colors", async () => {
  const found = await page.evaluate(async ([file, { colors, lobes, glow }]) => {
    const object = await loaded(file);
    const inputs = { light: "lobby" };
    const scene = await Scene.create({ ...inputs, material: {} });
    const [before] = [object.children[0].material];
    const [material] = EigenMaterial.convert(object, scene);
    const shared = ["map", "roughnessMap", "metalnessMap", "normalMap", "aoMap", "emissiveMap"].every((name) => before[name] && material[name] === before[name]);
    const camera = orthographic(1, 2, 3);
    const turn = camera.quaternion.clone().invert().toArray();
    const position = new THREE.Vector3();
    const all = surface(object, camera).map((pixel) => {
      const texel = (texels, width, height, [u, v] = pixel.uv) => texels[Math.min(height - 1, Math.floor(v * height)) * width + Math.min(width - 1, Math.floor(u * width))];
      const near = pixel.uv.some((at, axis) => [5, 3, 4, 8, 2].some((count) => Math.abs(at * count - Math.round(at * count)) < 1e-3));
      // The vertex colors are linear in the position.
      position.set((2 * (pixel.at % 128) + 1) / 128 - 1, (2 * Math.floor(pixel.at / 128) + 1) / 128 - 1, 0).multiplyScalar(1.1);
      position.z = Math.sqrt(Math.max(0, 1 - position.lengthSq()));
      const height = position.applyQuaternion(camera.quaternion).y;
      const [red, green, blue] = texel(colors, 5, 3);
      const [occlusion, roughness, metallic] = texel(lobes, 4, 4);
      const vertex = 0.6 + 0.4 * height;
      return { ...pixel, near, occlusion: occlusion / 255, emission: texel(glow, 2, 2), baseColor: [red * vertex, green * vertex, blue * vertex], metallic: metallic / 255, roughness: roughness / 255 };
    });
    const pixels = all.filter(({ near, normal }) => !near && normal[2] > 0.05);
    // The parts at each pixel's own roughness, directly: of all, and of all but the matte part.
    const lit = await window.parts(inputs, turn, pixels);
    const exposure = scene.exposure();
    const expected = pixels.map(({ occlusion, emission, baseColor, metallic }, k) => baseColor.map((base, c) => {
      const f0 = 0.04 * (1 - metallic) + base * metallic;
      const [matte, metal, rim] = lit[k].map((part) => part[c]);
      return Math.max(0, occlusion * base * (1 - metallic) * (1 - f0) * matte + f0 * metal + rim) + emission[c] / exposure;
    }));
    return { shared, ...difference(picture(object, camera), pixels, expected, exposure) };
  }, [
    file({
      colors: ([, y]) => [0.6 + 0.4 * y, 0.6 + 0.4 * y, 0.6 + 0.4 * y],
      images: { colors: COLORS, lobes: LOBES, bumps: BUMPS, glow: GLOW },
      material: {
        pbrMetallicRoughness: { baseColorTexture: { index: "colors" }, metallicRoughnessTexture: { index: "lobes" } },
        normalTexture: { index: "bumps", scale: 0.8 }, occlusionTexture: { index: "lobes" },
        emissiveTexture: { index: "glow" }, emissiveFactor: [1, 1, 1],
      },
    }),
    Object.fromEntries(Object.entries({ colors: COLORS, lobes: LOBES, glow: GLOW }).map(([name, { texels }]) => [
      name,
      Array.from({ length: texels.length / 4 }, (_, k) => texels.slice(4 * k, 4 * k + 3).map(name === "lobes" ? Number : decoded)),
    ])),
  ]);
  assert.ok(found.shared);
  close(found, [4e-3, 0.05]);
});

test("64 texels of everything are those of the program", async () => {
  const random = (() => {
    let state = 1;
    return (least, most) => {
      state = (48271 * state) % 2147483647;
      return Math.round(least + (most - least) * (state / 2147483647));
    };
  })();
  const bytes = glb({
    shape: "leaf",
    images: {
      colors: image(8, 8, () => [random(0, 255), random(0, 255), random(0, 255)]),
      lobes: image(8, 8, () => [random(60, 255), random(60, 255), random(0, 255)]),
      bumps: image(8, 8, () => {
        const [x, y] = [random(-80, 80), random(-80, 80)];
        return [128 + x, 128 + y, Math.round(128 + Math.sqrt(127 ** 2 - x * x - y * y))];
      }),
    },
    material: {
      pbrMetallicRoughness: { baseColorTexture: { index: "colors" }, metallicRoughnessTexture: { index: "lobes" } },
      normalTexture: { index: "bumps" }, occlusionTexture: { index: "lobes" },
    },
  });
  const folder = mkdtempSync(join(tmpdir(), "eigenshade-"));
  writeFileSync(join(folder, "leaf.glb"), bytes);
  for (const light of ["lobby", "park"]) {
    execFileSync(EIGENSHADE, [
      "render", "--object", "leaf.glb", "--light", light, "--size", "320", "--sources", "4", "--window", "none", "--table", "color", "--exposure", "1", "-o", "leaf.exr",
    ], { cwd: folder, stdio: "pipe" });
    const { buffer, byteOffset, length } = readFileSync(join(folder, "leaf.exr"));
    const { data, width } = new EXRLoader().setDataType(FloatType).parse(buffer.slice(byteOffset, byteOffset + length));
    const row = Array.from({ length: width }, (_, k) => data[4 * (width * (width >> 1) + k) + 3] > 0.5);
    const [first, last] = [row.indexOf(true), row.lastIndexOf(true)];
    const { pixels, exposure } = await page.evaluate(async ([file, light]) => {
      const scene = await Scene.create({ light, material: {}, sources: 4 });
      const object = await loaded(file);
      EigenMaterial.convert(object, scene, { exposure: 1 });
      const camera = orthographic(0, 0, 3);
      Object.assign(camera, { left: -1, right: 1, top: 1, bottom: -1 }).updateProjectionMatrix();
      return { pixels: [...picture(object, camera)], exposure: scene.exposure() };
    }, [bytes.toString("base64"), light]);
    const offs = [];
    for (let k = 0; k < 64; k++) {
      const [x, y] = [(k % 8) + 0.5, Math.floor(k / 8) + 0.5];
      const place = (at) => Math.floor(first + ((last - first + 1) * at) / 8);
      for (let c = 0; c < 3; c++) {
        offs.push(exposure * Math.abs(pixels[4 * (128 * 16 * y + 16 * x) + c] - data[4 * (width * place(y) + place(x)) + c]));
      }
    }
    offs.sort((a, b) => a - b);
    const rms = Math.sqrt(offs.reduce((sum, off) => sum + off * off, 0) / offs.length);
    assert.ok(rms < 3e-3 && offs.at(-1) < 1.5e-2, `${light}: ${rms}, ${offs.at(-1)}`);
  }
  rmSync(folder, { recursive: true });
});

test("one texel of color, metalness and occlusion is the material without textures", async () => {
  const most = await page.evaluate(async (files) => {
    const scene = await Scene.create({ light: "lobby", material: {}, sources: 4 });
    const [one, other] = await Promise.all(files.map(async (file) => {
      const object = await loaded(file);
      const [material] = EigenMaterial.convert(object, scene);
      // A map of roughness takes the blend of five.
      material.roughnessMap = null;
      return picture(object, orthographic(1, 2, 3));
    }));
    const peak = one.reduce((most, number) => Math.max(most, number));
    return one.reduce((most, number, k) => Math.max(most, Math.abs(number - other[k])), 0) / peak;
  }, [
    file({
      images: { color: image(1, 1, () => [200, 90, 30]), lobe: image(1, 1, () => [255, 255, 51]) },
      material: { pbrMetallicRoughness: { baseColorTexture: { index: "color" }, metallicRoughnessTexture: { index: "lobe" }, roughnessFactor: 0.3 }, occlusionTexture: { index: "lobe" } },
    }),
    file({ material: { pbrMetallicRoughness: { baseColorFactor: [...[200, 90, 30].map(decoded), 1], metallicFactor: 0.2, roughnessFactor: 0.3 } } }),
  ]);
  assert.ok(most <= 1e-5, `${most}`);
});

test("a measured material has the color, map, vertex colors and emission of its own", async () => {
  const found = await page.evaluate(async (file) => {
    const object = await loaded(file);
    const scene = await Scene.create({ light: "lobby", material: "red-fabric2" });
    const { map } = object.children[0].material;
    const material = new EigenMaterial(scene, { map, vertexColors: true, emissive: new THREE.Color(0.1, 0.2, 0.3), exposure: 2 });
    material.color.setRGB(0.5, 1, 0.8);
    object.children[0].material = material;
    const camera = orthographic(1, 2, 3);
    const pixels = surface(object, camera).filter(({ normal }) => normal[2] > 0);
    const direct = await Scene.create({ light: "lobby", material: "red-fabric2" });
    direct.turn(camera.quaternion.clone().invert().toArray());
    const { r, g, b } = direct.shade(...[0, 1, 2].map((axis) => Float32Array.from(pixels, ({ normal }) => normal[axis])));
    const texel = map.image.width === 1 ? [200, 90, 30].map((code) => new THREE.Color().setRGB(code / 255, 0, 0, THREE.SRGBColorSpace).r) : [];
    const expected = pixels.map((_, k) => [r[k], g[k], b[k]].map((value, c) => value * [0.5, 1, 0.8][c] * texel[c] * 0.5 + [0.1, 0.2, 0.3][c] / 2));
    return difference(picture(object, camera), pixels, expected, 2);
  }, file({
    colors: () => [0.5, 0.5, 0.5], images: { color: image(1, 1, () => [200, 90, 30]) },
    material: { pbrMetallicRoughness: { baseColorTexture: { index: "color" } } },
  }));
  // No images: the polynomials of the scene.
  close(found, [1e-5, 1e-4]);
});

test("both sides of a leaf, its holes by alphaTest, and opacity", async () => {
  const found = await page.evaluate(async (file) => {
    const inputs = { light: "park" };
    const scene = await Scene.create({ ...inputs, material: {} });
    const object = await loaded(file);
    EigenMaterial.convert(object, scene);
    const found = [];
    for (const position of [[0.5, 0.3, 3], [0.5, 0.3, -3]]) {
      const camera = orthographic(...position);
      const pixels = surface(object, camera);
      const shown = picture(object, camera);
      const solid = pixels.filter(({ uv: [u, v] }) => Math.floor(u * 2) === Math.floor(v * 2));
      const holes = pixels.length - pixels.filter(({ at }) => shown[4 * at + 3] > 0).length;
      const kept = solid.filter(({ at }) => shown[4 * at + 3] > 0);
      const expected = await window.module(inputs, camera.quaternion.clone().invert().toArray(), kept, () => ({ baseColor: [0.5, 0.8, 0.1], metallic: 0, roughness: 0.7 }));
      found.push({ ...difference(shown, kept, expected, scene.exposure()), holes: holes / pixels.length, facing: pixels[0].normal[2] });
    }
    const [material] = [object.children[0].material];
    Object.assign(material, { transparent: true, opacity: 0.25, alphaTest: 0, map: null, needsUpdate: true });
    const opacities = new Set(picture(object, orthographic(0, 0, 3)).filter((_, k) => k % 4 === 3));
    return { found, opacities: [...opacities].sort() };
  }, file({
    shape: "leaf",
    images: { holes: { width: 2, height: 2, texels: [255, 255, 255, 255, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255, 255, 255] } },
    material: {
      doubleSided: true, alphaMode: "MASK",
      pbrMetallicRoughness: { baseColorTexture: { index: "holes" }, baseColorFactor: [0.5, 0.8, 0.1, 1], metallicFactor: 0, roughnessFactor: 0.7 },
    },
  }));
  for (const one of found.found) {
    close(one, [5e-4, 2e-3]);
    assert.ok(Math.abs(one.holes - 0.5) < 0.02 && one.facing > 0.9, `${one.holes}, ${one.facing}`);
  }
  assert.deepEqual(found.opacities, [0, 0.25]);
});

test("an alphaMap, and a small object in perspective, seen from its own direction", async () => {
  const found = await page.evaluate(async (file) => {
    const scene = await Scene.create({ light: "lobby", material: {} });
    const object = await loaded(file);
    object.position.set(3, 2, 0.5);
    object.scale.setScalar(0.02);
    const [material] = EigenMaterial.convert(object, scene);
    object.updateMatrixWorld();
    const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 50);
    camera.position.set(1, 1, 8);
    camera.updateMatrixWorld();
    // Magnified: only the small sphere is in the picture.
    const [x, y] = object.position.clone().project(camera).toArray();
    camera.setViewOffset(2, 2, x + 1 - 0.004, 1 - y - 0.004, 0.008, 0.008);
    camera.updateProjectionMatrix();
    const direction = object.position.clone().applyMatrix4(camera.matrixWorldInverse).negate().normalize();
    const frame = new THREE.Quaternion().setFromUnitVectors(direction, new THREE.Vector3(0, 0, 1));
    const turn = frame.clone().multiply(camera.quaternion.clone().invert()).toArray();
    const pixels = surface(object, camera).map((pixel) => ({ ...pixel, normal: new THREE.Vector3(...pixel.normal).applyQuaternion(frame).toArray() }));
    const expected = await window.module({ light: "lobby" }, turn, pixels, () => ({ baseColor: [0.9, 0.6, 0.3], metallic: 1, roughness: 0.4 }));
    const off = difference(picture(object, camera), pixels, expected, scene.exposure());
    const texture = new THREE.DataTexture(new Uint8Array([0, 100, 0, 255]), 1, 1);
    texture.needsUpdate = true;
    Object.assign(material, { alphaMap: texture, alphaTest: 0.5, needsUpdate: true });
    return { off, hidden: picture(object, camera).every((number) => number === 0) };
  }, file({ material: { pbrMetallicRoughness: { baseColorFactor: [0.9, 0.6, 0.3, 1], metallicFactor: 1, roughnessFactor: 0.4 } } }));
  close(found.off, [2e-3, 2e-2]);
  assert.ok(found.hidden);
});

test("a scene is converted once, and what it cannot draw gives one warning", async () => {
  const found = await page.evaluate(async () => {
    const { warn } = console;
    const warnings = [];
    console.warn = (text) => warnings.push(text);
    const scene = await Scene.create({ light: "lobby", material: {} });
    const glass = new THREE.MeshPhysicalMaterial({ transmission: 1, clearcoat: 0.5, sheenColor: new THREE.Color("red") });
    const [plain, unlit, geometry] = [new THREE.MeshStandardMaterial({ name: "plain" }), new THREE.MeshBasicMaterial(), new THREE.SphereGeometry(0.3)];
    const group = new THREE.Group();
    const meshes = [plain, plain, glass, glass.clone(), unlit, [plain, unlit]].map((material) => new THREE.Mesh(geometry, material));
    group.add(...meshes);
    meshes[1].receiveShadow = meshes[2].receiveShadow = true;
    const made = EigenMaterial.convert(group, scene);
    const again = EigenMaterial.convert(group, scene);
    const materials = meshes.map(({ material }) => material);
    const before = picture(group, orthographic(0, 0, 5));
    made[0].lightRotation.set(0, 1, 0, 0);
    const turned = picture(group, orthographic(0, 0, 5));
    const clone = made[0].clone();
    const other = { roughness: 0.3 };
    const messages = [() => EigenMaterial.from(unlit, scene), () => new EigenMaterial(plain), () => new EigenMaterial(scene, { view: "mesh" }), () => new EigenMaterial(scene, { exposure: 0 }), () => EigenMaterial.from(plain, scene, other).lightRotation.isQuaternion]
      .map((run) => {
        try {
          return run();
        } catch ({ message }) {
          return message;
        }
      });
    console.warn = warn;
    return {
      warnings, messages, count: made.length, again: again.length, name: made[0].name,
      shared: materials[0] === materials[1] && materials[5][0] === materials[0] && materials[4] === unlit && materials[5][1] === unlit,
      different: materials[2] !== materials[3] && made.every((one) => one instanceof EigenMaterial && one instanceof THREE.MeshStandardMaterial),
      light: made.every(({ lightRotation }) => lightRotation === made[0].lightRotation) && clone.lightRotation === made[0].lightRotation,
      changed: before.some((number, k) => Math.abs(number - turned[k]) > 0.1),
    };
  });
  const { warnings, messages, ...rest } = found;
  assert.deepEqual(rest, { count: 3, again: 0, name: "plain", shared: true, different: true, light: true, changed: true });
  assert.deepEqual(
    warnings.map((text) => /^eigenshade: (\w+) has no effect on an EigenMaterial; .{20,}/.exec(text)?.[1]).sort(),
    ["clearcoat", "receiveShadow", "sheenColor", "transmission"],
  );
  assert.deepEqual(messages, [
    "EigenMaterial.from: it is [object Object], expected a MeshStandardMaterial",
    "EigenMaterial: it is [object Object], expected a Scene",
    'view: it is "mesh", expected "object", "camera" or an Object3D',
    "EigenMaterial: the exposure is 0, expected a number from 1.2e-38 to 3.4e38",
    true,
  ]);
});

test("a new light, turn, roughness or map is an upload, other sources are a new program", async () => {
  const found = await page.evaluate(async () => {
    const { lightPreset } = await import("eigenshade");
    const scene = await Scene.create({ light: "lobby", material: {}, sources: "auto", window: "auto" });
    const material = EigenMaterial.from(new THREE.MeshStandardMaterial({ roughness: 0.3, metalness: 0.7 }), scene);
    const mesh = new THREE.Mesh(new THREE.SphereGeometry(), material);
    const camera = orthographic(0, 0, 5);
    const pictures = [picture(mesh, camera)];
    const before = renderer.info.programs.length;
    for (const change of [
      () => material.lightRotation.set(0, 1, 0, 1).normalize(),
      () => (material.roughness = 0.6),
      () => (material.metalness = 0),
      () => material.emissive.set("blue"),
      () => (material.exposure = 2),
    ]) {
      change();
      pictures.push(picture(mesh, camera));
    }
    const after = renderer.info.programs.length;
    scene.light(await lightPreset("studio", { sources: 2 }));
    pictures.push(picture(mesh, camera));
    // Lights, fog and a logarithmic depth of three.js, and an environment, which has no effect.
    const world = new THREE.Scene().add(new THREE.PointLight());
    const plain = pictures.at(-1);
    const lit = picture(mesh, camera, world).every((number, k) => number === plain[k]);
    world.fog = new THREE.Fog("red", 1, 4.5);
    pictures.push(picture(mesh, camera, world));
    const different = pictures.every((one, k) => pictures.every((other, l) => k === l || one.some((number, at) => number !== other[at])));
    material.dispose();
    return { compiled: after - before, different, lit };
  });
  assert.deepEqual(found, { compiled: 0, different: true, lit: true });
});
