//! Objects on displays: pixels, rows, parts, outlines, and the geometry of a dial.
#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

use eigenshade::object::{Disc, DiscPixel, NormalMap};
use eigenshade::presets::{light, material};
use eigenshade::screen::{Display, Exposure, Nodes, Palette, Tone, blend565};
use eigenshade::{Error, Normal, Rgb, sphere};
use eigenshade_embedded_graphics::{Dial, Paint, Relief, Sphere};
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Bgr565, Bgr888, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use std::cell::{Cell, RefCell};

mod screen;

use screen::Screen;

static DISPLAY: Display = Display::new(Tone::Filmic);

/// The pixels that a circle covers by half or more.
fn disc(diameter: usize) -> impl Iterator<Item = DiscPixel> {
    Disc::new(diameter).unwrap().filter(|pixel| pixel.coverage() >= 128)
}

#[test]
fn a_sphere_has_the_pixels_of_the_runtime() {
    let scene = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let exposure = scene.exposure_by_factor(1.5).unwrap();
    let gold = Paint::new(|normal| scene.shade(normal), exposure, &DISPLAY);
    let (mut screen, mut fine) = (Screen::<Rgb565>::new(60, 50), Screen::<Rgb888>::new(60, 50));
    let mut dithered = Screen::<Rgb565>::new(60, 50);
    Sphere::new(Point::new(7, 3), 40, &gold).unwrap().draw(&mut screen).unwrap();
    Sphere::new(Point::new(7, 3), 40, &gold).unwrap().draw(&mut fine).unwrap();
    Sphere::new(Point::new(7, 3), 40, &gold.dithered()).unwrap().draw(&mut dithered).unwrap();
    let mut reversed = Screen::<Bgr565>::new(60, 50);
    let mut fine_reversed = Screen::<Bgr888>::new(60, 50);
    Sphere::new(Point::new(7, 3), 40, &gold).unwrap().draw(&mut reversed).unwrap();
    Sphere::new(Point::new(7, 3), 40, &gold).unwrap().draw(&mut fine_reversed).unwrap();
    for pixel in disc(40) {
        let color = exposure.of(scene.shade(pixel.normal()));
        let place = (pixel.row() + 3) * 60 + pixel.column() + 7;
        assert_eq!(screen.pixels[place], Some(RawU16::new(DISPLAY.rgb565(color)).into()));
        let of_pattern = DISPLAY.rgb565_dithered(color, pixel.column(), pixel.row());
        assert_eq!(dithered.pixels[place], Some(RawU16::new(of_pattern).into()));
        let Rgb { r, g, b } = DISPLAY.rgb888(color);
        assert_eq!(fine.pixels[place], Some(Rgb888::new(r, g, b)));
        assert_eq!(fine_reversed.pixels[place], Some(Bgr888::new(r, g, b)));
        assert_eq!(reversed.pixels[place], screen.pixels[place].map(Bgr565::from));
    }
    assert_eq!((screen.drawn(), screen.windows), (disc(40).count(), 40));
}

#[test]
fn a_sphere_in_integers_has_the_pixels_of_the_runtime() {
    let lobby = light::q15::LOBBY;
    let scene = sphere::q15::color::scene(lobby, material::q15::GOLD_METALLIC_PAINT).unwrap();
    let exposure = scene.exposure_by_factor(1.5).unwrap();
    let gold = Paint::q15(|normal| scene.shade(normal), exposure, &DISPLAY);
    let mut screen = Screen::<Rgb565>::new(40, 40);
    Sphere::new(Point::zero(), 40, &gold).unwrap().draw(&mut screen).unwrap();
    for pixel in disc(40) {
        let color = exposure.of(scene.shade(pixel.normal_q15()));
        let expected = RawU16::new(DISPLAY.rgb565(color)).into();
        assert_eq!(screen.pixels[pixel.index()], Some(expected));
    }
}

