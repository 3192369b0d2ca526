//! A captured light seen from one side.

use crate::sources::light_tree::LightTree;
use crate::sources::mirrored::{self, texel_of};
use crate::sources::response::{Glossy, Image, Place, Response};
use crate::sources::sphere::{Picture, Sphere};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::project;
use eigenshade_generator::material::brdf::Surface;
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::Source;
use std::f64::consts::{PI, TAU};

/// An environment map after a rotation.
pub struct View {
    rotation: Option<Rotation>,
    map: EnvironmentMap,
    tree: LightTree,
    /// The harmonics of the map.
    light: [Vec<f64>; 3],
}

/// Pictures of a sphere of one material, by channel and normal.
pub struct Pictures {
    /// By direct integration of the whole map.
    pub reference: Picture,
    /// Without sources, at each size.
    pub truncated: Vec<Picture>,
    /// The largest irradiance of the reference.
    pub peak: f64,
}

impl View {
    /// The map as it is, or after a rotation, with harmonics up to `degree`.
    ///
    /// # Errors
    ///
    /// As [`LightTree::new`].
    pub fn new(map: &EnvironmentMap, rotation: Option<Rotation>, degree: usize) -> Result<Self> {
        let map = rotation.map_or_else(|| map.clone(), |rotation| turned(map, rotation.matrix()));
        let tree = LightTree::new(std::slice::from_ref(&map))?;
        Ok(Self { rotation, light: project(&map, degree), map, tree })
    }

    /// Evenly spaced normals, and others that mirror the lamps.
    #[must_use]
    pub fn sphere(&self, spacing: f64) -> Sphere {
        let brightest = self.tree.mirror(0);
        mirrored::sphere(std::slice::from_ref(&self.map), spacing, &[brightest])
    }

    /// A source of the map, seen from here.
    #[must_use]
    pub fn turned(&self, source: &Source) -> Source {
        self.rotation.map_or(*source, |rotation| source.turned(rotation.matrix()))
    }

    /// The harmonics, by channel.
    #[must_use]
    pub fn light(&self) -> &[Vec<f64>; 3] {
        &self.light
    }

    /// The picture of a surface by direct integration.
    #[must_use]
    pub fn reference(&self, surface: &Surface, normals: &[[f64; 3]]) -> Picture {
        let mut of_map = self.tree.pictures(surface, normals, &());
        of_map.swap_remove(0)
    }

    /// Pictures of a material at these normals.
    #[must_use]
    pub fn pictures(&self, material: &Glossy, normals: &[[f64; 3]]) -> Pictures {
        let highest = material.responses.iter().map(Response::degree).max().unwrap_or(0);
        let images: Vec<[Image; 3]> = material
            .responses
            .iter()
            .map(|response| self.light.each_ref().map(|light| response.under(light)))
            .collect();
        let found = parallel::map(normals.len(), &(), |k| {
            let reference = self.tree.irradiance(&*material.brdf, normals[k])[0];
            let at = Place::new(normals[k], highest);
            let truncated =
                images.iter().map(|images| images.each_ref().map(|image| image.irradiance(&at)));
            (reference, truncated.collect::<Vec<[f64; 3]>>())
        });
        let reference =
            [0, 1, 2].map(|c: usize| found.iter().map(|(reference, _)| reference[c]).collect());
        let truncated = (0..material.responses.len()).map(|size| {
            [0, 1, 2].map(|c: usize| found.iter().map(|(_, sums)| sums[size][c]).collect())
        });
        let truncated = truncated.collect();
        let peak = crate::sources::sphere::peak(&reference);
        Pictures { reference, truncated, peak }
    }
}

/// The map turned by a matrix. Each texel is the mean of 2 x 2 samples.
fn turned(map: &EnvironmentMap, matrix: [[f64; 3]; 3]) -> EnvironmentMap {
    let (width, height) = (map.width, map.height);
    let texel = |k: usize| {
        let mut sum = [0.0; 3];
        for part in 0..4 {
            let u = ((k % width) as f64 + 0.25 + 0.5 * f64::from(part % 2)) / width as f64;
            let v = ((k / width) as f64 + 0.25 + 0.5 * f64::from(part / 2)) / height as f64;
            let (sin_t, cos_t) = (TAU * (u - 0.5)).sin_cos();
            let (sine, cosine) = (PI * v).sin_cos();
            let direction = [sin_t * sine, cosine, -cos_t * sine];
            let back = |i: usize| (0..3).map(|j| matrix[j][i] * direction[j]).sum::<f64>();
            let from = map.texels[texel_of([0, 1, 2].map(back), width, height)];
            sum.iter_mut().zip(from).for_each(|(sum, value)| *sum += 0.25 * value);
        }
        sum
    };
    EnvironmentMap { width, height, texels: parallel::map(width * height, &(), texel) }
}
