//! The measured operations in Q15. A program is one of these functions, with a table.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use board::{Passes, holds, measure};
use core::hint::black_box;
use eigenshade::presets::{light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT};
use eigenshade::q15::{
    BakedMap, Exposure, Highlights, Irradiance, LightBuffer, Lobe, MapPoint, Material,
    MaterialBuffer, NineTerms, Rotation,
};
use eigenshade::{DiscPixel, Display, Error, Meter, NormalPixel, Q15, Rgb, Tone, sphere};
use programs::inputs::integers as inputs;
use table::{BASIS, COMPONENTS, Coefficients, ORDER, SCENE, Scene, Transfer};

programs::program!();

/// A pixel of a scene.
fn shade() {
    let mantissas = [0; COMPONENTS].map(|_: i32| black_box(123_456_789));
    let Ok(scene) = BASIS.collapse::<SCENE>(&mantissas, -30) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    measure(&inputs::normals(), Passes(256), |normal| table::shade(&scene, *normal));
}

/// The same with the highlights of two sources, which all normals face.
fn shade_highlights() {
    let mantissas = [0; COMPONENTS].map(|_: i32| black_box(123_456_789));
    let Ok(scene) = BASIS.collapse::<SCENE>(&mantissas, -30) else { board::exit(false) };
    let lobes = programs::highlights::GRAY.first_chunk::<2>();
    let Some(Ok(highlights)) = lobes.map(|lobes| of_lobes::<_, 2>(lobes, scene.exponent())) else {
        board::exit(false)
    };
    let (scene, highlights) = (black_box(scene), black_box(highlights));
    holds(size_of_val(&scene) + size_of_val(&highlights));
    measure(&inputs::normals(), Passes(256), |normal| {
        highlights.add(table::shade(&scene, *normal), *normal)
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
    let Ok(scene) = sphere::q15::color::scene(LOBBY, GOLD_METALLIC_PAINT) else {
        board::exit(false)
    };
    let exponents = scene.each_ref().map(|channel| channel.exponent());
    let Ok(highlights) = of_lobes(&programs::highlights::COLOR, exponents) else {
        board::exit(false)
    };
    let (scene, highlights) = (black_box(scene), black_box(highlights));
    holds(size_of_val(&scene) + size_of_val(&highlights));
    measure(&inputs::normals(), Passes(64), |normal| highlights.add(scene.shade(*normal), *normal));
}

/// A pixel of a Lambertian scene, by the nine-term formula.
fn shade_lambertian() {
    let mantissas = [0; COMPONENTS].map(|_: i32| black_box(123_456_789));
    let Ok(scene) = BASIS.collapse::<SCENE>(&mantissas, -30) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    let Some(formula) = scene.nine_terms() else { board::exit(false) };
    measure(&inputs::normals(), Passes(256), |normal| formula.shade(*normal));
}

/// A new light on a fixed material.
fn relight() {
    relight_up_to!();
}

/// A new light on a fixed material, up to the scene.
fn relight_collapse() {
    relight_up_to!(collapse_into);
}

/// A new light on a fixed material, up to the coefficients or with `collapse_into` up to the scene.
/// A macro, so that the former is linked without `collapse_into`.
macro_rules! relight_up_to {
    ($($collapse_into:ident)?) => {
        let material = inputs::mantissas::<40>();
        let Ok(transfer) = table::transfer(&inputs::material(&material, ORDER)) else {
            board::exit(false)
        };
        let transfer = black_box(transfer);
        let (mut d, mut scene) = (Coefficients::default(), Scene::default());
        let of_scene = [$(stringify!($collapse_into))?].map(|_: &str| size_of_val(&scene));
        holds(of_scene.into_iter().sum());
        holds(size_of_val(&transfer) + size_of_val(&d));
        measure(&[inputs::mantissas::<100>()], Passes(64), |light| {
            let light = inputs::light(light);
            let done = table::relight_into(&transfer.view(), &light, black_box(&mut d));
            // Without `collapse_into`, the scene is not used otherwise.
            let _ = &mut scene;
            $(let done = done.and_then(|()| table::$collapse_into(&d, black_box(&mut scene)));)?
            done
        });
    };
}
use relight_up_to;

/// The coefficients of an image to its scene.
fn collapse() {
    let material = inputs::mantissas::<40>();
    let light = inputs::mantissas::<100>();
    let light = inputs::light(&light);
    let relit = table::transfer(&inputs::material(&material, ORDER))
        .and_then(|transfer| table::relight(&transfer.view(), &light));
    let Ok(relit) = relit else { board::exit(false) };
    let mut scene = Scene::default();
    holds(size_of_val(&relit) + size_of_val(&scene));
    measure(&[relit], Passes(64), |relit| table::collapse_into(relit, black_box(&mut scene)));
}

/// A new material, combined with the basis.
fn transfer() {
    let mut transfer = Transfer::default();
    holds(size_of_val(&transfer));
    measure(&[inputs::mantissas::<40>()], Passes(16), |material| {
        let material = inputs::material(material, ORDER);
        table::transfer_into(&material, black_box(&mut transfer))
    });
}

/// A pixel by the nine-term formula.
fn nine_terms() {
    let coefficients = [9000, 500, -3000, 8000, -700, -1200, 2500, 900, 3100];
    let formula = black_box(NineTerms::new(black_box(coefficients), -15));
    measure(&inputs::normals(), Passes(256), |normal| formula.shade(*normal));
}

/// A bilinear look-up in a baked map, by normal.
fn baked() {
    let map = baked_map();
    holds(size_of_val(&map));
    let normals = inputs::normals();
    measure(&normals, Passes(256), |normal| map.bilinear(MapPoint::of(*normal)));
}

/// A bilinear look-up in a baked map, by map coordinates.
fn baked_point() {
    let map = baked_map();
    holds(size_of_val(&map));
    let points = inputs::normals().map(MapPoint::of);
    measure(&points, Passes(256), |point| map.bilinear(*point));
}

fn baked_map() -> BakedMap<[i16; 1024]> {
    let texels = inputs::mantissas::<1024>().map(|texel| texel.0);
    let Ok(map) = BakedMap::new(32, 0, texels) else { board::exit(false) };
    black_box(map)
}

/// One row of a dense projection. A projection has one for each component.
fn dense_row() {
    measure(&[&ROW, &ROW], Passes(8), |modes| dense_product(modes));
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

static DISPLAY: Display = Display::new(Tone::Filmic);

fn exposure() -> Rgb<Exposure> {
    let exposure = Exposure::new(black_box(1.5), -15);
    Rgb::gray(exposure.unwrap_or_else(|_| board::exit(false)))
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

/// Three irradiances to a pixel of 16 bits: exposed, toned and encoded.
fn display() {
    let channels = inputs::mantissas::<48>().map(|channel| i32::from(channel.0));
    let (channels, _) = channels.as_chunks::<3>();
    let exposure = exposure();
    measure(channels, Passes(64), |channels| DISPLAY.rgb565(exposure.of(Rgb::from(*channels))));
}

/// The same in 24 bits.
fn display_888() {
    let channels = inputs::mantissas::<48>().map(|channel| i32::from(channel.0));
    let (channels, _) = channels.as_chunks::<3>();
    let exposure = exposure();
    measure(channels, Passes(64), |channels| DISPLAY.rgb888(exposure.of(Rgb::from(*channels))));
}

/// The same in 16 bits, with ordered dithering.
fn display_dithered() {
    let channels = inputs::mantissas::<48>().map(|channel| i32::from(channel.0));
    let (channels, _) = channels.as_chunks::<3>();
    let (exposure, mut column) = (exposure(), 0);
    measure(channels, Passes(64), |channels| {
        column += 1;
        DISPLAY.rgb565_dithered(exposure.of(Rgb::from(*channels)), column, 1)
    });
}

/// Three irradiances, exposed and counted for an exposure.
fn meter() {
    let channels = inputs::mantissas::<48>().map(|channel| i32::from(channel.0));
    let (channels, _) = channels.as_chunks::<3>();
    let (exposure, mut meter) = (exposure(), black_box(Meter::default()));
    holds(size_of_val(&meter));
    measure(channels, Passes(64), |channels| meter.add_linear(exposure.of(Rgb::from(*channels))));
}

/// A pixel of the gold sphere in three channels.
fn color() {
    let Ok(scene) = sphere::q15::color::scene(LOBBY, GOLD_METALLIC_PAINT) else {
        board::exit(false)
    };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    measure(&inputs::normals(), Passes(64), |normal| scene.shade(*normal));
}

/// The irradiances of 16 vertices in color.
fn vertices_16() {
    let Ok(scene) = sphere::q15::color::scene(LOBBY, GOLD_METALLIC_PAINT) else {
        board::exit(false)
    };
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
    let scene = sphere::q15::color::scene(LOBBY, GOLD_METALLIC_PAINT);
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

/// The coefficients of a glTF material in color, for a new roughness.
fn metallic_roughness() {
    let copper = [Q15(30_474), Q15(17_039), Q15(12_452)];
    holds(size_of::<Rgb<MaterialBuffer<40, 8>>>());
    measure(&[Q15(9_830), Q15(22_938)], Passes(64), |roughness| {
        Material::metallic_roughness(black_box(copper), Q15(i16::MAX), *roughness)
    });
}

/// The same to order 12.
fn metallic_roughness_12() {
    let copper = [Q15(30_474), Q15(17_039), Q15(12_452)];
    holds(size_of::<Rgb<MaterialBuffer<140, 13>>>());
    measure(&[Q15(9_830), Q15(22_938)], Passes(64), |roughness| {
        Material::metallic_roughness_of_order_12(black_box(copper), Q15(i16::MAX), *roughness)
    });
}

/// A new light in color on the gold sphere, up to the scene.
fn gold_light() {
    let transfer = sphere::q15::color::transfer(GOLD_METALLIC_PAINT);
    let Ok(transfer) = transfer else { board::exit(false) };
    let Ok(mut scene) = sphere::q15::color::relight(&transfer, LOBBY) else { board::exit(false) };
    let transfer = black_box(transfer);
    holds(size_of_val(&transfer) + size_of_val(&scene));
    measure(&[LOBBY], Passes(16), |light| {
        sphere::q15::color::relight_into(&transfer, *light, black_box(&mut scene)).is_ok()
    });
}

/// A rotation of a light in color about any axis.
fn turn() {
    let rotation = Rotation::from_quaternion(black_box([1, 2, 3, 10]));
    let Ok(rotation) = rotation else { board::exit(false) };
    holds(size_of_val(&rotation));
    measure(&[LOBBY], Passes(16), |light| light.turned::<100>(&rotation));
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
