//! Scenes as functions of a shader: the same sums as [`Scene::shade`], unrolled, in three channels.

use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::layout::{Form, Recurrence};
use crate::invariant::part;
use crate::recurrences::Recurrences;
use crate::scalar::Scalar;
use crate::scene::Scene;
use core::fmt::{self, Write};

/// A shader that computes the irradiance of scenes of one shape.
///
/// The text depends on the shape alone: how many terms each polynomial has. A new light or material
/// is an upload of [`uniforms`](Self::uniforms); no program is compiled while the shape stays.
///
/// ```
/// # #[cfg(all(feature = "baked", feature = "presets"))] {
/// use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
/// use eigenshade::{Shader, ShaderLanguage, sphere};
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
    recurrences: Recurrences<'a>,
}

/// The language of a shader, and where it finds the coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShaderLanguage {
    /// GLSL ES 3.00 (WebGL 2) with `uniform vec4 eigenshade[N]`. WebGL 2 promises 224 vectors to a
    /// fragment shader. The shipped tables `sphere` and `color` take 167 and 194, `pbr` 454.
    Glsl,
    /// The same with a uniform block `Eigenshade` of layout `std140`, for up to 1,024 vectors.
    GlslBlock,
    /// The same with a float texture `eigenshade` of one row, for any number of vectors.
    GlslTexture,
    /// WGSL with a uniform buffer, `@group(0) @binding(0) var<uniform> eigenshade`, of up to 4,096
    /// vectors.
    Wgsl,
}

impl<'a> Shader<'a> {
    /// The shader for scenes of the shape of this one.
    #[must_use]
    pub fn new<B>(scene: &Scene<'a, B>) -> Self {
        Self { lengths: scene.lengths(), recurrences: scene.recurrences() }
    }

    /// Number of coefficients: terms of all polynomials.
    #[must_use]
    pub fn terms(&self) -> usize {
        let lengths = self.lengths.iter().enumerate();
        lengths.map(|(azimuth, &length)| signs(azimuth) * usize::from(length)).sum()
    }

    /// Number of vectors of four numbers in the shader's array: one for each coefficient, and one for
    /// each entry of a recurrence. At least 1, because no array is empty.
    #[must_use]
    pub fn vectors(&self) -> usize {
        (self.terms() + self.entries().count()).max(1)
    }

    /// Writes the array of the shader: red, green and blue of each coefficient, and the numbers of
    /// the recurrences. Those of `vectors` beyond [`vectors`](Self::vectors) become zero. The numbers
    /// are meaningless for a shader of another shape.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are fewer `vectors`.
    pub fn uniforms<S: Scalar + Into<f32>, B: AsRef<[S]>>(
        &self,
        scene: Rgb<&Scene<'_, B>>,
        vectors: &mut [[f32; 4]],
    ) -> Result<(), Error> {
        let needed = self.vectors();
        Error::check(Argument::Scene, needed, needed.min(vectors.len()))?;
        let Rgb { r, g, b } =
            scene.map(|scene| scene.numbers().iter().map(|&number| number.into()));
        let colors = r.zip(g).zip(b).take(self.terms()).map(|((r, g), b)| [r, g, b, 0.0]);
        let entries = self.entries().map(|&[at, below]| [at, below, 0.0, 0.0]);
        let mut all = colors.chain(entries);
        vectors.fill_with(|| all.next().unwrap_or_default());
        Ok(())
    }

    /// The entries of the recurrences that are used: the last term needs no next polynomial.
    fn entries(&self) -> impl Iterator<Item = &'a Recurrence> {
        let lengths = self.lengths.iter().enumerate();
        let recurrences = self.recurrences;
        lengths.flat_map(move |(azimuth, &length)| {
            recurrences.of(azimuth).iter().take(usize::from(length).saturating_sub(1))
        })
    }

    /// Writes the text: the array `eigenshade` and `vec3 irradiance(vec3 normal)`, in WGSL
    /// `fn irradiance(normal: vec3f) -> vec3f`.
    ///
    /// The normal is a unit vector in the camera's frame, z toward the camera; the irradiance is
    /// linear, in the unit of [`Scene::shade`], and may be negative. GLSL needs a precision for
    /// floats; use `precision highp float`.
    ///
    /// # Errors
    ///
    /// Those of `out`.
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
        let longest = self.lengths.iter().map(|&length| usize::from(length)).max();
        out.write_str(if glsl {
            "vec3 irradiance(vec3 normal) {\n  float t = 2.0 * normal.z - 1.0"
        } else {
            "fn irradiance(normal: vec3f) -> vec3f {\n  let t = 2.0 * normal.z - 1.0"
        })?;
        if longest.is_some_and(|longest| Form::of(longest) == Form::EvenOdd) {
            out.write_str(if glsl { ", u" } else { ";\n  let u" })?;
            out.write_str(" = 2.0 * t * t - 1.0")?;
        }
        // Sums of (n_x + i n_y)^m: `re` and `im` those of the azimuths above, `p` and `q` this one's.
        out.write_str(if glsl {
            ";\n  vec3 re = vec3(0.0), im = re, p, q;\n"
        } else {
            ";\n  var re = vec3f(0.0);\n  var im = re;\n  var p: vec3f;\n  var q: vec3f;\n"
        })?;
        if self.entries().next().is_some() {
            out.write_str(if glsl {
                "  float e, f, g;\n"
            } else {
                "  var e: f32;\n  var f: f32;\n  var g: f32;\n"
            })?;
        }
        let (mut terms, mut entry) = (self.terms(), vectors);
        let mut above = false;
        for (azimuth, &length) in self.lengths.iter().enumerate().rev() {
            let length = usize::from(length);
            terms -= signs(azimuth) * length;
            let recurrence = self.recurrences.of(azimuth);
            entry -= recurrence.len().min(length.saturating_sub(1));
            if length == 0 && !above && azimuth > 0 {
                continue;
            }
            let text = Azimuth { language, first: terms, length, entry };
            if length > 0 && !recurrence.is_empty() {
                text.orthogonal(azimuth, out)?;
            } else {
                text.sum("p", 0, out)?;
                if azimuth > 0 {
                    text.sum("q", length, out)?;
                }
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
        out.write_str("  return p;\n}\n")
    }
}

