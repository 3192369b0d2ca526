//! The statements of a shader, in each language.

use crate::index::layout::Form;
use crate::invariant::part;
use core::fmt::{self, Write};

/// The language of a shader, and where it finds the coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShaderLanguage {
    /// GLSL ES 3.00 (WebGL 2) with `uniform vec4 eigenshade[N]`. WebGL 2 promises 224 vectors to a
    /// fragment shader. The shipped tables `sphere` and `color` take 167 and 194, `pbr` 454; eight
    /// sources 33.
    Glsl,
    /// The same with a uniform block `Eigenshade` of layout `std140`, for up to 1,024 vectors.
    GlslBlock,
    /// The same with a float texture `eigenshade` of one row, for any number of vectors.
    GlslTexture,
    /// WGSL with a uniform buffer, `@group(0) @binding(0) var<uniform> eigenshade`, to 4,096
    /// vectors.
    Wgsl,
}

impl ShaderLanguage {
    /// The texts before and after the place of a vector of the array.
    fn brackets(self) -> [&'static str; 2] {
        match self {
            Self::GlslTexture => ["texelFetch(eigenshade, ivec2(", ", 0), 0)"],
            _ => ["eigenshade[", "]"],
        }
    }
}

/// The text of the polynomials of an azimuth, that of +m and that of -m.
pub(crate) struct Azimuth {
    pub(crate) language: ShaderLanguage,
    /// Place of the first coefficient.
    pub(crate) first: usize,
    /// Terms of each polynomial.
    pub(crate) length: usize,
    /// Place of the first entry of the recurrence.
    pub(crate) entry: usize,
}

impl Azimuth {
    fn color(&self, place: usize, out: &mut impl Write) -> fmt::Result {
        self.vector(place, out)?;
        out.write_str(".rgb")
    }

    fn vector(&self, place: usize, out: &mut impl Write) -> fmt::Result {
        let [before, after] = self.language.brackets();
        put(out, before, place, after)
    }

    /// Writes the sum of a polynomial in the form of its length, by Horner's rule.
    pub(crate) fn sum(&self, name: &str, from: usize, out: &mut impl Write) -> fmt::Result {
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
    pub(crate) fn orthogonal(&self, azimuth: usize, out: &mut impl Write) -> fmt::Result {
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

/// Writes the statements that add the highlights of sources to `p`: `Highlights::shade`, in a loop.
/// `first` is the place of the first of their vectors.
pub(crate) fn highlights(
    language: ShaderLanguage,
    first: usize,
    sources: usize,
    out: &mut impl Write,
) -> fmt::Result {
    let [before, after] = language.brackets();
    let [int, float, vec3, vec4] = match language {
        ShaderLanguage::Wgsl => ["var", "let", "let", "let"],
        _ => ["int", "float", "vec3", "vec4"],
    };
    let constructor = if language == ShaderLanguage::Wgsl { "vec3f(" } else { "vec3(" };
    join(&["  ", float, " z = max(normal.z, 0.0);\n  ", vec4, " m = "], out)?;
    put(out, before, first, after)?;
    join(&[";\n  ", float, " v = sqrt(m.x + m.y * z * z);\n  for (", int], out)?;
    put(out, " k = ", first + 1, "; k < ")?;
    put(out, "", first + highlight_vectors(sources), "; k += 4) {\n")?;
    for (name, place) in [(" a = ", "k"), (" b = ", "k + 1"), (" c = ", "k + 2")] {
        join(&["    ", vec4, name, before, place, after, ";\n"], out)?;
    }
    // Not lit: no division, so that a lobe of zeros is dark.
    join(&["    ", float, " s = dot(b.xyz, normal);\n    if (s > 1e-12) {\n"], out)?;
    join(&["      ", vec3, " w = ", constructor, "dot(a.xyz, normal), "], out)?;
    out.write_str("a.w * normal.y + b.w * normal.z, c.w * normal.z);\n")?;
    join(&["      ", float, " d = dot(w, w);\n"], out)?;
    out.write_str("      p += c.rgb * (s / (d * d * (s * v + z * sqrt(m.x + m.y * s * s))))")?;
    join(&[" + ", before, "k + 3", after, ".rgb * s;\n    }\n  }\n"], out)
}

/// Number of vectors of the highlights: four for each source, and one for the gloss.
pub(crate) fn highlight_vectors(sources: usize) -> usize {
    if sources == 0 { 0 } else { 1 + 4 * sources }
}

fn statement(out: &mut impl Write, name: &str, operator: &str) -> fmt::Result {
    join(&["  ", name, operator], out)
}

fn join(texts: &[&str], out: &mut impl Write) -> fmt::Result {
    texts.iter().try_for_each(|text| out.write_str(text))
}

/// Writes a number between two texts. By hand: `core::fmt` would double the size of a module.
pub(crate) fn put(out: &mut impl Write, before: &str, number: usize, after: &str) -> fmt::Result {
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