#[test]
fn only_what_is_inside_the_target_is_shaded() {
    let shaded = Cell::new(0);
    let count = |Normal { .. }: Normal| {
        shaded.set(shaded.get() + 1);
        Rgb::gray(0.5)
    };
    let paint = Paint::new(count, Exposure::default(), &DISPLAY);
    let mut codes = [NormalMap::BACKGROUND; 32 * 32];
    for pixel in disc(32) {
        codes[pixel.index()] = NormalMap::code(pixel.normal());
    }
    let map = NormalMap::new(32, 32, codes.as_flattened()).unwrap();
    // Beyond each side and corner, partly and wholly.
    for (x, y) in (-40..50).step_by(9).flat_map(|x| (-40..50).step_by(9).map(move |y| (x, y))) {
        let [at, first] = [Point::new(x, y), Point::new(20, 4)];
        let inside = |pixel: &DiscPixel| {
            let at = at + Point::new(pixel.column() as i32, pixel.row() as i32);
            Rectangle::new(first, Size::new(15, 20)).contains(at)
        };
        let expected = disc(32).filter(inside).count();
        for object in 0..3 {
            let mut screen = Screen::<Rgb565>::new(40, 30);
            let mut part = screen.clipped(&Rectangle::new(first, Size::new(15, 20)));
            shaded.set(0);
            match object {
                0 => Sphere::new(at, 32, &paint).unwrap().draw(&mut part),
                1 => Relief::new(at, map, &paint).draw(&mut part),
                _ => Dial::new(at, 32, 3, 2, &paint).unwrap().draw(&mut part),
            }
            .unwrap();
            assert_eq!((screen.drawn(), shaded.get()), (expected, expected), "{object}: {at}");
        }
    }
}

#[test]
fn an_outline_is_mixed_with_the_background() {
    let paint = Paint::new(|_| Rgb::gray(1.0), Exposure::default(), &DISPLAY);
    let front = NormalMap::code(Normal::new(0.0, 0.0, 1.0).unwrap());
    let edge = |coverage| NormalMap::edge_code(coverage, [-1, 0]);
    // Two runs with a gap: the object, a quarter and three quarters of a pixel.
    let codes = [front, edge(64), NormalMap::BACKGROUND, front, edge(192), NormalMap::BACKGROUND];
    let map = NormalMap::new(6, 1, codes.as_flattened()).unwrap();
    let white = DISPLAY.rgb565(Rgb::gray(1.0));
    let color = |raw| Some(Rgb565::from(RawU16::new(raw)));

    let mut alone = Screen::new(6, 1);
    Relief::new(Point::zero(), map, &paint).draw(&mut alone).unwrap();
    assert_eq!(alone.pixels, [color(white), None, None, color(white), color(white), None]);
    assert_eq!(alone.windows, 2);

    let mut mixed = Screen::new(6, 1);
    let below = Rgb565::BLUE;
    Relief::new(Point::zero(), map, &paint).over(below).draw(&mut mixed).unwrap();
    let of = |coverage| color(blend565(RawU16::from(below).into_inner(), white, coverage));
    assert_eq!(mixed.pixels, [of(255), of(64), None, of(255), of(192), None]);
}

