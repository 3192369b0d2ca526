// A glTF file in the page's light, by three.js, which is loaded with this script.

import { metered } from "../eigenshade/src/exposure.js";
import { Scene } from "../eigenshade/src/index.js";
import { EigenMaterial } from "../eigenshade/src/three.js";
import * as THREE from "../vendor/three.js";
import { RADIUS } from "./draw.js";
import { FILMIC } from "./color.js";
import { checkGltf } from "./gltf.js";
import { MOST } from "./objects.js";

/** The curve of the page. */
THREE.ShaderChunk.tonemapping_pars_fragment = THREE.ShaderChunk.tonemapping_pars_fragment.replace(
  "vec3 CustomToneMapping( vec3 color ) { return color; }",
  `${FILMIC}
  vec3 CustomToneMapping(vec3 color) { return filmic(color); }`,
);

/** Pixels on a side of the picture that is metered. */
const METERED = 96;

/** @type {THREE.WebGLRenderer | undefined} */
let renderer;

/**
 * The renderer, whose canvas lies over that of the page.
 *
 * @param {HTMLCanvasElement} below
 * @param {() => void} restored called after its context was lost and came back
 */
function rendered(below, restored) {
  if (renderer) return renderer;
  renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.toneMapping = THREE.CustomToneMapping;
  renderer.domElement.id = "own-picture";
  renderer.domElement.setAttribute("aria-hidden", "true");
  renderer.domElement.addEventListener("webglcontextrestored", restored);
  below.after(renderer.domElement);
  return renderer;
}

/** An object of a file, in a circle as large as those of the page's own. */
export class Model {
  #object;
  #scene;
  #materials;
  #light = /** @type {unknown} */ (undefined);
  /** That of the light as it was set, on the object in the pose of the file. */
  #exposure = 1;
  #world = new THREE.Scene();
  #camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 4);
  #turn = new THREE.Quaternion();

  /**
   * @param {ArrayBuffer} bytes
   * @returns {Promise<Model>}
   * @throws {Error} if the file cannot be drawn
   */
  static async read(bytes) {
    const leftOut = checkGltf(bytes);
    const { scene: object } = await new THREE.GLTFLoader().parseAsync(bytes, "");
    const { center, radius, triangles } = sizeOf(object);
    object.position.sub(center);
    const posed = new THREE.Group().add(object);
    posed.scale.setScalar(RADIUS / radius);
    const scene = await Scene.create({ light: "studio", material: {}, sources: "auto", window: "auto" });
    return new Model(posed, scene, triangles, leftOut);
  }

  /**
   * @param {THREE.Group} object
   * @param {Scene} scene
   * @param {number} triangles
   * @param {string[]} leftOut extensions
   */
  constructor(object, scene, triangles, leftOut) {
    this.#object = object;
    this.#scene = scene;
    this.#materials = EigenMaterial.convert(object, scene, { lightRotation: this.#turn });
    this.#world.add(object);
    this.#camera.position.z = 2;
    this.triangles = triangles;
    this.leftOut = leftOut;
  }

  /**
   * Draws over a canvas.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {{ light: any, turn: number[], pose: number[], exposure: number }} look the exposure is a
   *   factor of the automatic one
   * @param {() => void} restored called if it has to be drawn again
   */
  draw(canvas, { light, turn, pose, exposure }, restored) {
    const drawer = rendered(canvas, restored);
    if (light !== this.#light) {
      this.#scene.light(light);
      this.#light = light;
      this.#exposure = this.#metered(drawer);
    }
    this.#turn.fromArray(turn);
    this.#object.quaternion.fromArray(pose);
    for (const material of this.#materials) material.exposure = exposure * this.#exposure;
    drawer.domElement.hidden = false;
    drawer.setSize(canvas.width, canvas.height, false);
    drawer.render(this.#world, this.#camera);
  }

  /** The exposure of a small picture, or that of a sphere if floats cannot be drawn. */
  #metered(/** @type {THREE.WebGLRenderer} */ drawer) {
    this.#turn.identity();
    this.#object.quaternion.identity();
    for (const material of this.#materials) material.exposure = 1;
    const target = new THREE.WebGLRenderTarget(METERED, METERED, { type: THREE.FloatType });
    const pixels = new Float32Array(4 * METERED ** 2);
    drawer.setRenderTarget(target);
    drawer.render(this.#world, this.#camera);
    drawer.readRenderTargetPixels(target, 0, 0, METERED, METERED, pixels);
    drawer.setRenderTarget(null);
    target.dispose();
    const covered = [...Array(METERED ** 2).keys()].filter((k) => pixels[4 * k + 3] > 0);
    if (!covered.length) return this.#scene.exposure();
    const [r, g, b] = [0, 1, 2].map((channel) => Float32Array.from(covered, (k) => pixels[4 * k + channel]));
    return metered({ r, g, b });
  }

  /** Shows the page's own picture again. */
  hide() {
    if (renderer) renderer.domElement.hidden = true;
  }

  /** Frees what the renderer keeps of it. */
  free() {
    this.hide();
    this.#object.traverse((/** @type {any} */ { geometry, material }) => {
      geometry?.dispose();
      for (const one of [material ?? []].flat()) {
        for (const value of Object.values(one)) if (value?.isTexture) value.dispose();
        one.dispose();
      }
    });
  }
}

/** Center, radius and number of triangles of an object, in rest. */
function sizeOf(/** @type {THREE.Object3D} */ object) {
  const center = new THREE.Box3().setFromObject(object, true).getCenter(new THREE.Vector3());
  const point = new THREE.Vector3();
  let [square, triangles] = [0, 0];
  object.traverse((/** @type {any} */ mesh) => {
    if (!mesh.isMesh) return;
    const { index, attributes: { position } } = mesh.geometry;
    triangles += ((index ?? position).count / 3) * (mesh.count ?? 1);
    if (triangles > MOST) throw new Error(`it has more than ${MOST} triangles`);
    for (let k = 0; k < position.count; k++) {
      mesh.getVertexPosition(k, point).applyMatrix4(mesh.matrixWorld);
      square = Math.max(square, point.distanceToSquared(center));
    }
  });
  if (!triangles) throw new Error("it has no mesh");
  if (!(square > 0 && square < Infinity)) throw new Error("its mesh has no size");
  return { center, radius: Math.sqrt(square), triangles };
}
