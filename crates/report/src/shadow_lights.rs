//! Captured lights that are turned and drawn, and those that an object's statistics are of.

use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::rotation::Rotation;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_model::vector::dot;
use eigenshade_model::{parallel, shipped};
use eigenshade_shadows::directions::{FINE, cell_of, cells};
use eigenshade_table::light;
use faer::Mat;
use std::f64::consts::{FRAC_PI_4, TAU};
use std::path::Path;

/// The degree of the light, and the number of its coefficients.
pub const DEGREE: usize = light::MAX_DEGREE;
pub const COUNT: usize = (DEGREE + 1) * (DEGREE + 1);

/// One in three maps is drawn; the other lights are in the statistics.
const EVERY: usize = 3;

/// Each texel of a map is divided into this many along each side.
const PARTS: usize = 4;

/// A turned light.
pub struct Turned {
    /// Whether it is tilted by up to 45 degrees.
    pub is_tilted: bool,
    /// The mean radiance in each cell of directions, r, g and b.
    pub radiance: [Vec<f32>; 3],
    /// Its coefficients, of a file of lights and not of these cells.
    pub light: [Vec<f64>; 3],
}

/// Lights that are drawn, and those that the statistics are of.
pub struct Lit {
    pub drawn: Vec<Turned>,
    pub known: Lights,
}

impl Lit {
    /// Every third map, turned four times by any angles and four times tilted by up to 45 degrees, and
    /// the other shipped lights.
    ///
    /// # Errors
    ///
    /// If a map is not in the folder.
    pub fn new(maps: &Path) -> Result<Self> {
        let rotations = rotations();
        Self::of(maps, |number, _| if number % EVERY == 0 { rotations.clone() } else { Vec::new() })
    }

    /// The maps with a rotation at least; `rotations` takes the number and the name of a map.
    ///
    /// # Errors
    ///
    /// If a map is not in the folder.
    pub fn of(maps: &Path, rotations: impl Fn(usize, &str) -> Vec<Rotation>) -> Result<Self> {
        let Lights { degree, entries } = shipped::lights()?.truncated(DEGREE);
        let angles: Vec<f64> = cells(FINE).iter().map(|(_, angle)| *angle).collect();
        let (mut drawn, mut known, mut number) = (Vec::new(), Vec::new(), 0);
        for light in entries {
            let path = maps.join(format!("{}.exr", light.name));
            let rotations = if path.exists() {
                number += 1;
                rotations(number - 1, &light.name)
            } else {
                Vec::new()
            };
            if rotations.is_empty() {
                known.push(light);
                continue;
            }
            let map = EnvironmentMap::from_path(path)?;
            drawn.extend(parallel::map(rotations.len(), &(), |k| Turned {
                is_tilted: rotations[k].alpha <= FRAC_PI_4,
                radiance: in_cells(&map, rotations[k], &angles),
                light: light.rgb.each_ref().map(|channel| rotations[k].turn(DEGREE, channel)),
            }));
        }
        if drawn.is_empty() {
            let what = format!("no maps in {}", maps.display());
            return Err(Error::new(what, "run it from the repository's root"));
        }
        Ok(Self { drawn, known: Lights { degree, entries: known } })
    }

    /// The columns of `transports`: harmonics, then the radiances.
    #[must_use]
    pub fn columns(&self) -> Mat<f32> {
        let cells = cells(FINE);
        let mut columns = Mat::zeros(cells.len(), COUNT + 3 * self.drawn.len());
        for (row, (direction, _)) in cells.into_iter().enumerate() {
            let values = spherical_harmonic::all(DEGREE, direction);
            values.into_iter().enumerate().for_each(|(k, one)| columns[(row, k)] = one as f32);
            for (k, channel) in self.drawn.iter().flat_map(|one| &one.radiance).enumerate() {
                columns[(row, COUNT + k)] = channel[row];
            }
        }
        columns
    }
}

/// The rotations of each light.
pub const ROTATIONS: usize = 8;

/// Four rotations, and four tilts.
#[must_use]
pub fn rotations() -> Vec<Rotation> {
    let any = (0..4).map(|k| {
        let share = |step: f64| (0.37 + step * f64::from(k)).fract();
        Rotation {
            alpha: (1.0 - 2.0 * share(0.618)).acos(),
            beta: TAU * share(0.755),
            gamma: TAU * share(0.569),
        }
    });
    let tilts = [0.3, 0.6, 0.8, 1.0].into_iter().enumerate().map(|(k, share)| {
        let axis = 1.3 + 1.7 * k as f64;
        Rotation { alpha: share * FRAC_PI_4, beta: axis, gamma: -axis }
    });
    any.chain(tilts).collect()
}

/// The mean radiance of a turned map in each cell.
fn in_cells(map: &EnvironmentMap, rotation: Rotation, angles: &[f64]) -> [Vec<f32>; 3] {
    let texels: Vec<usize> = (0..map.height * PARTS)
        .flat_map(|y| (0..map.width * PARTS).map(move |x| (x, y)))
        .map(|(x, y)| y / PARTS * map.width + x / PARTS)
        .collect();
    // Only directions and solid angles of the fine map are used.
    let fine =
        EnvironmentMap { width: PARTS * map.width, height: PARTS * map.height, texels: Vec::new() };
    let matrix = rotation.matrix();
    let mut sums = [0; 3].map(|_| vec![0.0; angles.len()]);
    for (place, texel) in texels.into_iter().enumerate() {
        let (column, row) = (place % fine.width, place / fine.width);
        let direction = fine.direction(column, row);
        let cell = cell_of(FINE, matrix.map(|axis| dot(axis, direction)));
        for (sum, radiance) in sums.iter_mut().zip(map.texels[texel]) {
            sum[cell] += fine.solid_angle(row) * f64::from(radiance);
        }
    }
    sums.map(|sums| sums.iter().zip(angles).map(|(sum, angle)| (sum / angle) as f32).collect())
}
