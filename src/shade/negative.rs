//! How to handle irradiance below zero.

/// How to handle irradiance below zero.
///
/// No light gives negative irradiance. Negative values result from lights and materials that end at
/// some degree and order, from fits, and from few components. Values are clamped only on request:
/// negative values show that an image is at its limits, and estimates from pixels need them.
///
/// ```
/// use eigenshade::screen::NegativePolicy;
///
/// let mut image = [0.5, -0.25];
/// assert_eq!(NegativePolicy::Clamped.apply(&mut image), Some(-0.25));
/// assert_eq!(image, [0.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum NegativePolicy {
    /// Keep negative values.
    #[default]
    Kept,
    /// Set negative values to zero.
    Clamped,
}

impl NegativePolicy {
    /// Applies this policy to one irradiance, a float or an integer. NaN stays NaN.
    #[inline]
    #[must_use]
    pub fn of<T: Copy + Default + PartialOrd>(self, irradiance: T) -> T {
        let zero = T::default();
        if self == Self::Clamped && irradiance < zero { zero } else { irradiance }
    }

    /// Applies this policy to many irradiances in place. Returns the smallest of the original
    /// values, ignoring NaN, or `None` if there are none.
    pub fn apply<T: Copy + Default + PartialOrd>(self, irradiance: &mut [T]) -> Option<T> {
        let mut least = None;
        for value in irradiance {
            let is_number = value.partial_cmp(&value).is_some();
            if is_number && least.is_none_or(|least| *value < least) {
                least = Some(*value);
            }
            *value = self.of(*value);
        }
        least
    }
}
