// The page: controls and state, state and picture.

import { EFFECTS, Scene, lightPreset, materialPreset, presetNames } from "../eigenshade/src/index.js";
import { BOARDS, instructions } from "./boards.js";
import { CASES, showCase } from "./cases.js";
import { disc, drawCpu, image, show } from "./cpu.js";
import { Drawing, KINDS, SHOWN } from "./draw.js";
import { showGallery } from "./gallery.js";
import { ANALYTIC, ambient } from "./harmonics.js";
import * as measure from "./measure.js";
import { nineTerms, shadeNine } from "./nine.js";
import { coin, coinNormals, parseObj, relief } from "./objects.js";
import { mark, percent, plot } from "./plot.js";
import { COMPONENTS, fromHash, initial, toHash } from "./state.js";
import { IDENTITY, dragged, multiply } from "./turn.js";

const find = (/** @type {string} */ id) => /** @type {any} */ (document.getElementById(id));
const wide = matchMedia("(min-width: 960px)");
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** Materials that have a thumbnail. */
const MATERIALS = [
  "gold-metallic-paint", "two-layer-gold", "brass", "alum-bronze", "silver-metallic-paint", "chrome-steel",
  "aluminium", "tungsten-carbide", "hematite", "black-obsidian", "blue-metallic-paint", "green-metallic-paint",
  "red-metallic-paint", "color-changing-paint1", "color-changing-paint2", "pearl-paint", "red-plastic",
  "yellow-plastic", "green-plastic", "violet-acrylic", "specular-blue-phenolic", "specular-red-phenolic",
  "green-latex", "violet-rubber", "pure-rubber", "red-fabric2", "blue-fabric", "green-fabric", "pink-felt",
  "white-fabric", "cherry-235", "natural-209", "white-marble", "pink-jasper", "orange-paint", "dark-blue-paint",
];

const NAMES = { ambient: "Ambient", hemisphere: "Hemisphere", directional: "Directional" };
const EFFECT_TEXT = {
  ambient: "response to the mean light",
  diffuse: "Lambertian shading",
  broad: "rough and backscattering lobes",
  gloss: "highlights",
};
const OBJECT_TEXT = { sphere: "A sphere", relief: "A shell in relief", coin: "A coin", own: "Your mesh" };

let state = initial();
/** Of the inputs as they are: all terms of all effects, and what is shown. */
let whole = /** @type {Scene} */ (/** @type {unknown} */ (undefined));
let ours = whole;
let scratch = whole;
let loaded = { light: /** @type {any} */ (undefined), material: /** @type {any} */ (undefined) };
let reference = /** @type {measure.Picture} */ (/** @type {unknown} */ (undefined));
let look = { exposure: 1, pose: state.pose, nine: { terms: new Float32Array(27), turn: state.turn } };
let auto = 1;
/** @type {import("./objects.js").Mesh | undefined} */
let ownMesh;
let drawnObject = "";

const canvas = /** @type {HTMLCanvasElement} */ (find("picture"));
const drawing = Drawing.of(canvas, () => {
  drawnObject = "";
  changed();
});

const readable = (/** @type {string} */ name) => name.replace(/^\d+-/, "").replaceAll("-", " ").replace(/\s?\d+$/, "");
const say = (/** @type {string} */ text) => (find("status").textContent = text);
const fail = (/** @type {string} */ text) => (find("fault").textContent = text);

// ---- inputs to scenes ----

/** The scenes' inputs that the state names. Throws for a name that does not exist. */
async function load(/** @type {typeof state} */ wanted) {
  const light =
    wanted.light === "own"
      ? /** @type {any} */ (wanted.ownLight).light
      : Object.hasOwn(ANALYTIC, wanted.light)
        ? ANALYTIC[wanted.light]()
        : await lightPreset(wanted.light, { sources: wanted.sources });
  const material = typeof wanted.material === "string" ? await materialPreset(wanted.material) : wanted.material;
  return { light, material };
}

/** Loads: the last one shows its parts and those of the loads that it overtook. */
let loads = 0;
/** @type {Partial<typeof state>} */
let pending = {};

