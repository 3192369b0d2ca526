// node presets.mjs PROGRAM: writes each shipped light and material to a file of its own, f32 in
// little-endian, all red, all green, all blue; and their names.

import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";

const [program] = process.argv.slice(2);
const run = (...options) => JSON.parse(execFileSync(program, options, { maxBuffer: 1 << 28 }));

const names = { light: [], material: [] };
for (const { kind, name } of run("list", "--json")) {
  const found = run("export", "--lang", "json", `--${kind}`, name);
  const { shape, values } = found[`${kind}s`];
  const [, channels, count] = shape;
  const numbers = new Float32Array(3 * count);
  for (let channel = 0; channel < 3; channel++) {
    const from = Math.min(channel, channels - 1) * count;
    numbers.set(values.slice(from, from + count), channel * count);
  }
  mkdirSync(`presets/${kind}`, { recursive: true });
  writeFileSync(`presets/${kind}/${name}.bin`, numbers);
  names[kind].push(name);
}
writeFileSync("presets/names.json", JSON.stringify(names));
