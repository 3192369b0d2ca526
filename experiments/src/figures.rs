//! The files that a command makes in a folder: texts, charts and pictures, written or compared with
//! those that are there. Words and elements must be equal, numbers nearly so: hosts differ in the
//! last digits, which decide how a value between two whole pixels or levels is rounded.

use crate::pages::compare_words;
use crate::sheet;
use eigenshade_cli::output;
use eigenshade_cli::picture::{self, Canvas};
use eigenshade_generator::png_samples::{self, PngSamples};
use eigenshade_model::error::{self, Error};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

pub struct Figures {
    /// The command's name, which the first line of each text states.
    pub command: &'static str,
    /// The folder of its figures: empty, or with `/` at its end.
    pub folder: &'static str,
    /// Whether texts are made from recorded CSV files, so that they must be the same. Otherwise
    /// their numbers must be near, see [`texts`].
    pub is_exact: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct OutputFile {
    /// Its path relative to the requested folder, with `/` as the separator.
    pub name: String,
    pub content: Content,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// CSV, Markdown or SVG.
    Text(String),
    /// PNG.
    Picture(Canvas),
}

impl OutputFile {
    pub fn text(name: impl Into<String>, text: String) -> Self {
        Self { name: name.into(), content: Content::Text(text) }
    }

    /// Writes the file below `folder`, either completely or not at all.
    pub fn write(&self, folder: &Path) -> error::Result<()> {
        let path = folder.join(&self.name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|error| Error::io(parent, &error))?;
        }
        match &self.content {
            Content::Text(text) => output::write_all(Some(&path), text),
            Content::Picture(canvas) => {
                picture::write_png(&path, canvas.width, canvas.height, &canvas.bytes)
            }
        }
    }
}

impl Figures {
    /// A CSV; `columns` are separated by commas.
    pub fn csv<R: IntoIterator<Item: AsRef<[u8]>>>(
        &self,
        name: &str,
        columns: &str,
        rows: impl IntoIterator<Item = R>,
    ) -> error::Result<OutputFile> {
        let text = sheet::csv(&format!("experiments {}", self.command), columns, rows)?;
        Ok(OutputFile::text(format!("{}{name}", self.folder), text))
    }

    pub fn chart(&self, name: &str, svg: &str) -> OutputFile {
        let text = format!("<!-- experiments {} -->\n{svg}", self.command);
        OutputFile::text(format!("{}{name}", self.folder), text)
    }

    pub fn picture(&self, name: &str, canvas: Canvas) -> OutputFile {
        let name = format!("{}{name}", self.folder);
        OutputFile { name, content: Content::Picture(canvas) }
    }

    /// The remedy for a file in `folder` that differs, with options for the command.
    pub fn again(&self, folder: &Path, options: &str) -> String {
        let (command, folder) = (self.command, folder.display());
        format!(
            "make it again with `cargo run --release -p experiments -- {command} --out \
             {folder}{options}`"
        )
    }

    /// Writes the files below `folder`, unless two of them lead to the same place.
    pub fn write(&self, files: &[OutputFile], folder: &Path) -> error::Result<()> {
        let paths = files.iter().map(|file| folder.join(&file.name));
        output::refuse_collisions(paths, std::iter::empty::<&Path>())?;
        files.iter().try_for_each(|file| file.write(folder))
    }

    /// Compares every file with the one in `folder`. Returns how many numbers of texts (coordinates
    /// and colors of charts included) and how many pixels were compared. The error is the first
    /// file that is missing, differs, or does not belong.
    pub fn compare(&self, files: &[OutputFile], folder: &Path) -> error::Result<[usize; 2]> {
        let [mut numbers, mut pixels] = [0, 0];
        let again = self.again(folder, if self.is_exact { " --from-csv" } else { "" });
        for file in files {
            let path = folder.join(&file.name);
            let fault = |what: String| Error::new(what, &*again).in_file(&path);
            let unreadable = |error: std::io::Error| match error.kind() {
                ErrorKind::NotFound => fault("this figure is missing".into()),
                _ => Error::io(&path, &error),
            };
            match &file.content {
                Content::Text(text) => {
                    let found = fs::read_to_string(&path).map_err(unreadable)?;
                    if self.is_exact && found != *text {
                        return Err(fault("it is not what the CSV files give".into()));
                    }
                    let is_chart = file.name.ends_with(".svg");
                    numbers += texts(&found, text, is_chart).map_err(fault)?;
                }
                Content::Picture(canvas) => {
                    fs::metadata(&path).map_err(unreadable)?;
                    let found =
                        png_samples::read(&path).map_err(|error| error.with_remedy(&*again))?;
                    pixels += pictures(&found, canvas).map_err(fault)?;
                }
            }
        }
        // Another file among the figures would be mistaken for a figure.
        let figures = folder.join(self.folder);
        let fault = |error: std::io::Error| Error::io(&figures, &error);
        for entry in fs::read_dir(&figures).map_err(fault)? {
            let path = entry.map_err(fault)?.path();
            if files.iter().all(|file| folder.join(&file.name) != path) {
                let remedy = "remove it, or keep it elsewhere";
                return Err(Error::new("the program makes no such figure", remedy).in_file(path));
            }
        }
        Ok([numbers, pixels])
    }
}

