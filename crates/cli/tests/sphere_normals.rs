//! The normals of a sphere, as rings and as pixels.

use crate::tolerances;
use eigenshade_cli::picture::sphere_view::SphereView;
use eigenshade_shading::sphere_rings::rings;

/// Mean over midpoints between rings: a quarter of the square of the step.
const RING_MIDPOINTS: f64 = 1e-4;

/// Squared length of a unit normal: some roundings.
const UNIT_LENGTH: f64 = 1e-15;

/// ∫ cos α cos(α)/π dω = 2/3 over the disc.
#[test]
fn shares_are_those_of_the_disc() {
    let rings = rings(0.02);
    let sum = |of: fn(f64) -> f64| -> f64 {
        rings.iter().map(|ring| ring.weight * ring.tilts.len() as f64 * of(ring.slant)).sum()
    };
    assert!((sum(|_| 1.0) - 1.0).abs() < tolerances::RING_SHARES);
    assert!((sum(f64::cos) - 2.0 / 3.0).abs() < RING_MIDPOINTS);
}

#[test]
fn normals_are_unit_and_up_is_y() {
    let view = SphereView::new(33);
    for n in &view.normals {
        let square: f64 = n.iter().map(|c| c * c).sum();
        assert!((square - 1.0).abs() < UNIT_LENGTH && n[2] >= 0.0);
    }
    assert!(view.normals[0][1] > 0.9 && view.pixels[0].row == 0);
    let middle = view.pixels.iter().position(|p| (p.column, p.row) == (16, 16)).unwrap();
    assert_eq!(view.normals[middle], [0.0, 0.0, 1.0]);
}
