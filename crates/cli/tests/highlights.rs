//! Small sources: finding them in a map, reading them from files, and pictures with them.

use crate::support::{Folder, assert_contains, assert_fails, shipped_path};
use eigenshade_cli::reading::pixels::LinearImage;
use eigenshade_generator::material::brdf::{Brdf, Geometry, Ggx};
use eigenshade_model::inputs::gloss_csv::read_glosses;
use eigenshade_model::inputs::set_error_csv::read_set_errors;
use eigenshade_model::inputs::source_csv::read_sources;
use eigenshade_model::source::{Gloss, SetError};
use eigenshade_shading::shipped;
use eigenshade_testing::fixtures;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A map of one lamp of 0.1 rad, half-way between the camera and the right, on a dim sky, as PFM.
fn lamp() -> Vec<u8> {
    // No multiples of the blocks of texels that sources are found with.
    let (width, height) = (66_usize, 33_usize);
    let texel = |k: usize| -> [f32; 3] {
        let polar = PI * ((k / width) as f64 + 0.5) / height as f64;
        let turn = TAU * (((k % width) as f64 + 0.5) / width as f64 - 0.5);
        let [x, z] = [turn.sin() * polar.sin(), -turn.cos() * polar.sin()];
        [if 0.6 * x + 0.8 * z > 0.1_f64.cos() { 20.0 } else { 0.1 }; 3]
    };
    fixtures::pfm(width, &(0..width * height).map(texel).collect::<Vec<_>>())
}

/// Directions of a lamp that is found, radians; and a highlight against the picture without it.
const PLACE: f64 = 0.03;

#[test]
fn a_lamp_is_found_and_mirrored() {
    let folder = Folder::new();
    folder.write("lamp.pfm", lamp());
    folder.ok("light lamp.pfm --sources 1 --for 0.3 --degree 9 --out lamp.csv");
    let lights = read_sources(folder.path("lamp.sources.csv")).unwrap();
    let [light] = &lights[..] else { panic!("{lights:?}") };
    let [source] = light.of_most(1) else { panic!("{light:?}") };
    let [x, _, z] = source.direction;
    assert!((0.6 * x + 0.8 * z).acos() < PLACE, "{source:?}");
    // What is left of pictures is beside them: a source halves it.
    let errors = read_set_errors(folder.path("lamp.sources.errors.csv")).unwrap();
    let rms = |most: usize| {
        let of_set = |one: &&SetError| (one.most, one.size) == (most, (9, 7));
        errors.iter().find(of_set).unwrap().errors[2].rms
    };
    assert!(rms(1) < 0.5 * rms(0) && rms(0) < 0.1, "{errors:?}");
    folder.ok("material ggx --roughness 0.3 --f0 0.9,0.6,0.3 --out copper.csv");
    let peak = |options: &str| peak_of(&folder, &format!("-l lamp.csv -m {PAINT} {options}"));
    let (_, blurred) = peak("");
    // The normal half-way to the lamp has x = 0.316.
    let (column, sharp) = peak("--sources 1");
    assert!(column.abs_diff(42) <= 2, "{column}");
    assert!(sharp > 1.3 * blurred, "{sharp} {blurred}");
    // A rotation turns the source with the light: by π about z to the other side.
    let (column, turned) = peak("--sources 1 --rotate 3.14159265,0,0");
    assert!(column.abs_diff(21) <= 2 && (turned / sharp - 1.0).abs() < 0.02, "{column} {turned}");
    // A material that is not shipped.
    let copper = |options: &str| peak_of(&folder, &format!("-l lamp.csv -m copper.csv {options}"));
    let [(_, blurred), (column, sharp)] = ["", "--sources 1"].map(copper);
    assert!(column.abs_diff(42) <= 2 && sharp > 1.3 * blurred, "{column} {sharp} {blurred}");
    // As few as the tolerance allows: one at 0.3, none for a large tolerance.
    let said = |tolerance: f64| {
        let choice = format!("--sources auto --tolerance {tolerance} -s 16 -o a.png");
        folder.messages(&format!("render -l lamp.csv -m copper.csv {choice}"))
    };
    for (tolerance, report) in [
        (0.5 * (rms(0) + rms(1)), "1 source at degree 9, order 7 leaves"),
        (1.01 * rms(0), "no sources at degree 9, order 7 leave"),
        (1e-9, "more than the 0.0000001 % asked for"),
    ] {
        assert_contains(&said(tolerance), &[report]);
    }
    assert_eq!(copper("--sources auto --tolerance 0.9"), copper(""));
}

/// A shipped material whose lobe is wide enough for a small map.
const PAINT: &str = "color-changing-paint2";

