//! Packed objects: their files, and hard cases of their pixels.

use eigenshade::object::{Object, Region};
use eigenshade::q15::MaterialBuffer;
use eigenshade::screen::{Display, Linear, LinearPalette, Nodes, Target, Tone};
use eigenshade::{Argument, Error, Gloss, Highlights, Material, Normal, Rgb, Source, sphere};
use eigenshade_table::material;
use eigenshade_table::object::{Pixel, encode};

static DISPLAY: Display = Display::new(Tone::Linear);

fn pixel(column: u16, row: u16, region: u16, record: [u8; 6]) -> Pixel {
    Pixel { column, row, region, record }
}

fn plastic() -> [u8; 6] {
    Region::new(0.0, 0.5).unwrap().bytes()
}

/// A file of two rows with a hole, and one row without an object.
fn file() -> Vec<u8> {
    let pixels = [(0, 0), (1, 0), (3, 0), (2, 2)]
        .map(|(column, row)| pixel(column, row, u16::from(column == 1), [0, 0, 255, 128, 0, 255]));
    encode([4, 3], &[plastic(), Region::new(1.0, 0.3).unwrap().bytes()], &pixels)
}

#[test]
fn cut_files_are_refused_and_bytes_after_them_ignored() {
    let mut bytes = file();
    for length in 0..bytes.len() {
        assert_eq!(Object::new(&bytes[..length]), Err(Error::Object), "{length}");
    }
    let object = Object::new(&bytes).unwrap();
    assert_eq!((object.width(), object.height(), object.regions().len()), (4, 3, 2));
    let places = object.pixels().map(|pixel| (pixel.column(), pixel.row(), pixel.region()));
    assert!(places.eq([(0, 0, 0), (1, 0, 1), (3, 0, 0), (2, 2, 0)]));
    let count = object.pixels().count();
    bytes.extend([0xff; 100]);
    assert_eq!(Object::new(&bytes).unwrap().pixels().count(), count);
}

/// Each byte of the header, of the regions, the rows and the heads of runs.
#[test]
fn wrong_structure_is_refused() {
    let bytes = file();
    let rows = 6 + 6 + 2 * 6;
    let records = rows + 4 * 4;
    let places = [
        (0, 1),            // magic
        (5, 2),            // version
        (6, 3),            // a run beyond the width
        (7, 0xff),         // the width of a file of one row
        (8, 9),            // rows that are not there
        (10, 1),           // a run of a region that does not exist
        (13, 0x80),        // metallic below 0
        (15, 0x80),        // roughness below 0
        (17, 0x80),        // matte share below 0
        (rows, 1),         // the first row does not begin at 0
        (rows + 4, 200),   // the rows are not in order
        (rows + 12, 0),    // fewer records than rows
        (rows + 15, 1),    // records that are not there
        (records, 9),      // a run that begins beyond the width
        (records + 2, 9),  // a run longer than its row
        (records + 2, 0),  // an empty run
        (records + 4, 2),  // a region that does not exist
        (records + 12, 0), // two runs at the same place
    ];
    for (place, byte) in places {
        let mut changed = bytes.clone();
        changed[place] = byte;
        // A larger width alone is an object with more background.
        let expected = if place == 7 { Ok(()) } else { Err(Error::Object) };
        assert_eq!(Object::new(&changed).map(drop), expected, "byte {place} = {byte}");
    }
    for size in [[0, 3], [4, 0]] {
        assert_eq!(Object::new(&encode(size, &[plastic()], &[])), Err(Error::Object));
    }
}

/// The normal is a node of the palette.
#[test]
fn an_object_of_one_pixel_has_the_color_of_its_normal() {
    for (metallic, base) in [(0.0, [255, 128, 0]), (1.0, [200, 150, 90])] {
        let region = Region::new(metallic, 0.4).unwrap();
        let [r, g, b] = base;
        let bytes = encode([1, 1], &[region.bytes()], &[pixel(0, 0, 0, [32, 40, r, g, b, 255])]);
        let object = Object::new(&bytes).unwrap();
        assert_eq!(object.regions().next(), Some(region));
        assert_eq!(object.nodes(0).count(), 4);
        let one = object.pixels().next().unwrap();
        let color = one.base_color().map(|channel| f32::from(channel) / 65_536.0);
        let light = eigenshade::presets::light::LOBBY;
        let exact = Material::metallic_roughness(color.into(), metallic, 0.4).unwrap();
        let exact = sphere::color::scene(light, exact.materials().unwrap()).unwrap();
        let exposure = exact.exposure_by_factor(0.8).unwrap();
        let parts = region
            .materials()
            .unwrap()
            .map(|part| sphere::color::scene(light, Material::new(&part).unwrap()).unwrap());
        let mut palette = LinearPalette::default();
        palette.fill(&Nodes::ALL, |normal| {
            parts.each_ref().map(|part| exposure.of(part.shade(normal)))
        });
        let mut screen = [[0_u8; 3]];
        let painted = object.painted(core::slice::from_ref(&palette), &DISPLAY).unwrap();
        painted.draw(&mut Target::new(&mut screen, 1).unwrap());
        let exact = <[u8; 3]>::from(DISPLAY.rgb888(exposure.of(exact.shade(one.normal()))));
        let apart = screen[0].iter().zip(exact).map(|(a, b)| a.abs_diff(b)).max().unwrap();
        assert!(apart <= 2, "{screen:?} {exact:?}");
    }
}

