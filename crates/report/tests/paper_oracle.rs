//! The figures of `docs/paper.md` against direct quadrature of (3), which shares no code with them.

use crate::support::repository;
use crate::{oracle, tolerances};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::irradiance;
use eigenshade_model::parallel;
use eigenshade_model::selection::variances;
use eigenshade_table::{light, material, mode};
use eigenshade_testing::fixtures::of_equal_areas;
use report::paper::bound::render;
use report::paper::partial_sum::PartialSum;
use report::paper::{DEGREE, Modes, ORDER, Study};
use report::sheet::Sheet;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// Errors of representation and of partial sums, over nodes against pixels, relative to the image's
/// energy: 28 intervals in cos α are exact, so only the rounding of some thousand terms remains.
const FIGURE_ERROR: f64 = 2e-13;
/// Irradiances of six digits, relative to the peak: half a unit of the last digit.
const LISTED: f64 = 6e-6;
/// The least ratio of a partial sum's error to its bound: below it, the bound would not be tested.
const BOUND_AT_WORK: f64 = 0.01;
/// The part that a partial sum leaves out at a pixel, relative to the peak: far above the tolerance
/// of the sum, so that a sum of all terms fails.
const LEFT_OUT: f64 = 1e-5;
/// Intervals in cos α, and steps in β: images of degree 9 have |m| up to 9.
const INTERVALS: usize = 28;
const TILTS: usize = 20;

/// The shipped data, shared by all tests of the paper's figures.
pub fn study() -> &'static Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| Study::new().expect("the shipped data"))
}

/// A committed CSV of the figures.
pub fn sheet(name: &str) -> Sheet {
    let path = repository().join(format!("docs/paper/{name}.csv"));
    Sheet::parse(&std::fs::read_to_string(path).expect("a text"), name).expect("a CSV")
}

/// Normals with the weights of cos(α)/π: 2z dz by Clenshaw and Curtis, equal steps in β.
fn pixels() -> Vec<([f64; 3], f64)> {
    let mut pixels = Vec::new();
    for (z, weight) in oracle::clenshaw_curtis(INTERVALS) {
        let sine = (1.0 - z * z).sqrt();
        // The rim has no weight.
        for tilt in (0..TILTS).filter(|_| z > 0.0) {
            let (y, x) = (2.0 * PI * (tilt as f64 + 0.3) / TILTS as f64).sin_cos();
            pixels.push(([sine * x, sine * y, z], 2.0 * z * weight / TILTS as f64));
        }
    }
    pixels
}

fn mean(pixels: &[([f64; 3], f64)], value: impl Fn(usize) -> f64) -> f64 {
    pixels.iter().enumerate().map(|(k, (_, weight))| weight * value(k)).sum()
}

/// Light and material of the image that both sums over pixels use.
const SEEN: [&str; 2] = ["studio", "05-leather"];

/// That image at the pixels.
fn image(pixels: &[([f64; 3], f64)]) -> &'static [f64] {
    static IMAGE: OnceLock<Vec<f64>> = OnceLock::new();
    IMAGE.get_or_init(|| {
        let study = study();
        let trial = study.trial(SEEN[0], SEEN[1]).expect("it is there");
        let explicit = oracle::ExplicitLight::new(&study.luminances[trial.light]);
        let indices = material::indices(ORDER).zip(&study.grays[trial.material]);
        let terms: Vec<_> = indices.map(|((o, p, q), b)| (o, p, q, *b)).collect();
        parallel::map(pixels.len(), &(), |k| oracle::irradiance(&explicit, &terms, pixels[k].0))
    })
}

