// Draws objects under a scene by WebGL 2: the sphere, meshes, normal maps, and views that compare.

import { Programs } from "../eigenshade/src/programs.js";
import { ENCODED, FILMIC } from "./color.js";
import { GLSL as NINE } from "./nine.js";
import { inverse, matrix } from "./turn.js";

/** @typedef {import("../eigenshade/src/index.js").Scene} Scene */

/** What a fragment shows. */
export const SHOWN = { picture: 0, nine: 1, difference: 2, moved: 3 };
/** Where a fragment's normal comes from. */
export const KINDS = { sphere: 0, mesh: 1, map: 2, bumps: 3 };
/** How differences are magnified. */
export const TIMES = 10;

/** The object's radius in a pane whose half side is 1. */
export const RADIUS = 0.94;

const VERTEX = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat3 pose;
uniform int kind;
out vec3 given;
out vec2 at;
flat out float side;
void main() {
  if (kind == ${KINDS.mesh} || kind == ${KINDS.map}) {
    vec3 place = pose * position;
    gl_Position = vec4(${RADIUS} * place.xy, -0.5 * place.z, 1.0);
    given = pose * normal;
    at = uv;
    side = sign(normal.z);
  } else {
    vec2 corner = 2.0 * vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
    given = vec3(0.0);
    at = corner / ${RADIUS};
    side = 1.0;
  }
}`;

/** @param {string} irradiance */
const fragment = (irradiance) => `#version 300 es
precision highp float;
precision highp int;
${irradiance}
${NINE}
uniform mat3 pose;
uniform int kind;
uniform int shown;
uniform float size;
uniform float exposure;
uniform float times;
uniform bool careful;
uniform sampler2D map;
uniform sampler2D exact;
in vec3 given;
in vec2 at;
flat in float side;
out vec4 color;

${ENCODED}
${FILMIC}
/** A normal that faces away moves to the rim. */
vec3 visible(vec3 n) {
  n = normalize(n);
  return n.z < 0.0 ? vec3(n.xy * inversesqrt(max(dot(n.xy, n.xy), 1e-12)), 0.0) : n;
}
vec3 onFace(vec3 n) {
  return pose * vec3(side * n.x, n.y, side * n.z);
}

