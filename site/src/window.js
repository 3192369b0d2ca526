// A window over the degrees of a light, where its picture would ring.

import { ofSources, sum, windowed } from "./harmonics.js";
import { pictureOf } from "./measure.js";

/** Windows from none to the strongest: stronger ones blur more than they mend. */
const WIDTHS = [Infinity, 40, 30, 24, 20, 17, 14.5];

/** Values below black that do not show, as a share of white. */
const DARKEST = -0.002;

/**
 * The light with the weakest window over what its sources leave with which the picture of the
 * material has no negative value that shows; the strongest window if none does.
 *
 * @param {import("../eigenshade/src/index.js").Scene} scene which is given light and material
 * @param {import("./state.js").Light & { sources: Float32Array }} light
 * @param {any} material
 */
export function calm(scene, light, material) {
  const exposure = scene.light(light).material(material).exposure();
  // A matte material is drawn without sources.
  const drawn = scene.isGlossy ? light.sources : new Float32Array();
  const [bright, rest] = [ofSources(drawn), sum(light, ofSources(drawn, -1))];
  const least = () => Math.min(...Object.values(pictureOf(scene)).map((channel) => channel.reduce((a, b) => Math.min(a, b))));
  let calmed = light;
  for (const width of WIDTHS) {
    calmed = { ...light, ...sum(windowed(rest, width), bright) };
    scene.light(calmed);
    if (exposure * least() >= DARKEST) break;
  }
  return calmed;
}
