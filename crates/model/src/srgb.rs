//! The transfer curve of sRGB.

/// The linear value of an sRGB code in \[0, 1\], IEC 61966-2-1.
#[must_use]
pub fn linear(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// The sRGB code of a linear value in \[0, 1\], IEC 61966-2-1; values outside are clipped.
#[must_use]
pub fn srgb(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let encoded =
        if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodings_are_those_of_the_standard() {
        let codes = [0.0, 0.003_130_8, 0.215_861, 0.5, 1.0, 2.0, -1.0, f64::NAN].map(srgb);
        assert_eq!(codes, [0, 10, 128, 188, 255, 255, 0, 0]);
    }

    #[test]
    fn codes_round_trip() {
        assert!((0..=u8::MAX).all(|code| srgb(linear(f64::from(code) / 255.0)) == code));
    }
}
