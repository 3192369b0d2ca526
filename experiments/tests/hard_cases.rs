//! The hard cases of `docs/stability.md`, each with its bounds.

use crate::tolerances;
use eigenshade_shading::parallel;
use experiments::stability::{Bound, CASES};
use indicatif::ProgressBar;

/// Tolerances that only the hard cases use, and those of all components. Each is at most ten times
/// the largest figure that it bounds, up to the rounding of that figure to one digit.
const TIGHT: [f64; 16] = [
    tolerances::ALL_COMPONENTS,
    tolerances::ALL_COMPONENTS_SHIPPED,
    tolerances::ALL_COMPONENTS_FEW,
    tolerances::HIGH_PIXELS,
    tolerances::HIGH_PIXELS_F32,
    tolerances::ORTHONORMAL_HIGH,
    tolerances::SUN,
    tolerances::FACETS,
    tolerances::BEYOND_RANK,
    tolerances::EIGENVALUE_ULP,
    tolerances::POLAR_INTEGRAL,
    tolerances::SCALED_F32,
    tolerances::FLAT_PICTURES,
    tolerances::WEIGHTED_PICTURES,
    tolerances::MILLION_PIXELS,
    tolerances::RASTER,
];

#[test]
fn every_figure_keeps_its_bound() {
    let measure = |k: usize| (CASES[k].1)();
    let figures = parallel::map(CASES.len(), &ProgressBar::hidden(), measure);
    let mut broken = Vec::new();
    for ((name, _), figures) in CASES.iter().zip(&figures) {
        for figure in figures {
            println!("{name}: {} {:e}, {:?}", figure.what, figure.found, figure.bound);
            if !figure.holds() {
                broken.push(format!("{name}: {figure:?}"));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
    for tolerance in TIGHT {
        let bounded = figures.iter().flatten().filter_map(|figure| match figure.bound {
            Bound::Most(bound) if bound == tolerance => Some(figure.found),
            _ => None,
        });
        let most = bounded.reduce(f64::max).unwrap_or_else(|| panic!("no figure ≤ {tolerance:e}"));
        assert!(tolerance <= 10.0 * 1.5 * most, "{most:e} ≤ {tolerance:e}");
    }
}
