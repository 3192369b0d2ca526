// Scenes that break naive code: the picture of the package beside that of a naive program.

import { Scene } from "../eigenshade/src/index.js";
import { disc, image, show } from "./cpu.js";
import { find } from "./dom.js";
import { Drawing, KINDS, SHOWN } from "./draw.js";
import { directional, disc as discLight, sum, ambient, windowed } from "./harmonics.js";
import { errorOf, meanOf, peakOf, pictureOf } from "./measure.js";
import { nineTerms, shadeNine } from "./nine.js";
import { coin, coinNormals } from "./objects.js";
import { percent } from "./plot.js";
import { project } from "./project.js";
import { IDENTITY } from "./turn.js";

const SIDE = 220;
const pixels = disc(SIDE);
const { x, y, z } = pixels;
const FRONT = unit([-0.5, 0.62, 0.6]);

/** @param {number[]} vector */
function unit(vector) {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
}

/** A white matte. */
const WHITE = { r: [2], g: [2], b: [2] };
const gray = (/** @type {Float32Array} */ values) => ({ r: values, g: values, b: values });

/** @typedef {{ ours: ImageData | HTMLCanvasElement, naive: ImageData | HTMLCanvasElement, oursCaption: string, naiveCaption: string, text: string }} Shown */

/** A clear sky with one texel of radiance 1e6, on a white matte. */
async function sun() {
  const [width, height, sky, ground, radiance] = [256, 128, 1, 0.3, 1e6];
  const data = new Float32Array(3 * width * height);
  for (let k = 0; k < data.length; k++) data[k] = k < data.length / 2 ? sky : ground;
  // The texel of a direction in front of the object, up to the left.
  const [row, column] = [Math.floor((height * Math.acos(FRONT[1])) / Math.PI), Math.floor(width * (0.5 + Math.atan2(FRONT[0], -FRONT[2]) / (2 * Math.PI)))];
  data.fill(radiance, 3 * (row * width + column), 3 * (row * width + column) + 3);
  const [theta, t] = [(Math.PI * (row + 0.5)) / height, 2 * Math.PI * ((column + 0.5) / width - 0.5)];
  const sunward = [Math.sin(t) * Math.sin(theta), Math.cos(theta), -Math.cos(t) * Math.sin(theta)];
  const angle = ((2 * Math.PI) / width) * (Math.cos((Math.PI * row) / height) - Math.cos((Math.PI * (row + 1)) / height));
  const scene = await Scene.create({ light: project({ width, height, stride: 3, data }), material: WHITE });
  const ours = scene.shade(x, y, z);
  const facing = (/** @type {number} */ k) => Math.max(0, x[k] * sunward[0] + y[k] * sunward[1] + z[k] * sunward[2]);
  // The integral by a formula.
  const exact = Float32Array.from(x, (_, k) => (radiance * angle * facing(k)) / Math.PI + (sky * (1 + y[k]) + ground * (1 - y[k])) / 2);
  // The same numbers each time.
  let seed = 1;
  const random = () => ((seed = (seed * 48271) % 2147483647) - 1) / 2147483646;
  let met = 0;
  const samples = 64;
  const hit = (samples * angle) / (4 * Math.PI);
  const naive = Float32Array.from(x, (_, k) => {
    // Of uniform directions, each meets the sun by chance; the sky is taken exactly, in favor of
    // the naive program.
    const meets = random() < hit;
    met += Number(meets && facing(k) > 0);
    return (sky * (1 + y[k]) + ground * (1 - y[k])) / 2 + (meets ? (4 * radiance * facing(k)) / samples : 0);
  });
  const exposure = 0.8 / exact.reduce((most, value) => Math.max(most, value), 0);
  const { rms } = errorOf(ours, gray(exact), exposure);
  return {
    ours: image(pixels, ours, exposure),
    naive: image(pixels, gray(naive), exposure),
    oursCaption: `Ours: off by ${percent(rms)} of white (rms)`,
    naiveCaption: `Naive: ${samples} random directions a pixel`,
    text: `One texel of the map is a million times as bright as the sky: ${met} of ${x.length.toLocaleString("en")} pixels of the naive program meet it, too brightly, and the others miss it; ours sums every texel once, into 100 coefficients.`,
  };
}

/** Light from one direction on a glossy material. */
async function direction() {
  const sharp = directional(FRONT, [3, 3, 3]);
  const scene = await Scene.create({ light: windowed(sharp), material: "blue-metallic-paint" });
  const ours = scene.shade(x, y, z);
  const naive = scene.light(sharp).shade(x, y, z);
  const least = (/** @type {typeof ours} */ picture) => -Math.min(0, ...["r", "g", "b"].map((c) => picture[c].reduce((a, b) => Math.min(a, b), 0))) / peakOf(picture);
  const exposure = 1.1 / peakOf(ours);
  return {
    ours: image(pixels, ours, 2 * exposure),
    naive: image(pixels, naive, 2 * exposure),
    oursCaption: `Ours, windowed: down to −${percent(least(ours))} of the peak`,
    naiveCaption: `Naive, cut at degree 9: down to −${percent(least(naive))}`,
    text: "A single direction holds all degrees, and a series that is cut off at degree 9 rings: bands around the highlight, and negative light. A window over the degrees trades the rings for a wider highlight.",
  };
}

