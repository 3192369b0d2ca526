//! Turns light in integers.

use super::arithmetic::{BITS, product, sum, times, whole};
use super::inputs::LEAST_TOP;
use super::{Light, Q15, Rotation};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::part_mut;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::light;
use crate::turn::exchange;
use crate::turn::swing_twist::{Arithmetic, Scales};
use core::mem::take;

/// The coefficients of a modified light, in a buffer of fixed capacity.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LightBuffer<const N: usize> {
    pub(super) exponent: i32,
    pub(super) mantissas: Buffer<Q15, N>,
}

impl<const N: usize> LightBuffer<N> {
    /// The light.
    ///
    /// # Errors
    ///
    /// As [`Light::new`].
    pub fn light(&self) -> Result<Light<'_>, Error> {
        Light::new(self.exponent, &self.mantissas)
    }
}

impl<const N: usize> Rgb<LightBuffer<N>> {
    /// The lights in these buffers.
    ///
    /// # Errors
    ///
    /// As [`Light::new`].
    pub fn lights(&self) -> Result<Rgb<Light<'_>>, Error> {
        self.each_ref().try_map(LightBuffer::light)
    }
}

impl Light<'_> {
    /// This light after rotation, to degree 16: L'(Rω) = L(ω). The result has an exponent of its
    /// own, so that no mantissa wraps or saturates.
    ///
    /// A coefficient of degree l is off by at most half a unit of the result's mantissas and
    /// 2^-12 of the root of the energy of its degree.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is below (degree + 1)², [`Error::Beyond`] if the degree is above
    /// 16, [`Error::Exponent`] if the exponent of the result is above 128.
    pub fn turned<const N: usize>(&self, rotation: &Rotation) -> Result<LightBuffer<N>, Error> {
        turned([*self], rotation).map(|[turned]| turned)
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::turned`] in each channel, at less than three times its cost.
    ///
    /// # Errors
    ///
    /// As [`Light::turned`].
    pub fn turned<const N: usize>(
        &self,
        rotation: &Rotation,
    ) -> Result<Rgb<LightBuffer<N>>, Error> {
        turned((*self).into(), rotation).map(Rgb::from)
    }

    /// [`turned`](Self::turned) into memory of the caller, which takes less stack: the mantissas of
    /// each light are the first ones of these. Returns the exponents.
    ///
    /// # Errors
    ///
    /// As [`turned`](Self::turned), where `N` is the number of mantissas. These are then left
    /// unspecified.
    #[inline]
    pub fn turn_into(
        &self,
        rotation: &Rotation,
        mantissas: Rgb<&mut [Q15]>,
    ) -> Result<Rgb<i32>, Error> {
        turn((*self).into(), rotation, mantissas.into()).map(Rgb::from)
    }
}

/// The arithmetic of integers. Numbers are scaled so that the root of the energy of a degree has
/// [`NUMBER_BITS`] bits; every sum of products then fits its accumulator.
struct Integers;

/// The matrices in fractions of 2^15.
#[expect(clippy::indexing_slicing, reason = "a constant has no iterators")]
static EXCHANGE: [Q15; exchange::ELEMENTS] = {
    let (mut elements, mut k) = ([Q15(0); exchange::ELEMENTS], 0);
    while k < exchange::ELEMENTS {
        let element = exchange::EXCHANGE[k] * 32_768.0;
        // A conversion truncates toward zero, and saturates.
        elements[k] = Q15(if element < 0.0 { element - 0.5 } else { element + 0.5 } as i16);
        k += 1;
    }
    elements
};

impl Arithmetic for Integers {
    type Coefficient = Q15;
    /// The power of two.
    type Scale = i32;
    type Number = i32;
    type Factor = i32;
    type Element = Q15;
    type Sum = i32;
    const EXCHANGE: &'static [Q15] = &EXCHANGE;
    #[inline(always)]
    fn scale(mantissas: &[Q15]) -> i32 {
        NUMBER_BITS - size(mantissas)
    }
    #[inline(always)]
    fn scaled(scale: i32) -> impl Fn(Q15) -> i32 {
        let shift = Shift::by(scale);
        move |mantissa| shift.of(mantissa.get())
    }
    #[inline(always)]
    fn coefficient(number: i32) -> Q15 {
        Q15::saturate(number)
    }
    #[inline(always)]
    fn product([c, s]: [i32; 2], [x, y]: [i32; 2]) -> [i32; 2] {
        let minus = product(y, s).wrapping_neg();
        [sum(product(x, c).wrapping_add(minus)), sum(product(y, c).wrapping_add(product(x, s)))]
    }
    #[inline(always)]
    fn add_product(sum: i32, element: Q15, number: i32) -> i32 {
        sum.wrapping_add(times(element, number))
    }
    #[inline(always)]
    fn number(sum: i32) -> i32 {
        whole(sum.wrapping_add(1 << (BITS - 1)))
    }
}

/// Bits of the root of a degree's energy. What a small swing changes has up to twice that size.
const NUMBER_BITS: i32 = BITS.cast_signed();

fn turned<const C: usize, const N: usize>(
    lights: [Light<'_>; C],
    rotation: &Rotation,
) -> Result<[LightBuffer<N>; C], Error> {
    let mut turned = [(); C].map(|()| LightBuffer::default());
    for (to, light) in turned.iter_mut().zip(&lights) {
        Error::check_turned(light.degree)?;
        to.mantissas = zeros(Argument::Light, light.mantissas.len())?;
    }
    let mantissas = turned.each_mut().map(|to| to.mantissas.as_mut_slice());
    let exponents = turn(lights, rotation, mantissas)?;
    turned.iter_mut().zip(exponents).for_each(|(to, exponent)| to.exponent = exponent);
    Ok(turned)
}

/// Turns lights into the first ones of these mantissas. Returns the exponents.
fn turn<const C: usize>(
    lights: [Light<'_>; C],
    rotation: &Rotation,
    mut turned: [&mut [Q15]; C],
) -> Result<[i32; C], Error> {
    for (to, light) in turned.iter_mut().zip(&lights) {
        Error::check_turned(light.degree)?;
        let (needed, capacity) = (light.mantissas.len(), to.len());
        let error = Error::Capacity { argument: Argument::Light, needed, capacity };
        *to = take(to).get_mut(..needed).ok_or(error)?;
    }
    let degree = lights.iter().map(|light| light.degree).max().unwrap_or_default();
    let mut scales = [Scales::default(); C];
    rotation.swing_twist(degree).turn::<Integers, C>(
        degree,
        lights.map(|light| light.mantissas),
        turned.each_mut().map(|to| &mut **to),
        &mut scales,
    );
    let mut exponents = [0; C];
    let channels = turned.into_iter().zip(&lights).zip(&scales);
    for (exponent, ((to, light), scales)) in exponents.iter_mut().zip(channels) {
        *exponent = align(to, light, scales)?;
    }
    Ok(exponents)
}

/// A product with a power of two, rounded.
#[derive(Clone, Copy)]
struct Shift {
    left: u32,
    right: u32,
    half: i32,
}

impl Shift {
    fn by(by: i32) -> Self {
        let left = by.clamp(0, 31).unsigned_abs();
        let right = by.clamp(-31, 0).unsigned_abs();
        Self { left, right, half: (1 << right) >> 1 }
    }

    /// Domain: it fits.
    #[inline(always)]
    fn of(self, number: i32) -> i32 {
        (number << self.left).saturating_add(self.half) >> self.right
    }
}

/// Bits of the largest magnitude.
fn bits(mantissas: &[Q15]) -> i32 {
    let all = mantissas.iter().fold(0, |all, &mantissa| all | mantissa.get().unsigned_abs());
    32 - all.leading_zeros().cast_signed()
}

/// Bits of the root of the energy of these mantissas, from above and with a margin of a 128th.
#[inline(never)]
fn size(mantissas: &[Q15]) -> i32 {
    // 13 bits of the largest, rounded up: the squares of 25 orders sum to less than 2^31.
    let shift = (bits(mantissas) - 13).max(0);
    let energy = mantissas.iter().fold(0, |energy: u32, &mantissa| {
        let size = (mantissa.get().unsigned_abs() >> shift) + 1;
        energy + size * size
    });
    let bits = 32 - (energy + (energy >> 6)).leading_zeros();
    shift + bits.div_ceil(2).cast_signed()
}

/// Brings the mantissas of all degrees to a common exponent.
#[inline(never)]
fn align(mantissas: &mut [Q15], light: &Light<'_>, scales: &Scales<i32>) -> Result<i32, Error> {
    let exponents = || scales.iter().take(light.degree + 1).map(|scale| light.exponent - scale);
    let range = |l: usize| l * l..light::count(l);
    let mut top = LEAST_TOP;
    for (l, exponent) in exponents().enumerate() {
        let bits = bits(part_mut(mantissas, range(l)));
        if bits > 0 {
            top = top.max(bits + exponent);
        }
    }
    let common = top - BITS.cast_signed();
    if common > 128 {
        return Err(Error::Exponent);
    }
    for (l, exponent) in exponents().enumerate() {
        let shift = Shift::by(exponent - common);
        for mantissa in part_mut(mantissas, range(l)) {
            *mantissa = Q15::saturate(shift.of(mantissa.get()));
        }
    }
    Ok(common)
}
