// three.js and our WebAssembly module on the same pixels: a task in JSON from standard input,
// the answer to standard output. `benches/peers/run` calls it.

import { readFileSync } from "node:fs";
import { load } from "../../../crates/wasm/eigenshade.mjs";
import { bytes } from "../../../crates/wasm/tests/support/modules.mjs";

const ROUNDS = 101;

const fail = (message) => {
  console.error(`error: ${message}`);
  process.exit(1);
};

const three = await import("three").catch((fault) =>
  fail(`${fault.message}; run \`npm install\` in benches/peers/node first`),
);
let module;
try {
  module = await load(bytes("all", ".simd"));
} catch (fault) {
  fail(fault.message);
}
const { SphericalHarmonics3, Vector3 } = three;
const { f32, exports } = module;
const task = JSON.parse(readFileSync(0, "utf8"));
const count = f32.shape.normals;

/** Buffers of the module. */
const view = (name, length) => new Float32Array(exports.memory.buffer, exports[name].value, length);
const [nine, axes, irradiance] = [view("nine", 9), view("f32_normals", 3 * count), view("f32_irradiance", count)];

/** Our coefficients to the graphics convention. */
const SIGNS = [1, -1, 1, -1, -1, -1, 1, -1, 1];

/** The light as three.js has it. */
function probe({ light }) {
  const coefficients = SIGNS.map((sign, k) => new Vector3(...light.map((channel) => sign * channel[k])));
  return new SphericalHarmonics3().set(coefficients);
}

/** Coefficients of 1, x, y, z, x² - y², xy, xz, yz, z² of one channel, on f = 1/π. */
function nineTerms(light) {
  const c = SIGNS.map((sign, k) => sign * light[k] * (k === 0 ? 1 : k < 4 ? 2 / 3 : 1 / 4));
  const [constant, linear, mixed, along] = [0.25, 0.75, 3.75, 0.3125].map((share) => Math.sqrt(share / Math.PI));
  return [
    constant * c[0] - along * c[6],
    linear * c[3],
    linear * c[1],
    linear * c[2],
    0.5 * mixed * c[8],
    mixed * c[4],
    mixed * c[7],
    mixed * c[5],
    3 * along * c[6],
  ];
}

/** Normals into the module, from `start` on; gives how many. */
function fill(start) {
  const part = task.normals.slice(start, start + count);
  part.forEach((normal, k) => normal.forEach((value, axis) => (axes[axis * count + k] = value)));
  return part.length;
}

/** One channel's image by an export that fills `f32_irradiance`. */
function channel(shade) {
  const image = [];
  for (let start = 0; start < task.normals.length; start += count) {
    const length = fill(start);
    shade(length);
    image.push(...irradiance.subarray(0, length));
  }
  return image;
}

/** The images of a case, by way. */
const IMAGES = {
  three: (one) => {
    const light = probe(one);
    const target = new Vector3();
    const pixels = task.normals.map((normal) => {
      light.getIrradianceAt(new Vector3(...normal), target);
      return target.toArray();
    });
    return [0, 1, 2].map((axis) => pixels.map((pixel) => pixel[axis] / Math.PI));
  },
  nine: (one) =>
    one.light.map((light) => {
      nine.set(nineTerms(light));
      return channel(exports.nine_terms);
    }),
  full: (one) =>
    one.light.map((light, k) => {
      f32.light(light).material(one.material[k]).project();
      f32.collapse();
      return channel(exports.f32_shade);
    }),
};

/** Root mean square of the difference over all channels, of the peak. */
function error({ reference }, image, isMatte) {
  let [both, own, peak, squares] = [0, 0, 0, 0];
  const each = (visit) =>
    reference.forEach((channel, c) => channel.forEach((value, k) => visit(value, image[c][k], task.weights[k])));
  each((value, found, weight) => {
    both += weight * value * found;
    own += weight * found * found;
    peak = Math.max(peak, Math.abs(value));
  });
  const albedo = isMatte ? both / own : 1;
  each((value, found, weight) => (squares += weight * (value - albedo * found) ** 2));
  return Math.sqrt(squares / 3) / peak;
}

const errors = (way, cases, isMatte) => cases.map((one) => error(one, IMAGES[way](one), isMatte));

/** Times of each way in those of the first, medians over interleaved rounds. */
async function ratios() {
  fill(0);
  const some = Math.min(count, task.normals.length);
  const [one] = task.measured_materials;
  IMAGES.full(one);
  fill(0);
  const light = probe(one);
  const target = new Vector3();
  const normals = task.normals.slice(0, some).map((normal) => new Vector3(...normal));
  const [x, y, z] = [0, 1, 2].map((axis) => Float32Array.from(task.normals.slice(0, some), (normal) => normal[axis]));
  const out = new Float32Array(some);
  let sum = 0;
  const threeChannels = (shade) => () => {
    for (let channel = 0; channel < 3; channel++) shade();
  };
  const tasks = [
    {
      repeat: 30,
      work: () => {
        for (const normal of normals) sum += light.getIrradianceAt(normal, target).x;
      },
    },
    { repeat: 400, work: threeChannels(() => exports.nine_terms(some)) },
    { repeat: 20, work: threeChannels(() => exports.f32_shade(some)) },
    { repeat: 20, work: threeChannels(() => f32.shade(x, y, z, out)) },
  ];
  const run = ({ work, repeat }) => {
    const start = process.hrtime.bigint();
    for (let turn = 0; turn < repeat; turn++) work();
    return Number(process.hrtime.bigint() - start) / repeat;
  };
  // Engines compile in the background what runs often.
  for (let turn = 0; turn < 20; turn++) {
    tasks.forEach(run);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  const found = tasks.map(() => []);
  for (let round = 0; round < ROUNDS; round++) {
    const times = tasks.map(run);
    times.forEach((time, k) => found[k].push(time / times[0]));
  }
  if (!Number.isFinite(sum)) fail("three.js gave no numbers");
  return found.map((all) => all.sort((a, b) => a - b)[all.length >> 1]);
}

const times = task.measured ? await ratios() : [];
const ways = [
  ["three.js", "three", false],
  ["nine terms in our module", "nine", true],
  ["full scene in our module", "full", true],
  ["full scene by `shade`", "full", true],
].map(([name, way, isOurs], k) => ({
  name,
  ratio: times[k] ?? null,
  is_ours: isOurs,
  mattes: errors(way, task.mattes, false),
  measured_materials: errors(way, task.measured_materials, way !== "full"),
}));
console.log(JSON.stringify({ ways }));
