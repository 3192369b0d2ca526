//! The measured operations in Q15. A program is one of these functions, with a table.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use board::{Passes, holds, measure};
use core::hint::black_box;
use eigenshade::object::{DiscPixel, NormalPixel};
use eigenshade::q15::{Highlights, Irradiance, LightBuffer, Lobe, NineTerms};
use eigenshade::screen::Meter;
use eigenshade::{Error, Rgb};
use operations::*;
use programs::inputs::integers::{self as inputs, GOLD_METALLIC_PAINT, LOBBY};
use table::{COMPONENTS, Coefficients, Scene, Transfer};

mod operations;

programs::program!();

/// A pixel of a scene.
fn shade() {
    let scene = black_box(collapsed());
    holds(size_of_val(&scene));
    measure(&inputs::normals(), Passes(256), |normal| scene.shade(*normal));
}

fn collapsed() -> Scene {
    let d = Coefficients::new([0; COMPONENTS].map(|_| black_box(123_456_789)), -30);
    let Ok(d) = d else { board::exit(false) };
    table::collapse(&d)
}

/// The same with the highlights of two sources, which all normals face.
fn shade_highlights() {
    let scene = collapsed();
    let lobes = programs::highlights::GRAY.first_chunk::<2>();
    let Some(Ok(highlights)) = lobes.map(|lobes| of_lobes::<_, 2>(lobes, scene.exponent())) else {
        board::exit(false)
    };
    let (scene, highlights) = (black_box(scene), black_box(highlights));
    holds(size_of_val(&scene) + size_of_val(&highlights));
    measure(&inputs::normals(), Passes(256), |normal| {
        highlights.add(scene.shade(*normal), *normal)
    });
}

/// Highlights of constants in flash.
#[inline(never)]
fn of_lobes<T: Irradiance, const N: usize>(
    lobes: &[Lobe<T>; N],
    exponent: T,
) -> Result<Highlights<T, N>, Error> {
    let highlights = Highlights::stored(T::default(), programs::highlights::ALPHA_SQUARE, lobes);
    highlights.map(|highlights| highlights.aligned(exponent))
}

/// A pixel of the gold sphere in color with the highlights of four sources, which all normals face.
fn highlights() {
    let Ok(scene) = inputs::color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let exponents = scene.each_ref().map(|channel| channel.exponent());
    let Ok(highlights) = of_lobes(&programs::highlights::COLOR, exponents) else {
        board::exit(false)
    };
    let (scene, highlights) = (black_box(scene), black_box(highlights));
    holds(size_of_val(&scene) + size_of_val(&highlights));
    measure(&inputs::normals(), Passes(64), |normal| highlights.add(scene.shade(*normal), *normal));
}

/// A new light on a fixed material.
fn relight() {
    let (transfer, mut d) = (black_box(transferred()), Coefficients::default());
    holds(size_of_val(&transfer) + size_of_val(&d));
    measure(&[inputs::numbers::<100>()], Passes(64), |light| {
        table::relight_into(&transfer.view(), &inputs::light(light), black_box(&mut d))
    });
}

/// A new light on a fixed material, up to the scene.
fn relight_collapse() {
    let (transfer, mut d) = (black_box(transferred()), Coefficients::default());
    let mut scene = Scene::default();
    holds(size_of_val(&transfer) + size_of_val(&d) + size_of_val(&scene));
    measure(&[inputs::numbers::<100>()], Passes(64), |light| {
        table::relight_into(&transfer.view(), &inputs::light(light), black_box(&mut d))?;
        table::collapse_into(&d, black_box(&mut scene));
        Ok::<(), eigenshade::Error>(())
    });
}

fn transferred() -> Transfer {
    let material = inputs::numbers::<40>();
    table::transfer(&inputs::material(&material)).unwrap_or_else(|_| board::exit(false))
}

/// The coefficients of an image to its scene.
fn collapse() {
    let light = inputs::numbers::<100>();
    let relit = table::relight(&transferred().view(), &inputs::light(&light));
    let Ok(relit) = relit else { board::exit(false) };
    let mut scene = Scene::default();
    holds(size_of_val(&relit) + size_of_val(&scene));
    measure(&[relit], Passes(64), |relit| table::collapse_into(relit, black_box(&mut scene)));
}

/// A new material, combined with the basis.
fn transfer() {
    let mut transfer = Transfer::default();
    holds(size_of_val(&transfer));
    measure(&[inputs::numbers::<40>()], Passes(16), |material| {
        table::transfer_into(&inputs::material(material), black_box(&mut transfer))
    });
}

