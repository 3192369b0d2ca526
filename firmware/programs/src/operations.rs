//! The measured operations that are the same in both number formats, but for types and inputs.

use super::inputs::{
    self, GOLD_METALLIC_PAINT, LOBBY, MapPoint, Material, Normal, OfOrder7, OfOrder12, color,
};
use board::{Passes, holds, measure};
use core::hint::black_box;
use eigenshade::screen::{Linear, Nodes, Palette, Target};
use eigenshade::{Error, Rgb};
pub use programs::DISPLAY;

/// A bilinear look-up in a baked map, by normal.
pub fn baked() {
    let Ok(map) = inputs::baked_map() else { board::exit(false) };
    let map = black_box(map);
    holds(size_of_val(&map));
    measure(&inputs::normals(), Passes(256), |normal| map.bilinear(MapPoint::of(*normal)));
}

/// A bilinear look-up in a baked map, by map coordinates.
pub fn baked_point() {
    let Ok(map) = inputs::baked_map() else { board::exit(false) };
    let map = black_box(map);
    holds(size_of_val(&map));
    let points = inputs::normals().map(MapPoint::of);
    measure(&points, Passes(256), |point| map.bilinear(*point));
}

/// Three irradiances to a pixel of 16 bits: exposed, toned and encoded.
pub fn display() {
    let channels = inputs::numbers::<48>().map(inputs::irradiance);
    let (channels, _) = channels.as_chunks::<3>();
    let exposure = inputs::exposure();
    measure(channels, Passes(64), |channels| DISPLAY.rgb565(exposure.of(Rgb::from(*channels))));
}

/// The same in 24 bits.
pub fn display_888() {
    let channels = inputs::numbers::<48>().map(inputs::irradiance);
    let (channels, _) = channels.as_chunks::<3>();
    let exposure = inputs::exposure();
    measure(channels, Passes(64), |channels| DISPLAY.rgb888(exposure.of(Rgb::from(*channels))));
}

/// The same in 16 bits, with ordered dithering.
pub fn display_dithered() {
    let channels = inputs::numbers::<48>().map(inputs::irradiance);
    let (channels, _) = channels.as_chunks::<3>();
    let (exposure, mut column) = (inputs::exposure(), 0);
    measure(channels, Passes(64), |channels| {
        column += 1;
        DISPLAY.rgb565_dithered(exposure.of(Rgb::from(*channels)), column, 1)
    });
}

/// A pixel of the gold sphere, in color.
pub fn color() {
    let Ok(scene) = color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    measure(&inputs::normals(), Passes(64), |normal| scene.shade(*normal));
}

/// A pixel of the gold sphere and its three mirror images, in color.
pub fn color_mirrored() {
    let Ok(scene) = color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let scene = black_box(scene);
    holds(size_of_val(&scene));
    measure(&inputs::normals(), Passes(64), |normal| scene.shade_mirrored(*normal));
}

/// A new light in color on the gold sphere, up to the scene.
pub fn gold_light() {
    let Ok(transfer) = color::transfer(GOLD_METALLIC_PAINT) else { board::exit(false) };
    let Ok(mut scene) = color::relight(&transfer, LOBBY) else { board::exit(false) };
    let transfer = black_box(transfer);
    holds(size_of_val(&transfer) + size_of_val(&scene));
    measure(&[LOBBY], Passes(64), |light| {
        color::relight_into(&transfer, *light, black_box(&mut scene)).is_ok()
    });
}

/// The coefficients of a glTF material in color, for a new roughness.
pub fn metallic_roughness() {
    let (copper, roughnesses) = (inputs::COPPER, inputs::ROUGHNESSES);
    holds(size_of::<OfOrder7>());
    measure(&roughnesses, Passes(64), |roughness| {
        Material::metallic_roughness(black_box(copper), inputs::ONE, *roughness)
    });
}

/// The same to order 12.
pub fn metallic_roughness_12() {
    let (copper, roughnesses) = (inputs::COPPER, inputs::ROUGHNESSES);
    holds(size_of::<OfOrder12>());
    measure(&roughnesses, Passes(64), |roughness| {
        Material::metallic_roughness_of_order_12(black_box(copper), inputs::ONE, *roughness)
    });
}

/// A rotation of a light in color about any axis.
pub fn turn() {
    let rotation = inputs::rotation();
    holds(size_of_val(&rotation));
    measure(&[LOBBY], Passes(64), |light| light.turned::<100>(&rotation));
}

/// All nodes of a palette, for the gold sphere.
pub fn palette() {
    let Ok(scene) = color::scene(LOBBY, GOLD_METALLIC_PAINT) else { board::exit(false) };
    let (scene, exposure) = (black_box(scene), inputs::exposure());
    let mut palette = Palette::default();
    holds(size_of_val(&scene) + size_of_val(&palette));
    measure(&[()], Passes(1), |()| {
        palette.fill_mirrored(&Nodes::ALL, &DISPLAY, |normal| {
            scene.shade_mirrored(normal).map(|color| exposure.of(color))
        });
        black_box(&mut palette);
    });
}

/// A row of 240 pixels through the middle of a sphere, from a palette.
pub fn palette_row() {
    let mut palette = Palette::default();
    palette.fill(&Nodes::ALL, &DISPLAY, |_: Normal| Rgb::gray(Linear(40_000)));
    let palette = black_box(&palette);
    let Ok(map) = programs::ball() else { board::exit(false) };
    let mut row = [0; programs::BALL];
    holds(size_of_val(palette) + size_of_val(&row));
    measure(&[-120], Passes(16), |place| {
        let mut target = Target::new(&mut row, programs::BALL)?;
        palette.draw(&map, &mut target.at(0, *place));
        black_box(&mut row);
        Ok::<(), Error>(())
    });
}

/// The same with ordered dithering.
pub fn palette_row_dithered() {
    let mut palette = Palette::default();
    palette.fill(&Nodes::ALL, &DISPLAY, |_: Normal| Rgb::gray(Linear(40_000)));
    let palette = black_box(&palette);
    let Ok(map) = programs::ball() else { board::exit(false) };
    let mut row = [0; programs::BALL];
    holds(size_of_val(palette) + size_of_val(&row));
    measure(&[-120], Passes(16), |place| {
        let mut target = Target::new(&mut row, programs::BALL)?;
        palette.dithered().draw(&map, &mut target.at(0, *place));
        black_box(&mut row);
        Ok::<(), Error>(())
    });
}
