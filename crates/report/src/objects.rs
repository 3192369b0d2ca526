//! Pictures of objects in their own materials against direct integration under whole maps, without
//! harmonics and without shadows.

mod assets;
mod integral;

pub use assets::all;

use crate::sheet::fields;
use eigenshade::Rgb;
use eigenshade::screen::{Exposure, Meter};
use eigenshade_asset::asset::Asset;
use eigenshade_asset::picture::{Picture, Settings};
use eigenshade_asset::texels::Texels;
use eigenshade_cli::picture::{Canvas, TextHeight};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::object::surface::View;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::parallel;
use eigenshade_model::srgb::srgb;
use indicatif::ProgressBar;
use integral::{Directions, halved};
use std::path::Path;

/// The columns of docs/objects.csv: errors in percent of white.
pub const COLUMNS: &str = "object,light,sources,rms,worst,sampling";

/// The lights.
pub const LIGHTS: [&str; 4] = ["lobby", "park", "workshop", "esplanade"];

/// The most sources of a light.
const SOURCES: usize = 8;

/// Pixels across a picture.
const SIZE: usize = 104;

/// Parts of a pixel across, each of 4 x 4 samples, in the reference: odd, so that the margins of half
/// a pixel and of half a part end at an edge of parts.
const PARTS: usize = 3;

/// The share of the texels of a picture that are also integrated under the map in its full size.
const CHECKED: usize = 40;

/// A picture by the program and by direct integration.
pub struct Pair {
    pub object: &'static str,
    light: &'static str,
    sources: usize,
    /// Irradiance times coverage, r, g and b, and coverage of each pixel: found and expected.
    pictures: [Vec<[f64; 4]>; 2],
    /// The exposure of the expected picture.
    exposure: Exposure,
    /// The rms difference of sums over the map and over that of half its size, of white.
    sampling: f64,
}

/// The pictures of the objects under a light whose map lies in this folder.
///
/// # Errors
///
/// If the map, or a file in the folder of temporary files, cannot be read.
pub fn pairs(
    light: &'static str,
    objects: &[&str],
    maps: &Path,
    progress: &ProgressBar,
) -> Result<Vec<Pair>> {
    let map = EnvironmentMap::from_path(maps.join(format!("{light}.exr")))?;
    let maps = [Directions::new(&map), Directions::new(&halved(&map)?)];
    let all = assets::all().into_iter();
    let all = all.filter(|(name, _)| objects.is_empty() || objects.contains(name));
    let mut pairs = Vec::new();
    for (object, glb) in all {
        let folder = tempfile::tempdir().map_err(|error| Error::io("a folder", &error))?;
        let path = folder.path().join(format!("{object}.glb"));
        std::fs::write(&path, glb.bytes()).map_err(|error| Error::io(&path, &error))?;
        pairs.push(pair(object, light, &path.into(), &maps, progress)?);
    }
    Ok(pairs)
}

fn pair(
    object: &'static str,
    light: &'static str,
    file: &InputFile,
    [whole, half]: &[Directions; 2],
    progress: &ProgressBar,
) -> Result<Pair> {
    let none = || Error::new("no materials", "give a glTF file").in_file(file.path());
    let asset = Asset::read(file)?.ok_or_else(none)?;
    let settings = Settings { size: SIZE, sources: Some(SOURCES), ..Settings::default() };
    let Ok(source) = light.parse();
    let picture = Picture::of(file, &asset, &source, &settings)?;
    let mut found = vec![[0.0; 4]; SIZE * SIZE];
    picture.draw(&mut |pixel, color| {
        let [r, g, b] = <[f32; 3]>::from(color).map(|c| pixel.coverage * f64::from(c));
        found[pixel.row * SIZE + pixel.column] = [r, g, b, pixel.coverage];
    });
    let texels = Texels::of(file, &asset, PARTS * (SIZE - 1) + 1, &View::default())?;
    progress.set_length(texels.texels.len() as u64);
    progress.set_position(0);
    let count = texels.texels.len();
    let colors = parallel::map(count, progress, |k| half.irradiance(&texels.texels[k]));
    let mut expected = vec![[0.0; 4]; SIZE * SIZE];
    let mut shown = colors.iter().zip(&texels.shares);
    for covered in &texels.pixels {
        // The middle of the first part is that of the first pixel.
        let [row, column] = [covered.row, covered.column].map(|k| (k + PARTS / 2) / PARTS);
        let place = row * SIZE + column;
        let share = covered.coverage / (PARTS * PARTS) as f64;
        for (color, part) in shown.by_ref().take(covered.texels) {
            for (sum, c) in expected[place].iter_mut().zip(color) {
                *sum += share * f64::from(*part) * c;
            }
        }
        expected[place][3] += share;
    }
    let mut meter = Meter::default();
    for [r, g, b, coverage] in expected.iter().filter(|pixel| pixel[3] > 0.0) {
        let [r, g, b] = [r, g, b].map(|c| (c / coverage) as f32);
        meter.add(Rgb::new(r, g, b));
    }
    let exposure = meter.exposure().unwrap_or_default();
    let checked = (0..count).step_by(CHECKED);
    let exact = parallel::map(checked.len(), &ProgressBar::hidden(), |k| {
        whole.irradiance(&texels.texels[CHECKED * k])
    });
    let coarse: Vec<[f64; 3]> = checked.map(|k| colors[k]).collect();
    let sampling = rms(exact.as_flattened(), coarse.as_flattened(), exposure);
    let sources = picture.sources;
    Ok(Pair { object, light, sources, pictures: [found, expected], exposure, sampling })
}

