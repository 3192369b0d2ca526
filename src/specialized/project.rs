//! Projects a light on a material with all sizes constant: the steps of
//! [`Basis::project`](crate::Basis::project). Four profiles read the scattered material once.

use super::{KnownTable, at, components, tail};
use crate::basis::Basis;
use crate::groups;
use crate::index::layout::LANES;
use crate::projection::{add_lit, gather, write_twos};
use crate::scattering::{scatter_pairs, transpose};

/// The sums S_l,pq of one q, for its `P` pairs p = q, q + 2, ..., in rows of `G` groups. Not inlined,
/// so that the sums stay in registers.
#[inline(never)]
pub fn scatter<const Q: usize, const P: usize, const G: usize, const M: usize, const R: usize>(
    material: &[f32; M],
    polar: &[[[f32; LANES]; G]; R],
    sums: &mut [[[f32; LANES]; G]],
) {
    scatter_pairs(Q, P, material, polar, sums);
}

/// The numbers of a table as `R` rows of `G` groups, if there are enough.
#[inline(always)]
pub fn table_rows<const G: usize, const R: usize>(
    numbers: &[f32],
) -> Option<&[[[f32; LANES]; G]; R]> {
    let (groups, _) = numbers.as_chunks::<LANES>();
    groups.as_chunks::<G>().0.first_chunk()
}

/// Transposes rows over l, one for each pair, to `D` rows over the pairs, one for each l.
#[inline(always)]
pub fn transposed<const V: usize, const D: usize, const G: usize, const R: usize>(
    sums: &[[[f32; LANES]; G]; R],
) -> [[[f32; LANES]; V]; D] {
    let mut scattering = [[[0.0; LANES]; V]; D];
    transpose(sums.as_flattened(), G, scattering.as_flattened_mut(), V);
    scattering
}

/// L_l^m and (-1)^m L_l^-m for the `L` degrees l from m = `M` on.
#[inline(always)]
pub fn lights<const M: usize, const L: usize, const N: usize>(light: &[f32; N]) -> [[f32; 2]; L] {
    let mut lights = [[0.0; 2]; L];
    gather(light, M + L - 1, M, &mut lights);
    lights
}

/// The components of up to `2 C` profiles of azimuth `M`, from number `FIRST` of this azimuth on:
/// `C` times two profiles, for +m and for -m, before the sum across the lanes. The rows have `V`
/// groups, for `L` degrees; the scattered material has `D` rows. Not inlined: a compiler that sees
/// single lanes being read splits the groups.
#[inline(never)]
pub fn rows<
    B: KnownTable<Basis<'static>>,
    const M: usize,
    const FIRST: usize,
    const C: usize,
    const V: usize,
    const L: usize,
    const D: usize,
>(
    scattering: &[[[f32; LANES]; V]; D],
    lights: &[[f32; 2]; L],
) -> [[groups::Two; 2]; C] {
    // Two profiles have two rows of factors for each degree.
    let factors = const {
        let row = at(B::BASIS.parts.azimuths, M).rows as usize + FIRST * L;
        tail(B::BASIS.parts.factors, LANES * V * row)
    };
    let mut sums = [[[0.0; 2 * LANES]; 2]; C];
    let (factors, _) = factors.as_chunks().0.as_chunks::<V>().0.as_chunks::<L>();
    let scattering = scattering.get(M..).and_then(|rows| rows.first_chunk::<L>());
    let Some(rows) = scattering.map(|rows| rows.iter().zip(lights)) else { return sums };
    // The sums are named, so that they stay in registers.
    match (factors, sums.as_mut_slice()) {
        ([a, ..], [of_a]) => {
            let mut sum = [[0.0; 2 * LANES]; 2];
            for (a, (scattering, lights)) in a.iter().zip(rows) {
                sum = add_lit(sum, &groups::product(a, scattering), lights);
            }
            *of_a = sum;
        }
        ([a, b, ..], [of_a, of_b]) => {
            let mut sums = [[[0.0; 2 * LANES]; 2]; 2];
            for ((a, b), (scattering, lights)) in a.iter().zip(b).zip(rows) {
                let (a, b) = (groups::product(a, scattering), groups::product(b, scattering));
                sums = [add_lit(sums[0], &a, lights), add_lit(sums[1], &b, lights)];
            }
            [*of_a, *of_b] = sums;
        }
        _ => {}
    }
    sums
}

/// Writes the components that [`rows`] computed.
#[inline(always)]
pub fn write<B, const M: usize, const FIRST: usize, const C: usize, const K: usize>(
    sums: &[[groups::Two; 2]; C],
    coefficients: &mut [f32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    // There are at most four profiles.
    let components = const {
        let place = at(B::BASIS.parts.azimuths, M);
        let left = place.profiles as usize - FIRST;
        components::<4>(
            B::BASIS.parts.profiles,
            place.first as usize + FIRST,
            if left < 4 { left } else { 4 },
        )
    };
    write_twos(sums, components, coefficients);
}
