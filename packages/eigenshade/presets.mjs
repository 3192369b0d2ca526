// node presets.mjs PROGRAM: writes each shipped light and material to a file of its own, f32 in
// little-endian, all red, all green, all blue, and the gloss of a material; the sources of each
// light, and all names.

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";

const [program] = process.argv.slice(2);
const run = (...options) => JSON.parse(execFileSync(program, options, { maxBuffer: 1 << 28 }));

/** The numbers after the name in each line of a file. */
function lines(file, count) {
  const text = readFileSync(new URL(`../../tables/inputs/${file}`, import.meta.url), "utf8");
  const all = text.trim().split("\n").slice(2).map((line) => line.split(","));
  return (name) => all.filter((fields) => fields[0] === name).flatMap((fields) => fields.slice(1, 1 + count).map(Number));
}
const [sources, gloss] = [lines("sources.csv", 11), lines("gloss.csv", 10)];

const names = { light: [], material: [] };
mkdirSync("presets/sources", { recursive: true });
for (const { kind, name } of run("list", "--json")) {
  const found = run("export", "--lang", "json", `--${kind}`, name);
  const { shape, values } = found[`${kind}s`];
  const [, channels, count] = shape;
  const ofGloss = kind === "material" ? gloss(name) : [];
  const numbers = new Float32Array(3 * count + ofGloss.length);
  numbers.set(ofGloss, 3 * count);
  for (let channel = 0; channel < 3; channel++) {
    const from = Math.min(channel, channels - 1) * count;
    numbers.set(values.slice(from, from + count), channel * count);
  }
  mkdirSync(`presets/${kind}`, { recursive: true });
  writeFileSync(`presets/${kind}/${name}.bin`, numbers);
  if (kind === "light") writeFileSync(`presets/sources/${name}.bin`, Float32Array.from(sources(name)));
  names[kind].push(name);
}
writeFileSync("presets/names.json", JSON.stringify(names));
