// The list of materials.

import { Scene } from "../eigenshade/src/index.js";
import { disc, image, show } from "./cpu.js";

/** Materials that have a thumbnail. */
const MATERIALS = [
  "gold-metallic-paint", "two-layer-gold", "brass", "alum-bronze", "silver-metallic-paint", "chrome-steel",
  "aluminium", "tungsten-carbide", "hematite", "black-obsidian", "blue-metallic-paint", "green-metallic-paint",
  "red-metallic-paint", "color-changing-paint1", "color-changing-paint2", "pearl-paint", "red-plastic",
  "yellow-plastic", "green-plastic", "violet-acrylic", "specular-blue-phenolic", "specular-red-phenolic",
  "green-latex", "violet-rubber", "pure-rubber", "red-fabric2", "blue-fabric", "green-fabric", "pink-felt",
  "white-fabric", "cherry-235", "natural-209", "white-marble", "pink-jasper", "orange-paint", "dark-blue-paint",
];

/** A material's name for people. */
export const readable = (/** @type {string} */ name) => name.replace(/^\d+-/, "").replaceAll("-", " ");

/**
 * Shows the materials, each a sphere in the studio, and calls back for the one that is chosen.
 *
 * @param {HTMLElement} list
 * @param {(name: string) => void} choose
 */
export function thumbnails(list, choose) {
  list.innerHTML = MATERIALS.map(
    (name) => `<label><input type="radio" name="material" value="${name}"><canvas width="64" height="64" aria-hidden="true"></canvas>${readable(name)}</label>`,
  ).join("");
  const pixels = disc(64);
  const { x, y, z } = pixels;
  const observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      observer.unobserve(target);
      const input = /** @type {HTMLInputElement} */ (target.querySelector("input"));
      // Without, the lamps of the studio ring.
      Scene.create({ light: "studio", material: input.value, sources: "auto", window: "auto" }).then((scene) =>
        show(/** @type {HTMLCanvasElement} */ (target.querySelector("canvas")), image(pixels, scene.shade(x, y, z), scene.exposure())),
      );
    }
  });
  for (const label of list.children) {
    observer.observe(label);
    const input = /** @type {HTMLInputElement} */ (label.querySelector("input"));
    input.addEventListener("change", () => choose(input.value));
  }
}
