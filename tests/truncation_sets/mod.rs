//! Images by themselves, and sets of images in one shape: each is within its tolerance, its bound
//! holds and is near the error, and no azimuth could lose another term.

use crate::invariants::TRUNCATED_PARTS;
use crate::tolerances;
use eigenshade_testing::{assert_recorded, images};

mod corner_cases;

use eigenshade::truncation::{Shape, Tolerance, Truncation};
use eigenshade::{Light, Material, Normal, sphere};
use eigenshade_generator::basis::build;
use eigenshade_model::database::Named;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::decode;
use eigenshade_testing::fixtures::normal;
use images::{Image, coefficients, rule, single, vectors};
use proptest::prelude::*;

/// A scene's bound in f32 beyond its share of the peak, of the share: some hundred roundings.
const PARSEVAL: f32 = 1e-5;

/// Rounding of d and of a scene in f32, of the peak: sums of some hundred products.
const ROUNDED: f64 = 1e-6;

/// The median, over images, of the bound divided by the error. Only components that are left out
/// make the bound larger than the error: terms that are left out hold a part of them already. Images
/// of a set, most of which could lose more, have bounds just as close.
const MEDIAN_BOUND_TO_ERROR: f64 = 1.1;

/// A tolerance, and what is found with it: the median and the most terms that stay, the median and
/// the largest bound divided by the error.
type Recorded = (f32, [f64; 4]);
const EACH_BY_ITSELF: [Recorded; 4] = [
    (0.1, [3.0, 14.0, 1.04, 1.79]),
    (1e-2, [18.0, 58.0, 1.03, 1.24]),
    (1e-3, [58.0, 89.0, 1.00, 1.04]),
    (1e-4, [88.0, 111.0, 1.00, 1.05]),
];
const MATERIALS_UNDER_A_LIGHT: [Recorded; 3] = [
    (0.1, [6.0, 14.0, 1.01, 1.15]),
    (1e-2, [42.0, 60.0, 1.00, 1.35]),
    (1e-3, [82.0, 91.0, 1.00, 1.00]),
];
const LIGHTS_ON_A_MATERIAL: [Recorded; 3] = [
    (0.1, [6.0, 10.0, 1.01, 1.15]),
    (1e-2, [41.0, 54.0, 1.00, 1.16]),
    (1e-3, [79.0, 89.0, 1.00, 1.00]),
];
const CHANNELS_OF_A_COLOR: [Recorded; 3] = [
    (0.1, [4.0, 11.0, 1.03, 2.11]),
    (1e-2, [20.0, 54.0, 1.03, 1.18]),
    (1e-3, [60.0, 89.0, 1.00, 1.09]),
];

type Rule = [(Normal, f64)];

/// A set in one shape.
struct Chosen {
    components: usize,
    lengths: Vec<u16>,
    reports: Vec<Truncation>,
    buffer: Vec<f32>,
}

impl Chosen {
    fn new(set: &[sphere::Coefficients], channels: usize, tolerance: Tolerance) -> Self {
        let mut lengths = [0; 16];
        let mut reports = vec![Truncation::default(); set.len()];
        let mut buffer = vec![0.0; set.len() * sphere::SCENE];
        let (room, report) = (&mut buffer, &mut reports);
        let shape = sphere::BASIS
            .collapse_set_within(set, channels, tolerance, &mut lengths, room, report)
            .expect("sizes");
        let (components, lengths) = (shape.components, shape.lengths.to_vec());
        Self { components, lengths, reports, buffer }
    }

    fn shape(&self) -> Shape<'_> {
        Shape { components: self.components, lengths: &self.lengths }
    }
}

/// Root mean square error of an image in a shape.
fn error_in(d: &[f32], shape: Shape<'_>, image: &Image, rule: &Rule) -> f64 {
    let made = sphere::BASIS.collapse_as(d, shape, [0.0; sphere::SCENE]).expect("sizes");
    image.apart(&made.0, rule)
}

/// The energy of the images in all components after the first `components`.
fn beyond(d: &[f32], components: usize) -> f64 {
    d.iter().skip(components).map(|&d| f64::from(d).powi(2)).sum()
}

