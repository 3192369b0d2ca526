//! Buffers with a capacity fixed at compile time.

use crate::error::{Argument, Error};
use core::ops::{Deref, DerefMut};

/// At most `N` numbers, or sources, stored in place: the coefficients, scenes, transfers and maps
/// that functions return by value.
///
/// A buffer dereferences to a slice. Each table states the capacities that it needs, such as
/// `sphere::SCENE`.
///
/// ```
/// use eigenshade::Buffer;
///
/// let buffer = Buffer::from([3.0, 1.0]);
/// assert_eq!(buffer.as_slice(), [3.0, 1.0]);
/// assert_eq!(buffer.iter().sum::<f32>(), 4.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct Buffer<S, const N: usize>(heapless::Vec<S, N>);

impl<S, const N: usize> Buffer<S, N> {
    /// A buffer of these numbers; `None` if there are more than `N`.
    #[must_use]
    pub fn from_slice(numbers: &[S]) -> Option<Self>
    where
        S: Clone,
    {
        heapless::Vec::from_slice(numbers).ok().map(Self)
    }

    /// The numbers.
    #[inline]
    #[must_use]
    pub fn as_slice(&self) -> &[S] {
        self.0.as_slice()
    }

    /// The numbers, to be changed.
    #[inline]
    pub fn as_mut_slice(&mut self) -> &mut [S] {
        self.0.as_mut_slice()
    }

    /// All `N` numbers, to be written. Numbers that were not there before are zero.
    #[inline(always)]
    pub(crate) fn filled(&mut self) -> Option<&mut [S; N]>
    where
        S: Clone + Default,
    {
        self.0.resize_default(N).ok()?;
        self.0.as_mut_slice().try_into().ok()
    }
}

#[inline]
pub(crate) fn zeros<S: Copy + Default, const N: usize>(
    argument: Argument,
    needed: usize,
) -> Result<Buffer<S, N>, Error> {
    if needed > N {
        return Err(Error::Capacity { argument, needed, capacity: N });
    }
    let mut buffer = heapless::Vec::from_array([S::default(); N]);
    buffer.truncate(needed);
    Ok(Buffer(buffer))
}

#[inline]
pub(crate) fn copied<S: Copy + Default, const N: usize>(
    argument: Argument,
    numbers: impl ExactSizeIterator<Item = S>,
) -> Result<Buffer<S, N>, Error> {
    let mut copy = zeros::<S, N>(argument, numbers.len())?;
    copy.iter_mut().zip(numbers).for_each(|(to, number)| *to = number);
    Ok(copy)
}

impl<S, const N: usize> From<[S; N]> for Buffer<S, N> {
    #[inline(always)]
    fn from(numbers: [S; N]) -> Self {
        Self(heapless::Vec::from_array(numbers))
    }
}

impl<S, const N: usize> Default for Buffer<S, N> {
    #[inline]
    fn default() -> Self {
        Self(heapless::Vec::new())
    }
}

impl<S, const N: usize> Deref for Buffer<S, N> {
    type Target = [S];
    #[inline]
    fn deref(&self) -> &[S] {
        &self.0
    }
}

impl<S, const N: usize> DerefMut for Buffer<S, N> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [S] {
        &mut self.0
    }
}

impl<S, const N: usize> AsRef<[S]> for Buffer<S, N> {
    #[inline]
    fn as_ref(&self) -> &[S] {
        &self.0
    }
}

impl<S, const N: usize> AsMut<[S]> for Buffer<S, N> {
    #[inline]
    fn as_mut(&mut self) -> &mut [S] {
        &mut self.0
    }
}

impl<'a, S, const N: usize> IntoIterator for &'a Buffer<S, N> {
    type Item = &'a S;
    type IntoIter = core::slice::Iter<'a, S>;
    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}
