//! Total errors of shipped materials: the integration that they come from, the recorded rows, and
//! the table that `docs/accuracy.md` makes of them.

use crate::spread;
use crate::support::repository;
use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Brdf, Part};
use eigenshade_generator::material::files::{Source, read};
use eigenshade_shading::shipped;
use experiments::light_tree::LightTree;
use experiments::material_errors::{SPACING, errors};
use experiments::numbers::{median, percent};
use indicatif::ProgressBar;
use std::fs;

/// Integration in blocks against every texel: the largest difference of the peak. The errors that
/// it is used for are 50 times as large in the median.
const OF_TREE: f64 = 3e-4;

/// Medians and worst maps at normals 1.4 times as far apart, as a factor, of the widest lobe and of the
/// narrowest.
const OF_SPACING: f64 = 1.1;

/// Recorded errors against the same again, in units of their last digit.
const OF_DIGITS: f64 = 2.5;

#[test]
fn blocks_are_their_texels() {
    let maps = ["park", "studio"].map(|name| {
        let path = repository().join(format!("tables/inputs/maps/{name}.exr"));
        EnvironmentMap::from_path(path).unwrap()
    });
    let (tree, whole) = (LightTree::new(&maps).unwrap(), Surroundings::new(&maps).unwrap());
    let sources = read(repository().join("tables/inputs/merl-abc.csv")).unwrap();
    for name in ["chrome", "gold-metallic-paint", "white-fabric2", "two-layer-gold", "pvc"] {
        let surface = sources.iter().find_map(|source| match source {
            Source::Surface(surface) if surface.name == name => Some(surface),
            _ => None,
        });
        let surface = surface.unwrap();
        let brdfs: [&dyn Brdf; 3] = [0, 1, 2].map(|c| surface.channel(c));
        let mut normals = spread(16);
        normals.retain(|[.., z]| *z > 0.0);
        normals.extend([0, 1].map(|map| whole.mirror(map)));
        let expected = whole.irradiance(&brdfs, &normals, 1.0);
        // The parts of all channels, each of which is a whole BRDF above.
        let of_part = |part: &Part<'_>, normal| -> Vec<[f64; 3]> {
            let all = tree.irradiance(part.brdf, normal, 1.0).into_iter();
            all.map(|i| [0, 1, 2].map(|c| part.shares[c] * i[c])).collect()
        };
        let of_parts = |&normal: &[f64; 3]| -> Vec<[f64; 3]> {
            let each = surface.parts().into_iter().map(|part| of_part(&part, normal));
            let add = |a: Vec<[f64; 3]>, b: Vec<[f64; 3]>| {
                a.iter().zip(&b).map(|(a, b)| [0, 1, 2].map(|c| a[c] + b[c])).collect()
            };
            each.reduce(add).unwrap()
        };
        let found: Vec<_> = normals.iter().map(of_parts).collect();
        for map in 0..maps.len() {
            let values = expected.iter().flat_map(|image| [0, 1, 2].map(|c| image[c][map][c]));
            let found = found.iter().flat_map(|image| image[map]);
            let peak = values.clone().fold(0.0, |most: f64, value| most.max(value.abs()));
            let apart = values.zip(found).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            println!("{name}, map {map}: {:.1e} of the peak", apart / peak);
            assert!(apart <= OF_TREE * peak, "{name}: {}", apart / peak);
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
