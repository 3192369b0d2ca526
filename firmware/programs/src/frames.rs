//! Frames of a sphere of 240 x 240 pixels, the same in both number formats but for types and inputs.

use super::inputs::{self, GOLD_METALLIC_PAINT, LOBBY, color};
use super::{highlighted, nine_terms, normal};
use board::{Passes, holds, measure};
use core::hint::black_box;
use eigenshade::object::{NormalMap, NormalPixel, Object};
use eigenshade::screen::{Exposure, LinearPalette, Palette, Target};
use eigenshade::{Error, Rgb};
use programs::{BALL, DISPLAY};

/// A row of pixels in the byte order of a display on SPI.
type Row = [[u8; 2]; BALL];

/// The light turned, the material relit, a palette filled, and every row drawn.
pub fn frame() {
    let Ok(map) = programs::ball() else { board::exit(false) };
    let (mut palette, mut row) = (Palette::default(), [[0; 2]; BALL]);
    let (nodes, exposure) = (map.nodes(), inputs::exposure());
    let held = size_of_val(&palette) + size_of_val(&nodes) + size_of_val(&row);
    turning(held, |scene, _| {
        palette.fill_mirrored(&nodes, &DISPLAY, |normal| {
            scene.shade_mirrored(normal).map(|color| exposure.of(color))
        });
        draw(&palette, &map, &mut row)
    });
}

/// The rows alone: the light stands still.
pub fn frame_still() {
    let Ok(map) = programs::ball() else { board::exit(false) };
    let (palette, mut row) = (black_box(Palette::default()), [[0; 2]; BALL]);
    holds(size_of_val(&palette) + size_of_val(&row));
    measure(&[()], Passes(1), |()| draw(&palette, &map, &mut row));
}

/// A frame with the highlights of four sources.
pub fn frame_sources() {
    let Ok(map) = programs::ball() else { board::exit(false) };
    let (mut palette, mut row) = (Palette::default(), [[0; 2]; BALL]);
    let (nodes, exposure) = (map.nodes(), inputs::exposure());
    let held = size_of_val(&palette) + size_of_val(&nodes) + size_of_val(&row);
    turning(held, |scene, rotation| {
        let shade = highlighted(scene, rotation)?;
        palette.fill_mirrored(&nodes, &DISPLAY, |normal| {
            shade(normal).map(|color| exposure.of(color))
        });
        draw(&palette, &map, &mut row)
    });
}

/// A frame of a textured object of 120 x 120 pixels and one region.
pub fn frame_textured() {
    let Ok(object) = programs::object() else { board::exit(false) };
    let Some(region) = object.regions().next() else { board::exit(false) };
    let Ok(parts) = inputs::parts(&region) else { board::exit(false) };
    let (mut palette, mut row) = (LinearPalette::default(), [[0; 2]; BALL]);
    let (nodes, exposure) = (object.nodes(0), inputs::exposure());
    let (parts, rotation) = (black_box(&parts), inputs::rotation());
    holds(size_of_val(parts) + size_of_val(&palette) + size_of_val(&nodes) + size_of_val(&row));
    measure(&[LOBBY], Passes(1), |light| {
        let light = light.turned::<100>(&rotation)?;
        let [tinted, plain] = parts;
        let tinted = color::relight(tinted, light.lights()?)?;
        let plain = color::relight(plain, light.lights()?)?;
        palette.fill_mirrored(&nodes, |normal| {
            [&tinted, &plain]
                .map(|part| part.shade_mirrored(normal).map(|color| exposure.of(color)))
        });
        draw_textured(&palette, &object, &mut row)
    });
}

/// The rows of [`frame_textured`] alone.
pub fn frame_textured_still() {
    let Ok(object) = programs::object() else { board::exit(false) };
    let (palette, mut row) = (black_box(LinearPalette::default()), [[0; 2]; BALL]);
    holds(size_of_val(&palette) + size_of_val(&row));
    measure(&[()], Passes(1), |()| draw_textured(&palette, &object, &mut row));
}

/// A frame of an object with shadows of 96 x 96 pixels, under light of degree 16.
pub fn frame_shadowed() {
    let Ok(object) = programs::shadowed() else { board::exit(false) };
    let (mut colors, mut row) = ([[0_u8; 2]; 4096], [[0; 2]; 96]);
    let Ok(exposure) = Exposure::new(black_box(1.5)) else { board::exit(false) };
    let rotation = inputs::rotation();
    holds(size_of_val(&colors) + size_of_val(&row));
    let channels = [inputs::numbers::<289>(); 3];
    measure(&[channels], Passes(1), |channels| {
        let light = Rgb::from(channels.each_ref().map(|channel| inputs::light(channel)));
        let light = light.turned::<289>(&rotation)?;
        let d = inputs::coefficients(&object, light.lights()?)?;
        object.colors(&d, exposure, &DISPLAY, &mut colors)?;
        for place in 0..object.height() as i32 {
            row.fill([0; 2]);
            object.draw(&colors, &mut Target::new(&mut row, 96)?.at(0, -place));
            black_box(&mut row);
        }
        Ok::<(), Error>(())
    });
}

