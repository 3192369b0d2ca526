// Shows the state in the page's controls.

import { EFFECTS } from "../eigenshade/src/index.js";
import { BOARDS } from "./boards.js";
import { CASES } from "./cases.js";
import { find } from "./dom.js";
import * as measure from "./measure.js";
import { percent } from "./plot.js";
import { COMPONENTS } from "./state.js";
import { readable } from "./thumbnails.js";

export const wide = matchMedia("(min-width: 960px)");
const coarse = matchMedia("(pointer: coarse)");

const NAMES = { ambient: "Ambient", hemisphere: "Hemisphere", directional: "Directional" };
const EFFECT_TEXT = {
  ambient: "response to the mean light",
  diffuse: "Lambertian shading",
  broad: "rough and backscattering lobes",
  gloss: "highlights",
};
const OBJECT_TEXT = { sphere: "A sphere", relief: "A shell in relief", coin: "A coin", own: "Your mesh" };

/**
 * Makes all controls show the state.
 *
 * @param {import("./state.js").State} state
 * @param {{ drawing: boolean, hasOwn: boolean, isModel: boolean, turnsLight: boolean, tab: string }} page
 *   whether WebGL draws, there is an object of the user's, it is shown with its own materials, and a
 *   plain drag turns the light; the tab that is shown
 */
export function controls(state, { drawing, hasOwn, isModel, turnsLight, tab: shown }) {
  const check = (/** @type {string} */ name, /** @type {string} */ value) => {
    for (const input of document.querySelectorAll(`input[name="${name}"]`)) {
      /** @type {HTMLInputElement} */ (input).checked = /** @type {HTMLInputElement} */ (input).value === value;
    }
  };
  const set = (/** @type {any} */ control, /** @type {unknown} */ value) => {
    if (control.value !== String(value)) control.value = String(value);
  };
  check("object", state.object);
  check("view", state.view);
  check("sources", String(state.sources));
  check("drag", state.drag);
  check("material", typeof state.material === "string" ? state.material : "");
  find("own-object").hidden = !hasOwn;
  const own = find("light").querySelector("option[value=own]");
  own.hidden = own.disabled = !state.ownLight;
  own.textContent = state.ownLight ? state.ownLight.name : "Your own";
  set(find("light"), state.light);
  set(find("step"), state.step);
  const tolerance = measure.toleranceOf(state.step);
  find("step").setAttribute("aria-valuetext", tolerance ? `within ${percent(tolerance)} of white` : "all terms");
  set(find("exposure"), state.exposure);
  find("exposure-value").textContent = `${state.exposure > 0 ? "+" : ""}${state.exposure} EV`;
  set(find("components"), state.components);
  find("components-value").textContent = `${state.components} of ${COMPONENTS}`;
  set(find("automatic"), state.automatic);
  find("has-shadows").checked = state.shadows;
  set(find("case"), state.case);
  if (typeof state.material !== "string") {
    set(find("base-color"), state.material.baseColor);
    set(find("metallic"), state.material.metallic);
    set(find("roughness"), state.material.roughness);
  }
  for (const effect of EFFECTS) find(`effect-${effect}`).checked = state.effects.includes(effect);
  for (const tab of document.querySelectorAll("[role=tab]")) {
    const panel = /** @type {string} */ (tab.getAttribute("aria-controls"));
    const selected = panel === shown;
    tab.setAttribute("aria-selected", String(selected));
    /** @type {HTMLElement} */ (tab).tabIndex = selected ? 0 : -1;
    find(panel).hidden = !selected && !(wide.matches && panel === "scene");
  }
  const [turns, other] = turnsLight ? ["light", "object"] : ["object", "light"];
  find("hint").textContent = !drawing
    ? "This browser has no WebGL 2: the CPU draws a sphere. Drag or use arrow keys to turn the light."
    : state.object === "sphere"
      ? "Drag or use arrow keys to turn the light: a sphere looks the same from every side."
      : `Drag or use arrow keys to turn the ${turns}; ${coarse.matches ? "two fingers" : "Alt-drag, two fingers or Shift+arrow keys"} turn the ${other}.`;
  const light = state.light === "own" ? state.ownLight?.name : state.light;
  const material = isModel ? "its own materials" : typeof state.material === "string" ? readable(state.material) : "a glTF material";
  find("picture").setAttribute("aria-label", `${OBJECT_TEXT[drawing ? state.object : "sphere"]} of ${material} under the light ${light}`);
}

/**
 * Calls back for a tab that is opened.
 *
 * @param {(tab: string) => void} open
 */
export function onTab(open) {
  const tabs = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[role=tab]")]);
  const openTab = (/** @type {HTMLElement} */ tab) => open(/** @type {string} */ (tab.getAttribute("aria-controls")));
  for (const tab of tabs) {
    tab.addEventListener("click", () => openTab(tab));
    tab.addEventListener("keydown", (event) => {
      const visible = tabs.filter((other) => other.offsetParent);
      const place = visible.indexOf(tab);
      const next = { ArrowRight: place + 1, ArrowLeft: place - 1, Home: 0, End: -1 }[event.key];
      if (next === undefined) return;
      event.preventDefault();
      const other = visible.at(next % visible.length);
      if (!other) return;
      openTab(other);
      other.focus();
    });
  }
}

/**
 * Fills the lists of choices.
 *
 * @param {{ light: string[] }} names
 */
export function fill(names) {
  const options = (/** @type {[string, string][]} */ entries) => entries.map(([value, text]) => new Option(text, value));
  const group = (/** @type {string} */ label, /** @type {HTMLOptionElement[]} */ children) => {
    const element = document.createElement("optgroup");
    element.label = label;
    element.append(...children);
    return element;
  };
  find("light").append(
    group("Captured", options(names.light.map((name) => [name, name.replaceAll("-", " ")]))),
    group("By formula", options(Object.entries(NAMES))),
    group("Yours", options([["own", "Your own"]])),
  );
  find("case").append(...options(Object.entries(CASES).map(([key, { title }]) => [key, title])));
  find("switches").innerHTML = EFFECTS.map(
    (effect) => `<li><label><input type="checkbox" role="switch" id="effect-${effect}" aria-describedby="saved-${effect}">
      <span>${effect[0].toUpperCase()}${effect.slice(1)}: ${EFFECT_TEXT[effect]}</span>
      <span class="share" id="share-${effect}"></span><small id="saved-${effect}"></small></label></li>`,
  ).join("");
  find("model").textContent = BOARDS.map(
    ({ name, base, each, within, source }) => `3 × (${base} + ${each} per term) + ${source} per source for the ${name.replace("Cortex-", "")}, terms within ${(100 * within).toFixed(0)}\u00a0%`,
  ).join(", ");
}
