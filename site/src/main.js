// The page: controls and state, state and picture.

import { EFFECTS, presetNames } from "../eigenshade/src/index.js";
import { BOARDS, instructions } from "./boards.js";
import { CASES, showCase } from "./cases.js";
import { controls, fill, find, onTab, wide } from "./controls.js";
import { drawCpu } from "./cpu.js";
import { Drawing, KINDS, SHOWN } from "./draw.js";
import { checkSize, onDrop, panorama } from "./files.js";
import { showGallery } from "./gallery.js";
import { ANALYTIC } from "./harmonics.js";
import * as measure from "./measure.js";
import { shadeNine } from "./nine.js";
import { coin, coinNormals, parseObj, relief } from "./objects.js";
import { counted, mark, percent, plot } from "./plot.js";
import { turnable } from "./pointers.js";
import { Scenes } from "./scenes.js";
import { colorsOf, screenError, screenText, verdict, wholeVerdict } from "./screen.js";
import { directError, loadErrors, showSources } from "./sources.js";
import { COMPONENTS, fromHash, initial, inputsOf, loadable, toHash } from "./state.js";
import { thumbnails } from "./thumbnails.js";
import { IDENTITY, dragged, multiply } from "./turn.js";

const still = matchMedia("(prefers-reduced-motion: reduce)");

let state = initial();
let scenes = /** @type {Scenes} */ (/** @type {unknown} */ (undefined));
let reference = /** @type {measure.Picture} */ (/** @type {unknown} */ (undefined));
/** @type {import("./objects.js").Mesh | undefined} */
let ownMesh;
/** @type {import("./model.js").Model | undefined} */
let ownModel;
let drawnObject = "";

