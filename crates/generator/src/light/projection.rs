//! Projects environment maps to spherical harmonic coefficients, L_l^m of (2).
//!
//! L_l^m = Σ radiance x Y_l^m(center of the texel) x solid angle of the texel: the midpoint rule
//! with exact weights. Compared with the integral of a smooth map its error is of the order of (l /
//! height)². For a map taken as a grid of point lights the error is zero.
//!
//! Direct sums over 8192 x 4096 texels with 1089 harmonics each would take hours. In the frame
//! whose polar axis is the map's vertical, each harmonic is a product, so the sums over azimuth are
//! taken row by row and the Legendre functions are applied once a row. The x axis of that frame is
//! the global z, its y axis is x and its z axis is y; its azimuth is π - t. The coefficients are
//! then rotated to the global frame, which is exact.

use crate::light::cube::{CubeMap, FACES, are_faces};
use crate::light::environment::EnvironmentMap;
use crate::light::frame::Frame;
use crate::light::map::Map;
use crate::light::map_file::maps_in;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::special::spherical_harmonic::{self, legendre};
use eigenshade_model::task::checkpoint;
use eigenshade_table::light;
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fs;
use std::path::{Path, PathBuf};

/// From the frame with its pole at the top of the map to the global frame.
const TO_GLOBAL: Rotation = Rotation { alpha: FRAC_PI_2, beta: FRAC_PI_2, gamma: PI };

/// L_l^m of a map up to `degree`, for each channel, in the order of [`eigenshade_table::light`] and
/// the project's own convention.
///
/// Agrees with the texel-by-texel sum to 1e-12 of the largest coefficient. Time: width x height x
/// (degree + 1) x 6 multiplications.
#[must_use]
pub fn project(map: &EnvironmentMap, degree: usize) -> [Vec<f64>; 3] {
    let mut local = [0, 1, 2].map(|_| vec![0.0; light::count(degree)]);
    let waves = Waves::new(map, degree);
    let row_sums = parallel::map(map.height, &(), |row| {
        waves.sums(&map.texels[row * map.width..(row + 1) * map.width])
    });
    // Rows are added in their order, whatever the number of threads.
    for (row, sums) in row_sums.iter().enumerate() {
        checkpoint();
        let (sine, cosine) = map.polar_angle(row).sin_cos();
        let solid_angle = map.solid_angle(row);
        for m in 0..=degree {
            let column = legendre(degree, m, cosine, sine);
            // N_l^-m P_l^-m = (-1)^m N_l^m P_l^m.
            let reflected = if m % 2 == 0 { solid_angle } else { -solid_angle };
            for (local, (even, odd)) in local.iter_mut().zip(sums) {
                for (l, value) in (m..).zip(&column) {
                    let order = m.cast_signed();
                    local[light::position(l, order)] += solid_angle * value * even[m];
                    if m > 0 {
                        local[light::position(l, -order)] += reflected * value * odd[m];
                    }
                }
            }
        }
    }
    local.map(|channel| TO_GLOBAL.turn(degree, &channel))
}

/// L_l^m of a cube up to `degree`, as [`project`].
///
/// Time: texels x (degree + 1)² x 4 multiplications.
#[must_use]
pub fn project_cube(cube: &CubeMap, degree: usize) -> [Vec<f64>; 3] {
    let zero = || [0, 1, 2].map(|_| vec![0.0; light::count(degree)]);
    // Faces are added in their order, whatever the number of threads.
    let faces = parallel::map(FACES.len(), &(), |face| {
        let mut sums = zero();
        for (direction, solid_angle, texel) in cube.texels(face) {
            checkpoint();
            let harmonics = spherical_harmonic::all(degree, direction);
            for (sums, value) in sums.iter_mut().zip(texel) {
                accumulate(sums, solid_angle * f64::from(value), &harmonics);
            }
        }
        sums
    });
    faces.iter().flatten().enumerate().fold(zero(), |mut rgb, (k, sums)| {
        accumulate(&mut rgb[k % 3], 1.0, sums);
        rgb
    })
}

