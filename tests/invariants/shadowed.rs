//! Objects with shadows of any numbers, in targets of any shape.

use super::Reader;
use eigenshade::object::{ObjectCoefficients, ShadowedObject, TexturedObject};
use eigenshade::screen::{Display, Exposure, Target, Tone, blend565};
use eigenshade::{Light, Q15, Rgb, q15};
use eigenshade_table::light;
use eigenshade_table::shadowed::{Cluster, File, Pixel, Row, Tint};

static DISPLAY: Display = Display::new(Tone::Filmic);

/// An object has the size that was written, a color for each code, and is drawn as pixel by pixel; with
/// changed bytes, it is refused or drawn.
pub fn drawn(input: &mut Reader<'_>) {
    let has_base_colors = input.byte() & 1 == 1;
    let mut file = file(input);
    if has_base_colors {
        let tint =
            |_: &Pixel| Tint { code: u16::from(input.byte()) % 9, base_color: input.bytes() };
        file.tints = file.pixels.iter().map(tint).collect();
        if !file.tints.is_empty() {
            return textured(&file, input);
        }
    }
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

    change(&mut bytes, input);
    if let Ok(object) = ShadowedObject::new(&bytes) {
        let colors = self::colors(&object, input);
        object.draw(&colors, &mut Target::new(&mut [0_u16; 30], 6).expect("rows"));
    }
}

/// The same with base colors: each pixel is base color x T + P, encoded.
fn textured(file: &File, input: &mut Reader<'_>) {
    let mut bytes = file.encode();
    let object = TexturedObject::new(&bytes).expect("a written object");
    assert_eq!([object.width(), object.height()], file.size.map(usize::from));
    assert_eq!(ShadowedObject::new(&bytes), Err(eigenshade::Error::Object));
    let of_codes = textured_colors(&object, input);
    let [across, down] = [(); 2].map(|()| 1 + input.up_to(12));
    let at = [(); 2].map(|()| i32::from(input.byte() % 24) - 12);
    let mut both = [(); 2].map(|()| vec![[0x12_u8, 0x34, 0x56]; across * down]);
    let [whole, single] = &mut both;
    object.draw(
        &of_codes,
        &DISPLAY,
        &mut Target::new(whole, across).expect("a row").at(at[0], at[1]),
    );
    let mut target = Target::new(single, across).expect("a row");
    let mut target = target.at(at[0], at[1]);
    for (pixel, tint) in file.pixels.iter().zip(&file.tints) {
        let below = target.pixel(pixel.column.into(), pixel.row.into());
        let [t, p] = [pixel.code, tint.code].map(|code| of_codes.get(usize::from(code)));
        let (Some(below), Some(t), Some(p)) = (below, t, p) else { continue };
        let channel = |channel: usize| {
            let level = f64::from(tint.base_color[channel]) / 255.0;
            let base =
                if level <= 0.04045 { level / 12.92 } else { ((level + 0.055) / 1.055).powf(2.4) };
            let base = (65_536.0 * base).round().min(65_535.0) as u64;
            let sum = ((base * u64::from(t[channel])) >> 12) + (u64::from(p[channel]) << 4);
            eigenshade::screen::Linear(sum as u32)
        };
        let color = DISPLAY.rgb888(Rgb::from([0, 1, 2].map(channel)));
        *below = color.over((*below).into(), pixel.coverage).into();
    }
    // The table of base colors may be rounded otherwise.
    for (a, b) in whole.as_flattened().iter().zip(single.as_flattened()) {
        assert!(a.abs_diff(*b) <= 1, "{a} {b}");
    }
    change(&mut bytes, input);
    if let Ok(object) = TexturedObject::new(&bytes) {
        let colors = textured_colors(&object, input);
        object.draw(&colors, &DISPLAY, &mut Target::new(&mut [0_u16; 30], 6).expect("rows"));
    }
}

/// Changes some bytes, and cuts some off.
fn change(bytes: &mut Vec<u8>, input: &mut Reader<'_>) {
    for _ in 0..1 + input.up_to(3) {
        let place = usize::from(u16::from_le_bytes(input.bytes())) % bytes.len();
        bytes[place] = input.byte();
    }
    bytes.truncate(bytes.len() - input.up_to(2) * input.up_to(40).min(bytes.len() / 2));
}

fn textured_colors(object: &TexturedObject<'_>, input: &mut Reader<'_>) -> Vec<[u16; 3]> {
    let light = |light: Rgb<Light<'_>>| object.coefficients(light);
    let integers = |light: Rgb<q15::Light<'_>>| object.coefficients_q15(light);
    let d = coefficients(object.degree(), light, integers, input);
    let exposure = Exposure::new(input.float(false)).unwrap_or_default();
    let mut colors = vec![[0; 3]; object.codes()];
    object.colors(&d, exposure, &mut colors).expect("a color for each code");
    colors
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
        tints: vec![],
    }
}

/// The colors of an object in a light of any numbers.
fn colors(object: &ShadowedObject<'_>, input: &mut Reader<'_>) -> Vec<u16> {
    let light = |light: Rgb<Light<'_>>| object.coefficients(light);
    let integers = |light: Rgb<q15::Light<'_>>| object.coefficients_q15(light);
    let d = coefficients(object.degree(), light, integers, input);
    let exposure = Exposure::new(input.float(false)).unwrap_or_default();
    let mut shaded = Vec::new();
    let shade = |color: Rgb<_>| shaded.push(DISPLAY.rgb565(color));
    object.shade(&d, exposure, shade);
    let mut colors = vec![0; object.codes()];
    object.colors(&d, exposure, &DISPLAY, &mut colors).expect("a color for each code");
    assert_eq!(colors, shaded);
    colors
}

/// The coefficients of a light of any numbers, in floats or in integers.
fn coefficients(
    most: usize,
    floats: impl Fn(Rgb<Light<'_>>) -> Result<Rgb<ObjectCoefficients>, eigenshade::Error>,
    integers: impl Fn(Rgb<q15::Light<'_>>) -> Result<Rgb<ObjectCoefficients>, eigenshade::Error>,
    input: &mut Reader<'_>,
) -> Rgb<ObjectCoefficients> {
    let count = light::count(input.up_to(most));
    let d = if input.byte() & 1 == 0 {
        let channels = [(); 3].map(|()| input.floats(count, false));
        let light = channels.each_ref().map(|one| Light::from_finite(one).expect("a light"));
        floats(light.into())
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
        integers(light.into())
    };
    d.expect("a light of its degree")
}
