//! Errors of estimates of light and material from damaged images.

pub mod damage;

pub mod figures;

pub mod report;

mod score;
