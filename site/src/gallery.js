// The first eigenimages, in signed colors, with the coefficients of the scene.

import { disc, show } from "./cpu.js";

const COUNT = 24;
const pixels = disc(72);

/** White through orange for positive values, through blue for negative ones. */
function signed(/** @type {Float32Array} */ values) {
  const most = values.reduce((largest, value) => Math.max(largest, Math.abs(value)), 1e-30);
  const picture = new ImageData(pixels.size, pixels.size);
  pixels.places.forEach((place, k) => {
    const level = values[k] / most;
    const strength = Math.abs(level) ** 0.7;
    const color = level > 0 ? [214, 112, 12] : [28, 96, 176];
    picture.data.set(color.map((value) => 250 + strength * (value - 250)), 4 * place);
    picture.data[4 * place + 3] = 255 * pixels.coverage[k];
  });
  return picture;
}

/** Three digits, and never "-0". */
const digits = (/** @type {number} */ value) => (Math.abs(value) < 5e-5 ? "0" : String(Number(value.toPrecision(2))).replace("-", "−"));

/**
 * Fills a list with eigenimages; those beyond `components` are out of the picture.
 *
 * @param {HTMLElement} list
 * @param {import("../eigenshade/src/index.js").Scene} scene
 * @param {number} components
 */
export function showGallery(list, scene, components) {
  if (list.childElementCount === 0) {
    list.innerHTML = Array.from({ length: COUNT }, () => "<li><canvas role=img></canvas><span></span></li>").join("");
    [...list.children].forEach((item, k) => {
      show(/** @type {HTMLCanvasElement} */ (item.querySelector("canvas")), signed(scene.eigenimage(k, pixels.x, pixels.y, pixels.z)));
    });
  }
  const { g } = scene.coefficients();
  [...list.children].forEach((item, k) => {
    const label = `d${k + 1} = ${digits(g[k])}`;
    item.querySelector("canvas")?.setAttribute("aria-label", `Eigenimage ${k + 1}`);
    const caption = item.querySelector("span");
    if (caption) caption.innerHTML = `<b>d<sub>${k + 1}</sub></b> ${digits(g[k])}`;
    item.classList.toggle("out", k >= components);
    item.setAttribute("title", label);
  });
}
