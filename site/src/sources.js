// What the page says of small sources.

import { EFFECTS } from "../eigenshade/src/index.js";
import { find } from "./dom.js";
import { counted } from "./plot.js";
import { screenText } from "./screen.js";

/**
 * Lines of `eigenshade/errors.csv`: light, roughness, sources, and the screen error against direct
 * integration, mean and 95th percentile; each light twice, the second time turned.
 */
let errors = /** @type {string[][]} */ ([]);

/** Fetches the errors. */
export async function loadErrors() {
  const text = await (await fetch(new URL("../eigenshade/errors.csv", import.meta.url))).text();
  errors = text.trim().split("\n").map((line) => line.split(","));
}

const roughnessOf = (/** @type {any} */ material) => material.roughness ?? material.gloss?.[0];

/**
 * The error of all terms against direct integration, of the metal under this light whose roughness is
 * next to the material's, with as many sources; `undefined` where it is not known.
 *
 * @param {import("./state.js").State} state
 * @param {any} inputs
 * @param {import("../eigenshade/src/index.js").Scene} scene
 * @returns {import("./screen.js").Direct | undefined}
 */
export function directError({ light, effects }, { material }, { sources: drawn, isGlossy }) {
  if (!isGlossy || effects.length < EFFECTS.length) return undefined;
  const away = (/** @type {string} */ rough) => Math.abs(Number(rough) - roughnessOf(material));
  const [nearest] = errors.map(([, rough]) => rough).sort((a, b) => away(a) - away(b));
  // Not every number of sources was measured, and fewer are not nearer.
  const known = errors.map(([, , sources]) => Number(sources));
  const count = Math.max(...known.filter((sources) => sources <= drawn));
  const found = errors.filter(([name, rough, sources]) => name === light && rough === nearest && Number(sources) === count);
  if (!found.length) return undefined;
  const [mean, p95] = [3, 4].map((column) => Math.max(...found.map((row) => Number(row[column]))));
  return { light, roughness: Number(nearest), sources: count, error: { mean, most: p95 } };
}

/**
 * How many sources are drawn, and what degree 9 leaves with them.
 *
 * @param {import("./state.js").State} state
 * @param {any} inputs
 * @param {import("../eigenshade/src/index.js").Scene} scene
 */
export function showSources(state, inputs, scene) {
  const { light, material } = inputs;
  const why = !light.sources?.length
    ? "this light has none"
    : state.effects.length < EFFECTS.length
      ? "effects are left out"
      : roughnessOf(material) === undefined
        ? "this material has no gloss"
        : scene.isGlossy ? "this material needs none" : "this material is matte";
  const text = scene.sources ? `${counted(scene.sources, "source")} drawn.` : state.sources ? `None drawn: ${why}.` : "";
  // Screen readers read it again whenever it is written.
  if (find("sources-drawn").textContent !== text) find("sources-drawn").textContent = text;
  const direct = directError(state, inputs, scene);
  find("degree").textContent = direct ? screenText(direct.error) : "-";
}
