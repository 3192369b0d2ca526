//! The tables of errors of docs/accuracy.md: every figure is computed again.

use crate::support::{Folder, rows};
use crate::tolerances;
use eigenshade_cli::picture::sphere_view::SphereView;
use eigenshade_generator::basis::build;
use eigenshade_model::database::Named;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fitted};
use eigenshade_shading::{reference_image, shipped};
use indicatif::ProgressBar;

/// The same of what f32 rounds, which is another half where multiplication and addition are fused.
const STATED_ROUNDING: f64 = 0.5;

const PAGE: &str = include_str!("../../../docs/accuracy.md");

/// The page has a line that starts like this, and states these numbers.
fn assert_stated(start: &str, found: &[f64], tolerance: f64) {
    let line = PAGE.lines().find(|line| line.starts_with(start));
    let line = line.unwrap_or_else(|| panic!("docs/accuracy.md lacks `{start}`"));
    let stated: Vec<f64> =
        line[start.len()..].split(['|', '/']).filter_map(|one| one.trim().parse().ok()).collect();
    let printed: Vec<String> = found.iter().map(|one| format!("{one:.1e}")).collect();
    println!("{start} {}", printed.join(" | "));
    assert_eq!(stated.len(), found.len(), "{line}");
    for (stated, found) in stated.iter().zip(found) {
        let apart = (stated - found).abs();
        assert!(apart <= tolerance * found, "{line}: {found}");
    }
}

#[test]
fn errors_of_the_demo_are_as_stated() {
    let folder = Folder::new();
    folder.ok("demo --out demo");
    let csv = folder.read("demo/demo.csv");
    let trials =
        rows(&csv, "light,material,components,energy_kept,rms_error,max_error,nanoseconds");
    for material in shipped::SHOWN_MATERIALS {
        let of_light = |light: &str| {
            let trial = trials.iter().find(|row| row[0] == light && row[1] == material);
            [4, 5].map(|place| 100.0 * trial.unwrap()[place].parse::<f64>().unwrap())
        };
        let found: Vec<f64> = shipped::SHOWN_LIGHTS.into_iter().flat_map(of_light).collect();
        assert_stated(&format!("| {material} |"), &found, tolerances::STATED);
    }
}

/// The larger of the two in the middle of an even number, as the page's medians are.
fn median_and_worst(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    [errors[errors.len() / 2], errors[errors.len() - 1]]
}

#[test]
fn errors_of_few_components_are_as_stated() {
    let chosen = |entries: &[Named], names: &[&str]| {
        let of = |name: &&str| entries.iter().find(|entry| entry.name == **name).unwrap().clone();
        names.iter().map(of).collect::<Vec<_>>()
    };
    let (all_lights, all_materials) = (shipped::lights().unwrap(), shipped::materials().unwrap());
    let mut scene = eigenshade_table::decode(shipped::TABLE).unwrap().scene;
    scene.basis.components = Some(usize::MAX);
    let table = build(&scene, &all_lights, &all_materials).unwrap();
    let (mut lights, mut materials) = fitted(&table, &all_lights, &all_materials);
    lights.entries = chosen(&lights.entries, &shipped::SHOWN_LIGHTS);
    materials.entries = chosen(&materials.entries, &shipped::SHOWN_MATERIALS);

    let mut view = SphereView::new(64);
    let mut inside = view.pixels.iter().map(|pixel| pixel.is_inside);
    view.normals.retain(|_| inside.next() == Some(true));
    let normals = OwnedNormals::new(&view.normals);
    let truth = reference_image::images(&lights, &materials, &view.normals, &ProgressBar::hidden());
    let basis = OwnedBasis::<f32>::new(&table);
    let all = table.count();
    let name = format!("{all} (all)");
    for (components, name) in
        [(9, "9"), (25, "25"), (50, "50"), (100, "100"), (150, "150"), (all, &*name)]
    {
        let mut shader = Shader::new(basis.any().unwrap(), components);
        let (mut rms, mut largest, mut inner) = (Vec::new(), Vec::new(), Vec::new());
        for light in &lights.entries {
            for material in &materials.entries {
                let pair = ((lights.degree, light), (materials.order, material));
                let ours = shader.color(pair.0, pair.1, &normals).unwrap();
                let (mut squares, mut most, mut peak) = (0.0, 0.0f64, 0.0f64);
                let mut farther_in: f64 = 0.0;
                for (k, of_pairs) in truth.iter().enumerate() {
                    for (ours, truth) in ours.iter().zip(of_pairs[rms.len()]) {
                        let apart = f64::from(ours[k]) - truth;
                        squares += apart * apart;
                        most = most.max(apart.abs());
                        if view.normals[k][2] > 0.3 {
                            farther_in = farther_in.max(apart.abs());
                        }
                        peak = peak.max(truth.abs());
                    }
                }
                rms.push((squares / (3.0 * truth.len() as f64)).sqrt() / peak);
                largest.push(most / peak);
                inner.push(farther_in / peak);
            }
        }
        let found = [median_and_worst(rms), median_and_worst(largest)].concat();
        if components == 50 {
            let [median, worst] = median_and_worst(inner).map(|error| 100.0 * error);
            let stated =
                format!("{worst:.1} % of the peak, the median picture's largest {median:.1} %");
            assert!(PAGE.contains(&stated), "docs/accuracy.md lacks `{stated}`");
        }
        let is_rounding = components == all;
        let tolerance = if is_rounding { STATED_ROUNDING } else { tolerances::STATED };
        assert_stated(&format!("| {name} |"), &found, tolerance);
    }
}
