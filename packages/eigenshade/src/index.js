// eigenshade: measured materials under captured light in a web page.

export { load } from "./engine.js";
export { Preview } from "./preview.js";
export { sphere } from "./renderer.js";
export { lightPreset, materialPreset, presetNames } from "./presets.js";
export { EFFECTS, Scene, TONES } from "./scene.js";
