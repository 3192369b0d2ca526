//! The perfectly matte material.

use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use std::f64::consts::PI;

/// f = albedo / π. Its only coefficient is b_00^0 = 2 albedo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambertian {
    albedo: f64,
}

impl Lambertian {
    /// From the albedo, the fraction of light that is reflected.
    ///
    /// # Errors
    ///
    /// If the albedo is outside \[0, 1\].
    pub fn new(albedo: f64) -> Result<Self> {
        Ok(Self { albedo: share("albedo", albedo)? })
    }
}

impl Brdf for Lambertian {
    fn value(&self, _: Geometry) -> f64 {
        self.albedo / PI
    }

    fn width(&self) -> f64 {
        1.0
    }
}

/// Checks that a number is in \[0, 1\].
pub(super) fn share(what: &str, value: f64) -> Result<f64> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value);
    }
    Err(Error::new(format!("{what} = {value} is outside [0, 1]"), "give a share of 1"))
}
