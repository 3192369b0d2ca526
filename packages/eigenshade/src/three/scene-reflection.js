// What the material of a scene reflects, by the scene's polynomials.

import { DataTexture, FloatType, Quaternion, RGBAFormat } from "three";
import { illumination } from "../scene.js";

/** @typedef {import("../scene.js").Scene} Scene */

/** Uniform vectors that are left for a scene: WebGL 2 promises 224 in all. */
const MOST = 200;

const PREFIX = "eigen_";

/** The scene's function for a shader, and the array that it reads. */
export class SceneReflection {
  #scene;
  #frame;
  #stored = { value: /** @type {Float32Array | DataTexture | undefined} */ (undefined) };
  #text = "";
  /** @type {unknown} What the scene is, but for its turn. */
  #illumination;
  #turn = new Quaternion();

  /**
   * @param {Scene} scene
   * @param {import("./frame.js").Frame} frame
   */
  constructor(scene, frame) {
    this.#scene = scene;
    this.#frame = frame;
    this.uniforms = { [`${PREFIX}eigenshade`]: this.#stored };
  }

  get text() {
    return (this.#text ||= this.#written());
  }

  /** The exposure of what the text computes. */
  get exposed() {
    return 1;
  }

  /** Uploads the scene if it is another one. */
  update() {
    const { turn } = this.#frame;
    const now = illumination(this.#scene);
    const isChanged = now !== this.#illumination;
    if (!isChanged && turn.equals(this.#turn)) return;
    this.#illumination = now;
    this.#scene.turn(this.#turn.copy(turn).toArray());
    this.#stored.value = stored(this.#scene, this.#stored.value);
    // With a tolerance the terms depend on the light and its turn.
    if (isChanged || this.#scene.truncation) this.#text = this.#written();
  }

  #written() {
    this.#stored.value ??= stored(this.#scene);
    const storage = this.#stored.value instanceof DataTexture ? "texture" : "uniforms";
    return `${this.#scene.glsl(storage, { prefix: PREFIX })}
vec3 eigenReflected(vec3 normal, vec3 base, float metallic, float roughness, float occlusion) {
  return base * ${PREFIX}irradiance(normal);
}`;
  }

  dispose() {
    const { value } = this.#stored;
    if (value instanceof DataTexture) value.dispose();
  }
}

/**
 * The array of a scene as a uniform, or where it is too long as a texture, the one before if it fits.
 *
 * @param {Scene} scene
 * @param {Float32Array | DataTexture} [before]
 */
function stored(scene, before) {
  const vectors = scene.uniforms();
  const width = vectors.length / 4;
  const texture = before instanceof DataTexture ? before : undefined;
  if (width > MOST && texture?.image.width === width) {
    texture.image.data = vectors;
    texture.needsUpdate = true;
    return texture;
  }
  texture?.dispose();
  if (width <= MOST) return vectors;
  const made = new DataTexture(vectors, width, 1, RGBAFormat, FloatType);
  made.needsUpdate = true;
  return made;
}
