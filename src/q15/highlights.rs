//! The reflections of small sources in fixed point: the formula of [`crate::Highlights`] in
//! integers.

use super::arithmetic::{Shift as _, saturated};
use super::inputs::decoded;
use super::tabulated::{leading, reciprocal, root};
use super::{Normal, Q15};
use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use core::fmt::Debug;
use sealed::Sealed;

/// The reflections of up to `N` small sources on a glossy material, by the formula of
/// [`crate::Highlights`]. `T` is `i32` for one channel or `Rgb<i32>` for three.
///
/// The reflections are in units of 2^exponent, with the exponents of the scene to which they are
/// added, one for each channel. A pixel uses integers of 32 bits only, so its bits are the same on
/// every machine.
///
/// ```
/// # #[cfg(feature = "presets")] {
/// use eigenshade::presets::{light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT};
/// use eigenshade::q15::{self, Normal};
/// use eigenshade::{Gloss, Highlights, Rgb, Source, sphere};
///
/// let lamp = Source::new([0.0, 0.6, 0.8], [0.5; 3], 0.03)?;
/// let gloss = Gloss::metallic_roughness([1.0, 0.78, 0.34], 1.0, 0.3)?;
/// let in_floats = Highlights::<1>::new(&gloss, &[lamp])?;
///
/// let scene = sphere::q15::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
/// let exponents = scene.each_ref().map(|channel| channel.exponent());
/// let highlights = q15::Highlights::<Rgb<i32>, 1>::quantize(&in_floats, exponents)?;
///
/// // Half-way between lamp and camera.
/// let normal = Normal::new(0, 316, 949)?;
/// let rest = scene.shade(normal);
/// let color = highlights.add(rest, normal);
/// assert!(color.r > 2 * rest.r);
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Highlights<T, const N: usize> {
    exponent: T,
    alpha_square: u32,
    lobes: Buffer<Lobe<T>, N>,
}

/// The constants of one source, for [`Highlights::stored`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lobe<T> {
    /// The upper triangle R of Q = Rᵀ R, row by row, in units of 2^(k - 16), to 2^16.
    pub form: [i32; 6],
    /// The direction in units of 2^-15.
    pub direction: [i32; 3],
    /// E F / (4 π √det A): a mantissa from 0 to 2^14, exclusive.
    pub specular: T,
    /// The part of the shift from specular mantissa to irradiance that all normals share.
    pub specular_shift: T,
    /// E (1 - F) albedo / π: a mantissa from 0 to 2^14, exclusive.
    pub matte: T,
    /// The shift from the matte mantissa times the cosine to the irradiance.
    pub matte_shift: T,
}

/// The irradiance of one channel, `i32`, or of three, `Rgb<i32>`.
///
/// This trait is sealed.
pub trait Irradiance: Sealed + Copy + Debug + Default + PartialEq {
    /// These channels; in one channel, green.
    #[doc(hidden)]
    fn of(color: Rgb<i32>) -> Self;
    /// A function of each channel of both.
    #[doc(hidden)]
    fn with(self, other: Self, function: impl FnMut(i32, i32) -> i32) -> Self;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for i32 {}
    impl Sealed for crate::color::Rgb<i32> {}
}

impl Irradiance for i32 {
    #[inline(always)]
    fn of(color: Rgb<i32>) -> Self {
        color.g
    }
    #[inline(always)]
    fn with(self, other: Self, mut function: impl FnMut(i32, i32) -> i32) -> Self {
        function(self, other)
    }
}

impl Irradiance for Rgb<i32> {
    #[inline(always)]
    fn of(color: Self) -> Self {
        color
    }
    #[inline(always)]
    fn with(self, other: Self, mut function: impl FnMut(i32, i32) -> i32) -> Self {
        self.zip(other).map(|(a, b)| function(a, b))
    }
}

impl<T: Irradiance, const N: usize> Highlights<T, N> {
    /// The constants of `highlights` in integers, for a scene of this
    /// [`exponent`](super::Scene::exponent). A single channel has the energies, reflectance and
    /// albedo of green.
    ///
    /// Cost: some 20 operations in floats for each source.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if there are more than `N` sources.
    pub fn quantize<const M: usize>(
        highlights: &crate::Highlights<M>,
        exponent: T,
    ) -> Result<Self, Error> {
        let mut lobes = zeros::<Lobe<T>, N>(Argument::Sources, highlights.lobes.len())?;
        for (to, from) in lobes.iter_mut().zip(&highlights.lobes) {
            let bits = size(&from.form);
            let [specular, matte] = [&from.specular, &from.matte].map(|factor| {
                let parts = factor.map(mantissa);
                [T::of(parts.map(|[mantissa, _]| mantissa)), T::of(parts.map(|[_, of]| of))]
            });
            let shift = |of: T, by: i32| {
                exponent.with(of, |exponent, of| exponent.wrapping_sub(of).wrapping_add(by))
            };
            *to = Lobe {
                form: from.form.map(|number| fixed(number, 16 - bits)),
                direction: from.direction.map(|number| fixed(number, 15)),
                specular: specular[0],
                specular_shift: shift(specular[1], 4 * bits + 15),
                matte: matte[0],
                matte_shift: shift(matte[1], 15),
            };
        }
        let [half_square, _] = highlights.masking;
        let alpha_square = fixed(half_square, 31).cast_unsigned();
        Ok(Self { exponent, alpha_square, lobes })
    }

