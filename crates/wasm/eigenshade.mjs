// A wrapper of the WebAssembly module of eigenshade for Node and browsers. It checks all input.
//
//     const { f32 } = await load("f32.simd.wasm");
//     f32.light(light).material(material);
//     f32.project();
//     f32.collapse();
//     const irradiance = f32.shade(x, y, z);
//
// Signs, axes and the order of coefficients are those of docs/conventions.md.

/** Loads the module: from a URL by fetch, or from bytes, a Response or a WebAssembly.Module. */
export async function load(source) {
  const instance = await instantiate(source);
  const { exports } = instance;
  const view = (name, array, length) =>
    new array(exports.memory.buffer, exports[name].value, length);
  const [degree, order, components, normals] = view("shape", Uint32Array, 4);
  const shape = { degree, order, components, normals };
  const formats = {};
  for (const [name, kind, mantissas, bits] of [
    ["f32", Floats, Float32Array, 0],
    ["q15", Integers, Int16Array, 15],
    ["q31", Integers, Int32Array, 31],
  ]) {
    if (exports[`${name}_collapse`]) {
      formats[name] = new kind(exports, name, view, shape, mantissas, bits);
    }
  }
  return Object.freeze({ degree, order, components, ...formats, exports });
}

async function instantiate(source) {
  if (source instanceof WebAssembly.Module) return WebAssembly.instantiate(source);
  let bytes = source;
  if (typeof source === "string" || source instanceof URL) bytes = await fetch(source);
  if (typeof Response !== "undefined" && bytes instanceof Response) {
    if (!bytes.ok) throw new Error(`${bytes.url}: ${bytes.status} ${bytes.statusText}`);
    bytes = await bytes.arrayBuffer();
  }
  return (await WebAssembly.instantiate(bytes)).instance;
}

/** Number of coefficients of a light of this degree. */
const lightCount = (degree) => (degree + 1) ** 2;

/** Coefficients of a material up to this order. */
function materialCount(order) {
  let count = 0;
  for (let o = 0; o <= order; o++) {
    const half = Math.floor(o / 2);
    count += ((half + 1) * (half + 2)) / 2;
  }
  return count;
}

/** The largest coefficient: products of larger ones may exceed f32. */
const LARGEST = 1e15;

/** The coefficients as a Float32Array, if their number is valid and none is too large. */
function checked(what, coefficients, count, most) {
  if (!(Array.isArray(coefficients) || ArrayBuffer.isView(coefficients))) {
    throw new TypeError(`${what}: an array of numbers expected, ${typeof coefficients} found`);
  }
  const counts = Array.from({ length: most + 1 }, (_, largest) => count(largest));
  if (!counts.includes(coefficients.length)) {
    const beyond = coefficients.length > counts[most] ? "; leave out the rest" : "";
    throw new RangeError(
      `${what}: ${coefficients.length} coefficients, this table takes ${counts.join(", ")}${beyond}`,
    );
  }
  const numbers = Float32Array.from(coefficients);
  const bad = numbers.findIndex((number) => !(Math.abs(number) <= LARGEST));
  if (bad >= 0) {
    throw new RangeError(
      `${what}: coefficient ${bad} is ${coefficients[bad]}, expected a number from -1e15 to 1e15`,
    );
  }
  return numbers;
}

/**
 * Unit normals along vectors, given component by component: those of a mesh or of a normal map,
 * whose 8-bit channel c means 2c - 255. Vectors that point away by no more than 1/8 are moved to
 * the rim.
 */
export function normalized(x, y, z) {
  const count = x.length;
  for (const [what, array] of Object.entries({ y, z })) {
    if (array.length !== count) {
      throw new RangeError(`normalized: x has ${count} numbers, ${what} has ${array.length}`);
    }
  }
  const normals = [0, 1, 2].map(() => new Float32Array(count));
  for (let k = 0; k < count; k++) {
    const distance = Math.hypot(x[k], y[k], z[k]);
    if (!(distance < Infinity && z[k] / distance >= -1 / 8)) {
      throw new RangeError(
        `normalized: vector ${k} is (${x[k]}, ${y[k]}, ${z[k]}), which is zero, not finite, or points away`,
      );
    }
    const visible = [x[k], y[k], Math.max(z[k], 0)];
    const length = Math.hypot(...visible);
    normals.forEach((axis, which) => (axis[k] = visible[which] / length));
  }
  return normals;
}

/** The common part of the formats. */
class Format {
  constructor(exports, name, view, shape, array, bits) {
    Object.assign(this, { exports, name, shape, array, bits });
    const buffer = (what, kind, length) => view(`${name}_${what}`, kind, length);
    this.inputs = {
      light: view("light", Float32Array, lightCount(shape.degree)),
      material: view("material", Float32Array, materialCount(shape.order)),
    };
    this.normals = buffer("normals", array, 3 * shape.normals);
    const answer = bits ? Int32Array : Float32Array;
    this.answers = {
      d: buffer("d", answer, shape.components),
      irradiance: buffer("irradiance", answer, shape.normals),
    };
    if (bits) this.exponents = buffer("exponents", Int32Array, 2);
    this.ready = { light: null, material: null, d: false, scene: false };
  }

  /** One channel of light: (degree + 1)² coefficients in radiance. */
  light(coefficients) {
    this.ready.light = checked("light", coefficients, lightCount, this.shape.degree);
    return this;
  }

  /** One channel of a BRDF: its coefficients in 1/sr. */
  material(coefficients) {
    this.ready.material = checked("material", coefficients, materialCount, this.shape.order);
    this.transferred = false;
    return this;
  }

