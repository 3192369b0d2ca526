// The WebAssembly module of eigenshade, for Node and browsers: memory wrapped, input checked.
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

/** Coefficients of a light up to this degree. */
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

/** The coefficients in f32. */
function checked(what, coefficients, count, most) {
  if (!(Array.isArray(coefficients) || ArrayBuffer.isView(coefficients))) {
    throw new TypeError(`${what}: an array of numbers expected, ${typeof coefficients} found`);
  }
  const counts = Array.from({ length: most + 1 }, (_, largest) => count(largest));
  if (!counts.includes(coefficients.length)) {
    const beyond = coefficients.length > counts[most] ? "; leave out what is beyond" : "";
    throw new RangeError(
      `${what}: ${coefficients.length} coefficients, this table takes ${counts.join(", ")}${beyond}`,
    );
  }
  const numbers = Float32Array.from(coefficients);
  const bad = numbers.findIndex((number) => !Number.isFinite(number));
  if (bad >= 0) {
    throw new RangeError(`${what}: coefficient ${bad} is ${coefficients[bad]}, which no f32 holds`);
  }
  return numbers;
}

/**
 * The unit normals along vectors given component by component: those of a mesh, or of a normal
 * map, whose channel c of 8 bits says 2c - 255. One that points away by no more than 1/8 is laid
 * on the rim, beyond which an image means nothing.
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
        `normalized: vector ${k} is (${x[k]}, ${y[k]}, ${z[k]}), which points nowhere or away`,
      );
    }
    const visible = [x[k], y[k], Math.max(z[k], 0)];
    const length = Math.hypot(...visible);
    normals.forEach((axis, which) => (axis[k] = visible[which] / length));
  }
  return normals;
}

/** What the formats have in common. */
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
    this.folded = false;
    return this;
  }

  /** Copies an input to where the module reads it, zeros above its degree or order. */
  put(what, step = "project") {
    const given = this.ready[what];
    if (!given) throw new Error(`${step}: there is no ${what} yet; give one first`);
    this.inputs[what].fill(0).set(given);
  }

  /** Calls a function of the module. */
  call(step) {
    if (!this.exports[`${this.name}_${step}`]()) {
      throw new Error(`${this.name}: the module refuses to ${step}`);
    }
  }

  /** Sums the components of each azimuth: an image that can be shaded. */
  collapse() {
    if (!this.ready.d) throw new Error("collapse: there are no coefficients d yet; project first");
    this.call("collapse");
    this.ready.scene = true;
    return this;
  }

  /**
   * The irradiances of visible unit normals, given component by component. `irradiance`
   * takes them if it is given.
   */
  shade(x, y, z, irradiance) {
    if (!this.ready.scene) throw new Error("shade: there is no scene yet; collapse first");
    return this.pixels("shade", "shade", [x, y, z], irradiance);
  }

  /** The irradiances by a function of the module, as many at a time as it takes. */
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
      `${name}: normal ${k} is (${x[k]}, ${y[k]}, ${z[k]}), no unit vector with z >= 0`,
    );
  }

  /** The first normal that is no unit vector, to a part in 2,000, or hidden; -1 for none. */
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

/** The way in floats. */
class Floats extends Format {
  /** The coefficients d of the light on the material. */
  project() {
    this.put("light");
    this.put("material");
    this.call("project");
    this.got();
    return this.answers.d.slice();
  }

  /** There are new coefficients d, and nothing of them yet. */
  got() {
    Object.assign(this.ready, { d: true, scene: false, map: false });
  }

  /** `project` in two parts, if the module has them: a material is folded in once. */
  relight() {
    this.has("relight");
    this.put("light", "relight");
    if (!this.folded) {
      this.put("material", "relight");
      this.call("fold");
      this.folded = true;
    }
    this.call("relight");
    this.got();
    return this.answers.d.slice();
  }

  /** Bakes the scene on a map of 32 x 32, if the module can. */
  bake() {
    this.has("bake");
    if (!this.ready.scene) throw new Error("bake: there is no scene yet; collapse first");
    this.call("bake");
    this.ready.map = true;
    return this;
  }

  /** `shade` by the baked map. */
  lookUp(x, y, z, irradiance) {
    this.has("look_up");
    if (!this.ready.map) throw new Error("lookUp: there is no map yet; bake first");
    return this.pixels("lookUp", "look_up", [x, y, z], irradiance);
  }

  has(step) {
    if (!this.exports[`f32_${step}`]) {
      throw new Error(`f32: this module has no f32_${step}; take floats.wasm`);
    }
  }

  /** Copies normals to where the module reads them. */
  write(from, start, end, to) {
    if (ArrayBuffer.isView(from)) this.normals.set(from.subarray(start, end), to);
    else for (let k = start; k < end; k++) this.normals[to + k - start] = from[k];
  }

  /** A normal that points away by less than this is as good as one at the rim. */
  hidden() {
    return -1e-3;
  }
}

/** The way in integers: a number is its mantissa times 2 to the exponent of its array. */
class Integers extends Format {
  /** The coefficients d of the light on the material: mantissas and their exponent. */
  project() {
    this.put("light");
    if (!this.folded) {
      this.put("material");
      this.call("fold");
      this.folded = true;
    }
    this.call("relight");
    Object.assign(this.ready, { d: true, scene: false });
    return { mantissas: this.answers.d.slice(), exponent: this.exponents[0] };
  }

  /** The exponent of every irradiance of the scene. */
  get exponent() {
    return this.exponents[1];
  }

  /** Mantissas as they are, other numbers to the nearest. */
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
