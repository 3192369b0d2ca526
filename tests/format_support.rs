//! Each number format supports what the table of docs/formats.md states, refuses the rest with an
//! error, and holds its invariants for any input.

use crate::invariants::integer::shipped;
use crate::invariants::{Reader, SHADING, project_reconstruct, public_interface};
use eigenshade::{Argument, Error, Format, Light, Q15, Q31, Scalar, quantized, sphere};
use eigenshade_table::quantize;
use eigenshade_table::scene::{Effect, Store};
use eigenshade_table::wire::{self, Endian};
use eigenshade_table::{General, MeanImage, Table};
use eigenshade_testing::fixtures::shipped_table;
use eigenshade_testing::part;
use proptest::collection::vec;
use proptest::prelude::*;
use std::marker::PhantomData;

/// The rows of the table: the last three columns by the first.
fn rows() -> Vec<[&'static str; 4]> {
    let text = part(include_str!("../docs/formats.md"), "support");
    let rows = text.lines().filter(|line| line.starts_with("| ")).skip(1);
    let cells = |row: &'static str| {
        let cells: Vec<_> = row.trim_matches('|').split(" | ").map(str::trim).collect();
        match cells[..] {
            [what, floats, integers] => [what, floats, integers.trim_end_matches(" |"), ""],
            [what, floats, integers, error] => [what, floats, integers, error],
            _ => panic!("{row}"),
        }
    };
    rows.map(cells).collect()
}

fn row(what: &str) -> [&'static str; 4] {
    let found = rows().into_iter().find(|[name, ..]| *name == what);
    found.unwrap_or_else(|| panic!("the table of docs/formats.md has no row `{what}`"))
}

/// Both integer formats refuse a table with the row's error.
fn assert_refused(what: &str, change: impl Fn(&mut Table)) {
    let [_, floats, integers, error] = row(what);
    assert_eq!((floats, integers), ("yes", "no"), "{what}");
    let mut table = shipped().table.clone();
    change(&mut table);
    for format in [quantize::IntegerFormat::Q15, quantize::IntegerFormat::Q31] {
        let refused = quantize::integers(&table, format, format.tolerance()).err();
        let refused = refused.expect(what).to_string();
        assert!(refused.contains(error), "{what}: `{error}` in `{refused}`");
    }
}

#[test]
fn tables_that_integers_do_not_serve_are_refused_as_documented() {
    assert_refused("the same, where ambient takes orders that no other effect takes", |table| {
        table.scene.effects.wanted = vec![Effect::Ambient, Effect::Diffuse];
    });
    assert_refused("a mean image (`criterion = \"standard\"`)", |table| {
        let coefficients = vec![0.0; table.count()];
        table.mean = Some(MeanImage { chebyshev: vec![1.0], coefficients });
    });
    assert_refused("a selection of modes (`modes`)", |table| table.selection = vec![true]);
    let general =
        "other objects than the sphere, or light that does not turn freely (`GeneralBasis`)";
    assert_refused(general, |table| {
        table.general = Some(General {
            normals: 1,
            rank: 1,
            eigenvalues: vec![None],
            projection: vec![0.0; 50],
            synthesis: vec![0.0; 50],
            modes: vec![],
            mean: vec![],
            mean_coefficients: vec![],
        });
    });
    assert_refused("polynomials of more than 16 terms", |table| {
        table.profiles[0].chebyshev = vec![1.0; 40];
    });
    assert_refused("more than 511 profiles, or degrees beyond 510", |table| {
        let last = table.profiles.last().cloned().expect("a profile");
        table.profiles.resize(512, last);
    });
    assert_refused("a profile above 4,095, as of `color` from component 149 on", |table| {
        table.profiles[0].chebyshev = vec![5000.0];
    });
    let color = shipped_table("color");
    let refused = quantize::integers(&color, quantize::IntegerFormat::Q15, 0.0).err();
    assert_eq!(refused, Some(quantize::QuantizeError::Large { component: 149 }));
    let [_, floats, integers, error] =
        row("transfers alone (`store = \"materials\"`), as statics, packed or quantized");
    assert_eq!((floats, integers), ("no", "no"));
    let mut table = shipped().table.clone();
    table.scene.basis.store = Store::Materials;
    for format in [wire::NumberFormat::F32, wire::NumberFormat::Q15, wire::NumberFormat::Q31] {
        let refused = wire::encode(&table, format, Endian::Little).expect_err("no factors");
        assert!(refused.to_string().contains(error), "`{error}` in `{refused}`");
    }
}

