//! Mathematics of set-up: roots and angles, by an implementation that the user picks.
//!
//! None of it is called for a pixel; normals that arrive unscaled take one root each.
//!
//! | type | formats | root, relative | sine and cosine | what it links |
//! |---|---|---|---|---|
//! | [`Libm`] | f32, f64 | last bit | last bit | f32 angles compute in f64: in software on most microcontrollers |
//! | [`SinglePrecision`] | f32 | 2e-7 | 1e-7 to 1,000 rad | nothing |
//! | [`Tabled`] | f32 | 1.1e-7 | 8e-8 to 1,000 rad | 388 bytes of tables |
//! | `Micromath` | f32 | 6.1 %, its reciprocal 3.5 % | 1.1e-3 to 10 rad | nothing; wants the feature `micromath` |

mod by_libm;
#[cfg(feature = "micromath")]
mod by_micromath;
mod newton;
mod quarters;
mod single_precision;
mod tabled;

pub(crate) use by_libm::ByLibm;
pub use by_libm::Libm;
#[cfg(feature = "micromath")]
pub use by_micromath::Micromath;
pub use single_precision::SinglePrecision;
pub use tabled::Tabled;

/// Roots and angles in the number format `S`.
///
/// Functions, not methods: an implementation is a type without values, chosen where a
/// function is called, as in `Normal::with_mathematics::<SinglePrecision>(x, y, z)`.
pub trait Mathematics<S> {
    /// √x, x >= 0.
    fn square_root(x: S) -> S;
    /// 1/√x, x > 0.
    fn inverse_root(x: S) -> S;
    /// (sin a, cos a) of an angle in radians.
    fn sine_and_cosine(angle: S) -> (S, S);
}