/// Checks each image of a set, each its own peak or that of its color; gives bounds over
/// errors.
fn checked(
    set: &[sphere::Coefficients],
    channels: usize,
    share: f32,
    images: &[Image],
) -> Vec<f64> {
    let rule = rule();
    let chosen = Chosen::new(set, channels, Tolerance::OfPeak(share));
    let shape = chosen.shape();
    let mut ratios = Vec::new();
    let peaks: Vec<f64> = images
        .chunks(channels)
        .flat_map(|color| {
            let peak = color.iter().fold(0.0, |most: f64, one| most.max(one.peak));
            color.iter().map(move |_| peak)
        })
        .collect();
    for (k, (report, image)) in chosen.reports.iter().zip(images).enumerate() {
        let scene = shape.scene(&chosen.buffer[k * sphere::SCENE..]).expect("enough");
        let error = image.apart(&scene, &rule);
        let (bound, peak) = (f64::from(report.bound), f64::from(report.peak));
        let rounding = tolerances::TRUNCATION_ROUNDING * image.peak;
        assert!(error <= bound + rounding, "{error:e} of {bound:e} at {share}");
        assert!(bound <= f64::from(share) * peak * 1.000_01, "{report:?}");
        assert!(peak <= peaks[k] * tolerances::TRUNCATION_PEAK, "{report:?}, {}", peaks[k]);
        let parts = [report.left_out_by_components, report.left_out_by_terms];
        let parts = parts.into_iter().map(f64::from).fold(0.0, f64::hypot);
        assert!((parts - bound).abs() <= TRUNCATED_PARTS * bound, "{report:?}");
        let of_components = beyond(&set[k], report.components).sqrt();
        let stated = f64::from(report.left_out_by_components);
        assert!((stated - of_components).abs() <= TRUNCATED_PARTS * bound, "{report:?}");
        let kept = (report.components, report.azimuths, report.terms);
        assert_eq!(kept, (chosen.components, chosen.lengths.len(), shape.terms()));
        // The same scene by itself, and the same bound; its peak is its own.
        let again = sphere::BASIS.collapse_as(&set[k], shape, [0.0; sphere::SCENE]).expect("sizes");
        let same = (f64::from(again.1.bound) - bound).abs();
        assert!(same <= TRUNCATED_PARTS * bound + rounding, "{report:?}, {again:?}");
        assert!((image.apart(&again.0, &rule) - error).abs() <= rounding);
        ratios.push(bound / error);
    }
    // Nothing more could go: of the images without a term more, one is beyond its tolerance.
    let last = chosen.lengths.len().saturating_sub(1);
    for azimuth in 0..chosen.lengths.len() {
        let mut lengths = chosen.lengths.clone();
        // A constant costs a pixel nothing, unless its azimuth is there for it alone.
        if lengths[azimuth] == 0 || lengths[azimuth] == 1 && (azimuth == 0 || azimuth < last) {
            continue;
        }
        lengths[azimuth] -= 1;
        let shorter = Shape { components: sphere::COMPONENTS, lengths: &lengths };
        let breaks = set.iter().zip(images).zip(&chosen.reports).any(|((d, image), report)| {
            let terms = error_in(d, shorter, image, &rule);
            let bound = (terms * terms + beyond(d, chosen.components)).sqrt();
            let rounding = tolerances::TRUNCATION_ROUNDING * image.peak;
            bound + rounding > f64::from(share * report.peak)
        });
        assert!(breaks, "{:?} could lose a term of {azimuth} at {share}", chosen.lengths);
    }
    ratios
}

fn middle<T: PartialOrd + Copy>(values: &mut [T]) -> (T, T) {
    values.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    (values[values.len() / 2], values[values.len() - 1])
}