/// L_l^m of a map of either layout up to `degree`, in the frame of a program. The cube of an OpenEXR
/// file is placed as the equirectangular map that OpenEXR makes of it.
///
/// # Errors
///
/// See [`Frame::turn`].
pub fn coefficients(map: &Map, frame: Frame, degree: usize) -> Result<[Vec<f64>; 3]> {
    let is_cube = matches!(map, Map::Cube(cube) if !cube.is_of_openexr());
    let turn = frame.turn(is_cube)?;
    let rgb = match map {
        Map::Equirectangular(map) => project(map, degree),
        Map::Cube(cube) => project_cube(cube, degree),
    };
    if frame == Frame::Eigenshade {
        return Ok(rgb);
    }
    Ok(rgb.map(|channel| turn.turn(degree, &channel)))
}

/// Φ_m and Φ_-m of the local azimuth for every column of the left half and m = 0..=degree. The
/// mirrored column has the same Φ_m and the opposite Φ_-m.
struct Waves {
    width: usize,
    even: Vec<Vec<f64>>,
    odd: Vec<Vec<f64>>,
}

impl Waves {
    fn new(map: &EnvironmentMap, degree: usize) -> Self {
        let waves = |sign: isize| {
            (0..map.width.div_ceil(2))
                .map(|column| {
                    let azimuth = PI - map.turn(column);
                    (0..=degree.cast_signed())
                        .map(|m| spherical_harmonic::azimuth(sign * m, azimuth))
                        .collect()
                })
                .collect()
        };
        Self { width: map.width, even: waves(1), odd: waves(-1) }
    }

    /// Σ over one row of radiance x Φ_m and radiance x Φ_-m, for each channel.
    fn sums(&self, texels: &[[f32; 3]]) -> [(Vec<f64>, Vec<f64>); 3] {
        let count = self.even.first().map_or(0, Vec::len);
        let mut sums = [0, 1, 2].map(|_| (vec![0.0; count], vec![0.0; count]));
        let (left, right) = texels.split_at(self.even.len());
        let mirrored = right.iter().rev();
        // The middle column of an odd width has no mirrored column.
        let alone = (self.width % 2 == 1).then_some(&[0.0; 3]);
        let waves = self.even.iter().zip(&self.odd);
        for ((here, there), (even, odd)) in left.iter().zip(mirrored.chain(alone)).zip(waves) {
            for (channel, (even_sums, odd_sums)) in sums.iter_mut().enumerate() {
                let (here, there) = (f64::from(here[channel]), f64::from(there[channel]));
                accumulate(even_sums, here + there, even);
                accumulate(odd_sums, here - there, odd);
            }
        }
        sums
    }
}

fn accumulate(sums: &mut [f64], factor: f64, waves: &[f64]) {
    for (sum, wave) in sums.iter_mut().zip(waves) {
        *sum += factor * wave;
    }
}

/// The maps that `paths` name, each with its name: the file name without extension. A folder stands
/// for the maps in it, sorted by name; if all of them are named as faces of a cube, see
/// [`FACES`], it is one map with the folder's name.
///
/// # Errors
///
/// If a path does not exist, a folder holds no map, or two maps have the same name.
pub fn named_maps<P: AsRef<Path>>(paths: &[P]) -> Result<Vec<(String, PathBuf)>> {
    let mut files = Vec::new();
    for path in paths {
        let path = path.as_ref();
        if path.is_dir() {
            let maps = maps_in(path)?;
            if are_faces(&maps) { files.push(path.to_owned()) } else { files.extend(maps) }
        } else {
            fs::metadata(path).map_err(|error| Error::io(path, &error))?;
            files.push(path.to_owned());
        }
    }
    let mut first_of = HashMap::new();
    let mut named = Vec::new();
    for file in files {
        let name = name(&file);
        if let Some(first) = first_of.insert(name.clone(), file.clone()) {
            return Err(Error::new(
                format!("`{name}` is also the name of {}", first.display()),
                "rename one of the two files: lights are named after their files",
            )
            .in_file(file));
        }
        named.push((name, file));
    }
    Ok(named)
}

/// The name of a folder, or that of a file without extension.
fn name(path: &Path) -> String {
    let whole = path.canonicalize();
    let name = match &whole {
        Ok(folder) if folder.is_dir() => folder.file_name(),
        _ => path.file_stem(),
    };
    name.map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}
