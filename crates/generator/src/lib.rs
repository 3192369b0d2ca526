//! From captured light and measured materials to eigenshade tables, by the model of
//! [`eigenshade_model`].
//!
//! Modules follow the mathematics of Nillius and Eklundh, "Phenomenological Eigenfunctions for Image
//! Irradiance", ICCV 2003; "(n)" in these pages is equation n of that paper.

pub mod brdf;

pub mod gram;

pub mod moments;

pub mod profile;

pub mod pca;

pub mod canonical;

mod eigenimages;

pub mod span;

mod span_table;

mod observed;

pub mod geometry;

pub mod light_statistics;

mod settle;

mod analysis;

pub mod choice;

pub mod basis;

pub mod general;

pub mod node_image;

pub mod representation;

pub mod partial_sum;

pub mod peak;

pub mod scene_file;

pub mod estimate;

pub mod inputs;

pub mod reading;

pub mod direct;

pub mod build;
