//! Every test of the report, in one binary.

#[path = "../../cli/tests/support/mod.rs"]
mod support;

mod accuracy_cost;
mod benchmark_tables;
mod direct_integration;
mod float_errors;
mod highlights;
mod material_errors;
mod metallic_roughness;
mod objects;
mod packed_objects;
mod palette_errors;
mod paper_oracle;
mod paper_statements;
mod reading;
mod roughness_weights;
mod shadows;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Brdf, Surface};
use eigenshade_generator::material::files::{Source, read};
use eigenshade_testing::{oracle, tolerances};
use report::sheet;
use report::texels::Texels;
use std::fs;
use std::path::{Path, PathBuf};

/// The program that has this command. `eigenshade` lies beside this one if it was built.
fn program(command: &str) -> PathBuf {
    let report = Path::new(env!("CARGO_BIN_EXE_report"));
    if command == "accuracy-cost" {
        return report.into();
    }
    let eigenshade = report.with_file_name(format!("eigenshade{}", std::env::consts::EXE_SUFFIX));
    assert!(eigenshade.exists(), "build it first: cargo build -p eigenshade-cli");
    eigenshade
}

/// Allowed difference from a recorded error, in units of its last digit. Processors round the maps,
/// the integrals and the sources differently.
const OF_DIGITS: f64 = 2.5;

/// A CSV of `docs` has these rows. Its first line is the command that prints them.
fn assert_recorded(name: &str, columns: &str, rows: &[Vec<String>]) {
    let recorded = fs::read_to_string(support::repository().join("docs").join(name)).expect(name);
    let (comment, _) = recorded.split_once('\n').expect("a line");
    let text = sheet::csv(comment.trim_start_matches("# "), columns, rows).expect("a CSV");
    println!("{text}");
    assert!(recorded == text, "docs/{name} has not the rows above");
}

/// A shipped map.
fn shipped_map(name: &str) -> EnvironmentMap {
    let path = support::repository().join(format!("tables/inputs/maps/{name}.exr"));
    EnvironmentMap::from_path(path).expect("a map")
}

/// The published fits of a model, `abc` or `sgd`, to the measured materials.
fn measured_surfaces(model: &str) -> Vec<Surface> {
    let path = support::repository().join(format!("tables/inputs/merl-{model}.csv"));
    let sources = read(path).expect("the fits").into_iter();
    let surface = |one| if let Source::Surface(surface) = one { Some(surface) } else { None };
    sources.filter_map(surface).collect()
}

/// The irradiance from every texel of maps, r, g and b, by normal and then by map.
fn by_texels(
    maps: &[EnvironmentMap],
    brdf: &dyn Brdf,
    normals: &[[f64; 3]],
    fineness: f64,
) -> Vec<Vec<[f64; 3]>> {
    let texels = Texels::new(maps).expect("maps of one size");
    let at = |normal: &[f64; 3]| {
        let mut sums = vec![[0.0; 3]; maps.len()];
        for texel in 0..texels.directions().len() {
            let weight = texels.weight(brdf, fineness, texel, *normal);
            for (sum, map) in sums.iter_mut().zip(maps) {
                let radiance = map.texels[texel];
                *sum = [0, 1, 2].map(|c: usize| sum[c] + weight * f64::from(radiance[c]));
            }
        }
        sums
    };
    normals.iter().map(at).collect()
}