/** Gives both scenes these inputs, or leaves both as they were. */
function accept(/** @type {typeof loaded} */ { light, material }) {
  const give = (/** @type {typeof loaded} */ inputs) => {
    for (const scene of [whole, ours]) scene.light(inputs.light).material(inputs.material);
  };
  try {
    give({ light, material });
  } catch (fault) {
    if (loaded.light) give(loaded);
    throw fault;
  }
}

/**
 * Takes parts of a new state, loads what they name, and shows it. A fault leaves all as it was, and is
 * returned.
 */
async function take(/** @type {Partial<typeof state>} */ parts) {
  pending = { ...pending, ...parts };
  const wanted = { ...state, ...pending };
  const turn = ++loads;
  busy(true);
  try {
    const inputs = await load(wanted);
    if (turn !== loads) return "";
    accept(inputs);
    [state, loaded, pending] = [{ ...state, ...pending }, inputs, {}];
    const albedo = measure.meanOf(measure.pictureOf(scratch.light(ambient()).material(loaded.material)));
    look.nine.terms = nineTerms(loaded.light, albedo);
    whole.turn(IDENTITY);
    auto = whole.exposure();
    fail("");
    changed();
    return "";
  } catch (fault) {
    const { message } = /** @type {Error} */ (fault);
    if (turn !== loads) return "";
    pending = {};
    fail(message);
    if (loaded.light) changed();
    return message;
  }
}

// ---- drawing ----

let frame = 0;
let idle = 0;

/** Draws and measures in the next frame, and what takes longer a little later. */
function changed() {
  busy(true);
  frame ||= requestAnimationFrame(() => {
    frame = 0;
    draw();
  });
}

function draw() {
  whole.turn(state.turn);
  ours.turn(state.turn).effects(state.effects).components(state.components).within(measure.toleranceOf(state.step));
  look = { exposure: auto * 2 ** state.exposure, pose: state.pose, nine: { terms: look.nine.terms, turn: state.turn } };
  const split = state.view === "split";
  if (drawing) {
    if (drawnObject !== state.object) {
      drawnObject = state.object;
      if (state.object === "sphere") drawing.object(KINDS.sphere);
      if (state.object === "relief") drawing.object(KINDS.mesh, (meshes.relief ??= relief()));
      if (state.object === "own") drawing.object(KINDS.mesh, ownMesh, false);
      if (state.object === "coin") {
        drawing.object(KINDS.map, (meshes.coin ??= coin()));
        drawing.map(512, (meshes.coinNormals ??= coinNormals(512)));
      }
    }
    const panes = split
      ? [{ scene: ours }, { scene: whole }, { scene: ours, shown: SHOWN.nine }, { scene: ours, shown: SHOWN.difference }]
      : [{ scene: ours }];
    // While something turns, terms come and go, and each set of them is a program. Until it rests, the
    // picture has all terms instead of waiting for a long one.
    if (dragging && ours.terms > 60 && !drawing.has(ours)) ours.within();
    const side = Math.min(1400, Math.max(64, Math.round(canvas.clientWidth * Math.min(2, devicePixelRatio))));
    drawing.draw(panes, look, side + (side % 2));
    ours.within(measure.toleranceOf(state.step));
  } else {
    drawCpu(canvas, ours, split ? whole : undefined, look);
  }
  find("captions").hidden = !split;
  numbers();
  controls();
  clearTimeout(idle);
  idle = setTimeout(later, 150);
}

const meshes = /** @type {Record<string, any>} */ ({});
let now = { terms: 0, rms: 0, worst: 0 };
let nineError = { rms: 0, worst: 0 };

/** The error of the picture, and costs by counts. */
function numbers() {
  reference = measure.pictureOf(whole);
  now = { terms: ours.terms, ...measure.errorOf(measure.pictureOf(ours), reference) };
  const { terms, rms, worst } = now;
  find("summary").textContent = `${counted(terms, "term")}${ours.sources ? ` + ${counted(ours.sources, "source")}` : ""} · rms ${percent(rms)} · worst ${percent(worst)}`;
  sources();
  find("rms").textContent = percent(rms);
  find("worst").textContent = percent(worst);
  find("terms").textContent = String(terms);
  for (const [id, board] of [["m0", BOARDS[0]], ["m4f", BOARDS[1]]]) {
    const count = Math.round(instructions(/** @type {any} */ (board), terms, ours.sources) / 10) * 10;
    find(/** @type {string} */ (id)).textContent = `${count.toLocaleString("en")} instr.`;
  }
  nineError = measure.errorOf(shadeNine(look.nine.terms, state.turn, measure.NORMALS), reference);
  find("nine-rms").textContent = percent(nineError.rms);
  find("nine-worst").textContent = percent(nineError.worst);
  mark(find("plot"), now, nineError);
}

