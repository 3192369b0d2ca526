//! Normal maps: PNG with 8 or 16 bits per channel.

use crate::png_samples::{self, PngSamples};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::visible;
use std::ops::RangeInclusive;

/// Allowed lengths of a normal's vector: the length is 1 up to rounding and filtering, and √3 for
/// black and for white.
pub const LENGTHS: RangeInclusive<f64> = 0.5..=1.5;

/// Reads the samples of a normal map, with green upside down if it points down in the file.
///
/// A map of two channels, whose blue is the same in all pixels, gets its blue from the other two. A
/// warning says so. Others say that many vectors are not of length 1, that the map fits a surface
/// only with green pointing down, or that the orientation of EXIF data is ignored.
///
/// # Errors
///
/// Those of [`png_samples::read`].
pub fn load(file: &InputFile, flip_green: bool) -> Result<PngSamples> {
    let mut map = png_samples::read(file.clone())?;
    if map.orientation.is_some() {
        file.warn("the orientation in its EXIF data is ignored, as normals would have to turn");
    }
    if flip_green {
        map.colors.iter_mut().for_each(|[_, green, _]| *green = map.full - *green);
    }
    let lengths = Lengths::of(&map);
    if lengths.is_blue_constant && lengths.off > OFF_SHARE {
        file.warn("blue is the same in all of its pixels: z follows from x and y");
        add_blue(&mut map);
    } else if lengths.off > OFF_SHARE {
        file.warn(format!(
            "{:.0} % of its vectors are longer or shorter than 1 by more than {OFF}, and are \
             normalized; check that it is a normal map",
            100.0 * lengths.off
        ));
    }
    if handedness(&map) < LEFT_HANDED {
        file.warn(match flip_green {
            true => "it fits a surface only without --flip-green: green points up in it",
            false => {
                "it fits a surface only if green points down, as in DirectX: give --flip-green, or \
                 flip its green channel"
            }
        });
    }
    Ok(map)
}

/// By how much rounding and filtering may change the length of a vector, and which share of the
/// vectors may differ more.
const OFF: f64 = 0.1;
const OFF_SHARE: f64 = 0.05;

/// Vectors of two channels that are longer show no object, as they lie beyond its rim.
const BEYOND_RIM: f64 = 1.05;

/// Whether a pixel is one of an object, as far as its opacity and color tell: gray is background.
fn is_of_object([r, g, b]: [u16; 3], opacity: u16, full: u16) -> bool {
    2 * u32::from(opacity) >= u32::from(full) && !(r == g && g == b)
}

/// Statistics of the pixels of an object.
struct Lengths {
    is_blue_constant: bool,
    /// The share of the vectors with a length other than 1, beyond [`OFF`].
    off: f64,
}

impl Lengths {
    fn of(map: &PngSamples) -> Self {
        let pixels = map.colors.iter().zip(&map.opacities);
        let pixels = pixels.filter(|(color, opacity)| is_of_object(**color, **opacity, map.full));
        let (mut blue, mut is_blue_constant, mut off, mut count) = (None, true, 0, 0);
        for (color, _) in pixels {
            is_blue_constant &= *blue.get_or_insert(color[2]) == color[2];
            count += 1;
            off += usize::from((length(vector(*color, map.full)) - 1.0).abs() > OFF);
        }
        Self { is_blue_constant, off: off as f64 / f64::max(1.0, f64::from(count)) }
    }
}

/// Replaces blue by what makes unit vectors, in 16 bits a channel. Pixels that show no object become
/// black.
fn add_blue(map: &mut PngSamples) {
    let scale = u16::MAX / map.full;
    let pixels = map.colors.iter_mut().zip(&mut map.opacities);
    for (color, opacity) in pixels {
        let is_of_object = is_of_object(*color, *opacity, map.full);
        let [x, y, _] = vector(*color, map.full);
        let square = x * x + y * y;
        *opacity *= scale;
        *color = match is_of_object && square.sqrt() <= BEYOND_RIM {
            true => {
                let z = (1.0 - square).max(0.0).sqrt();
                let blue = (0.5 * (z + 1.0) * f64::from(u16::MAX)).ceil() as u16;
                [scale * color[0], scale * color[1], blue]
            }
            false => [0; 3],
        };
    }
    map.full = u16::MAX;
}

/// The [`handedness`] from which down a map is one whose green points down.
const LEFT_HANDED: f64 = -0.5;

/// Normals that are steeper than this z are left out of the handedness: the slopes are steps there.
const LEAST_Z: f64 = 0.2;

/// The fewest squares of four pixels that state a handedness.
const FEWEST: usize = 16;

