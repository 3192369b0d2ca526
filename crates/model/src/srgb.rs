//! The transfer curve of sRGB.

/// The linear value of an sRGB code in \[0, 1\], IEC 61966-2-1.
#[must_use]
pub fn linear(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// The linear color of a hexadecimal sRGB code such as `#b87333`, or `#fc0` for `#ffcc00`.
///
/// # Errors
///
/// If it is not `#` and three or six digits; the message says so.
pub fn from_hex(text: &str) -> Result<[f64; 3], String> {
    let digits = text.strip_prefix('#').map(str::chars).into_iter().flatten();
    let digits: Option<Vec<u32>> = digits.map(|digit| digit.to_digit(16)).collect();
    let codes = match digits.as_deref() {
        Some(&[r, g, b]) => [r, g, b].map(|digit| 17 * digit),
        Some(&[r, s, g, h, b, c]) => [16 * r + s, 16 * g + h, 16 * b + c],
        _ => {
            let wrong = format!("`{text}` is no color; write # and three or six digits of 0 to f");
            return Err(wrong + ", as in '#b87333'");
        }
    };
    Ok(codes.map(|code| linear(f64::from(code) / 255.0)))
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
        assert_eq!([from_hex("#b87333"), from_hex("#B87333")], [Ok(copper), Ok(copper)]);
        assert_eq!(from_hex("#fff"), Ok([1.0; 3]));
        assert_eq!(from_hex("#fC0"), from_hex("#ffcc00"));
        let wrong =
            ["b87333", "#12", "#b8733", "#b873333", "#+87333", "#gggggg", "#é7333", "#", ""];
        for wrong in wrong {
            let message = from_hex(wrong).expect_err(wrong);
            assert!(message.starts_with(&format!("`{wrong}` is no color; write")), "{message}");
        }
    }

    #[test]
    fn codes_round_trip() {
        assert!((0..=u8::MAX).all(|code| srgb(linear(f64::from(code) / 255.0)) == code));
    }
}
