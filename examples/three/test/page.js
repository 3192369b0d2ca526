// In the page: draws meshes, and compares their pixels with the package's module.

import * as THREE from "three";
import { Scene } from "eigenshade";
import { EigenMaterial } from "eigenshade/three";

const SIZE = 160;
const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
renderer.setSize(SIZE, SIZE, false);
const target = new THREE.WebGLRenderTarget(SIZE, SIZE, { type: THREE.FloatType });

export const perspective = (position, fov = 40) => placed(new THREE.PerspectiveCamera(fov, 1, 0.1, 50), position);
export const orthographic = (position) => placed(new THREE.OrthographicCamera(-1.2, 1.2, 1.2, -1.2, 0.1, 50), position);

function placed(camera, position) {
  camera.position.set(...position);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

/** Draws a mesh in 8 bits, sRGB. */
export function picture(mesh, camera) {
  const world = new THREE.Scene();
  world.add(mesh);
  renderer.setRenderTarget(null);
  renderer.render(world, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * SIZE * SIZE);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  if (gl.getError()) throw new Error("WebGL found an error");
  return pixels;
}

/** The normals in the camera's frame of a mesh's pixels, as three.js's own material has them. */
export function normals(mesh, camera) {
  const { material } = mesh;
  const { normalMap, normalScale, flatShading, side } = material;
  mesh.material = new THREE.MeshNormalMaterial({ normalMap, flatShading, side });
  mesh.material.normalScale.copy(normalScale);
  const world = new THREE.Scene();
  world.add(mesh);
  renderer.setRenderTarget(target);
  renderer.setClearAlpha(0);
  renderer.clear();
  renderer.render(world, camera);
  renderer.setRenderTarget(null);
  const pixels = new Float32Array(4 * SIZE * SIZE);
  renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, pixels);
  mesh.material = material;
  const [at, axes] = [[], [[], [], []]];
  for (let k = 0; k < SIZE * SIZE; k++) {
    if (pixels[4 * k + 3] === 0) continue;
    at.push(k);
    const normal = [0, 1, 2].map((axis) => 2 * pixels[4 * k + axis] - 1);
    const length = Math.hypot(...normal);
    normal.forEach((number, axis) => axes[axis].push(number / length));
  }
  return { at, axes };
}

const encoded = (x) => {
  const clamped = Math.min(1, Math.max(0, x));
  return 255 * (clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * clamped ** (1 / 2.4) - 0.055);
};

/**
 * The largest difference, in codes, of a mesh's pixels from the module's irradiance of its normals,
 * which `frame` (a quaternion) and, in perspective, half the rotation from the pixel's direction to
 * z turn first. The module's scene is turned already.
 */
export function difference(mesh, camera, scene, frame = new THREE.Quaternion()) {
  const { at, axes } = normals(mesh, camera);
  const halfway = camera.isPerspectiveCamera ? at.map((pixel) => {
    const view = new THREE.Vector3((2 * (pixel % SIZE) + 1) / SIZE - 1, (2 * Math.floor(pixel / SIZE) + 1) / SIZE - 1, 0.5);
    view.applyMatrix4(camera.projectionMatrixInverse).normalize().negate().applyQuaternion(frame);
    return new THREE.Quaternion().setFromUnitVectors(view, view.clone().setZ(view.z + 1).normalize());
  }) : [];
  const pixels = picture(mesh, camera);
  const turned = axes.map(() => new Float32Array(at.length));
  const normal = new THREE.Vector3();
  for (let k = 0; k < at.length; k++) {
    normal.set(axes[0][k], axes[1][k], axes[2][k]).applyQuaternion(frame);
    if (halfway[k]) normal.applyQuaternion(halfway[k]);
    if (normal.z < 0) normal.setZ(0).normalize();
    normal.toArray().forEach((number, axis) => (turned[axis][k] = number));
  }
  const colors = scene.shade(...turned);
  let [most, sum, lit] = [0, 0, 0];
  at.forEach((pixel, k) => {
    [colors.r, colors.g, colors.b].forEach((color, channel) => {
      const code = encoded((mesh.material.exposure ? scene.exposure() : mesh.material.color.r) * color[k]);
      most = Math.max(most, Math.abs(code - pixels[4 * pixel + channel]));
      sum += (code - pixels[4 * pixel + channel]) ** 2;
      lit = Math.max(lit, pixels[4 * pixel + channel]);
    });
  });
  return { most, rms: Math.sqrt(sum / (3 * at.length)), lit, count: at.length };
}

export const programs = () => renderer.info.programs.length;
export { THREE, Scene, EigenMaterial, renderer };
