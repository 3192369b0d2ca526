//! The total error: recorded rows are found again; references, errors and rivals are as stated.

use super::{docs, rows};
use crate::support::repository;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::project;
use eigenshade_model::database::{Lights, Named};
use eigenshade_shading::shipped;
use eigenshade_testing::largest;
use experiments::accuracy_cost::settings;
use experiments::accuracy_cost::sheet::{TOTAL, compare};
use experiments::accuracy_cost::total::references::{ReferencePicture, SPACING, World};
use experiments::accuracy_cost::total::rivals::{Prefiltered, matcap};
use experiments::accuracy_cost::total::subjects::{self, GROUPS, Gltf, Kind, Subject};
use experiments::accuracy_cost::total::{HIGHEST, MATCAP, PREFILTERED, Study};
use experiments::sheet::Record;
use indicatif::ProgressBar;

/// Medians and 95th percentiles of an rms at normals 1.4 times as far apart, as a factor: half as
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
    assert_eq!((rows, numbers), (10, 10 * 8));
    let wider = study(1.4 * SPACING).shipped().expect("the shipped tables");
    assert!(wider.len() >= 6);
    for wider in &wider {
        let found = find(&found, wider.text("setting"), wider.text("kind"));
        for column in ["rms_median", "rms_most"] {
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
    let text = include_str!("../../../tables/inputs/pbr-materials.toml");
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
    let count = world.sphere.normals.len();
    let flat = |value: f64| [0; 3].map(|_| vec![value; count]);
    let reference = ReferencePicture::new(flat(2.0), &world.sphere);
    let same = reference.error(&flat(2.0), &world.sphere);
    assert_eq!([same.rms, same.pixel, same.difference], [0.0; 3]);
    let off = reference.error(&flat(1.5), &world.sphere);
    assert!((off.rms - 0.25).abs() < 1e-12 && (off.pixel - 0.25).abs() < 1e-12, "{off:?}");
    // Black instead of white is a difference of 100 by definition. A metered picture of one color
    // is white to within the seven per cent of the meter.
    let black = reference.error(&flat(0.0), &world.sphere);
    assert!((95.0..=100.001).contains(&black.difference), "{black:?}");
    assert!((0.0..black.difference).contains(&off.difference) && off.difference > 1.0);
    // One pixel in one channel.
    let mut one = flat(2.0);
    one[1][7] = 0.0;
    let off = reference.error(&one, &world.sphere);
    let expected = (world.sphere.weights[7] / 3.0).sqrt();
    assert!((off.rms - expected).abs() < 1e-12 && off.pixel == 1.0, "{off:?}");
    one[1][7] = f64::NAN;
    assert!(reference.error(&one, &world.sphere).pixel.is_nan());
}

/// What the page says of its tables.
#[test]
fn the_page_says_what_the_file_has() {
    let rows = rows(&TOTAL);
    let number =
        |setting, kind, column: &str| find(&rows, setting, kind).number(column).expect("a number");
    let (whole, nine) = ("9/7 all polynomial f32", "2/0 all nine-terms f32");
    assert!(number(whole, "all", "rms_median") < 0.02);
    // Sharp measured materials keep the 95th percentile up.
    let [low, high] = [whole, "16/16 K400 polynomial f32"];
    assert!(number(high, "measured", "rms_most") > 0.85 * number(low, "measured", "rms_most"));
    assert!(number(high, "gltf", "rms_most") < 0.6 * number(low, "gltf", "rms_most"));
    // With 4 sources, degree 9 and order 7 is nearer than degree 12 and order 12.
    for (kind, column) in [("gltf", "rms_median"), ("gltf", "rms_most"), ("measured", "rms_most")] {
        let four = number("9/7 all polynomial f32 sources4", kind, column);
        assert!(four < number("12/12 K400 polynomial f32", kind, column), "{kind} {column}");
    }
    // Neither the format nor the last terms matter.
    let ratio = |a, b| number(a, "all", "rms_most") / number(b, "all", "rms_most");
    assert!((ratio("sphere.bin q15", "sphere.bin f32") - 1.0).abs() < 0.01);
    assert!((ratio("9/7 K130 trim2e-4 polynomial f32", whole) - 1.0).abs() < 0.01);
    // Nine components: a smaller rms than the nine-term formula, a larger difference of color.
    let few = "9/7 K9 trim1e-1 polynomial f32";
    assert!(ratio(few, nine) < 0.8);
    let color = |setting| number(setting, "all", "difference_most");
    assert!(color(few) > 1.4 * color(nine));
    // Of glTF materials, the prefiltered maps are off by more than twice as much.
    for column in ["rms_median", "rms_most"] {
        assert!(number(PREFILTERED, "gltf", column) > 2.0 * number(whole, "gltf", column));
        assert!(number(MATCAP, "gltf", column) < 0.7 * number(whole, "gltf", column));
    }
}
