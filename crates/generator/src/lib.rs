//! From captured light and measured materials to eigenshade tables, by the model of
//! [`eigenshade_model`].
//!
//! Modules follow the mathematics of Nillius and Eklundh, "Phenomenological Eigenfunctions for Image
//! Irradiance", ICCV 2003; "(n)" in these pages is equation n of that paper.

pub mod light;

pub mod material;

pub mod object;

pub mod basis;

pub mod scene_file;

pub mod direct;

pub mod picture;

pub mod reading;

pub mod build;
