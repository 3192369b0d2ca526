//! Roots and angles for setup, with an implementation that the user chooses.
//!
//! Shading a pixel calls none of these functions; scaling a normal to length 1 takes one root.
//!
//! | type | formats | root, relative error | sine and cosine, error | also links |
//! |---|---|---|---|---|
//! | [`Libm`] | f32, f64 | last bit | last bit | f64 for f32 angles |
//! | [`SinglePrecision`] | f32 | 2e-7 | 1e-7 to 1,000 rad | nothing |
//! | [`Tabled`] | f32 | 1.1e-7 | 8e-8 to 1,000 rad | 388 bytes of tables |
//! | `Micromath` | f32 | 6.1 %, its reciprocal 3.5 % | 1.1e-3 to 10 rad | nothing |
//!
//! Most microcontrollers compute f64 in software. `Micromath` needs the feature `micromath`.

mod by_libm;
#[cfg(feature = "micromath")]
mod by_micromath;
mod functions;
mod newton;
mod quarters;
mod single_precision;
mod tabled;

pub use by_libm::Libm;
#[cfg(feature = "micromath")]
pub use by_micromath::Micromath;
pub use functions::Mathematics;
pub use single_precision::SinglePrecision;
pub use tabled::Tabled;
