// The page: controls and state, state and picture.

import { presetNames } from "../eigenshade/src/index.js";
import { CASES, showCase } from "./cases.js";
import { controls, fill, onTab, wide } from "./controls.js";
import { drawCpu } from "./cpu.js";
import { busy, find } from "./dom.js";
import { Drawing, SHOWN } from "./draw.js";
import { opens } from "./files.js";
import { showGallery } from "./gallery.js";
import { listen } from "./listen.js";
import * as measure from "./measure.js";
import { showMeasured, showNumbers } from "./numbers.js";
import { plot } from "./plot.js";
import { turnable } from "./pointers.js";
import { Scenes } from "./scenes.js";
import { Shown } from "./shown.js";
import { loadErrors } from "./sources.js";
import { fromHash, initial, inputsOf, loadable, toHash } from "./state.js";
import { thumbnails } from "./thumbnails.js";
import { dragged, multiply } from "./turn.js";

let state = initial();
let scenes = /** @type {Scenes} */ (/** @type {unknown} */ (undefined));
const shown = new Shown();

const canvas = /** @type {HTMLCanvasElement} */ (find("picture"));
const drawing = Drawing.of(canvas, () => {
  shown.forget();
  say("");
  changed();
});
canvas.addEventListener("webglcontextlost", () =>
  say("The browser has lost the picture and draws it again as soon as it can."),
);

const say = (/** @type {string} */ text) => (find("status").textContent = text);
const fail = (/** @type {string} */ text) => (find("fault").textContent = text);

// ---- inputs to scenes ----

/** Loads: the last one shows its parts and those of the loads that it overtook. */
let loads = 0;
/** @type {Partial<typeof state>} */
let pending = {};

/**
 * Takes parts of a new state, loads what they name, and shows it. A fault leaves all as it was, and
 * is returned.
 */
async function take(/** @type {Partial<typeof state>} */ parts) {
  pending = { ...pending, ...parts };
  const wanted = { ...state, ...pending };
  const turn = ++loads;
  busy(true);
  try {
    const inputs = await inputsOf(wanted);
    if (turn !== loads) return "";
    scenes.accept(inputs);
    [state, pending] = [{ ...state, ...pending }, {}];
    fail("");
    changed();
    return "";
  } catch (fault) {
    const { message } = /** @type {Error} */ (fault);
    if (turn !== loads) return "";
    pending = {};
    fail(message);
    if (scenes.loaded) changed();
    return message;
  }
}

/** Changes parts of the state that need no inputs. */
function set(/** @type {Partial<typeof state>} */ parts) {
  state = { ...state, ...parts };
  changed();
}

// ---- drawing ----

let frame = 0;
let idle = 0;

/** Draws and measures in the next frame, and what takes longer a little later. */
function changed() {
  busy(true);
  // What is measured later is of what was drawn.
  clearTimeout(idle);
  frame ||= requestAnimationFrame(() => {
    frame = 0;
    draw();
  });
}

/** The scene of the state. */
const ours = () =>
  scenes.ours.turn(state.turn).effects(state.effects).components(state.components).within(measure.toleranceOf(state.step), scenes.exposure);

function draw() {
  const { whole, best } = scenes;
  for (const scene of [whole, best]) scene.turn(state.turn);
  const scene = ours();
  const look = { exposure: scenes.exposure * 2 ** state.exposure, pose: state.pose, nine: { terms: scenes.nine, turn: state.turn } };
  const model = shown.modelOf(state);
  const split = state.view === "split" && !model;
  const side = Math.min(1400, Math.max(64, Math.round(canvas.clientWidth * Math.min(2, devicePixelRatio))));
  if (drawing && model && scenes.loaded) {
    drawing.draw([], look, side + (side % 2));
    model.draw(canvas, { light: scenes.loaded.light, turn: state.turn, pose: state.pose, exposure: 2 ** state.exposure }, changed);
  } else if (drawing) {
    shown.give(drawing, state.object);
    const panes = split
      ? [{ scene }, { scene: best }, { scene, shown: SHOWN.nine }, { scene, shown: SHOWN.difference }]
      : [{ scene }];
    // While something turns, terms come and go, and each set of them is a program. Until it rests,
    // the picture has all terms instead of waiting for a long one.
    if (dragging && scene.terms > 60 && !drawing.has(scene)) scene.within();
    drawing.draw(panes, look, side + (side % 2));
    scene.within(measure.toleranceOf(state.step), scenes.exposure);
  } else {
    drawCpu(canvas, scene, split ? best : undefined, look);
  }
  find("captions").hidden = !split;
  showNumbers(state, scenes, Boolean(model));
  showControls();
  showCoin();
  idle = setTimeout(later, 150);
}

/** How many calls show the coin. */
let showing = 0;

/** Shows the coin, if its tab is open. */
async function showCoin() {
  if (shownTab() !== "shadows" || !scenes.loaded) return;
  showing++;
  try {
    const { showShadows } = await import("./shadows.js");
    await showShadows(state, scenes.loaded.light);
  } catch (fault) {
    fail(`The coin cannot be shown: ${/** @type {Error} */ (fault).message}`);
  }
  showing--;
}

