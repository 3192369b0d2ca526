//! What each number format supports, the errors of the rest, and that it holds its invariants for any
//! input.

use crate::invariants::integer::shipped;
use crate::invariants::{
    Reader, SHADING, packed_object, project_reconstruct, public_interface, shadowed_object,
};
use eigenshade::{Argument, Error, Light, Q15, q15, sphere};
use eigenshade_table::Table;
use eigenshade_table::quantize;
use eigenshade_table::scene::{Criterion, Store};
use eigenshade_table::wire::{self, Endian};
use eigenshade_testing::fixtures::shipped_table;
use proptest::collection::vec;
use proptest::prelude::*;

/// A change of a table, and the error of integers that follows.
type Refusal = (fn(&mut Table), &'static str);

/// What a table may hold in `f32` alone.
const REFUSALS: [Refusal; 3] = [
    (
        |table| table.profiles[0].chebyshev = vec![1.0; 40],
        "make the table with a larger profile_tolerance or a lower degree",
    ),
    (
        |table| {
            let last = table.profiles.last().cloned().expect("a profile");
            table.profiles.resize(512, last);
        },
        "make the table with fewer components",
    ),
    (|table| table.profiles[0].chebyshev = vec![5000.0], "make the table of a lower degree"),
];

#[test]
fn tables_that_integers_do_not_hold_are_refused() {
    for (change, error) in REFUSALS {
        let mut table = shipped().table.clone();
        change(&mut table);
        let refused = quantize::integers(&table, quantize::TOLERANCE).expect_err(error).to_string();
        assert!(refused.contains(error), "`{error}` in `{refused}`");
    }
    let refused = quantize::integers(&shipped_table("color"), 0.0).err();
    assert_eq!(refused, Some(eigenshade_table::FormatError::Large { component: 149 }));
    let others: [Refusal; 3] = [
        (|table| table.scene.basis.store = Store::Materials, "the table stores only transfers"),
        (|table| table.scene.basis.criterion = Criterion::Standard, "it subtracts a mean image"),
        (|table| table.selection = vec![true], "it has a selection of modes"),
    ];
    for (change, error) in others {
        let mut table = shipped().table.clone();
        change(&mut table);
        for format in wire::NumberFormat::ALL {
            let refused = wire::encode(&table, format, Endian::Little).expect_err(error);
            assert!(refused.to_string().contains(error), "{refused}");
        }
    }
}

/// The numbers that a format has no room for.
#[test]
fn numbers_beyond_a_format_are_refused() {
    let says = |error: Error, expected: &str| {
        assert!(error.to_string().contains(expected), "`{expected}` in `{error}`");
    };
    let light = [1.0, 1.0, 1e300f64 as f32, 1.0];
    let refused = Error::NotFinite { argument: Argument::Light, index: 2 };
    assert_eq!(q15::Light::quantize(&light, &mut [Q15(0); 4]), Err(refused));
    assert_eq!(Light::new(&light), Err(refused));
    says(refused, "is not finite");
    says(Error::Beyond { argument: Argument::Light, most: 12, found: 13 }, "degree 12 at most");
    says(Error::Beyond { argument: Argument::Light, most: 16, found: 17 }, "degree 16 at most");

    let baked = |size: usize, constant: f32| {
        let mut d = [0.0f32; sphere::COMPONENTS];
        d[0] = constant;
        let scene = sphere::BASIS.collapse::<{ sphere::SCENE }>(&d).expect("sizes");
        scene.bake_integers_into(size, vec![0; size * size]).err()
    };
    let saturated = Error::Saturated { argument: Argument::Texels };
    assert_eq!(baked(4, 2e18), Some(saturated));
    says(saturated, "a number exceeds its integer format");
    assert_eq!(baked(4, 1e17), None);
    // No look-up reads the corner of a map of 8 x 8.
    for (size, index) in [(4, 0), (8, 1)] {
        let spoiled = Error::NotFinite { argument: Argument::Texels, index };
        assert_eq!(baked(size, f32::NAN), Some(spoiled));
    }

    // What saturates it is among the hard cases.
    let of_pixels = Error::Saturated { argument: Argument::Coefficients };
    says(of_pixels, "a number exceeds its integer format");
}

/// Parts that hold only transfers.
#[test]
fn what_every_format_supports_is_there() {
    let alone = q15::Parts {
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        ..*sphere::q15::BASIS.parts()
    };
    assert!(q15::Basis::new(alone).is_ok());
}

/// Bytes of two kinds, in runs: any, and those of extreme mantissas.
fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let extreme = prop_oneof![Just(0x00u8), Just(0x80), Just(0x7f), Just(0xff), Just(0x01)];
    let run = prop_oneof![
        vec(any::<u8>(), 0..400),
        vec(extreme, 0..400),
        (any::<[u8; 4]>(), 0usize..200).prop_map(|(word, times)| word.repeat(times)),
    ];
    vec(run, 0..6).prop_map(|runs| runs.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Floats are finite, integers do not wrap, and images keep their bounds.
    #[test]
    fn shading_takes_any_numbers(bytes in bytes()) {
        for holds in SHADING {
            holds(&mut Reader::new(&bytes));
        }
    }

    #[test]
    fn every_way_takes_any_numbers(bytes in bytes()) {
        public_interface(&bytes);
    }

    #[test]
    fn objects_are_drawn_as_pixel_by_pixel(bytes in bytes()) {
        packed_object(&bytes);
    }

    #[test]
    fn objects_with_shadows_are_drawn_as_pixel_by_pixel(bytes in bytes()) {
        shadowed_object(&bytes);
    }

    #[test]
    fn reconstructions_are_those_of_f64(bytes in bytes()) {
        project_reconstruct(&bytes);
    }
}