    /// Highlights of constants that were computed earlier: the results of
    /// [`exponent`](Self::exponent), [`alpha_square`](Self::alpha_square) and
    /// [`lobes`](Self::lobes). Machines without floats need no other constants. The irradiances are
    /// meaningless for any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if there are more than `N` sources.
    pub fn stored(exponent: T, alpha_square: u32, lobes: &[Lobe<T>]) -> Result<Self, Error> {
        let mut buffer = zeros::<Lobe<T>, N>(Argument::Sources, lobes.len())?;
        buffer.iter_mut().zip(lobes).for_each(|(to, from)| *to = *from);
        Ok(Self { exponent, alpha_square, lobes: buffer })
    }

    /// The same highlights, for a scene of another exponent.
    #[must_use]
    pub fn aligned(mut self, exponent: T) -> Self {
        let by = exponent.with(self.exponent, i32::wrapping_sub);
        for lobe in self.lobes.iter_mut() {
            lobe.specular_shift = lobe.specular_shift.with(by, i32::wrapping_add);
            lobe.matte_shift = lobe.matte_shift.with(by, i32::wrapping_add);
        }
        Self { exponent, ..self }
    }

    /// The exponent of each channel.
    #[must_use]
    pub const fn exponent(&self) -> T {
        self.exponent
    }

    /// α² in units of 2^-30.
    #[must_use]
    pub const fn alpha_square(&self) -> u32 {
        self.alpha_square
    }

    /// The constants of each source.
    #[must_use]
    pub fn lobes(&self) -> &[Lobe<T>] {
        &self.lobes
    }

    /// The irradiance of one normal by the sources alone, in units of 2^exponent, rounded down for
    /// each source and saturating.
    ///
    /// For an irradiance of 17 bits, the difference from the formula in exact arithmetic is at most
    /// 2 % of the peak for the least roughness, 1 % for 0.1, and 0.4 % from 0.2 on. The irradiance
    /// may be anything up to the peak where the formula jumps: where z is below 1/128 and the
    /// cosine to the source below 1/1024. Cost: a root by table, and for each source that the
    /// normal faces another root and a reciprocal: with two sources some 390 instructions on a
    /// Cortex-M0.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> T {
        self.add(T::default(), normal)
    }

    /// The irradiance of a scene of the highlights' exponent plus the irradiance of the sources.
    /// The sum saturates.
    // Not inlined, which leaves the registers to the polynomials of the scene.
    #[inline(never)]
    #[must_use]
    pub fn add(&self, irradiance: T, normal: Normal) -> T {
        let [x, y, z] = normal.components().map(Q15::get);
        let facing = masking(self.alpha_square, z);
        let mut sum = T::default();
        for lobe in &self.lobes {
            let cosine = products(lobe.direction, [x, y, z]) >> 15;
            if cosine <= 0 {
                continue;
            }
            let of_source = masking(self.alpha_square, cosine);
            let masked = product(cosine, facing).wrapping_add(product(z, of_source));
            let (weight, by) = weight(lobe.form([x, y, z]), masked);
            let cosine = cosine.cast_unsigned();
            let specular = lobe.specular.with(lobe.specular_shift, |mantissa, shift| {
                let number = (product(mantissa, cosine) >> 13).wrapping_mul(weight);
                scaled(number, shift.wrapping_sub(by))
            });
            let matte = lobe
                .matte
                .with(lobe.matte_shift, |mantissa, shift| scaled(product(mantissa, cosine), shift));
            sum = sum.with(specular, plus).with(matte, plus);
        }
        irradiance.with(sum, i32::saturating_add)
    }

    /// Adds the irradiance of each normal to `irradiance`: bit for bit [`add`](Self::add).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn add_slice(&self, normals: &[Normal], irradiance: &mut [T]) -> Result<(), Error> {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        for (irradiance, normal) in irradiance.iter_mut().zip(normals) {
            *irradiance = self.add(*irradiance, *normal);
        }
        Ok(())
    }
}

