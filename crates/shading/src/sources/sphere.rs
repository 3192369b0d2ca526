//! The normals of a sphere in rings, images at them by the direct sum (15), and errors of images.

use eigenshade_model::parallel;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_model::sphere_rings::Ring;

/// Irradiances by channel and then by normal.
pub type Picture = [Vec<f64>; 3];

/// The normals of a sphere, and the share of the disc that each represents.
#[derive(Clone, Debug)]
pub struct Sphere {
    rings: Vec<Ring>,
    /// Unit normals that face the camera.
    pub normals: Vec<[f64; 3]>,
    /// Weights; they sum to 1.
    pub weights: Vec<f64>,
}

impl Sphere {
    /// The normals of these rings.
    pub fn new(rings: Vec<Ring>) -> Self {
        let normals = rings.iter().flat_map(Ring::normals).collect();
        let weights = rings.iter().flat_map(|ring| vec![ring.weight; ring.tilts.len()]);
        Self { weights: weights.collect(), normals, rings }
    }

    /// These normals, of equal weight.
    #[must_use]
    pub fn of_normals(normals: &[[f64; 3]]) -> Self {
        let weights = vec![1.0 / normals.len().max(1) as f64; normals.len()];
        Self { rings: Vec::new(), normals: normals.to_vec(), weights }
    }

    /// The irradiances of each light on its material, by material, light and normal. `degree` is
    /// the degree of the sum and of all lights.
    pub fn direct(
        &self,
        (degree, order): (usize, usize),
        channels: &[(Vec<&[f64]>, &[f64])],
    ) -> Vec<Vec<f64>> {
        let sum = DirectSum::new(degree, order);
        let top = degree.cast_signed();
        let of_ring = |k: usize| {
            // The modes of a ring differ only in the azimuths Φ_m.
            let Ring { slant, tilts, .. } = &self.rings[k];
            let (sine, cosine) = slant.sin_cos();
            // At the rim, cos(π/2) is not exactly zero.
            let modes = sum.at([sine, 0.0, cosine.max(0.0)]);
            let azimuths: Vec<Vec<f64>> = tilts
                .iter()
                .map(|&tilt| (-top..=top).map(|m| azimuth(m, tilt)).collect())
                .collect();
            let mut images = Vec::new();
            for (lights, material) in channels {
                let scattered = modes.scatter(material);
                for light in lights {
                    let profile = modes.profile(light, &scattered);
                    let at = |one: &Vec<f64>| one.iter().zip(&profile).map(|(a, b)| a * b).sum();
                    images.push(azimuths.iter().map(at).collect::<Vec<f64>>());
                }
            }
            images
        };
        let by_ring = parallel::map(self.rings.len(), &(), of_ring);
        let count = channels.iter().map(|(lights, _)| lights.len()).sum();
        (0..count).map(|k| by_ring.iter().flat_map(|ring| &ring[k]).copied().collect()).collect()
    }

    /// The root mean square over normals and channels.
    pub fn rms(&self, picture: &Picture) -> f64 {
        let square = |channel: &Vec<f64>| -> f64 {
            channel.iter().zip(&self.weights).map(|(value, weight)| weight * value * value).sum()
        };
        (picture.iter().map(square).sum::<f64>() / 3.0).sqrt()
    }

    /// The root mean square difference of two pictures.
    pub fn apart(&self, found: &Picture, expected: &Picture) -> f64 {
        let off = |c: usize| found[c].iter().zip(&expected[c]).map(|(a, b)| a - b).collect();
        self.rms(&[0, 1, 2].map(off))
    }

    /// The error of a picture: root mean square relative to the peak.
    pub fn error(&self, found: &Picture, expected: &Picture) -> f64 {
        self.apart(found, expected) / peak(expected)
    }
}

/// The largest |I| of all channels.
pub fn peak(picture: &Picture) -> f64 {
    picture.iter().flatten().fold(0.0, |largest, i| i.abs().max(largest))
}
