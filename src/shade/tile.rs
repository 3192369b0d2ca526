//! A tile of normals, azimuth by azimuth: what short polynomials are fastest by where vector
//! registers are few.
//!
//! A block keeps its sums in registers and reads each term for all of it; with 16 registers it
//! is small, and with polynomials of a few terms a processor waits for one sum's last
//! product. Here each azimuth is a loop over the tile, its terms known in number, and the
//! sums of the azimuths above lie in the first cache.

use crate::scalar::Scalar;
use crate::scene::{Descent, argument};

/// Normals in one tile.
pub(super) const TILE: usize = 64;

/// Most terms of a polynomial: of longer ones blocks are faster.
const MOST: usize = 8;

/// Whether tiles are faster than blocks for these polynomials, on this target.
pub(super) fn fits<S>(polynomials: &Descent<'_, S>) -> bool {
    cfg!(all(target_arch = "x86_64", not(target_feature = "avx512f")))
        && !polynomials.any_longer_than(MOST)
}

/// P_m + i Q_m of the azimuths above, summed by Horner's rule in w̄, at a tile's normals.
struct Tile<'n, S> {
    t: [S; TILE],
    x: &'n [S; TILE],
    y: &'n [S; TILE],
    real: [S; TILE],
    imaginary: [S; TILE],
}

/// Runs a function for polynomials whose number of terms is known.
macro_rules! of_known_length {
    ($length:expr, $run:ident($($argument:expr),*)) => {
        match $length {
            0 => $run::<S, 0>($($argument),*),
            1 => $run::<S, 1>($($argument),*),
            2 => $run::<S, 2>($($argument),*),
            3 => $run::<S, 3>($($argument),*),
            4 => $run::<S, 4>($($argument),*),
            5 => $run::<S, 5>($($argument),*),
            6 => $run::<S, 6>($($argument),*),
            7 => $run::<S, 7>($($argument),*),
            _ => $run::<S, 8>($($argument),*),
        }
    };
}

/// The irradiances of a tile of normals.
pub(super) fn tile<S: Scalar>(
    mut polynomials: Descent<'_, S>,
    [x, y, z]: [&[S; TILE]; 3],
    out: &mut [S; TILE],
) {
    let (real, imaginary) = ([S::ZERO; TILE], [S::ZERO; TILE]);
    let mut sums = Tile { t: z.map(argument), x, y, real, imaginary };
    if let Some((plus, minus)) = polynomials.next() {
        of_known_length!(plus.len(), highest(plus, minus, &mut sums));
    }
    for (plus, minus) in polynomials.by_ref() {
        of_known_length!(plus.len(), azimuth(plus, minus, &mut sums));
    }
    of_known_length!(polynomials.pole.len(), pole(polynomials.pole, &sums, out));
}

/// By Horner's rule, as [`crate::polynomial::values`].
#[inline(always)]
fn value<S: Scalar, const L: usize>(terms: &[S; L], t: S) -> S {
    let Some((&first, rest)) = terms.split_first() else { return S::ZERO };
    rest.iter().fold(first, |sum, &term| term.add_product(sum, t))
}

#[inline(never)]
fn highest<S: Scalar, const L: usize>(plus: &[S], minus: &[S], sums: &mut Tile<'_, S>) {
    let (Some(plus), Some(minus)) = (plus.first_chunk::<L>(), minus.first_chunk::<L>()) else {
        return;
    };
    let both = sums.real.iter_mut().zip(&mut sums.imaginary);
    for ((real, imaginary), &t) in both.zip(&sums.t) {
        (*real, *imaginary) = (value(plus, t), value(minus, t));
    }
}

#[inline(never)]
fn azimuth<S: Scalar, const L: usize>(plus: &[S], minus: &[S], sums: &mut Tile<'_, S>) {
    let (Some(plus), Some(minus)) = (plus.first_chunk::<L>(), minus.first_chunk::<L>()) else {
        return;
    };
    let both = sums.real.iter_mut().zip(&mut sums.imaginary);
    let at = sums.t.iter().zip(sums.x.iter().zip(sums.y));
    for ((real, imaginary), (&t, (&x, &y))) in both.zip(at) {
        (*real, *imaginary) = (
            value(plus, t).add_product(*real, x).add_product(*imaginary, y),
            value(minus, t).add_product(*imaginary, x).add_product(-*real, y),
        );
    }
}

#[inline(never)]
fn pole<S: Scalar, const L: usize>(terms: &[S], sums: &Tile<'_, S>, out: &mut [S; TILE]) {
    let Some(terms) = terms.first_chunk::<L>() else { return };
    let both = sums.real.iter().zip(&sums.imaginary);
    let at = sums.t.iter().zip(sums.x.iter().zip(sums.y));
    for ((out, (&real, &imaginary)), (&t, (&x, &y))) in out.iter_mut().zip(both).zip(at) {
        *out = value(terms, t).add_product(real, x).add_product(imaginary, y);
    }
}
