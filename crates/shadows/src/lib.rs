//! Eigenimages of an object that shadows itself.

pub mod codebook;
pub mod directions;
pub mod eigenimages;
pub mod material;
pub mod object;
pub mod packed;
pub mod transport;
pub mod visibility;
