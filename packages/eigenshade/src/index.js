// eigenshade: measured materials under captured light in a web page.

export { load } from "./engine.js";
export { Preview } from "./preview.js";
export { sphere } from "./renderer.js";
export { lightPreset, materialPreset, presetNames } from "./presets.js";
export { EFFECTS, Scene, TONES } from "./scene.js";

/**
 * Types of options and results.
 *
 * @typedef {import("./engine.js").Engine} Engine
 * @typedef {import("./presets.js").Channels} Channels
 * @typedef {import("./preview.js").Look} Look
 * @typedef {import("./scene.js").Effect} Effect
 * @typedef {import("./scene.js").Inputs} Inputs
 * @typedef {import("./scene.js").MetallicRoughness} MetallicRoughness
 * @typedef {import("./scene.js").Storage} Storage
 * @typedef {import("./scene.js").Tone} Tone
 * @typedef {import("./scene.js").Truncation} Truncation
 * @typedef {import("./scene.js").Turn} Turn
 */
