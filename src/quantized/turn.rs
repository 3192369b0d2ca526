//! Turns light in integers.

use super::inputs::LEAST_TOP;
use super::{Light, Rotation};
use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::format::{FixedPoint, Wide as _};
use crate::index::light;
use crate::invariant::part_mut;
use crate::turn::{Arithmetic, Degree, LARGEST};
use core::marker::PhantomData;

/// The coefficients of a modified light, in a buffer of fixed capacity.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LightBuffer<Q, const N: usize> {
    pub(super) exponent: i32,
    pub(super) mantissas: Buffer<Q, N>,
}

impl<Q, const N: usize> LightBuffer<Q, N> {
    /// The light.
    ///
    /// # Errors
    ///
    /// Those of [`Light::new`].
    pub fn light(&self) -> Result<Light<'_, Q>, Error> {
        Light::new(self.exponent, &self.mantissas)
    }
}

impl<Q, const N: usize> Rgb<LightBuffer<Q, N>> {
    /// The lights in these buffers.
    ///
    /// # Errors
    ///
    /// Those of [`Light::new`].
    pub fn lights(&self) -> Result<Rgb<Light<'_, Q>>, Error> {
        self.each_ref().try_map(LightBuffer::light)
    }
}

impl<Q: FixedPoint> Light<'_, Q> {
    /// This light after rotation, to degree 12: L'(Rω) = L(ω). The result has an exponent of its
    /// own, so that no mantissa wraps or saturates.
    ///
    /// A coefficient of degree l is off by at most half a unit of the result's mantissas and, in
    /// [`Q15`](crate::Q15), 2^-12 of the root of the energy of its degree; 2^-25 in
    /// [`Q31`](crate::Q31).
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is below (degree + 1)², [`Error::Degree`] if the degree is above
    /// 12, [`Error::Exponent`] if the exponent of the result is above 128.
    pub fn turned<const N: usize>(&self, rotation: &Rotation) -> Result<LightBuffer<Q, N>, Error> {
        turned([*self], rotation).map(|[turned]| turned)
    }
}

impl<Q: FixedPoint> Rgb<Light<'_, Q>> {
    /// [`Light::turned`] in each channel, at less than three times its cost.
    ///
    /// # Errors
    ///
    /// The same.
    pub fn turned<const N: usize>(
        &self,
        rotation: &Rotation,
    ) -> Result<Rgb<LightBuffer<Q, N>>, Error> {
        turned((*self).into(), rotation).map(Rgb::from)
    }
}

/// The arithmetic of an integer format. Numbers are scaled so that the root of the energy of a
/// degree has [`number_bits`] bits; no sum of products then leaves its accumulator.
pub(super) struct Integers<Q>(PhantomData<Q>);

impl<Q: FixedPoint> Arithmetic for Integers<Q> {
    type Number = i32;
    type Factor = i32;
    type Element = Q;
    type Sum = Q::Wide;
    #[inline(always)]
    fn product([c, s]: [i32; 2], [x, y]: [i32; 2]) -> [i32; 2] {
        let minus = Q::product(y, s).wrapping_minus();
        [
            Q::sum(Q::product(x, c).wrapping_plus(minus)),
            Q::sum(Q::product(y, c).wrapping_plus(Q::product(x, s))),
        ]
    }
    #[inline(always)]
    fn add_product(sum: Q::Wide, element: Q, number: i32) -> Q::Wide {
        sum.wrapping_plus(element.times(number))
    }
    #[inline(always)]
    fn number(sum: Q::Wide) -> i32 {
        Q::whole(sum.wrapping_plus(Q::Wide::of(1 << (Q::BITS - 1))))
    }
}

/// Bits of the root of a degree's energy. What a small swing changes has up to twice that size.
const fn number_bits<Q: FixedPoint>() -> i32 {
    if Q::BITS < 30 { Q::BITS.cast_signed() } else { 30 }
}

/// The exponents of the degrees of a light.
type Exponents = [i32; LARGEST + 1];

