//! The coefficients of an object with shadows under a light.

use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::shadowed::MOST_RANK;
use crate::light::Light;
use crate::q15;
use crate::shadowed::{ShadowedObject, row_bytes};

/// The coefficients d of one channel: mantissas times a power of two.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ObjectCoefficients {
    pub(crate) mantissas: [i16; MOST_RANK],
    pub(crate) exponent: i32,
}

impl ShadowedObject<'_> {
    /// d of a light on the object's material.
    ///
    /// Cost: (degree + 1)² products for each component, channel, and part of the material in it:
    /// 64 x 289 x 3 for one part in each channel and a light of degree 16.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light has a higher degree.
    pub fn coefficients(&self, light: Rgb<Light<'_>>) -> Result<Rgb<ObjectCoefficients>, Error> {
        self.check_degrees(light.map(|light| light.degree()))?;
        let mut found = Rgb::from([(); 3].map(|()| ObjectCoefficients::ZERO));
        self.each_channel(light, &mut found, |light, share, found| {
            let coefficients = light.coefficients();
            let mut sums = [0.0_f32; MOST_RANK];
            for (part, rows) in self.parts().enumerate().filter(|(part, _)| share(*part) != 0) {
                let share = f32::from(share(part)) / 32_767.0;
                for (row, sum) in rows.zip(&mut sums) {
                    let product: f32 = row
                        .degrees(coefficients)
                        .map(|(shift, mantissas, light)| {
                            let products = mantissas.iter().zip(light);
                            let product: f32 =
                                products.map(|(q, one)| f32::from(q.cast_signed()) * one).sum();
                            product * (1_u32 << shift) as f32
                        })
                        .sum();
                    *sum += share * product * power(row.exponent);
                }
            }
            *found = ObjectCoefficients::of_floats(sums.get(..self.rank).unwrap_or_default());
        });
        Ok(found)
    }

    /// [`coefficients`](Self::coefficients) in integers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light has a higher degree.
    pub fn coefficients_q15(
        &self,
        light: Rgb<q15::Light<'_>>,
    ) -> Result<Rgb<ObjectCoefficients>, Error> {
        let mut found = Rgb::from([(); 3].map(|()| ObjectCoefficients::ZERO));
        self.coefficients_q15_into(light, &mut found)?;
        Ok(found)
    }

    /// [`coefficients_q15`](Self::coefficients_q15) into existing ones, which takes less stack.
    ///
    /// # Errors
    ///
    /// As [`coefficients_q15`](Self::coefficients_q15); `found` is then unchanged.
    pub fn coefficients_q15_into(
        &self,
        light: Rgb<q15::Light<'_>>,
        found: &mut Rgb<ObjectCoefficients>,
    ) -> Result<(), Error> {
        self.check_degrees(light.map(|light| light.degree))?;
        self.each_channel(light, found, |light, share, found| {
            let mantissas = light.mantissas();
            // Of each component a sum, of at most 44 bits for each part, and its exponent.
            let mut sums = [(0_i64, i32::from(i8::MIN)); MOST_RANK];
            for (part, rows) in self.parts().enumerate().filter(|(part, _)| share(*part) != 0) {
                let share = i64::from(share(part));
                for (row, sum) in rows.zip(&mut sums) {
                    let product: i64 = row
                        .degrees(mantissas)
                        .map(|(shift, mantissas, light)| {
                            let products = mantissas.iter().zip(light);
                            // At most 2^7 x 2^15 x 33.
                            let product: i32 = products
                                .map(|(q, one)| i32::from(q.cast_signed()) * i32::from(one.0))
                                .sum();
                            i64::from(product) << shift
                        })
                        .sum();
                    *sum = added(*sum, ((product * share) >> 15, row.exponent));
                }
            }
            let sums = sums.get(..self.rank).unwrap_or_default();
            *found = ObjectCoefficients::of_sums(sums, light.exponent());
        });
        Ok(())
    }

    fn check_degrees(&self, degrees: Rgb<usize>) -> Result<(), Error> {
        let check = |degree| Error::check_beyond(Argument::Light, self.degree(), degree);
        degrees.try_map(check).map(drop)
    }

    fn each_channel<L>(
        &self,
        light: Rgb<L>,
        found: &mut Rgb<ObjectCoefficients>,
        find: impl Fn(L, &dyn Fn(usize) -> i16, &mut ObjectCoefficients),
    ) {
        let share = |channel: usize| {
            move |part: usize| {
                let share =
                    self.shares.get(part).and_then(|share| share.as_chunks().0.get(channel));
                share.map_or(0, |&share| i16::from_le_bytes(share))
            }
        };
        let Rgb { r, g, b } = light;
        find(r, &share(0), &mut found.r);
        find(g, &share(1), &mut found.g);
        find(b, &share(2), &mut found.b);
    }

    /// The rows of each part.
    fn parts(&self) -> impl Iterator<Item = impl Iterator<Item = Row<'_>>> {
        // At least 1, so that no panic is linked.
        let size = row_bytes(self.degree()).max(1);
        self.rows.chunks_exact((self.rank * size).max(1)).map(move |part| {
            part.chunks_exact(size).map(|row| {
                let (exponent, rest) = row.split_first().unwrap_or((&0, &[]));
                let (shifts, mantissas) =
                    rest.split_at_checked(self.degree() + 1).unwrap_or_default();
                Row { exponent: i32::from(exponent.cast_signed()), shifts, mantissas }
            })
        })
    }
}

