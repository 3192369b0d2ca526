//! The measured operations in f32. A program is one of these functions, with a table.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use board::{Passes, holds, measure};
use core::hint::black_box;
use eigenshade::lights::NineTerms;
use eigenshade::object::{DiscPixel, NormalPixel};
use eigenshade::screen::Meter;
use eigenshade::truncation::Tolerance;
use eigenshade::{Error, Gloss, Highlights, Light, Normal, Normals, Rgb, Source};
use operations::*;
use programs::inputs::floats::{self as inputs, GOLD_METALLIC_PAINT, LOBBY};
use programs::split_sum::{SIDE, STEPS, SplitSum};
use table::{COMPONENTS, Coefficients, DEGREE, SCENE, Transfer};

mod operations;

programs::program!();

/// A pixel of a scene.
fn shade() {
    let numbers = inputs::numbers::<COMPONENTS>();
    let scene = table::collapse(&Coefficients::from(numbers));
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    measure(&inputs::normals(), Passes(64), |normal| scene.shade(*normal));
}

/// A new light on a fixed material.
fn relight() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = table::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let mut coefficients = Coefficients::from([0.0; COMPONENTS]);
    holds(size_of_val(&transfer) + size_of_val(&coefficients));
    measure(&[inputs::numbers::<100>()], Passes(256), |light| {
        let light = inputs::light(light);
        table::relight_into(&transfer, &light, black_box(&mut coefficients)).is_ok()
    });
}

/// The coefficients of an image to its scene.
fn collapse() {
    let coefficients = Coefficients::from(inputs::numbers());
    let mut scene = table::collapse(&coefficients);
    holds(size_of_val(&coefficients) + size_of_val(&scene));
    measure(&[coefficients], Passes(256), |coefficients| {
        table::collapse_into(coefficients, black_box(&mut scene));
    });
}

/// A new light on a fixed material, up to the scene.
fn relight_collapse() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = table::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let mut coefficients = Coefficients::from(inputs::numbers::<COMPONENTS>());
    let mut scene = table::collapse(&coefficients);
    holds(size_of_val(&transfer) + size_of_val(&coefficients) + size_of_val(&scene));
    measure(&[inputs::numbers::<100>()], Passes(256), |light| {
        let light = Light::from_finite(light)?;
        table::relight_into(&transfer, &light, &mut coefficients)?;
        table::collapse_into(&coefficients, black_box(&mut scene));
        Ok::<(), eigenshade::Error>(())
    });
}

/// A new material, combined with the basis.
fn transfer() {
    measure(&[inputs::numbers::<40>()], Passes(64), transferred);
}

#[inline(never)]
fn transferred(material: &[f32; 40]) -> Transfer {
    let material = inputs::material(material);
    table::transfer(&material).unwrap_or_else(|_| board::exit(false))
}

/// A light on a material to the coefficients of the image.
fn project() {
    let material = black_box(inputs::numbers::<40>());
    measure(&[inputs::numbers::<100>()], Passes(64), |light| projected(light, &material));
}

#[inline(never)]
fn projected(light: &[f32; 100], material: &[f32; 40]) -> Coefficients {
    let (light, material) = (inputs::light(light), inputs::material(material));
    table::project(&light, &material).unwrap_or_else(|_| board::exit(false))
}

/// The coefficients of images to scenes within 1 % of the peak, for lights and materials that grow
/// darker with their degree, as real ones do.
fn collapse_within() {
    let (light, material) = (inputs::numbers::<100>(), inputs::numbers::<40>());
    let images = [1, 2, 3, 4].map(|faster| image(&light, &material, faster));
    let (mut lengths, mut scene) = ([0; DEGREE + 1], [0.0; SCENE]);
    holds(size_of_val(&images[0]) + size_of_val(&lengths) + size_of_val(&scene));
    measure(&images, Passes(64), |d| {
        let (scene, lengths) = (black_box(&mut scene[..]), black_box(&mut lengths));
        let collapsed = table::BASIS.collapse_within(d, Tolerance::OfPeak(1e-2), lengths, scene);
        collapsed.map(|(_, truncation)| truncation)
    });
}

/// The image of a light and a material whose numbers decrease.
fn image(light: &[f32; 100], material: &[f32; 40], faster: usize) -> Coefficients {
    let (mut light, mut material) = (*light, *material);
    light.iter_mut().zip(0..).for_each(|(value, k)| *value /= (1 + k * faster) as f32);
    material.iter_mut().zip(0..).for_each(|(value, k)| *value /= (1 + k * faster) as f32);
    let (light, material) = (inputs::light(&light), inputs::material(&material));
    table::project(&light, &material).unwrap_or_else(|_| board::exit(false))
}

/// A pixel by the nine-term formula.
fn nine_terms() {
    let formula = black_box(NineTerms::new(inputs::numbers::<9>()));
    measure(&inputs::normals(), Passes(64), |normal| formula.shade(*normal));
}

