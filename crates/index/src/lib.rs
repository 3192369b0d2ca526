//! Where each coefficient stands. The whole project's index conventions, once.
//!
//! * [`light`]: the spherical harmonic coefficient of degree l and order m.
//! * [`material`]: the Koenderink-van Doorn coefficient (o, p, q).
//! * [`pair`]: one Zernike polynomial (p, q), the half of a scattering mode.
//! * [`mode`]: the irradiance modes of one azimuth |m|.
//!
//! Every order has the prefix property: the coefficients of a lower degree or
//! order are the first ones of a higher.
#![no_std]

pub mod light;
pub mod material;
pub mod mode;
pub mod pair;
