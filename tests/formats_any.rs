//! Every format under any input: what the fuzz targets ask, on every toolchain.

use crate::invariants;
use eigenshade::{Q15, Q31};
use invariants::Reader;
use proptest::collection::vec;
use proptest::prelude::*;

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

    #[test]
    fn floats_are_finite(bytes in bytes()) {
        invariants::shade_floats(&mut Reader::new(&bytes));
    }

    #[test]
    fn images_of_any_light_and_material_do_not_wrap(bytes in bytes()) {
        invariants::shade_integers::<Q15>(&mut Reader::new(&bytes));
        invariants::shade_integers::<Q31>(&mut Reader::new(&bytes));
    }

    #[test]
    fn any_transfer_is_refused_or_does_not_wrap(bytes in bytes()) {
        invariants::shade_transfer::<Q15>(&mut Reader::new(&bytes));
        invariants::shade_transfer::<Q31>(&mut Reader::new(&bytes));
    }

    #[test]
    fn any_coefficients_do_not_wrap(bytes in bytes()) {
        invariants::shade_coefficients::<Q15>(&mut Reader::new(&bytes));
        invariants::shade_coefficients::<Q31>(&mut Reader::new(&bytes));
    }

    #[test]
    fn any_images_keep_their_bounds(bytes in bytes()) {
        invariants::collapse_sets(&mut Reader::new(&bytes));
    }

    #[test]
    fn every_way_takes_any_numbers(bytes in bytes()) {
        invariants::public_interface(&bytes);
    }

    #[test]
    fn reconstructions_are_those_of_f64(bytes in bytes()) {
        invariants::project_reconstruct(&bytes);
    }
}