/** Two pictures of one drawing. */
function drawn(/** @type {(drawing: Drawing) => void} */ object, /** @type {Scene} */ scene, /** @type {number} */ shown, exposure = scene.exposure()) {
  const canvas = document.createElement("canvas");
  const drawing = Drawing.of(canvas);
  if (!drawing) return undefined;
  object(drawing);
  // A shorter program compiles faster, and is as far off beyond the rim.
  scene.within(1e-3);
  const look = { exposure, pose: [...IDENTITY], nine: { terms: new Float32Array(27), turn: [...IDENTITY] } };
  const [ours, naive] = [true, false].map((careful) => {
    drawing.draw([{ scene, shown, careful }], look, 2 * SIDE);
    const copy = document.createElement("canvas");
    copy.width = copy.height = 2 * SIDE;
    copy.getContext("2d")?.drawImage(canvas, 0, 0);
    return copy;
  });
  drawing.free();
  return { ours, naive };
}

/** Normals of a knurled sphere that face away near the rim. */
async function rim() {
  const scene = await Scene.create({ light: "venice", material: "specular-blue-phenolic" });
  const pair = drawn((drawing) => drawing.object(KINDS.bumps), scene, SHOWN.picture);
  return pair && {
    ...pair,
    oursCaption: "Ours: normals that face away move to the rim",
    naiveCaption: "Naive: used as they are",
    text: "Bumps and interpolated normals face away from the camera near the outline, where the picture is not defined; the polynomials leave their range there and give colors that no light has.",
  };
}

/** All light from behind the object. */
async function behind() {
  const light = windowed(sum(discLight([0, 0, -1], 1.1, [1.5, 1.35, 1.15]), ambient([0, 0, 0])));
  const scene = await Scene.create({ light, material: "silver-metallic-paint2" });
  const ours = scene.shade(x, y, z);
  const uniform = await Scene.create({ light: ambient(), material: "silver-metallic-paint2" });
  const naive = shadeNine(nineTerms(light, meanOf(pictureOf(uniform))), [...IDENTITY], [x, y, z]);
  const middle = x.findIndex((value, k) => Math.hypot(value, y[k]) < 0.01);
  const exposure = 0.9 / peakOf(ours);
  return {
    ours: image(pixels, ours, exposure),
    naive: image(pixels, naive, exposure),
    oursCaption: `Ours: ${percent(Math.abs(ours.g[middle]) / peakOf(ours))} of the peak in the middle`,
    naiveCaption: `Naive, nine terms: ${percent(Math.abs(naive.g[middle]) / peakOf(naive))} in the middle`,
    text: "All light comes from a disc behind the object, and none reaches its middle. The nine-term formula is Lambertian shading of degree 2: it lacks the gloss at grazing angles, and lets light through to the front.",
  };
}

/** A normal map of 8 bits. */
async function bytes() {
  const scene = await Scene.create({ light: "lobby", material: "gold-metallic-paint" });
  const exact = coinNormals(512);
  const coarse = exact.map((value, k) => (k % 4 === 3 ? 1 : (2 * Math.round(127.5 * (value + 1))) / 255 - 1));
  const pair = drawn((drawing) => {
    drawing.object(KINDS.map, coin());
    drawing.map(512, coarse, exact);
  }, scene, SHOWN.moved);
  return pair && {
    ...pair,
    oursCaption: "Ours, made unit: 10 × the error",
    naiveCaption: "Naive, as decoded: 10 × the error",
    text: "Normals of 8 bits are up to 0.7 % too long or too short, which high powers of z magnify; scaled to unit length, only their direction is off.",
  };
}

/** @type {Record<string, { title: string, make: () => Promise<Shown | undefined> }>} */
export const CASES = {
  sun: { title: "A sun of radiance 1e6", make: sun },
  direction: { title: "Light from one direction", make: direction },
  rim: { title: "Normals beyond the rim", make: rim },
  behind: { title: "All light from behind", make: behind },
  bytes: { title: "Normals of 8 bits", make: bytes },
};

/** The case that was asked for last; drawn once. */
let asked = "";

/** Draws a case of {@link CASES} in its panel. */
export async function showCase(/** @type {string} */ key) {
  if (asked === key) return;
  asked = key;
  const made = await CASES[key].make().catch((fault) => {
    // It may be tried again.
    if (asked === key) asked = "";
    throw fault;
  });
  if (asked !== key) return;
  for (const name of /** @type {const} */ (["ours", "naive"])) {
    const [picture, canvas, caption] = [made?.[name], find(`case-${name}`), find(`case-${name}-caption`)];
    if (picture instanceof ImageData) show(canvas, picture);
    else {
      canvas.width = canvas.height = 2 * SIDE;
      if (picture) canvas.getContext("2d")?.drawImage(picture, 0, 0);
    }
    caption.textContent = made?.[`${name}Caption`] ?? "";
    canvas.setAttribute("aria-label", caption.textContent || { ours: "Ours", naive: "Naive" }[name]);
  }
  find("case-text").textContent = made?.text ?? "This case needs WebGL 2, which this browser does not have.";
}