/// The display value of an irradiance, from 0 to 1.
fn shown(value: f64, exposure: Exposure) -> f64 {
    (f64::from(exposure.factor()) * value).clamp(0.0, 1.0)
}

fn rms(found: &[f64], expected: &[f64], exposure: Exposure) -> f64 {
    let pairs = found.iter().zip(expected);
    let sum: f64 = pairs.map(|(a, b)| (shown(*a, exposure) - shown(*b, exposure)).powi(2)).sum();
    (sum / found.len() as f64).sqrt()
}

impl Pair {
    /// The numbers of the pixels that the object covers at least in part, of both pictures.
    fn covered(&self) -> [Vec<f64>; 2] {
        let [found, expected] = &self.pictures;
        let is_covered = |k: &usize| found[*k][3] > 0.0 || expected[*k][3] > 0.0;
        let places: Vec<usize> = (0..found.len()).filter(is_covered).collect();
        [found, expected].map(|picture| {
            places.iter().flat_map(|place| picture[*place].into_iter().take(3)).collect()
        })
    }

    /// The rms difference, of white.
    pub fn error(&self) -> f64 {
        let [found, expected] = self.covered();
        rms(&found, &expected, self.exposure)
    }

    /// Its row of docs/objects.csv.
    pub fn fields(&self) -> Vec<String> {
        let [found, expected] = self.covered();
        let apart = found.iter().zip(&expected);
        let apart = apart.map(|(a, b)| (shown(*a, self.exposure) - shown(*b, self.exposure)).abs());
        let percent = |share: f64| format!("{:.2}", 100.0 * share);
        fields(&[
            &self.object,
            &self.light,
            &self.sources,
            &percent(self.error()),
            &format!("{:.0}", 100.0 * apart.fold(0.0, f64::max)),
            &percent(self.sampling),
        ])
    }
}

/// Pixels between pictures, and of the names above them and beside them.
const GAP: usize = 8;
const HEAD: usize = 24;
const SIDE: usize = 96;

/// By how much differences are enlarged.
const ENLARGED: f64 = 10.0;

const BACKGROUND: [u8; 3] = [24; 3];
const TEXT: [u8; 3] = [200; 3];

/// Direct integration, the program's pictures, and ten times their difference.
pub fn canvas(pairs: &[Pair]) -> Canvas {
    let step = SIZE + GAP;
    let mut canvas = Canvas::new(SIDE + pairs.len() * step, HEAD + 3 * step, BACKGROUND);
    for (row, name) in ["integral", "program", "10 x diff."].into_iter().enumerate() {
        let top = HEAD + row * step + SIZE / 2 - 8;
        canvas.text((GAP, top), TextHeight::Size16, TEXT, name);
    }
    for (column, pair) in pairs.iter().enumerate() {
        let left = SIDE + column * step;
        canvas.centered_text((left + SIZE / 2, 4), TextHeight::Size16, TEXT, pair.object);
        let [found, expected] = &pair.pictures;
        for place in 0..SIZE * SIZE {
            let (x, y) = (left + place % SIZE, HEAD + place / SIZE);
            let colors = [&expected[place], &found[place]];
            let pixels =
                colors.map(|pixel| [0, 1, 2].map(|c: usize| shown(pixel[c], pair.exposure)));
            for (row, (pixel, color)) in pixels.iter().zip(colors).enumerate() {
                // Over the background.
                let coverage = color[3].max(1e-9);
                let code = pixel.map(|c| srgb(c / coverage));
                canvas.blend(x, y + row * step, code, color[3].min(1.0));
            }
            let apart = [0, 1, 2].map(|c: usize| ENLARGED * (pixels[1][c] - pixels[0][c]).abs());
            let is_covered = colors.iter().any(|color| color[3] > 0.0);
            canvas.blend(x, y + 2 * step, apart.map(srgb), f64::from(u8::from(is_covered)));
        }
    }
    canvas
}
