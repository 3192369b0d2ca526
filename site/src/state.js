// The page's whole state, and the link that holds it.

import { EFFECTS, lightPreset, materialPreset } from "../eigenshade/src/index.js";
import { LARGEST } from "../eigenshade/src/input.js";
import { ALL_TERMS } from "./measure.js";
import { ANALYTIC, COUNT } from "./harmonics.js";
import { MOST } from "./pursuit.js";

/** @typedef {{ r: Float32Array, g: Float32Array, b: Float32Array, sources?: Float32Array }} Light */
/** @typedef {{ baseColor: string, metallic: number, roughness: number }} Gltf */

export const OBJECTS = ["sphere", "relief", "coin", "own"];
export const VIEWS = ["picture", "split"];
export const TABS = ["scene", "accuracy", "effects", "images", "shadows", "cases"];
export const COMPONENTS = 160;
export const SOURCES = ["auto", "0", "1", "2", "4", "8"];
/** The most sources that a light has; pictures are compared with those of as many. */
export const ALL_SOURCES = 16;
/** The tolerances of "automatic", in percent. */
export const AUTOMATIC = ["10", "5", "2", "1", "0.5", "0.1"];

export const initial = () => ({
  object: "relief",
  /** A preset, a formula, or "own". */
  light: "lobby",
  /** @type {{ name: string, light: Light } | undefined} */
  ownLight: undefined,
  /** @type {string | Gltf} */
  material: "gold-metallic-paint",
  /** How light and object are turned. */
  turn: [0, 0, 0, 1],
  pose: [0.2, -0.26, 0, 0.945],
  step: 14,
  /** Most small sources of a captured light: a number, or as few as the material needs. */
  sources: /** @type {number | "auto"} */ ("auto"),
  effects: [...EFFECTS],
  components: COMPONENTS,
  exposure: 0,
  view: "picture",
  drag: "object",
  tab: "accuracy",
  /** Whether the coin is shown with its shadows. */
  shadows: false,
  case: "sun",
  automatic: 1,
});

/** @typedef {ReturnType<typeof initial>} State */

