//! Direct integration of a material under a map, without harmonics and without shadows.

use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::error::Result;
use eigenshade_shading::textured::Texel;
use std::f32::consts::PI;

/// Directions that are summed together.
const LANES: usize = 8;

type Lanes = [f32; LANES];

/// The directions of a map.
pub struct Directions(Vec<Block>);

/// A few directions.
#[derive(Default)]
struct Block {
    /// The directions, and the half vectors between them and the view.
    light: [Lanes; 3],
    half: [Lanes; 3],
    /// Schlick's share of grazing light.
    fresnel: Lanes,
    /// Radiance times solid angle, by channel.
    light_of: [Lanes; 3],
}

impl Directions {
    /// Those of each texel of a map.
    pub fn new(map: &EnvironmentMap) -> Self {
        let mut blocks: Vec<Block> = Vec::new();
        for place in 0..map.width * map.height {
            let lane = place % LANES;
            if lane == 0 {
                blocks.push(Block::default());
            }
            let Some(block) = blocks.last_mut() else { continue };
            let (row, column) = (place / map.width, place % map.width);
            let light = map.direction(column, row);
            // Toward a light behind the object, where nothing is reflected, any half vector will do.
            let twice = (2.0 * (1.0 + light[2])).sqrt().max(1e-9);
            let half = [light[0], light[1], 1.0 + light[2]];
            for axis in 0..3 {
                block.light[axis][lane] = light[axis] as f32;
                block.half[axis][lane] = (half[axis] / twice) as f32;
                let energy = f64::from(map.texels[place][axis]) * map.solid_angle(row);
                block.light_of[axis][lane] = energy as f32;
            }
            let cosine = (1.0 + light[2]) / twice;
            block.fresnel[lane] = (1.0 - cosine).max(0.0).powi(5) as f32;
        }
        Self(blocks)
    }

    /// The irradiance of a texel: GGX with the height-correlated visibility of Smith, over a matte
    /// base.
    pub fn irradiance(&self, texel: &Texel) -> [f64; 3] {
        let normal = texel.normal.map(|c| c as f32);
        let square = texel.roughness.powi(4);
        let view = normal[2].max(1e-4);
        let of_view = (square + (1.0 - square) * view * view).sqrt();
        let mut sums = [0.0; 3];
        for block in &self.0 {
            let dot = |vectors: &[Lanes; 3], lane: usize| {
                vectors[0][lane] * normal[0]
                    + vectors[1][lane] * normal[1]
                    + vectors[2][lane] * normal[2]
            };
            let mut lobe = [0.0; LANES];
            let mut cosines = [0.0; LANES];
            for lane in 0..LANES {
                let cosine = dot(&block.light, lane).max(0.0);
                let half = dot(&block.half, lane);
                let form = half * half * (square - 1.0) + 1.0;
                let of_light = (square + (1.0 - square) * cosine * cosine).sqrt();
                let visibility = 0.5 / (cosine * of_view + view * of_light);
                lobe[lane] = cosine * square * visibility / (PI * form * form);
                cosines[lane] = cosine / PI;
            }
            for (c, sum) in sums.iter_mut().enumerate() {
                let (f0, matte) = (texel.reflectance[c], texel.matte[c]);
                let mut terms = [0.0; LANES];
                for (lane, term) in terms.iter_mut().enumerate() {
                    let fresnel = block.fresnel[lane];
                    let reflected = (f0 + (1.0 - f0) * fresnel) * lobe[lane];
                    let scattered = matte * (1.0 - fresnel) * cosines[lane];
                    *term = block.light_of[c][lane] * (reflected + scattered);
                }
                *sum += f64::from(terms.iter().sum::<f32>());
            }
        }
        sums
    }
}

/// The map in half its size each way: means over four texels of nearly the same solid angle.
///
/// # Errors
///
/// None for a map of even size.
pub fn halved(map: &EnvironmentMap) -> Result<EnvironmentMap> {
    let (width, height) = (map.width / 2, map.height / 2);
    let texel = |k: usize| {
        let (row, column) = (2 * (k / width), 2 * (k % width));
        let places = [0, 1, map.width, map.width + 1].map(|step| row * map.width + column + step);
        [0, 1, 2].map(|c: usize| places.iter().map(|at| 0.25 * map.texels[*at][c]).sum())
    };
    EnvironmentMap::new(width, height, (0..width * height).map(texel).collect())
}