fn turned<Q: FixedPoint, const C: usize, const N: usize>(
    lights: [Light<'_, Q>; C],
    rotation: &Rotation,
) -> Result<[LightBuffer<Q, N>; C], Error> {
    let mut turned = [(); C].map(|()| LightBuffer::default());
    let mut exponents: [Exponents; C] = lights.map(|light| [light.exponent; LARGEST + 1]);
    for (to, light) in turned.iter_mut().zip(&lights) {
        if light.degree > LARGEST {
            return Err(Error::Degree { found: light.degree });
        }
        to.mantissas = zeros(Argument::Light, light.mantissas.len())?;
        if let (Some(to), Some(&mean)) = (to.mantissas.first_mut(), light.mantissas.first()) {
            *to = mean;
        }
    }
    let degree = lights.iter().map(|light| light.degree).max().unwrap_or_default();
    let (rotation, mut elements) = (rotation.turn::<Q>(degree), Q::EXCHANGE);
    let mut numbers = [(); 3].map(|()| Degree::<Integers<Q>, C>::new());
    for l in 1..=degree {
        let range = light::count(l - 1)..light::count(l);
        let [of_degree, ..] = &mut numbers;
        let channels = lights.iter().zip(&mut exponents).enumerate();
        for (channel, (light, exponents)) in channels {
            // A light of a lower degree has none.
            let from = light.mantissas.get(range.clone()).unwrap_or_default();
            let shift = number_bits::<Q>() - size(from);
            let shifted = Shift::by(shift);
            of_degree.load(channel, from, |mantissa| shifted.of(whole(mantissa)));
            if let Some(exponent) = exponents.get_mut(l) {
                *exponent -= shift;
            }
        }
        rotation.apply(l, &mut elements, &mut numbers);
        let [of_degree, ..] = &mut numbers;
        for (channel, to) in turned.iter_mut().enumerate() {
            let to = to.mantissas.get_mut(range.clone()).unwrap_or_default();
            of_degree.store(channel, to, |number| Q::saturate(Q::Wide::of(number)));
        }
    }
    for ((to, light), exponents) in turned.iter_mut().zip(&lights).zip(&exponents) {
        to.exponent = align(&mut to.mantissas, light.degree, exponents)?;
    }
    Ok(turned)
}

#[inline(always)]
pub(super) fn whole<Q: FixedPoint>(mantissa: Q) -> i32 {
    mantissa.widen().saturated()
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
fn bits<Q: FixedPoint>(mantissas: &[Q]) -> i32 {
    let all = mantissas.iter().fold(0, |all, &mantissa| all | whole(mantissa).unsigned_abs());
    32 - all.leading_zeros().cast_signed()
}

/// Bits of the root of the energy of these mantissas, from above and with a margin of a 128th.
#[inline(never)]
fn size<Q: FixedPoint>(mantissas: &[Q]) -> i32 {
    // 13 bits of the largest, rounded up: the squares of 25 orders sum to less than 2^31.
    let shift = (bits(mantissas) - 13).max(0);
    let energy = mantissas.iter().fold(0, |energy: u32, &mantissa| {
        let size = (whole(mantissa).unsigned_abs() >> shift) + 1;
        energy + size * size
    });
    let bits = 32 - (energy + (energy >> 6)).leading_zeros();
    shift + bits.div_ceil(2).cast_signed()
}

/// Brings the mantissas of all degrees to a common exponent.
#[inline(never)]
fn align<Q: FixedPoint>(
    mantissas: &mut [Q],
    degree: usize,
    exponents: &Exponents,
) -> Result<i32, Error> {
    let range = |l: usize| l * l..light::count(l);
    let mut top = LEAST_TOP;
    for (l, exponent) in exponents.iter().enumerate().take(degree + 1) {
        let bits = bits(part_mut(mantissas, range(l)));
        if bits > 0 {
            top = top.max(bits + exponent);
        }
    }
    let common = top - Q::BITS.cast_signed();
    if common > 128 {
        return Err(Error::Exponent);
    }
    for (l, exponent) in exponents.iter().enumerate().take(degree + 1) {
        let shift = Shift::by(exponent - common);
        for mantissa in part_mut(mantissas, range(l)) {
            *mantissa = Q::saturate(Q::Wide::of(shift.of(whole(*mantissa))));
        }
    }
    Ok(common)
}
