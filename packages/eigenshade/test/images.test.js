// Images of all lights, read as a GPU reads them, against the module's scenes.

import assert from "node:assert/strict";
import { test } from "node:test";
import { readFileSync } from "node:fs";
import { DataUtils } from "three";
import { Scene, presetNames } from "../src/index.js";
import { Images, MARGIN } from "../src/images.js";
import { KNOTS, WEIGHTS } from "../src/roughness-weights.js";
import { illumination } from "../src/scene.js";

const COUNT = 1000;
const NORMALS = [0, 1, 2].map(() => new Float32Array(COUNT));
for (let k = 0; k < COUNT; k++) {
  const [sine, angle] = [Math.sqrt((k + 0.5) / COUNT), k * Math.PI * (3 - Math.sqrt(5))];
  [sine * Math.cos(angle), sine * Math.sin(angle), Math.sqrt(1 - sine * sine)].forEach((number, axis) => (NORMALS[axis][k] = number));
}

/** A texel of a layer between others, at a normal, in red. */
function sampled({ texels, side }, layer, k) {
  const [x, y] = [0, 1].map((axis) => side / 2 - 0.5 + ((side / 2 - MARGIN) * NORMALS[axis][k]) / Math.sqrt(1 + NORMALS[2][k]));
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const at = (a, b) => DataUtils.fromHalfFloat(texels[4 * ((layer * side + j + b) * side + i + a)]);
  const row = (b) => (1 - x + i) * at(0, b) + (x - i) * at(1, b);
  return (1 - y + j) * row(0) + (y - j) * row(1);
}

function weightsAt(roughness) {
  const place = ((roughness - 0.2) / 0.8) * (WEIGHTS.length / 5 - 1);
  const [row, share] = [Math.floor(place), place % 1];
  return KNOTS.map((_, k) => (1 - share) * WEIGHTS[5 * row + k] + share * WEIGHTS[5 * row + 5 + k]);
}

// The root mean square error of a white metal, as a share of white: of the median light, and of the worst.
for (const [roughness, one, blended] of [[0.2, [2.5e-3, 8e-3], [2.5e-3, 8e-3]], [0.25, [2e-3, 6e-3], [6e-3, 1.2e-2]], [0.5, [5e-4, 1.5e-3], [4e-3, 8e-3]], [0.9, [1e-4, 2e-4], [1e-3, 2e-3]]]) {
  test(`a white metal of roughness ${roughness} under all lights, without sources`, async () => {
    const errors = { one: [], blended: [] };
    for (const light of (await presetNames()).light) {
      const scene = await Scene.create({ light, material: { metallic: 1, roughness } });
      const exposure = (await Scene.create({ light, material: {} })).exposure();
      const turn = [0.3, 0.5, -0.2, 0.7].map((number) => number / Math.sqrt(0.87));
      const { r } = scene.turn(turn).shade(...NORMALS);
      const kinds = { one: [[roughness], [1]], blended: [KNOTS, weightsAt(roughness)] };
      for (const [kind, [roughnesses, weights]] of Object.entries(kinds)) {
        const images = new Images(roughnesses);
        images.fill(illumination(scene), turn, exposure);
        let sum = 0;
        for (let k = 0; k < COUNT; k++) {
          const lobe = weights.reduce((lobe, weight, knot) => lobe + weight * (sampled(images, 2 * knot + 1, k) + sampled(images, 2 * knot + 2, k)), 0);
          sum += (Math.max(0, lobe) - Math.max(0, exposure * r[k])) ** 2;
        }
        errors[kind].push(Math.sqrt(sum / COUNT));
      }
    }
    for (const [kind, bounds] of [["one", one], ["blended", blended]]) {
      const sorted = errors[kind].sort((a, b) => a - b);
      assert.ok(sorted.length > 20 && sorted[sorted.length >> 1] <= bounds[0] && sorted.at(-1) <= bounds[1], `${kind}: ${sorted[sorted.length >> 1]}, ${sorted.at(-1)}`);
    }
  });
}

test("the weights are those of the table", () => {
  const text = readFileSync(new URL("../../../tables/inputs/roughness-weights.csv", import.meta.url), "utf8");
  const rows = text.trim().split("\n").filter((line) => !line.startsWith("#")).slice(1);
  assert.deepEqual(WEIGHTS, rows.flatMap((row) => row.split(",").slice(1).map(Number)));
});