/// The column and the green irradiance of the brightest pixel of a sphere 64 pixels wide.
fn peak_of(folder: &Folder, options: &str) -> (usize, f64) {
    folder.ok(&format!("render --size 64 --out a.exr {options}"));
    let image = LinearImage::read(folder.path("a.exr"), None).unwrap();
    let green = image.pixels.iter().map(|pixel| pixel[1]).enumerate();
    let (place, peak) = green.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    (place % 64, peak)
}

/// The gloss beside a material CSV: exact for formulas, fitted to measurements.
#[test]
fn materials_have_their_gloss_beside_them() {
    let folder = Folder::new();
    folder.ok("material ggx --roughness 0.25 --f0 0.9,0.6,0.3 --albedo 0.1 --out m.csv");
    let exact = Gloss {
        roughness: 0.25,
        reflectance: [0.9, 0.6, 0.3],
        grazing: [1.0; 3],
        albedo: [0.1; 3],
    };
    let glosses = read_glosses(folder.path("m.gloss.csv")).unwrap();
    let [one] = &glosses[..] else { panic!("{glosses:?}") };
    assert_eq!((one.name.as_str(), one.gloss, one.error), ("ggx", exact, 0.0));
    // Measurements of the same BRDF, every 7.5 degrees and every 15 around.
    let colors = exact.reflectance.map(|f0| Ggx::new(0.25, f0, 0.1).unwrap());
    let row = |place: i32| {
        let [i, r] = [place / 156, place / 13 % 12].map(|k| FRAC_PI_2 * f64::from(k) / 12.0);
        let phi = PI * f64::from(place % 13) / 12.0;
        let at = Geometry::from_angles(i, r, phi);
        let [red, green, blue] = colors.each_ref().map(|color| color.value(at));
        format!("{i},{phi},{r},0,{red},{green},{blue}\n")
    };
    let measured: String = (0..12 * 12 * 13).map(row).collect();
    folder.write("copper.csv", format!("theta_i,phi_i,theta_r,phi_r,r,g,b\n{measured}"));
    folder.ok("material copper.csv --out n.csv");
    let glosses = read_glosses(folder.path("n.gloss.csv")).unwrap();
    let [one] = &glosses[..] else { panic!("{glosses:?}") };
    let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() < by, "{a} {b}: {one:?}");
    near(one.gloss.roughness, 0.25, 0.005);
    for c in 0..3 {
        near(one.gloss.reflectance[c], exact.reflectance[c], 0.02);
        near(one.gloss.albedo[c], 0.1, 0.02);
    }
    assert!(one.error < 0.01, "{one:?}");
    folder.ok("render -l studio -m n.csv --sources 2 -s 16 -o a.png");
    // Not beside what is no CSV.
    folder.ok("material ggx --roughness 0.25 --f0 0.9 --out other.txt");
    assert!(!folder.names().iter().any(|name| name.starts_with("other.gloss")));
}

/// One sentence for a sphere like chrome, with the figures of a metal of its roughness; none for a
/// matte one, nor for one that sources show.
#[test]
fn smooth_materials_are_beyond_the_method() {
    let folder = Folder::new();
    for (roughness, name) in [("0.1", "smooth"), ("0.3", "glossy"), ("0.8", "matte")] {
        folder.ok(&format!(
            "material ggx --roughness {roughness} --f0 0.9 --name {name} --out {name}.csv"
        ));
    }
    let said = |light: &str, material: &str, options: &str| {
        let drawn = format!("render -l {light} -m {material}.csv -s 16 -o a.png {options}");
        let text = folder.messages(&drawn);
        let notes: Vec<&str> = text.lines().filter(|line| line.contains("sharper")).collect();
        assert!(notes.len() <= 1, "{text}");
        notes.concat()
    };
    let errors = shipped::set_errors().unwrap();
    let of = |most: usize| {
        let is =
            |one: &&SetError| (one.light.as_str(), one.most, one.size) == ("studio", most, (9, 7));
        let error = errors.iter().find(is).unwrap().errors[0];
        [
            format!("by {:.1} % of their peak", 100.0 * error.rms),
            format!("by up to {:.0} %, in the worse of two views", 100.0 * error.worst),
        ]
    };
    let note = said("studio", "smooth", "");
    let start = "note: `smooth` is sharper than order 7 can show: at degree 9,";
    assert!(note.starts_with(start), "{note}");
    let [rms, worst] = of(0);
    assert_contains(&note, &[&rms, &worst, "`studio`"]);
    assert!(note.ends_with("`--sources 4` draws small bright sources sharply"), "{note}");
    let note = said("studio", "smooth", "--sources 4");
    assert!(note.contains("than order 7 and 4 sources can show"), "{note}");
    let [rms, worst] = of(4);
    assert!(note.contains(&rms) && note.ends_with(&worst), "{note}");
    // Under a light without a map, what is known of other lights.
    let note = said("blender-city", "smooth", "");
    assert!(note.contains("under some lights by"), "{note}");
    assert_ne!(said("studio", "glossy", ""), "");
    assert_eq!(said("studio", "glossy", "--sources 4"), "");
    assert_eq!(said("studio", "matte", ""), "");
}

