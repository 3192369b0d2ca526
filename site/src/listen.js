// The page's controls change the state.

import { EFFECTS } from "../eigenshade/src/index.js";
import { find } from "./dom.js";
import * as measure from "./measure.js";
import { percent } from "./plot.js";
import { COMPONENTS, initial } from "./state.js";
import { IDENTITY } from "./turn.js";

const still = matchMedia("(prefers-reduced-motion: reduce)");

/** @typedef {import("./state.js").State} State */

/**
 * What controls do.
 *
 * @typedef {object} Page
 * @property {() => State} state
 * @property {() => import("./scenes.js").Scenes} scenes
 * @property {(parts: Partial<State>) => void} set changes parts that need no files
 * @property {(parts: Partial<State>) => Promise<string>} take changes the light or the material
 */

const on = (/** @type {string} */ id, /** @type {string} */ event, /** @type {(control: any) => void} */ run) =>
  find(id).addEventListener(event, () => run(find(id)));
/** Calls back for a radio button of this name that is chosen. */
const onChoice = (/** @type {string} */ name, /** @type {(value: string) => void} */ run) => {
  for (const input of /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll(`input[name=${name}]`))) {
    input.addEventListener("change", () => run(input.value));
  }
};

/** Listens to all controls of the panels but tabs and files. */
export function listen(/** @type {Page} */ page) {
  const { set, take } = page;
  on("step", "input", ({ value }) => set({ step: Number(value) }));
  on("exposure", "input", ({ value }) => set({ exposure: Number(value) }));
  on("light", "change", ({ value }) => take({ light: value }));
  on("upright", "click", () => set({ turn: [...IDENTITY], pose: page.state().object === "relief" ? initial().pose : [...IDENTITY] }));
  on("automatic", "change", ({ value }) => set({ automatic: Number(value) }));
  on("has-shadows", "change", ({ checked }) => set({ shadows: checked }));
  // The switches do not exist yet.
  on("switches", "change", () => set({ effects: EFFECTS.filter((effect) => find(`effect-${effect}`).checked) }));
  for (const id of ["base-color", "metallic", "roughness"]) {
    on(id, "input", () =>
      take({
        material: {
          baseColor: find("base-color").value,
          metallic: Number(find("metallic").value),
          roughness: Number(find("roughness").value),
        },
      }),
    );
  }
  onChoice("sources", (value) => take({ sources: value === "auto" ? value : Number(value) }));
  for (const name of ["object", "view", "drag"]) onChoice(name, (value) => set({ [name]: value }));
  on("choose", "click", () => choose(page));
  grows(page);
}

/** Chooses effects and terms. */
function choose(/** @type {Page} */ page) {
  const [{ scratch, loaded, exposure }, state] = [page.scenes(), page.state()];
  if (!loaded) return;
  scratch.light(loaded.light).material(loaded.material).turn(state.turn);
  const found = measure.automatic(scratch, exposure, state.automatic / 100);
  scratch.turn(IDENTITY);
  if (!found) return;
  page.set({ effects: found.effects, step: found.step, components: COMPONENTS });
  const names = found.effects.length === EFFECTS.length ? "all effects" : found.effects.join(", ") || "no effect";
  find("chosen").textContent = `Chose ${names} and ${found.terms} terms: they leave out ${percent(found.rms)} of white rms, worst pixel ${percent(found.worst)}.`;
}

/** Listens to the slider of eigenimages, and to the button that moves it. */
function grows(/** @type {Page} */ { state, set }) {
  let growing = 0;
  function stop() {
    clearInterval(growing);
    growing = 0;
    find("grow").textContent = "Grow";
  }
  on("components", "input", ({ value }) => {
    stop();
    set({ components: Number(value) });
  });
  on("grow", "click", () => {
    if (growing) return stop();
    find("grow").textContent = "Stop";
    set({ components: 0, step: measure.ALL_TERMS });
    growing = setInterval(() => {
      if (state().components >= COMPONENTS) return stop();
      set({ components: state().components + 1 });
    }, still.matches ? 1000 : 120);
  });
}
