// In the page: evaluates a scene's shader at normals, on a float target.

let canvas;
const programs = new Map();

/**
 * red, green, blue and 1 of each of 1,024 normals, by WebGL 2. With a prefix, `beside` is the text of
 * another scene in the same program.
 */
export function webgl(scene, storage, [x, y, z], prefix = "", beside = "") {
  canvas ??= new OffscreenCanvas(1024, 1);
  const gl = canvas.getContext("webgl2");
  if (!gl.getExtension("EXT_color_buffer_float")) throw new Error("no float targets");
  const text = beside + (prefix ? scene.glsl(storage, { prefix }) : scene.glsl(storage));
  if (!programs.has(text)) programs.set(text, compiled(gl, text, prefix));
  const program = programs.get(text);
  gl.useProgram(program);
  const made = [];
  const texture = (unit, width, numbers) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    made.push(gl.createTexture());
    gl.bindTexture(gl.TEXTURE_2D, made.at(-1));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, 1, 0, gl.RGBA, gl.FLOAT, numbers);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  };
  const place = (name) => gl.getUniformLocation(program, name);
  const uniforms = scene.uniforms();
  if (storage === "uniforms") {
    gl.uniform4fv(place(`${prefix}eigenshade`), uniforms);
  } else if (storage === "block") {
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, `${prefix}Eigenshade`), 0);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, gl.createBuffer());
    gl.bufferData(gl.UNIFORM_BUFFER, uniforms, gl.STATIC_DRAW);
  } else {
    texture(1, uniforms.length / 4, uniforms);
    gl.uniform1i(place(`${prefix}eigenshade`), 1);
  }
  texture(0, 1024, Float32Array.from({ length: 4096 }, (_, k) => [x, y, z, x][k % 4][k >> 2]));
  gl.uniform1i(place("normals"), 0);
  texture(2, 1024, null);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
  gl.viewport(0, 0, 1024, 1);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new Float32Array(4096);
  gl.readPixels(0, 0, 1024, 1, gl.RGBA, gl.FLOAT, pixels);
  if (gl.getError()) throw new Error("WebGL found an error");
  made.forEach((texture) => gl.deleteTexture(texture));
  return pixels;
}

function compiled(gl, functions, prefix) {
  const program = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, `#version 300 es
      void main() { gl_Position = vec4(4.0 * float(gl_VertexID & 1) - 1.0, 2.0 * float(gl_VertexID & 2) - 1.0, 0.0, 1.0); }`],
    [gl.FRAGMENT_SHADER, `#version 300 es
      precision highp float;
      ${functions}
      uniform highp sampler2D normals;
      out vec4 color;
      void main() {
        vec3 normal = texelFetch(normals, ivec2(gl_FragCoord.x, 0), 0).xyz;
        // three.js has a variable of this name.
        vec3 ${prefix ? "irradiance" : "found"} = ${prefix}irradiance(normal);
        color = vec4(${prefix ? "irradiance" : "found"}, 1.0);
      }`],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

let device;

/** The same by a compute shader of WebGPU. With a prefix, the scene's buffer has binding 3. */
export async function webgpu(scene, [x, y, z], prefix = "", beside = "") {
  device ??= await (await navigator.gpu.requestAdapter()).requestDevice();
  const code = `${beside}${prefix ? scene.wgsl({ prefix, binding: 3 }) : scene.wgsl()}
    @group(0) @binding(1) var<storage, read> normals: array<vec4f>;
    @group(0) @binding(2) var<storage, read_write> colors: array<vec4f>;
    @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
      colors[id.x] = vec4f(${prefix}irradiance(normals[id.x].xyz), 1.0);
    }`;
  device.pushErrorScope("validation");
  const pipeline = device.createComputePipeline({ layout: "auto", compute: { module: device.createShaderModule({ code }) } });
  const buffer = (usage, numbers) => {
    const made = device.createBuffer({ size: numbers.byteLength, usage: usage | GPUBufferUsage.COPY_DST });
    device.queue.writeBuffer(made, 0, numbers);
    return made;
  };
  const normals = Float32Array.from({ length: 4096 }, (_, k) => [x, y, z, x][k % 4][k >> 2]);
  const { UNIFORM, STORAGE, COPY_SRC, MAP_READ } = GPUBufferUsage;
  const colors = buffer(STORAGE | COPY_SRC, new Float32Array(4096));
  const entries = [buffer(UNIFORM, scene.uniforms()), buffer(STORAGE, normals), colors];
  const read = buffer(MAP_READ, new Float32Array(4096));
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({
    layout: pipeline.getBindGroupLayout(0),
    entries: entries.map((buffer, k) => ({ binding: prefix && k === 0 ? 3 : k, resource: { buffer } })),
  }));
  pass.dispatchWorkgroups(16);
  pass.end();
  encoder.copyBufferToBuffer(colors, 0, read, 0, 16384);
  device.queue.submit([encoder.finish()]);
  const fault = await device.popErrorScope();
  if (fault) throw new Error(fault.message);
  await read.mapAsync(GPUMapMode.READ);
  return new Float32Array(read.getMappedRange().slice(0));
}