#[test]
fn pictures_say_what_they_lack() {
    let folder = Folder::new();
    let said = |arguments: &str| folder.messages(&format!("render {arguments} -s 16 -o a.png"));
    assert_eq!(said("-l studio -m gold-metallic-paint --sources 4"), "");
    // No lobe of its own, whose roughness would mean something.
    folder.ok("material oren-nayar --sigma 0.5 --albedo 0.2,0.4,0.8 --out rough.csv");
    assert_eq!(said("-l studio -m rough.csv"), "");
    for (drawn, note) in [
        ("-l studio -m pink-felt --sources 4", "as matte as a roughness"),
        ("-l studio -m two-layer-gold --sources 4", "not quite a GGX lobe"),
        ("-l studio -m rough.csv --sources 4", "as matte as a roughness of 1.00"),
        ("-l studio -m chrome --sources 3", "2 sources, the largest set of at most 3"),
        ("-l city -m chrome --sources 1", "0 sources, the largest set of at most 1"),
    ] {
        assert_contains(&said(drawn), &[note]);
    }
    for (refused, fragments) in [
        ("-l blender-city -m nylon", ["blender-city", "has no map"]),
        ("-l studio -m 07-velvet", ["07-velvet", "gloss"]),
        (
            "-l studio -m materials.csv:material-0",
            ["material-0", "eigenshade material .. --out FILE.csv"],
        ),
        ("-l lights.csv:light-0 -m nylon", ["lights.sources.csv", "light MAP --sources"]),
    ] {
        assert_fails(&folder, &format!("render {refused} --sources 4 -o a.png"), &fragments);
    }
    let csv = format!("light {} --sources 4 --out b.csv", shipped_path("inputs/lights.csv"));
    assert_fails(&folder, &csv, &["--sources needs a map"]);
}

/// A pixel of degree 12 takes fewer multiply-adds than one of degree 9 with sources that leave as
/// little, and harmonics alone show the walls of a city better at degree 12.
#[test]
fn a_tolerance_chooses_table_and_sources() {
    let folder = Folder::new();
    folder.ok("material ggx --roughness 0.5 --f0 0.9 --order 12 --out m.csv");
    folder.ok("material ggx --roughness 0.5 --f0 0.9 --out low.csv");
    let drawn = |light: &str, material: &str, options: &str| {
        let drawn = format!("render -l {light} -m {material} -s 16 -o a.exr {options}");
        let said = folder.messages(&drawn);
        (said, LinearImage::read(folder.path("a.exr"), None).unwrap().pixels)
    };
    let auto = |light: &str, material: &str, tolerance: &str| {
        drawn(light, material, &format!("--sources auto --tolerance {tolerance}"))
    };
    folder.ok("material ggx --roughness 0.65 --f0 0.9 --order 12 --out matte.csv");
    for (light, material, tolerance, report, same) in [
        ("city", "m.csv", "8e-3", "no sources at degree 12, order 12 leave 0.33 %", "-t pbr"),
        ("city", "m.csv", "2e-2", "no sources at degree 9, order 7 leave 1.36 %", ""),
        ("studio", "m.csv", "40dB", "1 source at degree 9, order 7 leaves 0.58 %", "--sources 1"),
        // A matte material has no sources, and the tolerance holds all the same.
        ("studio", "matte.csv", "2e-3", "no sources at degree 12, order 12 leave", "-t pbr"),
    ] {
        let (said, pixels) = auto(light, material, tolerance);
        assert_contains(&said, &[report]);
        assert!(pixels == drawn(light, material, same).1, "{light}, {material}, {tolerance}");
    }
    // Without coefficients to order 12, there is no choice.
    let report = ["16 sources at degree 9, order 7 leave 0.89 %", "more than the 0.8 % asked for"];
    assert_contains(&auto("city", "low.csv", "8e-3").0, &report);
    let (said, _) = auto("studio", "matte.csv", "1e-6");
    assert_contains(&said, &["more than the 0.0001 % asked for"]);
    // Shipped materials in color have both orders.
    let (said, pixels) = drawn("city", "brass", "-t pbr --sources auto --tolerance 2e-2");
    assert!(said.contains("at degree 12, order 12 leave"), "{said}");
    let sources = said.split_once(" source").map(|(count, _)| count.rsplit(' ').next());
    let sources = sources.flatten().and_then(|count| count.parse::<usize>().ok()).unwrap();
    assert!(pixels == drawn("city", "brass", &format!("-t pbr --sources {sources}")).1);
    let both = "render -l city -m m.csv --sources 4 --tolerance 1e-2 -o a.png";
    assert_fails(&folder, both, &["--sources auto"]);
    let unknown = "render -l blender-city -m m.csv --sources auto -o a.png";
    assert_fails(&folder, unknown, &["errors of the light's sources are not known"]);
}