const counted = (/** @type {number} */ count, /** @type {string} */ noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;

/** Lines of `eigenshade/errors.csv`: light, roughness, sources, rms, worst pixel; each light twice, turned. */
let errors = /** @type {string[][]} */ ([]);

/** How many sources are drawn, and what degree 9 leaves with them. */
function sources() {
  const { light, material } = loaded;
  const roughness = material.roughness ?? material.gloss?.[0];
  const why = !light.sources?.length
    ? `this light has no set of at most ${state.sources}`
    : state.effects.length < EFFECTS.length
      ? "effects are left out"
      : roughness === undefined ? "this material has no gloss" : "this material is matte";
  find("sources-drawn").textContent =
    ours.sources ? `${counted(ours.sources, "source")} drawn.` : state.sources ? `None drawn: ${why}.` : "";
  const nearest = [0.2, 0.3, 0.5].reduce((best, other) => (Math.abs(other - roughness) < Math.abs(best - roughness) ? other : best));
  const found = roughness < 0.6
    ? errors.filter(([name, rough, count]) => name === state.light && Number(rough) === nearest && Number(count) === (ours.sources && state.sources))
    : [];
  for (const [id, column] of /** @type {[string, number][]} */ ([["degree-rms", 3], ["degree-worst", 4]])) {
    find(id).textContent = found.length ? percent(Math.max(...found.map((row) => Number(row[column])))) : "-";
  }
}

/** The inputs of which the curve was measured. */
let curved = "";

/** What takes tens of milliseconds, once nothing changes. */
function later() {
  saveLink();
  if (dragging) {
    idle = setTimeout(later, 150);
    return;
  }
  const inputs = JSON.stringify([state.turn, state.effects, state.components, loads]);
  if (curved !== inputs) {
    curved = inputs;
    plot(find("plot"), measure.curveOf(ours, reference));
    ours.within(measure.toleranceOf(state.step));
    mark(find("plot"), now, nineError);
  }
  const times = measure.timesOf(ours, loaded.light);
  find("light-time").textContent = `${Number((1e6 * times.light).toPrecision(2))} µs`;
  find("pixel-time").textContent = `${Number((1e9 * times.pixel).toPrecision(2))} ns`;
  // Effects are those of light without sources.
  scratch.light({ ...loaded.light, sources: [] }).material(loaded.material).turn(state.turn).components(state.components);
  const parts = measure.effectsOf(scratch, measure.toleranceOf(state.step));
  for (const effect of EFFECTS) {
    const { share, saved } = parts[effect];
    find(`share-${effect}`).textContent = percent(share);
    find(`saved-${effect}`).textContent =
      saved > 0 ? `leaving it out saves ${saved} terms` : saved < 0 ? `leaving it out takes ${-saved} more terms` : "leaving it out saves no terms";
  }
  scratch.components().turn(IDENTITY);
  if (shownTab() === "images") showGallery(find("gallery"), whole, state.components);
  // What is being loaded is not shown yet.
  busy(Object.keys(pending).length > 0);
}

/** Whether the picture and its numbers are not yet those of the state; tests wait for it. */
const busy = (/** @type {boolean} */ is) => (document.documentElement.dataset.busy = String(is));

// ---- state to controls ----

/** The tab that is shown: on wide screens the scene has a place of its own. */
const shownTab = () => (wide.matches && state.tab === "scene" ? "accuracy" : state.tab);

function controls() {
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
  find("own-object").hidden = !ownMesh;
  const own = find("light").querySelector("option[value=own]");
  own.hidden = own.disabled = !state.ownLight;
  own.textContent = state.ownLight ? state.ownLight.name : "Your own";
  set(find("light"), state.light);
  set(find("step"), state.step);
  const tolerance = measure.toleranceOf(state.step);
  find("step").setAttribute("aria-valuetext", tolerance ? `within ${percent(tolerance)}` : "all terms");
  set(find("exposure"), state.exposure);
  find("exposure-value").textContent = `${state.exposure > 0 ? "+" : ""}${state.exposure} EV`;
  set(find("components"), state.components);
  find("components-value").textContent = `${state.components} of ${COMPONENTS}`;
  set(find("automatic"), state.automatic);
  set(find("case"), state.case);
  if (typeof state.material !== "string") {
    set(find("base-color"), state.material.baseColor);
    set(find("metallic"), state.material.metallic);
    set(find("roughness"), state.material.roughness);
  }
  for (const effect of EFFECTS) find(`effect-${effect}`).checked = state.effects.includes(effect);
  const shown = shownTab();
  for (const tab of document.querySelectorAll("[role=tab]")) {
    const panel = /** @type {string} */ (tab.getAttribute("aria-controls"));
    const selected = panel === shown;
    tab.setAttribute("aria-selected", String(selected));
    /** @type {HTMLElement} */ (tab).tabIndex = selected ? 0 : -1;
    find(panel).hidden = !selected && !(wide.matches && panel === "scene");
  }
  const turns = turnsLight() ? "the light" : "the object";
  find("hint").textContent = !drawing
    ? "This browser has no WebGL 2: the CPU draws a sphere. Drag to turn the light."
    : state.object === "sphere"
      ? "Drag to turn the light: a sphere looks the same from every side."
      : `Drag or use arrow keys to turn ${turns}; with Alt or two fingers, the ${turns === "the light" ? "object" : "light"}.`;
  const light = state.light === "own" ? state.ownLight?.name : state.light;
  const material = typeof state.material === "string" ? readable(state.material) : "a glTF material";
  canvas.setAttribute("aria-label", `${OBJECT_TEXT[drawing ? state.object : "sphere"]} of ${material} under the light ${light}`);
}

// ---- link ----

function saveLink() {
  const hash = toHash(state);
  if (hash !== location.hash.slice(1)) history.replaceState(null, "", hash ? `#${hash}` : location.pathname + location.search);
}

async function openLink() {
  const { state: wanted, faults } = fromHash(location.hash);
  if (wanted.case && !Object.hasOwn(CASES, wanted.case)) wanted.case = initial().case;
  const fault = await take(wanted);
  if (fault) faults.push(fault);
  if (!loaded.light) await take(initial());
  if (faults.length) fail(`This link is not whole: ${faults.join("; ")}.`);
  refreshCase();
}

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

/** @type {Map<number, PointerEvent>} */
const pointers = new Map();
canvas.addEventListener("pointerdown", (event) => {
  if (event.button > 0) return;
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
  dragging = true;
});
canvas.addEventListener("pointermove", (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const scale = 3 / canvas.clientWidth / pointers.size;
  let twist = 0;
  if (pointers.size === 2) {
    const other = [...pointers.values()].find(({ pointerId }) => pointerId !== event.pointerId);
    const angle = (/** @type {PointerEvent} */ at) => Math.atan2(at.clientY - (other?.clientY ?? 0), at.clientX - (other?.clientX ?? 0));
    twist = -Math.atan2(Math.sin(angle(event) - angle(before)), Math.cos(angle(event) - angle(before)));
  }
  pointers.set(event.pointerId, event);
  turnBy(scale * (event.clientX - before.clientX), scale * (event.clientY - before.clientY), twist, event.altKey || pointers.size > 1);
});
for (const end of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(end, (event) => {
    pointers.delete(/** @type {PointerEvent} */ (event).pointerId);
    dragging = pointers.size > 0;
    changed();
  });
}
canvas.addEventListener("keydown", (event) => {
  const [right, down] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
  if (!right && !down) return;
  event.preventDefault();
  turnBy(right * 0.0873, down * 0.0873, 0, event.altKey || event.shiftKey);
});

// ---- controls to state ----

const on = (/** @type {string} */ id, /** @type {string} */ event, /** @type {(control: any) => void} */ run) =>
  find(id).addEventListener(event, () => run(find(id)));

function set(/** @type {Partial<typeof state>} */ parts) {
  state = { ...state, ...parts };
  changed();
}

on("step", "input", ({ value }) => set({ step: Number(value) }));
on("exposure", "input", ({ value }) => set({ exposure: Number(value) }));
on("components", "input", ({ value }) => {
  stopGrowing();
  set({ components: Number(value) });
});
on("light", "change", ({ value }) => take({ light: value }));
on("upright", "click", () => set({ turn: [...IDENTITY], pose: state.object === "relief" ? initial().pose : [...IDENTITY] }));
on("automatic", "change", ({ value }) => set({ automatic: Number(value) }));
on("case", "change", ({ value }) => {
  set({ case: value });
  refreshCase();
});
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
for (const input of document.querySelectorAll("input[name=sources]")) {
  input.addEventListener("change", () => take({ sources: Number(/** @type {HTMLInputElement} */ (input).value) }));
}
for (const name of ["object", "view", "drag"]) {
  for (const input of document.querySelectorAll(`input[name=${name}]`)) {
    input.addEventListener("change", () => set({ [name]: /** @type {HTMLInputElement} */ (input).value }));
  }
}
on("choose", "click", () => {
  scratch.light(loaded.light).material(loaded.material).turn(state.turn);
  const best = measure.automatic(scratch, state.automatic / 100);
  scratch.turn(IDENTITY);
  if (!best) return;
  set({ effects: best.effects, step: best.step, components: COMPONENTS });
  const names = best.effects.length === EFFECTS.length ? "all effects" : best.effects.join(", ") || "no effect";
  find("chosen").textContent = `Chose ${names} and ${best.terms} terms: error ${percent(best.rms)} rms, worst pixel ${percent(best.worst)}.`;
});
on("copy", "click", async () => {
  saveLink();
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link is copied.");
  } catch {
    say("The link is in the address bar.");
  }
});

