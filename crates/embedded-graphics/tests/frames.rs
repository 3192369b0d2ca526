//! Frames of layers: over each other, on any part of a display, and what of them is sent.
#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

mod screen;

use eigenshade::object::{NormalMap, ShadowedObject};
use eigenshade::presets::{light, material};
use eigenshade::screen::{Display, Exposure, Nodes, Palette, Sent, Target, Tone};
use eigenshade::{Light, Normal, Rgb, sphere};
use eigenshade_embedded_graphics::{Frame, Layer};
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Bgr888, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use screen::Screen;

static DISPLAY: Display = Display::new(Tone::Filmic);

/// Objects over each other are those of the runtime, drawn one after the other, on any part of a
/// display; outlines are mixed with the object below, and only what changed is sent.
#[test]
fn a_frame_has_its_layers_over_each_other() {
    let scene = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let exposure = scene.exposure_by_factor(1.5).unwrap();
    let (mut gold, mut gray) = (Palette::default(), Palette::default());
    gold.fill(&Nodes::ALL, &DISPLAY, |normal| exposure.of(scene.shade(normal)));
    gray.fill(&Nodes::ALL, &DISPLAY, |normal: Normal| Rgb::gray(normal.components()[2]));
    let mut codes = [NormalMap::BACKGROUND; 90 * 90];
    NormalMap::sphere(90, &mut codes).unwrap();
    let map = NormalMap::new(90, 90, codes.as_flattened()).unwrap();
    let mut small = [NormalMap::BACKGROUND; 30 * 30];
    NormalMap::sphere(30, &mut small).unwrap();
    let small = NormalMap::new(30, 30, small.as_flattened()).unwrap();
    for at in [Point::zero(), Point::new(-20, 35), Point::new(60, -80)] {
        let (second, third) = (at + Point::new(45, 10), at + Point::new(70, 60));
        let layers = [
            Layer::new(at, map, &gray),
            Layer::new(second, small, &gold),
            Layer::new(third, small, gold.dithered()),
        ];
        let of_24_bits = [Layer::new(at, map, &gray), Layer::new(second, small, &gold)];
        let around = Rectangle::new(at, Size::new(100, 90));
        let frame = Frame::new(around, &layers, Rgb565::BLUE);
        assert_eq!(frame.bounding_box(), around);
        let mut expected = vec![0x001f_u16; 110 * 80];
        let mut target = Target::new(&mut expected, 110).unwrap();
        gray.draw(&map, &mut target.at(at.x, at.y));
        gold.draw(&small, &mut target.at(second.x, second.y));
        gold.dithered().draw(&small, &mut target.at(third.x, third.y));
        let mut screen = Screen::<Rgb565>::new(110, 80);
        frame.draw(&mut screen).unwrap();
        let drawn = around.intersection(&screen.bounding_box());
        for place in screen.bounding_box().points() {
            let index = (place.y * 110 + place.x) as usize;
            let color = drawn.contains(place).then(|| RawU16::new(expected[index]).into());
            assert_eq!(screen.pixels[index], color, "{place}");
        }

        // The same in the order of the channels and of the bytes, with 24 bits.
        let mut reversed = Screen::<Bgr888>::new(110, 80);
        Frame::new(around, &of_24_bits, Bgr888::BLUE).draw(&mut reversed).unwrap();
        let mut fine = vec![[0, 0, 255_u8]; 110 * 80];
        let mut target = Target::new(&mut fine, 110).unwrap();
        gray.draw(&map, &mut target.at(at.x, at.y));
        gold.draw(&small, &mut target.at(second.x, second.y));
        for (found, [r, g, b]) in reversed.pixels.iter().zip(fine) {
            assert!(found.is_none_or(|found| found == Bgr888::new(r, g, b)));
        }
    }
}

/// An object with shadows is that of the runtime, in 16 and in 24 bits: a pixel, and a pixel of the rim
/// that covers half of what is below.
#[test]
fn an_object_with_shadows_is_drawn_from_the_colors_of_its_codes() {
    let file: [&[u8]; 7] = [
        b"eigsh\x02\x03\0\x01\0\x02\0\x02\0", // 3 x 1 pixels, 2 codes in 2 clusters
        &[0, 1, 1, 0],                        // degree 0, one part, rank 1, no images
        &[0xff, 0x7f, 0, 0x40, 0, 0],         // orange
        &[0xf8, 0, 0x40],                     // a row without a shift: 2^6 x 2^-8
        &[1, 0, 0xf2, 0, 0x40],               // a cluster of one code: 2^14 x 2^-14
        &[1, 0, 0xf1, 0, 0x40],               // another: 2^14 x 2^-15
        &[0, 0, 0, 0, 7, 0, 0, 0, 1, 0, 1, 0, 0, 0, 2, 0, 1, 0x80, 1, 0, 128, 0],
    ];
    let file = file.concat();
    let object = ShadowedObject::new(&file).unwrap();
    let light = Light::new(&[3.0]).unwrap();
    let d = object.coefficients(Rgb::gray(light)).unwrap();
    let (mut words, mut fine) = ([0_u16; 2], [[0_u8; 3]; 2]);
    object.colors(&d, Exposure::default(), &DISPLAY, &mut words).unwrap();
    object.colors(&d, Exposure::default(), &DISPLAY, &mut fine).unwrap();
    let [[r, g, b], dim] = fine;
    assert!(r > g && g > dim[1] && dim[1] > 100 && b == 0);

    let (at, area) = (Point::new(4, 2), Rectangle::new(Point::zero(), Size::new(8, 4)));
    let mut expected = [0x001f_u16; 32];
    object.draw(&words, &mut Target::new(&mut expected, 8).unwrap().at(at.x, at.y));
    let mut screen = Screen::<Rgb565>::new(8, 4);
    let layers = [Layer::shadowed(at, &object, &words)];
    Frame::new(area, &layers, Rgb565::BLUE).draw(&mut screen).unwrap();
    assert!(screen.pixels.iter().eq(&expected.map(|word| Some(RawU16::new(word).into()))));

    let mut expected = [[0, 0, 255_u8]; 32];
    object.draw(&fine, &mut Target::new(&mut expected, 8).unwrap().at(at.x, at.y));
    assert_eq!([expected[20], expected[21]], [[0, 0, 255], fine[0]]);
    assert!(expected[22][0].abs_diff(dim[0] / 2) <= 1 && expected[22][2].abs_diff(127) <= 1);
    let mut screen = Screen::<Bgr888>::new(8, 4);
    let layers = [Layer::shadowed(at, &object, &fine)];
    Frame::new(area, &layers, Bgr888::BLUE).draw(&mut screen).unwrap();
    assert!(screen.pixels.iter().eq(&expected.map(|[r, g, b]| Some(Bgr888::new(r, g, b)))));
}

