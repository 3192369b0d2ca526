//! Kernels for shapes that are known at compile time. The generated code of a table calls them,
//! once for each part of the work.
//!
//! They compute the same as [`Basis::project`](crate::Basis::project),
//! [`Basis::relight`](crate::Basis::relight), [`Basis::collapse`](crate::Basis::collapse) and
//! [`Scene::shade`](crate::Scene::shade), with constants for all sizes and indices. If an argument
//! does not have the expected shape, the general functions are called instead.

mod scene;

pub use scene::{
    GROUPS, azimuth, blank_coefficients, blank_scene, coefficients_mut, collapse, highest, order,
    pole, scene, scene_mut, shade, transfer,
};

use crate::buffer::Buffer;
use crate::error::{Argument, Error};
use crate::index;
use crate::index::layout::{LANES, lowest_degree};
use crate::index::light::position;
use crate::lanes;
use crate::light::Light;
use crate::material::Material;
use crate::projection::Coefficients;
use crate::scalar::Scalar;

/// Shades normals one by one.
///
/// # Errors
///
/// [`Error::Length`] unless `irradiance` and `normals` have the same length.
#[inline(always)]
pub fn shade_each<N: Copy, I>(
    normals: &[N],
    irradiance: &mut [I],
    shade: impl Fn(N) -> I,
) -> Result<(), Error> {
    Error::check(Argument::Normals, normals.len(), irradiance.len())?;
    for (irradiance, &normal) in irradiance.iter_mut().zip(normals) {
        *irradiance = shade(normal);
    }
    Ok(())
}

/// The coefficients of a light, if there are exactly `N`.
#[inline]
pub fn light<'a, S: Scalar, const N: usize>(light: &Light<'a, S>) -> Option<&'a [S; N]> {
    light.coefficients().try_into().ok()
}

/// The coefficients of a material, if there are exactly `N`.
#[inline]
pub fn material<'a, S: Scalar, const N: usize>(material: &Material<'a, S>) -> Option<&'a [S; N]> {
    material.coefficients().try_into().ok()
}

/// The sums S_l,pq of one q, for its `P` pairs p = q, q + 2, ...: P x P products of a symmetric
/// matrix B and rows of Ĉ. Rows run along l and have `G` groups.
///
/// Not inlined, so that the sums stay in registers.
#[inline(never)]
pub fn scatter<
    S: Scalar,
    const Q: usize,
    const P: usize,
    const G: usize,
    const M: usize,
    const R: usize,
