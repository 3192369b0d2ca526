// node packages/eigenshade/sizes.mjs [--write]: prints the sizes of the package's parts, or writes
// them to README.md.

import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { sizes } from "./test/support/module-size.js";

const file = (path) => new URL(path, import.meta.url);
const README = file("README.md");
const MARKS = ["<!-- node packages/eigenshade/sizes.mjs --write -->\n", "<!-- end -->"];

const zipped = (bytes) => gzipSync(bytes, { level: 9 }).length;

/** Bytes with gzip of each part, by its name in the table. */
export function parts() {
  const found = [];
  for (const [name, path] of [
    ["module with relaxed SIMD", "wasm/eigenshade.relaxed.wasm"],
    ["module with SIMD", "wasm/eigenshade.simd.wasm"],
    ["module without SIMD", "wasm/eigenshade.wasm"],
    ["module for sources with relaxed SIMD", "wasm/eigenshade.sources.relaxed.wasm"],
    ["module for sources with SIMD", "wasm/eigenshade.sources.simd.wasm"],
    ["module for sources without SIMD", "wasm/eigenshade.sources.wasm"],
    ["module for objects with shadows", "wasm/eigenshade.shadowed.wasm"],
  ]) {
    const bytes = readFileSync(file(path));
    const { zipped: code } = sizes(bytes);
    found.push([`${name}: code`, code], [`${name}: all, with the tables`, zipped(bytes)]);
  }
  for (const [name, scripts] of [
    ["JavaScript", ["index", "shared"]],
    ["JavaScript with the element", ["element", "shared"]],
    ["JavaScript with the entry for three.js", ["index", "three", "shared"]],
    ["JavaScript of the entry for objects with shadows", ["shadowed", "shared"]],
  ]) {
    const bytes = scripts.map((script) => zipped(readFileSync(file(`dist/${script}.js`))));
    found.push([name, bytes.reduce((sum, one) => sum + one)]);
  }
  for (const [what, kind] of [["a light", "light"], ["sources of a light", "sources"], ["a material", "material"]]) {
    const all = readdirSync(file(`presets/${kind}`));
    const largest = Math.max(...all.map((name) => readFileSync(file(`presets/${kind}/${name}`)).length));
    found.push([`${what}, as it is`, largest]);
  }
  return found;
}

function table() {
  const rows = parts().map(([name, bytes]) => `| ${name} | ${bytes.toLocaleString("en-US")} |`);
  return ["| gzip -9 | bytes |", "|---|---:|", ...rows, ""].join("\n");
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  if (process.argv[2] === "--write") {
    const text = readFileSync(README, "utf8");
    const [before, rest] = text.split(MARKS[0]);
    const [, after] = rest.split(MARKS[1]);
    writeFileSync(README, before + MARKS[0] + table() + MARKS[1] + after);
  } else {
    process.stdout.write(table());
  }
}
