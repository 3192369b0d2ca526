// Programs of WebGL 2 for scenes, each compiled once.

/** The programs around the functions of scenes. Those used last are kept. */
export class Programs {
  #gl;
  #vertex;
  #fragment;
  #most;
  /** @type {Map<string, WebGLProgram>} */
  #kept = new Map();

  /**
   * @param {WebGL2RenderingContext} gl
   * @param {string} vertex the vertex shader
   * @param {(irradiance: string) => string} fragment the fragment shader around a scene's function
   * @param {number} most how many are kept
   */
  constructor(gl, vertex, fragment, most) {
    this.#gl = gl;
    this.#vertex = vertex;
    this.#fragment = fragment;
    this.#most = most;
  }

  /** @param {string} irradiance */
  has(irradiance) {
    return this.#kept.has(irradiance);
  }

  /** Forgets all programs, after the context was lost. */
  clear() {
    this.#kept.clear();
  }

  /**
   * The program around a scene's function.
   *
   * @param {string} irradiance
   * @returns {WebGLProgram | undefined} `undefined` if the context is lost
   */
  of(irradiance) {
    const found = this.#kept.get(irradiance) ?? this.#compiled(irradiance);
    if (!found) return undefined;
    this.#kept.delete(irradiance);
    this.#kept.set(irradiance, found);
    if (this.#kept.size > this.#most) {
      const [[oldest, program]] = this.#kept;
      this.#kept.delete(oldest);
      this.#gl.deleteProgram(program);
    }
    return found;
  }

  /**
   * @param {string} irradiance
   * @returns {WebGLProgram | undefined}
   */
  #compiled(irradiance) {
    const gl = this.#gl;
    const program = gl.createProgram();
    if (!program) return undefined;
    let log = "";
    for (const [kind, text] of /** @type {[GLenum, string][]} */ ([
      [gl.VERTEX_SHADER, this.#vertex],
      [gl.FRAGMENT_SHADER, this.#fragment(irradiance)],
    ])) {
      const shader = gl.createShader(kind);
      if (!shader) return undefined;
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      gl.deleteShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) log += gl.getShaderInfoLog(shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      log += gl.getProgramInfoLog(program);
      gl.deleteProgram(program);
      if (gl.isContextLost()) return undefined;
      throw new Error(`the shader of the scene does not compile: ${log}`);
    }
    return program;
  }
}
