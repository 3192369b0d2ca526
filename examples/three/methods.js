// Ways to light the same glTF material by the same map: each makes a world with one mesh.

import * as THREE from "three";
import { EXRLoader } from "three/addons/loaders/EXRLoader.js";
import { Scene, lightPreset } from "eigenshade";
import { EigenMaterial } from "eigenshade/three";
import { eigenMatcap } from "./matcap.js";

/**
 * An equirectangular texture of one of the maps behind the package's lights, in radiance: with its
 * middle where three.js has it, or as it is.
 */
export async function map(name, turn = true) {
  const texture = await new EXRLoader().loadAsync(new URL(`../../tables/inputs/maps/${name}.exr`, import.meta.url).href);
  if (!turn) return texture;
  const { data, width, height } = texture.image;
  // The middle of the map is -z; for three.js it is +x.
  const turned = new data.constructor(data.length);
  for (let k = 0; k < width * height; k++) {
    const column = (k % width + 0.75 * width) % width;
    turned.set(data.subarray(4 * k, 4 * k + 4), 4 * (k - (k % width) + column));
  }
  const made = new THREE.DataTexture(turned, width, height, THREE.RGBAFormat, texture.type);
  made.mapping = THREE.EquirectangularReflectionMapping;
  made.colorSpace = THREE.LinearSRGBColorSpace;
  made.magFilter = made.minFilter = THREE.LinearFilter;
  made.wrapS = THREE.RepeatWrapping;
  made.needsUpdate = true;
  return made;
}

/** A light probe of the first nine coefficients of a light: docs/method.md has the signs. */
export function lightProbe({ r, g, b }) {
  const probe = new THREE.LightProbe();
  probe.sh.coefficients.forEach((coefficient, k) => {
    const degree = Math.floor(Math.sqrt(k));
    const order = k - degree * degree - degree;
    const sign = order < 0 ? -1 : (-1) ** order;
    coefficient.set(r[k], g[k], b[k]).multiplyScalar(sign);
  });
  return probe;
}

/** The parameters of a glTF material for `MeshStandardMaterial`. */
const standard = ({ baseColor, metallic, roughness }) =>
  new THREE.MeshStandardMaterial({ color: new THREE.Color(...baseColor), metalness: metallic, roughness });

/** A glTF material from images of the light. */
export function imaged(scene, material, roughnessMap = null) {
  return EigenMaterial.from(Object.assign(standard(material), { roughnessMap }), scene, { exposure: 1 });
}

/** A map with one white texel. */
export function uniform() {
  const texture = new THREE.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
  texture.needsUpdate = true;
  return texture;
}

function world(geometry, material, ...lights) {
  const made = new THREE.Scene();
  made.add(new THREE.Mesh(geometry, material), ...lights);
  return made;
}

/** A scene with an error of 1 % of its peak, which the tables are relative to. */
const truncated = (scene) => scene.within(0.01, 1 / scene.within(0.01).truncation.peak);

const prefiltered = {};

/** By name, functions of a geometry, the name of a light, a material, and a renderer. */
export const METHODS = {
  eigenshade: async (geometry, light, material) =>
    world(geometry, new EigenMaterial(await Scene.create({ light, material }), { exposure: 1 })),
  "eigenshade, 4 sources": async (geometry, light, material) =>
    world(geometry, new EigenMaterial(await Scene.create({ light, material, sources: 4 }), { exposure: 1 })),
  "eigenshade, 1 %": async (geometry, light, material) =>
    world(geometry, new EigenMaterial(truncated(await Scene.create({ light, material })), { exposure: 1 })),
  "eigenshade, images": async (geometry, light, material) =>
    world(geometry, imaged(await Scene.create({ light, material: {}, sources: 4 }), material)),
  "eigenshade, images, roughness map": async (geometry, light, material) =>
    world(geometry, imaged(await Scene.create({ light, material: {}, sources: 4 }), material, uniform())),
  "eigenshade, matcap of 128²": async (geometry, light, material) =>
    world(geometry, eigenMatcap(await Scene.create({ light, material }))),
  "LightProbe, MeshStandardMaterial": async (geometry, light, material) =>
    world(geometry, standard(material), lightProbe(await lightPreset(light))),
  "LightProbe, MeshLambertMaterial": async (geometry, light, { baseColor }) =>
    world(geometry, new THREE.MeshLambertMaterial({ color: new THREE.Color(...baseColor) }), lightProbe(await lightPreset(light))),
  "PMREM, MeshStandardMaterial": async (geometry, light, material, renderer) => {
    const made = world(geometry, standard(material));
    prefiltered[light] ??= new THREE.PMREMGenerator(renderer).fromEquirectangular(await map(light));
    made.environment = prefiltered[light].texture;
    return made;
  },
};

/** glTF materials: a dielectric and a metal, of three roughnesses. */
export const MATERIALS = [0, 1].flatMap((metallic) =>
  [0.3, 0.5, 0.8].map((roughness) => ({ baseColor: metallic ? [1, 0.72, 0.3] : [0.5, 0.2, 0.08], metallic, roughness })));

export const LIGHTS = ["lobby", "park", "studio"];