/// A pixel by a prefiltered map and the split sum.
fn prefiltered() {
    let formula = black_box(SplitSum {
        radiance: inputs::numbers::<{ SIDE * SIDE }>(),
        reflected: inputs::numbers::<STEPS>(),
        matte: NineTerms::new(inputs::numbers::<9>()),
    });
    holds(size_of_val(&formula));
    measure(&inputs::normals(), Passes(64), |normal| formula.shade(*normal));
}

/// The next pixel of a disc and its normal.
fn disc() {
    let mut disc = programs::inputs::middle();
    holds(size_of_val(&disc));
    measure(&[(); 16], Passes(64), |()| disc.next().map(DiscPixel::normal));
}

/// The next pixel of a normal map and its normal.
fn normal_map() {
    let codes = programs::inputs::codes();
    let mut pixels = programs::inputs::pixels(&codes);
    holds(size_of_val(&pixels));
    measure(&[(); 16], Passes(64), |()| pixels.next().map(NormalPixel::normal));
}

/// Three irradiances, counted for an exposure.
fn meter() {
    let channels = inputs::numbers::<48>();
    let (channels, _) = channels.as_chunks::<3>();
    let mut meter = black_box(Meter::default());
    holds(size_of_val(&meter));
    measure(channels, Passes(64), |channels| meter.add(Rgb::from(*channels)));
}

/// A pixel of the gold sphere: normal, irradiance in color, 16 bits.
fn gold() {
    let Ok(scene) = inputs::color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    let (mut disc, exposure) = (programs::inputs::middle(), inputs::exposure());
    measure(&[(); 16], Passes(64), |()| {
        let pixel = disc.next()?;
        Some(DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal()))))
    });
}

/// The irradiances of 16 vertices in color.
fn vertices_16() {
    let Ok(scene) = inputs::color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let scene = black_box(scene);
    let axes = [0, 1, 2].map(|axis: usize| {
        inputs::normals().map(|normal| normal.components().get(axis).copied().unwrap_or(0.0))
    });
    let mut colors = [Rgb::gray(0.0); 16];
    holds(size_of_val(&scene) + size_of_val(&axes) + size_of_val(&colors));
    measure(&[axes], Passes(4), |[x, y, z]| {
        let normals = Normals::from_unit(x, y, z)?;
        scene.shade_slice(normals, black_box(&mut colors))
    });
}

/// `shade` with the highlights of two sources in one channel, which all normals face.
fn shade_highlights() {
    let numbers = inputs::numbers::<COMPONENTS>();
    let scene = table::collapse(&Coefficients::from(numbers));
    let [first, second, ..] = inputs::sources(black_box(0.3));
    let Ok(highlights) = reflected(&[first, second]) else { board::exit(false) };
    let (scene, highlights) = (black_box(scene), black_box(highlights));
    holds(size_of_val(&scene) + size_of_val(&highlights));
    measure(&inputs::normals(), Passes(64), |normal| {
        scene.shade(*normal) + reflection(&highlights, *normal)
    });
}

/// In a function of its own, which leaves the registers to the polynomials.
#[inline(never)]
fn reflection(highlights: &Highlights<2>, normal: Normal) -> f32 {
    highlights.shade(normal).g
}

/// A pixel of gold in color with the highlights of four sources, which all normals face.
fn highlights() {
    let Ok(scene) = table::color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let sources = inputs::sources(black_box(0.3));
    let Ok(highlights) = reflected(&sources) else { board::exit(false) };
    let (scene, highlights) = (black_box(scene), black_box(highlights));
    holds(size_of_val(&scene) + size_of_val(&highlights));
    measure(&inputs::normals(), Passes(64), |normal| {
        let (rest, lamps) = (scene.shade(*normal), highlights.shade(*normal));
        Rgb::new(rest.r + lamps.r, rest.g + lamps.g, rest.b + lamps.b)
    });
}

/// The highlights of four sources that turned.
fn highlights_turn() {
    let sources = inputs::sources(black_box(0.3));
    let rotation = inputs::rotation();
    holds(size_of_val(&sources));
    measure(&[sources], Passes(64), |sources| {
        reflected(&sources.map(|source| source.turned(rotation)))
    });
}

/// A light in color without four sources.
fn residual() {
    measure(&[inputs::sources(black_box(0.3))], Passes(4), |sources| {
        LOBBY.residual::<100>(sources)
    });
}

#[inline(never)]
fn reflected<const N: usize>(sources: &[Source; N]) -> Result<Highlights<N>, Error> {
    let gloss = Gloss::metallic_roughness([1.0, 0.78, 0.34], 1.0, 0.3)?;
    Highlights::new(&gloss, sources)
}

/// A rotation of a light in color about the view axis.
fn turn_view() {
    let mut turned = [[0.0; 100]; 3];
    holds(size_of_val(&turned));
    let angle = black_box([0.6, 0.8]);
    measure(&[LOBBY], Passes(64), |light| {
        let turned = black_box(&mut turned);
        [light.r, light.g, light.b]
            .iter()
            .zip(turned)
            .try_for_each(|(light, turned)| light.turn_about_view_into(angle, turned))
    });
}
