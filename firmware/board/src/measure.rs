//! Instructions and stack of one operation.

use crate::clock::{Clock, run_two_instructions};
use crate::{say, say_number, stack};
use core::hint::black_box;

/// Instructions of the loop that tells how long a tick is.
const CALIBRATION: u32 = 1 << 20;

/// How often an operation is repeated.
#[derive(Clone, Copy, Debug)]
pub struct Passes(pub u32);

/// Says how many bytes of RAM an operation's inputs and answers take, where they are not
/// statics.
pub fn holds(bytes: usize) {
    say("holds");
    say_number(bytes as u32);
    say("\n");
}

/// Measures an operation on each of the inputs, so many times each, and says
///
/// ```text
/// tick INSTRUCTIONS TICKS
/// count OPERATIONS TICKS TICKS_OF_AN_EMPTY_LOOP
/// stack BYTES
/// ```
///
/// A count takes in reading the input and writing the answer. The operation is part of
/// the loop, as in a program that draws an image, unless it is a function apart.
pub fn measure<I, O>(inputs: &[I], Passes(passes): Passes, mut operation: impl FnMut(&I) -> O) {
    let clock = Clock::start();
    say("tick");
    say_number(CALIBRATION);
    say_number(clock.ticks(|| run_two_instructions(CALIBRATION / 2)));
    let count = passes * inputs.len() as u32;
    let empty = clock.ticks(|| run(inputs, black_box(passes), &mut |_| ()));
    let ticks = clock.ticks(|| run(inputs, black_box(passes), &mut operation));
    say("\ncount");
    say_number(count);
    say_number(ticks);
    say_number(empty);
    let bytes = stack::taken(|| run(inputs, black_box(1), &mut operation));
    say("\nstack");
    say_number(bytes);
    say("\n");
}

/// [`measure`] of one of several operations of a program: it says `operation NAME` first.
pub fn measure_named<I, O>(
    name: &str,
    inputs: &[I],
    passes: Passes,
    operation: impl FnMut(&I) -> O,
) {
    say("operation ");
    say(name);
    say("\n");
    measure(inputs, passes, operation);
}

/// Each input so many times; not seen by its callers, so that it exists once.
#[inline(never)]
fn run<I, O>(inputs: &[I], passes: u32, operation: &mut impl FnMut(&I) -> O) {
    for _ in 0..passes {
        for input in inputs {
            black_box(operation(black_box(input)));
        }
    }
}
