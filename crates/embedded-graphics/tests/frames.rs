//! Frames of layers: over each other, on any part of a display, and what of them is sent.
#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

mod screen;

use eigenshade::object::NormalMap;
use eigenshade::presets::{light, material};
use eigenshade::screen::{Display, Nodes, Palette, Sent, Target, Tone};
use eigenshade::{Normal, Rgb, sphere};
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
        Frame::new(around, &layers[..2], Bgr888::BLUE).draw(&mut reversed).unwrap();
        let mut fine = vec![[0, 0, 255_u8]; 110 * 80];
        let mut target = Target::new(&mut fine, 110).unwrap();
        gray.draw(&map, &mut target.at(at.x, at.y));
        gold.draw(&small, &mut target.at(second.x, second.y));
        for (found, [r, g, b]) in reversed.pixels.iter().zip(fine) {
            assert!(found.is_none_or(|found| found == Bgr888::new(r, g, b)));
        }
    }
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
