// The modules: no import, as a reachable panic would be, and at most half of the stack in use.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { Scene, lightPreset, load, sphere } from "../src/index.js";
import { takeRelaxedSimd } from "./support/relaxed.js";

/** The stack size that `crates/wasm/build` sets. The stack is at the start of memory and grows down. */
const STACK = 65536;

const MARK = 0xa5;

takeRelaxedSimd();
const folder = new URL("../wasm/", import.meta.url);
const names = readdirSync(folder);
test("each module has three variants, but that of objects with shadows", () => {
  const expected = ["", ".sources"].flatMap((kind) => ["", ".relaxed", ".simd"].map((variant) => `eigenshade${kind}${variant}.wasm`));
  assert.deepEqual(names.toSorted(), [...expected, "eigenshade.shadowed.wasm"].toSorted());
});
for (const name of names) {
  const bytes = readFileSync(new URL(name, folder));

  test(`${name} cannot panic and imports nothing`, () => {
    assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), []);
  });

  // Its calls are those of another test.
  if (name === "eigenshade.shadowed.wasm") continue;

  test(`every call of ${name} uses at most half of the stack`, async () => {
    const engine = await load(bytes);
    const memory = engine.light.buffer;
    const before = memory.byteLength;
    assert.ok(engine.light.byteOffset >= STACK, "the stack must be at the start of memory");
    const sources = engine.hasSources ? 8 : 0;
    const scene = await Scene.create({ light: "lobby", material: "gold-metallic-paint", sources, engine });
    assert.equal(scene.sources, sources);
    const light = await lightPreset("lobby", { sources });
    const depths = [
      () => scene.light(light).shade([0], [0], [1]),
      () => scene.material({ baseColor: "#b87333" }).turn({ yaw: 1 }).coefficients(),
      () => scene.within(1e-3).shade([0], [0], [1]),
      () => scene.within().pixels([0], [0.6], [0.8]),
      () => sphere(scene, 200),
      () => scene.uniforms(),
      () => scene.glsl() + scene.wgsl(),
    ].map((call) => {
      const stack = new Uint8Array(memory, 0, STACK).fill(MARK);
      call();
      const lowest = stack.findIndex((byte) => byte !== MARK);
      return lowest < 0 ? 0 : STACK - lowest;
    });
    console.log(`${name}: ${depths} bytes`);
    assert.ok(Math.max(...depths) > 1000 && Math.max(...depths) <= STACK / 2, `${depths} bytes`);
    assert.equal(engine.light.buffer.byteLength, before, "memory does not grow");
  });
}
