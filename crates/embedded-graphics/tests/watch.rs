//! The example of a watch: its relief, its frames in integers, and in floats.
#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

#[path = "../examples/watch/face.rs"]
mod face;
#[path = "../examples/watch/picture.rs"]
mod picture;
#[path = "../examples/watch/relief.rs"]
mod relief;

use eigenshade::object::NormalMap;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU24};
use embedded_graphics::prelude::*;

const FACES: [&face::Face; 2] = [&face::SMALL, &face::LARGE];

#[test]
fn the_normals_are_as_described() {
    for face in FACES {
        let [dial, relief] = face.maps().unwrap();
        let committed = |map: NormalMap<'_>| {
            map.pixels()
                .map(|pixel| (pixel.index(), pixel.coverage(), pixel.code().bytes()))
                .collect::<Vec<_>>()
        };
        let made = relief::dial(face);
        let side = face.size as usize;
        let made = NormalMap::new(side, side, made.as_flattened()).unwrap();
        assert_eq!(committed(dial), committed(made));
        let made = relief::codes(face);
        let side = face.relief as usize;
        let made = NormalMap::new(side, side, made.as_flattened()).unwrap();
        let (found, made) = (committed(relief), committed(made));
        assert_eq!(found.len(), made.len());
        for ((at, _, found), (place, _, made)) in found.into_iter().zip(made) {
            // Sines differ between machines.
            let off = |k: usize| made[k].cast_signed().abs_diff(found[k].cast_signed());
            assert!(at == place && off(0) <= 1 && off(1) <= 1);
        }
    }
}

#[test]
fn frames_in_integers_are_the_same_on_every_machine() {
    for (face, expected) in FACES.into_iter().zip(face::CHECKSUMS) {
        let (mut watch, mut panel) = (face::integers::watch(face).unwrap(), face::Panel::new(face));
        for frame in (0..face::FRAMES).step_by(6) {
            face::integers::relight(frame, &mut watch).unwrap();
            let Ok(()) = watch.draw(&mut panel);
        }
        assert_eq!(panel.checksum, expected, "{}: {:#x}", face.size, panel.checksum);
    }
}

#[test]
fn the_picture_in_the_documentation_has_these_frames() {
    let picture = std::io::Cursor::new(include_bytes!("../../../docs/watch.png"));
    let mut picture = png::Decoder::new(picture).read_info().unwrap();
    assert_eq!(picture.info().size(), (picture::SIDE, picture::SIDE));
    let frames = picture.info().animation_control.unwrap().num_frames;
    assert_eq!(frames, (face::FRAMES / picture::STEP).cast_unsigned());
    let mut found = vec![0; picture.output_buffer_size().unwrap()];
    for frame in (0..face::FRAMES).step_by(picture::STEP as usize) {
        picture.next_frame(&mut found).unwrap();
        let expected = picture::rgb(frame).unwrap();
        assert_eq!(found.len(), expected.len());
        // A step of five bits, where floats round the other way.
        let off = found.iter().zip(&expected).filter(|(a, b)| a.abs_diff(**b) > 9).count();
        let changed = found.iter().zip(&expected).filter(|(a, b)| a != b).count();
        assert!(off == 0 && changed <= found.len() / 1_000, "frame {frame}: {off}, {changed}");
    }
}

#[test]
fn frames_in_integers_are_those_in_floats() {
    const SIDE: usize = face::LARGE.size as usize;
    const BYTES: usize = buffer_size::<Rgb888>(SIDE, SIDE);
    type Display = Framebuffer<Rgb888, RawU24, LittleEndian, SIDE, SIDE, BYTES>;
    let mut integers = face::integers::watch(&face::LARGE).unwrap();
    let mut floats = face::floats::watch(&face::LARGE).unwrap();
    for frame in [0, 7, 20] {
        let mut displays = [(); 2].map(|()| Display::new());
        let [of_integers, of_floats] = &mut displays;
        face::integers::relight(frame, &mut integers).unwrap();
        let Ok(()) = integers.draw(of_integers);
        face::floats::relight(frame, &mut floats).unwrap();
        let Ok(()) = floats.draw(of_floats);
        let (mut off, mut lit) = (0, 0);
        for place in of_floats.bounding_box().points() {
            let [a, b] = displays.each_ref().map(|display| display.pixel(place).unwrap());
            let steps = [(a.r(), b.r()), (a.g(), b.g()), (a.b(), b.b())];
            lit += usize::from(b != Rgb888::BLACK);
            off += usize::from(steps.iter().any(|(a, b)| a.abs_diff(*b) > 3));
        }
        // Half of the square and more is drawn; dark pixels are steep in sRGB.
        assert!(lit > 32_000 && off < lit / 100, "frame {frame}: {off} of {lit}");
    }
}