/// The allowed relative difference of two numbers of a CSV: two units of the six digits.
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

/// Compares two texts. Returns how many numbers and colors were compared. The error is the first
/// difference, with its line counted from 1.
pub fn texts(recorded: &str, now: &str, is_chart: bool) -> Result<usize, String> {
    let [recorded, now] = [recorded, now].map(spaced);
    let values = now.split_whitespace().filter_map(number);
    let floor = FLOOR * values.fold(0.0, |most, (value, _)| value.abs().max(most));
    let (mut attribute, mut count) = (String::new(), 0);
    compare_words(&recorded, &now, |_, old, new| {
        if let Some(name) = new.strip_suffix('=') {
            name.clone_into(&mut attribute);
        } else if new.ends_with('>') {
            attribute.clear();
        }
        let near = match &*attribute {
            _ if !is_chart => numbers(old, new, floor),
            "fill" | "stroke" => colors(old, new),
            name if COORDINATES.contains(&name) => numbers(old, new, PIXELS),
            _ => None,
        };
        count += usize::from(near.is_some());
        near.unwrap_or(old == new)
    })?;
    Ok(count)
}

/// The text with blanks around its punctuation, so that numbers are words.
fn spaced(text: &str) -> String {
    let signs = [",", "|", "(", ")", ";", ":", "\""];
    signs.iter().fold(text.to_owned(), |text, sign| text.replace(sign, &format!(" {sign} ")))
}

/// Whether two numbers are near, `None` if they are not both numbers. `floor` is always allowed.
fn numbers(old: &str, new: &str, floor: f64) -> Option<bool> {
    let ((a, _), (b, unit)) = (number(old)?, number(new)?);
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
fn colors(old: &str, new: &str) -> Option<bool> {
    let channels = |color: &str| {
        let digits = color.strip_prefix('#').filter(|digits| digits.len() == 6)?;
        Some(u32::from_str_radix(digits, 16).ok()?.to_be_bytes())
    };
    let (a, b) = (channels(old)?, channels(new)?);
    Some(a.iter().zip(b).all(|(a, b)| u16::from(a.abs_diff(b)) <= LEVELS))
}

/// Compares two pictures. Returns the number of pixels, or a description of the difference.
pub fn pictures(found: &PngSamples, expected: &Canvas) -> Result<usize, String> {
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
        for (a, b, is_same) in [
            ("a,1.00001e-3,7\n", "a,1.00002e-3,7\n", true),
            ("about 0.7 % of it.", "about 0.8 % of it.", true),
            // Rounding, compared with the largest number of the file.
            ("1\n3e-20", "1\n5e-20", true),
            ("about 0.7 % of it.", "about 0.9 % of it.", false),
            ("a,1.00001e-3,7", "a,1.0005e-3,7", false),
            ("a,7", "a,8", false),
            ("a,7", "b,7", false),
            ("a,7", "a", false),
            ("a,7,", "a,,7", false),
            ("a\nb", "a", false),
            ("a,NaN", "a,1", false),
        ] {
            assert_eq!(texts(a, b, false).is_ok(), is_same, "{a} {b}");
        }
        assert_eq!(texts("x 1,2\n3", "x 1,2\n3", false), Ok(3));
        assert!(texts("1\n2", "1\n3", false).unwrap_err().starts_with("line 2: "));
    }

    #[test]
    fn one_pixel_and_one_level_may_differ_and_nothing_else() {
        const CHART: &str = "<svg width=\"720\">\n<polyline fill=\"none\" opacity=\"1\" \
            stroke=\"#005FAA\" points=\"98,52 104,53 \"/>\n<rect x=\"90\" y=\"7\" \
            fill=\"#90C4DE\"/>\n<text x=\"1\" y=\"2\">\n10 %\n</text>\n</svg>\n";
        let with = |from: &str, to: &str| texts(&CHART.replace(from, to), CHART, true);
        assert_eq!(texts(CHART, CHART, true), Ok(10));
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
            let message = with(from, to).expect_err(from);
            assert!(message.starts_with(&format!("line {line}: ")), "{from} {to}: {message}");
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
            to_srgb: None,
            orientation: None,
        };
        type Change<'a> = &'a dyn Fn(&mut PngSamples);
        let with = |change: Change<'_>| {
            let mut changed = same.clone();
            change(&mut changed);
            pictures(&changed, &canvas)
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