#[test]
fn errors_are_those_of_pixels() {
    let study = study();
    let trial = study.trial(SEEN[0], SEEN[1]).expect("it is there");
    let pixels = pixels();
    let image = image(&pixels);
    let average = mean(&pixels, |k| image[k]);
    let variance = mean(&pixels, |k| (image[k] - average).powi(2));
    let near = |found: f64, expected: f64, what: &str| {
        let off = (found - expected).abs() / variance;
        println!("{what}: {off:.1e}");
        assert!(off <= FIGURE_ERROR, "{what}: {found} {expected}");
    };
    near(trial.variance, variance, "variance");
    near(trial.mean * trial.mean, average * average, "mean");

    for (table, fit) in study.tables.iter().zip(&trial.fits) {
        let normals: Vec<[f64; 3]> = pixels.iter().map(|(normal, _)| *normal).collect();
        let eigenimages = Evaluator::new(table).with_components(50).eigenimages(&normals);
        // Standard PCA's basis adds its mean image to everything.
        let pairs = image.iter().zip(eigenimages.mean());
        let mut residual: Vec<f64> = pairs.map(|(a, b)| a - b).collect();
        let criterion = table.scene.basis.criterion.name();
        for count in 0..50 {
            let eigenimage = eigenimages.eigenimage(count);
            if [0, 1, 5, 10, 30].contains(&count) {
                let center = mean(&pixels, |k| residual[k]);
                let left = mean(&pixels, |k| (residual[k] - center).powi(2));
                near(fit.variances[count], left, &format!("{criterion}, {count}"));
            }
            let d = mean(&pixels, |k| residual[k] * eigenimage[k]);
            residual.iter_mut().zip(&eigenimage).for_each(|(r, u)| *r -= d * u);
        }
    }
}

/// l, m, o, p, q.
type Mode = (usize, isize, usize, usize, usize);

/// The size, the coefficient and the mode of every term of an image, the strongest first.
fn strongest(light: &[f64], material: &[f64]) -> Vec<(f64, f64, Mode)> {
    let mut terms = Vec::new();
    let top = DEGREE.cast_signed();
    for m in -top..=top {
        let azimuth = m.unsigned_abs();
        let modes = mode::indices(DEGREE, ORDER, azimuth);
        for ((l, o, p, q), variance) in modes.zip(variances(&study().gram, azimuth)) {
            let c = light[light::position(l, m)] * material[material::position(o, p, q)];
            terms.push((c.abs() * variance.sqrt(), c, (l, m, o, p, q)));
        }
    }
    terms.sort_by(|a, b| b.0.total_cmp(&a.0));
    terms
}

/// A sum of the strongest terms, each by (14) at each pixel.
#[test]
fn partial_sums_are_those_of_pixels_and_within_their_bound() {
    const TERMS: usize = 150;
    let study = study();
    let trial = study.trial(SEEN[0], SEEN[1]).expect("it is there");
    let (light, material) = (&study.luminances[trial.light], &study.grays[trial.material]);
    let pixels = pixels();
    let mut left = image(&pixels).to_vec();
    let energy = mean(&pixels, |k| left[k] * left[k]);

    let terms = strongest(light, material);
    for &(_, c, (l, m, o, p, q)) in &terms[..TERMS] {
        for (left, ([x, y, z], _)) in left.iter_mut().zip(&pixels) {
            *left -= c * irradiance::value(l, m, o, p, q, x.hypot(*y).atan2(*z), y.atan2(*x));
        }
    }
    let mut sums = [0.0; 2 * DEGREE + 1];
    for (size, _, (_, m, ..)) in &terms[TERMS..] {
        sums[DEGREE.saturating_add_signed(*m)] += size;
    }
    let bound = sums.iter().map(|sum| sum * sum).sum::<f64>().sqrt();
    let error = mean(&pixels, |k| left[k] * left[k]).sqrt();

    let steps = PartialSum::new(&study.gram, &[]).steps(light, material);
    let step = steps.iter().find(|step| step.terms == TERMS).expect("every number of terms");
    let (off, of) = (step.error * step.error - error * error, step.bound / bound - 1.0);
    println!("error {:.1e} of the energy, bound {of:.1e}, {}", off / energy, error / bound);
    assert!(off.abs() <= FIGURE_ERROR * energy, "{} {error}", step.error);
    assert!(of.abs() <= FIGURE_ERROR, "{} {bound}", step.bound);
    assert!(error < bound && error > BOUND_AT_WORK * bound);
}

