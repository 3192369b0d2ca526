// three.js and our package on the same pixels: a task in JSON from standard input, the answer to
// standard output. `benches/peers/run` calls it.

import { readFileSync } from "node:fs";
import { Scene, load } from "../../../packages/eigenshade/src/index.js";

const ROUNDS = 101;

const fail = (message) => {
  console.error(`error: ${message}`);
  process.exit(1);
};

const three = await import("three").catch((fault) =>
  fail(`${fault.message}; run \`npm install\` in benches/peers/node first`),
);
let engine;
try {
  engine = await load(readFileSync(new URL("../../../target/modules/color.simd.wasm", import.meta.url)));
} catch (fault) {
  fail(fault.message);
}
const { SphericalHarmonics3, Vector3 } = three;
const task = JSON.parse(readFileSync(0, "utf8"));
const [x, y, z] = [0, 1, 2].map((axis) => Float32Array.from(task.normals, (normal) => normal[axis]));

/** Three channels as the package takes them, of degree 9 or order 7 at most. */
const rgb = (channels, most) => {
  const [r, g, b] = channels.map((channel) => channel.slice(0, most));
  return { r, g, b };
};
const scene = ({ light, material }) => Scene.create({ light: rgb(light, 100), material: rgb(material, 40), engine });

/** Our coefficients to the graphics convention. */
const SIGNS = [1, -1, 1, -1, -1, -1, 1, -1, 1];

/** The light as three.js has it. */
function probe({ light }) {
  const coefficients = SIGNS.map((sign, k) => new Vector3(...light.map((channel) => sign * channel[k])));
  return new SphericalHarmonics3().set(coefficients);
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
  ours: async (one) => {
    const { r, g, b } = (await scene(one)).shade(x, y, z);
    return [r, g, b];
  },
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

async function errors(way, cases, isMatte) {
  const found = [];
  for (const one of cases) found.push(error(one, await IMAGES[way](one), isMatte));
  return found;
}

/** Times of each way in those of the first, medians over interleaved rounds. */
async function ratios() {
  const [one] = task.measured_materials;
  const ours = await scene(one);
  const light = probe(one);
  const target = new Vector3();
  const normals = task.normals.map((normal) => new Vector3(...normal));
  const out = ours.shade(x, y, z);
  let sum = 0;
  const tasks = [
    {
      repeat: 30,
      work: () => {
        for (const normal of normals) sum += light.getIrradianceAt(normal, target).x;
      },
    },
    { repeat: 30, work: () => ours.shade(x, y, z, out) },
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
const ways = [];
for (const [k, [name, way, isOurs]] of [
  ["three.js", "three", false],
  ["full scene by `Scene.shade`", "ours", true],
].entries()) {
  ways.push({
    name,
    ratio: times[k] ?? null,
    is_ours: isOurs,
    mattes: await errors(way, task.mattes, false),
    measured_materials: await errors(way, task.measured_materials, !isOurs),
  });
}
console.log(JSON.stringify({ ways }));
