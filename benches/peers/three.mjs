// three.js and our package on the same pixels: a task in JSON from standard input, the images and
// times of both to standard output.

import { readFileSync } from "node:fs";
import { SphericalHarmonics3, Vector3 } from "../../examples/three/node_modules/three/build/three.module.js";
import { Scene, load } from "../../packages/eigenshade/src/index.js";

// Enough for engines to compile what runs often.
const ROUNDS = 1001;
const REPEATS = 30;
/// Our coefficients to the graphics convention.
const SIGNS = [1, -1, 1, -1, -1, -1, 1, -1, 1];

const engine = await load(readFileSync(new URL("../../target/modules/color.simd.wasm", import.meta.url)));
const { timed, normals, cases } = JSON.parse(readFileSync(0, "utf8"));
const axes = [0, 1, 2].map((axis) => Float32Array.from(normals, (normal) => normal[axis]));
const vectors = normals.map((normal) => new Vector3(...normal));

/** Draws a case with our package. */
async function ours({ light, material }) {
  const rgb = ([r, g, b]) => ({ r, g, b });
  const scene = await Scene.create({ light: rgb(light), material: rgb(material), engine });
  const out = scene.shade(...axes);
  return {
    draw: () => scene.shade(...axes, out),
    image: () => [...out.r, ...out.g, ...out.b],
  };
}

/** Draws it with the nine terms of three.js. */
function three({ light }) {
  const coefficients = SIGNS.map((sign, k) => new Vector3(...light.map((channel) => sign * channel[k])));
  const probe = new SphericalHarmonics3().set(coefficients);
  const pixels = vectors.map(() => new Vector3());
  return {
    draw: () => vectors.forEach((normal, k) => probe.getIrradianceAt(normal, pixels[k])),
    image: () => ["x", "y", "z"].flatMap((channel) => pixels.map((pixel) => pixel[channel] / Math.PI)),
  };
}

const seconds = ({ draw }) => {
  const start = performance.now();
  for (let repeat = 0; repeat < REPEATS; repeat++) draw();
  return performance.now() - start;
};

const images = [];
let times = [];
for (const one of cases) {
  const methods = [await ours(one), three(one)];
  methods.forEach(({ draw }) => draw());
  images.push(methods.map(({ image }) => image()));
  if (timed && times.length === 0) {
    times = methods.map(() => Infinity);
    for (let round = 0; round < ROUNDS; round++) {
      methods.forEach((method, k) => (times[k] = Math.min(times[k], seconds(method))));
    }
  }
}
console.log(JSON.stringify({ images, times }));