/// Normals of a rendered sphere: each degree and order of the light by quadrature of (3), on
/// the part of the material that its strongest terms leave.
#[test]
fn rendered_spheres_are_sums_of_integrals() {
    let study = study();
    let trial = study.trial("studio", "05-leather").expect("it is there");
    let normals = of_equal_areas(300);
    let found = render(study, "studio", "05-leather", &normals).expect("an image");
    let (step, image) = &found.sums[0];
    let (light, material) = (&study.luminances[trial.light], &study.grays[trial.material]);
    let terms = strongest(light, material);
    let peak = found.whole.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let mut least: f64 = f64::INFINITY;
    for k in [5, 150, 290] {
        let mut expected = 0.0;
        for (place, coefficient) in light.iter().enumerate() {
            let part: Vec<_> = terms[..step.terms]
                .iter()
                .filter(|(_, _, (l, m, ..))| light::position(*l, *m) == place)
                .map(|&(_, _, (_, _, o, p, q))| (o, p, q, material[material::position(o, p, q)]))
                .collect();
            let mut alone = vec![0.0; light.len()];
            alone[place] = *coefficient;
            let alone = oracle::ExplicitLight::new(&alone);
            if !part.is_empty() {
                expected += oracle::irradiance(&alone, &part, normals[k]);
            }
        }
        let off = (image[k] - expected).abs() / peak;
        println!("normal {k}: {off:.1e} of the peak");
        assert!(off <= tolerances::DIRECT_SUM, "{k}: {} {expected}", image[k]);
        least = least.min((found.whole[k] - expected).abs() / peak);
    }
    // What was left out shows.
    assert!(least > LEFT_OUT, "{least}");
}

/// Irradiances that Fig. 4 lists, each channel by quadrature of (3) on coefficients as they
/// are shipped; of the 1,000 modes the sum of theirs, each by (14).
#[test]
fn listed_irradiances_are_integrals() {
    let values = sheet("spheres_values");
    assert_eq!(values.columns.join(","), "light,material,modes,x,y,z,r,g,b");
    assert_eq!(values.rows.len(), 3 * 2 * 49);
    let study = study();
    for (k, pair) in values.rows.chunks(2 * 49).enumerate() {
        assert_eq!([0, 49].map(|row| pair[row].text("modes")), ["3704", "1000"]);
        let peak = sheet("spheres").of(Modes::All).numbers("peak")[k];
        let trial =
            study.trial(pair[0].text("light"), pair[0].text("material")).expect("it is there");
        let light = &study.lights.entries[trial.light];
        let material = &study.materials.entries[trial.material];
        for (row, channel) in [(3, 0), (24, 1), (37, 2), (45, 0)] {
            let [whole, selected] = [&pair[row], &pair[49 + row]];
            let [x, y, z] = ["x", "y", "z"].map(|column| whole.number(column).expect("a number"));
            let [listed, of_selected] = [whole, selected]
                .map(|row| row.number(["r", "g", "b"][channel]).expect("a number"));
            let explicit = oracle::ExplicitLight::new(&light.rgb[channel]);
            let indices = material::indices(ORDER).zip(&material.rgb[channel]);
            let terms: Vec<_> = indices.map(|((o, p, q), b)| (o, p, q, *b)).collect();
            let expected = oracle::irradiance(&explicit, &terms, [x, y, z]);
            let off = (listed - expected).abs() / peak;
            assert!(off <= LISTED, "{whole:?}: {expected}");
            // And of the selected modes.
            let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
            let mut sum = 0.0;
            for (l, m) in light::indices(DEGREE) {
                for &(o, p, q, b) in terms.iter().filter(|(_, _, q, _)| *q <= l) {
                    if study.selection[study.gram.place(m.unsigned_abs(), l, o, p, q)] {
                        let c = light.rgb[channel][light::position(l, m)] * b;
                        sum += c * irradiance::value(l, m, o, p, q, alpha, beta);
                    }
                }
            }
            assert!((of_selected - sum).abs() <= LISTED * peak, "{selected:?}: {sum}");
        }
    }
}
