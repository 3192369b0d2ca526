//! Fig. 4: spheres rendered with all modes and with the selected modes. Gives a plate, the
//! properties of each sphere, and its irradiance on a grid of normals.

use super::artefact::{Artefact, digits};
use super::plate::Plate;
use super::study::{Modes, Study, Trial, place};
use eigenshade_cli::picture::sphere_view::SphereView;
use eigenshade_cli::picture::tone::exposure;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::reference_image;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::scene::Criterion;
use indicatif::ProgressBar;

/// Material and light of each sphere, chosen from the shipped lights to be as near to the paper's
/// as possible.
pub const SHOWN: [(&str, &str); 3] =
    [("07-velvet", "forest"), ("05-leather", "studio"), ("55-orange-peel", "blender-sunset")];
/// Width of each sphere in pixels.
const SIZE: usize = 288;
/// The share of an image's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.98;

/// The grid of the listed irradiances: x and y of the normals are multiples of 1 / `STEPS`.
const STEPS: i32 = 4;

/// One sphere. Means and errors are over its pixels, each weighted by its share of the disc. Values
/// relative to the peak refer to the largest irradiance, in any channel, of the sphere of all
/// modes.
pub struct Sphere {
    /// Material and light.
    pub names: [&'static str; 2],
    /// The modes that are summed.
    pub modes: Modes,
    /// The factor by which the picture multiplies the irradiance, so that 1 is white.
    pub exposure: f64,
    /// Mean irradiance in r, g and b, under the lights as captured.
    pub mean: [f64; 3],
    /// The largest irradiance in any channel.
    pub peak: f64,
    /// The slant of the peak in degrees.
    pub slant: f64,
    /// The least irradiance in any channel, relative to the peak.
    pub least: f64,
    /// The share of the disc and the channels where the irradiance is negative.
    pub negative: f64,
    /// The difference from the sphere of all modes: root mean square over pixels and channels,
    /// relative to the peak.
    pub off: f64,
    /// The same as the paper's error, computed from the luminance: variance of the difference over
    /// the variance of the image.
    pub error: f64,
    /// Irradiance on the grid, in the order of [`grid`].
    pub listed: Vec<[f64; 3]>,
}

/// The spheres and the plate that shows them.
pub struct Spheres {
    /// The spheres by pair; for each pair all modes, then the selected modes.
    pub all: Vec<Sphere>,
    plate: Artefact,
}

/// The normals whose irradiances are listed, by y from the top, then by x.
#[must_use]
pub fn grid() -> Vec<[f64; 3]> {
    let mut normals = Vec::new();
    for row in (-STEPS..=STEPS).rev() {
        for column in -STEPS..=STEPS {
            let hidden = STEPS * STEPS - row * row - column * column;
            if hidden >= 0 {
                let scale = f64::from(STEPS).recip();
                let z = scale * f64::from(hidden).sqrt();
                normals.push([scale * f64::from(column), scale * f64::from(row), z]);
            }
        }
    }
    normals
}

impl Spheres {
    /// Renders the spheres: one row of the plate by the direct sum of all modes, one with the
    /// selected modes.
    ///
    /// # Errors
    ///
    /// Never in practice: the shipped data contain all images.
    pub fn new(study: &Study, trials: &[Trial], progress: &ProgressBar) -> Result<Self> {
        let table = &study.tables[place(Criterion::ImageCentered, Modes::Selected)];
        let owned = OwnedBasis::<f64>::new(table);
        // All of its components span every image that the selected modes can give.
        let mut shader = Shader::new(owned.basis().map_err(fault)?, usize::MAX);
        let mut plate = Plate::new(SIZE, (SHOWN.len(), 2), (0, 6, 2));
        let view = SphereView::new(SIZE);
        let normals = [view.normals.clone(), grid()].concat();
        let shaded = OwnedNormals::<f64>::new(&normals);
        let mut all = Vec::new();
        for (column, names) in SHOWN.into_iter().enumerate() {
            let trial = study.trial(trials, names.1, names.0)?;
            let (light, material) = (study.light(names.1)?, study.material(names.0)?);
            let lights = Lights { entries: vec![light.clone()], ..study.lights };
            let materials = Materials { entries: vec![material.clone()], ..study.materials };
            let truth = reference_image::images(&lights, &materials, &normals, progress);
            let truth: Vec<[f64; 3]> = truth.iter().map(|of_pairs| of_pairs[0]).collect();
            let selected = shader.colour(
                (study.lights.degree, light),
                (study.materials.order, material),
                &shaded,
            )?;
            let selected: Vec<[f64; 3]> =
                (0..normals.len()).map(|k| selected.each_ref().map(|channel| channel[k])).collect();
            let pixels = view.pixels.len();
            let scale = exposure(truth[..pixels].as_flattened().to_vec(), UNCLIPPED);
            let errors = [0.0, trial.unselected / trial.variance];
            let images = [&truth, &selected];
            for (row, (modes, image)) in Modes::BOTH.into_iter().zip(images).enumerate() {
                let mut one = Sphere::new(&view, image, &truth);
                one.listed = image[pixels..].to_vec();
                (one.names, one.modes) = ([names.0, names.1], modes);
                (one.exposure, one.error) = (scale, errors[row]);
                all.push(one);
                let image: Vec<[f64; 3]> =
                    image.iter().map(|rgb| rgb.map(|value| scale * value)).collect();
                plate.light(column, row, &image);
                plate.below(column, row, 0, &title(&material.name));
                plate.below(column, row, 1, &light.name);
            }
        }
        plate.beside(0, &["3,704", "modes"]);
        plate.beside(1, &["1,000", "modes"]);
        Ok(Self { all, plate: Artefact::picture("spheres.png", plate.finish()) })
    }

