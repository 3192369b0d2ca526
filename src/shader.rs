//! Scenes as functions of a shader: the same sums as [`Scene::shade`], unrolled, in three channels.

use crate::basis::signs;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::highlights::Highlights;
use crate::index::highlights::MAX_SOURCES;
use crate::scene::{Scene, count};
pub use crate::shader_text::ShaderLanguage;
use crate::shader_text::{highlight_vectors, highlights, polynomial, put};
use core::fmt::{self, Write};

/// A shader that computes the irradiance of scenes of one shape.
///
/// The text depends on the shape alone: how many terms each polynomial has. A new light or material
/// is an upload of [`uniforms`](Self::uniforms); no program is compiled while the shape stays.
///
/// ```
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
/// use eigenshade::shader::{Shader, ShaderLanguage};
/// use eigenshade::sphere;
///
/// let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
/// let shader = Shader::new(&scene.r);
/// let mut text = String::new();
/// shader.write(ShaderLanguage::Glsl, &mut text).unwrap();
/// assert!(text.contains("uniform vec4 eigenshade[167];"));
/// let mut uniforms = [[0.0; 4]; sphere::SCENE];
/// shader.uniforms(scene.each_ref().map(|scene| &**scene), &mut uniforms)?;
/// let short = &mut uniforms[1..];
/// assert!(shader.uniforms(scene.each_ref().map(|scene| &**scene), short).is_err());
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Shader<'a> {
    lengths: &'a [u16],
    sources: usize,
}

impl<'a> Shader<'a> {
    /// The shader for scenes of the shape of this one.
    #[must_use]
    pub fn new<B>(scene: &Scene<'a, B>) -> Self {
        Self { lengths: scene.lengths, sources: 0 }
    }

    /// The shader that adds the [`Highlights`] of up to `sources` small sources, 0 to
    /// [`MAX_SOURCES`], 32.
    ///
    /// The sources add a loop to the text, which depends on their number alone. A new or turned
    /// source and a new gloss are an upload of [`highlight_uniforms`](Self::highlight_uniforms).
    /// Cost: a vector, and four for each source; a root, and for each source that the normal faces
    /// another root, a division and 24 products.
    ///
    /// ```
    /// # #[cfg(all(feature = "baked", feature = "presets"))] {
    /// use eigenshade::presets::light::LOBBY;
    /// use eigenshade::shader::{Shader, ShaderLanguage};
    /// use eigenshade::{Gloss, Highlights, Material, Source, sphere};
    ///
    /// let (color, metallic, roughness) = ([0.93, 0.52, 0.38], 1.0, 0.25);
    /// let lamp = Source::new([0.0, 0.6, 0.8], [0.5; 3], 0.03)?;
    /// let rest = LOBBY.residual::<100>(&[lamp])?;
    /// let copper = Material::metallic_roughness(color, metallic, roughness)?;
    /// let scene = sphere::color::scene(rest.lights()?, copper.materials()?)?;
    /// let gloss = Gloss::metallic_roughness(color, metallic, roughness)?;
    /// let highlights = Highlights::<4>::new(&gloss, &[lamp])?;
    ///
    /// let shader = Shader::new(&scene.r).with_sources(4)?;
    /// let mut text = String::new();
    /// shader.write(ShaderLanguage::Wgsl, &mut text).unwrap();
    /// let mut vectors = [[0.0; 4]; 256];
    /// shader.uniforms(scene.each_ref().map(|scene| &**scene), &mut vectors)?;
    /// shader.highlight_uniforms(&highlights, &mut vectors)?;
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if there are more than [`MAX_SOURCES`].
    pub fn with_sources(self, sources: usize) -> Result<Self, Error> {
        if sources > MAX_SOURCES {
            let argument = Argument::Sources;
            return Err(Error::Capacity { argument, needed: sources, capacity: MAX_SOURCES });
        }
        Ok(Self { sources, ..self })
    }

    /// Number of coefficients: terms of all polynomials.
    #[must_use]
    pub fn terms(&self) -> usize {
        count(self.lengths)
    }

    /// Number of vectors of four numbers in the shader's array: one for each coefficient;
    /// with sources, four for each and one more. At least 1, because no array is empty.
    #[must_use]
    pub fn vectors(&self) -> usize {
        (self.terms() + highlight_vectors(self.sources)).max(1)
    }

    /// Writes the array of the shader: red, green and blue of each coefficient. All other `vectors`
    /// become zero, which makes the sources dark. The numbers are meaningless for a shader of
    /// another shape.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are fewer `vectors`.
    pub fn uniforms<B: AsRef<[f32]>>(
        &self,
        scene: Rgb<&Scene<'_, B>>,
        vectors: &mut [[f32; 4]],
    ) -> Result<(), Error> {
        let needed = self.vectors();
        Error::check(Argument::Scene, needed, needed.min(vectors.len()))?;
        let Rgb { r, g, b } = scene.map(|scene| scene.buffer.as_ref().iter().copied());
        let mut all = r.zip(g).zip(b).take(self.terms()).map(|((r, g), b)| [r, g, b, 0.0]);
        vectors.fill_with(|| all.next().unwrap_or_default());
        Ok(())
    }

