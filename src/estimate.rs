//! Estimates the coefficients d of an image as scalar products d_i = I • U_i, (19), pixel by pixel.
//!
//! Each addition to a plain sum loses the bits below the last bit of the sum: in f32, adding 0.1 a
//! million times gives an error of almost 1 %. The sums here also carry what each addition lost
//! (Kahan's compensated summation), so their error is one or two roundings, however many pixels.

use crate::basis::Basis;
use crate::buffer::{Buffer, zeros};
use crate::error::{Argument, Error};
use crate::normal::Normal;
use crate::relight::Coefficients;

/// An estimate in progress: see [`Basis::estimate`].
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Estimate<'a, const K: usize> {
    basis: Basis<'a>,
    sums: Buffer<Sum, K>,
    weight: Sum,
}

impl<'a> Basis<'a> {
    /// Starts an estimate of d from pixels, with no pixels yet.
    ///
    /// `K` must be at least [`components`](Self::components). The estimate stores 2 K + 2 numbers.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Normal, sphere};
    ///
    /// let mut estimate = sphere::estimate();
    /// for (x, z, seen) in [(0.0, 1.0, 1.2), (0.6, 0.8, 1.0), (-0.6, 0.8, 0.9)] {
    ///     estimate.add(Normal::new(x, 0.0, z)?, seen, 1.0);
    /// }
    /// assert_eq!(estimate.coefficients()?.len(), sphere::COMPONENTS);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `K` is too small.
    pub fn estimate<const K: usize>(&self) -> Result<Estimate<'a, K>, Error> {
        let sums = zeros::<Sum, K>(Argument::Coefficients, self.components())?;
        Ok(Estimate { basis: *self, sums, weight: Sum::default() })
    }
}

impl<'a, const K: usize> Estimate<'a, K> {
    /// The estimate of a table with `K` components.
    #[doc(hidden)]
    #[must_use]
    pub fn of_table(basis: Basis<'a>) -> Self {
        Self { basis, sums: [Sum::default(); K].into(), weight: Sum::default() }
    }

    /// Adds a pixel: its normal, the irradiance observed there, and its weight. The weight is the
    /// image area of the pixel (1 if all pixels are alike).
    ///
    /// An irradiance that is not finite makes every coefficient non-finite, whatever its weight.
    /// Leave such a pixel out.
    ///
    /// Cost: one polynomial for each profile, and five additions and a product for each component;
    /// no root and no division.
    #[inline]
    pub fn add(&mut self, normal: Normal, irradiance: f32, weight: f32) {
        let seen = weight * irradiance;
        for (place, value, [cosine, sine]) in self.basis.eigenimages_at(normal) {
            let profile = seen * value;
            for (index, around) in [(place.plus(), cosine), (place.minus(), -sine)] {
                let sum = index.and_then(|index| self.sums.get_mut(usize::from(index)));
                if let Some(sum) = sum {
                    sum.add(profile * around);
                }
            }
        }
        self.weight.add(weight);
    }

    /// The coefficients d: the weighted mean of I U_i over the pixels.
    ///
    /// The mean equals I • U_i if the weighted pixels are distributed like the normals of the
    /// basis: for a sphere, all pixels of its disc, seen from afar. Part of an object takes least
    /// squares instead.
    ///
    /// Compared with the same mean in exact arithmetic, the error is below 1e-6 of the
    /// largest coefficient, for a million pixels and the shipped table.
    ///
    /// # Errors
    ///
    /// [`Error::Weight`] unless the sum of the weights is finite and above zero.
    pub fn coefficients(&self) -> Result<Coefficients<K>, Error> {
        let mut coefficients = zeros::<f32, K>(Argument::Coefficients, self.sums.len())?;
        let weight = self.weight.sum;
        if !(weight.is_finite() && weight > 0.0) {
            return Err(Error::Weight);
        }
        let scale = weight.recip();
        for (coefficient, sum) in coefficients.iter_mut().zip(&self.sums) {
            *coefficient = sum.sum * scale;
        }
        Ok(coefficients)
    }
}

/// A sum and what its last addition rounded away.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Sum {
    sum: f32,
    excess: f32,
}

impl Sum {
    #[inline]
    fn add(&mut self, term: f32) {
        let owed = term - self.excess;
        let next = self.sum + owed;
        self.excess = (next - self.sum) - owed;
        self.sum = next;
    }
}
