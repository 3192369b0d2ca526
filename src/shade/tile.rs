//! Shades a tile of normals, azimuth by azimuth. This is the fastest way for short polynomials on
//! targets with few vector registers.
//!
//! A block keeps its sums in registers and reads each term once for all its normals. With 16
//! registers a block is small, and for polynomials of a few terms the processor waits for the last
//! product of one sum. A tile instead runs one loop over its normals for each azimuth, with the
//! number of terms known at compile time, and keeps the sums of higher azimuths in the L1 cache.

use crate::float;
use crate::polynomial::argument;
use crate::scene::Descent;

/// Normals in one tile: sixteen vectors, so that starting and ending a loop costs little.
pub(super) const TILE: usize = if cfg!(target_feature = "avx") { 128 } else { 64 };

/// The largest number of terms of a polynomial. Blocks are faster for longer ones.
const MOST: usize = 8;

/// Whether tiles are faster than blocks on this target. Never true if azimuth 0 is the only one.
pub(super) fn fits(polynomials: &Descent<'_>) -> bool {
    cfg!(all(target_arch = "x86_64", not(target_feature = "avx512f")))
        && !polynomials.lengths.is_empty()
        && !polynomials.any_longer_than(MOST)
}

/// The working memory of a tile: t, and P_m + i Q_m of the higher azimuths, summed by Horner's rule
/// in w̄. Tiles reuse it without clearing it.
#[repr(align(64))]
pub(super) struct Room {
    t: [f32; TILE],
    real: [f32; TILE],
    imaginary: [f32; TILE],
}

impl Room {
    pub(super) const fn new() -> Self {
        Self { t: [0.0; TILE], real: [0.0; TILE], imaginary: [0.0; TILE] }
    }
}

/// Runs a function specialized for the number of terms of a polynomial.
macro_rules! of_known_length {
    ($length:expr, $run:ident($($argument:expr),*)) => {
        match $length {
            0 => $run::<0>($($argument),*),
            1 => $run::<1>($($argument),*),
            2 => $run::<2>($($argument),*),
            3 => $run::<3>($($argument),*),
            4 => $run::<4>($($argument),*),
            5 => $run::<5>($($argument),*),
            6 => $run::<6>($($argument),*),
            7 => $run::<7>($($argument),*),
            _ => $run::<8>($($argument),*),
        }
    };
}

/// The first step of a tile, which scenes of the same normals share: the argument t of each normal.
#[inline(always)]
pub(super) fn arguments(z: &[f32; TILE], room: &mut Room) {
    for (t, &z) in room.t.iter_mut().zip(z) {
        *t = argument(z);
    }
}

/// The irradiances of a tile of normals, whose arguments are in `room`.
#[inline(always)]
pub(super) fn tile(
    mut polynomials: Descent<'_>,
    [x, y]: [&[f32; TILE]; 2],
    room: &mut Room,
    out: &mut [f32; TILE],
) {
    let Some((plus, minus)) = polynomials.next() else { return };
    of_known_length!(plus.len(), highest(plus, minus, room));
    for (plus, minus) in polynomials.by_ref() {
        of_known_length!(plus.len(), azimuth([plus, minus], [x, y], room));
    }
    of_known_length!(polynomials.pole.len(), pole(polynomials.pole, [x, y], room, out));
}

/// Horner's rule, as in [`crate::polynomial::values`].
#[inline(always)]
fn value<const L: usize>(terms: &[f32; L], t: f32) -> f32 {
    let Some((&first, rest)) = terms.split_first() else { return 0.0 };
    rest.iter().fold(first, |sum, &term| float::add_product(term, sum, t))
}

#[inline(never)]
fn highest<const L: usize>(plus: &[f32], minus: &[f32], room: &mut Room) {
    let (Some(plus), Some(minus)) = (plus.first_chunk::<L>(), minus.first_chunk::<L>()) else {
        return;
    };
    let both = room.real.iter_mut().zip(&mut room.imaginary);
    for ((real, imaginary), &t) in both.zip(&room.t) {
        (*real, *imaginary) = (value(plus, t), value(minus, t));
    }
}

#[inline(never)]
fn azimuth<const L: usize>([plus, minus]: [&[f32]; 2], [x, y]: [&[f32; TILE]; 2], room: &mut Room) {
    let (Some(plus), Some(minus)) = (plus.first_chunk::<L>(), minus.first_chunk::<L>()) else {
        return;
    };
    let both = room.real.iter_mut().zip(&mut room.imaginary);
    let at = room.t.iter().zip(x.iter().zip(y));
    for ((real, imaginary), (&t, (&x, &y))) in both.zip(at) {
        (*real, *imaginary) = (
            float::add_product(float::add_product(value(plus, t), *real, x), *imaginary, y),
            float::add_product(float::add_product(value(minus, t), *imaginary, x), -*real, y),
        );
    }
}

#[inline(never)]
fn pole<const L: usize>(
    terms: &[f32],
    [x, y]: [&[f32; TILE]; 2],
    room: &Room,
    out: &mut [f32; TILE],
) {
    let Some(terms) = terms.first_chunk::<L>() else { return };
    let both = room.real.iter().zip(&room.imaginary);
    let at = room.t.iter().zip(x.iter().zip(y));
    for ((out, (&real, &imaginary)), (&t, (&x, &y))) in out.iter_mut().zip(both).zip(at) {
        *out = float::add_product(float::add_product(value(terms, t), real, x), imaginary, y);
    }
}
