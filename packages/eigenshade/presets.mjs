// node presets.mjs: writes each shipped light and material to a file of its own, f32 in
// little-endian, all red, all green, all blue, and the gloss of a material; the sources of each
// light with the number that a material needs, and all names. Also src/roughness-weights.js.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";

/** The fields of each row of a file of `tables/inputs`. */
function rows(file) {
  const text = readFileSync(new URL(`../../tables/inputs/${file}`, import.meta.url), "utf8");
  return text.trim().split("\n").filter((line) => !line.startsWith("#")).slice(1).map((line) => line.split(","));
}

/** By name, the numbers of each row from the field `first` on, `count` or all. */
function byName(file, first, count) {
  const all = new Map();
  for (const [name, ...fields] of rows(file)) {
    if (!all.has(name)) all.set(name, []);
    all.get(name).push(fields.slice(first - 1, count && first - 1 + count).map(Number));
  }
  return all;
}
const [sources, gloss] = [byName("sources.csv", 1, 7), byName("gloss.csv", 1, 10)];

/** A light, a number of sources, degree, order and base, and the errors: mean, p95. */
const errors = rows("sources.errors.csv");

/** The roughness of the measured materials; errors are linear in its square between them. */
const KNOTS = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
/** The most sources, the degree and order of the presets, and their numbers of coefficients. */
const MOST = 8;
const SIZE = ["9", "7"];
const COUNTS = { light: 100, material: 40 };

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
    const rows = errors
      .filter(([light, count, degree, order, of]) => light === name && count <= MOST && degree === SIZE[0] && order === SIZE[1] && of === base)
      .map(([, count, , , , ...values]) => ({ count: Number(count), mean: values.slice(0, 6).map(Number), p95: values.slice(6, 12).map(Number) }))
      .sort((one, other) => one.count - other.count);
    if (!rows.length) continue;
    const steps = [];
    for (let k = 1; k <= 600; k++) {
      const roughness = k / 1000;
      const over = ({ mean, p95 }) => Math.max(interpolated(mean, roughness) / 2, interpolated(p95, roughness) / 5);
      let best = rows[0];
      for (const row of rows) {
        if (over(best) <= 1) break;
        if (over(row) < over(best)) best = row;
      }
      if (steps.at(-1)?.[2] === best.count) steps.at(-1)[1] = roughness;
      else steps.push([Number(base === "metal"), roughness, best.count]);
    }
    steps.at(-1)[1] = 1;
    all.push(...steps);
  }
  return all;
}

const names = { light: [], material: [] };
mkdirSync("presets/sources", { recursive: true });

/** Writes the entries of a file, whose coefficients begin at the field `first`: r, g, b, or one value. */
function write(kind, file, first) {
  mkdirSync(`presets/${kind}`, { recursive: true });
  for (const [name, coefficients] of byName(file, first)) {
    const channel = (k) => coefficients.slice(0, COUNTS[kind]).map((values) => values[values.length === 1 ? 0 : k]);
    const ofGloss = kind === "material" ? gloss.get(name) ?? [] : [];
    const numbers = [channel(0), channel(1), channel(2), ofGloss].flat(2);
    writeFileSync(`presets/${kind}/${name}.bin`, Float32Array.from(numbers));
    if (kind === "light") {
      const steps = needed(name);
      const numbers = [steps.length, ...steps.flat(), ...(sources.get(name) ?? []).flat()];
      writeFileSync(`presets/sources/${name}.bin`, Float32Array.from(numbers));
    }
    names[kind].push(name);
  }
}
write("light", "lights.csv", 3);
write("material", "merl.csv", 4);
write("material", "materials.csv", 4);
writeFileSync("presets/names.json", JSON.stringify(names));

const weights = rows("roughness-weights.csv").map((row) => `  ${row.slice(1).map(Number).join(", ")},`);
writeFileSync("src/roughness-weights.js", `// node presets.mjs: the weights of the images of five roughnesses at equally spaced roughnesses from
// 0.2 to 1.

/** The roughnesses that have images. */
export const KNOTS = [0.2, 0.35, 0.6, 0.825, 1];

/** The weights of each row. */
export const WEIGHTS = [
${weights.join("\n")}
];
`);
