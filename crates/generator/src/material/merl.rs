//! BRDFs tabulated in half-way and difference angles, and their files, as in the MERL database: W.
//! Matusik, H. Pfister, M. Brand and L. McMillan, "A Data-Driven Reflectance Model", SIGGRAPH 2003.
//! The angles are those of S. Rusinkiewicz, "A New Change of Variables for Efficient BRDF
//! Representation", 1998.
//!
//! | bytes of a file | contents |
//! |---:|---|
//! | 12 | the numbers of bins 90, 90, 180, as little-endian i32 |
//! | 34,992,000 | f64, little-endian: red, then green, then blue, each in the order of [`Merl`] |
//!
//! A value times 1/1500, 1.15/1500 or 1.66/1500 for the three channels is f in 1/sr. A value below
//! zero marks a bin without a value.

use crate::material::brdf::{Brdf, Geometry, Surface};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::f64::consts::{FRAC_PI_2, PI};
use std::io::Read;

/// Number of bins in θ_h, θ_d and φ_d.
pub const BINS: [usize; 3] = [90, 90, 180];

/// One channel of a table. Bins are indexed by θ_h, then θ_d, then φ_d. They are equal in θ_d over
/// \[0, π/2\], in φ_d over \[0, π), and in √θ_h over \[0, √(π/2)\].
///
/// Between bin centers f is linear in each of the three. Beyond the outermost centers of θ_h and
/// θ_d it is constant; in φ_d it is periodic (φ_d + π exchanges light and view). Bins without a
/// value are below zero in the files and are skipped: those of the eight bins around a point that
/// have a value share the weight, and f is 0 if none has. An isotropic surface cannot distinguish
/// φ_d from -φ_d, so f is the mean of the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Merl {
    values: Vec<f64>,
}

/// The largest accepted value: sums of its squares are finite.
const LARGEST: f64 = 1e100;

impl Merl {
    /// From values in 1/sr, which are below zero for bins without a value. `None` if their number
    /// differs from the number of bins, or if one is not finite or beyond 1e100, where squares
    /// overflow.
    #[must_use]
    pub fn new(values: Vec<f64>) -> Option<Self> {
        let fits = values.len() == BINS.iter().product::<usize>();
        (fits && values.iter().all(|value| value.abs() <= LARGEST)).then_some(Self { values })
    }

    /// Fraction of bins without a value.
    #[must_use]
    pub fn missing(&self) -> f64 {
        let count = self.values.iter().filter(|value| **value < 0.0).count();
        count as f64 / self.values.len() as f64
    }

    fn interpolated(
        &self,
        half: [(usize, f64); 2],
        difference: [(usize, f64); 2],
        phi: f64,
    ) -> f64 {
        let (mut sum, mut weights) = (0.0, 0.0);
        let azimuth = around(phi / PI * BINS[2] as f64, BINS[2]);
        for (h, of_half) in half {
            for (d, of_difference) in difference {
                for (p, of_azimuth) in azimuth {
                    let value = self.values[(h * BINS[1] + d) * BINS[2] + p];
                    let weight = of_half * of_difference * of_azimuth;
                    if value >= 0.0 && weight > 0.0 {
                        sum += weight * value;
                        weights += weight;
                    }
                }
            }
        }
        if weights > 0.0 { sum / weights } else { 0.0 }
    }
}

impl Brdf for Merl {
    fn value(&self, at: Geometry) -> f64 {
        let (cos_half, sin_half) = at.half_squared();
        let theta_h = sin_half.sqrt().atan2(cos_half.sqrt());
        let cos_d = at.difference_cosine();
        let sin_d = ((1.0 - cos_d) * (1.0 + cos_d)).sqrt();
        // cos θ_r - cos θ_i = 2 sin θ_h sin θ_d cos φ_d.
        let sines = 2.0 * sin_half.sqrt() * sin_d;
        let cosine = if sines > 0.0 { (at.reflected - at.incident) / sines } else { 0.0 };
        let phi = cosine.clamp(-1.0, 1.0).acos();
        let half = between((theta_h / FRAC_PI_2).sqrt() * BINS[0] as f64, BINS[0]);
        let difference = between(cos_d.acos() / FRAC_PI_2 * BINS[1] as f64, BINS[1]);
        let of = |phi| self.interpolated(half, difference, phi);
        0.5 * (of(phi) + of(PI - phi))
    }

    /// The third bin of θ_h begins at 8e-4 rad; the lobes of the database are wider.
    fn width(&self) -> f64 {
        5e-3
    }
}

/// The two bins whose centers enclose a place, and their weights.
fn between(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).clamp(0.0, (count - 1) as f64);
    let low = (place as usize).min(count - 2);
    let share = place - low as f64;
    [(low, 1.0 - share), (low + 1, share)]
}

/// The same for a periodic coordinate, where the last bin is next to the first.
fn around(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).rem_euclid(count as f64);
    let low = (place as usize).min(count - 1);
    let share = place - low as f64;
    [(low, 1.0 - share), ((low + 1) % count, share)]
}

/// Factors from the numbers in a file to 1/sr, for r, g and b.
pub const SCALES: [f64; 3] = [1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0];

/// Size of a file in bytes.
pub const BYTES: u64 = 12 + 3 * 8 * (BINS[0] * BINS[1] * BINS[2]) as u64;

const REMEDY: &str = "give a whole .binary file of an isotropic material";

/// Reads a file. The material is named after the stem of the file name. Equal channels are merged
/// into one.
///
/// # Errors
///
/// If the file cannot be read, is not [`BYTES`] long, claims other numbers of bins or holds a
/// number that is not finite, or if a channel has no bin with a value.
pub fn read(file: impl Into<InputFile>) -> Result<Surface> {
    let input = file.into();
    let path = input.path();
    let io = |error: std::io::Error| Error::io(path, &error);
    let (mut file, length) = input.open()?;
    let mut head = [0; 12];
    if length >= 12 {
        file.read_exact(&mut head).map_err(io)?;
        let claimed: Vec<i32> = head
            .chunks_exact(4)
            .map(|bytes| i32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
            .collect();
        if !claimed.iter().zip(BINS).all(|(&claimed, bins)| usize::try_from(claimed) == Ok(bins)) {
            return Err(Error::new(
                format!("its first numbers are {claimed:?}, not the bins {BINS:?}"),
                REMEDY,
            )
            .in_file(path));
        }
    }
    if length != BYTES {
        return Err(Error::new(format!("it has {length} bytes, not {BYTES}"), REMEDY).in_file(path));
    }
    let mut channels = Vec::new();
    for (name, scale) in ["red", "green", "blue"].into_iter().zip(SCALES) {
        let mut bytes = vec![0; (BYTES as usize - 12) / 3];
        file.read_exact(&mut bytes).map_err(io)?;
        let values = bytes.as_chunks().0.iter().map(|&eight| scale * f64::from_le_bytes(eight));
        let fault = |what: &str| Error::new(format!("{what} in its {name} part"), REMEDY);
        let channel = Merl::new(values.collect())
            .ok_or_else(|| fault("a number is not finite, or beyond 1e100").in_file(path))?;
        if channel.missing() >= 1.0 {
            return Err(fault("no bin has a value").in_file(path));
        }
        channels.push(channel);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let [red, green, blue] = <[Merl; 3]>::try_from(channels)
        .map_err(|_| Error::new("it does not have three channels", REMEDY).in_file(path))?;
    if red == green && red == blue {
        return Ok(Surface::gray(name, Box::new(red)));
    }
    Ok(Surface::colored(name, [Box::new(red), Box::new(green), Box::new(blue)]))
}
