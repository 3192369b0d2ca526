//! Small sources: finding them in a map, reading them from files, and pictures with them.

use crate::support::{Folder, assert_fails, repository};
use eigenshade_cli::reading::pixels::LinearImage;
use eigenshade_generator::material::brdf::{Brdf, Geometry, Ggx};
use eigenshade_model::inputs::gloss_csv::read_glosses;
use eigenshade_model::inputs::set_error_csv::read_set_errors;
use eigenshade_model::inputs::source_csv::read_sources;
use eigenshade_model::source::{Gloss, SetError};
use eigenshade_shading::shipped;
use eigenshade_testing::fixtures;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

/// A map of one lamp of 0.1 rad, half-way between the camera and the right, on a dim sky, as PFM.
fn lamp() -> Vec<u8> {
    // No multiples of the blocks of texels that sources are found with.
    let (width, height) = (66_usize, 33_usize);
    let mut texels = Vec::new();
    for row in 0..height {
        for column in 0..width {
            let polar = std::f64::consts::PI * (row as f64 + 0.5) / height as f64;
            let turn = std::f64::consts::TAU * ((column as f64 + 0.5) / width as f64 - 0.5);
            let [x, z] = [turn.sin() * polar.sin(), -turn.cos() * polar.sin()];
            texels.push([if 0.6 * x + 0.8 * z > 0.1_f64.cos() { 20.0 } else { 0.1 }; 3]);
        }
    }
    fixtures::pfm(width, &texels)
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
    let said = |tolerance: &str| {
        let choice = format!("--sources auto --tolerance {tolerance} -s 16 -o a.png");
        folder.messages(&format!("render -l lamp.csv -m copper.csv {choice}"))
    };
    let tolerance = 0.5 * (rms(0) + rms(1));
    assert!(
        said(&tolerance.to_string()).contains("1 source at degree 9, order 7 leaves"),
        "{}",
        said("0.01")
    );
    assert!(said(&(1.01 * rms(0)).to_string()).contains("no sources at degree 9, order 7 leave"));
    assert!(said("1e-9").contains("more than the 0.0000001 % asked for"));
    assert_eq!(copper("--sources auto --tolerance 0.9"), copper(""));
}

/// A shipped material whose lobe is wide enough for a small map.
const PAINT: &str = "color-changing-paint2";

