//! What the programs share: tables, inputs, and baselines to compare with.
#![no_std]

/// A full scene: degree 9, order 7, images to 1e-4 of the peak.
pub mod full {
    include!(concat!(env!("OUT_DIR"), "/full.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/full_q15.rs"));
    }

    /// In mantissas of 31 bits.
    pub mod q31 {
        include!(concat!(env!("OUT_DIR"), "/full_q31.rs"));
    }
}

/// Any Lambertian material under light of degree 2.
pub mod lambertian {
    include!(concat!(env!("OUT_DIR"), "/lambertian.rs"));

    /// In mantissas of 15 bits.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/lambertian_q15.rs"));
    }

    /// In mantissas of 31 bits.
    pub mod q31 {
        include!(concat!(env!("OUT_DIR"), "/lambertian_q31.rs"));
    }
}

/// The shipped table in Q15 for one material, folded in beforehand.
pub mod one_material {
    include!(concat!(env!("OUT_DIR"), "/one_material.rs"));
}

pub mod scenes;

pub mod ladder;

pub mod golden;

pub mod inputs;

pub mod integer_inputs;

pub mod drawing;

pub mod picture;

mod operations;

pub mod dense;
