//! The statements of a shader, in each language.

use crate::checked_slice::part;
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

/// Writes the sum of a polynomial of `length` terms, the first of which is at `first`: an even and an
/// odd half, by Horner's rule in u.
pub(crate) fn polynomial(
    language: ShaderLanguage,
    name: &str,
    first: usize,
    length: usize,
    out: &mut impl Write,
) -> fmt::Result {
    let [before, after] = language.brackets();
    join(&["  ", name, " = "], out)?;
    if length == 0 {
        out.write_str(if language == ShaderLanguage::Wgsl { "vec3f(0.0)" } else { "vec3(0.0)" })?;
    }
    let mut place = first;
    if length % 2 == 1 {
        put(out, before, place, after)?;
        out.write_str(".rgb")?;
        place += 1;
    }
    while place < first + length {
        if place > first {
            join(&[";\n  ", name, " = ", name, " * u + "], out)?;
        }
        join(&["(", before], out)?;
        put(out, "", place, after)?;
        join(&[".rgb * t + ", before], out)?;
        put(out, "", place + 1, after)?;
        out.write_str(".rgb)")?;
        place += 2;
    }
    out.write_str(";\n")
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
