//! Hard cases of palettes: few normals, edges of cells, small rims, other formats and exposures, and
//! light beyond white.

use eigenshade::object::{Disc, NormalCode, NormalMap};
use eigenshade::presets::{light, material};
use eigenshade::screen::{
    Display, Linear, LinearPalette, Nodes, Palette, Pixel, Target, Tone, blend565,
};
use eigenshade::sphere::{self, color};
use eigenshade::{Normal, Rgb, q15};
use eigenshade_testing::fixtures::normal;

static DISPLAY: Display = Display::new(Tone::Filmic);

fn levels(pixel: u16) -> [i32; 3] {
    [pixel >> 11, pixel >> 5 & 63, pixel & 31].map(i32::from)
}

/// The most levels by which the channels of two pixels differ.
fn apart(a: u16, b: u16) -> i32 {
    let pairs = levels(a).into_iter().zip(levels(b));
    pairs.map(|(a, b)| (a - b).abs()).max().unwrap_or_default()
}

/// The sizes that the documentation states: 8.7 and 13 KB.
#[test]
fn palettes_have_their_stated_sizes() {
    assert_eq!([size_of::<Palette>(), size_of::<LinearPalette>()], [8_712, 13_068]);
}

/// A flat object is as the display has its one normal, also where the normal is a node or lies on the
/// edge of a cell, and needs no other nodes than those around it.
#[test]
fn a_flat_object_has_the_color_of_its_normal() {
    let scene = color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let exposure = scene.exposure_by_factor(1.5).unwrap();
    for [u, v] in [[0_i8, 0], [8, 0], [-64, 24], [3, -8], [125, 0], [-127, 0], [0, 127], [80, -80]]
    {
        let code = [u.cast_unsigned(), v.cast_unsigned()];
        let codes = [code; 12];
        let map = NormalMap::new(4, 3, codes.as_flattened()).unwrap();
        assert_eq!(map.pixels().count(), 12, "{u} {v}");
        assert_eq!(map.nodes().count(), 4);
        let mut palette = Palette::default();
        palette.fill(&map.nodes(), &DISPLAY, |normal| exposure.of(scene.shade(normal)));
        let mut picture = [0_u16; 12];
        palette.draw(&map, &mut Target::new(&mut picture, 4).unwrap());
        let pixel = map.pixels().next().unwrap();
        let exact = DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal())));
        assert!(picture.iter().all(|&one| one == picture[0] && apart(one, exact) <= 1), "{u} {v}");
    }
}

/// Spheres of few pixels have them all, in all encodings, and never more than one level off.
#[test]
fn small_spheres_have_their_rims() {
    let scene = color::scene(light::PARK, material::PTFE_633NM).unwrap();
    let exposure = scene.exposure_by_factor(1.0).unwrap();
    let mut palette = Palette::default();
    palette.fill_mirrored(&Nodes::ALL, &DISPLAY, |normal| {
        scene.shade_mirrored(normal).map(|color| exposure.of(color))
    });
    for size in 1..20 {
        let mut codes = vec![NormalMap::BACKGROUND; size * size];
        NormalMap::sphere(size, &mut codes).unwrap();
        let map = NormalMap::new(size, size, codes.as_flattened()).unwrap();
        let below = 0x001f;
        let mut drawn = vec![below; size * size];
        palette.draw(&map, &mut Target::new(&mut drawn, size).unwrap());
        let mut swapped = vec![below.to_be_bytes(); size * size];
        palette.draw(&map, &mut Target::new(&mut swapped, size).unwrap());
        for pixel in map.pixels() {
            let exact = DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal())));
            let exact = blend565(below, exact, pixel.coverage());
            let found = drawn[pixel.index()];
            assert!(apart(found, exact) <= 1, "{size}: {found:x} {exact:x}");
        }
        assert!(drawn.iter().zip(swapped).all(|(one, bytes)| one.to_be_bytes() == bytes));
        let mut fine = vec![[0, 0, u8::MAX]; size * size];
        palette.draw(&map, &mut Target::new(&mut fine, size).unwrap());
        for pixel in map.pixels() {
            let color = palette.rgb888(pixel.code());
            let expected = color.over(Rgb::new(0, 0, u8::MAX), pixel.coverage());
            assert_eq!(fine[pixel.index()], <[u8; 3]>::from(expected));
        }
        if size < 8 {
            continue;
        }
        // Whole pixels of the same disc without codes, whose normals are within half a degree.
        let whole = Disc::new(size).unwrap().filter(|pixel| pixel.coverage() == 255);
        let far = whole.filter(|pixel| {
            let exact = DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal())));
            apart(drawn[pixel.index()], exact) > 1
        });
        assert_eq!(far.count(), 0, "{size}");
    }
}

