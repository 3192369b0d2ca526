//! Compares a folder of figures with those that the program makes now: the page, CSV, charts and
//! pictures. Neither side may have additional files. Words and elements must be equal, numbers
//! nearly so: hosts differ in the last digits of their arithmetic, and where a value lies between
//! two whole pixels or levels, such a digit decides how it is rounded.

use super::output_file::{Content, FOLDER, OutputFile};
use eigenshade_cli::picture::Canvas;
use eigenshade_generator::png_samples::{self, PngSamples};
use eigenshade_model::error::{Error, Result};
use std::ffi::OsString;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The allowed difference of two numbers of a CSV, relative to the larger one: two units of the six
/// digits.
const ALLOWED: f64 = 2e-5;
/// The difference that is always allowed, relative to the largest number of the file: rounding.
const FLOOR: f64 = 1e-13;
/// The allowed difference of a coordinate, in pixels of the chart.
const PIXELS: f64 = 1.0;
/// The allowed difference of a color channel of charts and pictures, out of 255.
const LEVELS: u16 = 1;
/// The share of a picture's pixels that may differ at all.
const SHARE: f64 = 1e-3;
/// Attributes of SVG that are coordinates; all others except colors must be equal.
const COORDINATES: [&str; 9] = ["x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "points"];

/// Compares every file with the one in `folder`. Returns how many numbers of texts (coordinates and
/// colors of charts included) and how many pixels were compared.
///
/// # Errors
///
/// The first file that is missing, differs, or does not belong; for a text, with its line.
pub fn compare(files: &[OutputFile], folder: &Path) -> Result<[usize; 2]> {
    let folder_name = folder.display();
    let again = || {
        format!(
            "make it again with `cargo run --release -p experiments -- paper --out {folder_name}`"
        )
    };
    let [mut numbers, mut pixels] = [0, 0];
    for file in files {
        let path = folder.join(&file.name);
        let fault = |error: std::io::Error| match error.kind() {
            ErrorKind::NotFound => Error::new("this figure is missing", again()).in_file(&path),
            _ => Error::io(&path, &error),
        };
        match &file.content {
            Content::Text(text) => {
                let found = fs::read_to_string(&path).map_err(fault)?;
                let is_chart = file.name.ends_with(".svg");
                numbers += compare_texts(&found, text, is_chart)
                    .map_err(|(line, what)| Error::new(what, again()).at_line(&path, line))?;
            }
            Content::Picture(canvas) => {
                fs::metadata(&path).map_err(fault)?;
                let found = png_samples::read(&path).map_err(|error| error.with_remedy(again()))?;
                pixels += compare_pictures(&found, canvas)
                    .map_err(|what| Error::new(what, again()).in_file(&path))?;
            }
        }
    }
    no_others(files, folder)?;
    Ok([numbers, pixels])
}

/// An extra file among the figures would be mistaken for a figure.
fn no_others(files: &[OutputFile], folder: &Path) -> Result<()> {
    let figures = folder.join(FOLDER);
    let fault = |error: std::io::Error| Error::io(&figures, &error);
    let entries = fs::read_dir(&figures).map_err(fault)?;
    let names = entries.map(|entry| entry.map(|entry| entry.file_name()));
    let mut names: Vec<OsString> = names.collect::<std::io::Result<_>>().map_err(fault)?;
    names.sort();
    let belongs = |name: &OsString| {
        let name = name.to_str().map(|name| format!("{FOLDER}/{name}"));
        files.iter().any(|file| Some(&file.name) == name.as_ref())
    };
    match names.iter().find(|name| !belongs(name)) {
        None => Ok(()),
        Some(name) => {
            let remedy = "remove it, or keep it elsewhere";
            Err(Error::new("the program makes no such figure", remedy).in_file(figures.join(name)))
        }
    }
}

/// Compares two texts. Returns the number of numbers and colors, or the first line (counted from 1)
/// where they differ, with a description.
fn compare_texts(
    found: &str,
    expected: &str,
    is_chart: bool,
) -> std::result::Result<usize, (u64, String)> {
    let values = expected.split(separates).filter_map(number);
    let floor = FLOOR * values.fold(0.0, |most, (value, _)| value.abs().max(most));
    let mut count = 0;
    let (mut found_lines, mut expected_lines) = (found.lines(), expected.lines());
    for line in 1.. {
        let (found, expected) = match (found_lines.next(), expected_lines.next()) {
            (None, None) => break,
            (Some(found), Some(expected)) => (found, expected),
            _ => return Err((line, "one line more or less than there should be".into())),
        };
        let differs = || (line, format!("`{}` where `{}` belongs", start(found), start(expected)));
        let [a, b] = [found, expected].map(|line| line.split(separates).collect::<Vec<_>>());
        if a.len() != b.len() {
            return Err(differs());
        }
        let mut attribute = "";
        for (found, expected) in a.into_iter().zip(b) {
            let near = match (is_chart, attribute) {
                (true, "fill" | "stroke") => colors(found, expected),
                (true, name) if COORDINATES.contains(&name) => numbers(found, expected, PIXELS),
                (true, _) => None,
                (false, _) => numbers(found, expected, floor),
            };
            match near {
                Some(true) => count += 1,
                None if found == expected => {}
                _ => return Err(differs()),
            }
            attribute = expected.strip_suffix('=').unwrap_or(match expected.ends_with('>') {
                true => "",
                false => attribute,
            });
        }
    }
    Ok(count)
}

fn separates(letter: char) -> bool {
    letter.is_whitespace() || matches!(letter, ',' | '|' | '(' | ')' | ';' | ':' | '"')
}

/// Whether two numbers are near, `None` if they are not both numbers. `floor` is always allowed.
fn numbers(found: &str, expected: &str, floor: f64) -> Option<bool> {
    let ((a, _), (b, unit)) = (number(found)?, number(expected)?);
    let allowed = (ALLOWED * a.abs().max(b.abs())).max(floor).max(unit);
    Some((a - b).abs() <= allowed)
}

/// A number, and one unit of its last digit if it has a decimal point, because a number with fewer
/// digits may be rounded either way. Whole numbers are counts and must be equal.
fn number(word: &str) -> Option<(f64, f64)> {
    let word = word.trim_end_matches('.');
    let value: f64 = word.parse().ok().filter(|value: &f64| value.is_finite())?;
    let (digits, power) = word.split_once('e').unwrap_or((word, "0"));
    let places = digits.split_once('.').map(|(_, places)| places.len());
    let power: i32 = power.parse().ok()?;
    let unit = places.map_or(0.0, |places| 10f64.powi(power - places as i32));
    Some((value, 1.000_001 * unit))
}

/// Whether two colors `#RRGGBB` are near, `None` if they are not both colors.
fn colors(found: &str, expected: &str) -> Option<bool> {
    let channels = |color: &str| {
        let digits = color.strip_prefix('#').filter(|digits| digits.len() == 6)?;
        Some(u32::from_str_radix(digits, 16).ok()?.to_be_bytes())
    };
    let (a, b) = (channels(found)?, channels(expected)?);
    Some(a.iter().zip(b).all(|(a, b)| u16::from(a.abs_diff(b)) <= LEVELS))
}

/// The beginning of a line, for a message.
fn start(line: &str) -> &str {
    line.char_indices().nth(60).map_or(line, |(end, _)| &line[..end])
}

/// Compares two pictures. Returns the number of pixels, or a description of the difference.
fn compare_pictures(found: &PngSamples, expected: &Canvas) -> std::result::Result<usize, String> {
    let (width, height) = (expected.width, expected.height);
    if (found.width, found.height) != (width, height) {
        let size = format!("it has {} x {} pixels", found.width, found.height);
        return Err(format!("{size} where {width} x {height} belong"));
    }
    if found.full != u16::from(u8::MAX) || found.opacities.iter().any(|one| *one != found.full) {
        return Err("it is not opaque with 8 bits a channel".into());
    }
    let mut off = 0;
    let (pixels, _) = expected.bytes.as_chunks::<3>();
    for (place, (found, expected)) in found.colors.iter().zip(pixels).enumerate() {
        let expected = expected.map(u16::from);
        let apart = found.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0);
        if apart > LEVELS {
            let at = format!("pixel ({}, {})", place % width, place / width);
            return Err(format!("{at} has {found:?} where {expected:?} belongs"));
        }
        off += usize::from(apart > 0);
    }
    let most = (SHARE * pixels.len() as f64) as usize;
    if off > most {
        return Err(format!("{off} of its pixels are off by a level where {most} may be"));
    }
    Ok(pixels.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use eigenshade_generator::png_samples::Curve;

    #[test]
    fn last_digits_may_differ_and_nothing_else() {
        let same = |a: &str, b: &str| compare_texts(a, b, false).is_ok();
        assert!(same("a,1.00001e-3,7\n", "a,1.00002e-3,7\n"));
        assert!(same("about 0.7 % of it.", "about 0.8 % of it."));
        assert!(!same("about 0.7 % of it.", "about 0.9 % of it."));
        for (a, b) in [("a,1.00001e-3,7", "a,1.0005e-3,7"), ("a,7", "a,8"), ("a,7", "b,7")] {
            assert!(!same(a, b), "{a} {b}");
        }
        assert!(!same("a,7", "a") && !same("a\nb", "a") && !same("a,NaN", "a,1"));
        // Rounding, compared with the largest number of the file.
        assert!(same("1\n3e-20", "1\n5e-20"));
        assert_eq!(compare_texts("x 1,2\n3", "x 1,2\n3", false), Ok(3));
        assert_eq!(compare_texts("1\n2", "1\n3", false).unwrap_err().0, 2);
    }

    const CHART: &str = "<svg width=\"720\">\n\
        <polyline fill=\"none\" opacity=\"1\" stroke=\"#005FAA\" points=\"98,52 104,53 \"/>\n\
        <rect x=\"90\" y=\"7\" fill=\"#90C4DE\"/>\n<text x=\"1\" y=\"2\">\n10 %\n</text>\n</svg>\n";

    #[test]
    fn one_pixel_and_one_level_may_differ_and_nothing_else() {
        let with = |from: &str, to: &str| compare_texts(&CHART.replace(from, to), CHART, true);
        assert_eq!(compare_texts(CHART, CHART, true), Ok(10));
        assert!(with("104,53", "105,52").is_ok() && with("#90C4DE", "#91C3DE").is_ok());
        for (from, to, line) in [
            ("104,53", "104,55", 2),
            ("104,53", "104,NaN", 2),
            ("104,53 ", "104,53 105,54 ", 2),
            ("#005FAA", "#0061AA", 2),
            ("\"none\"", "\"#000000\"", 2),
            ("opacity=\"1\"", "opacity=\"0\"", 2),
            ("polyline", "polygon", 2),
            ("y=\"7\"", "z=\"7\"", 3),
            ("10 %", "11 %", 5),
            ("720", "721", 1),
            ("</text>\n", "", 6),
        ] {
            assert_eq!(with(from, to).map_err(|(line, _)| line), Err(line), "{from} {to}");
        }
    }

    #[test]
    fn a_level_here_and_there_may_differ_and_nothing_else() {
        let canvas = Canvas::new(50, 40, [10, 20, 30]);
        let same = PngSamples {
            width: 50,
            height: 40,
            full: 255,
            curve: Curve::Srgb,
            colors: vec![[10, 20, 30]; 2000],
            opacities: vec![255; 2000],
        };
        type Change<'a> = &'a dyn Fn(&mut PngSamples);
        let with = |change: Change<'_>| {
            let mut changed = same.clone();
            change(&mut changed);
            compare_pictures(&changed, &canvas)
        };
        assert_eq!(with(&|_| ()), Ok(2000));
        assert_eq!(with(&|one| one.colors[..2].fill([11, 19, 30])), Ok(2000));
        let wrong: [(Change<'_>, &str); 5] = [
            (&|one| one.colors[..3].fill([11, 19, 30]), "3 of its pixels"),
            (&|one| one.colors[52][2] = 32, "pixel (2, 1)"),
            (&|one| one.opacities[7] = 254, "opaque"),
            (&|one| one.full = u16::MAX, "8 bits"),
            (&|one| (one.width, one.height) = (40, 50), "40 x 50"),
        ];
        for (change, word) in wrong {
            assert!(with(change).is_err_and(|what| what.contains(word)), "{word}");
        }
    }
}
