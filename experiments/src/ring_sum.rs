//! The direct sum (15) at rings of normals, of which only the azimuths differ.

use eigenshade_model::reference::{DirectSum, Modes};
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_shading::sphere_rings::Ring;

/// The modes of a ring.
pub struct RingSum<'a> {
    modes: Modes<'a>,
    /// Φ_m by tilt.
    azimuths: Vec<Vec<f64>>,
}

impl<'a> RingSum<'a> {
    /// `degree` is that of the sum.
    pub fn new(sum: &'a DirectSum, degree: usize, ring: &Ring) -> Self {
        let (sine, cosine) = ring.slant.sin_cos();
        let top = degree.cast_signed();
        let azimuths = |tilt: &f64| (-top..=top).map(|m| azimuth(m, *tilt)).collect();
        // At the rim, cos(π/2) is not exactly zero.
        let modes = sum.at([sine, 0.0, cosine.max(0.0)]);
        Self { modes, azimuths: ring.tilts.iter().map(azimuths).collect() }
    }

    /// The irradiances of each light on a material, by tilt.
    pub fn images<'l>(
        &self,
        lights: impl Iterator<Item = &'l [f64]>,
        material: &[f64],
    ) -> Vec<Vec<f64>> {
        let scattered = self.modes.scatter(material);
        let image = |light| {
            let profile = self.modes.profile(light, &scattered);
            let at = |azimuths: &Vec<f64>| azimuths.iter().zip(&profile).map(|(a, b)| a * b).sum();
            self.azimuths.iter().map(at).collect()
        };
        lights.map(image).collect()
    }
}
