// node presets.mjs PROGRAM: writes each shipped light and material to a file of its own, f32 in
// little-endian, all red, all green, all blue, and the gloss of a material; the sources of each
// light with the number that a material needs, and all names.

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

/** The size, degree, order and base of each measured set of a light, and its errors: mean, p95. */
const errors = readFileSync(new URL("../../tables/inputs/sources.errors.csv", import.meta.url), "utf8")
  .trim().split("\n").slice(2).map((line) => line.split(","));

/** The roughness of the measured materials; errors are linear in its square between them. */
const KNOTS = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
/** The most sources, and the degree and order of the presets. */
const MOST = 8;
const SIZE = ["9", "7"];

function interpolated(values, roughness) {
  const next = KNOTS.findIndex((knot) => roughness <= knot);
  if (next === 0) return values[0];
  const [from, to] = [KNOTS[next - 1] ** 2, KNOTS[next] ** 2];
  return values[next - 1] + ((values[next] - values[next - 1]) * (roughness ** 2 - from)) / (to - from);
}

/**
 * The fewest sources with which pictures are close on a screen, or else those that leave least, as
 * `Estimates::fewest` of the program: steps of 1 for a metal and 0 for a dielectric, the roughness
 * up to which they serve, to 0.001, and their number.
 */
function needed(name) {
  const all = [];
  for (const base of ["metal", "dielectric"]) {
    const sets = errors
      .filter(([light, set, degree, order, of]) => light === name && set <= MOST && degree === SIZE[0] && order === SIZE[1] && of === base)
      .map(([, set, , , , ...values]) => ({ set: Number(set), mean: values.slice(0, 6).map(Number), p95: values.slice(6, 12).map(Number) }))
      .sort((one, other) => one.set - other.set);
    if (!sets.length) continue;
    const steps = [];
    for (let k = 1; k <= 600; k++) {
      const roughness = k / 1000;
      const over = ({ mean, p95 }) => Math.max(interpolated(mean, roughness) / 2, interpolated(p95, roughness) / 5);
      let best = sets[0];
      for (const set of sets) {
        if (over(best) <= 1) break;
        if (over(set) < over(best)) best = set;
      }
      if (steps.at(-1)?.[2] === best.set) steps.at(-1)[1] = roughness;
      else steps.push([Number(base === "metal"), roughness, best.set]);
    }
    steps.at(-1)[1] = 1;
    all.push(...steps);
  }
  return all;
}

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
  if (kind === "light") {
    const steps = needed(name);
    const numbers = Float32Array.from([steps.length, ...steps.flat(), ...sources(name)]);
    writeFileSync(`presets/sources/${name}.bin`, numbers);
  }
  names[kind].push(name);
}
writeFileSync("presets/names.json", JSON.stringify(names));