/// Checks sets at these tolerances.
fn check_sets(recorded: &[Recorded], channels: usize, sets: &[Vec<sphere::Coefficients>]) {
    let rule = rule();
    let mut found: Vec<_> = recorded.iter().map(|_| (Vec::new(), Vec::new())).collect();
    for set in sets {
        let images: Vec<_> = set.iter().map(|d| Image::new(d, &rule)).collect();
        for ((terms, ratios), &(share, _)) in found.iter_mut().zip(recorded) {
            ratios.extend(checked(set, channels, share, &images));
            terms.push(Chosen::new(set, channels, Tolerance::OfPeak(share)).shape().terms());
        }
    }
    for ((mut terms, mut ratios), (share, recorded)) in found.into_iter().zip(recorded) {
        let (terms, most) = middle(&mut terms);
        let (ratio, worst) = middle(&mut ratios);
        assert!(ratio <= MEDIAN_BOUND_TO_ERROR, "{share}: {ratio}");
        let found = [terms as f64, most as f64, ratio, worst];
        assert_recorded(&share.to_string(), &found, recorded, tolerances::RECORDED);
    }
}

fn shipped() -> (Vec<Named>, Vec<Named>) {
    let lights = read_lights("tables/inputs/lights.csv", Some(9)).expect("the shipped lights");
    let materials = read_materials("tables/inputs/materials.csv", Some(7)).expect("materials");
    (lights.entries, materials.entries)
}

fn on(light: &Named, material: &Named) -> sphere::Coefficients {
    coefficients(&single(light.luminance()), &single(material.luminance()))
}

#[test]
fn each_image_by_itself() {
    let (lights, materials) = shipped();
    let alone = |light| materials.iter().map(move |material| vec![on(light, material)]);
    let sets: Vec<_> = lights.iter().flat_map(alone).collect();
    check_sets(&EACH_BY_ITSELF, 1, &sets);
}

#[test]
fn all_materials_under_each_light() {
    let (lights, materials) = shipped();
    let under = |light| materials.iter().map(|material| on(light, material)).collect();
    let sets: Vec<_> = lights.iter().map(under).collect();
    check_sets(&MATERIALS_UNDER_A_LIGHT, 1, &sets);
}

#[test]
fn all_lights_on_some_materials() {
    let (lights, materials) = shipped();
    let of = |material| lights.iter().map(|light| on(light, material)).collect();
    let sets: Vec<_> = materials.iter().step_by(6).map(of).collect();
    check_sets(&LIGHTS_ON_A_MATERIAL, 1, &sets);
}

/// Channels of light times those of the material.
#[test]
fn three_channels_share_a_peak() {
    let (lights, materials) = shipped();
    let pairs =
        lights.iter().flat_map(|light| materials.iter().step_by(5).map(move |m| (light, m)));
    let color = |(light, material): (&Named, &Named)| -> Vec<_> {
        let channels = light.rgb.iter().zip(&material.rgb);
        channels.map(|(l, b)| coefficients(&single(l.clone()), &single(b.clone()))).collect()
    };
    let sets: Vec<_> = pairs.map(color).collect();
    check_sets(&CHANNELS_OF_A_COLOR, 3, &sets);
}

#[test]
fn a_set_of_one_is_that_image_within_its_tolerance() {
    let (lights, materials) = shipped();
    for (light, material) in lights.iter().zip(&materials) {
        let d = on(light, material);
        for tolerance in [Tolerance::OfPeak(1e-2), Tolerance::OfPeak(1e-3)] {
            let mut lengths = [0; 16];
            let (scene, report) = sphere::BASIS
                .collapse_within(&d, tolerance, &mut lengths, [0.0f32; sphere::SCENE])
                .expect("sizes");
            let set = Chosen::new(std::slice::from_ref(&d), 1, tolerance);
            assert_eq!(set.reports, [report]);
            assert_eq!(set.lengths.len(), report.azimuths);
            let of_set = set.shape().scene(&set.buffer).expect("enough");
            for (at, _) in rule() {
                assert_eq!(scene.shade(at), of_set.shade(at));
            }
        }
    }
}