/// Only runs that changed are sent, whatever changed: a color, the place of an object, or the part of
/// the area that is seen; and what the display refused is sent again.
#[test]
fn what_changed_is_sent() {
    let gray = |scale: f32| {
        let mut palette = Palette::default();
        palette.fill(&Nodes::ALL, &DISPLAY, |normal: Normal| {
            Rgb::gray(scale * normal.components()[1].max(0.0))
        });
        palette
    };
    let (dark, bright) = (gray(0.2), gray(0.9));
    let mut codes = [NormalMap::BACKGROUND; 30 * 30];
    NormalMap::sphere(30, &mut codes).unwrap();
    let map = NormalMap::new(30, 30, codes.as_flattened()).unwrap();
    // Two runs a row, of an area that begins inside the display.
    let area = Rectangle::new(Point::new(3, 2), Size::new(280, 70));
    let mut shown = vec![None; 300 * 80];
    let mut sent = Sent::<{ 70 * 3 }>::default();
    let steps = [
        (Point::new(5, 5), &dark, None, 280 * 70),
        (Point::new(5, 5), &dark, None, 0),
        // The upper half of the sphere.
        (Point::new(5, 5), &bright, None, 15 * 256),
        (Point::new(40, 5), &bright, None, 30 * 256),
        (Point::new(120, 30), &bright, None, 55 * 256),
        (
            Point::new(120, 30),
            &bright,
            Some(Rectangle::new(Point::zero(), Size::new(90, 80))),
            70 * 87,
        ),
        (Point::new(i32::MIN, i32::MAX), &bright, None, 70 * 256),
    ];
    for (place, palette, part, most) in steps {
        let layers = [Layer::new(place, map, palette)];
        let frame = Frame::new(area, &layers, Rgb565::BLUE);
        let (mut screen, mut whole) =
            (Screen::<Rgb565>::new(300, 80), Screen::<Rgb565>::new(300, 80));
        let part = part.unwrap_or(screen.bounding_box());
        let count = frame.draw_changed(&mut screen.clipped(&part), &mut sent).unwrap();
        assert!(count == screen.drawn() && count <= most, "{place}: {count}");
        frame.draw(&mut whole.clipped(&part)).unwrap();
        shown.iter_mut().zip(&screen.pixels).for_each(|(old, new)| *old = new.or(*old));
        let seen = whole.pixels.iter().zip(&shown).filter(|(whole, _)| whole.is_some());
        assert!(seen.clone().count() > 0 && seen.clone().all(|(whole, shown)| whole == shown));
    }

    let mut sent = Sent::<30>::default();
    let layers = [Layer::new(Point::zero(), map, &bright)];
    let area = map_area(30);
    let frame = Frame::new(area, &layers, Rgb565::BLUE);
    for refused in [0, 7, 29] {
        let mut bus = Bus { refused };
        assert_eq!(frame.draw_changed(&mut bus, &mut sent), Err(refused));
    }
    let mut bus = Bus { refused: 99 };
    // All but those before the last refusal.
    assert_eq!(frame.draw_changed(&mut bus, &mut sent), Ok(30));
    assert_eq!(frame.draw_changed(&mut bus, &mut sent), Ok(0));
}

fn map_area(side: u32) -> Rectangle {
    Rectangle::new(Point::zero(), Size::new_equal(side))
}

/// A display that refuses a row.
struct Bus {
    refused: i32,
}

impl OriginDimensions for Bus {
    fn size(&self) -> Size {
        Size::new(30, 30)
    }
}

impl DrawTarget for Bus {
    type Color = Rgb565;
    type Error = i32;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, _: I) -> Result<(), i32> {
        unreachable!("pixel by pixel")
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        _: I,
    ) -> Result<(), i32> {
        if area.top_left.y == self.refused { Err(self.refused) } else { Ok(()) }
    }
}
