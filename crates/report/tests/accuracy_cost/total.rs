//! The total error: recorded rows are found again; references, errors and rivals are as stated.

use super::{docs, rows};
use crate::support::repository;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::project;
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::screen::ScreenError;
use eigenshade_model::shipped;
use eigenshade_shading::sources::screen::Reference;
use eigenshade_testing::largest;
use indicatif::ProgressBar;
use palette::Lab;
use palette::color_difference::Ciede2000;
use report::accuracy_cost::settings;
use report::accuracy_cost::sheet::{TOTAL, compare};
use report::accuracy_cost::total::references::{SPACING, World};
use report::accuracy_cost::total::rivals::{Prefiltered, matcap};
use report::accuracy_cost::total::subjects::{self, GROUPS, Gltf, Kind, Subject};
use report::accuracy_cost::total::{HIGHEST, MATCAP, PREFILTERED, Study};
use report::sheet::Record;
use report::sphere::Picture;

/// Medians and 95th percentiles of a mean at normals 1.4 times as far apart, as a factor: half as
/// many normals meet other parts of the highlights.
const OF_SPACING: f64 = 1.1;
/// The split sum under white light, of the peak: both integrate one lobe over the same texels.
const OF_WHITE: f64 = 1e-6;
/// A matcap of a matte sphere against direct integration, of the peak, where no texel is outside
/// the disc: bilinear look-ups err by an eighth of a texel's square times the curvature.
const OF_MATCAP: f64 = 2e-3;

/// The materials of a kind.
fn of_kind(kind: Kind) -> Vec<Subject> {
    let mut all = subjects::all().expect("the materials");
    all.retain(|subject| subject.kind == kind);
    all
}

fn find<'a>(rows: &'a [Record], setting: &str, kind: &str) -> &'a Record {
    let is_it = |row: &&Record| (row.text("setting"), row.text("kind")) == (setting, kind);
    rows.iter().find(is_it).unwrap_or_else(|| panic!("no row of {setting}, {kind}"))
}

/// The shipped tables and rivals, for a few materials. The command checks those of the settings.
#[test]
fn recorded_total_errors_are_found_again() {
    let maps = repository().join("tables/inputs/maps");
    let study = |spacing| {
        let few = subjects::few().expect("the materials");
        Study::new(&maps, few, &[7, 12], spacing, &ProgressBar::hidden()).expect("the shipped data")
    };
    let again = study(SPACING);
    let shipped = again.shipped().expect("the shipped tables");
    let rivals = again.rivals().expect("the rivals");
    let found = [shipped, rivals].concat();
    // Two groups, but the rivals are for glTF.
    assert_eq!(found.len(), 2 * 4 + 2);
    let [rows, numbers] = compare(&TOTAL, &found, &docs(), false).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((rows, numbers), (10, 10 * 13));
    let wider = study(1.4 * SPACING).shipped().expect("the shipped tables");
    assert!(wider.len() >= 6);
    for wider in &wider {
        let found = find(&found, wider.text("setting"), wider.text("kind"));
        for column in ["mean_median", "mean_most"] {
            let ratio = [wider, found].map(|row| row.number(column).expect("a number"));
            let ratio = ratio[0] / ratio[1];
            println!("{} {} {column}: {ratio:.3}", found.text("setting"), found.text("kind"));
            assert!((1.0 / OF_SPACING..OF_SPACING).contains(&ratio), "{ratio}");
        }
    }
}

/// Each setting up to the highest order is there for each kind, and the rivals where they apply.
#[test]
fn the_file_has_all_settings_and_kinds() {
    let rows = rows(&TOTAL);
    for one in settings::all(false) {
        let expected = if one.setting.recipe.order <= HIGHEST { GROUPS.len() } else { 0 };
        let name = one.setting.to_string();
        let of_setting = rows.iter().filter(|row| row.text("setting") == name);
        assert_eq!(of_setting.count(), expected, "{name}");
    }
    let kinds = |name: &str| -> Vec<&str> {
        let of = rows.iter().filter(|row| row.text("setting") == name);
        of.map(|row| row.text("kind")).collect()
    };
    assert_eq!(kinds(MATCAP), ["metal", "dielectric", "gltf", "matte", "few gltf"]);
    assert_eq!(kinds(PREFILTERED), ["metal", "dielectric", "gltf", "few gltf"]);
    let whole = find(&rows, "color.bin f32", "all");
    assert_eq!(whole.text("pictures"), (18 * (18 + 3 + 47)).to_string());
}

