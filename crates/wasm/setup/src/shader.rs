//! The scene and its highlights as the vectors and the text of a shader. Every function returns 0 if
//! there is no scene.

#[cfg(feature = "sources")]
use crate::highlights::HIGHLIGHTS;
use crate::scene::COLLAPSED;
use crate::shared::Shared;
use crate::table::SCENE;
use core::fmt;
use eigenshade::Scene;
use eigenshade::shader::{Shader, ShaderLanguage};

/// Vectors of a shader's array: those of all terms and sources.
const VECTORS: usize = SCENE + OF_SOURCES;
#[cfg(feature = "sources")]
const OF_SOURCES: usize = 1 + 4 * eigenshade_table::highlights::MAX_SOURCES;
#[cfg(not(feature = "sources"))]
const OF_SOURCES: usize = 0;
/// The array of the shader of the last `uniforms`.
#[unsafe(export_name = "uniform_array")]
static ARRAY: Shared<[[f32; 4]; VECTORS]> = Shared::new([[0.0; 4]; VECTORS]);

/// Terms of the scene.
#[unsafe(no_mangle)]
extern "C" fn terms() -> usize {
    // SAFETY: no other function runs.
    let scene = unsafe { COLLAPSED.borrow() }.scene();
    scene.map_or(0, |scene| Shader::new(&scene.r).terms())
}

/// Writes the scene as the array of its shader. Returns the number of vectors.
#[unsafe(no_mangle)]
extern "C" fn uniforms() -> usize {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (collapsed, array) = unsafe { (COLLAPSED.borrow(), ARRAY.borrow()) };
    let Some(scene) = collapsed.scene() else { return 0 };
    let shader = of_scene(&scene.r);
    if shader.uniforms(scene.each_ref(), array).is_err() {
        return 0;
    }
    #[cfg(feature = "sources")]
    // SAFETY: as above.
    if let Some(highlights) = unsafe { HIGHLIGHTS.borrow() }
        && shader.highlight_uniforms(highlights, array).is_err()
    {
        return 0;
    }
    shader.vectors()
}

/// The shader of a scene, and of the highlights of the last `highlights`.
fn of_scene<'a>(scene: &Scene<'a, &[f32]>) -> Shader<'a> {
    let shader = Shader::new(scene);
    #[cfg(feature = "sources")]
    // SAFETY: no other function borrows it now.
    let sources = unsafe { HIGHLIGHTS.borrow() }.as_ref().map_or(0, |h| h.len());
    #[cfg(feature = "sources")]
    let shader = shader.with_sources(sources).unwrap_or(shader);
    shader
}

/// The text of the shader of the last `shader`.
#[unsafe(export_name = "text")]
static TEXT: Shared<[u8; TEXT_LEN]> = Shared::new([0; TEXT_LEN]);
/// Bytes of the longest text: at most 160 for a term.
const TEXT_LEN: usize = 1024 + 160 * VECTORS;

/// Writes the text of the scene's shader in the language of this number. Returns its length.
#[unsafe(no_mangle)]
extern "C" fn shader(language: u32) -> usize {
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
    if of_scene(&scene.r).write(language, &mut text).is_ok() { text.written } else { 0 }
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
