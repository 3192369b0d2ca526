//! A folded material, in integers.

/// A material folded into a basis: for each profile a row over l from |m| on, times 2
/// to the profile's exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transfer<'a, Q> {
    pub(crate) numbers: &'a [Q],
    pub(crate) exponents: &'a [i16],
    /// Whether every row's sizes are known to sum to less than 2^(BITS + 1).
    pub(crate) bounded: bool,
}

impl<'a, Q> Transfer<'a, Q> {
    /// The transfer of these numbers. [`Basis::relight`](super::Basis::relight) checks each time that they are
    /// as many as it needs, and that no sum can leave its accumulator;
    /// [`Basis::transfer`](super::Basis::transfer) does so once.
    #[must_use]
    pub const fn new(numbers: &'a [Q], exponents: &'a [i16]) -> Self {
        Self { numbers, exponents, bounded: false }
    }
}

/// Room for a [`Transfer`] of `T` numbers and `P` profiles.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TransferBuffer<Q, const T: usize, const P: usize> {
    pub(crate) numbers: heapless::Vec<Q, T>,
    pub(crate) exponents: heapless::Vec<i16, P>,
}

impl<Q, const T: usize, const P: usize> TransferBuffer<Q, T, P> {
    /// The transfer in it.
    #[must_use]
    pub fn view(&self) -> Transfer<'_, Q> {
        Transfer { numbers: &self.numbers, exponents: &self.exponents, bounded: true }
    }
}
