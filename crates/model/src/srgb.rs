//! The transfer curve of sRGB.

/// The linear value of an sRGB code in \[0, 1\], IEC 61966-2-1.
#[must_use]
pub fn linear(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}
