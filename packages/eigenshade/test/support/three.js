// In the page: pictures of glTF files in floats, and what the module has for each pixel.

import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { Scene } from "eigenshade";
import { EigenMaterial } from "eigenshade/three";

const SIZE = 128;
const renderer = new THREE.WebGLRenderer();
const target = new THREE.WebGLRenderTarget(SIZE, SIZE, { type: THREE.FloatType });

export { EigenMaterial, Scene, THREE, renderer };

/** The object of a .glb in base64. */
export async function loaded(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return (await new GLTFLoader().parseAsync(bytes.buffer, "")).scene;
}

export function orthographic(...position) {
  const camera = new THREE.OrthographicCamera(-1.1, 1.1, 1.1, -1.1, 0.1, 50);
  camera.position.set(...position);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

/** Red, green, blue and opacity of each pixel, linear. */
export function picture(object, camera, scene = new THREE.Scene()) {
  scene.add(object);
  renderer.setRenderTarget(target);
  renderer.setClearAlpha(0);
  renderer.render(scene, camera);
  const pixels = new Float32Array(4 * SIZE * SIZE);
  renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, pixels);
  renderer.setRenderTarget(null);
  object.removeFromParent();
  return pixels;
}

/** A picture with another material on all meshes. */
function shownBy(make, object, camera) {
  const kept = new Map();
  object.traverse((mesh) => {
    if (!mesh.isMesh) return;
    kept.set(mesh, mesh.material);
    mesh.material = make(mesh.material);
  });
  const pixels = picture(object, camera);
  for (const [mesh, material] of kept) mesh.material = material;
  return pixels;
}

/** Of each covered pixel the normal in the camera's frame, by three.js, and the place in a texture. */
export function surface(object, camera) {
  const normals = shownBy(({ normalMap, normalScale, side, flatShading }) => {
    const made = new THREE.MeshNormalMaterial({ normalMap, side, flatShading });
    made.normalScale.copy(normalScale);
    return made;
  }, object, camera);
  const places = shownBy(({ side }) => new THREE.ShaderMaterial({
    side,
    vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: "varying vec2 at; void main() { gl_FragColor = vec4(at, 1.0, 1.0); }",
  }), object, camera);
  const found = [];
  for (let at = 0; at < SIZE * SIZE; at++) {
    if (normals[4 * at + 3] === 0 || places[4 * at + 3] === 0) continue;
    const normal = [0, 1, 2].map((axis) => 2 * normals[4 * at + axis] - 1);
    const length = Math.hypot(...normal);
    found.push({ at, uv: [places[4 * at], places[4 * at + 1]], normal: normal.map((number) => number / length) });
  }
  return found;
}

/** The module's irradiance of pixels under a light, each of a material; without less than 0 if it is shown. */
export async function module(inputs, turn, pixels, materialOf, isShown = true) {
  const groups = new Map();
  // Behind the rim, that of the rim.
  const shaded = pixels.map(({ normal: [x, y, z] }) => {
    const length = Math.hypot(x, y, Math.max(0, z));
    return [x / length, y / length, Math.max(0, z) / length];
  });
  pixels.forEach((pixel, k) => {
    const key = JSON.stringify(materialOf(pixel));
    groups.set(key, [...(groups.get(key) ?? []), k]);
  });
  const scene = (await Scene.create({ ...inputs, material: {} })).turn(turn);
  const colors = [];
  for (const [key, places] of groups) {
    scene.material(JSON.parse(key));
    const { r, g, b } = scene.shade(...[0, 1, 2].map((axis) => Float32Array.from(places, (k) => shaded[k][axis])));
    places.forEach((k, place) => (colors[k] = [r[place], g[place], b[place]].map((value) => (isShown ? Math.max(0, value) : value))));
  }
  return colors;
}

/**
 * The root mean square and the largest difference of a picture from exposed colors, as a share of white,
 * with how much is lit.
 */
export function difference(found, pixels, expected, exposure) {
  let [sum, most, lit] = [0, 0, 0];
  pixels.forEach(({ at }, k) => {
    expected[k].forEach((color, channel) => {
      const off = found[4 * at + channel] - exposure * color;
      sum += off * off;
      most = Math.max(most, Math.abs(off));
      lit = Math.max(lit, found[4 * at + channel]);
    });
  });
  return { rms: Math.sqrt(sum / (3 * pixels.length)), most, lit, count: pixels.length };
}

/**
 * Of each pixel, which has a `roughness`, the module's irradiance of the parts of its material: matte, metal
 * and rim, in each channel.
 */
export async function parts(inputs, turn, pixels) {
  const of = (baseColor, metallic) => module(inputs, turn, pixels, ({ roughness }) => ({ baseColor, metallic, roughness }), false);
  const [black, white, rim, metal] = await Promise.all([[[0, 0, 0], 0], [[1, 1, 1], 0], [[0, 0, 0], 1], [[1, 1, 1], 1]].map((one) => of(...one)));
  return pixels.map((_, k) => [
    white[k].map((number, c) => (number - black[k][c]) / 0.96),
    metal[k].map((number, c) => number - rim[k][c]),
    rim[k],
  ]);
}
