//! Projects a light on a material with all sizes constant: the steps of
//! [`Basis::project`](crate::Basis::project). Four profiles read the scattered material once.

use super::KnownTable;
use crate::basis::Basis;
use crate::index::layout::LANES;
use crate::light::Light;
use crate::material::Material;
use crate::projection::{add_lit, gather};
use crate::{index, lanes};

/// The coefficients of a light and of a material, if there are exactly `N` and `M`.
#[inline(always)]
pub fn inputs<'a, const N: usize, const M: usize>(
    light: &Light<'a>,
    material: &Material<'a>,
) -> Option<(&'a [f32; N], &'a [f32; M])> {
    Some((light.coefficients().try_into().ok()?, material.coefficients().try_into().ok()?))
}

/// The sums S_l,pq of one q, for its `P` pairs p = q, q + 2, ...: P x P products of a symmetric
/// matrix B and rows of Ĉ. Rows run along l and have `G` groups. Not inlined, so that the sums stay
/// in registers.
#[inline(never)]
pub fn scatter<const Q: usize, const P: usize, const G: usize, const M: usize, const R: usize>(
    material: &[f32; M],
    polar: &[[[f32; LANES]; G]; R],
    sums: &mut [[[f32; LANES]; G]],
) {
    let half = core::f32::consts::FRAC_1_SQRT_2;
    for p in 0..P {
        let mut sum = [[0.0; LANES]; G];
        for o in 0..P {
            let mode = index::material::position(Q + 2 * p.max(o), Q + 2 * p.min(o), Q);
            let row = polar.get(index::pair::position(Q + 2 * o, Q));
            let (Some(&b), Some(row)) = (material.get(mode), row) else { continue };
            let b = if o == p { b } else { half * b };
            for (sum, row) in sum.iter_mut().zip(row) {
                *sum = lanes::multiply_add(*sum, &[b; LANES], row);
            }
        }
        if let Some(to) = sums.get_mut(index::pair::position(Q + 2 * p, Q)) {
            *to = sum;
        }
    }
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
    let (columns, _) = sums.as_chunks::<LANES>();
    for (column, [first, second, third, fourth]) in columns.iter().enumerate() {
        let lanes = first.as_flattened().iter().zip(second.as_flattened());
        let lanes = lanes.zip(third.as_flattened().iter().zip(fourth.as_flattened()));
        for (row, ((&a, &b), (&c, &d))) in scattering.iter_mut().zip(lanes) {
            if let Some(to) = row.get_mut(column) {
                *to = [a, b, c, d];
            }
        }
    }
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
) -> [[lanes::Two; 2]; C] {
    let factors = const { B::BASIS.parts.factors.split_at(B::BASIS.factors_at(M, FIRST)).1 };
    let mut sums = [[[0.0; 2 * LANES]; 2]; C];
    let (factors, _) = factors.as_chunks().0.as_chunks::<V>().0.as_chunks::<L>();
    let scattering = scattering.get(M..).and_then(|rows| rows.first_chunk::<L>());
    let Some(rows) = scattering.map(|rows| rows.iter().zip(lights)) else { return sums };
    // The sums are named, so that they stay in registers.
    match (factors, sums.as_mut_slice()) {
        ([a, ..], [of_a]) => {
            let mut sum = [[0.0; 2 * LANES]; 2];
            for (a, (scattering, lights)) in a.iter().zip(rows) {
                sum = add_lit(sum, &lanes::product(a, scattering), lights);
            }
            *of_a = sum;
        }
        ([a, b, ..], [of_a, of_b]) => {
            let mut sums = [[[0.0; 2 * LANES]; 2]; 2];
            for ((a, b), (scattering, lights)) in a.iter().zip(b).zip(rows) {
                let (a, b) = (lanes::product(a, scattering), lanes::product(b, scattering));
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
    sums: &[[lanes::Two; 2]; C],
    coefficients: &mut [f32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    let places = const { &B::BASIS.twos_of::<C>(M, FIRST) };
    for (two, [plus, minus]) in places.iter().zip(sums) {
        for (components, sums) in two.iter().zip([lanes::sums(*plus), lanes::sums(*minus)]) {
            for (&component, sum) in components.iter().zip(sums) {
                if let Some(coefficient) = coefficients.get_mut(usize::from(component)) {
                    *coefficient = sum;
                }
            }
        }
    }
}
