//! Other ways to a picture, as engines have them: a matcap, and the split sum.

use super::references::World;
use super::subjects::Gltf;
use crate::accuracy_cost::images::Pair;
use crate::light_tree::LightTree;
use crate::sphere::Picture;
use eigenshade::object::Matcap;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::Surface;
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_shading::shader::{OwnedNormals, fault};
use std::f64::consts::PI;

/// Texels along a side of the matcap.
pub const MATCAP: usize = 32;

/// The pictures of a matcap in floats, by map: direct integration at the normals of 32 x 32 texels,
/// and bilinear look-ups, clamped at the sides.
pub fn matcap(surface: &Surface, world: &World) -> Vec<Picture> {
    let texels = Matcap::new(MATCAP).into_iter().flatten();
    let normals: Vec<_> = texels.map(|texel| texel.normal().components().map(f64::from)).collect();
    let texels = world.pictures(surface, &normals);
    let side = MATCAP as f64;
    // The texels before and after a coordinate, and its place between them.
    let cell = |x: f64| {
        let place = (0.5 * (x + 1.0) * side - 0.5).clamp(0.0, side - 1.0);
        let first = place as usize;
        (first, (first + 1).min(MATCAP - 1), place.fract())
    };
    let look_up = |texels: &[f64], [x, y, _]: [f64; 3]| {
        let ((left, right, across), (above, below, down)) = (cell(x), cell(-y));
        let row = |row: usize| {
            let [a, b] = [left, right].map(|column| texels[row * MATCAP + column]);
            a + across * (b - a)
        };
        row(above) + down * (row(below) - row(above))
    };
    let picture = |texels: &Picture| {
        let channel = |c: usize| world.sphere.normals.iter().map(move |&n| (c, n));
        [0, 1, 2].map(|c| channel(c).map(|(c, n)| look_up(&texels[c], n)).collect())
    };
    texels.iter().map(picture).collect()
}

/// Maps that are prefiltered for one roughness: B. Karis, "Real Shading in Unreal Engine 4",
/// SIGGRAPH 2013 courses. The normal and the view are taken to be the mirror direction.
pub struct Prefiltered {
    pub roughness: f64,
    /// The prefiltered radiance in the mirror direction of each normal, by map.
    radiance: Vec<Picture>,
    /// White light from everywhere.
    white: LightTree,
}

impl Prefiltered {
    pub fn new(roughness: f64, world: &World) -> Result<Self> {
        // The mirror direction of the view from z.
        let mirror = |&[x, y, z]: &[f64; 3]| [2.0 * x * z, 2.0 * y * z, 2.0 * z * z - 1.0];
        let directions: Vec<[f64; 3]> = world.sphere.normals.iter().map(mirror).collect();
        let EnvironmentMap { width, height, .. } = world.maps[0];
        let white = EnvironmentMap::new(width, height, vec![[1.0; 3]; width * height])?;
        let white = LightTree::new(&[white])?;
        Ok(Self { roughness, radiance: prefilter(&world.maps, &directions, roughness), white })
    }

    /// The pictures of a material with this roughness, by map.
    ///
    /// The lobe is the prefiltered radiance times what the lobe reflects of white light, which is
    /// the scale and the bias of the split sum. The matte part is what white light leaves of the
    /// albedo, under the light of degree 2.
    pub fn pictures(&self, gltf: Gltf, world: &World) -> Result<Vec<Picture>> {
        let lobe = Gltf { albedo: 0.0, ..gltf }.surface("lobe".into())?;
        let [reflected, ..] = &self.white.pictures(&lobe, &world.sphere.normals, &())[0];
        let normals = OwnedNormals::new(&world.sphere.normals);
        let picture = |map: usize| -> Result<Picture> {
            let channel = |c: usize| -> Result<Vec<f64>> {
                let light = world.lights.entries[map].rgb[c].clone();
                // b_00^0 of a Lambertian.
                let pair = Pair { light, material: vec![2.0 * gltf.albedo] };
                let mut matte = vec![0.0; world.sphere.normals.len()];
                let formula = pair.nine_terms()?;
                formula.shade_slice(normals.view()?, &mut matte).map_err(fault)?;
                let radiance = self.radiance[map][c].iter();
                let sum = |((radiance, share), matte): ((&f64, &f64), f32)| {
                    radiance * share + (1.0 - share) * f64::from(matte)
                };
                Ok(radiance.zip(reflected).zip(matte).map(sum).collect())
            };
            Ok([channel(0)?, channel(1)?, channel(2)?])
        };
        (0..world.maps.len()).map(picture).collect()
    }
}

/// The mean radiance by D(h) cos θ, with h half-way between a direction and the light's, and θ the
/// angle between these. Sums over the texels' centers.
fn prefilter(maps: &[EnvironmentMap], directions: &[[f64; 3]], roughness: f64) -> Vec<Picture> {
    let EnvironmentMap { width, height, .. } = maps[0];
    let texel =
        |k: usize| (maps[0].direction(k % width, k / width), maps[0].solid_angle(k / width));
    let texels: Vec<([f64; 3], f64)> = (0..width * height).map(texel).collect();
    let radiance: Vec<f32> =
        (0..width * height).flat_map(|k| maps.iter().flat_map(move |map| map.texels[k])).collect();
    let count = 3 * maps.len();
    let square = roughness.powi(4);
    let of_direction = |k: usize| {
        let [x, y, z] = directions[k];
        let (mut sums, mut total) = (vec![0.0f64; count], 0.0);
        for (([a, b, c], solid_angle), radiance) in texels.iter().zip(radiance.chunks_exact(count))
        {
            let cosine = a * x + b * y + c * z;
            if cosine <= 0.0 {
                continue;
            }
            // sin² and cos² of half the angle.
            let (sine, half) = (0.5 - 0.5 * cosine, 0.5 + 0.5 * cosine);
            let spread = sine + square * half;
            let weight = square / (PI * spread * spread) * cosine * solid_angle;
            total += weight;
            for (sum, &radiance) in sums.iter_mut().zip(radiance) {
                *sum += weight * f64::from(radiance);
            }
        }
        sums.iter_mut().for_each(|sum| *sum /= total);
        sums
    };
    let found = parallel::map(directions.len(), &(), of_direction);
    let of_map =
        |map: usize| [0, 1, 2].map(|c| found.iter().map(|sums| sums[3 * map + c]).collect());
    (0..maps.len()).map(of_map).collect()
}
