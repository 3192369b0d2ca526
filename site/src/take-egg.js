// A download of the first sight: the egg's coefficients, shader and programs.

import { EFFECTS } from "../eigenshade/src/index.js";
import { CURVE, srgb } from "./color.js";
import { GOLD } from "./gold.js";
import { LIGHT, SOURCES } from "./parts.js";
import { COMPONENTS } from "./state.js";
import { LIBRARY, SHIPPED, decimal, floats, glsl, numbers, part, python, titled, upper } from "./take.js";

/**
 * @typedef {object} Seen
 * @property {number[]} turn of the light
 * @property {number} exposure
 * @property {{ metallic: number, roughness: number }[]} regions
 * @property {number} tolerance the share of white within which terms are left out, or 0
 */

const FILE = "node site/egg.js egg.glb, then eigenshade pack-object egg.glb --size 240 --out";
/** What the page shows whatever the slider says. */
const SHOWN = { sources: SOURCES, window: /** @type {const} */ ("none"), effects: [...EFFECTS], components: COMPONENTS };
const title = (/** @type {number} */ tolerance, /** @type {string} */ marks) =>
  titled(`The egg under the light ${LIGHT}`, { ...SHOWN, tolerance }, marks, SHIPPED);

/** A module that draws on any target. */
export const rust = (/** @type {Seen} */ { turn, exposure, tolerance }) => `//! ${title(tolerance, "//!")}
//! With ${LIBRARY}.
//! Cargo.toml: eigenshade = { path = "../eigenshade", features = ["presets"] }
//! The object: ${FILE} egg.rs

use eigenshade::object::Object;
use eigenshade::presets::light::${upper(LIGHT)};
use eigenshade::screen::{Display, Exposure, LinearPalette, Target, Tone};
use eigenshade::sphere::color;
use eigenshade::{Error, Material, Rotation};

static DISPLAY: Display = Display::new(Tone::Filmic);

/// Draws \`egg::OBJECT\` with a palette for each of its regions.
pub fn draw(
    egg: &Object<'_>,
    palettes: &mut [LinearPalette],
    screen: &mut Target<'_>,
) -> Result<(), Error> {
    let rotation = Rotation::from_quaternion([${numbers(turn)}])?;
    let light = ${upper(LIGHT)}.turned::<100>(&rotation)?;
    let exposure = Exposure::new(${decimal(exposure)})?;
    for (k, (region, palette)) in egg.regions().zip(palettes.iter_mut()).enumerate() {
        let [tinted, plain] = region.materials()?;
        let tinted = color::scene(light.lights()?, Material::new(&tinted)?)?;
        let plain = color::scene(light.lights()?, Material::new(&plain)?)?;
        palette.fill(&egg.nodes(k), |normal| {
            [&tinted, &plain].map(|part| exposure.of(part.shade(normal)))
        });
    }
    egg.painted(palettes, &DISPLAY)?.draw(screen);
    Ok(())
}
`;

/** A function that draws on any target. */
export const c = (/** @type {Seen} */ { turn, exposure, regions, tolerance }) => `/* ${title(tolerance, " *")}
 * With the headers and the library of crates/capi, from ${LIBRARY}.
 * The object: ${FILE} egg.h */
#include "eigenshade_presets.h"
#include "egg.h"

enum { REGIONS = ${regions.length} };

eigenshade_status draw(const eigenshade_target_t *target) {
  static const float turn[4] = {${floats(turn)}};
  static eigenshade_light_buffer_f32_t turned;
  static eigenshade_material_buffer_f32_t materials;
  static eigenshade_color_material_f32_t of_tinted, of_plain;
  static eigenshade_picture_f32_t tinted, plain;
  static eigenshade_nodes_t nodes;
  static eigenshade_linear_palette_t palettes[REGIONS];
  eigenshade_color_light_f32_t light;
  eigenshade_status status =
      eigenshade_turn_f32(&eigenshade_light_${LIGHT}_f32, turn, &turned, &light);
  for (size_t k = 0; !status && k < REGIONS; k++) {
    status = eigenshade_nodes_of_region(&object_egg, k, &nodes);
    if (!status)
      status = eigenshade_region_materials_f32(&object_egg, k, &materials, &of_tinted, &of_plain);
    if (!status) status = eigenshade_picture_begin_f32(&light, &of_tinted, &tinted);
    if (!status) status = eigenshade_picture_begin_f32(&light, &of_plain, &plain);
    if (!status)
      status = eigenshade_linear_palette_fill_f32(&tinted, &plain, ${floats([exposure])}, &nodes, &palettes[k]);
  }
  if (status) return status;
  return eigenshade_object_draw(&object_egg, palettes, REGIONS, &eigenshade_display_filmic, target);
}
`;

