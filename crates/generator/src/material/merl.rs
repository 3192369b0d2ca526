//! Reads files of the MERL BRDF database, and others in its format.
//!
//! | bytes | what |
//! |---:|---|
//! | 12 | the numbers of bins 90, 90, 180, as little-endian i32 |
//! | 34,992,000 | f64, little-endian: red, then green, then blue, each in the order of [`Merl`] |
//!
//! A value times 1/1500, 1.15/1500 or 1.66/1500 for the three channels is f in 1/sr. A value below
//! zero marks a bin without a value.

use crate::material::brdf::{BINS, Merl, Surface};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::io::Read;

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
    // All channels, plus a second copy of one channel.
    input.admit(BYTES + BYTES / 3)?;
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
        .map_err(|_| Error::new("it has not three channels", REMEDY).in_file(path))?;
    if red == green && red == blue {
        return Ok(Surface::grey(name, Box::new(red)));
    }
    Ok(Surface::colored(name, [Box::new(red), Box::new(green), Box::new(blue)]))
}
