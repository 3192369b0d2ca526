// What the page says of small sources.

import { EFFECTS } from "../eigenshade/src/index.js";
import { find } from "./controls.js";
import { counted, percent } from "./plot.js";

/**
 * Lines of `eigenshade/errors.csv`: light, roughness, sources, rms, worst pixel; each light twice,
 * the second time turned.
 */
let errors = /** @type {string[][]} */ ([]);

/** Fetches the errors. */
export async function loadErrors() {
  const text = await (await fetch(new URL("../eigenshade/errors.csv", import.meta.url))).text();
  errors = text.trim().split("\n").map((line) => line.split(","));
}

/**
 * How many sources are drawn, and what degree 9 leaves with them.
 *
 * @param {import("./state.js").State} state
 * @param {any} inputs
 * @param {import("../eigenshade/src/index.js").Scene} scene
 */
export function showSources(state, { light, material }, { sources: drawn, isGlossy }) {
  const roughness = material.roughness ?? material.gloss?.[0];
  const why = !light.sources?.length
    ? `this light has no set of at most ${state.sources}`
    : state.effects.length < EFFECTS.length
      ? "effects are left out"
      : roughness === undefined ? "this material has no gloss" : "this material is matte";
  const text = drawn ? `${counted(drawn, "source")} drawn.` : state.sources ? `None drawn: ${why}.` : "";
  // Screen readers read it again whenever it is written.
  if (find("sources-drawn").textContent !== text) find("sources-drawn").textContent = text;
  const away = (/** @type {string} */ rough) => Math.abs(Number(rough) - roughness);
  const [nearest] = errors.map(([, rough]) => rough).sort((a, b) => away(a) - away(b));
  const found = isGlossy
    ? errors.filter(([name, rough, count]) =>
      name === state.light && rough === nearest && Number(count) === (drawn && state.sources))
    : [];
  for (const [id, column] of /** @type {[string, number][]} */ ([["degree-rms", 3], ["degree-worst", 4]])) {
    find(id).textContent = found.length ? percent(Math.max(...found.map((row) => Number(row[column])))) : "-";
  }
}
