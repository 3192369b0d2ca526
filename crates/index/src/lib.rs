//! Where each coefficient stands. The whole project's index conventions, once.
//!
//! * [`light`]: the spherical harmonic coefficient of degree l and order m.
//! * [`material`]: the Koenderink-van Doorn coefficient (o, p, q).
//! * [`pair`]: one Zernike polynomial (p, q), the half of a scattering mode.
//! * [`mode`]: the irradiance modes of one azimuth |m|.
//! * [`effect`]: sets of irradiance modes that a person can see.
//! * [`layout`]: how the runtime lays out its rows.
//! * [`wire`]: a table as bytes that the runtime reads where they lie.
//!
//! Every order of coefficients has the prefix property: those of a lower degree
//! or order are the first ones of a higher. "(n)" in these pages is equation n of
//! Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance",
//! ICCV 2003.
#![no_std]

pub mod effect;
pub mod layout;
pub mod light;
pub mod material;
pub mod mode;
pub mod pair;
pub mod wire;