/** A script that draws a sphere of the egg's gold, because Python draws no textures. */
const pythonOf = (/** @type {Seen} */ { turn, exposure, tolerance }) => {
  const baseColor = `#${GOLD.color.map((x) => Math.round(srgb(x)).toString(16).padStart(2, "0")).join("")}`;
  return python({ ...SHOWN, light: LIGHT, material: { ...GOLD, baseColor }, turn, exposure, tolerance });
};

const NAMES = ["black", "white"];

/**
 * Functions of GLSL ES 3.00 of a black and a white base color of each region, and one for all.
 *
 * @param {import("./take.js").Scene[]} scenes two of each region
 * @param {Seen} seen
 */
function shader(scenes, { exposure, regions }) {
  const prefix = (/** @type {number} */ k) => `${NAMES[k % 2]}${k >> 1}_`;
  const cases = scenes.filter((_, k) => k % 2).map((_, region) => {
    const [black, white] = [0, 1].map((base) => `${prefix(2 * region + base)}irradiance(normal)`);
    return `  ${region < scenes.length / 2 - 1 ? `if (region == ${region}) ` : ""}return mix(${black}, ${white}, base);`;
  });
  const text = scenes.map((scene, k) => glsl(scene, prefix(k), `Region ${k >> 1}, ${NAMES[k % 2]}`));
  const list = regions.map(({ metallic, roughness }, k) => `//   ${k}: metallic ${decimal(metallic)}, roughness ${decimal(roughness)}`);
  return `// The egg under the light ${LIGHT}, with ${LIBRARY}.
// Regions, in the order of the file of ${FILE} egg.bin:
${list.join("\n")}
// Color of a pixel: x = ${decimal(exposure)} * irradiance(region, base, normal), clipped below 0, then
// ${CURVE}, clipped above 1, then sRGB.
${text.join("\n")}
// The irradiance of a unit normal, x to the right, y up, z toward the camera, of a linear base color.
vec3 irradiance(int region, vec3 base, vec3 normal) {
${cases.join("\n")}
}
`;
}

/**
 * The coefficients of the eigenimages of a black and a white base color of each region.
 *
 * @param {import("./take.js").Scene[]} scenes two of each region
 * @param {Seen} seen
 */
function json(scenes, { turn, exposure, regions, tolerance }) {
  const [black, white] = [0, 1].map((base) => scenes.filter((_, k) => k % 2 === base).map(part));
  const parts = regions.map(({ metallic, roughness }, k) => ({ metallic, roughness, black: black[k], white: white[k] }));
  return `${JSON.stringify({ light: LIGHT, turn, exposure, tolerance, regions: parts }, null, 1)}\n`;
}

/**
 * The text of each kind of file.
 *
 * @param {import("./take.js").Scene[]} scenes two of each region
 * @param {Seen} seen
 */
export const texts = (scenes, seen) => ({
  json: () => json(scenes, seen), glsl: () => shader(scenes, seen), rs: () => rust(seen), c: () => c(seen), py: () => pythonOf(seen),
});
