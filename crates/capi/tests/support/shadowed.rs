//! The pictures of `example/shadowed.c`.

use super::{Encoding, SIDE, checksum, objects};
use eigenshade::Error;
use eigenshade::object::{ObjectCoefficients, ShadowedObject};
use eigenshade::presets::light::q15::LOBBY;
use eigenshade::screen::{Display, Exposure, Target, Tone};
use eigenshade::{Rgb, screen::Pixel};
use std::fmt::Write as _;

fn colors<P: Pixel>(
    object: &ShadowedObject<'_>,
    d: &Rgb<ObjectCoefficients>,
    below: P,
) -> Result<Vec<P>, Error> {
    let mut colors: Vec<P> = (0..object.codes()).map(|_| below).collect();
    object.colors(d, Exposure::new(1.5)?, &Display::new(Tone::Filmic), &mut colors)?;
    Ok(colors)
}

/// A part of the object, as bytes with what is between the rows.
fn target<P: Encoding>(
    lines: &mut String,
    object: &ShadowedObject<'_>,
    d: &Rgb<ObjectCoefficients>,
) -> Result<(), Error> {
    let mut pixels = [P::BELOW; 40 * 30];
    let colors = colors(object, d, P::BELOW)?;
    object.draw(&colors, &mut Target::new(&mut pixels, 40)?.at(-5, 7));
    let rows = pixels.chunks(40).flat_map(|row| {
        let mut bytes: Vec<u8> = row.iter().flat_map(|pixel| pixel.bytes()).collect();
        bytes.resize(P::STRIDE, 0x5a);
        bytes
    });
    let _ = writeln!(lines, "shadowed target,{}", checksum(rows));
    Ok(())
}

/// The lines.
pub fn lines(lines: &mut String) -> Result<(), Error> {
    let bytes = objects::shaded()?;
    let object = ShadowedObject::new(&bytes)?;
    let d = object.coefficients_q15(LOBBY)?;
    let mut picture = [0_u16; SIDE * SIDE];
    object.draw(&colors(&object, &d, 0_u16)?, &mut Target::new(&mut picture, SIDE)?);
    let bytes = picture.iter().flat_map(|pixel| pixel.to_le_bytes());
    let _ = writeln!(lines, "shadowed,{}", checksum(bytes));
    target::<u16>(lines, &object, &d)?;
    target::<[u8; 2]>(lines, &object, &d)?;
    target::<[u8; 3]>(lines, &object, &d)?;
    target::<[u8; 4]>(lines, &object, &d)
}
