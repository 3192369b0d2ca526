//! Windows on the degrees of a light: what keeps one that ends at some degree from ringing.

use crate::buffer::zeros;
use crate::error::{Error, What};
use crate::index::light;
use crate::light::Light;
use crate::mathematics::Mathematics;
use crate::scalar::Scalar;
use crate::turn::LightBuffer;

/// Factors by which a light's coefficients are weakened, degree by degree.
///
/// A light that ends at a degree rings about its brightest parts and goes below zero; so does the irradiance
/// of a glossy material. A window blurs it instead.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Window<S> {
    /// None: every degree as it is.
    #[default]
    Open,
    /// (sin x / x)⁴ with x = π l / width, and nothing from l = width on: the fourth power of the Lanczos
    /// window of P.-P. Sloan, "Stupid Spherical Harmonics (SH) Tricks", 2008.
    ///
    /// The wider, the weaker: at the width 2 (degree + 1) the last degree of a light of degree 9 keeps 20 %, at
    /// degree + 1 nearly nothing.
    SincFourth {
        /// The degree from which on nothing is left; above 0, not necessarily whole.
        width: S,
    },
}

impl<S: Scalar> Window<S> {
    /// The factor of a degree, from 0 to 1; 1 for degree 0, so that the mean light stays.
    ///
    /// A width that is not above 0 leaves degree 0 alone.
    #[must_use]
    pub fn factor<M: Mathematics<S>>(self, degree: usize) -> S {
        let Self::SincFourth { width } = self else { return S::ONE };
        let degree = S::from_whole(degree);
        if degree == S::ZERO {
            return S::ONE;
        }
        let inside = degree < width;
        if !inside {
            return S::ZERO;
        }
        let x = S::from_f64(core::f64::consts::PI) * degree * width.reciprocal();
        let (sine, _) = M::sine_and_cosine(x);
        let ratio = sine * x.reciprocal();
        let square = ratio * ratio;
        square * square
    }

    /// Weakens the coefficients of a light, in the order of
    /// [`index::light`](crate::index::light), where they are.
    ///
    /// Cost: a sine for each degree, a product for each coefficient.
    pub fn apply<M: Mathematics<S>>(self, coefficients: &mut [S]) {
        let (mut rest, mut degree) = (coefficients, 0);
        while !rest.is_empty() {
            let orders = (2 * degree + 1).min(rest.len());
            let (of_degree, higher) = rest.split_at_mut_checked(orders).unwrap_or_default();
            let factor = self.factor::<M>(degree);
            of_degree.iter_mut().for_each(|coefficient| *coefficient = *coefficient * factor);
            (rest, degree) = (higher, degree + 1);
        }
    }
}

impl<S: Scalar> Light<'_, S> {
    /// The coefficients of this light through a window; `N` is at least (degree + 1)². `M`
    /// computes a sine for each degree: of f32 `SinglePrecision` links nothing of f64.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn windowed<M: Mathematics<S>, const N: usize>(
        &self,
        window: Window<S>,
    ) -> Result<LightBuffer<S, N>, Error> {
        let mut windowed = zeros::<S, N>(What::Light, light::count(self.degree()))?;
        for (to, &from) in windowed.iter_mut().zip(self.coefficients()) {
            *to = from;
        }
        window.apply::<M>(&mut windowed);
        Ok(windowed)
    }
}
