//! The approximate constructors are as far off as documented, and no worse.

use eigenshade::presets::{light::STUDIO, material::CHROME_STEEL};
use eigenshade::{Error, Normal, Rotation, sphere};
use eigenshade_testing::fixtures::of_equal_areas;
use eigenshade_testing::oracle::Numbers;

/// Reciprocal roots, relative: the exponent halved, its bits as a straight line.
const INVERSE_ROOT: f32 = 0.035;

/// A pixel of chrome in a studio, of the peak.
const PIXEL: f32 = 0.21;

/// An element of a matrix: products of sines within 10 rad, two parabolas that are off by 1.1e-3.
const ELEMENT: f32 = 3e-3;

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

/// A steep picture: a normal of another length leaves the polynomials' domain.
#[test]
fn pixels_are_off_by_up_to_a_fifth_of_the_peak() {
    let scene = sphere::color::scene(STUDIO, CHROME_STEEL).expect("one table");
    let (mut worst, mut peak) = (0.0f32, 0.0f32);
    for at in of_equal_areas(4_000) {
        let [x, y, z] = at.map(|component| component as f32);
        let [exact, found] = [Normal::new, Normal::approximate]
            .map(|new| scene.g.shade(new(x, y, z).expect("visible")));
        (worst, peak) = (worst.max((found - exact).abs()), peak.max(exact));
    }
    assert!(worst <= PIXEL * peak && worst > 0.5 * PIXEL * peak, "{}", worst / peak);
}

#[test]
fn rotations_are_off_by_as_much_as_stated() {
    let mut numbers = Numbers(5);
    let mut worst = 0.0f32;
    for _ in 0..20_000 {
        let [beta, alpha, gamma] = [0; 3].map(|_| 10.0 * numbers.next() as f32);
        let exact = Rotation::from_euler(beta, alpha, gamma).expect("finite");
        let found = Rotation::approximate_from_euler(beta, alpha, gamma).expect("finite");
        let pairs = found.matrix().into_iter().flatten().zip(exact.matrix().into_iter().flatten());
        worst = pairs.fold(worst, |most, (found, exact)| most.max((found - exact).abs()));
        assert!(Rotation::from_matrix(found.matrix()) == Ok(found), "{found:?}");
    }
    assert!(worst <= ELEMENT && worst > 0.5 * ELEMENT, "{worst}");
    assert_eq!(Rotation::approximate_from_euler(f32::NAN, 0.0, 0.0), Err(Error::Rotation));
}
