// The turn of the light that follows a place, in Node.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { FIRST } from "../src/begin.js";
import { toward, wander } from "../src/follow.js";
import { LAMP, LIGHT, SOURCES } from "../src/parts.js";
import { rotate } from "../src/turn.js";
import { ROOT } from "./support.js";

/** Degrees from a turn to another. */
function degrees(a, b) {
  const sign = Math.sign(a.reduce((sum, along, k) => sum + along * b[k], 0)) || 1;
  return (720 / Math.PI) * Math.asin(Math.min(1, Math.hypot(...a.map((along, k) => along - sign * b[k])) / 2));
}

test("the lamp is the mean of the sources that are drawn, weighted by luminance", () => {
  const sources = readFileSync(join(ROOT, "tables/inputs/sources.csv"), "utf8").split("\n")
    .filter((line) => line.startsWith(`${LIGHT},`)).slice(0, SOURCES).map((line) => line.split(",").slice(1).map(Number));
  const luminance = ([, , , r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const sum = [0, 1, 2].map((axis) => sources.reduce((all, source) => all + luminance(source) * source[axis], 0));
  LAMP.forEach((along, axis) => assert.ok(Math.abs(along - sum[axis] / Math.hypot(...sum)) < 6e-4, `${LAMP} ${sum}`));
});

test("the lamp's highlight is at the place", () => {
  for (const [x, y] of [[0, 0], [0.5, -0.3], [-0.414, -0.03], [0.1, 0.79]]) {
    const lamp = rotate(toward([x, y]), LAMP);
    const half = [lamp[0], lamp[1], lamp[2] + 1].map((along, _, all) => along / Math.hypot(...all));
    assert.ok(Math.hypot(half[0] - x, half[1] - y) < 1e-3, `${x} ${y}: ${half}`);
  }
});

test("a step of 0.02 turns the light by at most 4 degrees", () => {
  for (let x = -1.6; x <= 1.6; x += 0.02) {
    for (let y = -1.6; y <= 1.6; y += 0.02) {
      for (const next of [[x + 0.02, y], [x, y + 0.02]]) {
        const by = degrees(toward([x, y]), toward(next));
        assert.ok(by <= 4, `${by} degrees from ${x} ${y} to ${next}`);
      }
    }
  }
});

test("the light that turns by itself does at most 2 degrees a frame", () => {
  for (let frame = 0; frame < 120 * 60; frame++) {
    const by = degrees(...[frame, frame + 1].map((k) => toward(wander(FIRST.place, k / 60))));
    assert.ok(by <= 2, `${by} degrees after ${frame / 60} s`);
  }
});
