//! Makes eigenshade tables from captured light and measured materials, using the model of
//! [`eigenshade_model`].
//!
//! The modules follow the mathematics of Nillius and Eklundh, "Phenomenological Eigenfunctions for
//! Image Irradiance", ICCV 2003. In these pages, "(n)" is equation n of that paper.

pub mod light;

pub mod material;

pub mod object;

pub mod basis;

pub mod scene_file;

pub mod direct;

pub mod picture;

pub mod reading;

pub mod build;
