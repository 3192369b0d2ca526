//! Three channels in floats: a turned light on a material as a scene, as the vectors of a shader,
//! and as its text. Every function returns 0 if its input is missing or invalid.

use crate::table::{BASIS, COMPONENTS, DEGREE, SCENE, TRANSFER, WORKSPACE};
use crate::{LIGHT_COUNT, MATERIAL_COUNT, Shared};
use core::fmt;
use eigenshade::{
    Effect, Effects, Light, Material, Rgb, Rotation, Scene, Shader, ShaderLanguage, Shape,
    Tolerance, Truncation,
};

/// The light of the next `color_relight`, channel by channel.
#[unsafe(export_name = "color_light")]
pub(crate) static LIGHT: Shared<[[f32; LIGHT_COUNT]; 3]> = Shared::new([[0.0; LIGHT_COUNT]; 3]);
/// The quaternion (x, y, z, w) by which the light is turned.
#[unsafe(export_name = "color_turn")]
pub(crate) static TURN: Shared<[f32; 4]> = Shared::new(UNTURNED);
/// The quaternion of no rotation.
const UNTURNED: [f32; 4] = [0.0, 0.0, 0.0, 1.0];
/// The material of the next `color_transfer`, channel by channel.
#[unsafe(export_name = "color_material")]
static MATERIAL: Shared<[[f32; MATERIAL_COUNT]; 3]> = Shared::new([[0.0; MATERIAL_COUNT]; 3]);
/// Base color, metallic and roughness of the next `color_metallic_roughness`.
#[unsafe(export_name = "color_parameters")]
static PARAMETERS: Shared<[f32; 5]> = Shared::new([0.0; 5]);
/// The coefficients d, channel by channel.
#[unsafe(export_name = "color_d")]
static D: Shared<[[f32; COMPONENTS]; 3]> = Shared::new([[0.0; COMPONENTS]; 3]);
/// Terms, azimuths, bound, estimated error of the table and peak of the last `color_truncate`.
#[unsafe(export_name = "color_report")]
static REPORT: Shared<[f32; 5]> = Shared::new([0.0; 5]);

static TRANSFERS: Shared<[[f32; TRANSFER]; 3]> = Shared::new([[0.0; TRANSFER]; 3]);
static ROOM: Shared<[f32; WORKSPACE]> = Shared::new([0.0; WORKSPACE]);

/// The scene: its polynomials, channel by channel, and their lengths.
pub static COLLAPSED: Shared<Collapsed> =
    Shared::new(Collapsed { numbers: [0.0; 3 * SCENE], lengths: [0; DEGREE + 1] });

/// A scene in three channels.
pub struct Collapsed {
    numbers: [f32; 3 * SCENE],
    lengths: [u16; DEGREE + 1],
}

impl Collapsed {
    /// The channels, or `None` before the first scene.
    pub fn scene(&self) -> Option<Rgb<Scene<'_, &[f32]>>> {
        let shape = Shape { components: COMPONENTS, lengths: &self.lengths };
        let (channels, _) = self.numbers.as_chunks::<SCENE>();
        let [r, g, b] = channels else { return None };
        Rgb::new(r, g, b).try_map(|numbers| shape.scene(&numbers[..])).ok()
    }
}

/// The coefficients of a glTF material, from the parameters.
#[unsafe(no_mangle)]
extern "C" fn color_metallic_roughness() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (&mut [r, g, b, metallic, roughness], material) =
        unsafe { (PARAMETERS.borrow(), MATERIAL.borrow()) };
    let Ok(found) = Material::metallic_roughness([r, g, b], metallic, roughness) else { return 0 };
    for (to, from) in material.iter_mut().zip(<[_; 3]>::from(found)) {
        to.fill(0.0);
        to.iter_mut().zip(from.iter()).for_each(|(to, &from)| *to = from);
    }
    1
}

/// The transfers of the material, for the effects whose bits are set: ambient, diffuse, broad and
/// gloss from the lowest.
#[unsafe(no_mangle)]
extern "C" fn color_transfer(effects: u32) -> u32 {
    let mut of = Effects::NONE;
    for (bit, effect) in Effect::ALL.into_iter().enumerate() {
        if effects >> bit & 1 == 1 {
            of = of.with(effect);
        }
    }
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (materials, room, transfers) =
        unsafe { (MATERIAL.borrow(), ROOM.borrow(), TRANSFERS.borrow()) };
    let done = materials.iter().zip(transfers).all(|(material, transfer)| {
        Material::from_finite(material)
            .and_then(|material| BASIS.transfer_effects_into(&material, of, room, transfer))
            .is_ok()
    });
    done.into()
}

/// The coefficients d of the turned light on the material of the last `color_transfer`; 0 also if
/// one is not finite.
#[unsafe(no_mangle)]
extern "C" fn color_relight() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (light, turn, transfers, d) =
        unsafe { (LIGHT.borrow(), TURN.borrow(), TRANSFERS.borrow(), D.borrow()) };
    let [r, g, b] = light;
    let Ok(lights) = Rgb::new(r, g, b).try_map(|numbers| Light::from_finite(&numbers[..])) else {
        return 0;
    };
    let turned;
    let lights = if *turn == UNTURNED {
        lights
    } else {
        let Ok(rotation) = Rotation::from_quaternion(*turn) else { return 0 };
        let Ok(found) = lights.turned::<LIGHT_COUNT>(&rotation) else { return 0 };
        turned = found;
        let Ok(lights) = turned.lights() else { return 0 };
        lights
    };
    let channels = <[_; 3]>::from(lights).into_iter().zip(transfers).zip(d);
    let mut done = true;
    for ((light, transfer), d) in channels {
        done &= BASIS.relight_into(&transfer[..], &light, d).is_ok();
        // A sum of magnitudes: as large as any irradiance, about.
        done &= d.iter().map(|d| d.abs()).sum::<f32>().is_finite();
    }
    done.into()
}

