//! The model from which eigenshade tables are computed, and the coefficient files that it takes as
//! input.
//!
//! The modules follow the mathematics of Nillius and Eklundh, "Phenomenological Eigenfunctions for
//! Image Irradiance", ICCV 2003; "(n)" in these pages is equation n of that paper.

pub mod special;

pub mod rotation;

pub mod polar_integral;

pub mod mode_gain;

pub mod scattering;

pub mod irradiance;

pub mod selection;

pub mod truth;

pub mod effects;

pub mod error;

pub mod database;

pub mod budget;

pub mod inputs;

pub mod unfinished;

pub mod output;