/// A palette holds displayed colors alone: filled in integers or in floats, from another table, light
/// or exposure, it has the colors of its last fill.
#[test]
fn palettes_are_of_their_last_fill() {
    let floats = color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let integers = sphere::q15::color::scene(light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT);
    let integers = integers.unwrap();
    let (of_floats, of_integers) =
        (floats.exposure_by_factor(1.5).unwrap(), integers.exposure_by_factor(1.5).unwrap());
    let mut palette = Palette::default();
    palette.fill(&Nodes::ALL, &DISPLAY, |_: Normal| Rgb::gray(9.0));
    palette.fill(&Nodes::ALL, &DISPLAY, |normal| of_integers.of(integers.shade(normal)));
    let mut exact = Palette::default();
    exact.fill(&Nodes::ALL, &DISPLAY, |normal| of_floats.of(floats.shade(normal)));
    let mut mirrored = Palette::default();
    mirrored.fill_mirrored(&Nodes::ALL, &DISPLAY, |normal| {
        integers.shade_mirrored(normal).map(|color| of_integers.of(color))
    });
    let mut linear = LinearPalette::default();
    linear.fill(&Nodes::ALL, |normal| [of_floats.of(floats.shade(normal)); 2]);
    let mut of_mirrors = LinearPalette::default();
    of_mirrors.fill_mirrored(&Nodes::ALL, |normal| {
        [floats.shade_mirrored(normal).map(|color| of_floats.of(color)); 2]
    });
    // Half of the tinted part and all of the plain one, which are the same.
    let base = Rgb::gray(1 << 15);
    let mut sums = [0.0; 2];
    for pixel in Disc::new(50).unwrap() {
        let code = pixel.code();
        let [a, b, c] = [&palette, &exact, &mirrored].map(|one| one.rgb888(code));
        for (a, (b, c)) in <[_; 3]>::from(a.zip(b.zip(c))) {
            assert!(a.abs_diff(b) <= 2 && a.abs_diff(c) <= 1, "{a} {b} {c}");
        }
        // In linear light, too, where mirror images differ by a step of 2^-12 of white.
        let exact = of_floats.of(floats.shade(pixel.normal()));
        let found = linear.color(code, base);
        let pairs = found.zip(of_mirrors.color(code, base)).zip(exact.map(|one| 1.5 * one));
        for ((Linear(found), Linear(mirrored)), exact) in <[_; 3]>::from(pairs) {
            assert!(found.abs_diff(mirrored) <= 16);
            sums[0] += (found as f32 / 65_536.0 - exact.max(0.0)).abs();
            sums[1] += exact;
        }
    }
    // A highlight between nodes.
    assert!(sums[0] < 0.015 * sums[1], "{sums:?}");
}

