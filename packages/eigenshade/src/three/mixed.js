// What a glTF material reflects, mixed for each pixel from images of its parts; and small sources.

import { Quaternion, Vector3 } from "three";
import { SOURCE } from "../input.js";
import { MARGIN } from "../images.js";
import { illumination } from "../scene.js";
import { weights } from "./image-texture.js";

/** The least roughness of a highlight, and the least cosine between the view and its middle. */
const [SMOOTHEST, LEAST_COSINE] = [0.065, 1 / 32];

/** The function for a shader, and what it reads. */
export class MixedReflection {
  #scene;
  #frame;
  #material;
  /** @type {import("./image-texture.js").ImageTexture | undefined} */
  #images;
  #uniforms = {
    eigenImages: { value: /** @type {import("three").DataArrayTexture | null} */ (null) },
    eigenWeights: { value: /** @type {import("three").DataTexture | null} */ (null) },
    eigenSources: { value: new Float32Array() },
  };

  /**
   * @param {import("../scene.js").Scene} scene
   * @param {import("./frame.js").Frame} frame
   * @param {import("three").MeshStandardMaterial} material whose roughness it has
   */
  constructor(scene, frame, material) {
    this.#scene = scene;
    this.#frame = frame;
    this.#material = material;
  }

  /** What it is about, as {@link textOf} has it. */
  get text() {
    const count = illumination(this.#scene).sources.length / SOURCE;
    return textOf(this.#images?.isBlended ?? Boolean(this.#material.roughnessMap), count);
  }

  get uniforms() {
    return this.#uniforms;
  }

  /** The exposure of what the text computes. */
  get exposed() {
    return this.#images?.exposure ?? 1;
  }

  /** Uploads what changed. */
  update() {
    const frame = this.#frame;
    const now = illumination(this.#scene);
    const { roughness, roughnessMap } = this.#material;
    this.#images = frame.images(roughnessMap ? undefined : Math.min(1, Math.max(0, roughness)));
    this.#images.update(now, frame.turn, this.#scene.exposure());
    this.#uniforms.eigenImages.value = this.#images.texture;
    if (this.#images.isBlended) this.#uniforms.eigenWeights.value = weights();
    this.#uniforms.eigenSources.value = turned(now.sources, frame.turn, this.exposed);
  }

  dispose() {
    this.#frame.dispose();
  }
}

const direction = new Vector3();

/**
 * Sources as three vectors each: the direction and the variance of the spread; the direction of the
 * plane of source and view, the cosine of half the angle between them, and the variance across the
 * plane; the energy and Fresnel's factor.
 *
 * @param {Float32Array} sources
 * @param {Quaternion} turn
 * @param {number} exposure
 */
function turned(sources, turn, exposure) {
  const vectors = new Float32Array((12 * sources.length) / SOURCE);
  for (let k = 0; k < sources.length / SOURCE; k++) {
    const [x, y, z, r, g, b, spread] = sources.subarray(SOURCE * k, SOURCE * (k + 1));
    direction.set(x, y, z).applyQuaternion(turn);
    const across = Math.hypot(direction.x, direction.y);
    const plane = across > 1e-15 ? [direction.x / across, direction.y / across] : [1, 0];
    const cosine = Math.max(LEAST_COSINE, Math.sqrt(Math.max(0, 0.5 + 0.5 * direction.z)));
    const wide = spread ** 2;
    vectors.set([...direction.toArray(), wide, ...plane, cosine, wide / cosine ** 2], 12 * k);
    vectors.set([...[r, g, b].map((energy) => exposure * energy), (1 - cosine) ** 5], 12 * k + 8);
  }
  return vectors;
}

/** @type {Map<string, string>} */
const texts = new Map();

/**
 * The text for images of one roughness, or of five that are blended.
 *
 * @param {boolean} isBlended
 * @param {number} sources
 */
function textOf(isBlended, sources) {
  const key = `${isBlended} ${sources}`;
  const text = texts.get(key) ?? written(isBlended, sources);
  texts.set(key, text);
  return text;
}

/**
 * As {@link textOf}.
 *
 * @param {boolean} isBlended
 * @param {number} sources
 */
function written(isBlended, sources) {
  const lobe = (/** @type {number} */ k) =>
    `(f0 * eigenImage(at, ${2 * k + 1}.0) + eigenImage(at, ${2 * k + 2}.0))`;
  const blended = `vec2 row = vec2((clamp(roughness, 0.2, 1.0) - 0.2) * 40.0 + 0.5, 0.25);
  row.x /= float(textureSize(eigenWeights, 0).x);
  vec4 weight = texture(eigenWeights, row);
  light += weight.x * ${lobe(0)} + weight.y * ${lobe(1)};
  light += weight.z * ${lobe(2)} + weight.w * ${lobe(3)};
  light += texture(eigenWeights, vec2(row.x, 0.75)).x * ${lobe(4)};`;
  // As `Highlights` of the runtime, which has the derivation.
  const highlights = `float squareAlpha = pow(max(roughness, ${SMOOTHEST}), 4.0);
  for (int k = 0; k < ${3 * sources}; k += 3) {
    vec4 a = eigenSources[k], b = eigenSources[k + 1], c = eigenSources[k + 2];
    float lit = dot(a.xyz, normal);
    if (lit <= 1e-12) continue;
    float sine = sqrt(1.0 - b.z * b.z);
    float blur = 0.25 * (2.0 + squareAlpha / (squareAlpha + 0.125 * (a.w + b.w)));
    vec2 widths = vec2(squareAlpha + blur * a.w, min(squareAlpha + blur * b.w, 1.0));
    float halfway = dot(vec3(sine * b.xy, b.z), normal);
    vec2 tangents = vec2(dot(vec3(b.z * b.xy, -sine), normal), dot(vec2(-b.y, b.x), normal.xy));
    float form = halfway * halfway + dot(tangents * tangents, 1.0 / widths);
    vec2 roots = sqrt(mix(vec2(normal.z * normal.z, lit * lit), vec2(1.0), squareAlpha));
    float masked = dot(vec2(lit, normal.z), roots);
    float faded = sqrt(widths.x * widths.y) * (1.0 + 0.5 * b.w * b.w);
    vec3 fresnel = mix(f0, vec3(1.0), c.w);
    vec3 specular = fresnel / (2.0 * faded * form * form * masked);
    light += c.rgb * (lit * RECIPROCAL_PI) * (specular + (1.0 - fresnel) * matte);
  }`;
  return `uniform sampler2DArray eigenImages;
${isBlended ? "uniform sampler2D eigenWeights;" : ""}
${sources ? `uniform vec4 eigenSources[${3 * sources}];` : ""}
vec3 eigenImage(vec2 at, float layer) {
  return texture(eigenImages, vec3(at, layer)).rgb;
}
vec3 eigenReflected(vec3 normal, vec3 base, float metallic, float roughness, float occlusion) {
  vec3 f0 = mix(vec3(0.04), base, metallic);
  vec3 matte = occlusion * (1.0 - metallic) * base;
  float radius = 0.5 - ${MARGIN} / float(textureSize(eigenImages, 0).x);
  vec2 at = 0.5 + radius * inversesqrt(1.0 + normal.z) * normal.xy;
  vec3 light = matte * (1.0 - f0) * eigenImage(at, 0.0);
  ${isBlended ? blended : `light += ${lobe(0)};`}
  ${sources ? highlights : ""}
  return light;
}`;
}
