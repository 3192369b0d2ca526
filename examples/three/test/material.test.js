// The material against the package's module, on 8 bits.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open } from "./support.js";

/** Codes of 8 bits. The module and the shader round a number on the edge between two codes differently. */
const CODES = 1;

let page, faults, close;

before(async () => {
  ({ page, faults, close } = await open());
  await page.evaluate(async () => {
    Object.assign(window, await import("/examples/three/test/page.js"), await import("/examples/three/matcap.js"));
    window.meshes = await import("/examples/three/meshes.js");
    window.inputs = { light: "lobby", material: "gold-metallic-paint" };
    window.sphere = () => new THREE.SphereGeometry(1, 96, 64);
    /** A scene as `EigenMaterial` has to turn it, by other means. */
    window.expected = async (camera, direction = new THREE.Vector3(0, 0, 1), rotation = new THREE.Quaternion()) => {
      const frame = new THREE.Quaternion().setFromUnitVectors(direction.clone().normalize(), new THREE.Vector3(0, 0, 1));
      const turn = frame.clone().multiply(camera.quaternion.clone().invert()).multiply(rotation);
      return { scene: (await Scene.create(inputs)).turn(turn.toArray()), frame };
    };
  });
});

after(async () => {
  await close?.();
  assert.deepEqual(faults, []);
});

/** Asserts that a picture is the module's. */
function same({ most, lit, count }) {
  assert.ok(most <= CODES, `${most} codes`);
  assert.ok(lit > 100 && count > 1000, `${lit}, ${count}`);
}

for (const mapped of [false, true]) {
  test(`a sphere ${mapped ? "with" : "without"} a normal map`, async () => {
    same(await page.evaluate(async (mapped) => {
      const scene = await Scene.create(inputs);
      const material = new EigenMaterial(scene, { normalMap: mapped ? meshes.normalMap() : null });
      const camera = orthographic([0, 0, 5]);
      return difference(new THREE.Mesh(sphere(), material), camera, (await expected(camera)).scene);
    }, mapped));
  });
}

test("small sources of the light, which turn with it and come and go", async () => {
  // Four are read from a texture.
  for (const found of await page.evaluate(async () => {
    const { lightPreset } = await import("eigenshade");
    window.inputs = { light: "lobby", material: "gold-metallic-paint", sources: 4 };
    const scene = await Scene.create(inputs);
    const material = new EigenMaterial(scene, { normalMap: meshes.normalMap() });
    material.lightRotation.setFromEuler(new THREE.Euler(0.2, 0.5, -0.3));
    const [mesh, camera, found] = [new THREE.Mesh(sphere(), material), orthographic([1, 2, 5]), []];
    for (const sources of [4, 0, 1, 8]) {
      window.inputs = { ...inputs, sources };
      scene.light(await lightPreset("lobby", { sources }));
      found.push(difference(mesh, camera, (await expected(camera, undefined, material.lightRotation)).scene));
      if (scene.sources !== sources) throw new Error(`${scene.sources} sources`);
    }
    window.inputs = { light: "lobby", material: "gold-metallic-paint" };
    return found;
  })) same(found);
});

for (const kind of ["column", "morphing", "instances", "knot"]) {
  test(`a mesh with ${kind}`, async () => {
    same(await page.evaluate(async (kind) => {
      const scene = await Scene.create(inputs);
      const material = new EigenMaterial(scene, { normalMap: meshes.normalMap() });
      const mesh = meshes[kind](material, 0.7);
      mesh.bend?.(0.4);
      mesh.rotation.set(0.3, 0.5, 0.1);
      const camera = orthographic([2, 1, 5]);
      return difference(mesh, camera, (await expected(camera)).scene);
    }, kind));
  });
}

test("the light stays in the world while a camera goes around, and by one program", async () => {
  const found = await page.evaluate(async () => {
    const scene = await Scene.create(inputs);
    const material = new EigenMaterial(scene);
    material.lightRotation.setFromEuler(new THREE.Euler(0.3, -0.8, 0.2));
    const mesh = new THREE.Mesh(sphere(), material);
    const found = [];
    let before;
    for (const position of [[0, 0, 5], [5, 0, 0], [-2, 3, -4], [1, -4, 2]]) {
      const camera = orthographic(position);
      const { scene } = await expected(camera, undefined, material.lightRotation);
      found.push(difference(mesh, camera, scene));
      before ??= programs();
    }
    return { found, compiled: programs() - before };
  });
  found.found.forEach(same);
  assert.equal(found.compiled, 0);
});

