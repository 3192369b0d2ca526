//! The transfer of a material, in fixed point.

/// The transfer of a material: for each profile a row over l from |m| on, times 2 to the exponent
/// of the profile.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transfer<'a, Q> {
    pub(crate) numbers: &'a [Q],
    pub(crate) exponents: &'a [i16],
    /// Whether the absolute values of every row are known to sum to less than 2^(BITS + 1).
    pub(crate) bounded: bool,
}

impl<'a, Q> Transfer<'a, Q> {
    /// A transfer of these numbers. [`Basis::relight`](super::Basis::relight) checks on every call
    /// that there are as many as it needs and that no sum can leave its accumulator.
    /// [`Basis::transfer`](super::Basis::transfer) checks this only once.
    #[must_use]
    pub const fn new(numbers: &'a [Q], exponents: &'a [i16]) -> Self {
        Self { numbers, exponents, bounded: false }
    }
}

/// Storage for a [`Transfer`] of `T` numbers and `P` profiles.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TransferBuffer<Q, const T: usize, const P: usize> {
    pub(crate) numbers: heapless::Vec<Q, T>,
    pub(crate) exponents: heapless::Vec<i16, P>,
}

impl<Q, const T: usize, const P: usize> TransferBuffer<Q, T, P> {
    /// The stored transfer.
    #[must_use]
    pub fn view(&self) -> Transfer<'_, Q> {
        Transfer { numbers: &self.numbers, exponents: &self.exponents, bounded: true }
    }
}
