//! Shades a normal: the sum of the profile polynomials, azimuth by azimuth.
//!
//! A polynomial has an even and an odd half, Σ_k (a_k + b_k t) u^k in t = 2z - 1 and u = 2t² - 1,
//! evaluated by Horner's rule in u. The terms are in the order ..., b_1, a_1, b_0, a_0, so with an
//! odd number of them the first has no odd partner. A term costs as much as in powers of t, but only
//! half as many powers cancel.

pub(crate) mod mirrored;
mod negative;
pub(crate) mod slice;

pub use negative::NegativePolicy;

use crate::basis::Basis;
use crate::checked_slice::{part, split};
use crate::color::Rgb;
use crate::float;
use crate::known_table::{KnownTable, at};
use crate::normal::Normal;
use crate::scene::{Descent, Scene};

/// Whether blocks are inlined and many: on targets where code may be large.
const LARGE: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

impl<B> Scene<'_, B> {
    /// The irradiance of one normal, in the unit of the light's radiance times steradian times the
    /// material's 1/sr.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> f32
    where
        B: AsRef<[f32]>,
    {
        let Normal { x, y, z } = normal;
        let [irradiance] = block(self.descent(), &[x], &[y], &[z]);
        irradiance
    }
}

impl<C> Rgb<Scene<'_, C>> {
    /// [`Scene::shade`] in each channel.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> Rgb<f32>
    where
        C: AsRef<[f32]>,
    {
        self.each_ref().map(|scene| scene.shade(normal))
    }
}

/// The irradiances of a block of normals: Re Σ_m (P_m + i Q_m) w̄^m with w = n_x + i n_y, by
/// Horner's rule from the highest azimuth down.
#[inline(always)]
pub(crate) fn block<const N: usize>(
    mut polynomials: Descent<'_>,
    x: &[f32; N],
    y: &[f32; N],
    z: &[f32; N],
) -> [f32; N] {
    let block = Block::new([x, y, z]);
    let Some((plus, minus)) = polynomials.next() else {
        return block.values(polynomials.pole);
    };
    let mut above = [block.values(plus), block.values(minus)];
    for (plus, minus) in polynomials.by_ref() {
        above = block.azimuth(plus, minus, Some(above));
    }
    block.pole(polynomials.pole, Some(above))
}

/// A block of normals, with the arguments of the polynomials.
#[derive(Clone, Copy, Debug)]
pub struct Block<'n, const N: usize> {
    x: &'n [f32; N],
    y: &'n [f32; N],
    t: [f32; N],
    u: [f32; N],
}

impl<'n, const N: usize> Block<'n, N> {
    /// The block of these normals, axis by axis.
    #[inline(always)]
    #[must_use]
    pub fn new([x, y, z]: [&'n [f32; N]; 3]) -> Self {
        let t = if LARGE { vectorized(z) } else { z.map(argument) };
        let mut u = t;
        for u in &mut u {
            *u = doubled(*u);
        }
        Self { x, y, t, u }
    }

    /// The values of a polynomial.
    #[inline(always)]
    fn values(&self, terms: &[f32]) -> [f32; N] {
        values(terms, [&self.t, &self.u])
    }

    /// P_m + i Q_m + w̄ `above`, from the polynomials of +m and of -m. The highest azimuth has
    /// nothing above it.
    #[inline(always)]
    #[must_use]
    pub fn azimuth(
        &self,
        plus: &[f32],
        minus: &[f32],
        above: Option<[[f32; N]; 2]>,
    ) -> [[f32; N]; 2] {
        let here = [self.values(plus), self.values(minus)];
        let Some([mut real, mut imaginary]) = above else { return here };
        descend([&mut real, &mut imaginary], here, [self.x, self.y]);
        [real, imaginary]
    }

    /// P_0 + Re w̄ `above`.
    #[inline(always)]
    #[must_use]
    pub fn pole(&self, terms: &[f32], above: Option<[[f32; N]; 2]>) -> [f32; N] {
        let mut sums = self.values(terms);
        let Some([real, imaginary]) = above else { return sums };
        let above = real.iter().zip(&imaginary).zip(self.x.iter().zip(self.y));
        for (sum, ((&real, &imaginary), (&x, &y))) in sums.iter_mut().zip(above) {
            *sum = float::add_product(float::add_product(*sum, real, x), imaginary, y);
        }
        sums
    }
}

/// The argument t of each normal. A loop, because `map` may become a call.
#[inline(always)]
fn vectorized<const N: usize>(z: &[f32; N]) -> [f32; N] {
    let mut t = [0.0; N];
    for (t, &z) in t.iter_mut().zip(z) {
        *t = argument(z);
    }
    t
}

/// [`Block::azimuth`] of azimuth `M` > 0 of a scene of `B`.
#[inline(always)]
pub fn azimuth<B: KnownTable<Basis<'static>>, const M: usize, const N: usize>(
    terms: &[f32; N],
    pixel: &Block<'_, 1>,
    above: Option<[[f32; 1]; 2]>,
) -> Option<[[f32; 1]; 2]> {
    let length = const { B::BASIS.length(M) };
    let start = const { at(B::BASIS.parts.azimuths, M).start as usize };
    let [plus, minus] = [start, start + length].map(|start| part(terms, start..start + length));
    Some(pixel.azimuth(plus, minus, above))
}

