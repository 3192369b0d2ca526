//! Windows over the degrees of a light, which reduce the ringing of a truncated light.

use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::index::light;
use crate::light::Light;
use crate::mathematics::Mathematics;
use crate::scalar::Scalar;
use crate::turn::LightBuffer;

/// Factors that attenuate a light's coefficients, degree by degree.
///
/// A light truncated at some degree rings around its brightest parts and becomes negative, and so
/// does the irradiance of a glossy material. A window blurs the light instead.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Window<S> {
    /// No window: every degree is kept as it is.
    #[default]
    None,
    /// (sin x / x)⁴ with x = π l / width, and 0 from l = width on: the fourth power of the Lanczos
    /// window of P.-P. Sloan, "Stupid Spherical Harmonics (SH) Tricks", 2008.
    ///
    /// A wider window attenuates less: with the width 2 (degree + 1) the last degree of a light of
    /// degree 9 keeps 20 %, with degree + 1 nearly nothing.
    SincFourth {
        /// The degree from which on the factor is 0; above 0, not necessarily an integer.
        width: S,
    },
}

impl<S: Scalar> Window<S> {
    /// The factor of a degree, from 0 to 1. It is 1 for degree 0, so the mean light is preserved.
    ///
    /// A width that is not above 0 keeps degree 0 only.
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

    /// Attenuates the coefficients of a light in place. They are in the order of
    /// [`index::light`](crate::index::light).
    ///
    /// Cost: a sine for each degree and a product for each coefficient.
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
    /// The coefficients of this light after a window. `N` must be at least (degree + 1)². `M`
    /// computes a sine for each degree; for f32, `SinglePrecision` links no f64 code.
    ///
    /// ```
    /// use eigenshade::mathematics::SinglePrecision;
    /// use eigenshade::{Light, Window};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let window = Window::SincFourth { width: 4.0 };
    /// let windowed = light.windowed::<SinglePrecision, 4>(window)?;
    /// assert!(windowed[0] == 3.5 && windowed[2] < 1.0);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small.
    pub fn windowed<M: Mathematics<S>, const N: usize>(
        &self,
        window: Window<S>,
    ) -> Result<LightBuffer<S, N>, Error> {
        let mut windowed = zeros::<S, N>(Argument::Light, light::count(self.degree()))?;
        for (to, &from) in windowed.iter_mut().zip(self.coefficients()) {
            *to = from;
        }
        window.apply::<M>(&mut windowed);
        Ok(windowed)
    }
}
