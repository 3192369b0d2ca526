//! The measured operations in f32. A program is one of these functions, with a table.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use board::{Passes, holds, measure};
use core::hint::black_box;
use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
use eigenshade::{
    BakedMap, Buffer, Disc, DiscPixel, Display, Light, MapPoint, Material, NineTerms, NormalPixel,
    Rgb, Rotation, Tolerance, Tone, sphere,
};
use programs::inputs::floats as inputs;
use table::{COMPONENTS, Coefficients, DEGREE, SCENE, Transfer};

programs::program!();

/// A pixel of a scene.
fn shade() {
    let numbers = inputs::numbers::<COMPONENTS>();
    let Ok(scene) = table::collapse(&Coefficients::from(numbers)) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    let Some(terms) = table::terms(&scene) else { board::exit(false) };
    measure(&inputs::normals(), Passes(64), |normal| table::shade_terms(terms, *normal));
}

/// A pixel of a Lambertian scene.
fn shade_lambertian() {
    shade();
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
    let Ok(mut scene) = table::collapse(&coefficients) else { board::exit(false) };
    holds(size_of_val(&coefficients) + size_of_val(&scene));
    measure(&[coefficients], Passes(256), |coefficients| {
        table::collapse_into(coefficients, black_box(&mut scene)).is_ok()
    });
}

/// A new light on a fixed material, up to the scene.
fn relight_collapse() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = table::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let mut coefficients = Coefficients::from(inputs::numbers::<COMPONENTS>());
    let Ok(mut scene) = table::collapse(&coefficients) else { board::exit(false) };
    holds(size_of_val(&transfer) + size_of_val(&coefficients) + size_of_val(&scene));
    measure(&[inputs::numbers::<100>()], Passes(256), |light| {
        let light = Light::new(light)?;
        table::relight_into(&transfer, &light, &mut coefficients)?;
        table::collapse_into(&coefficients, black_box(&mut scene))
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

/// A bilinear look-up in a baked map, by normal.
fn baked() {
    let Ok(map) = BakedMap::new(32, inputs::numbers::<1024>()) else { board::exit(false) };
    let map = black_box(map);
    holds(size_of_val(&map));
    measure(&inputs::normals(), Passes(64), |normal| map.bilinear(MapPoint::of(*normal)));
}

/// A bilinear look-up in a baked map, by map coordinates.
fn baked_point() {
    let Ok(map) = BakedMap::new(32, inputs::numbers::<1024>()) else { board::exit(false) };
    let map = black_box(map);
    holds(size_of_val(&map));
    let points = inputs::normals().map(MapPoint::of);
    measure(&points, Passes(64), |point| map.bilinear(*point));
}

static DISPLAY: Display = Display::new(Tone::Filmic);

/// The next pixel of a disc and its normal.
fn disc() {
    let mut disc = programs::inputs::middle(Disc::new(black_box(64)));
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

/// Three irradiances to a pixel of 16 bits: exposed, toned and encoded.
fn display() {
    let channels = inputs::numbers::<48>();
    let (channels, _) = channels.as_chunks::<3>();
    let exposure = black_box(1.5);
    measure(channels, Passes(64), |channels| {
        DISPLAY.rgb565(Rgb::from(*channels).exposed(exposure))
    });
}

/// A pixel of the gold sphere: normal, irradiance in color, 16 bits.
fn gold() {
    let Ok(scene) = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    let mut disc = programs::inputs::middle(Disc::new(black_box(64)));
    measure(&[(); 16], Passes(64), |()| {
        let pixel = disc.next()?;
        Some(DISPLAY.rgb565(scene.shade(pixel.normal()).exposed(1.5)))
    });
}

/// A new light in color on the gold sphere, up to the scene.
fn gold_light() {
    let Ok(transfer) = sphere::color::transfer(GOLD_METALLIC_PAINT) else { board::exit(false) };
    let Ok(mut scene) = sphere::color::relight(&transfer, LOBBY) else { board::exit(false) };
    let transfer = black_box(transfer);
    holds(size_of_val(&transfer) + size_of_val(&scene));
    measure(&[LOBBY], Passes(64), |light| {
        sphere::color::relight_into(&transfer, *light, black_box(&mut scene)).is_ok()
    });
}

/// The coefficients of a glTF material in color, for a new roughness.
fn metallic_roughness() {
    let copper = [0.93, 0.52, 0.38];
    holds(size_of::<Rgb<Buffer<f32, 40>>>());
    measure(&[0.3, 0.7], Passes(64), |roughness| {
        Material::metallic_roughness(black_box(copper), 1.0, *roughness)
    });
}

/// A rotation of a light in color about any axis.
fn turn() {
    let rotation = Rotation::from_quaternion(black_box([0.1, 0.2, 0.3, 1.0]));
    let Ok(rotation) = rotation else { board::exit(false) };
    holds(size_of_val(&rotation));
    measure(&[LOBBY], Passes(64), |light| light.turned::<100>(&rotation));
}

/// A rotation of a light in color about the view axis.
fn turn_view() {
    let mut turned = [[0.0; 100]; 3];
    holds(size_of_val(&turned));
    measure(&[LOBBY], Passes(64), |light| {
        let turned = black_box(&mut turned);
        [light.r, light.g, light.b]
            .iter()
            .zip(turned)
            .try_for_each(|(light, turned)| light.turn_about_view_into([0.6, 0.8], turned))
    });
}