/// The light turned, the material relit, and every pixel shaded.
pub fn frame_shaded() {
    let Ok(map) = programs::ball() else { board::exit(false) };
    let (exposure, mut row) = (inputs::exposure(), [[0; 2]; BALL]);
    turning(size_of_val(&row), |scene, _| {
        draw_shaded(&map, &mut row, |pixel| DISPLAY.rgb565(exposure.of(scene.shade(normal(pixel)))))
    });
}

/// Measures what paints a scene, with the turn of the light and the relighting of the material before
/// it. `held` is what it keeps between frames.
fn turning(
    held: usize,
    mut paint: impl FnMut(&color::Scene, &inputs::Rotation) -> Result<(), Error>,
) {
    let Ok(transfer) = color::transfer(GOLD_METALLIC_PAINT) else { board::exit(false) };
    let (transfer, rotation) = (black_box(&transfer), inputs::rotation());
    holds(size_of_val(transfer) + held);
    measure(&[LOBBY], Passes(1), |light| {
        let light = light.turned::<100>(&rotation)?;
        paint(&color::relight(transfer, light.lights()?)?, &rotation)
    });
}

/// Baseline: every pixel of a matte material by the nine-term formula, under a light that stands
/// still.
pub fn frame_nine_terms() {
    let (formulas, exposure) = (black_box(Rgb::gray(nine_terms())), inputs::exposure());
    let Ok(map) = programs::ball() else { board::exit(false) };
    let mut row = [[0; 2]; BALL];
    holds(size_of_val(&formulas) + size_of_val(&row));
    measure(&[()], Passes(1), |()| {
        draw_shaded(&map, &mut row, |pixel| {
            let normal = normal(pixel);
            let color = formulas.each_ref().map(|formula| formula.shade(normal));
            DISPLAY.rgb565(exposure.of(color))
        })
    });
}

/// Baseline: every pixel from a matcap of 64 x 64 pixels, by the nearest normal.
pub fn frame_matcap() {
    let (matcap, mut row) = (black_box([[0x12_u8, 0x34]; 64 * 64]), [[0; 2]; BALL]);
    holds(size_of_val(&matcap) + size_of_val(&row));
    measure(&[()], Passes(1), |()| {
        for codes in programs::CODES.as_chunks::<2>().0.as_chunks::<BALL>().0 {
            matcap_row(&matcap, codes, &mut row);
            black_box(&mut row);
        }
    });
}

/// The rim is not mixed with what is below it.
#[inline(never)]
fn matcap_row(matcap: &[[u8; 2]; 64 * 64], codes: &[[u8; 2]; BALL], row: &mut Row) {
    for (pixel, code) in row.iter_mut().zip(codes) {
        let [u, v] = code.map(|byte| usize::from(byte ^ 0x80) >> 2);
        *pixel = matcap.get(64 * v + u).copied().unwrap_or_default();
    }
}

/// Draws every row by the color of each pixel.
fn draw_shaded(
    map: &NormalMap<'_>,
    row: &mut Row,
    color: impl Fn(NormalPixel) -> u16,
) -> Result<(), Error> {
    for place in 0..BALL {
        row.fill([0; 2]);
        let mut target = Target::new(row, BALL)?;
        let mut target = target.at(0, -(place as i32));
        for pixel in map.row(place) {
            pixel.put(&mut target, color(pixel).to_be_bytes());
        }
        black_box(&mut *row);
    }
    Ok(())
}

/// Draws every row, on black.
fn draw(palette: &Palette, map: &NormalMap<'_>, row: &mut Row) -> Result<(), Error> {
    for place in 0..BALL as i32 {
        row.fill([0; 2]);
        palette.draw(map, &mut Target::new(row, BALL)?.at(0, -place));
        black_box(&mut *row);
    }
    Ok(())
}

/// Draws every row of a textured object, on black.
fn draw_textured(palette: &LinearPalette, object: &Object<'_>, row: &mut Row) -> Result<(), Error> {
    let painted = object.painted(core::slice::from_ref(palette), &DISPLAY)?;
    for place in 0..object.height() as i32 {
        row.fill([0; 2]);
        painted.draw(&mut Target::new(row, BALL)?.at(0, -place));
        black_box(&mut *row);
    }
    Ok(())
}