test("a matte point has the same irradiance from all sides", async () => {
  const spread = await page.evaluate(async () => {
    // Of all materials, only the radiance of a matte surface does not depend on the view.
    const scene = await Scene.create({ light: "lobby", material: { r: [2], g: [2], b: [2] } });
    const material = new EigenMaterial(scene);
    const mesh = new THREE.Mesh(sphere(), material);
    const normal = new THREE.Vector3(0.3, 0.4, Math.sqrt(0.75));
    const codes = [[0, 0, 5], [3, 1, 4], [-1, 4, 3]].map((position) => {
      const camera = orthographic(position);
      const pixels = picture(mesh, camera);
      const [x, y] = normal.clone().project(camera).toArray().map((at) => Math.round(80 * (at + 1) - 0.5));
      return [...pixels.slice(4 * (160 * y + x), 4 * (160 * y + x) + 3)];
    });
    return Math.max(...[0, 1, 2].map((c) => Math.max(...codes.map((code) => code[c])) - Math.min(...codes.map((code) => code[c]))));
  });
  // The normals of the three pixels differ by up to half a pixel, 0.6 degrees.
  assert.ok(spread <= 3, `${spread}`);
});

test("a small mesh at the edge of a perspective picture has the frame of its own direction", async () => {
  same(await page.evaluate(async () => {
    const scene = await Scene.create(inputs);
    const material = new EigenMaterial(scene);
    const mesh = new THREE.Mesh(sphere(), material);
    mesh.position.set(3, 2, 0.5);
    mesh.updateMatrixWorld();
    const camera = perspective([1, 1, 8], 60);
    const direction = mesh.position.clone().applyMatrix4(camera.matrixWorldInverse).negate();
    const of = await expected(camera, direction);
    return difference(mesh, camera, of.scene, of.frame);
  }));
});

test("with view `camera` it has the camera's frame", async () => {
  same(await page.evaluate(async () => {
    const scene = await Scene.create(inputs);
    const material = new EigenMaterial(scene, { view: "camera" });
    const mesh = new THREE.Mesh(sphere(), material);
    mesh.position.set(1, 0.6, 0);
    const camera = perspective([1, 1, 6], 40);
    return difference(mesh, camera, (await expected(camera)).scene);
  }));
});

test("a new light or material is an upload, a tolerance is a new program", async () => {
  const counts = await page.evaluate(async () => {
    const { lightPreset, materialPreset } = await import("eigenshade");
    const scene = await Scene.create(inputs);
    const material = new EigenMaterial(scene);
    const mesh = new THREE.Mesh(sphere(), material);
    const camera = orthographic([0, 0, 5]);
    const pictures = [picture(mesh, camera)];
    const counts = [programs()];
    scene.light(await lightPreset("studio"));
    pictures.push(picture(mesh, camera));
    scene.material(await materialPreset("red-fabric2"));
    pictures.push(picture(mesh, camera));
    scene.material({ baseColor: "#336699", roughness: 0.6 });
    pictures.push(picture(mesh, camera));
    counts.push(programs());
    scene.within(0.01);
    picture(mesh, camera);
    counts.push(programs());
    const different = pictures.every((one, k) => pictures.every((other, l) => k === l || one.some((n, at) => n !== other[at])));
    return { counts, different };
  });
  const [first, updated, truncated] = counts.counts;
  assert.equal(updated, first);
  assert.equal(truncated, first + 1);
  assert.ok(counts.different);
});

test("two materials of scenes with different terms do not share a program", async () => {
  const found = await page.evaluate(async () => {
    const camera = orthographic([0, 0, 5]);
    const found = [];
    for (const tolerance of [undefined, 0.1]) {
      const scene = (await Scene.create(inputs)).within(tolerance);
      const material = new EigenMaterial(scene);
      const module = (await expected(camera)).scene.within(tolerance);
      found.push(difference(new THREE.Mesh(sphere(), material), camera, module));
    }
    return found;
  });
  found.forEach(same);
});

