//! Display of linear values: an exposure, then sRGB.

/// The exposure factor: it scales the value below which a `share` of the values lie to 1. Returns 1
/// if that value is not positive.
#[must_use]
pub fn exposure(mut values: Vec<f64>, share: f64) -> f64 {
    values.retain(|value| value.is_finite());
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    let place = (share.clamp(0.0, 1.0) * last as f64).round() as usize;
    match values.get(place) {
        Some(&value) if value > 0.0 => value.recip(),
        _ => 1.0,
    }
}

/// The sRGB code of a linear value in \[0, 1\], IEC 61966-2-1; values outside are clipped.
#[must_use]
pub fn srgb(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let encoded =
        if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
}

/// The linear value of an sRGB code in \[0, 1\], IEC 61966-2-1.
#[must_use]
pub fn linear(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
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
    fn codes_come_back() {
        assert!((0..=u8::MAX).all(|code| srgb(linear(f64::from(code) / 255.0)) == code));
    }

    #[test]
    fn exposures_follow_the_percentile() {
        let values: Vec<f64> = (0..=100).map(f64::from).collect();
        assert_eq!(exposure(values, 0.5), 1.0 / 50.0);
        assert_eq!(exposure(vec![], 0.5), 1.0);
        assert_eq!(exposure(vec![-1.0], 1.0), 1.0);
    }
}