    /// The plate and the CSV files.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn artefacts(&self) -> Result<Vec<Artefact>> {
        let (mut rows, mut values) = (Vec::new(), Vec::new());
        for one in &self.all {
            let [material, light] = one.names.map(str::to_owned);
            let first = [light, material, one.modes.count().to_string()];
            let [r, g, b] = one.mean;
            let numbers = [
                one.exposure,
                r,
                g,
                b,
                one.peak,
                one.slant,
                one.least,
                one.negative,
                one.off,
                one.error,
            ];
            rows.push(first.iter().cloned().chain(numbers.map(digits)).collect());
            for ([x, y, z], rgb) in grid().into_iter().zip(&one.listed) {
                let numbers = [x, y, z].into_iter().chain(*rgb).map(digits);
                values.push(first.iter().cloned().chain(numbers).collect());
            }
        }
        let header = "light,material,modes,exposure,mean_r,mean_g,mean_b,\
                      peak,slant_of_peak,least_of_peak,share_below_zero,rms_off_of_peak,error";
        let listed = "light,material,modes,x,y,z,r,g,b";
        Ok(vec![
            Artefact::csv("spheres.csv", header, &rows)?,
            Artefact::csv("spheres_values.csv", listed, &values)?,
            self.plate.clone(),
        ])
    }
}

impl Sphere {
    /// Compares an image with the reference; its names and modes are left empty.
    fn new(view: &SphereView, image: &[[f64; 3]], truth: &[[f64; 3]]) -> Self {
        let area: f64 = view.pixels.iter().map(|pixel| pixel.coverage).sum();
        let mut mean = [0.0; 3];
        let (mut square, mut negative) = (0.0, 0.0);
        let (mut least, mut peak, mut slant) = (f64::INFINITY, 0.0, 0.0);
        let pixels = view.pixels.iter().zip(&view.normals).zip(image.iter().zip(truth));
        for ((pixel, [x, y, z]), (rgb, truth)) in pixels {
            for (channel, (value, truth)) in rgb.iter().zip(truth).enumerate() {
                mean[channel] += pixel.coverage * value / area;
                let share = pixel.coverage / (3.0 * area);
                square += share * (value - truth).powi(2);
                negative += if *value < 0.0 { share } else { 0.0 };
                least = value.min(least);
                if *value > peak {
                    (peak, slant) = (*value, x.hypot(*y).atan2(*z).to_degrees());
                }
            }
        }
        let truths = truth.iter().take(view.pixels.len()).flatten();
        let largest = truths.fold(0.0, |most: f64, value| most.max(*value));
        Self {
            names: [""; 2],
            modes: Modes::All,
            exposure: 1.0,
            mean,
            peak,
            slant,
            least: least / largest,
            negative,
            off: square.sqrt() / largest,
            error: 0.0,
            listed: Vec::new(),
        }
    }
}

/// A material's name for readers, without number and hyphens.
#[must_use]
pub fn title(name: &str) -> String {
    name.trim_start_matches(|letter: char| letter.is_ascii_digit() || letter == '-')
        .replace('-', " ")
}
