//! A look-up in a baked map of 32 x 32, bilinear, of map coordinates.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use eigenshade::{BakedMap, MapPoint};
use programs::inputs;

program!(main);

fn main() {
    let Ok(map) = BakedMap::new(32, inputs::numbers::<1024>()) else { board::exit(false) };
    let map = core::hint::black_box(map);
    holds(size_of_val(&map));
    let points = inputs::normals().map(MapPoint::of);
    measure(&points, Passes(64), |point| map.bilinear(*point));
}
