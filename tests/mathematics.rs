//! Roots and angles against the standard library's in f64, over their whole domains.

use eigenshade::mathematics::{Libm, Mathematics, SinglePrecision};
use eigenshade::{Error, Normal};

/// One rounding to f32, relative.
const ROUNDING_F32: f64 = 6.1e-8;

/// Roots in f32 by Newton's method, relative: a few roundings.
const SINGLE_ROOT: f64 = 2e-7;

/// Sines and cosines in f32 to 1,000 rad: roundings of a polynomial and of the angle's rest.
const SINGLE_ANGLE: f64 = 1e-7;

/// `micromath`'s roots, relative: the exponent halved, its bits as a straight line.
#[cfg(feature = "micromath")]
const MICROMATH_ROOT: f64 = 0.061;

/// Its reciprocal roots, relative: the same line with a better offset.
#[cfg(feature = "micromath")]
const MICROMATH_INVERSE_ROOT: f64 = 0.035;

/// Its sines and cosines within 10 rad: two parabolas.
#[cfg(feature = "micromath")]
const MICROMATH_ANGLE: f64 = 1.1e-3;

/// The largest relative errors of roots and of their reciprocals.
fn roots<M: Mathematics<f32>>() -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    // All of two octaves, a few of all others.
    let bits =
        (0x3f80_0000..0x4080_0000).step_by(7).chain((0x0080_0000..0x7f80_0000).step_by(4_999));
    for x in bits.map(f32::from_bits) {
        let root = f64::from(x).sqrt();
        let found = [f64::from(M::square_root(x)) / root, f64::from(M::inverse_root(x)) * root];
        worst
            .iter_mut()
            .zip(found)
            .for_each(|(worst, found)| *worst = worst.max((found - 1.0).abs()));
    }
    println!("roots: {worst:?}");
    worst
}

/// The largest error of sines and cosines of angles to `most`.
fn angles<M: Mathematics<f32>>(most: f32) -> f64 {
    let mut worst = 0.0f64;
    for k in -500_000..=500_000 {
        let angle = most * k as f32 / 500_000.0;
        let (sine, cosine) = M::sine_and_cosine(angle);
        let expected = f64::from(angle).sin_cos();
        worst = worst.max((f64::from(sine) - expected.0).abs());
        worst = worst.max((f64::from(cosine) - expected.1).abs());
    }
    println!("angles to {most}: {worst:e}");
    worst
}

#[test]
fn libm_is_right_to_the_last_bit() {
    let [root, inverse] = roots::<Libm>();
    assert!(root <= ROUNDING_F32 && inverse <= 2.0 * ROUNDING_F32);
    assert!(angles::<Libm>(1_000.0) <= ROUNDING_F32);
}

#[test]
fn single_precision_is_nearly_so() {
    assert!(roots::<SinglePrecision>().iter().all(|&worst| worst <= SINGLE_ROOT));
    assert!(angles::<SinglePrecision>(1_000.0) <= SINGLE_ANGLE);
    assert!(angles::<SinglePrecision>(0.1) <= SINGLE_ANGLE);
    assert_eq!(SinglePrecision::square_root(0.0), 0.0);
    assert_eq!(SinglePrecision::sine_and_cosine(0.0), (0.0, 1.0));
    for none in [f32::NAN, f32::INFINITY, -f32::INFINITY] {
        let (sine, cosine) = SinglePrecision::sine_and_cosine(none);
        assert!(!sine.is_finite() && !cosine.is_finite(), "{none}: {sine}, {cosine}");
    }
}

/// As bad as documented, and no worse.
#[cfg(feature = "micromath")]
#[test]
fn micromath_is_what_it_is() {
    use eigenshade::mathematics::Micromath;
    let [root, inverse] = roots::<Micromath>();
    assert!(root <= MICROMATH_ROOT && root > 0.9 * MICROMATH_ROOT);
    let most = MICROMATH_INVERSE_ROOT;
    assert!(inverse <= most && inverse > 0.9 * most);
    let (angle, most) = (angles::<Micromath>(10.0), MICROMATH_ANGLE);
    assert!(angle <= most && angle > 0.9 * most);
}

/// A normal takes the root that it is given.
#[test]
fn normals_are_scaled_by_the_root_given() {
    struct Half;
    impl Mathematics<f32> for Half {
        fn square_root(_: f32) -> f32 {
            2.0
        }
        fn inverse_root(_: f32) -> f32 {
            0.5
        }
        fn sine_and_cosine(_: f32) -> (f32, f32) {
            (0.0, 1.0)
        }
    }
    let normal = Normal::with_mathematics::<Half>(0.0, 3.0, 4.0).expect("visible");
    assert_eq!(normal.components(), [0.0, 1.5, 2.0]);
    let single = Normal::with_mathematics::<SinglePrecision>(3e-18f32, 0.0, 4e-18);
    let [x, _, z] = single.expect("a normal square").components();
    assert!((x - 0.6).abs() <= 1e-6 && (z - 0.8).abs() <= 1e-6);
    assert_eq!(Normal::with_mathematics::<Half>(0.0f32, 0.0, -1.0), Err(Error::Hidden));
    assert_eq!(Normal::with_mathematics::<Half>(f32::NAN, 0.0, 1.0), Err(Error::Normal));
}
