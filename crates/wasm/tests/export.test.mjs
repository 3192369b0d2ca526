// What `eigenshade export --lang js` writes goes into a module as it is.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { row } from "./support/golden.mjs";
import { bytes } from "./support/modules.mjs";
import { load } from "../eigenshade.mjs";

const ROOT = fileURLToPath(new URL("../../../", import.meta.url));
const PROGRAM = `${process.env.CARGO_TARGET_DIR ?? "target"}/debug/eigenshade`;
const [LIGHT, MATERIAL] = ["park", "07-velvet"];

/** The module of a light and a material. */
async function exported() {
  const options = ["export", "--lang", "js", "--light", LIGHT, "--material", MATERIAL];
  const text = execFileSync(PROGRAM, options, { cwd: ROOT, encoding: "utf8" });
  return import(`data:text/javascript,${encodeURIComponent(text)}`);
}

test("exported lights and materials are those of the golden file", async () => {
  const { lights, materials } = await exported();
  assert.deepEqual(Object.keys(lights), [LIGHT]);
  assert.deepEqual(Object.keys(materials), [MATERIAL]);
  const { f32 } = await load(bytes("f32", ""));
  const pair = `${LIGHT} ${MATERIAL} g`;
  const golden = ["light", "material"].map((what) => row("f32", what, pair).numbers);
  const [light, material] = [lights[LIGHT].g, materials[MATERIAL].g];
  assert.deepEqual([light, material], golden.map((numbers) => Float32Array.from(numbers)));
  const d = f32.light(light).material(material).project();
  assert.deepEqual(d, f32.light(golden[0]).material(golden[1]).project());
  assert.notDeepEqual(d, f32.light(lights[LIGHT].b).project());
});
