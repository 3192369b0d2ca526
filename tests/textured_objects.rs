//! Objects with shadows whose pixels have base colors: against sums in `f64`, rims and missing colors.

use super::shadowed_objects::{DISPLAY, Numbers, irradiances, small, whole};
use eigenshade::object::TexturedObject;
use eigenshade::screen::{Exposure, Target, blend565};
use eigenshade::{Argument, Error, Light, Q15, Rgb, q15};
use eigenshade_table::shadowed::{File, Pixel, Tint};

/// A small object with base colors, one of them black.
pub fn small_textured() -> File {
    let base_colors = [[200, 90, 10], [0; 3], [255; 3], [1, 128, 254]];
    let tint = |(code, base_color)| Tint { code, base_color };
    File { tints: [2, 1, 0, 2].into_iter().zip(base_colors).map(tint).collect(), ..small() }
}

/// A level of sRGB in linear light, by the standard.
fn decoded(level: u8) -> f64 {
    let share = f64::from(level) / 255.0;
    if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
}

/// Base color x T + P from the numbers of a file, in floats and in integers: within 2 levels of 255.
#[test]
fn pixels_with_base_colors_are_those_of_direct_sums() {
    let mut numbers = Numbers(9);
    let places = (0..5).flat_map(|row| (0..7).map(move |column| (column, row)));
    let pixels: Vec<Pixel> =
        places.map(|(column, row)| whole(column, row, numbers.next() as u16 % 40)).collect();
    let mut file = numbers.file([4, 3, 20, 4], &[(30, 0), (10, -1)], pixels);
    file.tints = (0..35)
        .map(|k| Tint {
            code: numbers.next() as u16 % 40,
            base_color: if k == 3 { [0; 3] } else { [(); 3].map(|()| numbers.next() as u8) },
        })
        .collect();
    let bytes = file.encode();
    let object = TexturedObject::new(&bytes).unwrap();
    assert_eq!([object.width(), object.height(), object.codes(), object.degree()], [7, 5, 40, 4]);
    let lights = [(); 3].map(|()| numbers.light(4));
    let exact = [0, 1, 2].map(|channel| irradiances(&file, &lights[channel], channel));
    let peak = exact.iter().flatten().fold(0.0_f64, |most, one| most.max(one.abs()));
    let exposure = Exposure::new((0.5 / peak) as f32).unwrap();
    let mut mantissas = lights.each_ref().map(|light| vec![Q15(0); light.len()]);
    let mut in_q15 = mantissas.iter_mut().zip(&lights);
    let integers = [(); 3].map(|()| {
        let (to, light) = in_q15.next().unwrap();
        q15::Light::quantize(light, to).unwrap()
    });
    let floats = lights.each_ref().map(|light| Light::new(light).unwrap());
    for d in [object.coefficients(floats.into()), object.coefficients_q15(integers.into())] {
        let mut colors = vec![[0; 3]; 40];
        object.colors(&d.unwrap(), exposure, &mut colors).unwrap();
        let mut screen = [[0_u8; 3]; 35];
        object.draw(&colors, &DISPLAY, &mut Target::new(&mut screen, 7).unwrap());
        for ((found, pixel), tint) in screen.iter().zip(&file.pixels).zip(&file.tints) {
            for (channel, exact) in exact.iter().enumerate() {
                let part = |code: u16| (0.5 / peak * exact[usize::from(code)]).max(0.0);
                let sum = decoded(tint.base_color[channel]) * part(pixel.code) + part(tint.code);
                let expected = DISPLAY.rgb888(Rgb::gray(sum as f32)).r;
                assert!(found[channel].abs_diff(expected) <= 2, "{found:?} {expected}");
            }
        }
    }
    // In the dark all is black, over whatever was there.
    let dark = Light::new(&[0.0]).unwrap();
    let mut colors = vec![[9; 3]; 40];
    object.colors(&object.coefficients(Rgb::gray(dark)).unwrap(), exposure, &mut colors).unwrap();
    let mut screen = [[7_u8; 3]; 35];
    object.draw(&colors, &DISPLAY, &mut Target::new(&mut screen, 7).unwrap());
    assert_eq!(screen, [[0; 3]; 35]);
    // Any colors, also the largest.
    object.draw(&[[u16::MAX; 3]; 40], &DISPLAY, &mut Target::new(&mut screen, 7).unwrap());
    assert_eq!(screen[4], [255; 3]);
}

#[test]
fn rims_and_missing_colors_of_pixels_with_base_colors() {
    let bytes = small_textured().encode();
    let object = TexturedObject::new(&bytes).unwrap();
    let d = object.coefficients(Rgb::gray(Light::new(&[1.0]).unwrap())).unwrap();
    let refused = Error::Length { argument: Argument::Colors, expected: 3, found: 2 };
    assert_eq!(object.colors(&d, Exposure::default(), &mut [[0; 3]; 2]), Err(refused));
    let white = [[1 << 12; 3]; 3];
    let mut screen = [0_u16; 8];
    object.draw(&white, &DISPLAY, &mut Target::new(&mut screen, 4).unwrap());
    let rim = blend565(0, 0xffff, 90);
    assert_eq!(screen, [0xffff, 0xffff, 0, rim, 0, 0, 0xffff, 0]);
    // The code of T or of P is missing, except in the second pixel.
    let mut screen = [1_u16; 8];
    object.draw(&white[..2], &DISPLAY, &mut Target::new(&mut screen, 4).unwrap());
    assert_eq!(screen, [1, 0xffff, 1, 1, 1, 1, 1, 1]);
    // A black base color has P alone.
    let colors = [[0; 3], [1 << 12, 0, 0], [0; 3]];
    let mut screen = [0_u16; 8];
    object.draw(&colors, &DISPLAY, &mut Target::new(&mut screen, 4).unwrap());
    assert_eq!(screen[1], 0xf800);
    // A target that begins within a run.
    for left in 0..6 {
        let mut part = [0_u16; 2];
        object.draw(&white, &DISPLAY, &mut Target::new(&mut part, 2).unwrap().at(-left, 0));
        let mut expected = [0xffff, 0xffff, 0, rim, 0, 0, 0, 0].into_iter().skip(left as usize);
        assert_eq!(part, [(); 2].map(|()| expected.next().unwrap_or(0)), "{left}");
    }
}