/// The irradiance: [`Block::pole`] of a scene of `B`.
#[inline(always)]
pub fn pole<B: KnownTable<Basis<'static>>, const N: usize>(
    terms: &[f32; N],
    pixel: &Block<'_, 1>,
    above: Option<[[f32; 1]; 2]>,
) -> f32 {
    let [irradiance] = pixel.pole(part(terms, ..const { B::BASIS.length(0) }), above);
    irradiance
}

/// The argument t = 2z - 1 of the profile polynomials.
#[inline]
pub(crate) fn argument(z: f32) -> f32 {
    z + z - 1.0
}

/// The argument u = 2t² - 1 = T_2(t).
#[inline(always)]
pub(crate) fn doubled(t: f32) -> f32 {
    float::add_product(-1.0, t + t, t)
}

/// The value of a polynomial.
#[inline]
pub(crate) fn value(terms: &[f32], t: f32) -> f32 {
    let [value] = values(terms, [&[t], &[doubled(t)]]);
    value
}

/// The values of a polynomial at a block of arguments t and u.
#[inline(always)]
pub(crate) fn values<const N: usize>(terms: &[f32], [t, u]: [&[f32; N]; 2]) -> [f32; N] {
    // In a block, an even number of terms begins with zero: with its first two, x86-64 takes more
    // instructions.
    let (mut sums, rest) = match terms {
        [odd, even, rest @ ..] if N == 1 && rest.len().is_multiple_of(2) => {
            (t.map(|t| float::add_product(*even, *odd, t)), rest)
        }
        _ => {
            let (alone, rest) = split(terms, terms.len() % 2);
            ([alone.first().copied().unwrap_or(0.0); N], rest)
        }
    };
    for [odd, even] in rest.as_chunks().0 {
        horner([odd, even], &mut sums, [t, u]);
    }
    sums
}

/// A step of Horner's rule at a block of arguments t and u: each sum becomes
/// even + odd t + sum u.
#[inline(always)]
fn horner<const N: usize>([odd, even]: [&f32; 2], sums: &mut [f32; N], [t, u]: [&[f32; N]; 2]) {
    #[cfg(target_feature = "relaxed-simd")]
    {
        *sums = float::fused(float::fused([*even; N], &[*odd; N], t), sums, u);
    }
    #[cfg(not(target_feature = "relaxed-simd"))]
    for (sum, (&t, &u)) in sums.iter_mut().zip(t.iter().zip(u)) {
        *sum = float::add_product(float::add_product(*even, *odd, t), *sum, u);
    }
}

/// A step of Horner's rule in w̄ = x - i y at a block of normals: the sum above becomes
/// here + w̄ above. Real and imaginary parts.
#[inline(always)]
fn descend<const N: usize>(
    [real, imaginary]: [&mut [f32; N]; 2],
    [plus, minus]: [[f32; N]; 2],
    [x, y]: [&[f32; N]; 2],
) {
    // The steps with `fused`, a loop for each product.
    #[cfg(target_feature = "relaxed-simd")]
    {
        let plus = float::fused(plus, real, x);
        let plus = float::fused(plus, imaginary, y);
        for number in &mut *real {
            *number = -*number;
        }
        let minus = float::fused(minus, imaginary, x);
        (*real, *imaginary) = (plus, float::fused(minus, real, y));
    }
    #[cfg(not(target_feature = "relaxed-simd"))]
    {
        let above = real.iter_mut().zip(imaginary);
        let here = plus.iter().zip(&minus).zip(x.iter().zip(y));
        for ((real, imaginary), ((&plus, &minus), (&x, &y))) in above.zip(here) {
            (*real, *imaginary) = (
                float::add_product(float::add_product(plus, *real, x), *imaginary, y),
                float::add_product(float::add_product(minus, *imaginary, x), -*real, y),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::layout::MAX_TERMS;

    /// Compares with powers of t and of u = cos 2θ. The sums are below 100.
    #[test]
    fn values_are_the_sums_that_they_stand_for() {
        let all: [f32; MAX_TERMS] =
            core::array::from_fn(|k| (((7 * k) % 19) as f32 - 9.0) / (1 + k % 5) as f32);
        for length in [0, 1, 2, 3, 16, 17, MAX_TERMS] {
            let terms = all.get(..length).unwrap_or_default();
            for angle in [0.0, 0.3, 1.2, 1.6, 2.5, core::f64::consts::PI] {
                let (t, u) = (libm::cos(angle), libm::cos(2.0 * angle));
                let element = |k: usize| {
                    let even = libm::pow(u, (k / 2) as f64);
                    if k.is_multiple_of(2) { even } else { t * even }
                };
                let terms_of_rising_k = terms.iter().rev().enumerate();
                let sum: f64 =
                    terms_of_rising_k.map(|(k, &term)| f64::from(term) * element(k)).sum();
                let t = t as f32;
                let found = value(terms, t);
                assert!(
                    (f64::from(found) - sum).abs() < 2e-4,
                    "{length} at {angle}: {found}, {sum}"
                );
                let at = [&[t; 2], &[doubled(t); 2]];
                assert_eq!(values(terms, at), [found; 2]);
            }
        }
    }
}