/// The column and the green irradiance of the brightest pixel of a sphere 64 pixels wide.
fn peak_of(folder: &Folder, options: &str) -> (usize, f64) {
    folder.ok(&format!("render --size 64 --out a.exr {options}"));
    let image = LinearImage::read(folder.path("a.exr"), None).unwrap();
    let mut best = (0, 0.0);
    for (k, pixel) in image.pixels.iter().enumerate() {
        if pixel[1] > best.1 {
            best = (k, pixel[1]);
        }
    }
    (best.0 % 64, best.1)
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
    let mut text = "theta_i,phi_i,theta_r,phi_r,r,g,b\n".to_owned();
    let colors = exact.reflectance.map(|f0| Ggx::new(0.25, f0, 0.1).unwrap());
    for (i, r, around) in (0..12)
        .flat_map(|i| (0..12).map(move |r| (i, r)))
        .flat_map(|(i, r)| (0..13).map(move |around| (i, r, around)))
    {
        let [i, r] = [i, r].map(|k| FRAC_PI_2 * f64::from(k) / 12.0);
        let phi = PI * f64::from(around) / 12.0;
        let at = Geometry::from_angles(i, r, phi);
        let [red, green, blue] = [0, 1, 2].map(|c: usize| colors[c].value(at));
        writeln!(text, "{i},{phi},{r},0,{red},{green},{blue}").unwrap();
    }
    folder.write("copper.csv", text);
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
        let notes = text.lines().filter(|line| line.contains("sharper")).map(str::to_owned);
        let notes: Vec<String> = notes.collect();
        assert!(notes.len() <= 1, "{text}");
        notes.into_iter().next().unwrap_or_default()
    };
    let errors = shipped::set_errors().unwrap();
    let of = |most: usize, place: usize| {
        let is =
            |one: &&SetError| (one.light.as_str(), one.most, one.size) == ("studio", most, (9, 7));
        let error = errors.iter().find(is).unwrap().errors[place];
        [
            format!("by {:.1} % of their peak", 100.0 * error.rms),
            format!("by up to {:.0} %, in the worse of two views", 100.0 * error.worst),
        ]
    };
    let note = said("studio", "smooth", "");
    let start = "note: `smooth` is sharper than order 7 can show: at degree 9,";
    assert!(note.starts_with(start), "{note}");
    let [rms, worst] = of(0, 0);
    assert!(note.contains(&rms) && note.contains(&worst) && note.contains("`studio`"), "{note}");
    assert!(note.ends_with("`--sources 4` draws small bright sources sharply"), "{note}");
    let note = said("studio", "smooth", "--sources 4");
    assert!(note.contains("than order 7 and 4 sources can show"), "{note}");
    let [rms, worst] = of(4, 0);
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
    assert!(said("-l studio -m pink-felt --sources 4").contains("as matte as a roughness"));
    assert!(said("-l studio -m two-layer-gold --sources 4").contains("not quite a GGX lobe"));
    assert_eq!(said("-l studio -m gold-metallic-paint --sources 4"), "");
    // No lobe of its own, whose roughness would mean something.
    folder.ok("material oren-nayar --sigma 0.5 --albedo 0.2,0.4,0.8 --out rough.csv");
    assert_eq!(said("-l studio -m rough.csv"), "");
    assert!(said("-l studio -m rough.csv --sources 4").contains("as matte as a roughness of 1.00"));
    assert!(
        said("-l studio -m chrome --sources 3").contains("2 sources, the largest set of at most 3")
    );
    assert!(
        said("-l city -m chrome --sources 1").contains("0 sources, the largest set of at most 1")
    );
    let no_map = "render -l blender-city -m nylon --sources 4 -o a.png";
    assert_fails(&folder, no_map, &["blender-city", "has no map"]);
    let no_gloss = "render -l studio -m 07-velvet --sources 4 -o a.png";
    assert_fails(&folder, no_gloss, &["07-velvet", "gloss"]);
    let no_gloss = "render -l studio -m materials.csv:material-0 --sources 4 -o a.png";
    assert_fails(&folder, no_gloss, &["material-0", "eigenshade material .. --out FILE.csv"]);
    let no_file = "render -l lights.csv:light-0 -m nylon --sources 4 -o a.png";
    assert_fails(&folder, no_file, &["lights.sources.csv", "light MAP --sources"]);
    let sources = repository().join("tables/inputs/lights.csv");
    let csv = format!("light {} --sources 4 --out b.csv", sources.display());
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
    let (said, pixels) = auto("city", "m.csv", "8e-3");
    assert!(said.contains("no sources at degree 12, order 12 leave 0.33 %"), "{said}");
    assert!(pixels == drawn("city", "m.csv", "-t pbr").1);
    let (said, pixels) = auto("city", "m.csv", "2e-2");
    assert!(said.contains("no sources at degree 9, order 7 leave 1.36 %"), "{said}");
    assert!(pixels == drawn("city", "m.csv", "").1);
    // Without coefficients to order 12, there is no choice.
    let (said, _) = auto("city", "low.csv", "8e-3");
    assert!(said.contains("16 sources at degree 9, order 7 leave 0.89 %"), "{said}");
    assert!(said.contains("more than the 0.8 % asked for"), "{said}");
    let (said, pixels) = auto("studio", "m.csv", "40dB");
    assert!(said.contains("1 source at degree 9, order 7 leaves 0.58 %"), "{said}");
    assert!(pixels == drawn("studio", "m.csv", "--sources 1").1);
    // A matte material has no sources, and the tolerance holds all the same.
    folder.ok("material ggx --roughness 0.65 --f0 0.9 --order 12 --out matte.csv");
    let (said, pixels) = auto("studio", "matte.csv", "2e-3");
    assert!(said.contains("no sources at degree 12, order 12 leave"), "{said}");
    assert!(pixels == drawn("studio", "matte.csv", "-t pbr").1);
    let (said, _) = auto("studio", "matte.csv", "1e-6");
    assert!(said.contains("more than the 0.0001 % asked for"), "{said}");
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