/// A scene in integers whose light is far beyond white is white, not wrapped, and black where
/// irradiance is below zero.
#[test]
fn a_sun_saturates() {
    let scene = sphere::q15::color::scene(light::q15::SKY, material::q15::CHROME).unwrap();
    for factor in [1.0, 1e3, 1e9] {
        let exposure = scene.exposure_by_factor(factor).unwrap();
        let mut palette = Palette::default();
        palette.fill_mirrored(&Nodes::ALL, &DISPLAY, |normal| {
            scene.shade_mirrored(normal).map(|color| exposure.of(color))
        });
        // Nodes themselves have no neighbors in their colors.
        let mut seen = [false; 2];
        for code in
            (-120..=120).step_by(8).flat_map(|u| (-120..=120).step_by(8).map(move |v| (u, v)))
        {
            let (u, v): (i8, i8) = code;
            let bytes = [u.cast_unsigned(), v.cast_unsigned()];
            let Ok(map) = NormalMap::new(1, 1, &bytes) else { continue };
            let Some(pixel) = map.pixels().next() else { continue };
            let color = exposure.of(scene.shade(pixel.normal_q15()));
            let found = palette.rgb565(pixel.code());
            assert!(apart(found, DISPLAY.rgb565(color)) <= 1, "{factor}: {code:?}");
            seen[0] |= found == 0xffff;
            seen[1] |= found == 0;
        }
        assert!(factor < 1e9 || seen == [true; 2]);
    }
}

/// Pixels keep to their target, whose buffer may be too small for the object.
#[test]
fn a_small_buffer_is_not_left() {
    let mut palette = Palette::default();
    palette.fill(&Nodes::ALL, &DISPLAY, |_: q15::Normal| Rgb::gray(Linear(60_000)));
    let mut codes = [NormalMap::BACKGROUND; 30 * 30];
    NormalMap::sphere(30, &mut codes).unwrap();
    let map = NormalMap::new(30, 30, codes.as_flattened()).unwrap();
    fn drawn<P: Pixel + Default + PartialEq>(palette: &Palette, map: &NormalMap<'_>) -> usize {
        let mut buffer = [P::default(); 20 * 10 + 7];
        palette.draw(map, &mut Target::new(&mut buffer, 20).unwrap());
        buffer.iter().filter(|&&one| one != P::default()).count()
    }
    let inside = map.pixels().filter(|one| one.column() < 20 && one.row() < 10).count();
    let all = [
        drawn::<u16>(&palette, &map),
        drawn::<[u8; 2]>(&palette, &map),
        drawn::<[u8; 3]>(&palette, &map),
    ];
    // A rim of 1/32 of a dark gray may be black.
    assert!(all.iter().all(|&count| count <= inside && count + 4 > inside), "{all:?} {inside}");
    // Codes beyond the rim and of missing neighbors draw nothing.
    let wrong = [[127, 127], NormalMap::edge_code(128, [1, 0]), [0x80, 0x80]];
    let map = NormalMap::new(3, 1, wrong.as_flattened()).unwrap();
    assert_eq!(drawn::<u16>(&palette, &map), 0);
}

/// The levels of a matte sphere rise toward the light and leave none out but where the sRGB curve is
/// steep: the steps between codes are not wider than those of RGB565.
#[test]
fn a_matte_sphere_has_no_bands() {
    let mut palette = Palette::default();
    palette
        .fill(&Nodes::ALL, &DISPLAY, |normal: Normal| Rgb::gray(normal.components()[0].max(0.0)));
    for y in [0.0, 0.2, 0.5_f64] {
        let row = (0..400).map(|k| {
            let x = (1.0 - y * y).sqrt() * f64::from(k) / 400.0;
            let z = (1.0 - x * x - y * y).max(0.0).sqrt();
            levels(palette.rgb565(NormalCode::of(normal([x, y, z]))))
        });
        let all: Vec<[i32; 3]> = row.collect();
        let mut bright = 0;
        for pair in all.windows(2) {
            let [r, g, b] = [0, 1, 2].map(|channel| pair[1][channel] - pair[0][channel]);
            assert!(r >= 0 && g >= 0 && b >= 0, "{y}: {pair:?}");
            if pair[0][1] > 25 {
                bright += 1;
                assert!(r <= 1 && g <= 2 && b <= 1, "{y}: {pair:?}");
            }
        }
        assert!(bright > 250, "{bright}");
    }
}
