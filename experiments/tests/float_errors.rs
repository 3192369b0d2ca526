//! The runtime in floats, from light and material to pixels, against the direct sum over modes.

use eigenshade::wire::aligned;
use eigenshade::{Argument, Basis, Error, Parts};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::wire::{Endian, NumberFormat, encode};
use experiments::float_errors::{SHAPES, errors, table};

/// Errors of all components in f32 and f64 at each shape, relative to the peak: in f32 a few
/// roundings of each of three steps, in f64 the rank's cut-off of 1e-10, which the sharpest lobes
/// amplify, and look-ups, which end 2^-22 short of the pole.
const ALL_COMPONENTS_AT: [[f64; 2]; 5] =
    [[2e-6, 5e-6], [1e-5, 5e-6], [1e-5, 5e-6], [2e-5, 1e-5], [2e-5, 1e-5]];

/// Three methods with every component above a rank cut-off of 1e-10. The table of
/// `docs/method.md` has the errors in f32.
#[test]
fn floats_are_right_at_every_degree() {
    let page = include_str!("../../docs/method.md");
    let (_, table) = page.split_once("<!-- float errors: ").expect("the table's start");
    let (table, _) = table.split_once("<!-- end of float errors -->").expect("its end");
    for (shape, [in_f32, in_f64]) in SHAPES.into_iter().zip(ALL_COMPONENTS_AT) {
        let errors = errors(shape);
        let row = format!("\n| {}, {} | {} |", shape[0], shape[1], errors[0].components);
        let row = table.split_once(&row).expect("a row of the table").1.lines().next();
        let stated = row.expect("its figures").split('|').filter_map(|one| one.trim().parse().ok());
        let found = errors.iter().filter(|one| one.format == "f32");
        for (one, stated) in found.zip(stated.collect::<Vec<f64>>()) {
            // Another compiler sums in another order.
            let ratio = one.largest / stated;
            assert!((0.5..=2.0).contains(&ratio), "{shape:?} {}: {:e}", one.method, one.largest);
        }
        for one in errors {
            let method = format!("{shape:?}, {} components, {}", one.components, one.method);
            println!("{method}, {}: {:.1e}, rms {:.1e}", one.format, one.largest, one.rms);
            let allowed = if one.format == "f32" { in_f32 } else { in_f64 };
            assert!(one.largest <= allowed, "{method} in {}: {:e}", one.format, one.largest);
        }
    }
}

/// A table with series is read back from its wire file, array by array. A number of recurrences
/// that is not one for each term and azimuth is refused.
#[test]
fn a_table_with_series_is_read_back() {
    let (table, ..) = table([16, 16]);
    let owned = OwnedBasis::<f32>::new(&table);
    let basis = owned.basis().expect("a basis");
    assert!(!basis.parts().recurrences.is_empty());
    let bytes = encode(&table, NumberFormat::F32, Endian::Little).expect("a wire file");
    let mut room = vec![0; bytes.len() / 4 + 1];
    let read = Basis::<f32>::from_bytes(aligned(&bytes, &mut room).expect("room"));
    let read = read.expect("a wire file");
    assert_eq!(format!("{:?}", read.parts()), format!("{:?}", basis.parts()));

    let recurrences = basis.parts().recurrences;
    for found in [1, recurrences.len() - 1] {
        let parts = Parts { recurrences: &recurrences[..found], ..*basis.parts() };
        let expected = Error::Length { argument: Argument::Recurrences, expected: 0, found };
        assert_eq!(Basis::new(parts).err(), Some(expected));
    }
}
