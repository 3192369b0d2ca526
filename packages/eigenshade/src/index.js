// eigenshade: measured materials under captured light in a web page.

export { setAssets } from "./assets.js";
export { load } from "./engine.js";
export { Preview } from "./preview.js";
export { lightPreset, materialPreset, presetNames } from "./presets.js";
export { EFFECTS, TONES } from "./input.js";
export { Scene } from "./scene.js";
export { sphere } from "./sphere.js";

/**
 * Types of options and results.
 *
 * @typedef {import("./assets.js").Assets} Assets
 * @typedef {import("./engine.js").Engine} Engine
 * @typedef {import("./input.js").Channels} Channels
 * @typedef {import("./preview.js").Look} Look
 * @typedef {import("./input.js").Effect} Effect
 * @typedef {import("./input.js").Inputs} Inputs
 * @typedef {import("./input.js").MetallicRoughness} MetallicRoughness
 * @typedef {import("./input.js").Numbers} Numbers
 * @typedef {import("./shader.js").Storage} Storage
 * @typedef {import("./input.js").Tone} Tone
 * @typedef {import("./engine.js").Truncation} Truncation
 * @typedef {import("./input.js").Turn} Turn
 */
