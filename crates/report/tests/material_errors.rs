//! Errors of materials that no table is made of: total errors against direct integration, what the
//! components of tables leave.

use crate::support::repository;
use crate::{OF_DIGITS, assert_recorded, by_texels, measured_surfaces, shipped_map};
use eigenshade_generator::basis;
use eigenshade_generator::material::brdf::Measure;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::shipped;
use eigenshade_table::reduce::with_components;
use eigenshade_table::scene::MaterialNormalize;
use eigenshade_testing::fixtures::of_equal_areas;
use eigenshade_testing::largest;
use indicatif::ProgressBar;
use report::accuracy_cost::errors::{Errors, Found, Spread, compare};
use report::accuracy_cost::images::Images;
use report::accuracy_cost::scope::{Scope, windowed};
use report::accuracy_cost::settings::{Format, Recipe, Setting};
use report::accuracy_cost::total::references::World;
use report::accuracy_cost::total::subjects::Gltf;
use report::material_errors::{SPACING, errors};
use report::numbers::percent;
use std::fs;

/// Integration in blocks against every texel: the largest difference of the peak. The errors that
/// it is used for are 50 times as large in the median.
const OF_TREE: f64 = 3e-4;
/// Medians and worst maps at normals 1.4 times as far apart, as a factor: widest, narrowest lobe.
const OF_SPACING: f64 = 1.1;

