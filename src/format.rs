//! The number formats: floats, and integers with a separate scale.

pub use crate::index::record::Q15;
use core::fmt::Debug;

/// A floating-point format of the runtime: `f32` or `f64`.
///
/// This trait is sealed. Code is generic over [`Scalar`](crate::Scalar).
pub trait Format:
    sealed::Sealed + Copy + Debug + Default + PartialEq + PartialOrd + 'static
{
    /// The name of the format on a command line.
    const NAME: &'static str;
}

impl Format for f32 {
    const NAME: &'static str = "f32";
}

impl Format for f64 {
    const NAME: &'static str = "f64";
}

pub(crate) mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    impl Sealed for i32 {}
}