/// A palette draws what its pixels are, in every color, and the codes of a dial are its normals.
#[test]
fn palettes_and_codes_of_a_dial() {
    let scene = sphere::color::scene(light::LOBBY, material::GOLD_METALLIC_PAINT).unwrap();
    let exposure = scene.exposure_by_factor(1.5).unwrap();
    let mut palette = Palette::default();
    palette.fill(&Nodes::ALL, &DISPLAY, |normal| exposure.of(scene.shade(normal)));
    let (mut screen, mut dithered) = (Screen::<Rgb565>::new(40, 40), Screen::<Rgb565>::new(40, 40));
    let mut fine = Screen::<Bgr888>::new(40, 40);
    Sphere::new(Point::zero(), 40, &palette).unwrap().draw(&mut screen).unwrap();
    Sphere::new(Point::zero(), 40, &palette.dithered()).unwrap().draw(&mut dithered).unwrap();
    Sphere::new(Point::zero(), 40, &palette).unwrap().draw(&mut fine).unwrap();
    for pixel in disc(40) {
        let (code, at) = (pixel.code(), pixel.index());
        assert_eq!(screen.pixels[at], Some(RawU16::new(palette.rgb565(code)).into()));
        let of_pattern = palette.dithered().rgb565(code, pixel.column(), pixel.row());
        assert_eq!(dithered.pixels[at], Some(RawU16::new(of_pattern).into()));
        let Rgb { r, g, b } = palette.rgb888(code);
        assert_eq!(fine.pixels[at], Some(Bgr888::new(r, g, b)));
    }
    // On a background, whole pixels stay and the rim is mixed, beyond the circle, too.
    let below = Rgb565::BLUE;
    let mut over = Screen::<Rgb565>::new(40, 40);
    Sphere::new(Point::zero(), 40, &palette).unwrap().over(below).draw(&mut over).unwrap();
    let mut mixed = 0;
    for pixel in Disc::new(40).unwrap() {
        let color = palette.rgb565(pixel.code());
        let expected = blend565(RawU16::from(below).into_inner(), color, pixel.coverage());
        assert_eq!(over.pixels[pixel.index()], Some(RawU16::new(expected).into()));
        mixed += usize::from((1..255).contains(&pixel.coverage()));
    }
    assert!(mixed > 80 && over.drawn() > screen.drawn());

    let (mut drawn, mut packed) = (Screen::<Rgb565>::new(80, 80), Screen::<Rgb565>::new(80, 80));
    let dial = Dial::new(Point::zero(), 80, 6, 3, &palette).unwrap();
    let mut codes = [NormalMap::BACKGROUND; 80 * 80];
    assert!(Dial::codes(80, 6, 3, &mut codes[1..]).is_err());
    Dial::codes(80, 6, 3, &mut codes).unwrap();
    dial.draw(&mut drawn).unwrap();
    let map = NormalMap::new(80, 80, codes.as_flattened()).unwrap();
    Relief::new(Point::zero(), map, &palette).draw(&mut packed).unwrap();
    // Every code of the rim refers to a pixel with a normal.
    let coded = codes.iter().filter(|&&code| code != NormalMap::BACKGROUND).count();
    assert_eq!(map.pixels().count(), coded);
    // The mean of the normals by their definition, at 10 x 10 points.
    let (mut worst, mut off, mut whole) = (0.0_f64, 0, 0);
    for pixel in map.pixels().filter(|pixel| pixel.coverage() == 255) {
        let points = (0..100).map(|k| [f64::from(k % 10), f64::from(k / 10)]);
        let points = points.map(|place| place.map(|part| (2.0 * part + 1.0) / 10.0 - 1.0));
        let [x, y] = [pixel.column(), 79 - pixel.row()].map(|at| 2.0 * at as f64 + 1.0 - 80.0);
        let normals = points.map(|[right, up]| self::dial([x + right, y + up], 80.0, 6.0, 3.0));
        let sum = normals.fold([0.0; 3], |sum, one| [0, 1, 2].map(|k| sum[k] + one[k]));
        let length = sum.iter().map(|along| along * along).sum::<f64>().sqrt();
        let found = pixel.normal().components().map(f64::from);
        let cosine = found.iter().zip(sum).map(|(a, b)| a * b / length).sum::<f64>();
        let angle = cosine.min(1.0).acos().to_degrees();
        (worst, off, whole) = (worst.max(angle), off + usize::from(angle > 3.0), whole + 1);
    }
    // Sixteen points do not resolve an edge.
    assert!(worst < 12.0 && off < whole / 20, "{worst} {off} of {whole}");
    assert!(whole > 4_700 && packed.drawn() == drawn.drawn(), "{whole}");
}

/// The normal of a dial by its definition, in units of half a pixel.
fn dial([x, y]: [f64; 2], diameter: f64, bezel: f64, mark: f64) -> [f64; 3] {
    let upright = |[x, y]: [f64; 2]| [x, y, (1.0 - x * x - y * y).max(0.0).sqrt()];
    let distance = x.hypot(y);
    let inner = diameter - 2.0 * bezel;
    if distance > inner {
        let across = (distance - (diameter - bezel)) / bezel;
        return upright([across * x / distance, across * y / distance]);
    }
    for k in 0..12 {
        let (sine, cosine) = f64::from(k * 30).to_radians().sin_cos();
        let (along, across) = (x * cosine + y * sine, (y * cosine - x * sine) / mark);
        let outer = inner - 4.0 * mark;
        if across.abs() < 1.0 - 1e-9 && along >= (0.75 * outer).floor() && along < outer {
            return upright([-across * sine, across * cosine]);
        }
    }
    upright([0.25 * x / diameter, 0.25 * y / diameter])
}