/// Measured materials and formulas.
#[test]
fn blocks_are_their_texels() {
    let maps = ["park", "studio"].map(shipped_map);
    let lights = Lights { degree: 0, entries: Vec::new() };
    let world = World::of(maps.to_vec(), lights, 0.5).unwrap();
    let mut normals = of_equal_areas(16);
    normals.retain(|[.., z]| *z > 0.0);
    normals.extend([0, 1].map(|map| world.tree.mirror(map)));
    let gltf = [(0.1, 0.9, 0.0), (0.22, 0.8, 0.0), (0.45, 0.04, 0.7), (0.95, 0.8, 0.0)];
    let gltf = gltf.map(|(roughness, f0, albedo)| Gltf { roughness, f0, albedo });
    let formulas = gltf.map(|gltf| gltf.surface(format!("{}", gltf.roughness)).unwrap());
    let names = ["chrome", "gold-metallic-paint", "white-fabric2", "two-layer-gold", "pvc"];
    let mut surfaces = measured_surfaces("abc");
    surfaces.retain(|surface| names.contains(&surface.name.as_str()));
    surfaces.extend(formulas);
    assert_eq!(surfaces.len(), 9);
    for surface in surfaces {
        let channel = |c: usize| by_texels(&maps, surface.channel(c), &normals, 1.0);
        let expected: Vec<_> = (0..surface.channels()).map(channel).collect();
        let expected = |c: usize| &expected[c.min(expected.len() - 1)];
        for (map, found) in world.pictures(&surface, &normals).iter().enumerate() {
            let of = |c: usize| expected(c).iter().map(move |image| image[map][c]);
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
        for (found, wider) in found.iter().zip(wider) {
            let recorded = shipped::total_error(name, found.size, found.sources).expect("a row");
            println!("{name}: {found:?}, wider {wider:?}");
            let (wider, found) = (&wider.error, &found.error);
            for (wider, found, recorded) in [
                (wider.median, found.median, recorded.median),
                (wider.most, found.most, recorded.most),
            ] {
                for (wider, found, recorded) in
                    [(wider.mean, found.mean, recorded.mean), (wider.p95, found.p95, recorded.p95)]
                {
                    let off = (found - recorded).abs();
                    assert!(off <= 0.01 * recorded + OF_DIGITS * 1e-2, "{name}: {off}");
                    let off = (wider / found - 1.0).abs();
                    assert!(
                        off <= OF_SPACING - 1.0 || (wider - found).abs() < 0.3,
                        "{name}: {off}"
                    );
                }
            }
        }
    }
    let unknown = errors(&inputs, &["chrom".to_owned()], SPACING, &ProgressBar::hidden());
    assert!(unknown.unwrap_err().to_string().contains("`chrom`"));
}

/// Rows of `merl.energy.csv` of a model and an order: material and share of the energy left out.
fn left_out(model: &str, order: usize) -> Vec<(String, f64)> {
    let path = repository().join("tables/inputs/merl.energy.csv");
    let text = fs::read_to_string(path).unwrap();
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    let rows = rows.map(|line| line.split(',').collect::<Vec<_>>());
    let of_kind = rows.filter(|row| row[1..3] == [model, &order.to_string()]);
    of_kind.map(|row| (row[0].to_owned(), row[3].parse().unwrap())).collect()
}

/// The energies left out and the shipped coefficients, of one broad and one narrow lobe.
#[test]
fn projections_are_found_again() {
    let shipped = shipped::named_materials(12).unwrap().entries;
    let (felt, chrome) = ("pink-felt", "chrome");
    for (model, order, name) in
        [("abc", 12, felt), ("abc", 12, chrome), ("sgd", 7, felt), ("sgd", 12, felt)]
    {
        let all = measured_surfaces(model);
        assert_eq!(all.len(), 94);
        let surface = all.iter().find(|surface| surface.name == name).unwrap();
        let found = surface.project(order, Measure::Projected);
        let recorded = left_out(model, order);
        assert!(recorded.iter().map(|(name, _)| name).eq(all.iter().map(|one| &one.name)));
        let (_, recorded) = recorded.iter().find(|(of, _)| of == name).unwrap();
        println!("{model} {order} {name}: {:.3e}", found.left_out);
        assert!((found.left_out / recorded - 1.0).abs() <= OF_DIGITS * 1e-3, "{recorded}");
        let Some(expected) = shipped.iter().find(|one| (model, &*one.name) == ("abc", name)) else {
            continue;
        };
        for (found, expected) in windowed(found.material).rgb.iter().zip(&expected.rgb) {
            let apart = found.iter().zip(expected).map(|(a, b)| a - b);
            assert!(largest(apart) <= 1e-9 * largest(expected.iter().copied()), "{name}");
        }
    }
}

/// Scenes of `tables/` and numbers of components: of the gray materials of CUReT; of the table that
/// the runtime compiles in; of the table with which `render` draws.
const TABLES: [(&str, &[usize]); 3] =
    [("curet", &[50, 64, 100]), ("sphere", &[46]), ("color", &[50, 64, 80, 100, 120, 160])];
/// The largest rms error, relative to the peak, that `tables/color.toml` allows itself.
const OF_ALL: f64 = 1e-5;

#[test]
fn errors_of_unseen_materials() {
    let tables = repository().join("tables");
    let load = |name| scene_file::load(tables.join(format!("{name}.toml"))).unwrap();
    let unseen = shipped::unseen_materials().unwrap();
    assert_eq!(unseen.entries.len(), 47);
    let [ours, color] = ["sphere", "color"].map(|name| load(name).scene.material.names);
    assert_eq!(ours, color);
    let measured = TABLES.map(|(name, components)| errors_of(load(name), &unseen, components));
    let color = measured[2].last().unwrap();
    for Errors { rms, .. } in [color.seen, color.unseen] {
        assert!(rms.worst <= OF_ALL, "{rms:?}");
    }
    let mut as_they_are = load("color");
    as_they_are.scene.material.normalize = MaterialNormalize::None;
    let as_they_are = errors_of(as_they_are, &unseen, &TABLES[2].1[..1]);
    let [unequal, equal] = [&as_they_are[0], &measured[2][0]].map(|one| one.unseen.rms.median);
    assert!(unequal > 2.0 * equal, "{unequal:e} {equal:e}");
    let mut rows = Vec::new();
    for ((name, components), found) in TABLES.into_iter().zip(&measured) {
        for (components, Found { seen, unseen, .. }) in components.iter().zip(found) {
            let mut row = vec![format!("`{name}`"), components.to_string()];
            row.extend([seen.rms, unseen.rms].map(cells).concat());
            row.push(percent(unseen.largest.most, 2));
            rows.push(row);
        }
    }
    let columns = "scene,components,its own: median,its own: 95 %,its own: worst,unseen: median,\
                   unseen: 95 %,unseen: worst,95 % of worst pixels";
    assert_recorded("unseen.csv", columns, &rows);
}

/// The errors with each number of components, over all lights as captured.
fn errors_of(loaded: Loaded, unseen: &Materials, components: &[usize]) -> Vec<Found> {
    let Loaded { mut scene, lights, materials: seen, .. } = loaded;
    let (degree, order) = (scene.light.degree, scene.material.order);
    let scope = Scope { degree, order, lights, seen, unseen: unseen.clone() };
    scene.basis.components = components.last().copied();
    let whole = basis::build(&scene, &scope.lights, &scope.seen).unwrap();
    let images = Images::new(&scope);
    let errors = |&components: &usize| {
        let recipe = Recipe::first(degree, order, components);
        let table = with_components(&whole, |number, _| number < components);
        compare(&Setting::of(recipe).in_format(Format::F64), &table, &images).unwrap()
    };
    components.iter().map(errors).collect()
}

fn cells(Spread { median, most, worst }: Spread) -> [String; 3] {
    [median, most, worst].map(error)
}

/// What pictures do not show is not told apart.
fn error(share: f64) -> String {
    if share < OF_ALL { "< 0.001 %".into() } else { percent(share, 2) }
}