let growing = 0;
function stopGrowing() {
  clearInterval(growing);
  growing = 0;
  find("grow").textContent = "Grow";
}
on("grow", "click", () => {
  if (growing) return stopGrowing();
  find("grow").textContent = "Stop";
  set({ components: 0, step: measure.ALL_TERMS });
  growing = setInterval(() => {
    if (state.components >= COMPONENTS) return stopGrowing();
    set({ components: state.components + 1 });
  }, still.matches ? 1000 : 120);
});

// ---- tabs ----

const tabs = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[role=tab]")]);
function openTab(/** @type {HTMLElement} */ tab) {
  set({ tab: /** @type {string} */ (tab.getAttribute("aria-controls")) });
  controls();
  refreshCase();
}
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
/** The hard case that is shown; drawn once. */
let shownCase = "";
function refreshCase() {
  if (shownTab() !== "cases" || shownCase === state.case) return;
  shownCase = state.case;
  showCase(state.case, {
    ours: find("case-ours"), naive: find("case-naive"), oursCaption: find("case-ours-caption"),
    naiveCaption: find("case-naive-caption"), text: find("case-text"),
  });
}

// ---- files ----

on("open-light", "click", () => find("file").click());
on("open-mesh", "click", () => find("file").click());
on("file", "change", (input) => {
  if (input.files[0]) open(input.files[0]);
  input.value = "";
});
let depth = 0;
addEventListener("dragenter", (event) => {
  event.preventDefault();
  depth++;
  document.body.classList.add("dropping");
});
addEventListener("dragleave", () => {
  if (--depth <= 0) document.body.classList.remove("dropping");
});
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", (event) => {
  event.preventDefault();
  depth = 0;
  document.body.classList.remove("dropping");
  const [file] = event.dataTransfer?.files ?? [];
  if (file) open(file);
});

