// A window over the degrees of a light, where its picture would ring.

import { ofSources, sum, windowed } from "./harmonics.js";
import { pictureOf } from "./measure.js";
import { IDENTITY } from "./turn.js";

/** Windows from none to the strongest: stronger ones blur more than they mend. */
const WIDTHS = [Infinity, 40, 30, 24, 20, 17];

/** Views of all sides: a light may be turned. */
const HALF = Math.SQRT1_2;
const VIEWS = [IDENTITY, [0, 1, 0, 0], [0, HALF, 0, HALF], [0, -HALF, 0, HALF], [HALF, 0, 0, HALF], [-HALF, 0, 0, HALF]];

/**
 * The light with the weakest window over what its sources leave of which no picture of the material
 * has a negative value; the strongest window if none does.
 *
 * @param {import("../eigenshade/src/index.js").Scene} scene which it changes
 * @param {import("./state.js").Light & { sources: Float32Array }} light
 * @param {any} material
 */
export function calm(scene, light, material) {
  const [bright, rest] = [ofSources(light.sources), sum(light, ofSources(light.sources, -1))];
  scene.material(material);
  const least = () => Math.min(...VIEWS.flatMap((view) => Object.values(pictureOf(scene.turn(view))).map((channel) => channel.reduce((a, b) => Math.min(a, b)))));
  const windows = WIDTHS.map((width) => () => ({ ...sum(windowed(rest, width), bright), sources: light.sources }));
  const found = windows.find((make) => {
    scene.light(make());
    return least() >= 0;
  });
  scene.turn(IDENTITY);
  return (found ?? windows[windows.length - 1])();
}
