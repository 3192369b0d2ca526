//! The approximate constructors are as far off as documented, and no worse.

use eigenshade::{Error, Normal, Rotation};

/// Reciprocal roots, relative: the exponent halved, its bits as a straight line.
const INVERSE_ROOT: f32 = 0.035;

/// Sines and cosines within 10 rad: two parabolas.
const ANGLE: f64 = 1.1e-3;

#[test]
fn normals_are_too_long_or_too_short_by_as_much_as_stated() {
    let worst = (0..4_000).fold(0.0f32, |worst, k| {
        let scale = 1.002f32.powi(k - 2_000);
        let [x, y, z] = [0.36, 0.48, 0.8].map(|component| component * scale);
        let [x, y, z] = Normal::approximate(x, y, z).expect("visible").components();
        worst.max(((x * x + y * y + z * z).sqrt() - 1.0).abs())
    });
    assert!(worst <= INVERSE_ROOT && worst > 0.9 * INVERSE_ROOT, "{worst}");
    assert_eq!(Normal::approximate(0.0, 0.0, -1.0), Err(Error::Hidden));
    assert_eq!(Normal::approximate(f32::NAN, 0.0, 1.0), Err(Error::Normal));
}

#[test]
fn rotations_are_off_by_as_much_as_stated() {
    let worst = (-10_000..=10_000).fold(0.0f64, |worst, k| {
        let angle = k as f32 * 1e-3;
        let turned = |rotation: Result<Rotation, Error>| {
            rotation.expect("finite").turn_direction([1.0, 0.0, 0.0]).map(f64::from)
        };
        let found = turned(Rotation::approximate_from_euler(angle, 0.0, 0.0));
        let (sine, cosine) = f64::from(angle).sin_cos();
        [found[0] - cosine, found[1] - sine]
            .into_iter()
            .fold(worst, |most, off| most.max(off.abs()))
    });
    // About z: the cosines of the other angles, 1, are off too.
    assert!(worst <= 2.5 * ANGLE && worst > 0.9 * ANGLE, "{worst}");
    assert_eq!(Rotation::approximate_from_euler(f32::NAN, 0.0, 0.0), Err(Error::Rotation));
}
