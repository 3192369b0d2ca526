// How the page begins: its first light and accuracy.

import { toleranceOf } from "./measure.js";
import { Parts } from "./parts.js";
import { toward } from "./follow.js";

/** The slider's step, and the place of the highlight, from -1 to 1 to the right and up. */
export const FIRST = { step: 25, place: [-0.3, 0.35] };

/** How much brighter than a white sphere the object is exposed: its base colors are darker. */
const BRIGHTER = 1.5;

/** @param {{ metallic: number, roughness: number }[]} regions */
export async function began(regions) {
  const parts = await Parts.create(regions);
  const exposure = BRIGHTER * parts.exposure();
  parts.set(toward(FIRST.place), toleranceOf(FIRST.step), exposure);
  return { parts, exposure, palettes: parts.palettes(exposure) };
}
