//! The polynomials of a scene in the order in which a pixel uses them.

use crate::index::layout::Recurrence;
use crate::parts::Recurrences;

/// Iterates over the polynomials of a scene, downward from the highest azimuth that has any. Each
/// item holds those of +m and -m.
#[derive(Clone, Copy)]
pub(crate) struct Descent<'s, S> {
    /// Lengths of the polynomials of m = 1, 2, ...
    pub(crate) lengths: &'s [u16],
    pub(crate) pole: &'s [S],
    pub(crate) around: &'s [S],
    pub(crate) recurrences: Recurrences<'s>,
}

impl<'s, S> Descent<'s, S> {
    /// Whether any azimuth has a recurrence.
    #[inline]
    pub(crate) fn is_orthogonal(&self) -> bool {
        !self.recurrences.is_empty()
    }

    /// The recurrence of the next azimuth, or after the last one that of the pole; empty if there
    /// is none.
    pub(crate) fn recurrence(&self) -> &'s [Recurrence] {
        self.recurrences.of(self.lengths.len())
    }

    /// Whether any polynomial has more terms than this.
    pub(crate) fn any_longer_than(&self, terms: usize) -> bool {
        self.pole.len() > terms || self.lengths.iter().any(|&length| usize::from(length) > terms)
    }
}

impl<'s, S> Iterator for Descent<'s, S> {
    type Item = (&'s [S], &'s [S]);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (&length, lower) = self.lengths.split_last()?;
        let length = usize::from(length);
        let (rest, of_both) = self.around.split_at_checked(self.around.len() - 2 * length)?;
        (self.lengths, self.around) = (lower, rest);
        of_both.split_at_checked(length)
    }
}
