// The first sight: the object under a light that follows the pointer. All else is loaded afterwards.

import { toward } from "./follow.js";
import { drawer } from "./object-picture.js";
import { unpacked } from "./packed.js";

const find = (/** @type {string} */ id) => /** @type {any} */ (document.getElementById(id));
const canvas = /** @type {HTMLCanvasElement} */ (find("object"));
const still = matchMedia("(prefers-reduced-motion: reduce)");
const busy = (/** @type {boolean} */ is) => (document.documentElement.dataset.busy = String(is));

// ---- details ----

/** @type {Promise<typeof import("./main.js")> | undefined} */
let details;

/** Shows the details if the address holds a state, else the first sight. */
function route() {
  const open = location.hash.length > 1;
  find("first").hidden = open;
  find("page").hidden = !open;
  for (const button of document.querySelectorAll(".only-details")) /** @type {HTMLElement} */ (button).hidden = !open;
  find("take").open = false;
  if (open) (details ??= import("./main.js")).catch((fault) => broken(`The details cannot be shown: ${fault.message}`));
  else start();
}
addEventListener("hashchange", route);
const broken = (/** @type {string} */ text) => {
  find("first-fault").textContent = text;
  busy(false);
};

// ---- downloads ----

const take = find("take");
take.addEventListener("click", async (/** @type {PointerEvent} */ { target }) => {
  const { take: kind } = /** @type {HTMLElement} */ (target).dataset;
  if (!kind) return;
  find("take-note").textContent = "";
  const shown = await (find("first").hidden ? details : started);
  await shown?.download(kind).catch((/** @type {Error} */ { message }) => (find("take-note").textContent = message));
});
// A click elsewhere and Escape close the menu.
addEventListener("pointerdown", ({ target }) => take.contains(target) || (take.open = false));
take.addEventListener("keydown", (/** @type {KeyboardEvent} */ { key }) => {
  if (key !== "Escape") return;
  take.open = false;
  take.querySelector("summary").focus();
});

// ---- the object ----

/** @type {Promise<import("./live.js").Live | undefined> | undefined} */
let started;
function start() {
  started ??= begin().catch((fault) => {
    broken(`The picture cannot be drawn: ${fault.message}`);
    return undefined;
  });
}

async function begin() {
  busy(true);
  const response = await fetch(new URL("../object/egg.bin", import.meta.url));
  if (!response.ok || !response.body) throw new Error(`object/egg.bin: ${response.status}; run site/build`);
  const object = await unpacked(response.body);
  const draw = drawer(canvas, object);
  draw(object.palettes);
  // The first frame shows the picture, and the second one comes after it.
  for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
  performance.mark("first-picture");
  const { Live } = await import("./live.js");
  const live = await Live.create(object, draw);
  follow(object.about.place, live);
  return live;
}

// ---- the light ----

/**
 * Turns the light: slowly by itself, until a pointer or a key moves it.
 *
 * @param {[number, number]} first
 * @param {import("./live.js").Live} live
 */
function follow(first, live) {
  let place = [...first];
  let wanted = place;
  let isLed = still.matches;
  let frame = 0;
  const began = performance.now();
  const next = () => (frame ||= requestAnimationFrame(step));
  const step = (/** @type {number} */ now) => {
    frame = 0;
    if (find("first").hidden) return;
    if (!isLed) wanted = wander(first, (now - began) / 1000);
    const away = Math.hypot(wanted[0] - place[0], wanted[1] - place[1]);
    // A fifth of the way, so that the light does not jump.
    const way = still.matches || away < 1e-3 ? 1 : 0.2;
    place = place.map((at, k) => at + way * (wanted[k] - at));
    live.turn(toward(place));
    live.draw();
    if (!isLed || away >= 1e-3) next();
  };
  const lead = (/** @type {number[]} */ to) => {
    isLed = true;
    wanted = to;
    busy(true);
    next();
  };
  const stage = find("first");
  const at = (/** @type {PointerEvent} */ event) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const [x, y] = [(2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height];
    lead([x, y].map((along) => Math.max(-1.6, Math.min(1.6, along))));
  };
  stage.addEventListener("pointermove", (/** @type {PointerEvent} */ event) => {
    const { target, pointerType } = event;
    const isElsewhere = /** @type {Element} */ (target).closest(".say");
    if (pointerType === "mouse" ? !isElsewhere : target === canvas) at(event);
  });
  canvas.addEventListener("pointerdown", at);
  canvas.addEventListener("keydown", (event) => {
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!by) return;
    event.preventDefault();
    lead(wanted.map((along, k) => Math.max(-1, Math.min(1, along + 0.08 * by[k]))));
  });
  live.changed = next;
  new ResizeObserver(next).observe(canvas);
  addEventListener("hashchange", next);
  next();
}

/** Where the light is after some seconds: on an ellipse that starts at its first place. */
const wander = ([x, y], /** @type {number} */ seconds) => [
  x * Math.cos(0.7 * seconds) + 0.6 * Math.sin(0.7 * seconds),
  y - 0.25 + 0.25 * Math.cos(0.9 * seconds),
];

find("closed").hidden = true;
route();
