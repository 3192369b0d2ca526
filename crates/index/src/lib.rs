//! The index conventions of the whole project: where each coefficient is stored.
//!
//! * [`light`]: the spherical harmonic coefficient of degree l and order m.
//! * [`material`]: the Koenderink-van Doorn coefficient (o, p, q).
//! * [`pair`]: one Zernike polynomial (p, q), half of a scattering mode.
//! * [`mode`]: the irradiance modes of one azimuth |m|.
//! * [`effect`]: sets of irradiance modes with a visible meaning.
//! * [`format`](mod@format): the number formats.
//! * [`highlights`]: the most small sources of a light, and the materials of their errors.
//! * [`layout`]: the memory layout of the runtime's rows.
//! * [`record`]: the arrays of a table.
//! * [`source`]: records as Rust source, with the feature `alloc`.
//! * [`wire`]: tables as bytes that the runtime reads in place.
//!
//! Every ordering of coefficients has the prefix property: the coefficients up to a lower degree or
//! order are the first ones of any higher degree or order. "(n)" in these pages is equation n of
//! Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance", ICCV 2003.
//!
//! ```
//! use eigenshade_index::{light, material};
//!
//! // A light of degree 1 is stored as 00, 1-1, 10, 11.
//! assert_eq!(light::indices(1).collect::<Vec<_>>(), [(0, 0), (1, -1), (1, 0), (1, 1)]);
//! assert_eq!(light::position(1, -1), 1);
//! assert_eq!((light::count(9), material::count(7)), (100, 40));
//! ```
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "alloc")]
extern crate alloc;

pub mod effect;
pub mod format;
pub mod highlights;
pub mod layout;
pub mod light;
pub mod material;
pub mod mode;
pub mod pair;
pub mod record;
#[cfg(feature = "alloc")]
pub mod source;
pub mod wire;
