//! The hard cases, each with its bounds: `docs/stability.md` has a line of each.

use crate::tolerances;
use experiments::stability;
use stability::{CASES, Case};

/// Every figure of a case keeps to its bound.
fn assert_holds(case: &Case) {
    let figures = (case.measure)();
    for figure in &figures {
        println!("{}: {} {:e}, {:?}", case.name, figure.what, figure.found, figure.bound);
    }
    for figure in &figures {
        assert!(figure.holds(), "{}: {figure:?}", case.name);
    }
}

macro_rules! cases {
    ($($test:ident = $case:path;)*) => {
        $(#[test]
        fn $test() {
            assert_holds(&$case);
        })*

        /// No case of the document is without its test.
        #[test]
        fn every_case_is_tested() {
            assert_eq!([$($case.name),*].as_slice(), CASES.iter().map(|case| case.name).collect::<Vec<_>>());
        }
    };
}

cases! {
    special_functions = stability::special::FUNCTIONS;
    turned_frames = stability::rotations::COMPOSITION;
    turned_together = stability::rotations::TOGETHER;
    degree_32_and_order_32 = stability::high_degree::CASE;
    a_root_of_the_singular = stability::singular::ROOT;
    exact_ranks = stability::singular::RANKS;
    more_components_than_rank = stability::singular::MORE_THAN_RANK;
    the_same_order_and_sign = stability::spectra::SAME_ORDER;
    nearly_equal_eigenvalues = stability::spectra::NEARLY_EQUAL;
    pole_and_rim = stability::edges::POLE_AND_RIM;
    few_lights_and_materials = stability::databases::FEW;
    materials_all_alike = stability::databases::ALIKE;
    zeros = stability::databases::ZEROS;
    plain_lights_and_materials = stability::databases::PLAIN;
    a_covariance_of_rank_one = stability::databases::RANK_ONE;
    a_sun = stability::sun::TEXEL;
    maps_of_odd_sizes = stability::sun::SIZES;
    flat_objects = stability::flat::FLAT;
    weights_over_twelve_decades = stability::flat::WEIGHTS;
    degenerate_triangles = stability::facets::DEGENERATE;
    scales_in_f64 = stability::scales::DOUBLE;
    scales_in_f32 = stability::scales::SINGLE;
    light_at_1e_30_in_f32 = stability::subnormal::TINY;
    a_million_pixels = stability::summation::MILLION;
    a_normal_map_of_8_bits = stability::user_inputs::EIGHT_BITS;
    normals_behind_the_rim = stability::user_inputs::BEHIND;
    a_sun_by_every_way = stability::user_inputs::SUN;
    a_direction_by_every_way = stability::user_inputs::DELTA;
    a_thousand_rotations = stability::user_inputs::DRIFT;
    a_matrix_almost_orthonormal = stability::user_inputs::ALMOST;
    pixels_at_full_weight = stability::user_inputs::FULL_WEIGHT;
}

/// Tolerances that only the page's cases use, and those of all components. Of the figures with such
/// a bound, the largest is at least a tenth of it.
#[test]
fn bounds_are_no_more_than_ten_times_what_is_measured() {
    let page = include_str!("../../docs/stability.md");
    for bound in [
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
    ] {
        let of_bound = format!(" (≤ {bound:e})");
        let before = page.match_indices(&of_bound).map(|(at, _)| &page[..at]);
        let measured = before.map(|text| text.rsplit(' ').next().unwrap_or_default());
        let measured = measured.map(|text| text.parse::<f64>().expect("a number"));
        let most = measured.reduce(f64::max).unwrap_or_else(|| panic!("no figure{of_bound}"));
        // The page gives one digit: half a unit of it.
        assert!(bound <= 10.0 * 1.5 * most, "{most:e}{of_bound}");
    }
}
