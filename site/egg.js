// node site/egg.js FILE.glb: the page's object, a jewelled egg of gold, enamel and pearls, as a glTF file.
// Its front half alone is made, because nothing else is seen.

import { writeFileSync } from "node:fs";
import { glb } from "../packages/eigenshade/test/support/glb.js";
import { srgb } from "./src/color.js";
import { GOLD } from "./src/gold.js";

/** Texels, and half of the longitudes that they cover. */
const [ACROSS, DOWN, EDGE] = [1536, 1536, 0.53 * Math.PI];
/** Wires and lozenges around the egg. */
const WIRES = 14;

const clamp = (x, least = 0, most = 1) => Math.min(most, Math.max(least, x));
const smooth = (from, to, x) => ((x = clamp((x - from) / (to - from))), x * x * (3 - 2 * x));

/** The radius and the height of the outline at t from 0 (top) to π, and their derivatives. */
function outline(t) {
  const [sine, cosine] = [Math.sin(t), Math.cos(t)];
  const wide = 0.8 - 0.1 * cosine;
  return { r: sine * wide, y: 1.03 * cosine, dr: cosine * wide + 0.1 * sine * sine, dy: -1.03 * sine };
}

// The places of the pattern, as angles from the top.
const [CAP, UPPER, LOWER, FOOT] = [0.36, 1.42, 1.86, 2.74];

const PEARL = { color: [0.86, 0.8, 0.72], metallic: 0, roughness: 0.35 };
const CREAM = { color: [0.83, 0.76, 0.62], metallic: 0, roughness: 0.35 };
const BLUE = { color: [0.03, 0.15, 0.6], metallic: 1, roughness: 0.44 };
const SAPPHIRE = { color: [0.02, 0.1, 0.5], metallic: 0, roughness: 0.35 };
const RUBY = { color: [0.5, 0.03, 0.05], metallic: 0, roughness: 0.35 };
const GROOVE = { color: [0.4, 0.25, 0.09], metallic: 1, roughness: 0.4 };

/** A round wire: the height over the distance, both in half widths. */
const wire = (distance) => Math.sqrt(Math.max(0, 1 - distance * distance));

/** The height and the material at a longitude and an angle from the top. */
function surface(phi, t) {
  const { r } = outline(t);
  // Rings of gold with beads, in units of the radius of the egg.
  for (const [at, width] of [[CAP, 0.045], [UPPER, 0.05], [LOWER, 0.05], [FOOT, 0.045]]) {
    const away = Math.abs(t - at) / width;
    if (away > 1.6) continue;
    const count = 2 * Math.round((Math.PI * r) / (2.1 * width));
    const along = ((Math.abs(phi) * count) / (2 * Math.PI)) % 1 - 0.5;
    const bead = Math.hypot((t - at) / width, (along * 2 * Math.PI * r) / count / width);
    if (bead < 0.98) return { height: width * (0.25 + 0.9 * wire(bead)), ...GOLD };
    return { height: width * 0.45 * wire(clamp((away - 1.2) / 0.4, -1, 1)), ...(away < 1 ? GROOVE : GOLD) };
  }
  if (t < CAP || t > FOOT) {
    // Flutes.
    const flute = Math.abs(Math.sin((phi * 28) / 2));
    return { height: 0.02 * flute * smooth(0, 0.15, Math.min(t, Math.PI - t)), ...GOLD };
  }
  if (t > UPPER && t < LOWER) return band(phi, (t - (UPPER + LOWER) / 2) / ((LOWER - UPPER) / 2));
  return trellis(phi, t, r);
}

/** The painted band: gold leaves on a wave and blue dots on cream enamel. */
function band(phi, up) {
  const x = ((Math.abs(phi) * WIRES) / (2 * Math.PI)) % 1 - 0.5;
  const [u, v] = [x * 2, up];
  // A flower of eight petals at each place, and dots between.
  const [radius, angle] = [Math.hypot(u * 0.95, v), Math.atan2(v, u * 0.95)];
  const petal = 0.34 + 0.3 * Math.abs(Math.cos(2 * angle));
  const [cx, cy] = [Math.abs(Math.abs(u) - 1), Math.abs(v)];
  const between = Math.hypot(cx * 0.95, cy - 0.42);
  const center = Math.hypot(cx * 0.95, cy);
  if (radius < 0.2) return { height: 0.03 * wire(radius / 0.2), ...GOLD };
  if (radius < petal) return { height: 0.012, ...SAPPHIRE };
  if (radius < petal + 0.05) return { height: 0.014, ...GOLD };
  if (between < 0.13) return { height: 0.01, ...RUBY };
  if (center < 0.1) return { height: 0.02 * wire(center / 0.1), ...GOLD };
  return { height: 0, ...CREAM };
}

