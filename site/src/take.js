// Downloads of the details: coefficients, shader, and programs in Rust, C and Python.

import { EFFECTS } from "../eigenshade/src/index.js";
import { linear } from "./color.js";
import { ANALYTIC } from "./harmonics.js";
import { percent } from "./plot.js";
import { COMPONENTS } from "./state.js";
import { inverse, matrix } from "./turn.js";

/** @typedef {import("../eigenshade/src/index.js").Scene} Scene */

/**
 * The sphere that the texts describe.
 *
 * @typedef {object} Seen
 * @property {string} light a shipped one
 * @property {string | import("./state.js").Gltf} material
 * @property {number[]} turn of the light
 * @property {number} exposure
 * @property {number} sources how many are drawn
 * @property {number | "none"} window its width in degrees
 * @property {string[]} effects those that are kept
 * @property {number} components how many eigenimages are kept
 * @property {number} tolerance the share of white within which terms are left out, or 0
 */

/** The library, and the page that says how to get it. */
export const LIBRARY = "eigenshade 0.1.0 (README.md of its repository)";

/** The eigenimages of its table in Rust and C; in Python it has the page's. */
export const SHIPPED = 46;

/** A number as Rust has it. */
export const decimal = (/** @type {number} */ value) => {
  const text = String(Number(value.toPrecision(6)));
  return /[.e]/.test(text) ? text : `${text}.0`;
};
export const numbers = (/** @type {number[]} */ list) => list.map(decimal).join(", ");
export const floats = (/** @type {number[]} */ list) => list.map((value) => `${decimal(value)}f`).join(", ");

export const upper = (/** @type {string} */ name) => name.toUpperCase().replaceAll("-", "_");

/** Linear red, green and blue of "#rrggbb". */
const channels = (/** @type {string} */ color) => [1, 3, 5].map((at) => linear(parseInt(color.slice(at, at + 2), 16) / 255));

/** The window of a scene, as {@link Scene} takes it. */
export const windowOf = (/** @type {Scene} */ { windowWidth }) => (Number.isFinite(windowWidth) ? windowWidth : "none");

const named = (/** @type {Seen["material"]} */ material) => (typeof material === "string" ? material : "a glTF material");
const title = (/** @type {Seen} */ seen, /** @type {string} */ marks, /** @type {number} */ images) =>
  titled(`A sphere of ${named(seen.material)} under the light ${seen.light}`, seen, marks, images);

/**
 * The title of a program, with the differences of its picture from the page's: a comment whose lines
 * begin with these marks.
 *
 * @param {string} text
 * @param {Pick<Seen, "sources" | "window" | "effects" | "components" | "tolerance">} seen
 * @param {string} marks
 * @param {number} images how many eigenimages the program has
 */
export function titled(text, { sources, window, effects, components, tolerance }, marks, images) {
  const without = EFFECTS.filter((effect) => !effects.includes(effect));
  const differences = [
    sources ? "its lamps are blurred (docs/highlights.md)" : "",
    window === "none" ? "" : "no window lessens its dark rings",
    without.length ? `it has ${without.join(", ")}, which the page left out` : "",
    Math.min(images, components) < COMPONENTS ? `it has ${images} eigenimages, the page's picture ${components} of ${COMPONENTS}` : "",
    tolerance ? `it has all terms; the page left some out, within ${percent(tolerance)} of white` : "",
  ];
  return [text, ...differences.filter(Boolean)].join(`;\n${marks} `) + ".";
}

/** A module that draws on any target. */
export function rust(/** @type {Seen} */ seen) {
  const { light, material, turn, exposure } = seen;
  const isNamed = typeof material === "string";
  return `//! ${title(seen, "//!", SHIPPED)}
//! With ${LIBRARY}.
//! Cargo.toml: eigenshade = { path = "../eigenshade", features = ["presets"] }

use eigenshade::object::Disc;
use eigenshade::presets::light::${upper(light)};
${isNamed ? `use eigenshade::presets::material::${upper(material)};\n` : ""}use eigenshade::screen::{Display, Exposure, Target, Tone};
use eigenshade::{${isNamed ? "" : "Material, "}Rotation, sphere};

static DISPLAY: Display = Display::new(Tone::Filmic);

pub fn draw(screen: &mut Target<'_>) -> Result<(), eigenshade::Error> {
    let rotation = Rotation::from_quaternion([${numbers(turn)}])?;
    let light = ${upper(light)}.turned::<100>(&rotation)?;
${isNamed ? "" : `    let color = [${numbers(channels(material.baseColor))}]; // linear
    let material = Material::metallic_roughness(color, ${decimal(material.metallic)}, ${decimal(material.roughness)})?;
`}    let scene = sphere::color::scene(light.lights()?, ${isNamed ? upper(material) : "material.materials()?"})?;
    let exposure = Exposure::new(${decimal(exposure)})?;
    for pixel in Disc::new(240)? {
        pixel.put(screen, DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal()))));
    }
    Ok(())
}
`;
}

