//! Errors that a table's components leave for materials outside its scene, and the table of them in
//! `docs/accuracy.md`.

use crate::assert_readme_says;
use crate::support::repository;
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_model::database::Materials;
use eigenshade_shading::shipped;
use eigenshade_table::decode;
use eigenshade_table::reduce::with_components;
use eigenshade_table::scene::MaterialNormalize;
use experiments::accuracy_cost::errors::{Errors, Found, Spread, compare};
use experiments::accuracy_cost::images::Images;
use experiments::accuracy_cost::scope::Scope;
use experiments::accuracy_cost::settings::{Format, Recipe, Setting};
use experiments::multiplications::Multiplications;
use experiments::numbers::percent;
use std::fs;

/// Scenes of `tables/` and numbers of components: of the gray materials of CUReT; of the table that
/// the runtime compiles in; of the table with which `render` draws.
const TABLES: [(&str, &[usize]); 3] =
    [("curet", &[50, 64, 100]), ("sphere", &[46]), ("color", &[50, 64, 80, 100, 120, 160])];
/// Multiply-adds by which any step may cost more with the shipped table than with that of CUReT.
const DEARER: f64 = 1.01;
/// The largest rms error, relative to the peak, that `tables/color.toml` allows itself.
const OF_ALL: f64 = 1e-5;

#[test]
fn the_page_has_the_errors_of_unseen_materials() {
    let tables = repository().join("tables");
    let load = |name| scene_file::load(tables.join(format!("{name}.toml"))).unwrap();
    let unseen = shipped::unseen_materials().unwrap();
    assert_eq!(unseen.entries.len(), 47);
    let [ours, color] = ["sphere", "color"].map(|name| load(name).scene.material.names);
    assert_eq!(ours, color);
    let [of_shipped, of_curet] = [shipped::TABLE, shipped::CURET].map(costs);
    for (ours, before) in of_shipped.into_iter().zip(of_curet) {
        assert!(ours as f64 <= DEARER * before as f64, "{of_shipped:?} {of_curet:?}");
    }
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
    let mut page = String::from(
        "| scene | components | its own: median | 95 % | worst | unseen: median | 95 % | worst | \
         95 % of worst pixels |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for ((name, components), found) in TABLES.into_iter().zip(&measured) {
        for (components, Found { seen, unseen, .. }) in components.iter().zip(found) {
            let cells = [seen.rms, unseen.rms].map(cells).join(" | ");
            let pixel = percent(unseen.largest.most, 2);
            page += &format!("| `{name}` | {components} | {cells} | {pixel} |\n");
        }
    }
    println!("{page}");
    let text = fs::read_to_string(repository().join("docs/accuracy.md")).unwrap();
    assert!(text.contains(&page), "docs/accuracy.md lacks the table above");
    let Spread { median, most, .. } = measured[1][0].unseen.rms;
    let [median, most] = [median, most].map(|share| percent(share, 2));
    assert_readme_says(&format!(
        "off by {median} of the peak (rms) in the median and by {most} for one in twenty"
    ));
}

/// Multiplications of a table: a pixel, a new light's two steps, a new material.
fn costs(table: &[u8]) -> [usize; 4] {
    let costs = Multiplications::of(&decode(table).unwrap()).unwrap();
    [costs.pixel, costs.relight, costs.collapse, costs.transfer]
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

fn cells(Spread { median, most, worst }: Spread) -> String {
    [median, most, worst].map(error).join(" | ")
}

/// What pictures do not show is not told apart.
fn error(share: f64) -> String {
    if share < OF_ALL { "< 0.001 %".into() } else { percent(share, 2) }
}
