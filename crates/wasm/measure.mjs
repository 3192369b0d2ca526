// Measures the modules of `crates/wasm/build`: sizes, and times of one run.
//
//     node crates/wasm/measure.mjs            prints the tables, fails if a bound is exceeded
//     node crates/wasm/measure.mjs --write    writes them to crates/wasm/README.md

import { readFileSync, writeFileSync } from "node:fs";
import { load } from "./eigenshade.mjs";
import { hemisphere, leasts } from "./tests/support/timing.mjs";
import { row } from "./tests/support/golden.mjs";
import { VARIANTS, bytes, sizes } from "./tests/support/modules.mjs";

/** Maximum cost of a pixel of the full scene with SIMD, in nine-term pixels: 14 ns against 0.4. */
const MAX_RATIO = 14 / 0.4;

/** The pair that is shaded. */
const PAIR = "park 07-velvet g";

const README = new URL("README.md", import.meta.url);
const MARKS = ["<!-- node crates/wasm/measure.mjs --write -->", "<!-- end -->"];

const thousands = (number) => number.toLocaleString("en-US");
const called = (name, variant) => `\`${name}\`, ${variant ? "with" : "without"} SIMD`;

function sizeTable() {
  const lines = [
    "| module | code and all else, gzip -9 | the same, as it is | data: the tables |",
    "|---|---:|---:|---:|",
  ];
  for (const name of ["f32", "q15", "q31", "floats", "all"]) {
    for (const variant of VARIANTS) {
      const size = sizes(bytes(name, variant));
      const numbers = [size.zipped, size.rest, size.data].map(thousands).join(" | ");
      lines.push(`| ${called(name, variant)} | ${numbers} |`);
    }
  }
  return lines.join("\n");
}

/** Times of one variant, each with its name. */
async function times(variant) {
  const { f32, q15, q31, exports } = await load(bytes("all", variant));
  const count = f32.shape.normals;
  const pixels = 4 * count;
  const many = hemisphere(pixels);
  const few = hemisphere(count);
  for (const format of [f32, q15, q31]) {
    format.light(row("f32", "light", PAIR).numbers).material(row("f32", "material", PAIR).numbers);
    format.project();
    // Leaves these normals in the module's buffer.
    format.collapse().shade(...few);
  }
  const nine = new Float32Array(exports.memory.buffer, exports.nine.value, 9);
  nine.set([0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);
  const out = new Float32Array(pixels);
  const tasks = [
    { name: "nine terms, a pixel", work: () => exports.nine_terms(count), count },
    { name: "`f32`, a pixel", work: () => exports.f32_shade(count), count },
    { name: "`f32` by `shade`, a pixel", work: () => f32.shade(...many, out), count: pixels },
    { name: "`f32` `project` and `collapse`", work: () => f32.project() && f32.collapse(), count: 1 },
    { name: "`q15`, a pixel", work: () => exports.q15_shade(count), count },
    { name: "`q31`, a pixel", work: () => exports.q31_shade(count), count },
  ];
  return (await leasts(tasks)).map((time, k) => ({ ...tasks[k], time }));
}

const all = [];
for (const variant of VARIANTS) all.push(await times(variant));
const ratios = all.map((rows) => rows[1].time / rows[0].time);
const lines = ["| ns | without SIMD | with SIMD |", "|---|---:|---:|"];
all[0].forEach(({ name }, k) => {
  const numbers = all.map((rows) => (rows[k].time < 1000 ? Number(rows[k].time.toPrecision(2)) : thousands(Math.round(rows[k].time / 100) * 100)));
  lines.push(`| ${name} | ${numbers.join(" | ")} |`);
});
lines.push(`| a full pixel in nine-term pixels | ${ratios.map((ratio) => ratio.toFixed(0)).join(" | ")} |`);
const tables = `${sizeTable()}\n\n${lines.join("\n")}\n`;
console.log(tables);
if (process.argv.includes("--write")) {
  const text = readFileSync(README, "utf8");
  const [start, end] = [text.indexOf(MARKS[0]) + MARKS[0].length, text.indexOf(MARKS[1])];
  writeFileSync(README, `${text.slice(0, start)}\n${tables}${text.slice(end)}`);
}
if (ratios[1] > MAX_RATIO) {
  console.error(`error: a full pixel costs ${ratios[1].toFixed(1)} nine-term pixels, ${MAX_RATIO} at most`);
  process.exitCode = 1;
}