/// Whether a format is a [`Scalar`], over which what only floats have is written: a method of the
/// type itself goes before that of a trait.
struct Probe<S>(PhantomData<S>);

impl<S: Scalar> Probe<S> {
    fn is_float(&self) -> bool {
        true
    }
}

trait Other {
    fn is_float(&self) -> bool {
        false
    }
}

impl<S: Format> Other for Probe<S> {}

#[test]
fn what_only_floats_have_does_not_compile_in_integers() {
    let floats = [Probe::<f32>(PhantomData).is_float(), Probe::<f64>(PhantomData).is_float()];
    let integers = [Probe::<Q15>(PhantomData).is_float(), Probe::<Q31>(PhantomData).is_float()];
    assert_eq!((floats, integers), ([true; 2], [false; 2]));
    let closed = rows().into_iter().filter(|[.., error]| error.starts_with("does not compile"));
    // bake, IntegerMap, windowed, and one row for the two within a tolerance.
    assert_eq!(closed.count(), 4);
}

/// The numbers that a format has no room for.
#[test]
fn numbers_beyond_a_format_are_refused_as_documented() {
    let says = |error: Error, what: &str| {
        let [.., integers, expected] = row(what);
        assert_eq!(integers, "no");
        assert!(error.to_string().contains(expected), "{what}: `{expected}` in `{error}`");
    };
    let light = [1.0, 1.0, 1e300f64 as f32, 1.0];
    let refused = Error::NotFinite { argument: Argument::Light, index: 2 };
    assert_eq!(quantized::Light::quantize(&light, &mut [Q15(0); 4]), Err(refused));
    assert_eq!(Light::new(&light), Err(refused));
    assert!(Light::new(&[1e300f64; 4]).is_ok());
    says(refused, "a light of 1e300");
    says(Error::Degree { found: 13 }, "`Light::turn_into` above degree 12");

    let baked = |size: usize, constant: f32| {
        let mut d = [0.0f32; sphere::COMPONENTS];
        d[0] = constant;
        let scene = sphere::BASIS.collapse::<{ sphere::SCENE }>(&d).expect("sizes");
        scene.bake_integers_into(size, vec![0; size * size]).err()
    };
    let saturated = Error::Saturated { argument: Argument::Texels };
    assert_eq!(baked(4, 2e18), Some(saturated));
    says(saturated, "a map of irradiances of 2^60 or more, in integers");
    assert_eq!(baked(4, 1e17), None);
    // No look-up reads the corner of a map of 8 x 8.
    for (size, index) in [(4, 0), (8, 1)] {
        let spoiled = Error::NotFinite { argument: Argument::Texels, index };
        assert_eq!(baked(size, f32::NAN), Some(spoiled));
    }

    // What saturates it is among the hard cases.
    let of_pixels = Error::Saturated { argument: Argument::Coefficients };
    says(of_pixels, "sums of more than 2^15 pixels of full weight and size");
}

/// A table that all formats take is taken, and by each way that the first rows name.
#[test]
fn what_every_format_supports_is_there() {
    let mut table = shipped().table.clone();
    for effects in [vec![Effect::Diffuse, Effect::Broad], Effect::ALL.to_vec()] {
        table.scene.effects.wanted = effects;
        for format in [quantize::IntegerFormat::Q15, quantize::IntegerFormat::Q31] {
            let taken = quantize::integers(&table, format, format.tolerance());
            assert!(taken.is_ok(), "{:?}", taken.err());
        }
    }
    for what in [
        "`project`, `transfer`, `relight`, `collapse`, `shade`, `estimate`, `NegativePolicy`",
        "the sphere's tables of some effects",
    ] {
        assert_eq!(row(what)[1..], ["yes", "yes", ""]);
    }
    let alone = quantized::Parts {
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        ..*sphere::q15::BASIS.parts()
    };
    assert!(quantized::Basis::<Q15>::new(alone).is_ok());
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
    fn reconstructions_are_those_of_f64(bytes in bytes()) {
        project_reconstruct(&bytes);
    }
}