/// 1 for the normals of a surface, -1 for those with y upside down, 0 if the map does not say.
///
/// A surface z(x, y) has the slopes p and q, and dp/dy = dq/dx. With y upside down one of the two
/// has the other sign. The mean of 2 dp/dy dq/dx / (dp/dy² + dq/dx²) over all squares of four pixels
/// where both derivatives are beyond the rounding of samples.
fn handedness(map: &PngSamples) -> f64 {
    let slopes = |column: usize, row: usize| {
        let place = row * map.width + column;
        let (color, opacity) = (map.colors[place], map.opacities[place]);
        let [x, y, z] = vector(color, map.full);
        let length = length([x, y, z]);
        let is_steep = z < LEAST_Z * length || !LENGTHS.contains(&length);
        (is_of_object(color, opacity, map.full) && !is_steep).then(|| [-x / z, -y / z])
    };
    let rounding = 4.0 / f64::from(map.full);
    let (mut sum, mut count) = (0.0, 0);
    for row in 1..map.height {
        for column in 1..map.width {
            let at = |left: usize, up: usize| slopes(column - left, row - up);
            let (Some(a), Some(b), Some(c), Some(d)) = (at(1, 1), at(0, 1), at(1, 0), at(0, 0))
            else {
                continue;
            };
            let p_upward = 0.5 * (a[0] + b[0] - c[0] - d[0]);
            let q_rightward = 0.5 * (b[1] + d[1] - a[1] - c[1]);
            if p_upward.abs().min(q_rightward.abs()) > rounding {
                let squares = p_upward * p_upward + q_rightward * q_rightward;
                sum += 2.0 * p_upward * q_rightward / squares;
                count += 1;
            }
        }
    }
    if count < FEWEST { 0.0 } else { sum / count as f64 }
}

/// The unit normal, z >= 0, of each pixel of a map; `None` where there is no object.
///
/// A channel c in 0..=1 encodes the coordinate 2c - 1: red is x to the right, green is y up, blue
/// is z toward the camera. A pixel is background if its opacity is below one half, or if the length
/// of its vector is not within [`LENGTHS`], which excludes gray, black and white.
///
/// # Errors
///
/// Reports the first pixel that is not background, that counts according to `counts`, and that
/// points away from the camera by more than [`RIM`](eigenshade_model::inputs::normals::RIM) beyond
/// rounding. Such a pixel that does not count has no normal instead.
pub fn normals(map: &PngSamples, counts: &[bool]) -> Result<Vec<Option<[f64; 3]>>> {
    each(map, counts).collect()
}

/// Like [`normals`], one pixel at a time.
fn each(map: &PngSamples, counts: &[bool]) -> impl Iterator<Item = Result<Option<[f64; 3]>>> {
    let full = f64::from(map.full);
    let pixels = map.colors.iter().zip(&map.opacities).zip(counts).enumerate();
    pixels.map(move |(number, ((&color, &opacity), &counts))| {
        let found =
            if 2.0 * f64::from(opacity) < full { Ok(None) } else { normal(map, number, color) };
        if counts { found } else { Ok(found.unwrap_or_default()) }
    })
}

/// Like [`normals`], one pixel at a time, also of pixels whose opacity is below one half: their
/// coverage, the second number, is their opacity. Among these, those that point away from the
/// camera show nothing.
pub(crate) fn shown(map: &PngSamples) -> impl Iterator<Item = Result<Option<([f64; 3], f64)>>> {
    let full = f64::from(map.full);
    map.colors.iter().zip(&map.opacities).enumerate().map(move |(number, (&color, &opacity))| {
        let coverage = f64::from(opacity) / full;
        let found = match coverage {
            0.0 => Ok(None),
            ..0.5 => Ok(normal(map, number, color).unwrap_or_default()),
            _ => normal(map, number, color),
        };
        found.map(|normal| normal.map(|normal| (normal, coverage)))
    })
}

/// The normal of pixel `number`, whatever its opacity, if its vector has an allowed length.
fn normal(map: &PngSamples, number: usize, color: [u16; 3]) -> Result<Option<[f64; 3]>> {
    let vector = vector(color, map.full);
    if !LENGTHS.contains(&length(vector)) {
        return Ok(None);
    }
    visible(vector).map(Some).map_err(|(what, _)| {
        let (column, row) = (number % map.width, number / map.width);
        Error::new(
            format!("pixel {column}, {row} (from 0): {what}"),
            "make it transparent: only pixels that show the object may count",
        )
    })
}

/// The vector of a red, green and blue sample: 2c - 1 for each channel c = sample / `full`, not
/// normalized.
///
/// No sample encodes exactly 0, so a z less than one step below 0 is rounded to the rim.
fn vector(color: [u16; 3], full: u16) -> [f64; 3] {
    let full = f64::from(full);
    let [x, y, z] = color.map(|c| 2.0 * f64::from(c) / full - 1.0);
    [x, y, if z < 0.0 && z > -2.0 / full { 0.0 } else { z }]
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|c| c * c).sum::<f64>().sqrt()
}
