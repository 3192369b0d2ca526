// The matcap against the package's module, on 8 bits.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open } from "./support.js";

let page, faults, close;

before(async () => {
  ({ page, faults, close } = await open());
  await page.evaluate(async () => Object.assign(window, await import("/examples/three/test/page.js"), await import("/examples/three/matcap.js")));
});

after(async () => {
  await close?.();
  assert.deepEqual(faults, []);
});

// Root mean square and largest difference in codes of sRGB. The irradiance changes at the rim as a
// root, which a texture cuts off.
for (const [size, rms, most] of [[32, 2.5, 45], [64, 1.5, 36], [128, 0.8, 22], [256, 0.5, 16]]) {
  test(`a sphere by a matcap of ${size} texels, while the camera goes around`, async () => {
    const found = await page.evaluate(async (size) => {
      const inputs = { light: "lobby", material: "gold-metallic-paint" };
      const scene = await Scene.create(inputs);
      const material = eigenMatcap(scene, { size });
      material.color.setScalar(scene.exposure());
      const mesh = new THREE.Mesh(new THREE.SphereGeometry(0.01, 96, 64), material);
      const found = [];
      for (const position of [[0, 0, 5], [3, 2, 3]]) {
        // From far away, so that the matcap's own frames agree with the camera's.
        const camera = perspective(position.map((at) => 4 * at), 0.06);
        const module = (await Scene.create(inputs)).turn(camera.quaternion.clone().invert().toArray());
        found.push(difference(mesh, camera, module));
      }
      return found;
    }, size);
    for (const { most: largest, rms: mean, lit, count } of found) {
      assert.ok(largest <= most && mean <= rms, `${largest} codes, ${mean} rms`);
      assert.ok(lit > 100 && count > 1000);
    }
  });
}

test("it warns once of what has no effect, and is drawn as before", async () => {
  const { warnings, most, kept } = await page.evaluate(async () => {
    const material = eigenMatcap(await Scene.create({ light: "lobby", material: "nylon" }));
    const [mesh, camera] = [new THREE.Mesh(new THREE.SphereGeometry(), material), orthographic([0, 0, 5])];
    const before = picture(mesh, camera);
    const { warn } = console;
    const warnings = [];
    console.warn = (...parts) => warnings.push(parts.join(" "));
    const texture = new THREE.DataTexture(new Uint8Array([9, 9, 9, 255]), 1, 1);
    texture.needsUpdate = true;
    for (const name of ["roughnessMap", "metalnessMap", "aoMap", "lightMap", "envMap", "emissiveMap", "specularMap", "clearcoatMap"]) {
      for (let k = 0; k < 2; k++) material[name] = texture;
    }
    for (const name of ["roughness", "metalness", "clearcoat", "shininess"]) material[name] = 0.5;
    Object.assign(material, { emissive: new THREE.Color("red"), iridescenceMap: null, wireframeLinejoin: "round" });
    mesh.receiveShadow = true;
    material.needsUpdate = true;
    const after = [0, 1].map(() => picture(mesh, camera)).at(-1);
    console.warn = warn;
    return { warnings, kept: material.roughnessMap === undefined, most: Math.max(...after.map((code, k) => Math.abs(code - before[k]))) };
  });
  assert.equal(most, 0);
  assert.ok(kept);
  assert.deepEqual(warnings.map((text) => /^eigenshade: (\w+) has no effect on this material; .{20,}/.exec(text)?.[1]), [
    "roughnessMap", "metalnessMap", "aoMap", "lightMap", "envMap", "emissiveMap", "specularMap", "clearcoatMap",
    "roughness", "metalness", "clearcoat", "shininess", "emissive", "receiveShadow",
  ]);
});