/** Most bytes of a file. */
const LARGEST = 512 * 2 ** 20;

async function open(/** @type {File} */ file) {
  fail("");
  say(`Reading ${file.name}`);
  try {
    if (file.size === 0) throw new Error("it is empty");
    if (file.size > LARGEST) throw new Error("it is larger than 512 MB");
    if (/\.obj$/i.test(file.name)) {
      const mesh = parseObj(await file.text());
      ownMesh = mesh;
      drawnObject = "";
      set({ object: "own" });
      say(`${file.name}: ${mesh.indices.length / 3} triangles.`);
      if (!drawing) say(`${file.name} is read, but without WebGL 2 only spheres are drawn.`);
    } else {
      const { light, width, height } = await panorama(file);
      const fault = await take({ light: "own", ownLight: { name: file.name.slice(0, 80), light } });
      if (fault) throw new Error(fault);
      const shape = width === 2 * height ? "" : " It is not twice as wide as high; it is read as equirectangular.";
      say(`${file.name}: ${width} × ${height}, projected to degree 9.${shape}`);
    }
  } catch (fault) {
    say("");
    fail(`${file.name} cannot be used: ${/** @type {Error} */ (fault).message}. The picture is as it was.`);
  }
}

/** Seconds that a worker may say nothing. */
const PATIENCE = 60;

