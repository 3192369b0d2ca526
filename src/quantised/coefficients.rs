//! The coefficients d of one image, in fixed point.

/// The coefficients d of one image, component by component. The mantissas are at most 2^30 in size
/// and are multiplied by 2^exponent.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coefficients<const K: usize> {
    pub(crate) mantissas: heapless::Vec<i32, K>,
    pub(crate) exponent: i32,
}

impl<const K: usize> Coefficients<K> {
    /// The mantissas, component by component.
    #[must_use]
    pub fn mantissas(&self) -> &[i32] {
        &self.mantissas
    }

    /// The common exponent.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}