/** Base64 for links. */
function encodeLight({ r, g, b, sources = [] }) {
  const bytes = new Uint8Array(Float32Array.from([...r, ...g, ...b, ...sources]).buffer);
  return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** @param {string} text */
function decodeLight(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
  const count = (bytes.length - 12 * COUNT) / 28;
  if (!(Number.isInteger(count) && count >= 0 && count <= MOST)) throw new RangeError("its light is incomplete");
  const numbers = new Float32Array(bytes.buffer);
  if (!numbers.every((value) => Math.abs(value) <= LARGEST)) throw new RangeError(`its light has a number beyond ${LARGEST}`);
  const [r, g, b] = [0, 1, 2].map((k) => numbers.slice(COUNT * k, COUNT * (k + 1)));
  return { r, g, b, sources: numbers.slice(3 * COUNT) };
}

/** How each part of the state becomes text and back. Readers throw for what is no value. */
const one = (/** @type {string[]} */ names) => ({
  write: String,
  read(/** @type {string} */ text) {
    if (!names.includes(text)) throw new RangeError(`"${text}" is not one of ${names.join(", ")}`);
    return text;
  },
});
const oneNumber = (/** @type {string[]} */ numbers) => ({
  write: String,
  read: (/** @type {string} */ text) => Number(one(numbers).read(text)),
});
const number = (/** @type {number} */ least, /** @type {number} */ most, whole = false) => ({
  write: (/** @type {number} */ value) => String(Number(value.toFixed(3))),
  read(/** @type {string} */ text) {
    const value = text === "" ? NaN : Number(text);
    if (!(value >= least && value <= most) || (whole && !Number.isInteger(value))) {
      throw new RangeError(`"${text}" is not a ${whole ? "whole " : ""}number from ${least} to ${most}`);
    }
    return value;
  },
});
const rotation = {
  write: (/** @type {number[]} */ turn) => turn.map((value) => Number(value.toFixed(5))).join(),
  read(/** @type {string} */ text) {
    const turn = text.split(",").map(Number);
    const length = Math.hypot(...turn);
    if (turn.length !== 4 || !(length > 0.5 && length < 2)) throw new RangeError(`"${text}" is not a rotation`);
    return turn.map((value) => value / length);
  },
};
const name = {
  write: String,
  read(/** @type {string} */ text) {
    if (!/^[a-z0-9-]{1,40}$/.test(text)) throw new RangeError(`"${text}" is not a name`);
    return text;
  },
};

/** @type {Record<string, { write: (value: any) => string, read: (text: string) => any }>} */
const PARTS = {
  object: one(OBJECTS),
  light: name,
  ownLight: {
    write: (own) => (own ? `${encodeLight(own.light)}.${own.name}` : ""),
    read(text) {
      const dot = text.indexOf(".");
      if (dot < 0) throw new RangeError("its light has no name");
      return { light: decodeLight(text.slice(0, dot)), name: text.slice(dot + 1, dot + 81) };
    },
  },
  material: {
    write: (value) =>
      typeof value === "string" ? value : `${value.baseColor},${value.metallic},${value.roughness}`,
    read(text) {
      const [, baseColor, metallic, roughness] = /^(#[0-9a-f]{6}),([\d.]+),([\d.]+)$/.exec(text) ?? [];
      if (!baseColor) return name.read(text);
      const share = number(0, 1);
      return { baseColor, metallic: share.read(metallic), roughness: share.read(roughness) };
    },
  },
  turn: rotation,
  pose: rotation,
  step: number(0, ALL_TERMS, true),
  sources: {
    write: String,
    read: (/** @type {string} */ text) => (text === "auto" ? text : oneNumber(SOURCES).read(text)),
  },
  effects: {
    write: (value) => EFFECTS.filter((effect) => value.includes(effect)).join() || "none",
    read: (text) => (text === "none" ? [] : text.split(",").map(one([...EFFECTS]).read)),
  },
  components: number(0, COMPONENTS, true),
  exposure: number(-4, 4),
  view: one(VIEWS),
  drag: one(["object", "light"]),
  tab: one(TABS),
  shadows: {
    write: (/** @type {boolean} */ has) => (has ? "on" : "off"),
    read: (/** @type {string} */ text) => one(["on", "off"]).read(text) === "on",
  },
  case: name,
  automatic: oneNumber(AUTOMATIC),
};

/**
 * The link's part after "#": what differs from the initial state. The page writes "details" if nothing does.
 *
 * @param {State} state
 */
export function toHash(state) {
  const [usual, parts] = [initial(), new URLSearchParams()];
  for (const [key, { write }] of Object.entries(PARTS)) {
    const text = write(state[key]);
    if (text !== write(usual[key])) parts.set(key, text);
  }
  // What a link holds of an own light matters only while it is shown.
  if (state.light !== "own") parts.delete("ownLight");
  return parts.toString().replaceAll("%2C", ",");
}

/**
 * The state of a link. What it does not hold, or holds wrongly, is initial; `faults` says what is
 * wrong.
 *
 * @param {string} hash
 * @param {boolean} [ownMesh] whether the page has a mesh, which no link holds
 * @returns {{ state: State, faults: string[] }}
 */
export function fromHash(hash, ownMesh = false) {
  const [state, faults] = [initial(), /** @type {string[]} */ ([])];
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (key === "details") continue;
    if (!Object.hasOwn(PARTS, key)) {
      faults.push(`${key} is unknown`);
      continue;
    }
    try {
      state[key] = PARTS[key].read(text);
    } catch (fault) {
      faults.push(`${key}: ${/** @type {Error} */ (fault).message}`);
    }
  }
  if (state.light === "own" && !state.ownLight) {
    faults.push("its own light is missing");
    state.light = initial().light;
  }
  if (state.object === "own" && !ownMesh) {
    faults.push("a link holds no mesh; drop the file again");
    state.object = initial().object;
  }
  return { state, faults };
}

/** How the scenes' inputs are loaded that the state names. Throws for a name that does not exist. */
const INPUTS = {
  async light(/** @type {State} */ { light, ownLight, sources }) {
    if (light === "own") {
      const own = /** @type {Light} */ (ownLight?.light);
      return { ...own, sources: own.sources?.subarray(0, 7 * (sources === "auto" ? MOST : sources)) };
    }
    return Object.hasOwn(ANALYTIC, light) ? ANALYTIC[light]() : lightPreset(light, { sources });
  },
  material: async (/** @type {State} */ { material }) =>
    typeof material === "string" ? materialPreset(material) : material,
};

/**
 * The scenes' inputs that the state names, and the same light with all its sources. Throws for a name
 * that does not exist.
 */
export async function inputsOf(/** @type {State} */ wanted) {
  return {
    light: await INPUTS.light(wanted),
    best: await INPUTS.light({ ...wanted, sources: ALL_SOURCES }),
    material: await INPUTS.material(wanted),
  };
}

/**
 * Makes inputs initial that cannot be loaded, and says why.
 *
 * @param {State} wanted
 */
export async function loadable(wanted) {
  const faults = /** @type {string[]} */ ([]);
  for (const key of /** @type {const} */ (["light", "material"])) {
    try {
      await INPUTS[key](wanted);
    } catch (fault) {
      faults.push(/** @type {Error} */ (fault).message);
      Object.assign(wanted, { [key]: initial()[key] });
    }
  }
  return faults;
}
