//! Databases with little variation.

use super::{Figure, exactly, most, tight};
use crate::tolerances;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_table::Table;
use eigenshade_table::scene::Normalize;
use eigenshade_testing::fixtures::{self, lights, materials, named};
use eigenshade_testing::largest;
use eigenshade_testing::oracle::Numbers;

const DEGREE: usize = 6;
const ORDER: usize = 5;

/// The errors of a scene by both criteria, and its table by the first one.
fn both(lights: Lights, materials: Materials) -> (f64, Table) {
    let loaded = fixtures::scene(lights, materials);
    let table = fixtures::table(&loaded);
    let error = fixtures::reconstruction_error(&loaded, &table);
    // Standard PCA spans the images in the exposure that its statistics use.
    let mut loaded = fixtures::standard(loaded);
    for light in &mut loaded.lights.entries {
        let ambient = light.luminance()[0];
        light.rgb.iter_mut().flatten().for_each(|value| *value /= ambient);
    }
    let standard = fixtures::table(&loaded);
    (largest([error, fixtures::reconstruction_error(&loaded, &standard)]), table)
}

pub(super) fn few() -> Vec<Figure> {
    let mut numbers = Numbers(21);
    let mut error = |l: usize, b: usize| {
        both(lights(DEGREE, l, &mut numbers), materials(ORDER, b, &mut numbers)).0
    };
    let limit = tolerances::ALL_COMPONENTS;
    vec![
        most("one light, four materials, of the peak", error(1, 4), limit),
        most("four lights, one material, of the peak", error(4, 1), limit),
        most("one of each, of the peak", error(1, 1), limit),
    ]
}

pub(super) fn alike() -> Vec<Figure> {
    let mut numbers = Numbers(22);
    let (lights, one) = (lights(DEGREE, 3, &mut numbers), materials(ORDER, 1, &mut numbers));
    let mut copies = one.clone();
    copies.entries.resize(8, one.entries[0].clone());
    let (_, single) = both(lights.clone(), one);
    let (error, table) = both(lights, copies);
    let more = table.components.len().abs_diff(single.components.len());
    let apart = apart(&eigenvalues(&table), &eigenvalues(&single));
    vec![
        exactly("components more than for one", more, 0),
        most("eigenvalues, of the largest", apart, tolerances::SINGULAR_VALUE),
        tight("images, of the peak", error, tolerances::ALL_COMPONENTS_FEW),
    ]
}

pub(super) fn zeros() -> Vec<Figure> {
    let mut numbers = Numbers(23);
    let some = lights(DEGREE, 3, &mut numbers);
    let no_light = named("black", vec![0.0; eigenshade_table::light::count(DEGREE)]);
    let black = named("black", vec![0.0; eigenshade_table::material::count(ORDER)]);
    let mut with_black = materials(ORDER, 3, &mut numbers);
    with_black.entries.push(black.clone());
    let (among, _) = both(some.clone(), with_black);
    let (alone, table) = both(some.clone(), Materials { order: ORDER, entries: vec![black] });
    let mut loaded = fixtures::scene(some, materials(ORDER, 3, &mut numbers));
    loaded.lights.entries.push(no_light.clone());
    let refused = loaded.build().is_err_and(|error| error.to_string().contains("`black`"));
    loaded.scene.light.normalize = Normalize::None;
    let dark = fixtures::reconstruction_error(&loaded, &fixtures::table(&loaded));
    loaded.lights.entries = vec![no_light];
    let nothing = fixtures::table(&loaded);
    let limit = tolerances::ALL_COMPONENTS;
    vec![
        most("a black material among three, of the peak", among, limit),
        most("a black material alone: the irradiance itself", alone, 0.0),
        exactly("a black material alone: components", table.components.len(), 1),
        exactly("a black light is refused by name", usize::from(refused), 1),
        most("a black light accepted, of the peak", dark, limit),
        exactly("a black light alone: components", nothing.components.len(), 1),
    ]
}

/// Keeps the first coefficient of each channel.
fn only_first(entries: &mut [Named]) {
    entries.iter_mut().flat_map(|entry| &mut entry.rgb).for_each(|channel| channel[1..].fill(0.0));
}

pub(super) fn plain() -> Vec<Figure> {
    let mut numbers = Numbers(24);
    let mut ambient = lights(DEGREE, 3, &mut numbers);
    only_first(&mut ambient.entries);
    let (first, of_ambient) = both(ambient, materials(ORDER, 1, &mut numbers));
    let mut matte = materials(ORDER, 3, &mut numbers);
    only_first(&mut matte.entries);
    let (second, of_matte) = both(lights(DEGREE, 4, &mut numbers), matte);
    // Only degrees 0, 1, 2, 4 and 6 reach a Lambertian surface. Each |m| has as many profiles as
    // there are such degrees from |m| on, and the constant belongs to degree 0.
    let of_degrees = 1 + 4 + 2 * (4 + 3 + 2 + 2 + 1 + 1);
    let limit = tolerances::ALL_COMPONENTS_FEW;
    vec![
        exactly("components under ambient light", of_ambient.components.len(), 2),
        most("ambient light, of the peak", first, limit),
        exactly("components of Lambertian materials", of_matte.components.len(), of_degrees),
        most("Lambertian materials, of the peak", second, limit),
    ]
}

/// Ambient light of two exposures on one material, so that Σ_c has a single direction.
pub(super) fn rank_one() -> Vec<Figure> {
    let mut numbers = Numbers(25);
    let mut pair = lights(DEGREE, 2, &mut numbers);
    only_first(&mut pair.entries);
    for (light, ambient) in pair.entries.iter_mut().zip([1.0, 1.0 + 1e-6]) {
        light.rgb.iter_mut().for_each(|channel| channel[0] = ambient);
    }
    let mut loaded = fixtures::standard(fixtures::scene(pair, materials(ORDER, 1, &mut numbers)));
    loaded.scene.light.normalize = Normalize::None;
    let table = fixtures::table(&loaded);
    let error = fixtures::reconstruction_error(&loaded, &table);
    // The variance by hand: that of the exposures times the energy of the image.
    let spread: f64 = 0.5e-6;
    let mean = table.mean.as_ref().expect("standard criterion");
    let energy: f64 = mean.coefficients.iter().map(|d| d * d).sum();
    let expected = spread * spread * energy / (1.0 + spread).powi(2);
    let off = eigenvalues(&table)[0] / expected - 1.0;
    vec![
        exactly("components", table.components.len(), 1),
        most("its eigenvalue, relative", off, tolerances::SMALL_VARIANCE),
        most("images, of the peak", error, tolerances::ALL_COMPONENTS_FEW),
    ]
}

/// The eigenvalues of a table, without the constant.
fn eigenvalues(table: &Table) -> Vec<f64> {
    table.spectrum.iter().filter_map(|(_, value)| *value).collect()
}

/// The largest difference between two lists of eigenvalues, relative to the largest eigenvalue.
/// Missing values count as 0.
fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let count = found.len().max(expected.len());
    let at = |values: &[f64], k: usize| values.get(k).copied().unwrap_or(0.0);
    let apart = largest((0..count).map(|k| at(found, k) - at(expected, k)));
    if apart == 0.0 { 0.0 } else { apart / at(expected, 0).max(at(found, 0)) }
}
