//! The figures of `docs/ablation.md`: the scenes' tables, the shares of their effects against sums
//! over modes by hand, their errors, and their costs relative to the nine-term formula.

use crate::support::repository;
use crate::tolerances;
use eigenshade::{Light, NineTerms, Normal};
use eigenshade_cli::table::compare::differences;
use eigenshade_generator::scene_file;
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::{light, material};
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::sphere_rings::rings;
use eigenshade_testing::fixtures;
use eigenshade_testing::{largest, largest_difference, part, relative_error};
use experiments::ablation::scenes::{self, SCENES, Scene, Times};
use experiments::ablation::{self, pictures};
use experiments::pages::Purpose;
use experiments::sheet::{Counts, M0, M4F};
use experiments::sphere::Sphere;

/// Degree 2 in f32 against the nine-term formula in f64, of the peak: rounding of ten sums.
const SAME_AS_NINE_TERMS: f64 = 1e-6;
/// Pictures of effects against sums over modes by hand, of the peak: rounding of 3,704 products.
const EFFECT_BY_HAND: f64 = 2e-14;

/// The committed tables are of their scene files; those that share one differ in color and turns.
#[test]
fn tables_are_of_their_scenes() {
    for scene in &SCENES {
        let table = scene.whole_table();
        let loaded = scene_file::load(scene.path()).expect("a scene");
        let mut fresh = loaded.build().expect("a table");
        let named = &fresh.scene.effects;
        let (color, turns) = (scene.channels == 3, scene.turns);
        assert_eq!((named.color, named.rotation), (color, turns), "{}", scene.name);
        if scene.name != scene.table {
            (fresh.scene.effects.color, fresh.scene.effects.rotation) = (false, false);
        }
        let found = differences(&table, &fresh).expect("two tables of one scene");
        for difference in found {
            assert!(!difference.is_over(), "{}: {difference:?}", scene.name);
        }
    }
}

/// Whether a mode of degree l and order o belongs to an effect.
type Belongs = fn(usize, usize) -> bool;

/// The picture of each effect, mode by mode: (14) times L times b.
#[test]
fn pictures_of_effects_are_sums_over_their_modes() {
    let sphere = Sphere::new(rings(0.5));
    for name in ["sky_lambertian", "studio_plaster", "studio_velvet"] {
        let scene = Scene::named(name);
        let table = scene.whole_table();
        let (degree, order) = (table.gram.degree, table.scene.material.order);
        let (light, material) = (scene.light(degree), scenes::material(&table, order));
        let reference = DirectSum::new(degree, order);
        let by_hand = |belongs: Belongs| -> Vec<f64> {
            let of = |normal: &[f64; 3]| {
                let modes = reference.at(*normal);
                let mut sum = 0.0;
                for ((l, m), of_light) in light::indices(degree).zip(&light.entries[0].rgb[0]) {
                    let material = material::indices(order).zip(&material.entries[0].rgb[0]);
                    for ((o, p, q), b) in material.filter(|((o, ..), _)| belongs(l, *o)) {
                        sum += of_light * b * modes.value(l, m, o, p, q);
                    }
                }
                sum
            };
            sphere.normals.iter().map(of).collect()
        };
        let peak = largest(by_hand(|_, _| true));
        let effects: [(Effect, Belongs); 4] = [
            (Effect::Ambient, |l, _| l == 0),
            (Effect::Diffuse, |l, o| l > 0 && o == 0),
            (Effect::Broad, |l, o| l > 0 && o > 0 && o < 4),
            (Effect::Gloss, |l, o| l > 0 && o > 3),
        ];
        for (effect, belongs) in effects {
            let wanted = Effects::NONE.with(effect);
            let found = &pictures::direct(&sphere, &light, &material, wanted)[0];
            let off = largest_difference(&found[0], &by_hand(belongs));
            assert!(off <= EFFECT_BY_HAND * peak, "{name} {effect:?}: {off}");
        }
    }
}