>(
    material: &[S; M],
    polar: &[[[S; LANES]; G]; R],
    sums: &mut [[[S; LANES]; G]],
) {
    let half = S::from_f64(core::f64::consts::FRAC_1_SQRT_2);
    for p in 0..P {
        let mut sum = [[S::ZERO; LANES]; G];
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
pub fn table_rows<S: Scalar, const G: usize, const R: usize>(
    numbers: &[S],
) -> Option<&[[[S; LANES]; G]; R]> {
    let (groups, _) = numbers.as_chunks::<LANES>();
    groups.as_chunks::<G>().0.first_chunk()
}

/// Transposes rows over l, one for each pair, to `D` rows over the pairs, one for each l.
#[inline(always)]
pub fn transposed<S: Scalar, const V: usize, const D: usize, const G: usize, const R: usize>(
    sums: &[[[S; LANES]; G]; R],
) -> [[[S; LANES]; V]; D] {
    let mut scattering = [[[S::ZERO; LANES]; V]; D];
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

/// The coefficients of an image less those of the mean image.
#[inline(always)]
pub fn coefficients<S: Scalar, const K: usize>(
    mut coefficients: [S; K],
    mean: &[S],
) -> Coefficients<S, K> {
    subtract(&mut coefficients, mean);
    Buffer::from(coefficients)
}

/// Subtracts the coefficients of the mean image from those of an image.
#[inline(always)]
pub fn subtract<S: Scalar, const K: usize>(coefficients: &mut [S; K], mean: &[S]) {
    for (coefficient, &mean) in coefficients.iter_mut().zip(mean) {
        *coefficient -= mean;
    }
}

/// The sums of one pass of a transfer, for the orders from `FIRST` on, with `P` profiles of each
/// and `L` degrees. The rows of the pass start at `START`.
///
/// Not inlined: a compiler that sees single lanes being read splits the groups.
#[inline(never)]
pub fn pass<
    S: Scalar,
    const START: usize,
    const FIRST: isize,
    const P: usize,
    const L: usize,
    const N: usize,
>(
    transfer: &[S],
    light: &[S; N],
) -> [[S; LANES]; P] {
    let mut sums = [[S::ZERO; LANES]; P];
    let (groups, _) = transfer.get(START..).unwrap_or_default().as_chunks::<LANES>();
    let Some(rows) = groups.as_chunks::<P>().0.first_chunk::<L>() else { return sums };
    for (l, row) in (lowest_degree(FIRST)..).zip(rows) {
        let window = window(light, l, FIRST);
        for (sum, row) in sums.iter_mut().zip(row) {
            *sum = lanes::multiply_add(*sum, row, &window);
        }
    }
    sums
}

/// L_l^m for the orders from `first` on. Orders beyond l read other coefficients or zero, which
/// does no harm because their rows are zero.
#[inline(always)]
fn window<S: Scalar, const N: usize>(light: &[S; N], l: usize, first: isize) -> [S; LANES] {
    let start = position(l, first);
    if let Some(window) = light.get(start..).and_then(|rest| rest.first_chunk()) {
        return *window;
    }
    let at = |lane: usize| light.get(start.wrapping_add(lane)).copied().unwrap_or(S::ZERO);
    [at(0), at(1), at(2), at(3)]
}

/// L_l^m and (-1)^m L_l^-m for the `L` degrees l from m = `M` on.
#[inline(always)]
pub fn lights<S: Scalar, const M: usize, const L: usize, const N: usize>(
    light: &[S; N],
) -> [[S; 2]; L] {
    let mut lights = [[S::ZERO; 2]; L];
    let order = M.cast_signed();
    let at = |place: usize| light.get(place).copied().unwrap_or(S::ZERO);
    for (l, lights) in (M..).zip(&mut lights) {
        let minus = at(position(l, -order));
        *lights = [at(position(l, order)), if M % 2 == 1 { -minus } else { minus }];
    }
    lights
}

/// The components of two profiles of azimuth `M`, for +m and for -m, before the sum across the
/// lanes.
///
/// The rows have `V` groups, for `L` degrees. The factors start at `START` of `F` numbers, and the
/// scattered material has `D` rows. Not inlined, for the same reason as [`pass`].
#[inline(never)]
pub fn rows<
    S: Scalar,
    const START: usize,
    const M: usize,
    const V: usize,
    const L: usize,
    const D: usize,
    const F: usize,
>(
    factors: &[S; F],
    scattering: &[[[S; LANES]; V]; D],
    lights: &[[S; 2]; L],
) -> [[S; 2 * LANES]; 2] {
    let (groups, _) = factors.get(START..).unwrap_or_default().as_chunks();
    let factors = groups.as_chunks::<V>().0.first_chunk::<L>();
    let scattering = scattering.get(M..).and_then(|rows| rows.first_chunk::<L>());
    let mut sums = [[S::ZERO; 2 * LANES]; 2];
    let (Some(factors), Some(scattering)) = (factors, scattering) else { return sums };
    let [plus, minus] = &mut sums;
    for ((factors, scattering), &[of_plus, of_minus]) in factors.iter().zip(scattering).zip(lights)
    {
        let row = lanes::product(factors, scattering);
        *plus = lanes::multiply_add_two(*plus, &row, &[of_plus; LANES]);
        *minus = lanes::multiply_add_two(*minus, &row, &[of_minus; LANES]);
    }
    sums
}

/// [`rows`] for four profiles at once, with factors from `A` and from `B` on. The scattered
/// material is read only once.
#[inline(never)]
pub fn more_rows<
    S: Scalar,
    const A: usize,
    const B: usize,
    const M: usize,
    const V: usize,
    const L: usize,
    const D: usize,
    const F: usize,
>(
    factors: &[S; F],
    scattering: &[[[S; LANES]; V]; D],
    lights: &[[S; 2]; L],
) -> [[S; 2 * LANES]; 4] {
    let of = |start: usize| {
        let (groups, _) = factors.get(start..).unwrap_or_default().as_chunks();
        groups.as_chunks::<V>().0.first_chunk::<L>()
    };
    let scattering = scattering.get(M..).and_then(|rows| rows.first_chunk::<L>());
    let mut sums = [[S::ZERO; 2 * LANES]; 4];
    let (Some(a), Some(b), Some(scattering)) = (of(A), of(B), scattering) else { return sums };
    let [a_plus, a_minus, b_plus, b_minus] = &mut sums;
    let rows = a.iter().zip(b).zip(scattering).zip(lights);
    for (((a, b), scattering), &[plus, minus]) in rows {
        let (a, b) = (lanes::product(a, scattering), lanes::product(b, scattering));
        *a_plus = lanes::multiply_add_two(*a_plus, &a, &[plus; LANES]);
        *a_minus = lanes::multiply_add_two(*a_minus, &a, &[minus; LANES]);
        *b_plus = lanes::multiply_add_two(*b_plus, &b, &[plus; LANES]);
        *b_minus = lanes::multiply_add_two(*b_minus, &b, &[minus; LANES]);
    }
    sums
}

/// The sum across the lanes of the first profile.
#[inline(always)]
pub fn first<S: Scalar>(lanes: [S; 2 * LANES]) -> S {
    let [first, _] = lanes::sums(lanes);
    first
}

/// The sum across the lanes of the second profile.
#[inline(always)]
pub fn second<S: Scalar>(lanes: [S; 2 * LANES]) -> S {
    let [_, second] = lanes::sums(lanes);
    second
}
