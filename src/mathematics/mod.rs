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
