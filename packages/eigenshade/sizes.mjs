// node packages/eigenshade/sizes.mjs [--write]: prints the sizes of the package's entries, or writes
// them to README.md.

import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const file = (path) => new URL(path, import.meta.url);
const README = file("README.md");
const MARKS = ["<!-- node packages/eigenshade/sizes.mjs --write -->\n", "<!-- end -->"];

/** Bytes of a file with gzip -9. */
const zipped = (path) => gzipSync(readFileSync(file(path)), { level: 9 }).length;

/** The scripts that entries import at once, without those that are loaded later. */
function scripts(names) {
  const found = new Set(names);
  for (const name of found) {
    const text = readFileSync(file(`dist/${name}`), "utf8");
    for (const [, path] of text.matchAll(/(?:from|import)"\.\/([^"]+)"/g)) found.add(path);
  }
  return [...found];
}

/** The module of a scene with sources for a browser with all kinds of SIMD. */
const MODULE = "wasm/eigenshade.sources.relaxed.wasm";

/** The same in a script of `eigenshade/bundled`, which has no module with relaxed SIMD. */
const bundled = () =>
  `dist/bundled/${readdirSync(file("dist/bundled")).find((name) => name.startsWith("eigenshade.sources.simd-"))}`;

/** The name, the scripts and the module of each entry. */
const entries = () => [
  ["`eigenshade`", ["index.js"], MODULE],
  ["`eigenshade/element`", ["element.js"], MODULE],
  ["`eigenshade/react`", ["react.js"], MODULE],
  ["`eigenshade/three`", ["three.js", "index.js"], MODULE],
  ["`eigenshade/shadowed`", ["shadowed.js"], "wasm/eigenshade.shadowed.wasm"],
  ["`eigenshade` with `eigenshade/bundled`", ["index.js", "bundled.js"], bundled()],
];

/** Bytes with gzip of the JavaScript, the WebAssembly and both, by the name of the entry. */
export function sizes() {
  return entries().map(([name, entry, module]) => {
    const javascript = scripts(entry).reduce((sum, script) => sum + zipped(`dist/${script}`), 0);
    const wasm = zipped(module);
    return [name, javascript, wasm, javascript + wasm];
  });
}

function table() {
  const rows = sizes().map(([name, ...bytes]) => `| ${name} | ${bytes.map((one) => one.toLocaleString("en-US")).join(" | ")} |`);
  return ["| bytes with gzip -9 | JavaScript | WebAssembly | total |", "|---|---:|---:|---:|", ...rows, ""].join("\n");
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