/// A pixel by the nine-term formula.
fn nine_terms() {
    let coefficients = [9000, 500, -3000, 8000, -700, -1200, 2500, 900, 3100];
    let formula = black_box(NineTerms::new(black_box(coefficients), -15));
    measure(&inputs::normals(), Passes(256), |normal| formula.shade(*normal));
}

/// A dense projection: a row for each component of the shipped table.
fn dense_46() {
    measure(&[&ROW], Passes(8), |modes| {
        for _ in 0..46 {
            black_box(dense_product(black_box(modes)));
        }
    });
}

/// Modes at degree 9 and order 7.
const MODES: usize = 3704;

/// Used as every row and as the modes, because a matrix of K x 3704 does not fit the smaller
/// boards.
static ROW: [i16; MODES] = {
    let mut row = [0; MODES];
    let (mut rest, mut state) = (row.as_mut_slice(), 1_u32);
    while let [first, tail @ ..] = rest {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *first = (state >> 16) as i16;
        rest = tail;
    }
    row
};

/// The row times the modes, rounded to Q15: four products a step, summed in 64 bits, as CMSIS-DSP's
/// `arm_mat_vec_mult_q15` does.
#[inline(never)]
fn dense_product(modes: &[i16; MODES]) -> i16 {
    let (rows, _) = ROW.as_chunks::<4>();
    let (modes, _) = modes.as_chunks::<4>();
    let mut sum = 0_i64;
    for ([a, b, c, d], [e, f, g, h]) in rows.iter().zip(modes) {
        let product = |a: i16, b: i16| i64::from(i32::from(a) * i32::from(b));
        sum += product(*a, *e) + product(*b, *f) + product(*c, *g) + product(*d, *h);
    }
    let rounded = (sum + (1 << 14)) >> 15;
    rounded.clamp(i64::from(i16::MIN), i64::from(i16::MAX)) as i16
}

/// The next pixel of a disc and its normal.
fn disc() {
    let mut disc = programs::inputs::middle();
    holds(size_of_val(&disc));
    measure(&[(); 16], Passes(64), |()| disc.next().map(DiscPixel::normal_q15));
}

/// The next pixel of a normal map and its normal.
fn normal_map() {
    let codes = programs::inputs::codes();
    let mut pixels = programs::inputs::pixels(&codes);
    holds(size_of_val(&pixels));
    measure(&[(); 16], Passes(64), |()| pixels.next().map(NormalPixel::normal_q15));
}

/// Three irradiances, exposed and counted for an exposure.
fn meter() {
    let channels = inputs::numbers::<48>().map(|channel| i32::from(channel.0));
    let (channels, _) = channels.as_chunks::<3>();
    let (exposure, mut meter) = (inputs::exposure(), black_box(Meter::default()));
    holds(size_of_val(&meter));
    measure(channels, Passes(64), |channels| meter.add_linear(exposure.of(Rgb::from(*channels))));
}

/// The irradiances of 16 vertices in color.
fn vertices_16() {
    let Ok(scene) = inputs::color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let scene = black_box(scene);
    let four = inputs::normals();
    let vertices: [_; 4] = [four; 4];
    let mut colors = [Rgb::gray(0); 16];
    holds(size_of_val(&scene) + size_of_val(&vertices) + size_of_val(&colors));
    measure(&[vertices], Passes(4), |vertices| {
        scene.shade_slice(vertices.as_flattened(), black_box(&mut colors))
    });
}

/// A pixel of the gold sphere: normal, irradiance in color, 16 bits.
fn gold() {
    let scene = inputs::color::scene(LOBBY, GOLD_METALLIC_PAINT);
    let scene = scene.and_then(|scene| Ok((scene.exposure_by_factor(1.5)?, scene)));
    let Ok((exposure, scene)) = scene else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene) + size_of_val(&exposure));
    let mut disc = programs::inputs::middle();
    measure(&[(); 16], Passes(64), |()| {
        let pixel = disc.next()?;
        Some(DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal_q15()))))
    });
}

/// A rotation of a light in color about the view axis.
fn turn_view() {
    let mut turned = black_box(Rgb::<LightBuffer<100>>::default());
    holds(size_of_val(&turned));
    // 0.6 and 0.8.
    let angle = black_box([644_245_094, 858_993_459]);
    measure(&[LOBBY], Passes(16), |light| {
        light.turn_about_view_into(angle, black_box(&mut turned)).is_ok()
    });
}
