//! The recurrences of polynomials, by azimuth.

use crate::error::{Argument, Error};
use crate::index::layout;
use crate::invariant::part;

/// Recurrences by azimuth (see [`layout::recurrences`]).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Recurrences<'a> {
    /// The first azimuth that has a recurrence, or a number above all azimuths.
    pub(crate) first: usize,
    /// Entries of each recurrence.
    stride: usize,
    numbers: &'a [layout::Recurrence],
}

impl<'a> Recurrences<'a> {
    /// No azimuth has a recurrence.
    pub const NONE: Self = Self { first: usize::MAX, stride: 0, numbers: &[] };

    /// The recurrences for polynomials of these lengths.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless each azimuth has as many entries as the longest polynomial has
    /// terms; [`Error::Series`] without the feature `series`.
    pub const fn new(lengths: &[u16], numbers: &'a [layout::Recurrence]) -> Result<Self, Error> {
        match layout::recurrences(lengths, numbers.len()) {
            Some([_, _]) if numbers.is_empty() => Ok(Self::NONE),
            Some(_) if !cfg!(feature = "series") => Err(Error::Series),
            Some([first, stride]) => Ok(Self { first, stride, numbers }),
            None => Err(Error::Length {
                argument: Argument::Recurrences,
                expected: 0,
                found: numbers.len(),
            }),
        }
    }

    /// Whether no azimuth has one.
    #[inline]
    pub(crate) const fn is_empty(&self) -> bool {
        !cfg!(feature = "series") || self.numbers.is_empty()
    }

    /// The recurrence of an azimuth, or empty.
    #[inline]
    pub(crate) fn of(&self, azimuth: usize) -> &'a [layout::Recurrence] {
        if self.is_empty() {
            return &[];
        }
        let Some(row) = azimuth.checked_sub(self.first) else { return &[] };
        let rest = part(self.numbers, row.wrapping_mul(self.stride)..);
        part(rest, ..self.stride)
    }
}
