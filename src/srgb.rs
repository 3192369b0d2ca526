//! The sRGB encoding (IEC 61966-2-1) in constants.

/// The encoding of a number from 0 to 1.
pub(crate) const fn encoded(x: f64) -> f64 {
    if x <= 0.003_130_8 {
        return 12.92 * x;
    }
    // x^(1/2.4) is the twelfth root of x^5. Newton's method falls to it from 1.
    let fifth = x * x * x * x * x;
    let (mut root, mut step) = (1.0, 0);
    while step < 64 {
        let cube = root * root * root;
        let eleventh = cube * cube * cube * root * root;
        root -= (eleventh * root - fifth) / (12.0 * eleventh);
        step += 1;
    }
    1.055 * root - 0.055
}

/// The linear values of the levels 0 to 255, in units of 2^-16.
pub(crate) static LINEAR: [u16; 256] = linear();

#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
const fn linear() -> [u16; 256] {
    let (mut values, mut level) = ([0; 256], 0);
    while level < 256 {
        let units = decoded(level as f64 / 255.0) * 65_536.0 + 0.5;
        values[level] = if units < 65_535.0 { units as u16 } else { u16::MAX };
        level += 1;
    }
    values
}

/// The number from 0 to 1 with this encoding.
const fn decoded(x: f64) -> f64 {
    if x <= 0.040_45 {
        return x / 12.92;
    }
    // a^2.4 is the fifth root of a^12. Newton's method falls to it from 1.
    let a = (x + 0.055) / 1.055;
    let fourth = a * a * a * a;
    let twelfth = fourth * fourth * fourth;
    let (mut root, mut step) = (1.0, 0);
    while step < 32 {
        let power = root * root * root * root;
        root -= (power * root - twelfth) / (5.0 * power);
        step += 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_decoded() {
        for (level, found) in LINEAR.into_iter().enumerate() {
            let x = level as f64 / 255.0;
            let exact = if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) };
            let off = f64::from(found) - (65_536.0 * exact).min(65_535.0);
            assert!(off.abs() <= 0.501, "{level}: {off}");
            assert!((encoded(exact) - x).abs() < 1e-7, "{level}");
        }
    }
}