/// The parts of a region add up to the material and to its highlights, for any base color of plastic
/// and of metal; between them, for the base color of the matte share.
#[test]
fn parts_add_up_to_the_material() {
    let sources = [Source::new([0.6, 0.0, 0.8], [3.0, 2.0, 1.0], 0.05).unwrap()];
    let normals = [[0.2_f32, 0.1, 0.97], [0.9, 0.0, 0.4], [-0.5, 0.5, 0.7], [0.0, 0.0, 1.0]];
    for (metallic, base) in [(0.0_f32, 0.1), (0.0, 1.0), (1.0, 0.3), (1.0, 1.0), (0.5, 0.5)] {
        for roughness in [0.2, 0.55, 1.0] {
            let region = Region::new(metallic, roughness).unwrap();
            assert!((region.metallic() - metallic).abs() < 2e-5);
            let (metallic, roughness) = (region.metallic(), region.roughness());
            let [tinted, plain] = region.materials().unwrap();
            let whole = Material::metallic_roughness([base; 3], metallic, roughness).unwrap().r;
            let whole_q15 = sum_q15(region.materials_q15().unwrap(), base);
            let largest = whole.iter().fold(0.0_f32, |most, one| most.max(one.abs()));
            for (k, &expected) in whole.iter().enumerate() {
                let found = base * tinted[k] + plain[k];
                assert!((found - expected).abs() < 1e-4 * largest, "{metallic} {base} {roughness}");
                assert!((whole_q15[k] - expected).abs() < 1e-3 * largest, "{k}");
            }
            let gloss = Gloss::metallic_roughness([base; 3], metallic, roughness).unwrap();
            let expected = Highlights::<1>::new(&gloss, &sources).unwrap();
            let [tinted, plain] = region.highlights::<1>(&sources).unwrap();
            for [x, y, z] in normals {
                let normal = Normal::new(x, y, z).unwrap();
                let expected = expected.shade(normal);
                let found = tinted.shade(normal).map(|one| base * one) + plain.shade(normal);
                for (found, expected) in <[_; 3]>::from(found.zip(expected)) {
                    assert!((found - expected).abs() < 1e-4 * expected.max(1e-3), "{metallic}");
                }
            }
        }
    }
}

/// base x tinted + plain, of integers.
fn sum_q15(parts: [MaterialBuffer<40, 8>; 2], base: f32) -> Vec<f32> {
    let [tinted, plain] = parts.map(|part| {
        let part = part.material().unwrap();
        let number = |k: usize| {
            let order = (0..8).find(|&o| k < material::count(o)).unwrap();
            f32::from(part.mantissas()[k].0) * 2f32.powi(part.exponents()[order].into())
        };
        (0..40).map(number).collect::<Vec<_>>()
    });
    tinted.iter().zip(plain).map(|(tinted, plain)| base * tinted + plain).collect()
}

/// A highlight far beyond white on black saturates; what is not finite is dark.
#[test]
fn palettes_saturate() {
    let object = encode([1, 1], &[plastic()], &[pixel(0, 0, 0, [0, 0, 0, 255, 255, 255])]);
    let object = Object::new(&object).unwrap();
    let mut palette = LinearPalette::default();
    palette.fill(&Nodes::ALL, |_: Normal| {
        [Rgb::new(1e9, f32::NAN, -5.0), Rgb::new(0.0, 1e9, f32::NEG_INFINITY)]
    });
    let one = object.pixels().next().unwrap();
    let Rgb { r, g, b } = palette.color(one.code(), one.base_color());
    assert_eq!([r, b], [Linear(0); 2]);
    assert!(g >= Linear(15 << 16) && g <= Linear(32 << 16));
}

#[test]
fn too_few_palettes_are_refused() {
    let bytes = file();
    let object = Object::new(&bytes).unwrap();
    let palettes = [const { LinearPalette::BLACK }; 2];
    assert!(object.painted(&palettes, &DISPLAY).is_ok());
    let argument = Argument::Palettes;
    let expected = Error::Length { argument, expected: 2, found: 1 };
    assert_eq!(object.painted(&palettes[..1], &DISPLAY).map(drop), Err(expected));
    let outside = |argument| Err(Error::Outside { argument });
    assert_eq!(Region::new(1.1, 0.5), outside(Argument::Metallic));
    assert_eq!(Region::new(0.5, f32::NAN), outside(Argument::Roughness));
    assert_eq!(Region::new(0.5, 0.5).unwrap().with_matte(-0.1), outside(Argument::Color));
}
