//! Total errors of shipped materials: the integration that they come from, the recorded rows, and
//! the table that `docs/accuracy.md` makes of them.

use crate::support::repository;
use crate::{measured_surfaces, shipped_map, spread};
use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::material::brdf::Brdf;
use eigenshade_model::database::Lights;
use eigenshade_shading::shipped;
use eigenshade_testing::largest;
use experiments::accuracy_cost::total::references::World;
use experiments::accuracy_cost::total::subjects::Gltf;
use experiments::material_errors::{SPACING, errors};
use experiments::numbers::{median, percent};
use indicatif::ProgressBar;
use std::fs;

/// Integration in blocks against every texel: the largest difference of the peak. The errors that
/// it is used for are 50 times as large in the median.
const OF_TREE: f64 = 3e-4;

/// Medians and worst maps at normals 1.4 times as far apart, as a factor, of the widest lobe and of
/// the narrowest.
const OF_SPACING: f64 = 1.1;

/// Recorded errors against the same again, in units of their last digit.
const OF_DIGITS: f64 = 2.5;

/// Measured materials and formulas.
#[test]
fn blocks_are_their_texels() {
    let maps = ["park", "studio"].map(shipped_map);
    let whole = Surroundings::new(&maps).unwrap();
    let lights = Lights { degree: 0, entries: Vec::new() };
    let world = World::of(maps.to_vec(), lights, 0.5).unwrap();
    let mut normals = spread(16);
    normals.retain(|[.., z]| *z > 0.0);
    normals.extend([0, 1].map(|map| whole.mirror(map)));
    let gltf = [(0.22, 0.8, 0.0), (0.45, 0.04, 0.7), (0.95, 0.8, 0.0)];
    let gltf = gltf.map(|(roughness, f0, albedo)| Gltf { roughness, f0, albedo });
    let formulas = gltf.map(|gltf| gltf.surface(format!("{}", gltf.roughness)).unwrap());
    let names = ["chrome", "gold-metallic-paint", "white-fabric2", "two-layer-gold", "pvc"];
    let measured =
        measured_surfaces().into_iter().filter(|surface| names.contains(&surface.name.as_str()));
    let surfaces: Vec<_> = measured.chain(formulas).collect();
    assert_eq!(surfaces.len(), 8);
    for surface in surfaces {
        let brdfs: [&dyn Brdf; 3] = [0, 1, 2].map(|c| surface.channel(c));
        let expected = whole.irradiance(&brdfs, &normals, 1.0);
        for (map, found) in world.pictures(&surface, &normals).iter().enumerate() {
            let of = |c: usize| expected.iter().map(move |image| image[c][map][c]);
            let peak = largest((0..3).flat_map(of));
            let apart = largest((0..3).flat_map(|c| of(c).zip(&found[c]).map(|(a, b)| a - b)));
            println!("{}, map {map}: {:.1e} of the peak", surface.name, apart / peak);
            assert!(apart <= OF_TREE * peak, "{}: {}", surface.name, apart / peak);
        }
    }
}

#[test]
fn recorded_errors_are_found_again() {
    let inputs = repository().join("tables/inputs");
    let names = ["pink-felt", "chrome"].map(str::to_owned);
    let again = |spacing| errors(&inputs, &names, spacing, &ProgressBar::hidden()).unwrap();
    let (found, wider) = (again(SPACING), again(1.4 * SPACING));
    for ((name, found), (_, wider)) in found.iter().zip(&wider) {
        for ((&size, found), wider) in shipped::ERROR_SIZES.iter().zip(found).zip(wider) {
            let recorded = shipped::total_error(name, size).expect("a row");
            println!("{name} {size:?}: {found:?}, wider {wider:?}");
            let near = |a: f64, b: f64, digit: f64| assert!((a - b).abs() <= OF_DIGITS * digit);
            near(found.median, recorded.median, 1e-5);
            near(found.worst, recorded.worst, 1e-5);
            near(found.pixel, recorded.pixel, 1e-4);
            for (wider, found) in [(wider.median, found.median), (wider.worst, found.worst)] {
                let ratio = wider / found;
                assert!((1.0 / OF_SPACING..OF_SPACING).contains(&ratio), "{name}: {ratio}");
            }
        }
    }
    let unknown = errors(&inputs, &["chrom".to_owned()], SPACING, &ProgressBar::hidden());
    assert!(unknown.unwrap_err().to_string().contains("`chrom`"));
}

/// The share of the sorted values that is at most this.
fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[((sorted.len() - 1) as f64 * share).round() as usize]
}

#[test]
fn the_page_has_the_errors_of_materials() {
    let named = shipped::named_materials().unwrap().entries;
    let mut table = String::from(
        "| degree, order | median | 95th percentile | worst material | worst map | worst pixel |\n\
         |---|---:|---:|---:|---:|---:|\n",
    );
    for size in shipped::ERROR_SIZES {
        let of_size = named
            .iter()
            .filter_map(|one| Some((one.name.as_str(), shipped::total_error(&one.name, size)?)));
        let all: Vec<(&str, shipped::TotalError)> = of_size.collect();
        assert_eq!(all.len(), 95);
        let medians: Vec<f64> = all.iter().map(|(_, error)| error.median).collect();
        let most = |value: &dyn Fn(&shipped::TotalError) -> f64| {
            let worst = all.iter().max_by(|(_, a), (_, b)| value(a).total_cmp(&value(b)));
            worst.map(|(name, error)| format!("{} ({name})", percent(value(error), 2))).unwrap()
        };
        table += &format!(
            "| {}, {} | {} | {} | {} | {} | {} |\n",
            size.0,
            size.1,
            percent(median(&medians), 2),
            percent(quantile(&medians, 0.95), 2),
            most(&|error| error.median),
            most(&|error| error.worst),
            most(&|error| error.pixel),
        );
    }
    println!("{table}");
    let page = fs::read_to_string(repository().join("docs/accuracy.md")).unwrap();
    assert!(page.contains(&table), "docs/accuracy.md lacks the table above");
}
