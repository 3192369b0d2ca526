//! Pictures of a sphere by the direct sum (15), and their norms.

use eigenshade_index::effect::Effects;
use eigenshade_model::effects;
use eigenshade_model::truth::Truth;
use eigenshade_shading::sphere_rings::{Ring, rings};

/// Irradiances by channel and then by normal.
pub type Picture = Vec<Vec<f64>>;

/// The normals of a sphere, and the share of the disc that each represents.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// Unit normals that face the camera.
    pub normals: Vec<[f64; 3]>,
    /// Weights; they sum to 1.
    pub weights: Vec<f64>,
}

impl Sphere {
    /// Normals `spacing` radians apart.
    pub fn new(spacing: f64) -> Self {
        let rings = rings(spacing);
        let weights = rings.iter().flat_map(|ring| vec![ring.weight; ring.tilts.len()]);
        Self { weights: weights.collect(), normals: rings.iter().flat_map(Ring::normals).collect() }
    }

    /// The root mean square over normals and channels.
    pub fn rms(&self, picture: &Picture) -> f64 {
        let square = |channel: &Vec<f64>| -> f64 {
            channel.iter().zip(&self.weights).map(|(value, weight)| weight * value * value).sum()
        };
        (picture.iter().map(square).sum::<f64>() / picture.len() as f64).sqrt()
    }

    /// The direct sum over some effects, for a light by channel and a material.
    pub fn direct(
        &self,
        (degree, light): (usize, &[Vec<f64>]),
        (order, material): (usize, &[f64]),
        wanted: Effects,
    ) -> Picture {
        let truth = Truth::new(degree, order);
        let materials = effects::materials(order, material, wanted);
        let lights: Vec<_> =
            light.iter().map(|light| effects::lights(degree, light, wanted)).collect();
        let mut picture = vec![Vec::with_capacity(self.normals.len()); light.len()];
        for &normal in &self.normals {
            let modes = truth.at(normal);
            let scattered: Vec<_> = materials.iter().map(|one| modes.scatter(one)).collect();
            for (channel, lights) in picture.iter_mut().zip(&lights) {
                let products = lights.iter().zip(&scattered);
                channel.push(products.map(|(light, one)| modes.irradiance(light, one)).sum());
            }
        }
        picture
    }
}

/// The largest |I| of all channels.
pub fn peak(picture: &Picture) -> f64 {
    picture.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// The difference of two pictures; the second may have one channel that serves for all.
pub fn difference(a: &Picture, b: &Picture) -> Picture {
    let of = |(k, channel): (usize, &Vec<f64>)| {
        channel.iter().zip(&b[k.min(b.len() - 1)]).map(|(a, b)| a - b).collect()
    };
    a.iter().enumerate().map(of).collect()
}
