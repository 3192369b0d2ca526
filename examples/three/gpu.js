// In the page: draws functions `vec3 irradiance(vec3 normal)` in fragment shaders.

const SIZE = 256;
const gl = new OffscreenCanvas(SIZE, SIZE).getContext("webgl2", { antialias: false, depth: false });

/** The nine-term formula, with `vec4` uniforms, in sums of three numbers as in a scene's text. */
export const NINE = `uniform vec4 nine[9];
vec3 irradiance(vec3 n) {
  return nine[0].rgb + nine[1].rgb * n.y + nine[2].rgb * n.z + nine[3].rgb * n.x + nine[4].rgb * (n.x * n.y)
    + nine[5].rgb * (n.y * n.z) + nine[6].rgb * (n.z * n.z) + nine[7].rgb * (n.x * n.z)
    + nine[8].rgb * (n.x * n.x - n.y * n.y);
}`;

export const TRIVIAL = "vec3 irradiance(vec3 n) { return n; }";

/** A program around a function, and the numbers of its array of uniforms, four for each vector. */
export function program(text, name, numbers) {
  const made = gl.createProgram();
  for (const [kind, source] of [
    [gl.VERTEX_SHADER, `#version 300 es
      void main() { gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 2.0 * float(gl_VertexID & 2) - 1.0, 0.0, 1.0); }`],
    [gl.FRAGMENT_SHADER, `#version 300 es
      precision highp float;
      ${text}
      out vec4 color;
      void main() {
        vec2 at = 1.4 * gl_FragCoord.xy / ${SIZE}.0 - 0.7;
        color = vec4(irradiance(vec3(at, sqrt(1.0 - dot(at, at)))), 1.0);
      }`],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  gl.useProgram(made);
  if (name) gl.uniform4fv(gl.getUniformLocation(made, name), numbers);
  return made;
}

/** Draws some pictures of a program, and returns when they are done. Returns the number of pixels. */
export function draw(made, pictures) {
  gl.viewport(0, 0, SIZE, SIZE);
  gl.useProgram(made);
  for (let k = 0; k < pictures; k++) gl.drawArrays(gl.TRIANGLES, 0, 3);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return pictures * SIZE ** 2;
}
