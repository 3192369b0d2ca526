//! The highlights of 1 to 16 sources in one channel, and those of a new light whose constants are
//! stored, in Q15. All normals face all sources.
#![no_std]
#![no_main]

use board::{Passes, holds, measure_named};
use core::hint::black_box;
use eigenshade::q15::{Highlights, Lobe};
use programs::highlights::{ALPHA_SQUARE, GRAY};
use programs::inputs::integers as inputs;

programs::program!();

fn sources() {
    of_count::<1>(["pixel_1", "light_1"]);
    of_count::<2>(["pixel_2", "light_2"]);
    of_count::<4>(["pixel_4", "light_4"]);
    of_count::<8>(["pixel_8", "light_8"]);
    of_count::<16>(["pixel_16", "light_16"]);
    holds(size_of::<Highlights<i32, 16>>());
}

fn of_count<const N: usize>([pixel, light]: [&str; 2]) {
    let lobes: [Lobe<i32>; N] =
        core::array::from_fn(|k| GRAY.get(k % 4).copied().unwrap_or_default());
    let lobes = black_box(lobes);
    let aligned = |exponent: &i32| {
        Highlights::<i32, N>::stored(0, ALPHA_SQUARE, &lobes).map(|one| one.aligned(*exponent))
    };
    measure_named(light, &[-15], Passes(64), aligned);
    let Ok(highlights) = aligned(&black_box(-15)) else { board::exit(false) };
    let highlights = black_box(highlights);
    measure_named(pixel, &inputs::normals(), Passes(64), |normal| highlights.shade(*normal));
}