#[test]
fn a_lambertian_material_under_light_of_degree_two_is_the_nine_term_formula() {
    let scene = Scene::named("sky_lambertian");
    assert_eq!(scene.terms(), 9);
    let table = scene.whole_table();
    let basis = OwnedBasis::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let sphere = Sphere::new(rings(0.2));
    let normals = OwnedNormals::new(&sphere.normals);
    let each: Vec<Normal<f64>> = sphere.normals.iter().map(|&at| fixtures::normal(at)).collect();
    for light in &scene.lights(2).entries {
        let found = shader.polynomial(&light.rgb[0], &[2.0], &normals).expect("it fits");
        let found: Vec<f64> = found.into_iter().map(f64::from).collect();
        let formula = NineTerms::lambertian(&Light::new(&light.rgb[0]).expect("9 numbers"), 1.0);
        let expected: Vec<f64> = each.iter().map(|&normal| formula.shade(normal)).collect();
        let off = relative_error(&found, &expected);
        assert!(off <= SAME_AS_NINE_TERMS, "{off}");
    }
    // To 1e-2, whatever the light of degree 2.
    assert!(pictures::terms_within(&scene, 1e-2).iter().all(|&terms| terms <= 9));
}

/// Without gloss there are fewer components and terms, and less than half of the numbers.
#[test]
fn a_scene_without_gloss_costs_less() {
    for name in ["studio_velvet", "sun_leather"] {
        let scene = Scene::named(name);
        let all = scene.size(None).expect("the scene");
        let less = scene.size(Some(Effect::Gloss)).expect("an effect of the scene");
        assert!(less.components < all.components && less.terms < all.terms, "{less:?} {all:?}");
        assert!(2 * less.numbers < all.numbers, "{less:?} of {all:?}");
    }
}

/// On the boards without and with a float unit, in pixels by the nine-term formula.
#[test]
fn scenes_cost_no_more_than_promised() {
    let counts = Counts::recorded();
    let (lambertian, typical) = (tolerances::OF_NINE_TERMS, tolerances::TYPICAL_OF_NINE_TERMS);
    for (operation, limits) in [
        ("shade_lambertian", [lambertian; 2]),
        ("sky_lambertian/pixel", [lambertian; 2]),
        ("studio_plaster/pixel", [typical; 2]),
        ("studio_velvet/pixel", [typical; 2]),
        ("sun_leather/pixel", [typical; 2]),
        // One term.
        ("ambient_lambertian/pixel", [0.33, 0.5]),
    ] {
        for (on, limit) in [M0, M4F].into_iter().zip(limits) {
            let found = counts.of_nine_terms(on, operation);
            assert!(found <= limit, "{operation} {on:?}: {found}");
        }
    }
    assert_eq!(Scene::named("ambient_lambertian").terms(), 1);
}

/// Times are not compared. The scenes keep their tolerances.
#[test]
fn the_page_has_the_current_figures() {
    let times = Times { scenes: vec![0.0; SCENES.len()], changes: [0.0; 4] };
    let parts = ablation::parts(&times).expect("scenes within their tolerances");
    let page = Purpose { out: None, check: Some(repository().join("docs/ablation.md")) };
    assert_eq!(ablation::PAGE.write_or_compare(&page, &parts), Ok(()));
}

/// `docs/costs.md`, to two digits, and `docs/performance.md` have the shipped table's products.
#[test]
fn pages_agree_on_multiplications() {
    let found = ablation::multiplications();
    let costs = part(include_str!("../../docs/costs.md"), "multiplications");
    for (start, count) in [
        ("`transfer`: ", found.transfer),
        ("`relight`: ", found.relight),
        ("`collapse`: ", found.collapse),
        ("`shade`: ", found.pixel),
    ] {
        println!("{start}{count}");
        let row = costs.lines().find_map(|line| line.strip_prefix(&format!("| {start}")));
        let stated = row.and_then(|row| row.trim_end_matches(" |").rsplit(' ').next());
        let stated: f64 = stated.expect(start).replace(',', "").parse().expect("a number");
        let off = (stated / count as f64 - 1.0).abs();
        assert!(off <= 0.01, "docs/costs.md: {start}{stated} where {count} belongs");
    }
    let row = format!("full scene: 13 13 13 13 13 12 13 | {} |", found.pixel);
    let (_, counts) = include_str!("../../docs/performance.md")
        .split_once("<!-- counts, default -->")
        .expect("the table's start");
    let (counts, _) = counts.split_once("<!-- end of counts, default -->").expect("its end");
    assert!(counts.contains(&row), "{row}");
}
