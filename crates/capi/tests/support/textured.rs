//! The pictures of `example/textured.c`.

use super::{Encoding, LIGHT, SIDE, checksum, lobby_sources, objects, rest};
use eigenshade::object::Object;
use eigenshade::presets::light::q15::LOBBY;
use eigenshade::screen::{Display, LinearPalette, Target, Tone};
use eigenshade::sphere::q15::color;
use eigenshade::{Error, Q15, Rgb, Source, q15};
use std::fmt::Write as _;

/// A palette for each region of an object.
fn palettes(
    object: &Object<'_>,
    light: Rgb<q15::Light<'_>>,
    sources: &[Source],
) -> Result<Vec<LinearPalette>, Error> {
    let regions = object.regions().enumerate();
    let filled = regions.map(|(number, region)| {
        let [tinted, plain] = region.materials_q15()?;
        let [of_tinted, of_plain] = region.highlights::<4>(sources)?;
        let part = |material: &q15::MaterialBuffer<40, 8>, highlights| {
            let scene = color::scene(light, material.material()?)?;
            let exponents = scene.each_ref().map(|channel| channel.exponent());
            let highlights = q15::Highlights::<Rgb<i32>, 4>::quantize(highlights, exponents)?;
            let exposure = scene.exposure_by_factor(1.5)?;
            Ok::<_, Error>(move |normal: q15::Normal| {
                let mut images = normal.mirrored().into_iter();
                scene.shade_mirrored(normal).map(|irradiance| {
                    let image = images.next().unwrap_or(normal);
                    exposure.of(highlights.add(irradiance, image))
                })
            })
        };
        let parts = [part(&tinted, &of_tinted)?, part(&plain, &of_plain)?];
        let mut palette = LinearPalette::default();
        palette.fill_mirrored(&object.nodes(number), |normal| {
            parts.each_ref().map(|part| part(normal))
        });
        Ok(palette)
    });
    filled.collect()
}

/// A part of the object, as bytes with what is between the rows.
fn target<P: Encoding>(
    lines: &mut String,
    object: &Object<'_>,
    palettes: &[LinearPalette],
    display: &Display,
) -> Result<(), Error> {
    let painted = object.painted(palettes, display)?;
    for painted in [painted, painted.dithered()] {
        let mut pixels = [P::BELOW; 40 * 30];
        painted.draw(&mut Target::new(&mut pixels, 40)?.at(-5, 7));
        let rows = pixels.chunks(40).flat_map(|row| {
            let mut bytes: Vec<u8> = row.iter().flat_map(|pixel| pixel.bytes()).collect();
            bytes.resize(P::STRIDE, 0x5a);
            bytes
        });
        let _ = writeln!(lines, "textured target,{}", checksum(rows));
    }
    Ok(())
}

/// The lines.
pub fn lines(lines: &mut String) -> Result<(), Error> {
    let bytes = objects::striped()?;
    let object = Object::new(&bytes)?;
    let display = Display::new(Tone::Filmic);
    let matte = palettes(&object, LOBBY, &[])?;
    let sources = lobby_sources()?;
    let mut mantissas = [[Q15(0); LIGHT]; 3];
    let glossy = palettes(&object, rest(&sources, &mut mantissas)?, &sources)?;
    let glossy_painted = object.painted(&glossy, &display)?;
    let matte = object.painted(&matte, &display)?;
    for (name, painted) in [
        ("textured", matte),
        ("dithered", matte.dithered()),
        ("textured highlights", glossy_painted),
    ] {
        let mut picture = [0_u16; SIDE * SIDE];
        painted.draw(&mut Target::new(&mut picture, SIDE)?);
        let bytes = picture.iter().flat_map(|pixel| pixel.to_le_bytes());
        let _ = writeln!(lines, "{name},{}", checksum(bytes));
    }
    target::<u16>(lines, &object, &glossy, &display)?;
    target::<[u8; 2]>(lines, &object, &glossy, &display)?;
    target::<[u8; 3]>(lines, &object, &glossy, &display)?;
    target::<[u8; 4]>(lines, &object, &glossy, &display)
}
