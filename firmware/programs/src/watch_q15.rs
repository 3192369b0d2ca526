//! Whole frames of the watch face in Q15. Frames are compared with those of
//! the host. A program is one of these functions.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use board::{Passes, measure};
use eigenshade::Error;

#[path = "../../../crates/embedded-graphics/examples/watch/face.rs"]
mod face;

programs::program!();

fn watch() {
    check(&face::SMALL, face::CHECKSUMS[0]);
    turning(&face::SMALL);
}

fn watch_240() {
    check(&face::LARGE, face::CHECKSUMS[1]);
    turning(&face::LARGE);
}

/// The light turned, the dial relit, its palette and the colors of the relief computed, and every
/// pixel sent.
fn turning(face: &face::Face) {
    let Ok(mut watch) = face::integers::watch(face) else { board::exit(false) };
    let mut panel = face::Panel::new(face);
    board::holds(size_of_val(&watch));
    measure(&[5], Passes(1), |frame| {
        face::integers::relight(*frame, &mut watch)?;
        let Ok(()) = watch.draw(&mut panel);
        Ok::<(), Error>(())
    });
}

/// Every pixel drawn and sent: the light stands still.
fn watch_240_still() {
    let Ok(mut watch) = face::integers::watch(&face::LARGE) else { board::exit(false) };
    let mut panel = face::Panel::new(&face::LARGE);
    if face::integers::relight(5, &mut watch).is_err() {
        board::exit(false);
    }
    board::holds(size_of_val(&watch));
    measure(&[()], Passes(1), |()| watch.draw(&mut panel).is_ok());
}

/// Compares frames with those of the host.
fn check(face: &face::Face, expected: u32) {
    let Ok(mut watch) = face::integers::watch(face) else { board::exit(false) };
    let mut panel = face::Panel::new(face);
    for frame in [0, 6, 12, 18] {
        if face::integers::relight(frame, &mut watch).is_err() || watch.draw(&mut panel).is_err() {
            board::exit(false);
        }
    }
    if panel.checksum != expected {
        board::exit(false);
    }
}
