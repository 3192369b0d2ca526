// Downloads: coefficients, shader, programs in Rust, C and Python, and the picture.

import { linear } from "./color.js";
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
 */

/** The library, and the page that says how to get it. */
export const LIBRARY = "eigenshade 0.1.0 (README.md of its repository)";

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
/** The sphere, and the differences of a program's picture from the page's. */
const title = (/** @type {Seen} */ { light, material, sources, window }, marks = "") => {
  const differences = [sources ? "its lamps are blurred (docs/highlights.md)" : "", window === "none" ? "" : "no window lessens its dark rings"];
  return [`A sphere of ${named(material)} under the light ${light}`, ...differences.filter(Boolean)].join(`;\n${marks} `) + ".";
};

/** A module that draws on any target. */
export function rust(/** @type {Seen} */ seen) {
  const { light, material, turn, exposure } = seen;
  const isNamed = typeof material === "string";
  return `//! ${title(seen, "//!")}
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
  return `/* ${title(seen, " *")}
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
  return `# ${title({ ...seen, sources: 0 }, "#")}
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
export const json = (/** @type {Scene} */ scene, /** @type {Seen} */ seen) => `${JSON.stringify({ ...seen, ...part(scene) }, null, 1)}\n`;

/** Saves a canvas's picture. */
export async function savePicture(/** @type {string} */ name, /** @type {HTMLCanvasElement} */ canvas) {
  const picture = await new Promise((/** @type {BlobCallback} */ done) => canvas.toBlob(done));
  if (!picture) throw new Error("This browser makes no PNG of the picture.");
  save(name, picture);
}

/** Saves a file. */
export function save(/** @type {string} */ name, /** @type {Blob | string} */ content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(typeof content === "string" ? new Blob([content]) : content);
  link.download = name;
  link.click();
  /** @type {HTMLElement} */ (document.getElementById("take-note")).textContent = `Saved ${name}`;
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
