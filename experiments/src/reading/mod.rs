//! Reading light and material off damaged images: how far the answers are off.

pub mod damage;

pub mod figures;

pub mod report;

mod score;