/// Collapses d to a scene with all terms.
#[unsafe(no_mangle)]
extern "C" fn color_collapse() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (d, Collapsed { numbers, lengths }) = unsafe { (D.borrow(), COLLAPSED.borrow()) };
    let (channels, _) = numbers.as_chunks_mut::<SCENE>();
    let mut done = true;
    for (d, numbers) in d.iter().zip(channels) {
        done &= BASIS.collapse_into(d, numbers).is_ok();
    }
    *lengths = [0; DEGREE + 1];
    for (to, &from) in lengths.iter_mut().zip(BASIS.parts().lengths) {
        *to = from;
    }
    done.into()
}

/// Collapses d to a scene with as few terms as a share of white under an exposure allows, and writes
/// the report.
#[unsafe(no_mangle)]
extern "C" fn color_truncate(share: f32, exposure: f32) -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (d, Collapsed { numbers, lengths }, report) =
        unsafe { (D.borrow(), COLLAPSED.borrow(), REPORT.borrow()) };
    let mut reports = [Truncation::default(); 3];
    let mut found = [0; DEGREE + 1];
    let tolerance = Tolerance::OfWhite { share, exposure };
    let shape = BASIS.collapse_set_within(&d[..], 3, tolerance, &mut found, numbers, &mut reports);
    let Ok(shape) = shape else { return 0 };
    *lengths = [0; DEGREE + 1];
    for (to, &from) in lengths.iter_mut().zip(shape.lengths) {
        *to = from;
    }
    let most = |of: fn(&Truncation) -> f32| reports.iter().map(of).fold(0.0, f32::max);
    *report = [
        shape.terms() as f32,
        shape.azimuths() as f32,
        most(|report| report.bound),
        most(|report| report.floor),
        most(|report| report.peak),
    ];
    1
}

/// Vectors of a shader's array: those of all terms and sources.
const VECTORS: usize = SCENE + OF_SOURCES;
#[cfg(feature = "sources")]
const OF_SOURCES: usize = 1 + 4 * eigenshade_table::highlights::MAX_SOURCES;
#[cfg(not(feature = "sources"))]
const OF_SOURCES: usize = 0;
/// The array of the shader of the last `color_vectors`.
#[unsafe(export_name = "color_array")]
static ARRAY: Shared<[[f32; 4]; VECTORS]> = Shared::new([[0.0; 4]; VECTORS]);

/// Terms of the scene.
#[unsafe(no_mangle)]
extern "C" fn color_terms() -> usize {
    // SAFETY: no other function runs.
    let scene = unsafe { COLLAPSED.borrow() }.scene();
    scene.map_or(0, |scene| Shader::new(&scene.r).terms())
}

/// Writes the scene as the array of its shader. Returns the number of vectors.
#[unsafe(no_mangle)]
extern "C" fn color_vectors() -> usize {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (collapsed, array) = unsafe { (COLLAPSED.borrow(), ARRAY.borrow()) };
    let Some(scene) = collapsed.scene() else { return 0 };
    let shader = shader(&scene.r);
    if shader.uniforms(scene.each_ref(), array).is_err() {
        return 0;
    }
    #[cfg(feature = "sources")]
    // SAFETY: as above.
    if let Some(highlights) = unsafe { crate::highlights::HIGHLIGHTS.borrow() }
        && shader.highlight_uniforms(highlights, array).is_err()
    {
        return 0;
    }
    shader.vectors()
}

/// The shader of a scene, and of the highlights of the last `color_highlights`.
fn shader<'a>(scene: &Scene<'a, &[f32]>) -> Shader<'a> {
    let shader = Shader::new(scene);
    #[cfg(feature = "sources")]
    // SAFETY: no other function borrows it now.
    let sources = unsafe { crate::highlights::HIGHLIGHTS.borrow() }.as_ref().map_or(0, |h| h.len());
    #[cfg(feature = "sources")]
    let shader = shader.with_sources(sources).unwrap_or(shader);
    shader
}

/// The text of the shader of the last `color_shader`.
#[unsafe(export_name = "color_text")]
static TEXT: Shared<[u8; TEXT_LEN]> = Shared::new([0; TEXT_LEN]);
/// Bytes of the longest text: at most 160 for a term.
const TEXT_LEN: usize = 1024 + 160 * VECTORS;

/// Writes the text of the scene's shader in the language of this number. Returns its length.
#[unsafe(no_mangle)]
extern "C" fn color_shader(language: u32) -> usize {
    let language = match language {
        0 => ShaderLanguage::Glsl,
        1 => ShaderLanguage::GlslBlock,
        2 => ShaderLanguage::GlslTexture,
        3 => ShaderLanguage::Wgsl,
        _ => return 0,
    };
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (collapsed, text) = unsafe { (COLLAPSED.borrow(), TEXT.borrow()) };
    let Some(scene) = collapsed.scene() else { return 0 };
    let mut text = Text { rest: text, written: 0 };
    if shader(&scene.r).write(language, &mut text).is_ok() { text.written } else { 0 }
}

/// A text in a buffer.
struct Text<'a> {
    rest: &'a mut [u8],
    written: usize,
}

impl fmt::Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let all = core::mem::take(&mut self.rest);
        let Some((to, rest)) = all.split_at_mut_checked(text.len()) else { return Err(fmt::Error) };
        to.copy_from_slice(text.as_bytes());
        (self.rest, self.written) = (rest, self.written + text.len());
        Ok(())
    }
}
