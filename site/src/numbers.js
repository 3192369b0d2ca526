// The numbers beside the picture: its errors, costs, times and effects, and their plot.

import { EFFECTS } from "../eigenshade/src/index.js";
import { BOARDS, instructions } from "./boards.js";
import { find } from "./dom.js";
import * as measure from "./measure.js";
import { shadeNine } from "./nine.js";
import { counted, mark, percent, plot } from "./plot.js";
import { colorsOf, screenError, screenText, verdict, wholeVerdict } from "./screen.js";
import { directError, showSources } from "./sources.js";
import { IDENTITY } from "./turn.js";

/** @typedef {import("./scenes.js").Scenes} Scenes */
/** @typedef {import("./state.js").State} State */

let reference = /** @type {measure.Picture} */ (/** @type {unknown} */ (undefined));
let now = { terms: 0, rms: 0, worst: 0 };
let nineError = { rms: 0, worst: 0 };

/**
 * The error of the picture on a screen, that of the terms that are left out, and costs by counts.
 *
 * @param {State} state
 * @param {Scenes} scenes
 * @param {boolean} isModel whether an object is shown with its own materials
 */
export function showNumbers(state, scenes, isModel) {
  const { ours, whole, best, exposure } = scenes;
  reference = measure.pictureOf(whole);
  const shown = measure.pictureOf(ours);
  const expected = colorsOf(measure.pictureOf(best), exposure);
  const screen = (/** @type {measure.Picture} */ picture) => screenError(colorsOf(picture, exposure), expected);
  now = { terms: ours.terms, ...measure.errorOf(shown, reference, exposure) };
  const { terms, rms, worst } = now;
  const direct = directError(state, scenes.loaded, ours);
  const said = direct
    ? wholeVerdict(screenError(colorsOf(shown, exposure), colorsOf(reference, exposure)), direct)
    : verdict(screen(shown), best.sources);
  find("verdict").textContent = isModel ? "Its own materials, with all terms" : said.error;
  find("against").textContent = isModel ? "The numbers are those of a sphere of the chosen material" : said.against;
  find("cost").textContent = isModel ? "" : `${counted(terms, "term")}${ours.sources ? ` + ${counted(ours.sources, "source")}` : ""}`;
  showSources(state, scenes.loaded, ours);
  find("rms").textContent = percent(rms);
  find("worst").textContent = percent(worst);
  find("terms").textContent = String(terms);
  for (const [id, board] of [["m0", BOARDS[0]], ["m4f", BOARDS[1]]]) {
    const count = Math.round(instructions(/** @type {any} */ (board), terms, ours.sources) / 10) * 10;
    find(/** @type {string} */ (id)).textContent = `${count.toLocaleString("en")} instr.`;
  }
  const nine = shadeNine(scenes.nine, state.turn, measure.NORMALS);
  nineError = measure.errorOf(nine, reference, exposure);
  find("nine-screen").textContent = screenText(screen(nine));
  mark(find("plot"), now, nineError);
}

/** Of what the curve was measured. */
let curved = "";

/**
 * What takes tens of milliseconds: the curve, times, and effects of the picture whose numbers were
 * shown last.
 *
 * @param {State} state
 * @param {Scenes} scenes
 */
export function showMeasured(state, scenes) {
  const { ours, scratch, exposure } = scenes;
  const what = JSON.stringify([scenes.accepted, state.turn, state.effects, state.components]);
  if (curved !== what) {
    curved = what;
    plot(find("plot"), measure.curveOf(ours, reference, exposure));
    ours.within(measure.toleranceOf(state.step), exposure);
    mark(find("plot"), now, nineError);
  }
  const { light, material } = /** @type {import("./scenes.js").Inputs} */ (scenes.loaded);
  const times = measure.timesOf(ours, light);
  find("light-time").textContent = `${Number((1e6 * times.light).toPrecision(2))} µs`;
  find("pixel-time").textContent = `${Number((1e9 * times.pixel).toPrecision(2))} ns`;
  // Effects are those of light without sources.
  scratch.light({ ...light, sources: [] }).material(material).turn(state.turn).components(state.components);
  const parts = measure.effectsOf(scratch, exposure, measure.toleranceOf(state.step));
  for (const effect of EFFECTS) {
    const { share, saved } = parts[effect];
    find(`share-${effect}`).textContent = percent(share);
    find(`saved-${effect}`).textContent =
      saved > 0 ? `leaving it out saves ${saved} terms` : saved < 0 ? `leaving it out takes ${-saved} more terms` : "leaving it out saves no terms";
  }
  scratch.components().turn(IDENTITY);
}
