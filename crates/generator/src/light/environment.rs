//! Environment maps: the light that arrives from every direction.
//!
//! Maps are equirectangular, with row 0 at the top. The pixel at (u, v) in \[0, 1\]² looks along
//! (sin t sin θ, cos θ, -cos t sin θ), with θ = πv and t = 2π(u - 1/2). The middle of the map is
//! -z, in front of the camera. The light on the surfaces that the camera sees comes from the edges
//! of the map, +z.

use eigenshade_model::database::luminance;
use eigenshade_model::error::{Error, Result};
use std::f64::consts::{PI, TAU};

/// The most texels that are read: 16384 x 8192.
pub const MOST_TEXELS: usize = 1 << 27;

/// No file type packs more texels into a byte; a header that claims more is wrong.
const MOST_TEXELS_PER_BYTE: u64 = 1 << 16;

/// Linear radiance in every direction.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentMap {
    /// Number of columns.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// r, g, b; row by row from the top, each from the left. All values are finite; negative texels
    /// are kept unchanged.
    pub texels: Vec<[f32; 3]>,
}

/// Integrals of radiance over all directions, for each channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrals {
    /// Integral of the whole map.
    pub total: [f64; 3],
    /// Integral of the negative texels only; zero or below.
    pub negative: [f64; 3],
}

impl Integrals {
    /// The negative part of the map's luminance as a share of both parts, 0 to 1.
    ///
    /// NaN if the map is black.
    #[must_use]
    pub fn negative_share(&self) -> f64 {
        let negative = -luminance(self.negative);
        negative / (luminance(self.total) + 2.0 * negative)
    }
}

impl EnvironmentMap {
    /// Makes a map from texels.
    ///
    /// # Errors
    ///
    /// If there are no texels, their number is not `width` x `height`, or one is not finite.
    pub fn new(width: usize, height: usize, texels: Vec<[f32; 3]>) -> Result<Self> {
        if width.checked_mul(height) != Some(texels.len()) || texels.is_empty() {
            return Err(Error::new(
                format!("{} texels do not fill {width} x {height}", texels.len()),
                "give the map width x height texels, one at least",
            ));
        }
        let broken = |texel: &[f32; 3]| !texel.iter().all(|channel| channel.is_finite());
        if let Some(first) = texels.iter().position(broken) {
            let count = texels.iter().filter(|texel| broken(texel)).count();
            let (column, row) = (first % width, first / width);
            return Err(Error::new(
                format!(
                    "pixels that are not finite: {count}, the first in column {column} of row \
                     {row}, from 0 at the top left"
                ),
                "clean the map: paint them over with their neighbors",
            ));
        }
        Ok(Self { width, height, texels })
    }

    /// The same radiance in the next larger number of columns and rows that are multiples of
    /// `block`. A texel is the mean over its solid angle.
    #[must_use]
    pub fn in_blocks(self, block: usize) -> Self {
        let [width, height] = [self.width, self.height].map(|side| side.next_multiple_of(block));
        if [width, height] == [self.width, self.height] {
            return self;
        }
        let across = overlaps(self.width, width, |x| x);
        let down = overlaps(self.height, height, |y| -(PI * y).cos());
        let texel = |row: &[(usize, f64)], column: &[(usize, f64)]| {
            let mut sum = [0.0; 3];
            for (y, a) in row {
                for (x, b) in column {
                    let from = self.texels[y * self.width + x];
                    sum.iter_mut()
                        .zip(from)
                        .for_each(|(sum, value)| *sum += a * b * f64::from(value));
                }
            }
            sum.map(|value| value as f32)
        };
        let texel = &texel;
        let texels =
            down.iter().flat_map(|row| across.iter().map(move |column| texel(row, column)));
        Self { width, height, texels: texels.collect() }
    }

    /// Whether the map is twice as wide as high. If not, its texels still divide the sphere, but
    /// the picture may not be equirectangular at all: it may be a mirror ball or a cube cross.
    #[must_use]
    pub fn is_twice_as_wide_as_high(&self) -> bool {
        self.width == 2 * self.height
    }

