//! A whole frame of the watch face in Q15: the light turned, two materials relit, and every pixel
//! sent to a display. Frames are compared with those of the host.
#![no_std]
#![no_main]

use board::{Passes, measure};

#[path = "../../../crates/embedded-graphics/examples/watch/face.rs"]
mod face;

programs::program!();

fn watch() {
    let (mut watch, mut panel) = (face::Watch::default(), face::Panel::default());
    for frame in [0, 6, 12, 18] {
        if face::integers::draw(frame, &mut watch, &mut panel).is_err() {
            board::exit(false);
        }
    }
    if panel.checksum != face::CHECKSUM {
        board::exit(false);
    }
    board::holds(size_of_val(&watch));
    measure(&[5], Passes(1), |frame| face::integers::draw(*frame, &mut watch, &mut panel));
}
