// Measures the modules of `crates/wasm/build`: sizes, and times of one run.
//
//     node crates/wasm/measure.mjs            prints the tables, fails if a bound is exceeded
//     node crates/wasm/measure.mjs --write    puts them into crates/wasm/README.md
//     node crates/wasm/measure.mjs --times    puts the times into crates/wasm/times.csv

import { readFileSync, writeFileSync } from "node:fs";
import { load } from "./eigenshade.mjs";
import { row } from "./tests/support/golden.mjs";
import { VARIANTS, bytes, sizes } from "./tests/support/modules.mjs";

/** Nine-term pixels that one of the full scene may cost with SIMD: 14 ns where they take 0.4. */
const MOST = 14 / 0.4;

const PAIR = "park 07-velvet g";
const README = new URL("README.md", import.meta.url);
const TIMES = new URL("times.csv", import.meta.url);
const MARKS = ["<!-- node crates/wasm/measure.mjs --write -->", "<!-- end -->"];

const thousands = (number) => number.toLocaleString("en-US");
const called = (name, variant) => `\`${name}\`, ${variant ? "with" : "without"} SIMD`;

function sizeTable() {
  const lines = [
    "| module | code and all else, gzip -9 | the same, as it is | data: the tables |",
    "|---|---:|---:|---:|",
  ];
  for (const name of ["f32", "q15", "q31", "all"]) {
    for (const variant of VARIANTS) {
      const size = sizes(bytes(name, variant));
      const numbers = [size.zipped, size.rest, size.data].map(thousands).join(" | ");
      lines.push(`| ${called(name, variant)} | ${numbers} |`);
    }
  }
  return lines.join("\n");
}

/** Medians over interleaved runs, in nanoseconds for one of `count`. */
function medians(tasks) {
  const times = tasks.map(() => []);
  for (let run = 0; run < 41; run++) {
    tasks.forEach(({ work, repeat, count }, k) => {
      const start = process.hrtime.bigint();
      for (let turn = 0; turn < repeat; turn++) work();
      times[k].push(Number(process.hrtime.bigint() - start) / repeat / count);
    });
  }
  return times.map((all) => all.sort((a, b) => a - b)[all.length >> 1]);
}

/** Normals over the visible hemisphere. */
function hemisphere(count) {
  const at = (k) => {
    const z = (k + 0.5) / count;
    const [sine, tilt] = [Math.sqrt(1 - z * z), 2.399963 * k];
    return [sine * Math.cos(tilt), sine * Math.sin(tilt), z];
  };
  return [0, 1, 2].map((axis) => Float32Array.from({ length: count }, (_, k) => at(k)[axis]));
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
    { name: "nine terms, a pixel", file: "nine_terms,f32", work: () => exports.nine_terms(count), repeat: 400, count },
    { name: "`f32`, a pixel", file: "pixel,f32", work: () => exports.f32_shade(count), repeat: 20, count },
    { name: "`f32` by `shade`, a pixel", work: () => f32.shade(...many, out), repeat: 1, count: pixels },
    { name: "`f32` `project` and `collapse`", file: "light,f32", work: () => f32.project() && f32.collapse(), repeat: 50, count: 1 },
    { name: "`q15`, a pixel", file: "pixel,q15", work: () => exports.q15_shade(count), repeat: 4, count },
    { name: "`q31`, a pixel", file: "pixel,q31", work: () => exports.q31_shade(count), repeat: 4, count },
  ];
  // Engines compile in the background what runs often.
  for (let turn = 0; turn < 20; turn++) {
    for (const { work, repeat } of tasks) for (let k = 0; k < repeat; k++) work();
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  return medians(tasks).map((time, k) => ({ ...tasks[k], time }));
}

const all = [];
for (const variant of VARIANTS) all.push(await times(variant));
const ratios = all.map((rows) => rows[1].time / rows[0].time);
const lines = ["| ns | without SIMD | with SIMD |", "|---|---:|---:|"];
all[0].forEach(({ name }, k) => {
  const numbers = all.map((rows) => (rows[k].time < 100 ? rows[k].time.toPrecision(2) : thousands(Math.round(rows[k].time / 100) * 100)));
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
if (process.argv.includes("--times")) {
  const found = all.flatMap((rows, simd) =>
    rows.filter(({ file }) => file).map(({ file, time }) => `${simd},${file},${time.toPrecision(3)}`),
  );
  const head = ["# node crates/wasm/measure.mjs --times", "simd,operation,format,ns"];
  writeFileSync(TIMES, `${[...head, ...found].join("\n")}\n`);
}
if (ratios[1] > MOST) {
  console.error(`error: a full pixel costs ${ratios[1].toFixed(1)} nine-term pixels, ${MOST} at most`);
  process.exitCode = 1;
}
