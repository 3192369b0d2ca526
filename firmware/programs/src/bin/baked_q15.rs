//! A look-up in a baked map of 32 x 32 in Q15, bilinear, of a normal.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use eigenshade::{IntegerMap, MapPoint, Q15};
use programs::integer_inputs as inputs;

program!(main);

fn main() {
    let texels = inputs::mantissas::<Q15, 1024>().map(|texel| texel.0);
    let Ok(map) = IntegerMap::new(32, 0, texels) else { board::exit(false) };
    let map = core::hint::black_box(map);
    holds(size_of_val(&map));
    let normals = inputs::normals::<Q15>();
    measure(&normals, Passes(256), |normal| map.bilinear(MapPoint::of_quantized(*normal)));
}
