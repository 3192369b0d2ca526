//! What each texel of an environment map adds to the irradiance (3), without harmonics, degree or
//! order.
//!
//! Every texel is a patch of constant radiance. The weight of a texel is the integral of f cos θ_i
//! over its solid angle, computed by the midpoint rule on k x k equal parts with the exact solid
//! angle of each. k grows where f changes within the texel: it depends on the texel's size relative
//! to the lobe's width at the half-way direction, and relative to the height above the horizon.

use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::vector::dot;
use std::f64::consts::{PI, TAU};

/// Largest number of parts along one side of a texel.
const MOST_PARTS: usize = 32;

/// The texels of environment maps of one common size.
pub struct Texels {
    width: usize,
    height: usize,
    directions: Vec<[f64; 3]>,
    /// The exact solid angle of one texel in each row.
    solid_angles: Vec<f64>,
}

impl Texels {
    /// The texels of maps, which must have one size.
    ///
    /// # Errors
    ///
    /// If there is no map or the maps differ in size.
    pub fn new(maps: &[EnvironmentMap]) -> Result<Self> {
        let Some(first) = maps.first() else {
            return Err(Error::new("there is no map to read", "name a map, or a folder of maps"));
        };
        let (width, height) = (first.width, first.height);
        if let Some(other) = maps.iter().find(|map| (map.width, map.height) != (width, height)) {
            let what = format!("maps of {width} x {height} and {} x {}", other.width, other.height);
            return Err(Error::new(what, "give maps of one size"));
        }
        let direction = |k: usize| first.direction(k % width, k / width);
        let directions = (0..width * height).map(direction).collect();
        let solid_angles = (0..height).map(|row| first.solid_angle(row)).collect();
        Ok(Self { width, height, directions, solid_angles })
    }

    /// Unit directions of the centers, row by row.
    #[must_use]
    pub fn directions(&self) -> &[[f64; 3]] {
        &self.directions
    }

    /// ∫ f cos θ_i dω over one texel, counted row by row, at a unit normal with z > 0 seen along z.
    ///
    /// `fineness` is the number of parts of a texel for each width of the features within it. 1 is
    /// coarse; compare with twice the value to check convergence.
    ///
    /// # Panics
    ///
    /// If `texel` is out of range.
    #[must_use]
    pub fn weight(&self, brdf: &dyn Brdf, fineness: f64, texel: usize, normal: [f64; 3]) -> f64 {
        let direction = self.directions[texel];
        let cosine = dot(direction, normal);
        let size = PI / self.height as f64;
        if cosine < -size {
            return 0.0;
        }
        let at =
            Geometry { incident: cosine.max(0.0), reflected: normal[2], between: direction[2] };
        let parts = parts(at, brdf.width(), fineness * size);
        let row = texel / self.width;
        if parts == 1 {
            if cosine <= 0.0 {
                return 0.0;
            }
            return brdf.value(at) * cosine * self.solid_angles[row];
        }
        let column = texel % self.width;
        let step = 1.0 / parts as f64;
        let mut tilts = [(0.0, 0.0); MOST_PARTS];
        for (tilt, j) in tilts[..parts].iter_mut().zip(0..) {
            let along = column as f64 + (f64::from(j) + 0.5) * step;
            *tilt = (TAU * (along / self.width as f64 - 0.5)).sin_cos();
        }
        let mut sum = 0.0;
        for i in 0..parts {
            let top = row as f64 + i as f64 * step;
            let (sin_polar, cos_polar) = (size * (top + 0.5 * step)).sin_cos();
            let solid_angle = self.solid_angle(top, step);
            for (sin_t, cos_t) in &tilts[..parts] {
                let direction = [sin_t * sin_polar, cos_polar, -cos_t * sin_polar];
                let cosine = dot(direction, normal);
                if cosine > 0.0 {
                    let at = Geometry { incident: cosine, between: direction[2], ..at };
                    sum += brdf.value(at) * cosine * solid_angle;
                }
            }
        }
        sum
    }

    /// Solid angle of a part that begins at row `top` and is `step` texels high and wide.
    fn solid_angle(&self, top: f64, step: f64) -> f64 {
        let half = 0.5 * step * PI / self.height as f64;
        let middle = (top + 0.5 * step) * PI / self.height as f64;
        TAU * step / self.width as f64 * 2.0 * middle.sin() * half.sin()
    }
}

/// Parts along each side of a texel, for a BRDF of this width and the texel's size in radians times
/// the fineness.
fn parts(at: Geometry, width: f64, wanted: f64) -> usize {
    // Both distances are at least the width times the cosine of θ_d.
    let difference = at.difference_cosine().max(1e-3);
    if wanted <= width * difference {
        return 1;
    }
    // The half-way direction moves by 1 / 2 cos θ_d times the motion of the light's direction.
    let (_, sine) = at.half_squared();
    let half = 2.0 * difference * sine.sqrt().max(width);
    let narrowest = half.min(at.incident.max(width));
    (wanted / narrowest).ceil().clamp(1.0, MOST_PARTS as f64) as usize
}
