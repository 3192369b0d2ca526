//! The example of a watch: its relief, its frames in integers, and in floats.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../examples/watch/face.rs"]
mod face;
#[path = "../examples/watch/picture.rs"]
mod picture;
#[path = "../examples/watch/relief.rs"]
mod relief;

use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU24};
use embedded_graphics::prelude::*;

#[test]
fn the_relief_is_as_described() {
    let committed = include_bytes!("../examples/watch/relief.bin");
    let made = relief::codes();
    assert_eq!(committed.len(), made.as_flattened().len());
    for (made, &committed) in made.as_flattened().iter().zip(committed) {
        // Sines differ between machines.
        assert!(made.cast_signed().abs_diff(committed.cast_signed()) <= 1);
    }
}

#[test]
fn the_dial_is_that_of_the_drawable() {
    let committed = include_bytes!("../examples/watch/dial.bin");
    assert_eq!(relief::dial().as_flattened(), committed);
}

#[test]
fn frames_in_integers_are_the_same_on_every_machine() {
    let (mut watch, mut panel) = (face::Watch::default(), face::Panel::default());
    for frame in (0..face::FRAMES).step_by(6) {
        let Ok(()) = face::integers::draw(frame, &mut watch, &mut panel).unwrap();
    }
    assert_eq!(panel.checksum, face::CHECKSUM, "{:#x}", panel.checksum);
}

#[test]
fn the_picture_in_the_documentation_has_these_frames() {
    let picture = std::io::Cursor::new(include_bytes!("../../../docs/watch.png"));
    let mut picture = png::Decoder::new(picture).read_info().unwrap();
    assert_eq!(picture.info().size(), (picture::SIDE, picture::SIDE));
    let frames = picture.info().animation_control.unwrap().num_frames;
    assert_eq!(frames, face::FRAMES.cast_unsigned());
    let mut found = vec![0; picture.output_buffer_size().unwrap()];
    for frame in 0..face::FRAMES {
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
    const SIDE: usize = face::SIZE as usize;
    const BYTES: usize = buffer_size::<Rgb888>(SIDE, SIDE);
    type Display = Framebuffer<Rgb888, RawU24, LittleEndian, SIDE, SIDE, BYTES>;
    let mut watch = face::Watch::default();
    for frame in [0, 7, 20] {
        let mut displays = [(); 2].map(|()| Display::new());
        let [of_integers, of_floats] = &mut displays;
        let Ok(()) = face::integers::draw(frame, &mut watch, of_integers).unwrap();
        let Ok(()) = face::floats::draw(frame, &mut watch, of_floats).unwrap();
        let (mut off, mut lit) = (0, 0);
        for place in of_floats.bounding_box().points() {
            let [a, b] = displays.each_ref().map(|display| display.pixel(place).unwrap());
            let steps = [(a.r(), b.r()), (a.g(), b.g()), (a.b(), b.b())];
            lit += usize::from(b != Rgb888::BLACK);
            off += usize::from(steps.iter().any(|(a, b)| a.abs_diff(*b) > 3));
        }
        // Half of the square and more is drawn; dark pixels are steep in sRGB.
        assert!(lit > 9_000 && off < lit / 100, "frame {frame}: {off} of {lit}");
    }
}
