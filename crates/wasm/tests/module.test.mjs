// The size and the imports of each module.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { VARIANTS, bytes, sizes } from "./support/modules.mjs";

/** Maximum size with gzip -9 of a module of one format, without its data section (the tables). */
const MAX_BYTES = 4096;

/** Relative size difference that another compiler may cause. */
const COMPILERS = 0.03;

const README = readFileSync(new URL("../README.md", import.meta.url), "utf8");

for (const variant of VARIANTS) {
  for (const name of ["f32", "q15", "q31"]) {
    test(`${name}${variant}.wasm without tables is at most ${MAX_BYTES} bytes`, () => {
      const { zipped } = sizes(bytes(name, variant));
      assert.ok(zipped <= MAX_BYTES, `${zipped} bytes`);
    });
  }

  // A reachable panic would be an import: see src/lib.rs.
  for (const name of ["f32", "q15", "q31", "floats", "all"]) {
    test(`${name}${variant}.wasm cannot panic and imports nothing`, () => {
      const module = new WebAssembly.Module(bytes(name, variant));
      assert.deepEqual(WebAssembly.Module.imports(module), []);
    });
  }

  for (const name of ["f32", "q15", "q31", "floats", "all"]) {
    test(`README.md states the size of ${name}${variant}.wasm`, () => {
      const { zipped } = sizes(bytes(name, variant));
      const simd = variant ? "with" : "without";
      const line = README.split("\n").find((text) => text.startsWith(`| \`${name}\`, ${simd} SIMD |`));
      const stated = Number(line?.split("|")[2].replaceAll(",", ""));
      assert.ok(Math.abs(stated - zipped) <= COMPILERS * zipped, `${zipped} bytes, not ${stated}`);
    });
  }
}
