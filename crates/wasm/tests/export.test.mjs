// What `eigenshade export --lang js` writes goes into a module as it is.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { row } from "./support/golden.mjs";
import { bytes } from "./support/modules.mjs";
import { load } from "../eigenshade.mjs";

const ROOT = fileURLToPath(new URL("../../../", import.meta.url));
const PROGRAM = `${process.env.CARGO_TARGET_DIR ?? "target"}/debug/eigenshade`;
const [LIGHT, MATERIAL] = ["park", "07-velvet"];

/** What the program prints. */
function eigenshade(options) {
  return execFileSync(PROGRAM, options, { cwd: ROOT, encoding: "utf8", maxBuffer: 2 ** 26 });
}

/** The module of a light and a material. */
async function exported(light = LIGHT, material = MATERIAL) {
  const text = eigenshade(["export", "--lang", "js", "--light", light, "--material", material]);
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

test("the README's sphere in integers is the program's, bit for bit", async () => {
  const { lights, materials } = await exported("lobby", "gold-metallic-paint");
  const readme = readFileSync(new URL("../README.md", import.meta.url), "utf8");
  const [, code] = readme.match(/```js\n(\/\/ A gold sphere[^]*?)```/);
  const draw = new Function("q15", "lights", "materials", `${code}; return { normals, picture };`);
  const { q15 } = await load(bytes("q15", ""));
  const { normals, picture } = draw(q15, lights, materials);

  const [x, y, z] = normals;
  const folder = mkdtempSync(join(tmpdir(), "eigenshade-"));
  const file = join(folder, "normals.csv");
  writeFileSync(file, ["x,y,z", ...x.map((_, k) => [x[k], y[k], z[k]].join())].join("\n"));
  const options = ["shade", "--table", "sphere", "--light", "lobby", "--format", "q15"];
  options.push("--material", "gold-metallic-paint", "--normals", file, "--method", "polynomial");
  const rows = eigenshade(options).trimEnd().split("\n").slice(1);
  rmSync(folder, { recursive: true });
  const expected = rows.map((row) => row.split(",").slice(3).map(Number));
  const found = x.map((_, k) => picture.map((channel) => channel[k]));
  assert.ok(found.length > 40_000);
  assert.deepEqual(found, expected);
});
