// Draws spheres by a shader in one WebGL 2 context that all previews of a page share, where that is
// faster than the CPU.

import { TONES } from "./input.js";
import { Programs } from "./programs.js";
import { sphere } from "./sphere.js";

/** @typedef {import("./scene.js").Scene} Scene */
/** @typedef {import("./input.js").Tone} Tone */

/** A quad that covers the picture, as one triangle. */
const VERTEX = `#version 300 es
void main(){gl_Position=vec4(2.*vec2(gl_VertexID<<1&2,gl_VertexID&2)-1.,0,1);}`;

/**
 * The fragment shader of a sphere around a scene's function. Its outline is half a pixel from the
 * border, and pixels that the outline crosses show the rim. `code` applies the tone curve and sRGB;
 * it bounds its input, whose square f32 has to hold. Minifiers leave the text as it is, so it is
 * short.
 *
 * @param {string} irradiance
 */
const fragment = (irradiance) => `#version 300 es
precision highp float;precision highp int;
${irradiance}
uniform float size,exposure;uniform int tone;out vec4 color;
float code(float x){x=clamp(x,0.,1e15);
if(tone==1)x*=(1.+x/256.)/(1.+x);
if(tone==2)x*=(2.51*x+.03)/(x*(2.43*x+.59)+.14);
x=min(x,1.);return x<=.0031308?12.92*x:1.055*pow(x,1./2.4)-.055;}
void main(){float r=.5*max(size-1.,1.);vec2 a=(gl_FragCoord.xy-.5*size)/r;float q=dot(a,a);
vec3 e=exposure*irradiance(vec3(a/max(1.,sqrt(q)),sqrt(max(0.,1.-q))));
color=clamp(r*(1.-sqrt(q))+.5,0.,1.)*vec4(code(e.r),code(e.g),code(e.b),1);}`;

/** Programs that are kept; scenes of other shapes are compiled anew. */
const KEPT = 16;

/** Pixels across of the picture whose time says which way is faster. */
const SAMPLE = 128;

/** Milliseconds in which hardware draws it, whatever the CPU takes. */
const FAST = 4;

/** Milliseconds that something takes, the least of up to three times: the first one warms up. */
function time(/** @type {() => void} */ what) {
  let least = Infinity;
  for (let k = 0; k < 3 && least > FAST; k++) {
    const start = performance.now();
    what();
    least = Math.min(least, performance.now() - start);
  }
  return least;
}

/** The shared context. */
class Shared {
  #canvas;
  #gl;
  /** @type {boolean | undefined} Whether the CPU is faster; unknown before a picture was timed. */
  #isSlow;
  /** The array of a scene: a block, which takes larger tables than uniforms do. */
  #array;
  #programs;
  /** What to draw again after the context was lost. */
  restored = new EventTarget();

  /**
   * @param {OffscreenCanvas} canvas
   * @param {WebGL2RenderingContext} gl
   */
  constructor(canvas, gl) {
    this.#canvas = canvas;
    this.#gl = gl;
    this.#array = gl.createBuffer();
    this.#programs = new Programs(gl, VERTEX, fragment, KEPT);
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.#programs.clear();
    });
    canvas.addEventListener("webglcontextrestored", () => {
      this.#array = gl.createBuffer();
      this.restored.dispatchEvent(new Event("restored"));
    });
  }

  /** Whether nothing can be drawn now. */
  get lost() {
    return this.#gl.isContextLost();
  }

  /** The context, for tests of its loss. */
  get context() {
    return this.#gl;
  }

  /**
   * Draws a sphere.
   *
   * @param {Scene} scene
   * @param {number} size
   * @param {{ exposure: number, tone: Tone }} look
   * @returns {OffscreenCanvas | undefined} `undefined` if the context is lost, the scene has more
   *   terms than a uniform block holds, or the CPU is faster, as it is where WebGL is software
   */
  draw(scene, size, look) {
    this.#isSlow ??= this.#isSlower(scene, look);
    return this.#isSlow ? undefined : this.#draw(scene, size, look);
  }

  /**
   * Whether the CPU draws a picture faster; `undefined` if WebGL does not draw it now.
   *
   * @param {Scene} scene
   * @param {{ exposure: number, tone: Tone }} look
   */
  #isSlower(scene, look) {
    const gl = this.#gl;
    // Compiles the program, whose time does not count.
    if (!this.#draw(scene, SAMPLE, look)) return undefined;
    const shader = time(() => {
      this.#draw(scene, SAMPLE, look);
      // Waits until it is drawn.
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    });
    return shader > FAST && time(() => sphere(scene, SAMPLE, look)) < shader;
  }

  /**
   * @param {Scene} scene
   * @param {number} size
   * @param {{ exposure: number, tone: Tone }} look
   */
  #draw(scene, size, { exposure, tone }) {
    const gl = this.#gl;
    const array = scene.uniforms();
    if (array.byteLength > gl.getParameter(gl.MAX_UNIFORM_BLOCK_SIZE)) return undefined;
    const program = this.#programs.of(scene.glsl("block"));
    if (!program || this.lost) return undefined;
    if (this.#canvas.width !== size) this.#canvas.width = this.#canvas.height = size;
    gl.viewport(0, 0, size, size);
    const place = (/** @type {string} */ name) => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.#array);
    gl.bufferData(gl.UNIFORM_BUFFER, array, gl.DYNAMIC_DRAW);
    gl.uniform1f(place("size"), size);
    gl.uniform1f(place("exposure"), exposure);
    gl.uniform1i(place("tone"), TONES.indexOf(tone));
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return this.lost ? undefined : this.#canvas;
  }
}

/** @type {Shared | null | undefined} */
let shared;

/** The shared context, or `null` where there is no WebGL 2. */
export function renderer() {
  if (shared === undefined) {
    const canvas = typeof OffscreenCanvas === "undefined" ? undefined : new OffscreenCanvas(1, 1);
    const gl = canvas?.getContext("webgl2", { antialias: false, depth: false });
    shared = canvas && gl ? new Shared(canvas, gl) : null;
  }
  return shared;
}
