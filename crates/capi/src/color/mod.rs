//! In color: three channels from light to pixel, in `f32` and in Q15.

mod format;

mod picture;

mod float;

mod q15;

mod glossy;

mod steps;

mod rows;

mod meter;

mod exported;

#[cfg(test)]
pub(crate) use exported::{f32_functions, q15_functions};
pub(crate) use format::Channels;
#[cfg(test)]
pub(crate) use format::{MATERIAL, ORDER};
pub(crate) use glossy::{Gloss, Source};
#[cfg(test)]
pub(crate) use glossy::{SOURCES, functions as source_functions};
#[cfg(test)]
pub(crate) use meter::functions as meter_functions;