/// How many polynomials an azimuth has.
fn signs(azimuth: usize) -> usize {
    if azimuth == 0 { 1 } else { 2 }
}

/// The text of the polynomials of an azimuth, that of +m and that of -m.
struct Azimuth {
    language: ShaderLanguage,
    /// Place of the first coefficient.
    first: usize,
    /// Terms of each polynomial.
    length: usize,
    /// Place of the first entry of the recurrence.
    entry: usize,
}

impl Azimuth {
    /// Writes the color of a coefficient.
    fn color(&self, place: usize, out: &mut impl Write) -> fmt::Result {
        self.vector(place, out)?;
        out.write_str(".rgb")
    }

    /// Writes a vector of the array.
    fn vector(&self, place: usize, out: &mut impl Write) -> fmt::Result {
        match self.language {
            ShaderLanguage::GlslTexture => {
                put(out, "texelFetch(eigenshade, ivec2(", place, ", 0), 0)")
            }
            _ => put(out, "eigenshade[", place, "]"),
        }
    }

    /// Writes the sum of a polynomial in the form of its length, by Horner's rule.
    fn sum(&self, name: &str, from: usize, out: &mut impl Write) -> fmt::Result {
        let first = self.first + from;
        let assign = |out: &mut _| statement(out, name, " = ");
        if self.length == 0 {
            assign(out)?;
            return out.write_str(match self.language {
                ShaderLanguage::Wgsl => "vec3f(0.0);\n",
                _ => "vec3(0.0);\n",
            });
        }
        let odd = self.length % 2;
        let (mut place, step) = match Form::of(self.length) {
            Form::Monomial => (first + 1, 1),
            Form::EvenOdd => (first + odd, 2),
        };
        // The first of the sum: a single term, or the highest pair.
        assign(out)?;
        if step == 2 && odd == 0 {
            self.pair(place, out)?;
            place += 2;
        } else {
            self.color(first, out)?;
        }
        out.write_str(";\n")?;
        while place < first + self.length {
            assign(out)?;
            out.write_str(name)?;
            if step == 2 {
                out.write_str(" * u + ")?;
                self.pair(place, out)?;
            } else {
                out.write_str(" * t + ")?;
                self.color(place, out)?;
            }
            out.write_str(";\n")?;
            place += step;
        }
        Ok(())
    }

    /// Writes an odd and an even half.
    fn pair(&self, place: usize, out: &mut impl Write) -> fmt::Result {
        out.write_str("(")?;
        self.color(place, out)?;
        out.write_str(" * t + ")?;
        self.color(place + 1, out)?;
        out.write_str(")")
    }

    /// Writes the sums of both polynomials by the recurrence of their azimuth.
    fn orthogonal(&self, azimuth: usize, out: &mut impl Write) -> fmt::Result {
        out.write_str(match self.language {
            ShaderLanguage::Wgsl => "  p = vec3f(0.0);\n  q = p;\n",
            _ => "  p = vec3(0.0);\n  q = p;\n",
        })?;
        out.write_str("  e = 1.0;\n  f = 0.0;\n")?;
        for k in 0..self.length {
            let last = self.first + self.length - 1 - k;
            statement(out, "p", " += ")?;
            self.color(last, out)?;
            out.write_str(" * e;\n")?;
            if azimuth > 0 {
                statement(out, "q", " += ")?;
                self.color(last + self.length, out)?;
                out.write_str(" * e;\n")?;
            }
            if k + 1 < self.length {
                out.write_str("  g = (2.0 * t - ")?;
                self.vector(self.entry + k, out)?;
                out.write_str(".x) * e - ")?;
                self.vector(self.entry + k, out)?;
                out.write_str(".y * f;\n  f = e;\n  e = g;\n")?;
            }
        }
        Ok(())
    }
}

/// The beginning of a statement.
fn statement(out: &mut impl Write, name: &str, operator: &str) -> fmt::Result {
    out.write_str("  ")?;
    out.write_str(name)?;
    out.write_str(operator)
}

/// Writes a number between two texts. By hand: `core::fmt` would double the size of a module.
fn put(out: &mut impl Write, before: &str, number: usize, after: &str) -> fmt::Result {
    out.write_str(before)?;
    let (mut digits, mut rest, mut count) = ([0; 20], number, 0);
    for digit in &mut digits {
        (*digit, rest, count) = (b'0' + (rest % 10) as u8, rest / 10, count + 1);
        if rest == 0 {
            break;
        }
    }
    for &digit in part(&digits, ..count).iter().rev() {
        out.write_char(char::from(digit))?;
    }
    out.write_str(after)
}
