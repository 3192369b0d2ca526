// What a module costs and what it needs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { VARIANTS, bytes, sizes } from "./support/modules.mjs";

/** Bytes by gzip -9 of a module of one format but for its data, which are its tables. */
const MOST = 4096;

/** By how much another compiler's module may differ. */
const COMPILERS = 0.03;

const README = readFileSync(new URL("../README.md", import.meta.url), "utf8");

for (const variant of VARIANTS) {
  for (const name of ["f32", "q15", "q31"]) {
    test(`${name}${variant}.wasm without tables is at most ${MOST} bytes`, () => {
      const { zipped } = sizes(bytes(name, variant));
      assert.ok(zipped <= MOST, `${zipped} bytes`);
    });
  }

  // A panic that the compiler cannot rule out would be an import: see src/lib.rs.
  for (const name of ["f32", "q15", "q31", "floats", "all"]) {
    test(`${name}${variant}.wasm cannot panic and needs nothing from outside`, () => {
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