/// A row that gives a coefficient from a light.
struct Row<'a> {
    exponent: i32,
    shifts: &'a [u8],
    mantissas: &'a [u8],
}

impl<'a> Row<'a> {
    /// The shift of each degree of a light, its mantissas and its coefficients.
    fn degrees<T>(
        &self,
        mut light: &'a [T],
    ) -> impl Iterator<Item = (u32, &'a [u8], &'a [T])> + use<'a, T> {
        let (shifts, mut mantissas) = (self.shifts, self.mantissas);
        shifts.iter().enumerate().map_while(move |(l, shift)| {
            let orders = 2 * l + 1;
            let (of_degree, rest) = mantissas.split_at_checked(orders)?;
            let (coefficients, others) = light.split_at_checked(orders)?;
            (mantissas, light) = (rest, others);
            // At most 12, as `new` has checked; the mask links no panic.
            Some((u32::from(*shift) & 15, of_degree, coefficients))
        })
    }
}

/// 2 to an exponent, which is brought to -126 to 127.
fn power(exponent: i32) -> f32 {
    f32::from_bits((127 + exponent.clamp(-126, 127)).cast_unsigned() << 23)
}

/// The sum of two numbers, each a mantissa and an exponent.
fn added(a: (i64, i32), b: (i64, i32)) -> (i64, i32) {
    let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
    if high.0 == 0 {
        return low;
    }
    ((low.0 >> (high.1 - low.1).min(63)) + high.0, high.1)
}

impl ObjectCoefficients {
    const ZERO: Self = Self { mantissas: [0; MOST_RANK], exponent: 0 };

    fn of_floats(numbers: &[f32]) -> Self {
        let largest = numbers.iter().fold(0.0_f32, |most, one| most.max(one.abs()));
        // The exponent with which the largest number has 15 bits, unless it is below 2^-113.
        let exponent = ((largest.to_bits() >> 23).cast_signed() - 126 - 15).max(-127);
        let scale = power(-exponent);
        let mantissa = |one: &f32| {
            let scaled = one * scale;
            (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }).clamp(-32_767.0, 32_767.0) as i16
        };
        Self { mantissas: filled(numbers.iter().map(mantissa)), exponent }
    }

    fn of_sums(sums: &[(i64, i32)], of_light: i32) -> Self {
        let bits =
            |sum: &(i64, i32)| 64 - sum.0.unsigned_abs().leading_zeros().cast_signed() + sum.1;
        let nonzero = sums.iter().filter(|sum| sum.0 != 0);
        let exponent = nonzero.map(bits).max().unwrap_or_default() - 15;
        let mantissa = |&(sum, own): &(i64, i32)| {
            let down = exponent - own;
            let mantissa = if down > 0 {
                let down = down.min(62);
                (sum + (1 << (down - 1))) >> down
            } else {
                // A sum of at most 15 bits, or 0 of any exponent.
                sum << (-down).min(15)
            };
            mantissa.clamp(-32_767, 32_767) as i16
        };
        Self { mantissas: filled(sums.iter().map(mantissa)), exponent: exponent + of_light }
    }
}

/// Numbers, and zeros after them.
fn filled(numbers: impl Iterator<Item = i16>) -> [i16; MOST_RANK] {
    let mut all = [0; MOST_RANK];
    all.iter_mut().zip(numbers).for_each(|(to, one)| *to = one);
    all
}