/** Ends the worker of the last panorama. Nothing is said of it any more. */
let end = () => {};

/** The light of a panorama, by a worker. A new one ends the one before. */
function panorama(/** @type {File} */ file) {
  end();
  const worker = new Worker(new URL("panorama.js", import.meta.url), { type: "module" });
  return new Promise((resolve, reject) => {
    /** @type {ReturnType<typeof setTimeout>} */
    let patience;
    end = () => {
      clearTimeout(patience);
      worker.terminate();
    };
    const refuse = (/** @type {string} */ why) => {
      end();
      reject(new Error(why));
    };
    const wait = () => {
      clearTimeout(patience);
      patience = setTimeout(() => refuse(`it is not read after ${PATIENCE} seconds`), 1000 * PATIENCE);
    };
    wait();
    worker.addEventListener("message", ({ data }) => {
      if (data.stage) {
        wait();
        say(data.stage === "decoding" ? `${file.name}: decoding` : `${file.name}: projecting, ${Math.round(100 * data.share)} %`);
        return;
      }
      if (data.fault) return refuse(data.fault);
      end();
      resolve(data);
    });
    worker.addEventListener("error", (event) => refuse(event.message || "the decoder cannot be loaded"));
    worker.postMessage({ file, name: file.name });
  });
}

// ---- start ----

async function start() {
  const names = await presetNames();
  const text = await (await fetch(new URL("../eigenshade/errors.csv", import.meta.url))).text();
  errors = text.trim().split("\n").map((line) => line.split(","));
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
  for (const effect of EFFECTS) {
    on(`effect-${effect}`, "change", ({ checked }) =>
      set({ effects: EFFECTS.filter((other) => (other === effect ? checked : state.effects.includes(other))) }),
    );
  }
  find("model").textContent = BOARDS.map(
    ({ name, base, each, within, source }) => `3 × (${base} + ${each} per term) + ${source} per source for the ${name.replace("Cortex-", "")}, terms within ${(100 * within).toFixed(0)}\u00a0%`,
  ).join(", ");
  plot(find("plot"), []);
  // With sources, for their module.
  const inputs = { light: "studio", material: "gold-metallic-paint", sources: 1 };
  [whole, ours, scratch] = await Promise.all([1, 2, 3].map(() => Scene.create(inputs)));
  find("base-color").value = "#b87333";
  find("metallic").value = "1";
  find("roughness").value = "0.4";
  thumbnails();
  await openLink();
  addEventListener("hashchange", openLink);
  wide.addEventListener("change", changed);
  new ResizeObserver(changed).observe(canvas);
}

/** The materials, each a sphere in the studio. */
function thumbnails() {
  find("thumbs").innerHTML = MATERIALS.map(
    (name) => `<label><input type="radio" name="material" value="${name}"><canvas width="64" height="64" aria-hidden="true"></canvas>${readable(name)}</label>`,
  ).join("");
  const pixels = disc(64);
  const { x, y, z } = pixels;
  const observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      observer.unobserve(target);
      const input = /** @type {HTMLInputElement} */ (target.querySelector("input"));
      Scene.create({ light: "studio", material: input.value }).then((scene) =>
        show(/** @type {HTMLCanvasElement} */ (target.querySelector("canvas")), image(pixels, scene.shade(x, y, z), scene.exposure())),
      );
    }
  });
  for (const label of find("thumbs").children) {
    observer.observe(label);
    const input = label.querySelector("input");
    input.addEventListener("change", () => take({ material: input.value }));
  }
}

start().catch((fault) => fail(`The page cannot start: ${fault.message}`));
