//! A whole frame of the watch face: the light turned, two materials relit, and every pixel sent to
//! a display. Its pixels in integers are compared with those of the host.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program draws in one number format")]

use board::{Passes, measure};

#[path = "../../../crates/embedded-graphics/examples/watch/face.rs"]
mod face;

programs::program!();

/// In floats.
fn in_f32() {
    let mut panel = face::Panel::default();
    measure(&[5], Passes(1), |frame| face::floats::draw(*frame, &mut panel));
}

/// In integers.
fn in_q15() {
    let mut panel = face::Panel::default();
    for frame in [0, 6, 12, 18] {
        if face::integers::draw(frame, &mut panel).is_err() {
            board::exit(false);
        }
    }
    if panel.checksum != face::CHECKSUM {
        board::exit(false);
    }
    measure(&[5], Passes(1), |frame| face::integers::draw(*frame, &mut panel));
}