/// No table is made of any material: its name is in no scene file, and its parameters are not those
/// of `tables/inputs/pbr-materials.toml`.
#[test]
fn the_materials_are_unseen() {
    let subjects = subjects::all().expect("the materials");
    let unseen = shipped::unseen_materials().expect("the materials").entries;
    let text = include_str!("../../../../tables/inputs/pbr-materials.toml");
    for subject in &subjects {
        let name = &subject.surface.name;
        if subject.kind == Kind::Measured {
            assert!(unseen.iter().any(|one| one.name == *name), "{name}");
        }
        let (_, parameter) = name.rsplit_once('-').unwrap_or(("", name));
        let key = if subject.kind == Kind::Matte { "sigma" } else { "roughness" };
        assert!(!text.contains(&format!("{key} = {parameter}\n")), "{name}");
    }
    // At the shipped order, measured materials have the shipped coefficients: some of them.
    let measured = of_kind(Kind::Measured);
    assert!(measured.iter().map(|one| &one.surface.name).eq(unseen.iter().map(|one| &one.name)));
    let some: Vec<Subject> = measured.into_iter().step_by(9).collect();
    let materials = &subjects::coefficients(&some, &[7])[0];
    for (found, shipped) in materials.entries.iter().zip(unseen.iter().step_by(9)) {
        for (found, shipped) in found.rgb.iter().flatten().zip(shipped.rgb.iter().flatten()) {
            let off = (found - shipped).abs();
            assert!(off <= 1e-5 * shipped.abs().max(1e-2), "{off}");
        }
    }
}

/// White light from everywhere, 128 x 64.
fn white() -> World {
    let map = EnvironmentMap::new(128, 64, vec![[1.0; 3]; 128 * 64]).expect("a map");
    let light = Named { name: "white".into(), rgb: project(&map, 2) };
    let lights = Lights { degree: 2, entries: vec![light] };
    World::of(vec![map], lights, 0.15).expect("a map")
}

/// Under white light, the split sum of a metal is exact.
#[test]
fn the_split_sum_is_exact_under_white_light() {
    let world = white();
    for (roughness, f0) in [(0.22, 0.8), (0.65, 0.04)] {
        let gltf = |albedo| Gltf { roughness, f0, albedo };
        let surface = gltf(0.0).surface("metal".into()).expect("a material");
        let expected = &world.pictures(&surface, &world.sphere.normals)[0];
        let prefiltered = Prefiltered::new(roughness, &world).expect("a map");
        let picture = |albedo| prefiltered.pictures(gltf(albedo), &world).expect("a picture");
        let (whole, lobe) = (&picture(0.7)[0], &picture(0.0)[0]);
        let pairs = lobe.iter().flatten().zip(expected.iter().flatten());
        let apart = largest(pairs.map(|(a, b)| a - b));
        assert!(apart <= OF_WHITE, "{roughness}: {apart:e}");
        // The matte part is what the lobe leaves of the albedo.
        for (whole, lobe) in whole[0].iter().zip(&lobe[0]) {
            assert!((whole - lobe - 0.7 * (1.0 - lobe)).abs() < 1e-3, "{whole} {lobe}");
        }
    }
}

/// A matcap has the values of direct integration between its texels, where the image is smooth.
#[test]
fn a_matcap_is_right_inside() {
    let mut world = white();
    // A sky: linear in y, so the matte irradiance is linear in the normal.
    let map = &mut world.maps[0];
    for row in 0..map.height {
        for column in 0..map.width {
            let [_, y, _] = map.direction(column, row);
            map.texels[row * map.width + column] = [(1.0 + y) as f32; 3];
        }
    }
    let world = World::of(world.maps, world.lights, 0.15).expect("a map");
    let matte = &of_kind(Kind::Matte)[0];
    let found = &matcap(&matte.surface, &world)[0];
    let expected = &world.pictures(&matte.surface, &world.sphere.normals)[0];
    let peak = expected.iter().flatten().fold(0.0, |most: f64, &value| value.max(most));
    let mut checked = 0;
    for (k, [x, y, _]) in world.sphere.normals.iter().enumerate() {
        if x.hypot(*y) < 0.9 {
            let apart = (found[1][k] - expected[1][k]).abs() / peak;
            assert!(apart <= OF_MATCAP, "{x} {y}: {apart}");
            checked += 1;
        }
    }
    assert!(checked > 100, "{checked}");
}