/// What the table of all components leaves out of the direct sum is rounding: the bound is of
/// the error against that.
#[test]
fn of_all_components_bounds_are_of_the_direct_sum() {
    let (lights, materials) = shipped();
    let mut scene = decode(include_bytes!("../../tables/curet.bin")).expect("a table").scene;
    scene.basis.components = Some(10_000);
    let inputs = read_lights("tables/inputs/lights.csv", None).expect("the shipped lights");
    let measured = read_materials("tables/inputs/materials.csv", Some(7)).expect("materials");
    let table = build(&scene, &inputs, &measured).expect("a table");
    let owned = OwnedBasis::new(&table).expect("a table for f32");
    let basis = owned.basis().expect("parts of a table");
    let (degree, order) = (basis.degree(), basis.order());
    let reference = DirectSum::new(degree, order);
    let vectors = vectors();
    let modes: Vec<_> = vectors.iter().map(|&(at, _)| reference.at(at)).collect();
    let materials: Vec<_> = materials.iter().step_by(3).map(Named::luminance).collect();
    let scattered: Vec<Vec<_>> =
        modes.iter().map(|at| materials.iter().map(|one| at.scatter(one)).collect()).collect();
    let (len, mut ratios) = (basis.scene_len(), Vec::new());
    for light in lights.iter().step_by(3).map(Named::luminance) {
        let of_light = single(light.clone());
        let set: Vec<_> = materials
            .iter()
            .map(|material| {
                let mut d = vec![0.0; basis.components()];
                let mut workspace = vec![0.0; basis.workspace_len()];
                let light = Light::new(&of_light).expect("coefficients");
                let material = single(material.clone());
                let material = Material::new(&material).expect("coefficients");
                basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
                d
            })
            .collect();
        let of = |k: usize| {
            let both = modes.iter().zip(&scattered);
            both.map(|(modes, of)| modes.irradiance(&light, &of[k])).collect::<Vec<_>>()
        };
        let direct: Vec<_> = (0..set.len()).map(of).collect();
        for share in [0.1, 1e-2, 1e-3, 1e-4] {
            let mut lengths = [0; 16];
            let mut reports = vec![Truncation::default(); set.len()];
            let mut buffer = vec![0.0; set.len() * len];
            let (room, report) = (&mut buffer, &mut reports);
            let shape = basis
                .collapse_set_within(&set, 1, Tolerance::OfPeak(share), &mut lengths, room, report)
                .expect("sizes");
            for (k, (numbers, report)) in buffer.chunks_exact(len).zip(&reports).enumerate() {
                let scene = shape.scene(numbers).expect("enough");
                let squares = vectors.iter().zip(&direct[k]).map(|(&(at, weight), direct)| {
                    weight * (f64::from(scene.shade(normal(at))) - direct).powi(2)
                });
                let error = squares.sum::<f64>().sqrt();
                let table = (tolerances::ALL_COMPONENTS + ROUNDED) * f64::from(report.peak);
                assert!(error <= f64::from(report.bound) + table, "{error:e}, {report:?}");
                assert!(report.bound <= share * report.peak * (1.0 + PARSEVAL));
                ratios.push(f64::from(report.bound) / error);
            }
        }
    }
    let (ratio, worst) = middle(&mut ratios);
    println!("{} components: {ratio:.3}, {worst:.2}", basis.components());
    assert!(ratio <= MEDIAN_BOUND_TO_ERROR, "{ratio}");
}

/// Numbers of images and of channels.
const SIZES: &[(usize, usize)] =
    &[(1, 1), (2, 1), (2, 2), (3, 1), (3, 3), (4, 2), (5, 1), (6, 1), (6, 2), (6, 3), (6, 6)];

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 128,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]
    #[test]
    fn bounds_hold_of_any_set(
        lights in prop::collection::vec(prop::collection::vec(-1.0f32..1.0, 100), 3),
        materials in prop::collection::vec(prop::collection::vec(-1.0f32..1.0, 40), 2),
        exponent in 0.3f32..5.0,
        (count, channels) in prop::sample::select(SIZES),
    ) {
        let pairs = lights.iter().flat_map(|light| materials.iter().map(move |m| (light, m)));
        let set = pairs.take(count).map(|(light, material)| coefficients(light, material));
        let set: Vec<_> = set.collect();
        let images: Vec<_> = set.iter().map(|d| Image::new(d, &rule())).collect();
        checked(&set, channels, 10f32.powf(-exponent), &images);
    }
}
