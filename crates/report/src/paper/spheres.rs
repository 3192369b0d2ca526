//! Fig. 4: spheres rendered with all modes and with the selected modes. Gives a plate, the
//! properties of each sphere, and its irradiance on a grid of normals.

use super::plate::{Plate, UNCLIPPED};
use super::{Modes, Study, csv, place, row, title};
use crate::figures::OutputFile;
use crate::numbers::exposure;
use eigenshade_cli::picture::SphereView;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::reference_image;
use eigenshade_table::scene::Criterion;

/// Material and light of each sphere, chosen from the shipped lights to be as near to the paper's
/// as possible: one matte with a bright rim, one glossy, one between the two.
pub const SHOWN: [(&str, &str); 3] =
    [("07-velvet", "forest"), ("05-leather", "studio"), ("55-orange-peel", "blender-sunset")];
/// Width of each sphere in pixels.
const SIZE: usize = 288;
/// The grid of the listed irradiances: x and y of the normals are multiples of 1 / `STEPS`.
const STEPS: i32 = 4;
/// Normals that are shaded together.
const BAND: usize = 1 << 12;

/// One row of the plate is by the direct sum of all modes, one has the selected modes.
pub fn files(study: &Study) -> Result<Vec<OutputFile>> {
    let table = &study.tables[place(Criterion::ImageCentered, Modes::Selected)];
    // All of its components span every image that the selected modes can give.
    let evaluator = Evaluator::new(table);
    let mut plate = Plate::new(SIZE, (SHOWN.len(), 2), [0, 6, 2]);
    let normals = [plate.view.normals.clone(), grid()].concat();
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for (column, (material_name, light_name)) in SHOWN.into_iter().enumerate() {
        let trial = study.trial(light_name, material_name)?;
        let light = &study.lights.entries[trial.light];
        let material = &study.materials.entries[trial.material];
        let lights = Lights { entries: vec![light.clone()], ..study.lights };
        let materials = Materials { entries: vec![material.clone()], ..study.materials };
        let whole = reference_image::images(&lights, &materials, &normals, &());
        let whole: Vec<[f64; 3]> = whole.iter().map(|of_pairs| of_pairs[0]).collect();
        let d = |c: usize| evaluator.project(&light.rgb[c], &material.rgb[c]);
        let d = [d(0)?, d(1)?, d(2)?];
        // Not all eigenimages at once, which take 200 MB.
        let selected = normals.chunks(BAND).flat_map(|normals| {
            let eigenimages = evaluator.eigenimages(normals);
            let rgb = d.each_ref().map(|d| eigenimages.reconstruct(d));
            (0..normals.len()).map(move |k| rgb.each_ref().map(|channel| channel[k]))
        });
        let selected: Vec<[f64; 3]> = selected.collect();
        let pixels = plate.view.pixels.len();
        let scale = exposure(whole[..pixels].as_flattened().to_vec(), UNCLIPPED);
        let errors = [0.0, trial.unselected / trial.variance];
        for (line, modes) in Modes::BOTH.into_iter().enumerate() {
            let image = [&whole, &selected][line];
            let measured = measures(&plate.view, image, &whole);
            let numbers = [scale].into_iter().chain(measured).chain([errors[line]]);
            let count = modes.count();
            let fields = |numbers| row(&[&light_name, &material_name, &count], numbers);
            rows.push(fields(numbers.collect::<Vec<f64>>()));
            for (normal, rgb) in grid().into_iter().zip(&image[pixels..]) {
                values.push(fields([normal, *rgb].concat()));
            }
            plate.light((column, line), scale, image.iter().copied());
            plate.below((column, line), &[&title(material_name), light_name]);
        }
    }
    plate.beside(0, &["3,704", "modes"]);
    plate.beside(1, &["1,000", "modes"]);
    let header = "light,material,modes,exposure,mean_r,mean_g,mean_b,\
                  peak,slant_of_peak,least_of_peak,share_below_zero,rms_off_of_peak,error";
    let listed = "light,material,modes,x,y,z,r,g,b";
    Ok(vec![
        csv("spheres.csv", header, &rows)?,
        csv("spheres_values.csv", listed, &values)?,
        OutputFile::picture("spheres.png", plate.finish()),
    ])
}

/// The normals whose irradiances are listed, by y from the top, then by x.
fn grid() -> Vec<[f64; 3]> {
    let rows = (-STEPS..=STEPS).rev();
    let places = rows.flat_map(|y| (-STEPS..=STEPS).map(move |x| (x, y)));
    let normal = |(x, y): (i32, i32)| {
        let hidden = STEPS * STEPS - x * x - y * y;
        let normal = [f64::from(x), f64::from(y), f64::from(hidden).sqrt()];
        (hidden >= 0).then(|| normal.map(|one| f64::from(STEPS).recip() * one))
    };
    places.filter_map(normal).collect()
}

/// The mean irradiance in r, g and b; the peak in any channel and its slant in degrees; the least
/// irradiance; the share of the disc and the channels that is negative; the root mean square
/// difference from the image of all modes. Means are over pixels, each weighted by its share of the
/// disc. The least and the difference are relative to the peak of all modes.
fn measures(view: &SphereView, image: &[[f64; 3]], whole: &[[f64; 3]]) -> [f64; 8] {
    let area: f64 = view.pixels.iter().map(|pixel| pixel.coverage).sum();
    let mut mean = [0.0; 3];
    let (mut square, mut negative, mut largest) = (0.0, 0.0, 0.0f64);
    let (mut least, mut peak, mut slant) = (f64::INFINITY, 0.0, 0.0);
    let pixels = view.pixels.iter().zip(&view.normals).zip(image.iter().zip(whole));
    for ((pixel, [x, y, z]), (rgb, whole)) in pixels {
        for (channel, (value, whole)) in rgb.iter().zip(whole).enumerate() {
            mean[channel] += pixel.coverage * value / area;
            let share = pixel.coverage / (3.0 * area);
            square += share * (value - whole).powi(2);
            negative += if *value < 0.0 { share } else { 0.0 };
            least = value.min(least);
            largest = largest.max(*whole);
            if *value > peak {
                (peak, slant) = (*value, x.hypot(*y).atan2(*z).to_degrees());
            }
        }
    }
    let [r, g, b] = mean;
    [r, g, b, peak, slant, least / largest, negative, square.sqrt() / largest]
}