    /// The unit direction of a texel's center.
    #[must_use]
    pub fn direction(&self, column: usize, row: usize) -> [f64; 3] {
        let (sine, cosine) = self.polar_angle(row).sin_cos();
        let (sin_t, cos_t) = self.turn(column).sin_cos();
        [sin_t * sine, cosine, -cos_t * sine]
    }

    /// θ at the middle of a row, radians.
    pub(crate) fn polar_angle(&self, row: usize) -> f64 {
        PI * (row as f64 + 0.5) / self.height as f64
    }

    /// t at the middle of a column, radians.
    pub(crate) fn turn(&self, column: usize) -> f64 {
        TAU * ((column as f64 + 0.5) / self.width as f64 - 0.5)
    }

    /// The exact solid angle of each texel of a row, steradians:
    /// (2π / width)(cos θ_top - cos θ_bottom).
    #[must_use]
    pub fn solid_angle(&self, row: usize) -> f64 {
        // Write the difference of cosines as a product, which stays accurate at the poles.
        let half = 0.5 * PI / self.height as f64;
        TAU / self.width as f64 * 2.0 * self.polar_angle(row).sin() * half.sin()
    }

    /// The integrals of the map and of its negative texels, with exact solid angles.
    #[must_use]
    pub fn negative_integral(&self) -> Integrals {
        let mut integrals = Integrals { total: [0.0; 3], negative: [0.0; 3] };
        for (row, texels) in self.texels.chunks_exact(self.width).enumerate() {
            let solid_angle = self.solid_angle(row);
            for channel in 0..3 {
                let values = texels.iter().map(|texel| f64::from(texel[channel]));
                let (total, negative) = values.fold((0.0, 0.0), |(total, negative), value| {
                    (total + value, negative + value.min(0.0))
                });
                integrals.total[channel] += solid_angle * total;
                integrals.negative[channel] += solid_angle * negative;
            }
        }
        integrals
    }
}

/// Returns the number of texels, or rejects a size that no file of `bytes` bytes can hold, before
/// memory is allocated for it.
pub(crate) fn believable(width: usize, height: usize, bytes: u64) -> Result<usize> {
    let count = width.checked_mul(height);
    let most = bytes.saturating_mul(MOST_TEXELS_PER_BYTE);
    match count {
        Some(0) => Err(Error::new(
            format!("it is {width} x {height} pixels: it has none"),
            "export the map again",
        )),
        Some(count) if count <= MOST_TEXELS && count as u64 <= most => Ok(count),
        Some(count) if count as u64 <= most => Err(Error::new(
            format!("it is {width} x {height} pixels, too many to read"),
            format!("shrink it to at most {MOST_TEXELS} pixels"),
        )),
        _ => Err(Error::new(
            format!("its header claims {width} x {height} pixels, which {bytes} bytes cannot hold"),
            format!("export the map again, with {MOST_TEXELS} pixels at most"),
        )),
    }
}

/// The error for a file whose contents do not match its extension.
pub(crate) fn other_type(named: &str) -> Error {
    Error::new(
        format!("it is not a file of type {named}, despite its name"),
        "check the file, or give it the ending of its type: .exr, .hdr, .pfm, .png or .jpg",
    )
}

/// The error for a file that ends too early or is corrupt.
pub(crate) fn broken(why: impl std::fmt::Display) -> Error {
    Error::new(format!("it is broken or cut short ({why})"), "fetch or export the map again")
}

/// For each of `to` equal intervals of [0, 1], those of `from` equal intervals that it overlaps, and
/// their shares of its measure.
fn overlaps(from: usize, to: usize, measure: fn(f64) -> f64) -> Vec<Vec<(usize, f64)>> {
    let edge = |k: usize, of: usize| k as f64 / of as f64;
    let one = |k: usize| {
        let [low, high] = [edge(k, to), edge(k + 1, to)];
        let whole = measure(high) - measure(low);
        // The first and the last interval of the others that begin before its end.
        (k * from / to..((k + 1) * from).div_ceil(to))
            .map(|j| {
                let [a, b] = [low.max(edge(j, from)), high.min(edge(j + 1, from))];
                (j, (measure(b) - measure(a)) / whole)
            })
            .collect()
    };
    (0..to).map(one).collect()
}