test("two meshes with the same material in a perspective picture are an error", async () => {
  const { message, turns } = await page.evaluate(async () => {
    const material = new EigenMaterial(await Scene.create(inputs));
    const [one, other] = [0, 1].map(() => new THREE.Mesh(sphere(), material));
    const camera = perspective([0, 0, 5]);
    let turns = 0;
    for (const mesh of [one, other, one]) turns += picture(mesh, camera).some((code) => code > 100);
    try {
      picture(new THREE.Group().add(one, other), camera);
    } catch ({ message }) {
      return { message, turns };
    }
  });
  assert.equal(turns, 3);
  assert.match(message, /each mesh needs a material of its own/);
});

test("two renderers may draw two meshes with the same material", async () => {
  const lit = await page.evaluate(async () => {
    const material = new EigenMaterial(await Scene.create(inputs));
    const camera = perspective([0, 0, 5]);
    // Their first pictures, of one number.
    return [0, 1].map((x) => {
      const mesh = new THREE.Mesh(sphere(), material);
      mesh.position.x = x;
      const renderer = new THREE.WebGLRenderer();
      renderer.render(new THREE.Scene().add(mesh), camera);
      const { gl, data } = { gl: renderer.getContext(), data: new Uint8Array(4) };
      gl.readPixels(150, 75, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, data);
      renderer.dispose();
      return data[0];
    });
  });
  assert.ok(lit.every((code) => code > 0), `${lit}`);
});

test("it warns once of what has no effect, and is drawn as before", async () => {
  const { warnings, most, kept } = await page.evaluate(async () => {
    const material = new EigenMaterial(await Scene.create(inputs));
    const [mesh, camera] = [new THREE.Mesh(sphere(), material), orthographic([0, 0, 5])];
    const before = picture(mesh, camera);
    const { warn } = console;
    const warnings = [];
    console.warn = (...parts) => warnings.push(parts.join(" "));
    const texture = new THREE.DataTexture(new Uint8Array([9, 9, 9, 255]), 1, 1);
    texture.needsUpdate = true;
    for (const name of ["roughnessMap", "metalnessMap", "aoMap", "lightMap", "envMap", "specularMap", "clearcoatMap"]) {
      for (let k = 0; k < 2; k++) material[name] = texture;
    }
    for (const name of ["roughness", "metalness", "clearcoat", "shininess"]) material[name] = 0.5;
    Object.assign(material, { iridescenceMap: null, wireframeLinejoin: "round" });
    mesh.receiveShadow = true;
    material.needsUpdate = true;
    const after = [0, 1].map(() => picture(mesh, camera)).at(-1);
    console.warn = warn;
    return { warnings, kept: material.clearcoatMap === undefined, most: Math.max(...after.map((code, k) => Math.abs(code - before[k]))) };
  });
  assert.equal(most, 0);
  assert.ok(kept);
  assert.deepEqual(warnings.map((text) => /^eigenshade: (\w+) has no effect on an EigenMaterial/.exec(text)?.[1]).sort(), [
    "aoMap", "clearcoat", "clearcoatMap", "envMap", "lightMap", "metalness", "metalnessMap", "receiveShadow", "roughness",
    "roughnessMap", "shininess", "specularMap",
  ]);
});

test("a clone is drawn as the material is", async () => {
  same(await page.evaluate(async () => {
    const scene = await Scene.create(inputs);
    const material = new EigenMaterial(scene, { view: "camera", normalMap: meshes.normalMap() });
    material.lightRotation.setFromEuler(new THREE.Euler(0.3, -0.8, 0.2));
    const camera = orthographic([1, 2, 5]);
    return difference(new THREE.Mesh(sphere(), material.clone()), camera, (await expected(camera, undefined, material.lightRotation)).scene);
  }));
});

test("the exposure is the same whatever was drawn last", async () => {
  const found = await page.evaluate(async () => {
    const scene = await Scene.create({ light: "sunset", material: "gold-metallic-paint" });
    const [mesh, found] = [new THREE.Mesh(sphere(), new EigenMaterial(scene)), [scene.exposure()]];
    for (const position of [[0, 0, 5], [5, 0, 0], [0, 0, -5]]) {
      picture(mesh, orthographic(position));
      found.push(scene.exposure());
    }
    return found;
  });
  assert.deepEqual(found, Array(4).fill(found[0]));
});
