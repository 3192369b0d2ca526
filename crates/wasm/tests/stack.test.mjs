// The stack that each call uses.

import assert from "node:assert/strict";
import { test } from "node:test";
import { PAIRS, normals, row } from "./support/golden.mjs";
import { VARIANTS, bytes } from "./support/modules.mjs";
import { load } from "../eigenshade.mjs";

/** The stack size that `build` sets. The stack is at the start of memory and grows down. */
const STACK = 8192;

const MARK = 0xa5;

/** Bytes of the stack that this call writes to. */
function depth(exports, call) {
  const stack = new Uint8Array(exports.memory.buffer, 0, STACK).fill(MARK);
  call();
  const lowest = stack.findIndex((byte) => byte !== MARK);
  return lowest < 0 ? 0 : STACK - lowest;
}

for (const variant of VARIANTS) {
  test(`every call of floats${variant}.wasm uses at most half of the stack`, async () => {
    const { exports, f32 } = await load(bytes("floats", variant));
    assert.ok(exports.memory.buffer.byteLength <= 2 * 65536, "README.md says two pages");
    f32.light(row("f32", "light", PAIRS[0]).numbers);
    f32.material(row("f32", "material", PAIRS[0]).numbers);
    const depths = [
      depth(exports, () => f32.relight()),
      depth(exports, () => f32.collapse()),
      depth(exports, () => f32.bake()),
      depth(exports, () => f32.lookUp(...normals("f32", Float32Array))),
    ];
    assert.ok(Math.max(...depths) > 0, "a collapsed scene is on the stack");
    assert.ok(Math.max(...depths) <= STACK / 2, `${depths} bytes`);
  });

  test(`every call of all${variant}.wasm uses at most half of the stack`, async () => {
    const { exports, ...formats } = await load(bytes("all", variant));
    assert.ok(exports.light.value >= STACK, "the stack must be at the start of memory");
    assert.ok(exports.memory.buffer.byteLength <= 2 * 65536, "README.md says two pages");
    for (const name of ["f32", "q15", "q31"]) {
      const format = formats[name];
      format.light(row("f32", "light", PAIRS[0]).numbers);
      format.material(row("f32", "material", PAIRS[0]).numbers);
      const depths = [
        depth(exports, () => format.project()),
        depth(exports, () => format.collapse()),
        depth(exports, () => format.shade(...normals("f32", Float32Array))),
      ];
      assert.ok(Math.max(...depths) > 0, "a collapsed scene is on the stack");
      assert.ok(Math.max(...depths) <= STACK / 2, `${name}: ${depths} bytes`);
    }
  });
}