impl<T> Lobe<T> {
    /// nᵀ Q n in units of 2^(2k - 32): at least 2^16, and below 2^32, as [`size`] chooses k.
    #[inline(always)]
    fn form(&self, [x, y, z]: [i32; 3]) -> u32 {
        let [xx, xy, xz, yy, yz, zz] = self.form;
        let square = |row: i32| {
            let row = row >> 15;
            row.wrapping_mul(row).cast_unsigned()
        };
        let [first, second] = [products([xx, xy, xz], [x, y, z]), products([yy, yz], [y, z])];
        square(first).wrapping_add(square(second)).wrapping_add(square(zz.wrapping_mul(z)))
    }
}

/// The sum of products. It fits into 31 bits for a lobe that was quantized.
#[inline(always)]
fn products<const C: usize>(a: [i32; C], b: [i32; C]) -> i32 {
    a.into_iter().zip(b).fold(0, |sum, (a, b)| sum.wrapping_add(a.wrapping_mul(b)))
}

/// A product of a number that is at least 0.
#[inline(always)]
fn product(a: i32, b: u32) -> u32 {
    a.cast_unsigned().wrapping_mul(b)
}

/// The sum of two numbers that are at least 0.
#[inline(always)]
fn plus(a: i32, b: i32) -> i32 {
    let sum = a.wrapping_add(b);
    if sum < 0 { i32::MAX } else { sum }
}

/// `number` 2^-`shift`, rounded down; `number` is less than 2^31.
#[inline(always)]
fn scaled(number: u32, shift: i32) -> i32 {
    match number.checked_shr(shift.cast_unsigned()) {
        Some(number) => number.cast_signed(),
        None => far(number, shift),
    }
}

/// The same for a shift to the left, or by all bits.
#[cold]
#[inline(never)]
fn far(number: u32, shift: i32) -> i32 {
    let by = shift.wrapping_neg().cast_unsigned();
    match (number, shift) {
        (0, _) | (_, 0..) => 0,
        _ if by < number.leading_zeros() => (number << by).cast_signed(),
        _ => i32::MAX,
    }
}

/// √(α² + (1 - α²) c²) in units of 2^-15, for c in the same, at least 0, and α² in 2^-30.
#[inline(always)]
fn masking(alpha_square: u32, cosine: i32) -> u32 {
    let square = product(cosine, cosine.cast_unsigned());
    // At most 2^30 and a two-hundredth: a normal may be a two-thousandth too long.
    root(
        alpha_square
            .wrapping_add(square)
            .wrapping_sub((square >> 16).wrapping_mul(alpha_square >> 14)),
    )
}

/// 1 / (½ (nᵀ Q n)² m), where m = `masked` in 2^-30: a number of at most 16 bits, and the part of
/// its exponent that depends on the normal.
#[inline(always)]
fn weight(form: u32, masked: u32) -> (u32, i32) {
    // 16 bits of each, from 2^15 on; the square from 2^13 on; so the divisor from 2^28 on.
    let leads = [leading(form), leading(masked)];
    let form = (form << (leads[0] & 31)) >> 16;
    let masked = (masked << (leads[1] & 31)) >> 16;
    let divisor = (form.wrapping_mul(form) >> 17).wrapping_mul(masked);
    let by = leads[0] + leads[0] + leads[1];
    (reciprocal(divisor), by.cast_signed())
}

/// The least k such that nᵀ Q n is less than 4^k, with a margin of a hundredth for rounding and
/// normals that are a little too long. Q has the eigenvalue 1 and the eigenvalues of A⁻¹, which are
/// the roots of x² - tr x + det.
fn size(form: &[f32; 6]) -> i32 {
    let [xx, _, _, yy, _, zz] = *form;
    let trace = form.iter().fold(-1.0, |sum, number| sum + number * number);
    let root = xx * yy * zz;
    let mut most = 1.0 / 1.01_f32;
    for k in 0..8 {
        most *= 4.0;
        if most > 0.5 * trace && most * (most - trace) + root * root > 0.0 {
            return k + 1;
        }
    }
    8
}

/// A number in units of 2^-`bits`, rounded, of at most 31 bits.
fn fixed(number: f32, bits: i32) -> i32 {
    let (significand, exponent) = decoded(number);
    saturated(i64::from(significand).shifted((exponent + bits).min(32)))
}

/// The largest mantissa. Times the cosine of a normal that is a little too long, it is below 2^29.
const LARGEST: i32 = 16_372;

/// The mantissa of a number that is at least 0, of 13 to 14 bits, and its exponent.
fn mantissa(number: f32) -> [i32; 2] {
    let (significand, exponent) = decoded(number);
    match significand.shifted(-10) {
        ..=LARGEST => [significand.shifted(-10), exponent + 10],
        _ => [significand.shifted(-11), exponent + 11],
    }
}
