//! A full scene of the table `pbr`, whose polynomials are too long for powers of t.

use crate::limit::necessary;
use eigenshade::wire::aligned;
use eigenshade::{Basis, Scene};
use eigenshade_table::wire::{Endian, Format, encode};
use std::path::Path;

/// What the page calls it.
pub const NAME: &str = "full scene of `pbr`";

/// The scene of its first component: what a pixel takes does not depend on the numbers.
pub fn scene() -> Scene<'static, Vec<f32>> {
    let basis = basis();
    basis.collapse_into(&[1.0], vec![0.0; basis.scene_len()]).expect("sizes")
}

/// Terms of its polynomials, by azimuth, and the multiply-adds that a pixel cannot do without.
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
