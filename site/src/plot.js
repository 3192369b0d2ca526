// What is left out by terms, as SVG: both on logarithmic scales.

const [LEFT, RIGHT, TOP, BOTTOM] = [52, 352, 8, 172];
const [LEAST, MOST] = [1e-6, 2];
const TERMS = 300;

const across = (/** @type {number} */ terms) => LEFT + ((RIGHT - LEFT) * Math.log(Math.max(1, terms))) / Math.log(TERMS);
const down = (/** @type {number} */ error) => {
  const share = Math.log(Math.min(MOST, Math.max(LEAST, error)) / LEAST) / Math.log(MOST / LEAST);
  return BOTTOM - (BOTTOM - TOP) * share;
};

export const counted = (/** @type {number} */ count, /** @type {string} */ noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;

/** @param {number} share */
export function percent(share) {
  const value = 100 * share;
  if (value === 0) return "0";
  if (value >= 10) return `${value.toFixed(0)} %`;
  return value >= 0.001 ? `${Number(value.toPrecision(2))} %` : "< 0.001 %";
}

/**
 * @param {Element} svg
 * @param {{ terms: number, rms: number, worst: number }[]} curve
 */
export function plot(svg, curve) {
  const errors = [1, 1e-2, 1e-4, 1e-6].map(
    (error) => `<line class="grid" x1="${LEFT}" x2="${RIGHT}" y1="${down(error)}" y2="${down(error)}"/>
      <text x="${LEFT - 5}" y="${down(error) + 3}" text-anchor="end">${Number((100 * error).toPrecision(1))} %</text>`,
  );
  const terms = [1, 3, 10, 30, 100, 300].map(
    (count) => `<line class="grid" x1="${across(count)}" x2="${across(count)}" y1="${TOP}" y2="${BOTTOM}"/>
      <text x="${across(count)}" y="${BOTTOM + 13}" text-anchor="middle">${count}</text>`,
  );
  const path = (/** @type {"rms" | "worst"} */ what) =>
    `<polyline class="${what}" points="${curve
      .filter((point) => point[what] > LEAST)
      .map((point) => `${across(point.terms).toFixed(1)},${down(point[what]).toFixed(1)}`)
      .join(" ")}"/>`;
  svg.innerHTML = `${errors.join("")}${terms.join("")}
    <text x="${(LEFT + RIGHT) / 2}" y="${BOTTOM + 26}" text-anchor="middle">terms</text>
    ${path("worst")}${path("rms")}
    <text x="${LEFT + 8}" y="${BOTTOM - 20}">— rms</text><text x="${LEFT + 8}" y="${BOTTOM - 7}">- - worst pixel</text>
    <circle class="nine-point" r="4"/><text class="nine-name" text-anchor="end">nine terms</text>
    <circle class="worst-point" r="4"/><circle class="rms-point" r="5.5"/>`;
}

/**
 * Moves the points to where the scene is.
 *
 * @param {Element} svg
 * @param {{ terms: number, rms: number, worst: number }} now
 * @param {{ rms: number }} nine the error of the nine-term formula
 */
export function mark(svg, { terms, rms, worst }, nine) {
  svg.querySelector(".nine-point")?.setAttribute("cx", across(9).toFixed(1));
  svg.querySelector(".nine-point")?.setAttribute("cy", down(nine.rms).toFixed(1));
  svg.querySelector(".nine-name")?.setAttribute("x", (across(9) - 7).toFixed(1));
  svg.querySelector(".nine-name")?.setAttribute("y", (down(nine.rms) + 13).toFixed(1));
  for (const [name, error] of /** @type {[string, number][]} */ ([["rms", rms], ["worst", worst]])) {
    const circle = svg.querySelector(`.${name}-point`);
    circle?.setAttribute("cx", across(terms).toFixed(1));
    circle?.setAttribute("cy", down(error).toFixed(1));
  }
  svg.setAttribute("aria-label", `What is left out by terms: now ${terms} terms, rms ${percent(rms)}, worst pixel ${percent(worst)}`);
}
