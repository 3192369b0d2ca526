//! Small sources: finding them in a map, reading them from files, and pictures with them.

use crate::support::{Folder, assert_contains, assert_fails};
use eigenshade_cli::pixels::LinearImage;
use eigenshade_generator::material::brdf::{Brdf, Geometry, Ggx};
use eigenshade_model::inputs::gloss_csv::read_glosses;
use eigenshade_model::inputs::source_csv::read_sources;
use eigenshade_model::inputs::source_error_csv::read_source_errors;
use eigenshade_model::shipped;
use eigenshade_model::source::{Base, Gloss, SourceError};
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
    let [source] = light.first(1) else { panic!("{light:?}") };
    let [x, _, z] = source.direction;
    assert!((0.6 * x + 0.8 * z).acos() < PLACE, "{source:?}");
    // What is left of pictures is beside them: a source halves it.
    let errors = read_source_errors(folder.path("lamp.sources.errors.csv")).unwrap();
    let left = |most: usize| {
        let key = (most, (9, 7), Base::Metal);
        errors.iter().find(|one| (one.sources, one.size, one.base) == key).unwrap().errors[2]
    };
    assert!(left(1).mean < 0.5 * left(0).mean && left(1).white < 0.5 * left(0).white, "{errors:?}");
    folder.ok("material ggx --roughness 0.3 --f0 0.9,0.6,0.3 --out copper.csv");
    let peak = |options: &str| peak_of(&folder, &format!("-l lamp.csv -m {PAINT} {options}"));
    let (_, blurred) = peak("--sources 0");
    // The normal half-way to the lamp has x = 0.316.
    let (column, sharp) = peak("--sources 1");
    assert!(column.abs_diff(42) <= 2, "{column}");
    assert!(sharp > 1.3 * blurred, "{sharp} {blurred}");
    // A rotation turns the source with the light: by π about z to the other side.
    let (column, turned) = peak("--sources 1 --rotate 3.14159265,0,0");
    assert!(column.abs_diff(21) <= 2 && (turned / sharp - 1.0).abs() < 0.02, "{column} {turned}");
    // A material that is not shipped.
    let copper = |options: &str| peak_of(&folder, &format!("-l lamp.csv -m copper.csv {options}"));
    let [(_, blurred), (column, sharp)] = ["--sources 0", "--sources 1"].map(copper);
    assert!(column.abs_diff(42) <= 2 && sharp > 1.3 * blurred, "{column} {sharp} {blurred}");
    // As few as the tolerance allows: one at 0.3, none for a large tolerance.
    let said = |tolerance: f64| {
        let choice = format!("--sources auto --tolerance {tolerance} -s 16 -o a.png");
        folder.messages(&format!("render -l lamp.csv -m copper.csv {choice}"))
    };
    for (tolerance, report) in [
        (0.5 * (left(0).white + left(1).white), ", 1 source,"),
        (1.01 * left(0).white, ", no sources,"),
        (1e-9, "of white, 0.0000001 % asked for"),
    ] {
        assert_contains(&said(tolerance), &[report]);
    }
    assert_eq!(copper("--sources auto --tolerance 0.9"), copper("--sources 0"));
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
    let errors = shipped::source_errors().unwrap();
    let of = |most: usize| {
        let key = ("studio", most, (9, 7), Base::Metal);
        let is = |one: &&SourceError| (one.light.as_str(), one.sources, one.size, one.base) == key;
        let error = errors.iter().find(is).unwrap().errors[0];
        format!("{:.1} in the mean and {:.1} for 95 of 100 pixels", error.mean, error.p95)
    };
    for (sources, words) in [(0, "no sources"), (4, "4 sources")] {
        let note = said("studio", "smooth", &format!("--sources {sources}"));
        let start = format!(
            "note: `smooth` is sharper than degree 9, order 7 with {words} can show: a metal of its \
             roughness, 0.10, under `studio`"
        );
        assert!(note.starts_with(&start) && note.contains(&of(sources)), "{note}");
    }
    // Under a light without a map, what is known of other lights.
    let note = said("blender-city", "smooth", "");
    assert!(note.contains("under the median of 18 lights"), "{note}");
    assert_ne!(said("venice", "glossy", "--sources 0"), "");
    assert_eq!(said("venice", "glossy", ""), "");
    assert_eq!(said("studio", "matte", ""), "");
}

