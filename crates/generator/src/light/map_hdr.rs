//! Radiance maps (`.hdr`): four bytes a pixel, three mantissas and a common exponent.
//!
//! A mantissa m stands for m + 1/2, as in Radiance and Filament. Programs that write these files
//! drop what follows a mantissa, so without the half all light is too dark: by 0.27 % where a
//! channel is the brightest one, and by a quarter where its mantissa is 1.
//!
//! This crate reads them itself because `image` 0.25 adds no half, drops the exponent that one
//! needs for it, and ignores what the header states about color.

use crate::light::environment::{EnvironmentMap, believable, broken, other_type};
use crate::light::primaries::{Primaries, XYZ, product};
use crate::orientation::Orientation;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};

/// Rows of other lengths are never in the encoding that codes each component by itself.
const CODED: std::ops::RangeInclusive<usize> = 8..=0x7fff;

/// The longest line of a header.
const LONGEST_LINE: u64 = 1 << 16;

/// Decodes a map of any orientation, run-length encoded or not. Colors that are multiplied by a
/// `COLORCORR`, have other `PRIMARIES` or are CIE XYZ are converted to linear sRGB, with a warning.
/// The exposure in the header is not applied, because the exposure of a map is arbitrary.
pub(crate) fn decode(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
) -> Result<EnvironmentMap> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    if !reader.fill_buf().map_err(io)?.starts_with(b"#?") {
        return Err(other_type("Radiance"));
    }
    let header = Header::read(reader)?;
    let (orientation, stored) = header.size;
    let count = believable(stored[0], stored[1], length)?;
    let size = orientation.size(stored);
    let conversion = header.conversion(file);
    let mut texels = vec![[0.0; 3]; count];
    let mut pixels = vec![[0; 4]; stored[0]];
    for row in 0..stored[1] {
        read_row(reader, &mut pixels).map_err(|what| broken(format!("row {row}: {what}")))?;
        for (column, pixel) in pixels.iter().enumerate() {
            texels[orientation.place([column, row], size)] = conversion.of(color(*pixel));
        }
    }
    if !reader.fill_buf().map_err(io)?.is_empty() {
        file.warn("bytes after its last row are ignored");
    }
    EnvironmentMap::new(size[0], size[1], texels)
}

/// The color of four bytes; an exponent of 0 is black.
fn color([r, g, b, exponent]: [u8; 4]) -> [f64; 3] {
    match exponent {
        0 => [0.0; 3],
        _ => {
            let unit = 2.0f64.powi(i32::from(exponent) - 136);
            [r, g, b].map(|mantissa| (f64::from(mantissa) + 0.5) * unit)
        }
    }
}

/// The fields of a header.
struct Header {
    /// Pixels in a row of the file, and its rows.
    size: (Orientation, [usize; 2]),
    is_xyz: bool,
    /// The text of the line.
    primaries: Option<String>,
    /// The product of all lines, as of the exposure.
    correction: [f64; 3],
    exposure: f64,
    /// Lines that state no numbers.
    unread: Vec<String>,
}

impl Header {
    fn read(reader: &mut BufReader<File>) -> Result<Self> {
        let mut header = Self {
            size: (Orientation::default(), [0; 2]),
            is_xyz: false,
            primaries: None,
            correction: [1.0; 3],
            exposure: 1.0,
            unread: Vec::new(),
        };
        let mut next = || {
            let mut line = Vec::new();
            let read = reader.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line);
            read.map_err(broken)?;
            let line = line.strip_suffix(b"\n").ok_or_else(|| broken("no end of its header"))?;
            Ok(String::from_utf8_lossy(line).trim().to_owned())
        };
        loop {
            let line = next()?;
            if line.is_empty() {
                break;
            }
            let Some((name, value)) = line.split_once('=') else { continue };
            match name.trim().to_ascii_uppercase().as_str() {
                "FORMAT" => header.is_xyz = is_xyz(value.trim())?,
                "PRIMARIES" => header.primaries = Some(value.trim().to_owned()),
                "COLORCORR" => match numbers::<3>(value) {
                    Some(factors) if factors.iter().all(|one| *one > 0.0) => {
                        header.correction = [0, 1, 2].map(|k| header.correction[k] * factors[k]);
                    }
                    _ => header.unread.push(line),
                },
                "EXPOSURE" => match numbers::<1>(value) {
                    Some([factor]) => header.exposure *= factor,
                    None => header.unread.push(line),
                },
                _ => {}
            }
        }
        let line = next()?;
        header.size = size(&line)
            .ok_or_else(|| broken(format!("its size is `{line}`, expected -Y rows +X columns")))?;
        Ok(header)
    }

    /// How its pixels become radiance in linear sRGB. What is done and what is not done is warned
    /// of.
    fn conversion(&self, file: &InputFile) -> Conversion {
        for line in &self.unread {
            file.warn(format!("its header has `{line}`, which is not understood and ignored"));
        }
        if self.exposure != 1.0 {
            file.warn(format!(
                "its EXPOSURE, {}, is not divided out: the exposure of a map is arbitrary",
                self.exposure
            ));
        }
        if self.correction != [1.0; 3] {
            let [r, g, b] = self.correction;
            file.warn(format!("its COLORCORR, {r} {g} {b}, is divided out"));
        }
        let factors = self.correction.map(f64::recip);
        let matrix = if self.is_xyz {
            file.warn("its colors are CIE XYZ, and are converted to linear sRGB");
            XYZ.to_srgb()
        } else if let Some(text) = &self.primaries {
            let primaries = numbers::<8>(text).map(Primaries::of_list);
            match primaries.map(|one| (one.is_srgb(), one.to_srgb())) {
                Some((true, _)) => None,
                Some((false, Some(matrix))) => {
                    file.warn(format!(
                        "its PRIMARIES, {text}, are not those of sRGB: its colors are converted"
                    ));
                    Some(matrix)
                }
                _ => {
                    file.warn(format!("its PRIMARIES, {text}, are none: nothing is converted"));
                    None
                }
            }
        } else {
            None
        };
        Conversion { factors, matrix }
    }
}

