//! The transfer curve of sRGB.

/// The linear value of an sRGB code in \[0, 1\], IEC 61966-2-1.
#[must_use]
pub fn linear(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// The linear color of a hexadecimal sRGB code such as `#b87333`.
#[must_use]
pub fn from_hex(text: &str) -> Option<[f64; 3]> {
    let digits = text.strip_prefix('#')?;
    let is_hex = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    let [_, rgb @ ..] = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex)?.to_be_bytes();
    Some(rgb.map(|code| linear(f64::from(code) / 255.0)))
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
    fn hexadecimal_codes_are_colors() {
        let copper = [0xb8, 0x73, 0x33].map(|code| linear(f64::from(code) / 255.0));
        assert_eq!([from_hex("#b87333"), from_hex("#B87333")], [Some(copper); 2]);
        assert_eq!(from_hex("#ffffff"), Some([1.0; 3]));
        for wrong in ["b87333", "#fff", "#b8733", "#b873333", "#+87333", "#b8733g", "#é7333", ""] {
            assert_eq!(from_hex(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn codes_round_trip() {
        assert!((0..=u8::MAX).all(|code| srgb(linear(f64::from(code) / 255.0)) == code));
    }
}