/// The fewest sources that are close, or within a tolerance, by the shipped errors.
#[test]
fn pictures_take_the_sources_that_they_need() {
    let folder = Folder::new();
    folder.ok("material ggx --roughness 0.5 --f0 0.9 --out metal.csv");
    folder.ok("material gltf --base-color 0.5,0.5,0.5 --metallic 0 --roughness 0.3 --out clay.csv");
    let drawn = |light: &str, material: &str, options: &str| {
        let drawn = format!("render -l {light} -m {material} -s 16 -o a.exr {options}");
        let said = folder.messages(&drawn);
        (said, LinearImage::read(folder.path("a.exr"), None).unwrap().pixels)
    };
    let errors = shipped::source_errors().unwrap();
    let mut counts = Vec::new();
    for light in ["studio", "city", "venice"] {
        for (material, base, place) in
            [("metal.csv", Base::Metal, 4), ("clay.csv", Base::Dielectric, 2)]
        {
            let of_light = errors.iter().filter(|one| {
                (one.light.as_str(), one.size, one.base) == (light, (9, 7), base)
                    && one.sources <= 8
            });
            let all: Vec<_> = of_light.map(|one| (one.sources, one.errors[place])).collect();
            let Some((count, _)) = all.iter().find(|(_, error)| error.is_close()) else {
                continue;
            };
            let (said, pixels) = drawn(light, material, "");
            let words = match count {
                0 => "no sources".to_owned(),
                1 => "1 source".to_owned(),
                _ => format!("{count} sources"),
            };
            assert_contains(&said, &[&format!(", {words},")]);
            assert!(!said.contains("sharper"), "{said}");
            assert!(pixels == drawn(light, material, &format!("--sources {count}")).1, "{said}");
            counts.push(*count);
            // A tolerance between two errors takes the second.
            assert_eq!(all[0].0, 0);
            let share = 0.5 * (all[0].1.white + all[1].1.white);
            let (said, _) = drawn(light, material, &format!("--tolerance {share}"));
            let within = all.iter().find(|(_, error)| error.white <= share);
            if let Some((count, _)) = within.filter(|(count, _)| *count > 1) {
                assert_contains(&said, &[&format!(", {count} sources,")]);
            }
        }
    }
    assert!(counts.len() >= 5 && counts.iter().any(|&count| count > 0), "{counts:?}");
    let both = "render -l city -m metal.csv --sources 4 --tolerance 1e-2 -o a.png";
    assert_fails(&folder, both, &["--sources auto"]);
    // A light without a map has no sources, and a file without gloss neither.
    for drawn in ["-l blender-city -m metal.csv", "-l city -m 07-velvet"] {
        let said = folder.messages(&format!("render {drawn} -s 16 -o a.png"));
        assert_contains(&said, &[", no sources,"]);
    }
}

/// A window is chosen where rings would be black, and can be left out.
#[test]
fn dark_rings_get_a_window() {
    let folder = Folder::new();
    folder.ok("material ggx --roughness 0.35 --f0 0.9,0.5,0.2 --out copper.csv");
    let drawn = |options: &str| {
        let drawn = format!("render -l studio -m copper.csv -s 64 -o a.exr {options}");
        let said = folder.messages(&drawn);
        let pixels = LinearImage::read(folder.path("a.exr"), None).unwrap().pixels;
        let least = pixels.iter().flatten().fold(f64::INFINITY, |least, &value| least.min(value));
        (said, least)
    };
    let (said, ringing) = drawn("--sources 0 --window none");
    assert_contains(&said, &["no window"]);
    let (said, mended) = drawn("--sources 0");
    assert_contains(&said, &["a window of width "]);
    assert!(ringing < 0.0 && mended > 0.5 * ringing, "{ringing} {mended}");
    let width = said.split_once("width ").unwrap().1;
    let width = width.split(|c: char| c != '.' && !c.is_ascii_digit()).next().unwrap();
    let (_, given) = drawn(&format!("--sources 0 --window {width}"));
    assert!((given - mended).abs() < 0.05 * ringing.abs(), "{given} {mended}");
    let shade = "shade -l studio -m copper.csv -n normals.csv --window auto";
    assert_fails(&folder, shade, &["--window auto is for a picture", "give a width"]);
}

/// A mesh that hides light from itself is drawn without shadows, and a line says so where sources
/// shine through it.
#[test]
fn shadows_that_are_left_out_are_named() {
    let folder = Folder::new();
    // The inside of half an octahedron, and its outside.
    let corners = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n";
    let sides = "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    folder.write("hollow.obj", format!("{corners}v 0 0 -1\n{sides}"));
    folder.write("convex.obj", format!("{corners}v 0 0 1\n{sides}"));
    let said = |object: &str, options: &str| {
        let inputs = format!("--object {object}.obj --light studio --material chrome {options}");
        folder.messages(&format!("render {inputs} --size 32 --out a.png"))
    };
    let hollow = said("hollow", "--sources 2 --flat");
    assert_contains(&hollow, &["warning: shadows are left out: the object hides", "`--shadows`"]);
    let hidden = hollow.split_once("hides ").unwrap().1.split_once(" %").unwrap().0;
    let hidden: f64 = hidden.parse().unwrap();
    // Of the light through its mouth, of area 2, the sides, of area 2 √3, receive 2 / (2 √3) each.
    let expected = 100.0 * (1.0 - 1.0 / 3.0_f64.sqrt());
    println!("{hidden} % {expected:.1} %");
    assert!((hidden - expected).abs() < 2.0);
    for (object, options) in [
        ("hollow", "--sources 0 --flat"),
        ("hollow", "--shadows"),
        ("convex", "--sources 2 --flat"),
        ("convex", "--sources 2"),
    ] {
        let said = said(object, options);
        assert!(!said.contains("shadows are left out"), "{object} {options}: {said}");
    }
}
