//! What the programs share: tables, inputs, and baselines to compare with.
#![no_std]


/// A full scene: degree 9, order 7, images to 1e-4 of the peak.
pub mod full {
    include!(concat!(env!("OUT_DIR"), "/full.rs"));
}

/// A white matte under light of degree 2.
pub mod lambertian {
    include!(concat!(env!("OUT_DIR"), "/lambertian.rs"));
}

pub mod inputs;

pub mod nine_terms;

pub mod dense;
