//! Frames of a sphere in Q15. A program is one of these functions.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use eigenshade::q15::{Highlights, Normal, Rotation};
use eigenshade::{Error, Rgb};
use frames::*;
use programs::highlights::{ALPHA_SQUARE, COLOR};
use programs::inputs::integers::{self as inputs, color};

mod frames;

programs::program!();

/// A scene with the highlights of four sources, whose constants are stored: turned sources need
/// floats.
fn highlighted<'s>(
    scene: &'s color::Scene,
    _: &Rotation,
) -> Result<impl Fn(Normal) -> Rgb<i32> + 's, Error> {
    let exponents = scene.each_ref().map(|channel| channel.exponent());
    let stored = Highlights::<Rgb<i32>, 4>::stored(Rgb::gray(0), ALPHA_SQUARE, &COLOR)?;
    let highlights = stored.aligned(exponents);
    Ok(move |normal| highlights.add(scene.shade(normal), normal))
}