struct Conversion {
    factors: [f64; 3],
    matrix: Option<[[f64; 3]; 3]>,
}

impl Conversion {
    fn of(&self, color: [f64; 3]) -> [f32; 3] {
        let color = [0, 1, 2].map(|k| self.factors[k] * color[k]);
        let color = self.matrix.as_ref().map_or(color, |matrix| product(matrix, color));
        color.map(|value| value as f32)
    }
}

/// Whether a format is that of CIE XYZ.
fn is_xyz(format: &str) -> Result<bool> {
    match format {
        "32-bit_rle_rgbe" => Ok(false),
        "32-bit_rle_xyze" => Ok(true),
        other => Err(Error::new(
            format!("it is of a kind that is not supported (FORMAT={other})"),
            "export it as RGBE",
        )),
    }
}

/// This many finite numbers, and no more.
fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let all: Option<Vec<f64>> = text
        .split_ascii_whitespace()
        .map(|word| word.parse().ok().filter(|number: &f64| number.is_finite()))
        .collect();
    all?.try_into().ok()
}

/// The orientation, and how many pixels a row of the file has and how many rows there are, of a
/// line like `-Y 512 +X 1024`.
fn size(line: &str) -> Option<(Orientation, [usize; 2])> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    let [major, rows, minor, columns] = words.try_into().ok()?;
    let transposed = major.ends_with('X');
    let (x, y) = if transposed { (major, minor) } else { (minor, major) };
    let orientation = Orientation {
        transposed,
        from_right: matches!(x, "-X" | "+X").then_some(x == "-X")?,
        from_bottom: matches!(y, "-Y" | "+Y").then_some(y == "+Y")?,
    };
    Some((orientation, [columns.parse().ok()?, rows.parse().ok()?]))
}

/// Reads a row. The error is the fault.
fn read_row(reader: &mut impl Read, row: &mut [[u8; 4]]) -> std::result::Result<(), String> {
    let mut first = [0; 4];
    fill(reader, &mut first)?;
    let [a, b, high, low] = first;
    if !CODED.contains(&row.len()) || (a, b) != (2, 2) || high > 0x7f {
        return read_pixels(reader, first, row);
    }
    let width = usize::from(u16::from_be_bytes([high, low]));
    if width != row.len() {
        return Err(format!("it has {width} pixels"));
    }
    // Each component by itself: up to 128 different bytes, or one byte more than that often.
    for component in 0..4 {
        let mut column = 0;
        while column < row.len() {
            let [code] = bytes(reader)?;
            let is_run = code > 128;
            let count = usize::from(if is_run { code - 128 } else { code });
            let run = row.get_mut(column..column + count).filter(|run| !run.is_empty());
            let run = run.ok_or("a run has a wrong length")?;
            let mut value = [0];
            for (number, pixel) in run.iter_mut().enumerate() {
                if number == 0 || !is_run {
                    fill(reader, &mut value)?;
                }
                pixel[component] = value[0];
            }
            column += count;
        }
    }
    Ok(())
}

/// Reads pixels one by one. Three mantissas of 1, which no writer makes, repeat the pixel before as
/// often as the exponent states, 256 times that if they follow others, and so on.
fn read_pixels(
    reader: &mut impl Read,
    first: [u8; 4],
    row: &mut [[u8; 4]],
) -> std::result::Result<(), String> {
    let (mut column, mut next, mut shift) = (0_usize, first, 0);
    loop {
        match (next, column.checked_sub(1)) {
            ([1, 1, 1, count], Some(before)) => {
                let before = row[before];
                let count = usize::from(count).checked_shl(shift).unwrap_or(usize::MAX);
                let end = column.checked_add(count).filter(|end| *end <= row.len());
                let end = end.ok_or("a run has a wrong length")?;
                row[column..end].fill(before);
                (column, shift) = (end, shift + 8);
            }
            _ => {
                row[column] = next;
                (column, shift) = (column + 1, 0);
            }
        }
        if column >= row.len() {
            return Ok(());
        }
        next = bytes(reader)?;
    }
}

fn bytes<const N: usize>(reader: &mut impl Read) -> std::result::Result<[u8; N], String> {
    let mut bytes = [0; N];
    fill(reader, &mut bytes)?;
    Ok(bytes)
}

fn fill(reader: &mut impl Read, bytes: &mut [u8]) -> std::result::Result<(), String> {
    reader.read_exact(bytes).map_err(|error| error.to_string())
}