void main() {
  float square = dot(at, at);
  float coverage = 1.0;
  vec3 normal, other = vec3(0.0, 0.0, 1.0);
  if (kind == ${KINDS.mesh}) {
    normal = visible(given);
  } else if (kind == ${KINDS.map}) {
    // On the whole face, so that derivatives and texels are defined.
    vec3 mapped = texture(map, at).xyz, fine = texture(exact, at).xyz;
    normal = at.x < -0.5 ? given : onFace(mapped);
    other = visible(at.x < -0.5 ? given : onFace(fine));
    if (careful) normal = visible(normal);
  } else {
    coverage = clamp(0.5 * size * ${RADIUS} * (1.0 - sqrt(square)) + 0.5, 0.0, 1.0);
    if (coverage <= 0.0) discard;
    normal = square < 1.0 ? vec3(at, sqrt(1.0 - square)) : vec3(at * inversesqrt(square), 0.0);
    if (kind == ${KINDS.bumps}) {
      // A knurl that tilts normals by up to 20 degrees, at the rim beyond it.
      normal += 0.26 * vec3(at * dot(sin(32.0 * at), vec2(1.0)), -1.0);
      normal = careful ? visible(normal) : normalize(normal);
    }
  }
  vec3 value = irradiance(normal);
  vec3 light;
  if (shown == ${SHOWN.picture}) light = filmic(exposure * value);
  if (shown == ${SHOWN.nine}) light = filmic(exposure * nineTerms(normal));
  if (shown == ${SHOWN.difference}) light = times * exposure * abs(value - nineTerms(normal));
  if (shown == ${SHOWN.moved}) light = times * exposure * abs(value - irradiance(other));
  color = coverage * vec4(encoded(light), 1.0);
}`;

/** Programs that are kept. */
const KEPT = 48;

/**
 * What a pane shows.
 *
 * @typedef {object} Pane
 * @property {Scene} scene
 * @property {number} [shown] of {@link SHOWN}
 * @property {boolean} [careful] whether normals are made unit and visible; true by default
 */

/**
 * @typedef {object} Look
 * @property {number} exposure
 * @property {number[]} pose the turn of the object
 * @property {{ terms: Float32Array, turn: number[] }} nine
 * @property {number} [times] how a difference is magnified
 */

/** A canvas with WebGL 2. */
export class Drawing {
  #gl;
  #programs;
  #kind = KINDS.sphere;
  #count = 0;
  /** @type {WebGLTexture[]} */
  #textures = [];
  #array = /** @type {WebGLVertexArrayObject | null} */ (null);
  /** @type {WebGLBuffer[]} */
  #buffers = [];
  /** The terms of the scene, where they are too many for uniforms. */
  #terms = /** @type {WebGLTexture | null} */ (null);

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {() => void} [restored] called after the context was lost and came back
   * @returns {Drawing | undefined} `undefined` without WebGL 2
   */
  static of(canvas, restored = () => {}) {
    const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    return gl ? new Drawing(canvas, gl, restored) : undefined;
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {WebGL2RenderingContext} gl
   * @param {() => void} restored
   */
  constructor(canvas, gl, restored) {
    this.canvas = canvas;
    this.#gl = gl;
    this.#programs = new Programs(gl, VERTEX, fragment, KEPT);
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.#programs.clear();
      this.#textures = [];
      this.#buffers = [];
      this.#array = this.#terms = null;
    });
    canvas.addEventListener("webglcontextrestored", restored);
  }

  /**
   * Sets the object.
   *
   * @param {number} kind of {@link KINDS}
   * @param {import("./objects.js").Mesh} [mesh]
   * @param {boolean} [closed] whether its triangles are counterclockwise from outside
   */
  object(kind, mesh, closed = true) {
    const gl = this.#gl;
    // Triangles of a closed mesh that face away are hidden; those of a file may face anywhere.
    if (mesh && closed) gl.enable(gl.CULL_FACE);
    else gl.disable(gl.CULL_FACE);
    this.#kind = kind;
    this.#count = mesh ? mesh.indices.length : 0;
    if (this.#array) gl.deleteVertexArray(this.#array);
    this.#buffers.forEach((buffer) => gl.deleteBuffer(buffer));
    this.#array = gl.createVertexArray();
    gl.bindVertexArray(this.#array);
    if (!mesh) return;
    this.#buffers = [0, 1, 2, 3].map(() => gl.createBuffer());
    [mesh.positions, mesh.normals, mesh.uvs].forEach((numbers, place) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers[place]);
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, place === 2 ? 2 : 3, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#buffers[3]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices, gl.STATIC_DRAW);
  }

  /**
   * The normal map, and the exact one that it is compared with.
   *
   * @param {number} size
   * @param {Float32Array} map four numbers a texel
   */
  map(size, map, exact = map) {
    const gl = this.#gl;
    this.#textures.forEach((texture) => gl.deleteTexture(texture));
    this.#textures = [map, exact].map((numbers, unit) => {
      const texture = gl.createTexture();
      gl.activeTexture(gl.TEXTURE1 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA16F, size, size, 0, gl.RGBA, gl.FLOAT, numbers);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.LINEAR);
      for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
      return texture;
    });
  }

  /**
   * Draws one pane, or four in two rows.
   *
   * @param {Pane[]} panes
   * @param {Look} look
   * @param {number} size pixels of the canvas's side
   * @returns {boolean} whether it could
   */
  draw(panes, look, size) {
    const gl = this.#gl;
    if (this.canvas.width !== size || this.canvas.height !== size) this.canvas.width = this.canvas.height = size;
    gl.viewport(0, 0, size, size);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const side = panes.length > 1 ? 2 : 1;
    const each = size / side;
    panes.forEach((pane, k) => {
      const [column, row] = [k % side, Math.floor(k / side)];
      gl.viewport(column * each, size - (row + 1) * each, each, each);
      this.#pane(pane, look, each);
    });
    return !gl.isContextLost();
  }

  /** Whether a scene of as many uniforms fits beside the nine vectors, the matrices and the rest. */
  #fits(/** @type {Scene} */ scene) {
    const vectors = scene.terms + (scene.sources && 1 + 4 * scene.sources);
    return vectors + 32 <= this.#gl.getParameter(this.#gl.MAX_FRAGMENT_UNIFORM_VECTORS);
  }

  /** Whether a scene's program is compiled: another may take longer than a frame. */
  has(/** @type {Scene} */ scene) {
    return this.#programs.has(scene.glsl(this.#fits(scene) ? "uniforms" : "texture"));
  }

  /** @param {Pane} pane @param {Look} look @param {number} size */
  #pane({ scene, shown = SHOWN.picture, careful = true }, { exposure, pose, nine, times = TIMES }, size) {
    const gl = this.#gl;
    const uniforms = scene.uniforms();
    const fits = this.#fits(scene);
    const program = this.#programs.of(scene.glsl(fits ? "uniforms" : "texture"));
    if (!program) return;
    const place = (/** @type {string} */ name) => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    if (fits) {
      gl.uniform4fv(place("eigenshade"), uniforms);
    } else {
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, (this.#terms ??= gl.createTexture()));
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, uniforms.length / 4, 1, 0, gl.RGBA, gl.FLOAT, uniforms);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
      gl.uniform1i(place("eigenshade"), 0);
    }
    const rows = new Float32Array(27);
    for (let k = 0; k < 27; k++) rows[3 * (k % 9) + Math.floor(k / 9)] = nine.terms[k];
    gl.uniform3fv(place("nine"), rows);
    gl.uniformMatrix3fv(place("nineBack"), false, matrix(inverse(nine.turn)));
    gl.uniformMatrix3fv(place("pose"), false, matrix(pose));
    gl.uniform1i(place("kind"), this.#kind);
    gl.uniform1i(place("shown"), shown);
    gl.uniform1i(place("careful"), Number(careful));
    gl.uniform1f(place("size"), size);
    gl.uniform1f(place("exposure"), exposure);
    gl.uniform1f(place("times"), times);
    gl.uniform1i(place("map"), 1);
    gl.uniform1i(place("exact"), 2);
    gl.bindVertexArray(this.#array);
    if (this.#count) gl.drawElements(gl.TRIANGLES, this.#count, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Gives the context back: a page has only a few. */
  free() {
    this.#gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
