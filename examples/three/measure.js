// In the page: what compare.js measures.

import * as THREE from "three";
import { Scene, lightPreset } from "eigenshade";
import { eigenMatcap } from "./matcap.js";
import { EigenMaterial } from "eigenshade/three";
import { LIGHTS, MATERIALS, METHODS, imaged, lightProbe, map, uniform } from "./methods.js";

const SIZE = 128;
const renderer = new THREE.WebGLRenderer();
const target = new THREE.WebGLRenderTarget(SIZE, SIZE, { type: THREE.FloatType });
const camera = new THREE.OrthographicCamera(-1.02, 1.02, 1.02, -1.02, 0.1, 10);
camera.position.z = 5;
const geometry = new THREE.SphereGeometry(1, 192, 96);

/** The linear pixels of a world. */
function pixels(world, camera) {
  renderer.setRenderTarget(target);
  renderer.setClearAlpha(0);
  renderer.render(world, camera);
  const numbers = new Float32Array(4 * SIZE * SIZE);
  renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, numbers);
  renderer.setRenderTarget(null);
  return numbers;
}

/** Pixels spread evenly over the sphere's picture, and their normals. */
export function normals() {
  const world = new THREE.Scene();
  world.add(new THREE.Mesh(geometry, new THREE.MeshNormalMaterial()));
  const numbers = pixels(world, camera);
  const inside = [];
  for (let k = 0; k < SIZE * SIZE; k++) if (numbers[4 * k + 3]) inside.push(k);
  return inside.filter((_, k) => k % 37 === 0).map((pixel) => {
    const normal = [0, 1, 2].map((axis) => 2 * numbers[4 * pixel + axis] - 1);
    const length = Math.hypot(...normal);
    return { pixel, normal: normal.map((number) => number / length) };
  });
}

/** The colors of these pixels by a method. */
export async function colors(method, light, material, at) {
  // three.js's matcap has a perspective frame in every camera: it is seen from far away.
  let eye = camera;
  if (method.includes("matcap")) {
    eye = new THREE.PerspectiveCamera(2 * THREE.MathUtils.radToDeg(Math.atan(1.02 / 500)), 1, 400, 600);
    eye.position.z = 500;
  }
  const made = await METHODS[method](geometry, light, material, renderer);
  const numbers = pixels(made, eye);
  return at.map(({ pixel }) => [...numbers.slice(4 * pixel, 4 * pixel + 3)]);
}

/** Worlds whose frames `frame` draws: a sphere that fills the picture, and a trivial shader. */
const worlds = [];
export async function prepareFrames() {
  const trivial = new THREE.Scene();
  trivial.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial()));
  worlds.push(trivial);
  for (const make of Object.values(METHODS)) worlds.push(await make(geometry, LIGHTS[0], MATERIALS[1], renderer));
  return ["trivial shader", ...Object.keys(METHODS)];
}

const frames = new THREE.WebGLRenderTarget(512, 512);
export function frame(which, count) {
  renderer.setRenderTarget(frames);
  for (let k = 0; k < count; k++) renderer.render(worlds[which], camera);
  renderer.readRenderTargetPixels(frames, 256, 256, 1, 1, new Uint8Array(4));
  renderer.setRenderTarget(null);
}

/**
 * Milliseconds of set-up on the CPU for a new light, and for one that only turned. Nothing is
 * compiled or uploaded; only a prefiltered map is made by the GPU.
 */
export async function setUp() {
  const equirects = await Promise.all(LIGHTS.slice(0, 2).map((name) => map(name)));
  const light = await lightPreset(LIGHTS[0]);
  const world = new THREE.Scene();
  // The browser's clock has steps of 0.1 ms.
  const least = (work, repeat = 200) => {
    let best = Infinity;
    for (let turn = 0; turn < 12; turn++) {
      const start = performance.now();
      for (let k = 0; k < repeat; k++) work(repeat * turn + k);
      best = Math.min(best, (performance.now() - start) / repeat);
    }
    return best;
  };
  const of = async (make, { tolerance, repeat, sources = 0 } = {}) => {
    const scene = await Scene.create({ light: LIGHTS[0], material: MATERIALS[1], sources });
    if (tolerance) scene.within(tolerance, 1 / scene.within(tolerance).truncation.peak);
    const [one, other] = await Promise.all(LIGHTS.slice(0, 2).map((light) => lightPreset(light, { sources })));
    const material = make(scene);
    const mesh = new THREE.Mesh(geometry, material);
    const rotation = material.lightRotation;
    const prepare = () => material.onBeforeRender(renderer, world, camera, geometry, mesh);
    return {
      light: least((k) => {
        scene.light(k % 2 ? one : other);
        material.update?.();
        prepare();
      }, repeat),
      turn: least((k) => {
        rotation.setFromEuler(new THREE.Euler(0, k + 1, 0));
        prepare();
      }, repeat),
    };
  };
  const eigen = (scene) => new EigenMaterial(scene, { exposure: 1 });
  const generator = new THREE.PMREMGenerator(renderer);
  // The first one compiles its shaders.
  const made = generator.fromEquirectangular(equirects[0]);
  const pixel = new Uint8Array(4);
  return {
    eigenshade: await of(eigen),
    "eigenshade, 4 sources": await of(eigen, { sources: 4 }),
    "eigenshade, 1 %": await of(eigen, { tolerance: 0.01 }),
    "eigenshade, images": await of((scene) => imaged(scene, MATERIALS[1]), { repeat: 10, sources: 4 }),
    "eigenshade, images, roughness map": await of((scene) => imaged(scene, MATERIALS[1], uniform()), { repeat: 10, sources: 4 }),
    "eigenshade, matcap of 128²": await of(eigenMatcap, { repeat: 10 }),
    probe: { light: least(() => lightProbe(light)), turn: 0 },
    pmrem: {
      light: Math.min(...[0, 1, 2].map((k) => {
        const start = performance.now();
        generator.fromEquirectangular(equirects[k % 2], made);
        const gl = renderer.getContext();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        return performance.now() - start;
      })),
      turn: 0,
    },
    texture: made.width * made.height * 8,
  };
}

export { LIGHTS, MATERIALS, METHODS };