const canvas = /** @type {HTMLCanvasElement} */ (find("picture"));
const drawing = Drawing.of(canvas, () => {
  drawnObject = "";
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

function draw() {
  const { ours, whole, best } = scenes;
  for (const scene of [whole, best]) scene.turn(state.turn);
  ours.turn(state.turn).effects(state.effects).components(state.components).within(measure.toleranceOf(state.step), scenes.exposure);
  const look = { exposure: scenes.exposure * 2 ** state.exposure, pose: state.pose, nine: { terms: scenes.nine, turn: state.turn } };
  const model = shownModel();
  const split = state.view === "split" && !model;
  const side = Math.min(1400, Math.max(64, Math.round(canvas.clientWidth * Math.min(2, devicePixelRatio))));
  if (drawing && model && scenes.loaded) {
    drawing.draw([], look, side + (side % 2));
    model.draw(canvas, { light: scenes.loaded.light, turn: state.turn, pose: state.pose, exposure: 2 ** state.exposure }, changed);
  } else if (drawing) {
    ownModel?.hide();
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
      ? [{ scene: ours }, { scene: best }, { scene: ours, shown: SHOWN.nine }, { scene: ours, shown: SHOWN.difference }]
      : [{ scene: ours }];
    // While something turns, terms come and go, and each set of them is a program. Until it rests,
    // the picture has all terms instead of waiting for a long one.
    if (dragging && ours.terms > 60 && !drawing.has(ours)) ours.within();
    drawing.draw(panes, look, side + (side % 2));
    ours.within(measure.toleranceOf(state.step), scenes.exposure);
  } else {
    drawCpu(canvas, ours, split ? best : undefined, look);
  }
  find("captions").hidden = !split;
  numbers();
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

const meshes = /** @type {Record<string, any>} */ ({});
let now = { terms: 0, rms: 0, worst: 0 };
let nineError = { rms: 0, worst: 0 };

/** The error of the picture on a screen, that of the terms that are left out, and costs by counts. */
function numbers() {
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
  const isModel = Boolean(shownModel());
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

/** What takes tens of milliseconds, once nothing changes. */
function later() {
  saveLink();
  if (dragging || showing) {
    idle = setTimeout(later, 150);
    return;
  }
  const { ours, whole, scratch, exposure } = scenes;
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
  if (shownTab() === "images") showGallery(find("gallery"), whole, state.components);
  // A change that waits for its frame and what is being loaded are not shown yet.
  busy(frame > 0 || Object.keys(pending).length > 0);
}

/** Whether the picture and its numbers are not yet those of the state; tests wait for it. */
const busy = (/** @type {boolean} */ is) => (document.documentElement.dataset.busy = String(is));

/** The tab that is shown: on wide screens the scene has a place of its own. */
const shownTab = () => (wide.matches && state.tab === "scene" ? "accuracy" : state.tab);

/** The model that is shown: an object of the user's with its own materials. */
const shownModel = () => (state.object === "own" ? ownModel : undefined);
/** Whether there is an object of the user's. */
const hasOwn = () => Boolean(ownMesh ?? ownModel);

const showControls = () =>
  controls(state, { drawing: Boolean(drawing), hasOwn: hasOwn(), isModel: Boolean(shownModel()), turnsLight: turnsLight(), tab: shownTab() });

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
  const { state: wanted, faults } = fromHash(hash, hasOwn());
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
on("has-shadows", "change", ({ checked }) => set({ shadows: checked }));
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
for (const input of /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll("input[name=sources]"))) {
  input.addEventListener("change", () => take({ sources: input.value === "auto" ? input.value : Number(input.value) }));
}
for (const name of ["object", "view", "drag"]) {
  for (const input of document.querySelectorAll(`input[name=${name}]`)) {
    input.addEventListener("change", () => set({ [name]: /** @type {HTMLInputElement} */ (input).value }));
  }
}
on("choose", "click", () => {
  const { scratch, loaded } = scenes;
  if (!loaded) return;
  scratch.light(loaded.light).material(loaded.material).turn(state.turn);
  const found = measure.automatic(scratch, scenes.exposure, state.automatic / 100);
  scratch.turn(IDENTITY);
  if (!found) return;
  set({ effects: found.effects, step: found.step, components: COMPONENTS });
  const names = found.effects.length === EFFECTS.length ? "all effects" : found.effects.join(", ") || "no effect";
  find("chosen").textContent = `Chose ${names} and ${found.terms} terms: they leave out ${percent(found.rms)} of white rms, worst pixel ${percent(found.worst)}.`;
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

// ---- downloads ----

/** Saves a file of this kind of what is shown. */
export async function download(/** @type {string} */ kind) {
  const files = await import("./take.js");
  const { ours } = scenes;
  ours.turn(state.turn).within(measure.toleranceOf(state.step), scenes.exposure);
  const { light, material, turn } = state;
  const seen = { light, material, turn, exposure: scenes.exposure * 2 ** state.exposure, sources: ours.sources, window: files.windowOf(ours) };
  const name = `eigenshade.${kind}`;
  if (kind === "png") return files.savePicture(name, canvas);
  if (kind === "json") return files.save(name, files.json(ours, seen));
  if (kind === "glsl") return files.save(name, files.glsl(ours));
  if (light === "own" || Object.hasOwn(ANALYTIC, light)) throw new Error("Programs are of captured lights; take the coefficients.");
  files.save(name, { rs: files.rust, c: files.c, py: files.python }[kind](seen));
}

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

onTab((tab) => {
  set({ tab });
  showControls();
  refreshCase();
});
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
onDrop(open);

async function open(/** @type {File} */ file) {
  fail("");
  say(`Reading ${file.name}`);
  try {
    checkSize(file);
    if (/\.(glb|gltf)$/i.test(file.name)) {
      if (!drawing) throw new Error("it needs WebGL 2, which this browser has not");
      const { Model } = await import("./model.js");
      const model = await Model.read(await file.arrayBuffer());
      ownModel?.free();
      [ownMesh, ownModel] = [undefined, model];
      set({ object: "own" });
      const without = model.leftOut.length ? `, without ${model.leftOut.join(", ")}` : "";
      say(`${file.name}: ${counted(model.triangles, "triangle")} with its own materials${without}.`);
    } else if (/\.obj$/i.test(file.name)) {
      ownMesh = parseObj(await file.text());
      ownModel?.free();
      ownModel = undefined;
      drawnObject = "";
      set({ object: "own" });
      say(`${file.name}: ${ownMesh.indices.length / 3} triangles.`);
      if (!drawing) say(`${file.name} is read, but without WebGL 2 only spheres are drawn.`);
    } else {
      const { light, width, height, note } = await panorama(file, say);
      const fault = await take({ light: "own", ownLight: { name: file.name.slice(0, 80), light } });
      if (fault) throw new Error(fault);
      const shape = width === 2 * height ? "" : " It is not twice as wide as high; it is read as equirectangular.";
      say(`${file.name}: ${width} × ${height}, projected to degree 9, with ${counted(light.sources.length / 7, "source")}.${shape}${note}`);
    }
  } catch (fault) {
    say("");
    fail(`${file.name} cannot be used: ${/** @type {Error} */ (fault).message}. The picture is as it was.`);
  }
}

// ---- start ----

async function start() {
  const names = await presetNames();
  await loadErrors();
  fill(names);
  for (const effect of EFFECTS) {
    on(`effect-${effect}`, "change", ({ checked }) =>
      set({ effects: EFFECTS.filter((other) => (other === effect ? checked : state.effects.includes(other))) }),
    );
  }
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