/** What takes tens of milliseconds, once nothing changes. */
function later() {
  saveLink();
  if (dragging || showing) {
    idle = setTimeout(later, 150);
    return;
  }
  showMeasured(state, scenes);
  if (shownTab() === "images") showGallery(find("gallery"), scenes.whole, state.components);
  // A change that waits for its frame and what is being loaded are not shown yet.
  busy(frame > 0 || Object.keys(pending).length > 0);
}

/** The tab that is shown: on wide screens the scene has a place of its own. */
const shownTab = () => (wide.matches && state.tab === "scene" ? "accuracy" : state.tab);

const showControls = () =>
  controls(state, { drawing: Boolean(drawing), hasOwn: shown.hasOwn, isModel: Boolean(shown.modelOf(state)), turnsLight: turnsLight(), tab: shownTab() });

// ---- link ----

function saveLink() {
  // Without a hash, the page shows its first sight.
  const hash = toHash(state) || "details";
  if (!find("page").hidden && hash !== location.hash.slice(1)) history.replaceState(null, "", `#${hash}`);
}

/** Links that were opened: the last one is shown. */
let links = 0;

/** Takes the state of a link, without what is wrong in it. */
async function openLink(/** @type {string} */ hash) {
  const link = ++links;
  const before = loads;
  busy(true);
  const { state: wanted, faults } = fromHash(hash, shown.hasOwn);
  if (!Object.hasOwn(CASES, wanted.case)) {
    faults.push(`case: "${wanted.case}" is not one of ${Object.keys(CASES).join(", ")}`);
    wanted.case = initial().case;
  }
  faults.push(...(await loadable(wanted)));
  // What was chosen meanwhile stays.
  if (link !== links || (scenes.loaded && before !== loads)) return;
  const fault = await take(wanted);
  if (fault) faults.push(fault);
  if (!scenes.loaded) await take(initial());
  if (faults.length) fail(`This link is not whole: ${faults.join("; ")}.`);
  refreshCase();
}

find("copy").addEventListener("click", async () => {
  saveLink();
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link is copied.");
  } catch {
    say("The link is in the address bar.");
  }
});

// ---- turning ----

let dragging = false;

/** Whether a plain drag turns the light. A sphere shows no turn of its own. */
const turnsLight = () => state.drag === "light" || state.object === "sphere" || !drawing;

function turnBy(/** @type {number} */ right, /** @type {number} */ down, /** @type {number} */ twist, /** @type {boolean} */ other) {
  const by = dragged(right, down, twist);
  const what = turnsLight() !== other || state.object === "sphere" || !drawing ? "turn" : "pose";
  state[what] = multiply(by, /** @type {any} */ (state[what]));
  changed();
}
const drags = (/** @type {boolean} */ is) => {
  dragging = is;
  if (!is) changed();
};
turnable(canvas, turnBy, drags);
turnable(find("shadowed"), (right, down, twist) => set({ turn: multiply(dragged(right, down, twist), /** @type {any} */ (state.turn)) }), drags);

// ---- controls, files and downloads ----

listen({ state: () => state, scenes: () => scenes, set, take });
opens({ set, take, shown, draws: Boolean(drawing), say, fail });

/** Saves a file of this kind of what is shown. */
export async function download(/** @type {string} */ kind) {
  const [files, { texts, windowOf }] = await Promise.all([import("./download.js"), import("./take.js")]);
  const { light, material, turn, effects, components } = state;
  const scene = ours();
  const seen = {
    light, material, turn, exposure: scenes.exposure * 2 ** state.exposure, sources: scene.sources, window: windowOf(scene),
    effects, components, tolerance: measure.toleranceOf(state.step) ?? 0,
  };
  await files.download(kind, `eigenshade.${kind}`, shown.modelOf(state) ? find("own-picture") : canvas, texts(scene, seen));
}

// ---- tabs ----

onTab((tab) => {
  set({ tab });
  showControls();
  refreshCase();
});
find("case").addEventListener("change", () => {
  set({ case: find("case").value });
  refreshCase();
});
function refreshCase() {
  if (shownTab() === "cases") showCase(state.case).catch((fault) => fail(`The case cannot be shown: ${fault.message}`));
}

// ---- start ----

async function start() {
  const names = await presetNames();
  await loadErrors();
  fill(names);
  plot(find("plot"), []);
  scenes = await Scenes.create();
  thumbnails(find("thumbs"), (material) => take({ material }));
  await openLink(location.hash);
  // By now the page may have replaced its own address.
  addEventListener("hashchange", ({ newURL }) => {
    const { hash } = new URL(newURL);
    if (hash) openLink(hash);
  });
  wide.addEventListener("change", changed);
  new ResizeObserver(changed).observe(canvas);
}

start().catch((fault) => fail(`The page cannot start: ${fault.message}`));
