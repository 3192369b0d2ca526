//! A full scene of the table `pbr`, whose polynomials are too long for powers of t; and the same
//! as series in orthogonal polynomials, the form of the high azimuths of tables of degree 16 and more.

use crate::limit::necessary;
use eigenshade::wire::aligned;
use eigenshade::{Basis, Parts, Scene};
use eigenshade_table::wire::{Endian, Format, encode};
use std::path::Path;

/// Names in docs/performance.md of the scene as even and odd halves, and of the same as series.
pub const NAMES: [&str; 2] = ["full scene of `pbr`", "the same as series"];

/// The scene of the table's first component, in the named form. The time of a pixel does not depend
/// on the numbers, so the series use made-up recurrences.
pub fn scene(name: &str) -> Scene<'static, Vec<f32>> {
    let mut basis = basis();
    if name == NAMES[1] {
        let lengths = basis.parts().lengths;
        let longest = usize::from(lengths.iter().copied().max().expect("azimuths"));
        let recurrences = Vec::leak(vec![[0.0, 0.25]; longest * lengths.len()]);
        basis = Basis::new(Parts { recurrences, ..*basis.parts() }).expect("the same shape");
    }
    basis.collapse_into(&[1.0], vec![0.0; basis.scene_len()]).expect("sizes")
}

/// Terms of its polynomials, by azimuth, and the multiply-adds that a pixel cannot do without in
/// halves.
pub fn terms() -> (Vec<u16>, usize) {
    let lengths = basis().parts().lengths.iter().copied();
    let lengths: Vec<u16> = lengths.take_while(|&length| length > 0).collect();
    let necessary = necessary(&lengths);
    (lengths, necessary)
}

/// The table, packed; its bytes are needed to the end.
fn basis() -> Basis<'static, f32> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tables/pbr.bin");
    let table = eigenshade_table::decode(&std::fs::read(path).expect("the shipped table"));
    let bytes = encode(&table.expect("a table"), Format::F32, Endian::Little).expect("a sphere's");
    let room = Vec::leak(vec![0; bytes.len().div_ceil(4)]);
    Basis::from_bytes(aligned(&bytes, room).expect("room")).expect("a wire file")
}
