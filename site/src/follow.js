// The light follows a place on the object.

import { LAMP } from "./parts.js";
import { multiply } from "./turn.js";

/** Puts the lamp where the camera is. */
const FRONT = between(LAMP, [0, 0, 1]);

/**
 * The turn of the light that puts the lamp's highlight at a place of a sphere: (x, y) from -1 to 1 to the
 * right and up. A step of 0.02 turns the light by at most 4 degrees.
 *
 * @param {number[]} place
 * @returns {[number, number, number, number]}
 */
export function toward([x, y]) {
  // Beyond this the lamp is behind the object.
  const inside = Math.min(1, 0.8 / Math.max(1e-9, Math.hypot(x, y)));
  const normal = [x * inside, y * inside, 0];
  normal[2] = Math.sqrt(1 - normal[0] ** 2 - normal[1] ** 2);
  const mirrored = [2 * normal[2] * normal[0], 2 * normal[2] * normal[1], 2 * normal[2] ** 2 - 1];
  // The shortest turn from the lamp would be another one on each side of its opposite.
  return multiply(between([0, 0, 1], mirrored), FRONT);
}

/** Milliseconds for which the light moves by itself. */
const WANDERS = 10e3;

/** The place of the light after some seconds: on an ellipse that starts at its first place. */
export const wander = ([x, y], /** @type {number} */ seconds) => [
  x * Math.cos(0.7 * seconds) + 0.6 * Math.sin(0.7 * seconds),
  y - 0.25 + 0.25 * Math.cos(0.9 * seconds),
];

/** The smallest rotation from a unit vector to another that is not opposite. */
function between([a, b, c], [x, y, z]) {
  const turn = [b * z - c * y, c * x - a * z, a * y - b * x, 1 + a * x + b * y + c * z];
  const length = Math.hypot(...turn);
  return /** @type {[number, number, number, number]} */ (turn.map((value) => value / length));
}

/**
 * Turns the light: slowly by itself for ten seconds, until a pointer or a key moves it.
 *
 * @param {HTMLElement} stage
 * @param {HTMLCanvasElement} canvas of the object, on the stage
 * @param {[number, number]} first
 * @param {import("./live.js").Live} live
 */
export function follow(stage, canvas, first, live) {
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  let place = [...first];
  let wanted = place;
  let isLed = still.matches;
  let frame = 0;
  const began = performance.now();
  const next = () => (frame ||= requestAnimationFrame(step));
  const step = (/** @type {number} */ now) => {
    frame = 0;
    if (stage.hidden) return;
    if (!isLed) wanted = wander(first, (now - began) / 1000);
    isLed ||= now - began > WANDERS;
    const away = Math.hypot(wanted[0] - place[0], wanted[1] - place[1]);
    // A fifth of the way, so that the light does not jump.
    const way = still.matches || away < 1e-3 ? 1 : 0.2;
    place = place.map((at, k) => at + way * (wanted[k] - at));
    live.turn(toward(place));
    const isOnTheWay = isLed && way < 1;
    live.draw(isOnTheWay);
    if (!isLed || isOnTheWay) next();
  };
  const lead = (/** @type {number[]} */ to) => {
    isLed = true;
    wanted = to;
    live.announce();
    next();
  };
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
