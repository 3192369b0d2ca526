//! From captured light and measured materials to eigenshade tables.
//!
//! The modules stand in the order of the mathematics of Nillius and Eklundh,
//! "Phenomenological Eigenfunctions for Image Irradiance", ICCV 2003; "(n)" in
//! these pages is equation n of that paper.

pub mod special;

pub mod rotation;

pub mod polar_integral;

pub mod mode_gain;

pub mod scattering;

pub mod brdf;

pub mod irradiance;

pub mod truth;

pub mod gram;

pub mod selection;

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

pub mod effects;

pub mod peak;

pub mod scene_file;

pub mod estimate;

pub mod database;

pub mod error;

pub mod budget;

pub mod inputs;

pub mod reading;

pub mod direct;

pub mod unfinished;

pub mod output;

pub mod build;
