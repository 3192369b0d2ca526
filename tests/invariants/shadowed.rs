//! Objects with shadows of any numbers, in targets of any shape.

use super::Reader;
use eigenshade::object::ShadowedObject;
use eigenshade::screen::{Display, Exposure, Target, Tone, blend565};
use eigenshade::{Light, Q15, Rgb, q15};
use eigenshade_table::light;
use eigenshade_table::shadowed::{Cluster, File, Pixel, Row};

static DISPLAY: Display = Display::new(Tone::Filmic);

/// An object has the size that was written, a color for each code, and is drawn as pixel by pixel; with
/// changed bytes, it is refused or drawn.
pub fn drawn(input: &mut Reader<'_>) {
    let file = file(input);
    let mut bytes = file.encode();
    let object = ShadowedObject::new(&bytes).expect("a written object");
    assert_eq!([object.width(), object.height()], file.size.map(usize::from));
    assert_eq!(object.degree(), usize::from(file.degree));
    let colors = colors(&object, input);

    let [across, down] = [(); 2].map(|()| 1 + input.up_to(12));
    let at = [(); 2].map(|()| i32::from(input.byte() % 24) - 12);
    let mut both = [(); 2].map(|()| vec![0x1234_u16; across * down]);
    let [whole, single] = &mut both;
    object.draw(&colors, &mut Target::new(whole, across).expect("a row").at(at[0], at[1]));
    let mut target = Target::new(single, across).expect("a row");
    let mut target = target.at(at[0], at[1]);
    for pixel in &file.pixels {
        let below = target.pixel(pixel.column.into(), pixel.row.into());
        if let (Some(below), Some(&color)) = (below, colors.get(usize::from(pixel.code))) {
            *below = blend565(*below, color, pixel.coverage);
        }
    }
    assert_eq!(whole, single);

    for _ in 0..1 + input.up_to(3) {
        let place = usize::from(u16::from_le_bytes(input.bytes())) % bytes.len();
        bytes[place] = input.byte();
    }
    bytes.truncate(bytes.len() - input.up_to(2) * input.up_to(40).min(bytes.len() / 2));
    if let Ok(object) = ShadowedObject::new(&bytes) {
        let colors = self::colors(&object, input);
        object.draw(&colors, &mut Target::new(&mut [0_u16; 30], 6).expect("rows"));
    }
}

/// A file of small sizes.
fn file(input: &mut Reader<'_>) -> File {
    let size = [(); 2].map(|()| 1 + u16::from(input.byte()) % 9);
    let [degree, parts, rank, images] = [2, 3, 6, 16].map(|most| input.up_to(most));
    let [parts, rank] = [parts, rank].map(|one| one.max(1));
    let count = light::count(degree);
    let words = |input: &mut Reader<'_>, count: usize| {
        (0..count).map(|_| i16::from_le_bytes(input.bytes())).collect::<Vec<_>>()
    };
    let bytes = |input: &mut Reader<'_>, count: usize| {
        (0..count).map(|_| input.byte().cast_signed()).collect::<Vec<_>>()
    };
    let exponent = |input: &mut Reader<'_>| input.byte().cast_signed();
    let row = |input: &mut Reader<'_>| Row {
        exponent: exponent(input),
        shifts: (0..=degree).map(|_| input.up_to(12) as u8).collect(),
        mantissas: bytes(input, count),
    };
    let clusters: Vec<_> = (0..1 + input.up_to(2))
        .map(|_| Cluster {
            mean: (exponent(input), words(input, rank)),
            images: (0..images).map(|_| (exponent(input), bytes(input, rank))).collect(),
            weights: (0..input.up_to(4)).map(|_| bytes(input, images)).collect(),
        })
        .collect();
    let codes: usize = clusters.iter().map(|cluster| cluster.weights.len()).sum();
    let mut pixels = Vec::new();
    for (row, column) in (0..size[1]).flat_map(|row| (0..size[0]).map(move |one| (row, one))) {
        let choice = input.byte();
        if choice > 60 {
            // One more than there are.
            let code = (usize::from(choice) % (codes + 1)) as u16;
            let coverage = if choice > 120 { u8::MAX } else { input.byte() };
            pixels.push(Pixel { column, row, code, coverage });
        }
    }
    File {
        size,
        degree: degree as u8,
        shares: (0..parts).map(|_| [(); 3].map(|()| i16::from_le_bytes(input.bytes()))).collect(),
        rows: (0..parts).map(|_| (0..rank).map(|_| row(input)).collect()).collect(),
        clusters,
        pixels,
    }
}

/// The colors of an object in a light of any numbers, in floats or in integers.
fn colors(object: &ShadowedObject<'_>, input: &mut Reader<'_>) -> Vec<u16> {
    let degree = input.up_to(object.degree());
    let count = light::count(degree);
    let d = if input.byte() & 1 == 0 {
        let channels = [(); 3].map(|()| input.floats(count, false));
        let light = channels.each_ref().map(|one| Light::from_finite(one).expect("a light"));
        object.coefficients(light.into())
    } else {
        let channels = [(); 3].map(|()| {
            let exponent = i32::from(input.byte().cast_signed());
            let mantissas: Vec<_> =
                (0..count).map(|_| Q15(i16::from_le_bytes(input.bytes()))).collect();
            (exponent, mantissas)
        });
        let light = channels
            .each_ref()
            .map(|(exponent, mantissas)| q15::Light::new(*exponent, mantissas).expect("a light"));
        object.coefficients_q15(light.into())
    };
    let d = d.expect("a light of its degree");
    let exposure = Exposure::new(input.float(false)).unwrap_or_default();
    let mut shaded = Vec::new();
    let shade = |color: Rgb<_>| shaded.push(DISPLAY.rgb565(color));
    object.shade(&d, exposure, shade);
    let mut colors = vec![0; object.codes()];
    object.colors(&d, exposure, &DISPLAY, &mut colors).expect("a color for each code");
    assert_eq!(colors, shaded);
    colors
}
