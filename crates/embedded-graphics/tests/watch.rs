//! The example of a watch: its relief, its frames in integers, and in floats.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../examples/watch/face.rs"]
mod face;
#[path = "../examples/watch/relief.rs"]
mod relief;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};

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
fn frames_in_integers_are_the_same_on_every_machine() {
    let mut panel = face::Panel::default();
    for frame in (0..face::FRAMES).step_by(6) {
        let Ok(()) = face::integers::draw(frame, &mut panel).unwrap();
    }
    assert_eq!(panel.checksum, face::CHECKSUM, "{:#x}", panel.checksum);
}

#[test]
fn the_picture_in_the_documentation_has_these_frames() {
    let picture = std::io::Cursor::new(include_bytes!("../../../docs/watch.png"));
    let mut picture = png::Decoder::new(picture).read_info().unwrap();
    let frames = picture.info().animation_control.unwrap().num_frames;
    assert_eq!(frames, face::FRAMES.cast_unsigned());
    let settings = OutputSettingsBuilder::new().scale(2).build();
    let mut found = vec![0; picture.output_buffer_size().unwrap()];
    for frame in 0..face::FRAMES {
        picture.next_frame(&mut found).unwrap();
        let mut display = SimulatorDisplay::<Rgb565>::new(Size::new_equal(face::SIZE));
        face::floats::draw(frame, &mut display).unwrap().unwrap();
        let image = display.to_rgb_output_image(&settings);
        let image = image.as_image_buffer();
        let expected = image.as_raw();
        assert_eq!(found.len(), expected.len());
        // A step of five bits, where floats round the other way.
        let off = found.iter().zip(*expected).filter(|(a, b)| a.abs_diff(**b) > 9).count();
        let changed = found.iter().zip(*expected).filter(|(a, b)| a != b).count();
        assert!(off == 0 && changed <= found.len() / 1_000, "frame {frame}: {off}, {changed}");
    }
}

#[test]
fn frames_in_integers_are_those_in_floats() {
    let size = Size::new_equal(face::SIZE);
    for frame in [0, 7, 20] {
        let mut displays = [(); 2].map(|()| SimulatorDisplay::<Rgb888>::new(size));
        let [of_integers, of_floats] = &mut displays;
        face::integers::draw(frame, of_integers).unwrap().unwrap();
        face::floats::draw(frame, of_floats).unwrap().unwrap();
        let (mut off, mut lit) = (0, 0);
        for place in of_floats.bounding_box().points() {
            let [a, b] = displays.each_ref().map(|display| display.get_pixel(place));
            let steps = [(a.r(), b.r()), (a.g(), b.g()), (a.b(), b.b())];
            lit += usize::from(b != Rgb888::BLACK);
            off += usize::from(steps.iter().any(|(a, b)| a.abs_diff(*b) > 3));
        }
        // Half of the square and more is drawn; dark pixels are steep in sRGB.
        assert!(lit > 9_000 && off < lit / 100, "frame {frame}: {off} of {lit}");
    }
}
