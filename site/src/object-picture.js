// Pictures of the packed object on a canvas, from palettes: by WebGL 2, or else on the CPU.

import { ENCODED, FILMIC, encoded } from "./color.js";
import { NODES, SIDE, lookUp } from "./packed.js";

/** The object's share of the canvas's height. */
const FILLED = 0.94;

const VERTEX = `#version 300 es
void main() { gl_Position = vec4(2.0 * vec2(gl_VertexID << 1 & 2, gl_VertexID & 2) - 1.0, 0, 1); }`;

/** A pixel of the screen is the mean of four of the object's, weighted by distance. */
const FRAGMENT = `#version 300 es
precision highp float; precision highp int; precision highp usampler2D; precision highp sampler2DArray;
uniform usampler2D object;
uniform sampler2D colors;
uniform sampler2DArray palettes;
uniform float size;
out vec4 color;

${ENCODED}
${FILMIC}

vec4 texel(ivec2 at) {
  if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, textureSize(object, 0)))) return vec4(0);
  uvec4 packed = texelFetch(object, at, 0);
  uint region = packed.a & 3u;
  vec2 node = (vec2(packed.xy) / 8.0 + 0.5) / ${SIDE}.0;
  vec3 black = texture(palettes, vec3(node, 2u * region)).rgb;
  vec3 white = texture(palettes, vec3(node, 2u * region + 1u)).rgb;
  vec3 light = mix(black, white, texelFetch(colors, ivec2(packed.b, 0), 0).rgb);
  return float(packed.a >> 2) / 63.0 * vec4(encoded(filmic(light)), 1.0);
}

void main() {
  vec2 shape = vec2(textureSize(object, 0));
  vec2 at = vec2(gl_FragCoord.x, size - gl_FragCoord.y) - 0.5 * size;
  at = at * shape.y / (${FILLED} * size) + 0.5 * shape - 0.5;
  ivec2 first = ivec2(floor(at));
  vec2 way = at - vec2(first);
  vec4 above = mix(texel(first), texel(first + ivec2(1, 0)), way.x);
  vec4 below = mix(texel(first + ivec2(0, 1)), texel(first + ivec2(1, 1)), way.x);
  color = mix(above, below, way.y);
}`;

/** @typedef {import("./packed.js").Packed} Packed */

/**
 * Makes the function that draws an object on a canvas from palettes.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {Packed} object
 * @param {(text: string) => void} say what is wrong, or nothing
 * @returns {(palettes: Float32Array) => void}
 */
export function drawer(canvas, object, say) {
  const gl = isSupported() && canvas.getContext("webgl2", { antialias: false, depth: false, preserveDrawingBuffer: true });
  if (!gl) return onCpu(canvas, object);
  let ready = prepared(gl, object);
  let last = object.palettes;
  const draw = (/** @type {Float32Array} */ palettes) => {
    last = palettes;
    if (gl.isContextLost()) return;
    const size = Math.round(Math.min(1400, Math.max(object.height / FILLED, canvas.clientWidth * devicePixelRatio)));
    if (canvas.width !== size) canvas.width = canvas.height = size;
    gl.viewport(0, 0, size, size);
    gl.activeTexture(gl.TEXTURE2);
    gl.texImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.RGBA16F, SIDE, SIDE, palettes.length / (4 * NODES), 0, gl.RGBA, gl.FLOAT, palettes);
    gl.uniform1f(ready, size);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    say("The graphics driver took the picture away. If it does not come back, reload the page.");
  });
  canvas.addEventListener("webglcontextrestored", () => {
    say("");
    ready = prepared(gl, object);
    draw(last);
  });
  return draw;
}

/** Whether WebGL 2 links the program. A canvas whose context is of WebGL can have no other one. */
function isSupported() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return false;
  const isLinked = gl.getProgramParameter(linked(gl), gl.LINK_STATUS);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return isLinked;
}

function linked(/** @type {WebGL2RenderingContext} */ gl) {
  const program = /** @type {WebGLProgram} */ (gl.createProgram());
  for (const [kind, text] of /** @type {[GLenum, string][]} */ ([[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]])) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  return program;
}

/** Uploads the object, and gives the place of the canvas's size. */
function prepared(/** @type {WebGL2RenderingContext} */ gl, /** @type {Packed} */ { width, height, texels, colors }) {
  const program = linked(gl);
  gl.useProgram(program);
  const textures = /** @type {const} */ ([["object", gl.TEXTURE_2D, gl.NEAREST], ["colors", gl.TEXTURE_2D, gl.NEAREST], ["palettes", gl.TEXTURE_2D_ARRAY, gl.LINEAR]]);
  textures.forEach(([name, kind, filter], unit) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(kind, gl.createTexture());
    for (const which of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(kind, which, filter);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(kind, wrap, gl.CLAMP_TO_EDGE);
    gl.uniform1i(gl.getUniformLocation(program, name), unit);
    if (name === "object") gl.texImage2D(kind, 0, gl.RGBA8UI, width, height, 0, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE, texels);
    if (name === "colors") gl.texImage2D(kind, 0, gl.RGBA32F, colors.length / 4, 1, 0, gl.RGBA, gl.FLOAT, colors);
  });
  return gl.getUniformLocation(program, "size");
}

/** As {@link drawer}, in the object's own pixels. */
function onCpu(/** @type {HTMLCanvasElement} */ canvas, /** @type {Packed} */ object) {
  const { width, height, texels } = object;
  const side = Math.round(height / FILLED);
  canvas.width = canvas.height = side;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const picture = new ImageData(width, height);
  const light = [0, 0, 0];
  return (/** @type {Float32Array} */ palettes) => {
    for (let k = 0; k < width * height; k++) {
      const coverage = texels[4 * k + 3] >> 2;
      if (!coverage) continue;
      lookUp(object, palettes, k, light);
      for (let c = 0; c < 3; c++) picture.data[4 * k + c] = encoded(light[c]);
      picture.data[4 * k + 3] = (255 * coverage) / 63;
    }
    context.putImageData(picture, (side - width) >> 1, (side - height) >> 1);
  };
}