  /** Copies an input to the module's buffer, with zeros above its degree or order. */
  put(what, step = "project") {
    const given = this.ready[what];
    if (!given) throw new Error(`${step}: no ${what} yet; set one first`);
    this.inputs[what].fill(0).set(given);
  }

  /** Calls a function of the module. */
  call(step) {
    if (!this.exports[`${this.name}_${step}`]()) {
      throw new Error(`${this.name}: the module rejected the input of ${step}`);
    }
  }

  /** Sums the components of each azimuth to a scene, which can be shaded. */
  collapse() {
    if (!this.ready.d) throw new Error("collapse: no coefficients d yet; call project first");
    this.call("collapse");
    this.ready.scene = true;
    return this;
  }

  /**
   * The irradiances of visible unit normals, given component by component. They are written to
   * `irradiance` if it is given.
   */
  shade(x, y, z, irradiance) {
    if (!this.ready.scene) throw new Error("shade: no scene yet; call collapse first");
    return this.pixels("shade", "shade", [x, y, z], irradiance);
  }

  /** Computes irradiances with a function of the module, in parts of the size of its buffers. */
  pixels(name, step, [x, y, z], irradiance) {
    const count = x.length;
    irradiance ??= new this.answers.irradiance.constructor(count);
    for (const [what, array] of Object.entries({ y, z, irradiance })) {
      if (array.length !== count) {
        throw new RangeError(`${name}: x has ${count} numbers, ${what} has ${array.length}`);
      }
    }
    const bad = this.firstBad(x, y, z);
    if (bad >= 0) throw this.badNormal(name, bad, x, y, z);
    for (let start = 0; start < count; start += this.shape.normals) {
      const end = Math.min(start + this.shape.normals, count);
      [x, y, z].forEach((from, axis) => this.write(from, start, end, axis * this.shape.normals));
      const done = this.exports[`${this.name}_${step}`](end - start);
      if (done < end - start) throw this.badNormal(name, start + done, x, y, z);
      irradiance.set(this.answers.irradiance.subarray(0, end - start), start);
    }
    return irradiance;
  }

  badNormal(name, k, x, y, z) {
    return new RangeError(
      `${name}: normal ${k} is (${x[k]}, ${y[k]}, ${z[k]}), expected a unit vector with z >= 0`,
    );
  }

  /** Index of the first normal that is not a unit vector to 1 part in 2,000, or is hidden; or -1. */
  firstBad(x, y, z) {
    const one = x instanceof this.array ? 2 ** this.bits : 1;
    const [least, most, hidden] = [0.999 * one * one, 1.001 * one * one, this.hidden(one)];
    for (let k = 0; k < x.length; k++) {
      const square = x[k] * x[k] + y[k] * y[k] + z[k] * z[k];
      if (!(square >= least && square <= most && z[k] >= hidden)) return k;
    }
    return -1;
  }
}

/** Floats. */
class Floats extends Format {
  /** The coefficients d of the light on the material. */
  project() {
    this.put("light");
    this.put("material");
    this.call("project");
    this.changed();
    return this.answers.d.slice();
  }

  /** Records new coefficients d: the scene and the map are out of date. */
  changed() {
    Object.assign(this.ready, { d: true, scene: false, map: false });
  }

  /** Like `project`, but computes the transfer of a material only once, if the module can. */
  relight() {
    this.has("relight");
    this.put("light", "relight");
    if (!this.transferred) {
      this.put("material", "relight");
      this.call("transfer");
      this.transferred = true;
    }
    this.call("relight");
    this.changed();
    return this.answers.d.slice();
  }

  /** Bakes the scene into a map of 32 x 32, if the module can. */
  bake() {
    this.has("bake");
    if (!this.ready.scene) throw new Error("bake: no scene yet; call collapse first");
    this.call("bake");
    this.ready.map = true;
    return this;
  }

  /** Like `shade`, but reads the baked map. */
  lookUp(x, y, z, irradiance) {
    this.has("look_up");
    if (!this.ready.map) throw new Error("lookUp: no map yet; call bake first");
    return this.pixels("lookUp", "look_up", [x, y, z], irradiance);
  }

  has(step) {
    if (!this.exports[`f32_${step}`]) {
      throw new Error(`f32: this module has no f32_${step}; use floats.wasm`);
    }
  }

  /** Copies normals to the module's buffer. */
  write(from, start, end, to) {
    if (ArrayBuffer.isView(from)) this.normals.set(from.subarray(start, end), to);
    else for (let k = start; k < end; k++) this.normals[to + k - start] = from[k];
  }

  /** The least z: a normal that points away by less counts as one at the rim. */
  hidden() {
    return -1e-3;
  }
}

/** Integers: a number is its mantissa times 2 to the power of the exponent of its array. */
class Integers extends Format {
  /** The coefficients d of the light on the material: mantissas and their exponent. */
  project() {
    this.put("light");
    if (!this.transferred) {
      this.put("material");
      this.call("transfer");
      this.transferred = true;
    }
    this.call("relight");
    Object.assign(this.ready, { d: true, scene: false });
    return { mantissas: this.answers.d.slice(), exponent: this.exponents[0] };
  }

  /** The exponent of every irradiance of the scene. */
  get exponent() {
    return this.exponents[1];
  }

  /** Copies normals to the module's buffer; numbers that are not mantissas are rounded. */
  write(from, start, end, to) {
    if (from instanceof this.array) {
      this.normals.set(from.subarray(start, end), to);
      return;
    }
    const one = 2 ** this.bits;
    for (let k = start; k < end; k++) {
      this.normals[to + k - start] = Math.max(1 - one, Math.min(one - 1, Math.round(one * from[k])));
    }
  }

  hidden() {
    return 0;
  }
}
