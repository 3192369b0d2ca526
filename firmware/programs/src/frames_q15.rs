//! Frames of a sphere in Q15. A program is one of these functions.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use core::hint::black_box;
use eigenshade::object::NormalPixel;
use eigenshade::q15::{Highlights, NineTerms, Normal, Rotation};
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
) -> Result<impl Fn(Normal) -> [Rgb<i32>; 4] + 's, Error> {
    let exponents = scene.each_ref().map(|channel| channel.exponent());
    let stored = Highlights::<Rgb<i32>, 4>::stored(Rgb::gray(0), ALPHA_SQUARE, &COLOR)?;
    let highlights = stored.aligned(exponents);
    Ok(move |normal: Normal| {
        let mut colors = scene.shade_mirrored(normal);
        for (color, normal) in colors.iter_mut().zip(normal.mirrored()) {
            *color = highlights.add(*color, normal);
        }
        colors
    })
}

fn normal(pixel: NormalPixel) -> Normal {
    pixel.normal_q15()
}

fn nine_terms() -> NineTerms {
    NineTerms::new(black_box([9000, 500, -3000, 8000, -700, -1200, 2500, 900, 3100]), -15)
}
