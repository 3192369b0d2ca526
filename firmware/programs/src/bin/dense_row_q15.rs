//! One row of a dense projection in Q15; a projection has as many as components.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use programs::dense::{MODES, row};

program!(main);

/// The same numbers stand for every row and for the modes: a K x 3704 matrix does not fit
/// the smaller boards.
static ROW: [i16; MODES] = {
    let mut row = [0; MODES];
    let (mut rest, mut state) = (row.as_mut_slice(), 1_u32);
    while let [first, tail @ ..] = rest {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *first = (state >> 16) as i16;
        rest = tail;
    }
    row
};

fn main() {
    measure(&[&ROW, &ROW], Passes(8), |modes| product(modes));
}

#[inline(never)]
fn product(modes: &[i16; MODES]) -> i16 {
    row(&ROW, modes)
}