/// Errors of pictures that are made up.
#[test]
fn errors_are_those_of_known_pictures() {
    let world = white();
    let sphere = &world.sphere;
    let count = sphere.normals.len();
    let flat = |value: f64| [0; 3].map(|_| vec![value; count]);
    let reference = Reference::new(flat(2.0), sphere);
    let error = |picture: &Picture| reference.errors(picture, sphere).all;
    assert_eq!(error(&flat(2.0)), ScreenError::default());
    // A metered picture of one color is white to within the seven per cent of the meter.
    let off = error(&flat(1.0));
    assert!((0.46..0.54).contains(&off.white) && off.mean > 1.0, "{off:?}");
    assert!((off.p95 - off.mean).abs() < 1e-9, "{off:?}");
    // What is brighter than white shows as white.
    assert!(error(&flat(5.0)).white < 0.08, "{:?}", error(&flat(5.0)));
    // Black instead of white is a difference of 100 by definition.
    let black = error(&flat(0.0));
    assert!((95.0..=100.001).contains(&black.mean), "{black:?}");
    // Pixels with four hundredths of the weight are beyond the 95th percentile, six are not.
    for (share, is_seen) in [(0.04, false), (0.06, true)] {
        let (mut picture, mut weight) = (flat(2.0), 0.0);
        for k in (0..count).take_while(|&k| {
            weight += sphere.weights[k];
            weight < share
        }) {
            (0..3).for_each(|c| picture[c][k] = 0.0);
        }
        let error = error(&picture);
        assert_eq!(error.p95 > 50.0, is_seen, "{share}: {error:?}");
        assert!((0.8..1.01).contains(&(error.mean / (share * black.mean))), "{share}: {error:?}");
    }
    // A lamp is clipped in the reference; only the rest has errors.
    let mut weight = 0.0;
    let is_lamp: Vec<bool> =
        sphere.weights.iter().map(|one| (weight += one, weight < 0.08).1).collect();
    let lit = |lamp: f64, rest: f64| {
        [0; 3].map(|_| is_lamp.iter().map(|&is| if is { lamp } else { rest }).collect())
    };
    let reference = Reference::new(lit(100.0, 0.1), sphere);
    let errors = reference.errors(&lit(90.0, 0.12), sphere);
    let share = errors.below.mean / errors.all.mean;
    assert!((1.05..1.1).contains(&share) && errors.all.mean > 0.5, "{errors:?}");
    assert!(reference.errors(&lit(f64::NAN, 0.1), sphere).all.white.is_nan());
}

/// CIEDE2000 of the library against pairs that its authors publish: G. Sharma, W. Wu, E. N. Dalal,
/// "The CIEDE2000 color-difference formula", Color Research and Application 30, 2005, table 1.
#[test]
fn differences_are_the_published_ones() {
    for (a, b, expected) in [
        ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
        ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
        ([50.0, 2.5, 0.0], [50.0, 3.2592, 0.335], 1.0),
        ([2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514], 0.9082),
    ] {
        let [a, b]: [Lab; 2] = [a, b].map(|[l, a, b]: [f32; 3]| Lab::new(l, a, b));
        assert!((a.difference(b) - expected).abs() < 1e-3, "{a:?} {b:?} {}", a.difference(b));
    }
}

/// The windows that `eigenshade render` chooses lower the screen error, over all pictures and over
/// those with sources.
#[test]
fn windows_bring_pictures_nearer() {
    let rows = rows(&TOTAL);
    for table in ["9/7 all polynomial f32", "12/12 K400 polynomial f32"] {
        for sources in ["", " sources4", " sources8"] {
            let number = |window: &str, column| {
                let name = format!("{table}{sources}{window}");
                find(&rows, &name, "all").number(column).expect("a number")
            };
            for column in ["mean_median", "mean_most", "p95_most"] {
                let [with, without] = ["", " no-window"].map(|window| number(window, column));
                assert!(with <= 1.02 * without, "{table}{sources} {column}: {with} {without}");
            }
            let [with, without] = ["", " no-window"].map(|window| number(window, "mean_most"));
            assert!(!sources.is_empty() || with < 0.85 * without, "{table}: {with} {without}");
        }
    }
}
