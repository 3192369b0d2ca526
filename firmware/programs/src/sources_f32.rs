//! The highlights of 1 to 16 sources in one channel, and their turn with the light up to the
//! highlights, in f32. All normals face all sources.
#![no_std]
#![no_main]

use board::{Passes, holds, measure_named};
use core::hint::black_box;
use eigenshade::{Error, Gloss, Highlights, Source};
use programs::inputs::floats as inputs;

programs::program!();

fn sources() {
    of_count::<1>(["pixel_1", "light_1"]);
    of_count::<2>(["pixel_2", "light_2"]);
    of_count::<4>(["pixel_4", "light_4"]);
    of_count::<8>(["pixel_8", "light_8"]);
    of_count::<16>(["pixel_16", "light_16"]);
    holds(size_of::<Highlights<16>>() + size_of::<[Source; 16]>());
}

fn of_count<const N: usize>([pixel, light]: [&str; 2]) {
    let along = black_box(0.3);
    let four = inputs::sources(along);
    let sources: [Source; N] =
        core::array::from_fn(|k| four.get(k % 4).copied().unwrap_or_else(|| board::exit(false)));
    let rotation = inputs::rotation();
    measure_named(light, &[sources], Passes(16), |sources| {
        reflected(&sources.map(|source| source.turned(rotation)))
    });
    let Ok(highlights) = reflected(&sources) else { board::exit(false) };
    let highlights = black_box(highlights);
    measure_named(pixel, &inputs::normals(), Passes(64), |normal| highlights.shade(*normal).g);
}

#[inline(never)]
fn reflected<const N: usize>(sources: &[Source; N]) -> Result<Highlights<N>, Error> {
    let gloss = Gloss::metallic_roughness([1.0, 0.78, 0.34], 1.0, 0.3)?;
    Highlights::new(&gloss, sources)
}
