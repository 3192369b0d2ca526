//! Irradiance below zero: what becomes of it.

/// What becomes of irradiance below zero, which no light gives: it comes of lights and materials
/// that end at some degree and order, of fits, and of few components.
///
/// Nothing is clamped unasked: negative values are how an image shows that it is at its limits,
/// and what is read from pixels needs them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Negatives {
    /// They stay.
    #[default]
    Kept,
    /// They become zero.
    Clamped,
}

impl Negatives {
    /// One irradiance, in floats or integers; NaN stays.
    #[inline]
    #[must_use]
    pub fn of<T: Copy + Default + PartialOrd>(self, irradiance: T) -> T {
        let zero = T::default();
        if self == Self::Clamped && irradiance < zero { zero } else { irradiance }
    }

    /// Many where they are; gives the least that was there before, none of no pixels. A NaN is
    /// passed over.
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
