//! Turns light in integers about the view axis.

use super::arithmetic::{BITS, product, truncated};
use super::rotation::{multiples, unit};
use super::{Light, LightBuffer, Q15};
use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::turn::swing_twist::Multiples;
use crate::turn::twist::{self, Twist};

impl Light<'_> {
    /// This light after a rotation about the view axis z, from x toward y, by the angle along
    /// (cosine, sine): [`turned`](Self::turned) at a fraction of its cost. Cosine and sine are
    /// integers of any scale; as fractions of 2^30 they cost neither a root nor a division.
    ///
    /// The exponent stays the same, unless a coefficient needs one bit more. A coefficient is off by
    /// at most one and a half units of the result's mantissas, and the share of its degree's energy that
    /// [`turned`](Self::turned) states.
    ///
    /// ```
    /// use eigenshade::Q15;
    /// use eigenshade::q15::Light;
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
    /// As [`turned`](Self::turned), but [`Error::Beyond`] if the degree is above 12;
    /// [`Error::Rotation`] if cosine and sine are 0.
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [i32; 2],
    ) -> Result<LightBuffer<N>, Error> {
        let mut turned = LightBuffer::default();
        self.turn_about_view_into(angle, &mut turned)?;
        Ok(turned)
    }

    /// [`turned_about_view`](Self::turned_about_view) into an existing buffer, without moving it.
    ///
    /// # Errors
    ///
    /// As [`turned_about_view`](Self::turned_about_view); `turned` is then left unspecified.
    pub fn turn_about_view_into<const N: usize>(
        &self,
        angle: [i32; 2],
        turned: &mut LightBuffer<N>,
    ) -> Result<(), Error> {
        turn([(self, turned)], angle)
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::turned_about_view`] in each channel.
    ///
    /// # Errors
    ///
    /// As [`Light::turned_about_view`].
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [i32; 2],
    ) -> Result<Rgb<LightBuffer<N>>, Error> {
        let mut turned = Rgb::default();
        self.turn_about_view_into(angle, &mut turned)?;
        Ok(turned)
    }

    /// [`turned_about_view`](Self::turned_about_view) into existing buffers, without moving them.
    ///
    /// # Errors
    ///
    /// As [`turned_about_view`](Self::turned_about_view); `turned` is then left unspecified.
    pub fn turn_about_view_into<const N: usize>(
        &self,
        angle: [i32; 2],
        turned: &mut Rgb<LightBuffer<N>>,
    ) -> Result<(), Error> {
        let Rgb { r, g, b } = turned;
        turn([(&self.r, r), (&self.g, g), (&self.b, b)], angle)
    }
}

fn turn<const C: usize, const N: usize>(
    lights: [(&Light<'_>, &mut LightBuffer<N>); C],
    angle: [i32; 2],
) -> Result<(), Error> {
    let degree = lights.iter().map(|(light, _)| light.degree).max().unwrap_or_default();
    Error::check_degree(degree)?;
    let mut multiples = multiples(fraction(angle).ok_or(Error::Rotation)?, degree);
    for [cosine, _] in &mut multiples {
        *cosine += 1 << (BITS - 1);
    }
    for (light, to) in lights {
        to.exponent = light.exponent + i32::from(!turn_one(light, &multiples, &mut to.mantissas)?);
        if to.exponent > 128 {
            return Err(Error::Exponent);
        }
    }
    Ok(())
}

/// An angle's cosine and sine in fractions of 2^30; none if both are 0.
fn fraction(angle: [i32; 2]) -> Option<[i32; 2]> {
    let [x, y] = angle.map(|number| u64::from(number.unsigned_abs()));
    // Such fractions already, rounded: cosine² + sine² is 2^60 to within 2^30.5.
    if (x * x + y * y).abs_diff(1 << 60) < 1 << 31 {
        return Some(angle);
    }
    let [cosine, sine] = angle;
    unit(cosine.into(), sine.into())
}

/// Turns a light. A coefficient may grow by √2. If it then has too many bits, all are halved, and
/// `false` is returned.
fn turn_one<const N: usize>(
    light: &Light<'_>,
    multiples: &Multiples<i32>,
    turned: &mut Buffer<Q15, N>,
) -> Result<bool, Error> {
    let whole = <&[Q15; N]>::try_from(light.mantissas).ok();
    if let (Some(from), Some(turned)) = (whole, turned.filled()) {
        if turn_all(from, multiples, turned) {
            return Ok(true);
        }
    } else {
        *turned = zeros(Argument::Light, light.mantissas.len())?;
        if turn_in_loops(light, multiples, turned, false) {
            return Ok(true);
        }
    }
    turn_in_loops(light, multiples, turned, true);
    Ok(false)
}

/// Turns a light whose degree is a constant. Returns whether all numbers fit.
#[inline(never)]
fn turn_all<const N: usize>(
    from: &[Q15; N],
    multiples: &Multiples<i32>,
    turned: &mut [Q15; N],
) -> bool {
    // In a register: a constant would take an addition of its own.
    let half = core::hint::black_box(HALF);
    twist::turn_unrolled(Integers { multiples, half, halves: false }, from, turned)
}

/// The same for a degree that is known at run time, and for halved numbers, which fit.
#[inline(never)]
fn turn_in_loops(
    light: &Light<'_>,
    multiples: &Multiples<i32>,
    turned: &mut [Q15],
    halves: bool,
) -> bool {
    let twist = Integers { multiples, half: HALF, halves };
    twist::turn(twist, light.degree, light.mantissas, turned)
}

/// Half a unit of a product.
const HALF: i32 = 1 << (BITS - 2);

/// A twist of mantissas, or of their halves.
struct Integers<'a> {
    multiples: &'a Multiples<i32>,
    half: i32,
    halves: bool,
}

impl Twist for Integers<'_> {
    type Coefficient = Q15;
    type Factor = [i32; 2];
    #[inline(always)]
    fn zonal(&self, mantissa: Q15) -> Q15 {
        truncated(self.number(mantissa))
    }
    #[inline(always)]
    fn factor(&mut self, m: usize) -> [i32; 2] {
        self.multiples.get(m - 1).copied().unwrap_or_default()
    }
    #[inline(always)]
    fn pair(&self, [c, s]: [i32; 2], pair: [Q15; 2]) -> ([Q15; 2], bool) {
        let [x, y] = pair.map(|mantissa| self.number(mantissa));
        let sums = [product(x, c) - product(y, s), product(y, c) + product(x, s)];
        let [x, y] = sums.map(|sum| (self.half + sum) >> (BITS - 1));
        let [a, b] = [x, y].map(|number| number.wrapping_add(1 << BITS).cast_unsigned());
        ([truncated(x), truncated(y)], (a | b) >> (BITS + 1) == 0)
    }
}

impl Integers<'_> {
    /// A mantissa as an integer, or half of it, rounded.
    #[inline(always)]
    fn number(&self, mantissa: Q15) -> i32 {
        let number = mantissa.get();
        if self.halves { (number >> 1) + (number & 1) } else { number }
    }
}