/** A function that draws on any target. */
export function c(/** @type {Seen} */ seen) {
  const { light, material, turn, exposure } = seen;
  const lower = (/** @type {string} */ name) => name.replaceAll("-", "_");
  const isNamed = typeof material === "string";
  return `/* ${title(seen, " *", SHIPPED)}
 * With the headers and the library of crates/capi, from ${LIBRARY}. */
#include "eigenshade_presets.h"

eigenshade_status draw(const eigenshade_target_t *target) {
  static const float turn[4] = {${floats(turn)}};
  static eigenshade_light_buffer_f32_t turned;
  static eigenshade_picture_f32_t picture;
  eigenshade_color_light_f32_t light;
${isNamed ? "" : `  static const float color[3] = {${floats(channels(material.baseColor))}}; /* linear */
  static eigenshade_material_buffer_f32_t buffer;
  eigenshade_color_material_f32_t material;
`}  eigenshade_status status =
      eigenshade_turn_f32(&eigenshade_light_${lower(light)}_f32, turn, &turned, &light);
${isNamed ? "" : `  if (!status)
    status = eigenshade_metallic_roughness_f32(color, ${floats([material.metallic])}, ${floats([material.roughness])}, &buffer, &material);
`}  if (!status)
    status = eigenshade_picture_begin_f32(&light, &${isNamed ? `eigenshade_material_${lower(material)}_f32` : "material"}, &picture);
  if (status) return status;
  return eigenshade_picture_draw_disc_f32(&picture, 240, ${floats([exposure])}, &eigenshade_display_filmic, target);
}
`;
}

/** A script that writes a picture in sRGB, without the page's curve. */
export function python(/** @type {Seen} */ seen) {
  const { light, material, turn, exposure, sources } = seen;
  const { yaw, pitch, roll } = angles(turn);
  const made = typeof material === "string"
    ? `es.materials["${material}"]`
    : `es.Material.gltf("${material.baseColor}", metallic=${decimal(material.metallic)}, roughness=${decimal(material.roughness)})`;
  return `# ${title({ ...seen, sources: 0 }, "#", COMPONENTS)}
# With ${LIBRARY}.
import eigenshade as es
import numpy as np

light = es.lights["${light}"].rotated(yaw=${decimal(yaw)}, pitch=${decimal(pitch)}, roll=${decimal(roll)})
material = ${made}
image = es.Table().render(light, material, size=240, sources=${sources})  # linear, and coverage
color = np.clip(${decimal(exposure)} * image[..., :3], 0, 1)
color = np.where(color <= 0.0031308, 12.92 * color, 1.055 * color ** (1 / 2.4) - 0.055)  # sRGB
with open("sphere.ppm", "wb") as file:
    file.write(b"P6 240 240 255\\n" + (255 * color * image[..., 3:] + 0.5).astype(np.uint8).tobytes())
`;
}

/** The angles of Ry(yaw) Rx(pitch) Rz(roll). */
export function angles(/** @type {number[]} */ turn) {
  // Row by row: that of the inverse is its transpose.
  const rows = matrix(inverse(turn));
  const at = (/** @type {number} */ row, /** @type {number} */ column) => rows[3 * row + column];
  return {
    yaw: Math.atan2(at(0, 2), at(2, 2)),
    pitch: Math.asin(Math.max(-1, Math.min(1, -at(1, 2)))),
    roll: Math.atan2(at(1, 0), at(1, 1)),
  };
}

/** A function of GLSL ES 3.00 with its numbers, whose names begin with a prefix. */
export function glsl(/** @type {Scene} */ scene, prefix = "", title = scene.label) {
  const array = scene.uniforms();
  const vectors = Array.from({ length: array.length / 4 }, (_, k) => `  vec4(${numbers([...array.subarray(4 * k, 4 * k + 4)])})`);
  const text = scene.glsl("uniforms", prefix ? { prefix } : {});
  const name = `vec4 ${prefix}eigenshade[${vectors.length}]`;
  const declared = `uniform ${name};`;
  if (!text.startsWith(declared)) throw new Error("the shader does not begin with its array");
  return `// ${title}: irradiance of a unit normal, x to the right, y up, z toward the camera.
const ${name} = vec4[](
${vectors.join(",\n")}
);${text.slice(declared.length)}`;
}

/** The coefficients of the eigenimages of the table `color`, for light without drawn sources. */
export function part(/** @type {Scene} */ scene) {
  const { sources, degree, order, terms } = scene;
  const d = Object.fromEntries(Object.entries(scene.coefficients()).map(([channel, of]) => [channel, [...of]]));
  return { sources, window: windowOf(scene), degree, order, terms, d };
}

/** The same, with the scene. */
const json = (/** @type {Scene} */ scene, /** @type {Seen} */ seen) => `${JSON.stringify({ ...seen, ...part(scene) }, null, 1)}\n`;

/** The text of each kind of file. */
export const texts = (/** @type {Scene} */ scene, /** @type {Seen} */ seen) => {
  const program = (/** @type {(seen: Seen) => string} */ write) => () => {
    if (seen.light === "own" || Object.hasOwn(ANALYTIC, seen.light)) throw new Error("Programs are of captured lights; take the coefficients.");
    return write(seen);
  };
  return { json: () => json(scene, seen), glsl: () => glsl(scene), rs: program(rust), c: program(c), py: program(python) };
};
