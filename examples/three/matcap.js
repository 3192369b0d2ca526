// A matcap that follows the light: a MeshMatcapMaterial whose texture an eigenshade scene computes.

import { DataTexture, DataUtils, HalfFloatType, LinearFilter, MeshMatcapMaterial, Quaternion, RGBAFormat } from "three";
import { warnUnsupported } from "./unsupported.js";

/** Radius of the disc in a texture, as in the shader of `MeshMatcapMaterial`. */
const RADIUS = 0.495;

/**
 * A drop-in for `MeshMatcapMaterial`, which any number of meshes share. Whenever the camera or
 * `material.lightRotation` turned, it shades the texture anew on the CPU and uploads it. After
 * `scene.light(..)` or `scene.material(..)` call `material.update()`. It warns once of each property of
 * other materials that is set, and of `receiveShadow`, which have no effect.
 *
 * The texels are linear irradiance, not exposed, and may exceed 1: the texture has no color space,
 * so that three.js decodes nothing, and tone mapping and sRGB come after `color`.
 *
 * @param {import("eigenshade").Scene} scene which the material turns
 * @param {object} [options] `size`, texels on a side, and parameters of `MeshMatcapMaterial`
 */
export function eigenMatcap(scene, { size = 128, ...parameters } = {}) {
  const shade = matcap(size);
  const texels = new Uint16Array(4 * size * size).fill(DataUtils.toHalfFloat(1));
  const matcapTexture = new DataTexture(texels, size, size, RGBAFormat, HalfFloatType);
  matcapTexture.magFilter = matcapTexture.minFilter = LinearFilter;
  const material = new MeshMatcapMaterial({ matcap: matcapTexture, ...parameters });
  const [turn, turned] = [new Quaternion(), new Quaternion()];
  const check = warnUnsupported(material);
  let changed = true;

  material.lightRotation = new Quaternion();
  material.update = () => {
    changed = true;
    return material;
  };
  material.onBeforeRender = (renderer, world, camera, geometry, object) => {
    check(object);
    turn.setFromRotationMatrix(camera.matrixWorldInverse).multiply(material.lightRotation);
    if (!changed && turn.equals(turned)) return;
    turned.copy(turn);
    changed = false;
    const { r, g, b } = shade(scene.turn(turn.toArray()));
    for (let k = 0; k < size * size; k++) {
      texels[4 * k] = half(r[k]);
      texels[4 * k + 1] = half(g[k]);
      texels[4 * k + 2] = half(b[k]);
    }
    matcapTexture.needsUpdate = true;
  };
  material.addEventListener("dispose", () => matcapTexture.dispose());
  return material;
}

const half = (number) => DataUtils.toHalfFloat(Math.min(65504, Math.max(0, number)));

/**
 * A function that shades the texels of a matcap, row by row from the bottom. Texels outside the
 * disc have the irradiance of the rim.
 */
export function matcap(size) {
  const [x, y, z, r, g, b] = Array.from({ length: 6 }, () => new Float32Array(size * size));
  for (let k = 0; k < size * size; k++) {
    const across = ((k % size) + 0.5) / size - 0.5;
    const up = (Math.floor(k / size) + 0.5) / size - 0.5;
    const distance = Math.hypot(across, up) / RADIUS;
    const scale = RADIUS * Math.max(1, distance);
    [x[k], y[k]] = [across / scale, up / scale];
    z[k] = Math.sqrt(Math.max(0, 1 - distance * distance));
  }
  return (scene) => scene.shade(x, y, z, { r, g, b });
}
