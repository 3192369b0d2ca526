//! Frames of a sphere in f32. A program is one of these functions.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use eigenshade::lights::NineTerms;
use eigenshade::object::NormalPixel;
use eigenshade::{Error, Gloss, Highlights, Normal, Rgb, Rotation};
use frames::*;
use programs::inputs::floats::{self as inputs, color};

mod frames;

programs::program!();

/// A scene with the highlights of four sources, which turn with the light.
fn highlighted<'s>(
    scene: &'s color::Scene,
    rotation: &Rotation,
) -> Result<impl Fn(Normal) -> [Rgb<f32>; 4] + 's, Error> {
    let gloss = Gloss::metallic_roughness([1.0, 0.78, 0.34], 1.0, 0.3)?;
    let sources = inputs::sources(core::hint::black_box(0.3)).map(|one| one.turned(*rotation));
    let highlights = Highlights::<4>::new(&gloss, &sources)?;
    Ok(move |normal: Normal| {
        let mut colors = scene.shade_mirrored(normal);
        for (color, normal) in colors.iter_mut().zip(normal.mirrored()) {
            *color = *color + highlights.shade(normal);
        }
        colors
    })
}

fn normal(pixel: NormalPixel) -> Normal {
    pixel.normal()
}

fn nine_terms() -> NineTerms {
    NineTerms::new(inputs::numbers::<9>())
}
