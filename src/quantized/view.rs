//! Turns light in integers about the view axis: a rotation of each pair of orders m and -m.

use super::rotation::{multiples, unit};
use super::turn::{Integers, whole};
use super::{Light, LightBuffer};
use crate::buffer::zeros;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::format::{FixedPoint, Wide as _};
use crate::index::light;
use crate::light::degree;
use crate::turn::view::unrolled;
use crate::turn::{Arithmetic as _, LARGEST, Multiples};

impl<Q: FixedPoint> Light<'_, Q> {
    /// This light after a rotation about the view axis z, from x toward y, by the angle along
    /// (cosine, sine), integers of any scale: [`turned`](Self::turned) at a fraction of its cost.
    ///
    /// The exponent stays the same, unless a coefficient needs one bit more; in
    /// [`Q31`](crate::Q31) it is always one more. A coefficient is off by at most one and a half
    /// units of the result's mantissas, and the share of its degree's energy that
    /// [`turned`](Self::turned) states.
    ///
    /// ```
    /// use eigenshade::Q15;
    /// use eigenshade::quantized::Light;
    ///
    /// let left = [28_672, 0, 0, 8_192].map(Q15); // the brightest side
    /// let light = Light::new(-13, &left)?;
    /// let turned = light.turned_about_view::<4>([0, 7])?; // now from below
    /// assert_eq!(turned.light()?.mantissas(), [28_672, 8_192, 0, 0].map(Q15));
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`turned`](Self::turned), and [`Error::Rotation`] if cosine and sine are 0.
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [i32; 2],
    ) -> Result<LightBuffer<Q, N>, Error> {
        let [turned] = turned([*self], angle)?;
        Ok(turned)
    }
}

impl<Q: FixedPoint> Rgb<Light<'_, Q>> {
    /// [`Light::turned_about_view`] in each channel.
    ///
    /// # Errors
    ///
    /// The same.
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [i32; 2],
    ) -> Result<Rgb<LightBuffer<Q, N>>, Error> {
        turned((*self).into(), angle).map(Rgb::from)
    }
}

/// Lights after rotation.
fn turned<Q: FixedPoint, const C: usize, const N: usize>(
    lights: [Light<'_, Q>; C],
    [cosine, sine]: [i32; 2],
) -> Result<[LightBuffer<Q, N>; C], Error> {
    let degree = lights.iter().map(|light| light.degree).max().unwrap_or_default();
    if degree > LARGEST {
        return Err(Error::Degree { found: degree });
    }
    let angle = unit(cosine.into(), sine.into()).ok_or(Error::Rotation)?;
    let mut multiples = multiples::<Q>(angle, degree);
    // The harmonics of odd m > 0 have the sign -1.
    multiples.iter_mut().step_by(2).for_each(|[_, sine]| *sine = -*sine);
    let mut turned = [(); C].map(|()| LightBuffer::default());
    for (to, light) in turned.iter_mut().zip(&lights) {
        to.mantissas = zeros(Argument::Light, light.mantissas.len())?;
        to.exponent = turn::<Q, N>(light, &multiples, &mut to.mantissas);
        if to.exponent > 128 {
            return Err(Error::Exponent);
        }
    }
    Ok(turned)
}

/// Turns a light and returns its exponent. A coefficient may grow by √2. If it then has too many
/// bits, all are halved; in 31 bits always, as no larger integer is at hand.
fn turn<Q: FixedPoint, const N: usize>(
    light: &Light<'_, Q>,
    multiples: &Multiples<i32>,
    turned: &mut [Q],
) -> i32 {
    let exact = (<&[Q; N]>::try_from(light.mantissas), <&mut [Q; N]>::try_from(&mut *turned));
    let fits = Q::BITS < 30
        && match exact {
            (Ok(from), Ok(turned)) => turn_all(from, multiples, turned),
            _ => turn_in_loops(light, multiples, turned, false),
        };
    if !fits {
        turn_in_loops(light, multiples, turned, true);
    }
    light.exponent + i32::from(!fits)
}

/// Turns a light whose degree is known when the program is compiled. Returns whether all numbers
/// fit.
#[inline(never)]
fn turn_all<Q: FixedPoint, const N: usize>(
    from: &[Q; N],
    multiples: &Multiples<i32>,
    turned: &mut [Q; N],
) -> bool {
    // No light has another length.
    let degree = const { if let Ok(degree) = degree(N) { degree } else { 0 } };
    let mut all = means(degree, from, turned, false);
    unrolled!(m in 1..=degree {
        {}
        l => all |= pair(m, l, multiples, from, turned, false)
    });
    fits::<Q>(all)
}

/// The same for a degree that is known at run time, and for halved numbers.
#[inline(never)]
fn turn_in_loops<Q: FixedPoint>(
    light: &Light<'_, Q>,
    multiples: &Multiples<i32>,
    turned: &mut [Q],
    halves: bool,
) -> bool {
    let mut all = means(light.degree, light.mantissas, turned, halves);
    for m in 1..=light.degree {
        for l in m..=light.degree {
            all |= pair(m, l, multiples, light.mantissas, turned, halves);
        }
    }
    fits::<Q>(all)
}

/// Copies the coefficients of order 0; returns their [`stored`] bits.
#[inline(always)]
fn means<Q: FixedPoint>(degree: usize, from: &[Q], turned: &mut [Q], halves: bool) -> i32 {
    (0..=degree).map(|l| light::position(l, 0)).fold(0, |all, place| {
        match (from.get(place), turned.get_mut(place)) {
            (Some(&mean), Some(to)) => all | stored(to, number(mean, halves)),
            _ => all,
        }
    })
}

/// Turns the orders -m and m of degree l; returns their [`stored`] bits.
#[inline(always)]
fn pair<Q: FixedPoint>(
    m: usize,
    l: usize,
    multiples: &Multiples<i32>,
    from: &[Q],
    turned: &mut [Q],
    halves: bool,
) -> i32 {
    let pair = light::position(l, -m.cast_signed())..=light::position(l, m.cast_signed());
    match (from.get(pair.clone()), turned.get_mut(pair), multiples.get(m - 1)) {
        (Some(&[minus, .., plus]), Some([to_minus, .., to_plus]), Some(&factor)) => {
            let [x, y] = [minus, plus].map(|mantissa| number(mantissa, halves));
            let [dx, dy] = Integers::<Q>::product(factor, [x, y]);
            // The changes alone may exceed 31 bits.
            stored(to_minus, x.wrapping_add(dx)) | stored(to_plus, y.wrapping_add(dy))
        }
        _ => 0,
    }
}

/// A mantissa as an integer, or half of it, rounded.
#[inline(always)]
fn number<Q: FixedPoint>(mantissa: Q, halves: bool) -> i32 {
    let number = whole(mantissa);
    if halves { (number >> 1) + (number & 1) } else { number }
}

/// Stores a number, and returns one that has bits beyond `BITS` unless it fits.
#[inline(always)]
fn stored<Q: FixedPoint>(to: &mut Q, number: i32) -> i32 {
    *to = Q::saturate(Q::Wide::of(number));
    number.wrapping_add(1 << Q::BITS)
}

/// Whether all numbers that were [`stored`] fit.
fn fits<Q: FixedPoint>(all: i32) -> bool {
    Q::BITS >= 30 || all.cast_unsigned() >> (Q::BITS + 1) == 0
}
