//! Instructions and stack of one operation.

use crate::clock::{Clock, run_two_instructions};
use crate::{say, say_number, stack};
use core::hint::black_box;

/// Instructions of the loop that tells how long a tick is.
const CALIBRATION: u32 = 1 << 20;

/// How often an operation is repeated.
#[derive(Clone, Copy, Debug)]
pub struct Passes(pub u32);

/// Measures an operation on each of the inputs, so many times each, and says
///
/// ```text
/// tick INSTRUCTIONS TICKS
/// count OPERATIONS TICKS TICKS_OF_AN_EMPTY_LOOP
/// stack BYTES
/// ```
///
/// A count takes in reading the input and writing the answer.
pub fn measure<I, O>(inputs: &[I], Passes(passes): Passes, mut operation: impl FnMut(&I) -> O) {
    let clock = Clock::start();
    say("tick");
    say_number(CALIBRATION);
    say_number(clock.ticks(|| run_two_instructions(CALIBRATION / 2)));
    let count = passes * inputs.len() as u32;
    let empty = clock.ticks(|| {
        for _ in 0..black_box(passes) {
            for input in inputs {
                black_box(input);
            }
        }
    });
    let mut run = |passes| {
        for _ in 0..passes {
            for input in inputs {
                black_box(operation(black_box(input)));
            }
        }
    };
    let ticks = clock.ticks(|| run(black_box(passes)));
    say("\ncount");
    say_number(count);
    say_number(ticks);
    say_number(empty);
    let bytes = stack::taken(|| run(black_box(1)));
    say("\nstack");
    say_number(bytes);
    say("\n");
}