#[test]
fn a_dial_has_a_bezel_and_twelve_marks_on_a_dome() {
    for (diameter, bezel, mark) in [(240, 20, 4), (64, 5, 2), (96, 0, 3), (33, 8, 0), (1000, 60, 9)]
    {
        let normals = RefCell::new(Vec::new());
        let integers = RefCell::new(Vec::new());
        let floats = |normal: Normal| {
            normals.borrow_mut().push(normal.components().map(f64::from));
            Rgb::gray(0.5)
        };
        let whole = |normal: eigenshade::q15::Normal| {
            integers.borrow_mut().push(normal.components().map(|one| f64::from(one.0) / 32_768.0));
            Rgb::gray(1000)
        };
        let mut screen = Screen::<Rgb565>::new(diameter, diameter);
        let paint = Paint::new(floats, Exposure::default(), &DISPLAY);
        Dial::new(Point::zero(), diameter, bezel, mark, &paint).unwrap().draw(&mut screen).unwrap();
        let mut screen = Screen::<Rgb565>::new(diameter, diameter);
        let exposure = Rgb::gray(eigenshade::q15::Exposure::new(1.0, -15).unwrap());
        let paint = Paint::q15(whole, exposure, &DISPLAY);
        Dial::new(Point::zero(), diameter, bezel, mark, &paint).unwrap().draw(&mut screen).unwrap();
        let (mut elsewhere, mut marked) = (0, 0);
        let found = normals.borrow();
        for ((pixel, &found), &whole) in
            disc(diameter as usize).zip(&*found).zip(&*integers.borrow())
        {
            let size = f64::from(diameter);
            let at = [pixel.column(), size as usize - 1 - pixel.row()]
                .map(|place| 2.0 * place as f64 + 1.0 - size);
            let exact = dial(at, size, f64::from(bezel), f64::from(mark));
            let off = |found: [f64; 3]| {
                found.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
            };
            // Near a rim a root is steep.
            let allowed = if exact[2] < 0.1 { 0.02 } else { 2e-3 };
            elsewhere += usize::from(off(found) > allowed || off(whole) > allowed);
            marked += usize::from(off(found) <= allowed && exact[2] < 0.9);
        }
        // Pixels on the edge of a mark may lie on either side of it.
        assert!(elsewhere <= found.len() / 1_000, "{diameter}: {elsewhere} of {}", found.len());
        assert!(marked > 100, "{diameter}: {marked} of {}", found.len());
    }
}

/// A bezel and marks beyond the most are the widest that there are.
#[test]
fn a_dial_has_room_for_its_marks() {
    let picture = |bezel, mark| {
        let mut screen = Screen::<Rgb888>::new(128, 128);
        let paint = Paint::new(|normal| normal.components().into(), Exposure::default(), &DISPLAY);
        Dial::new(Point::zero(), 128, bezel, mark, &paint).unwrap().draw(&mut screen).unwrap();
        screen.pixels
    };
    assert!(picture(999, 999) == picture(32, 8));
    assert!(picture(32, 8) != picture(32, 0));
}

#[test]
fn what_cannot_be_drawn_is_an_error() {
    let paint = Paint::new(|_| Rgb::gray(1.0), Exposure::default(), &DISPLAY);
    let at = Point::zero();
    for diameter in [0, 4097, u32::MAX] {
        let found = diameter as usize;
        assert_eq!(
            Sphere::<_, Rgb565>::new(at, diameter, &paint).err(),
            Some(Error::Size { found })
        );
        let dial = Dial::<_, Rgb565>::new(at, diameter, u32::MAX, u32::MAX, &paint);
        assert_eq!(dial.err(), Some(Error::Size { found }));
    }
}