/** Gold wires that cross, with pearls on the crossings, over engraved blue. */
function trellis(phi, t, r) {
  // Mercator's map has no distortion: lozenges shrink toward the ends.
  const up = Math.log(Math.tan(t / 2));
  const [a, b] = [phi + up, phi - up].map((x) => ((x * WIRES) / (2 * Math.PI) + 1e3) % 1 - 0.5);
  // The side of a lozenge.
  const side = (2 * Math.PI * r) / WIRES / Math.SQRT2;
  const [near, far] = [Math.abs(a), Math.abs(b)].map((x) => 0.5 - x);
  const pearl = Math.hypot(near, far) / 0.19;
  if (pearl < 1) return { height: side * (0.05 + 0.17 * wire(pearl)), ...PEARL };
  if (pearl < 1.25) return { height: side * 0.05, ...GROOVE };
  const away = Math.min(near, far) / 0.06;
  if (away < 1) return { height: side * 0.075 * wire(away), ...GOLD };
  // Rays from the middle of the lozenge, engraved, around a gold stud.
  const [radius, angle] = [Math.hypot(a, b), Math.atan2(a, b)];
  if (radius < 0.075) return { height: side * 0.05 * wire(radius / 0.075), ...GOLD };
  return { height: side * 0.012 * Math.cos(16 * angle) * smooth(0.03, 0.2, radius), ...BLUE };
}

function textures() {
  const count = ACROSS * DOWN;
  const heights = new Float32Array(count);
  const [base, mr, normal] = [0, 1, 2].map(() => new Uint8Array(4 * count).fill(255));
  const phiOf = (column) => (((column + 0.5) / ACROSS) * 2 - 1) * EDGE;
  const tOf = (row) => ((row + 0.5) / DOWN) * Math.PI;
  for (let row = 0; row < DOWN; row++) {
    for (let column = 0; column < ACROSS; column++) {
      const at = row * ACROSS + column;
      const { height, color, metallic, roughness } = surface(phiOf(column), tOf(row));
      heights[at] = height;
      base.set(color.map((x) => Math.round(srgb(x))), 4 * at);
      mr.set([0, Math.round(255 * roughness), 255 * metallic], 4 * at);
    }
  }
  for (let row = 0; row < DOWN; row++) {
    const { r, dr, dy } = outline(tOf(row));
    const [east, south] = [(r * 2 * EDGE) / ACROSS, (Math.hypot(dr, dy) * Math.PI) / DOWN];
    for (let column = 0; column < ACROSS; column++) {
      const [left, right] = [Math.max(0, column - 1), Math.min(ACROSS - 1, column + 1)];
      const [above, below] = [Math.max(0, row - 1), Math.min(DOWN - 1, row + 1)];
      const x = -(heights[row * ACROSS + right] - heights[row * ACROSS + left]) / ((right - left) * east);
      const y = (heights[below * ACROSS + column] - heights[above * ACROSS + column]) / ((below - above) * south);
      const length = Math.hypot(x, y, 1);
      normal.set([x, y, 1].map((along) => Math.round(255 * (0.5 + (0.5 * along) / length))), 4 * (row * ACROSS + column));
    }
  }
  const image = (texels) => ({ width: ACROSS, height: DOWN, texels });
  return { base: image(base), mr: image(mr), normal: image(normal) };
}

function mesh([across, down] = [128, 160]) {
  const [positions, normals, tangents, uvs, indices] = [[], [], [], [], []];
  for (let row = 0; row <= down; row++) {
    const t = Math.PI * clamp(row / down, 1e-4, 1 - 1e-4);
    const { r, y, dr, dy } = outline(t);
    const length = Math.hypot(dr, dy);
    for (let column = 0; column <= across; column++) {
      const phi = ((2 * column) / across - 1) * EDGE;
      const [sine, cosine] = [Math.sin(phi), Math.cos(phi)];
      positions.push(r * sine, y, r * cosine);
      normals.push((-dy / length) * sine, dr / length, (-dy / length) * cosine);
      tangents.push(cosine, 0, -sine, 1);
      uvs.push(column / across, t / Math.PI);
    }
  }
  for (let row = 0; row < down; row++) {
    for (let column = 0; column < across; column++) {
      const [a, b] = [row, row + 1].map((at) => at * (across + 1) + column);
      indices.push(a, b, b + 1, a, b + 1, a + 1);
    }
  }
  return { positions, normals, tangents, uvs, indices };
}

writeFileSync(process.argv[2], glb({
  shape: mesh(),
  images: textures(),
  material: {
    pbrMetallicRoughness: { baseColorTexture: { index: "base" }, metallicRoughnessTexture: { index: "mr" } },
    normalTexture: { index: "normal" },
  },
  more: { samplers: [{ magFilter: 9729, minFilter: 9987, wrapS: 33071, wrapT: 33071 }] },
}));
