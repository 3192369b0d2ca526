//! A whole frame of the watch face in f32: the light turned, two materials relit, and every pixel
//! sent to a display.
#![no_std]
#![no_main]

use board::{Passes, measure};

#[path = "../../../crates/embedded-graphics/examples/watch/face.rs"]
mod face;

programs::program!();

fn watch() {
    let (mut watch, mut panel) = (face::Watch::default(), face::Panel::default());
    board::holds(size_of_val(&watch));
    measure(&[5], Passes(1), |frame| face::floats::draw(*frame, &mut watch, &mut panel));
}