    /// Writes the sources' part of the shader's array, after [`uniforms`](Self::uniforms) or in
    /// place of the highlights before. Sources that are not there are dark: their vectors become
    /// zero.
    ///
    /// A shader is as near to the formula as [`Highlights::shade`].
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are fewer `vectors` than [`vectors`](Self::vectors), and
    /// [`Error::Capacity`] if there are more highlights than the shader has sources.
    pub fn highlight_uniforms<const N: usize>(
        &self,
        highlights: &Highlights<N>,
        vectors: &mut [[f32; 4]],
    ) -> Result<(), Error> {
        let (needed, capacity) = (self.vectors(), self.sources);
        Error::check(Argument::Scene, needed, needed.min(vectors.len()))?;
        if highlights.len() > capacity {
            let argument = Argument::Sources;
            return Err(Error::Capacity { argument, needed: highlights.len(), capacity });
        }
        let mut all = highlights.vectors().map(|vector| vector.map(Into::into));
        let places = vectors.iter_mut().skip(self.terms());
        for vector in places.take(highlight_vectors(capacity)) {
            *vector = all.next().unwrap_or_default();
        }
        Ok(())
    }

    /// Writes the text: the array `eigenshade` and `vec3 irradiance(vec3 normal)`, in WGSL
    /// `fn irradiance(normal: vec3f) -> vec3f`.
    ///
    /// The normal is a unit vector in the camera's frame, z toward the camera; the irradiance is
    /// linear, in the unit of [`Scene::shade`], and may be negative. With sources it includes their
    /// highlights. GLSL needs a precision for floats; use `precision highp float`.
    ///
    /// # Errors
    ///
    /// The errors of `out`.
    pub fn write(&self, language: ShaderLanguage, out: &mut impl Write) -> fmt::Result {
        let vectors = self.vectors();
        let glsl = language != ShaderLanguage::Wgsl;
        match language {
            ShaderLanguage::Glsl => put(out, "uniform vec4 eigenshade[", vectors, "];\n")?,
            ShaderLanguage::GlslBlock => {
                out.write_str("layout(std140) uniform Eigenshade {\n")?;
                put(out, "  vec4 eigenshade[", vectors, "];\n};\n")?;
            }
            ShaderLanguage::GlslTexture => {
                out.write_str("uniform highp sampler2D eigenshade;\n")?;
            }
            ShaderLanguage::Wgsl => {
                out.write_str("@group(0) @binding(0) var<uniform> eigenshade")?;
                put(out, ": array<vec4f, ", vectors, ">;\n")?;
            }
        }
        out.write_str(if glsl {
            "vec3 irradiance(vec3 normal) {\n  float t = 2.0 * normal.z - 1.0, u = 2.0 * t * t - 1.0"
        } else {
            "fn irradiance(normal: vec3f) -> vec3f {\n  let t = 2.0 * normal.z - 1.0;\n  \
             let u = 2.0 * t * t - 1.0"
        })?;
        // Sums of (n_x + i n_y)^m: `re` and `im` those of the azimuths above, `p` and `q` this
        // one's.
        out.write_str(if glsl {
            ";\n  vec3 re = vec3(0.0), im = re, p, q;\n"
        } else {
            ";\n  var re = vec3f(0.0);\n  var im = re;\n  var p: vec3f;\n  var q: vec3f;\n"
        })?;
        let (mut terms, mut above) = (self.terms(), false);
        for (azimuth, &length) in self.lengths.iter().enumerate().rev() {
            let length = usize::from(length);
            terms -= signs(azimuth) * length;
            if length == 0 && !above && azimuth > 0 {
                continue;
            }
            polynomial(language, "p", terms, length, out)?;
            if azimuth > 0 {
                polynomial(language, "q", terms + length, length, out)?;
            }
            if above {
                out.write_str("  p += normal.x * re + normal.y * im;\n")?;
                if azimuth > 0 {
                    out.write_str("  q += normal.x * im - normal.y * re;\n")?;
                }
            }
            above = true;
            if azimuth > 0 {
                out.write_str("  re = p;\n  im = q;\n")?;
            }
        }
        if self.lengths.is_empty() {
            out.write_str("  p = re;\n")?;
        }
        if self.sources > 0 {
            highlights(language, self.terms(), self.sources, out)?;
        }
        out.write_str("  return p;\n}\n")
    }
}
