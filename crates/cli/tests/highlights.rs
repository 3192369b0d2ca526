//! Small sources: finding them in a map, reading them from files, and pictures with them.

use crate::support::{Folder, assert_fails, repository};
use eigenshade_cli::reading::pixels::LinearImage;
use eigenshade_model::inputs::source_csv::read_sources;

/// A map of one lamp of 0.1 rad, half-way between the camera and the right, on a dim sky, as PFM.
fn lamp() -> Vec<u8> {
    let (width, height) = (64_usize, 32_usize);
    let mut bytes = format!("PF\n{width} {height}\n-1.0\n").into_bytes();
    // Rows from the bottom up.
    for row in (0..height).rev() {
        for column in 0..width {
            let polar = std::f64::consts::PI * (row as f64 + 0.5) / height as f64;
            let turn = std::f64::consts::TAU * ((column as f64 + 0.5) / width as f64 - 0.5);
            let [x, z] = [turn.sin() * polar.sin(), -turn.cos() * polar.sin()];
            let radiance: f32 = if 0.6 * x + 0.8 * z > 0.1_f64.cos() { 20.0 } else { 0.1 };
            for _ in 0..3 {
                bytes.extend(radiance.to_le_bytes());
            }
        }
    }
    bytes
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
    let peak = |options: &str| {
        folder.ok(&format!(
            "render -l lamp.csv -m color-changing-paint2 --size 64 --out a.exr {options}"
        ));
        let image = LinearImage::read(folder.path("a.exr"), None).unwrap();
        let mut best = (0, 0.0);
        for (k, pixel) in image.pixels.iter().enumerate() {
            if pixel[1] > best.1 {
                best = (k, pixel[1]);
            }
        }
        (best.0 % 64, best.1)
    };
    let (_, blurred) = peak("");
    // The normal half-way to the lamp has x = 0.316.
    let (column, sharp) = peak("--sources 1");
    assert!(column.abs_diff(42) <= 2, "{column}");
    assert!(sharp > 1.3 * blurred, "{sharp} {blurred}");
    // A rotation turns the source with the light: by π about z to the other side.
    let (column, turned) = peak("--sources 1 --rotate 3.14159265,0,0");
    assert!(column.abs_diff(21) <= 2 && (turned / sharp - 1.0).abs() < 0.02, "{column} {turned}");
}

#[test]
fn pictures_say_what_they_lack() {
    let folder = Folder::new();
    let said = |arguments: &str| folder.messages(&format!("render {arguments} -s 16 -o a.png"));
    assert!(said("-l studio -m pink-felt --sources 4").contains("as matte as a roughness"));
    assert!(said("-l studio -m chrome --sources 4").contains("not quite a GGX lobe"));
    assert!(!said("-l studio -m gold-metallic-paint --sources 4").contains("gloss"));
    let no_map = "render -l blender-city -m nylon --sources 4 -o a.png";
    assert_fails(&folder, no_map, &["sources.csv", "blender-city", "light MAP --sources"]);
    let no_gloss = "render -l studio -m 07-velvet --sources 4 -o a.png";
    assert_fails(&folder, no_gloss, &["07-velvet", "gloss"]);
    let no_file = "render -l lights.csv:light-0 -m nylon --sources 4 -o a.png";
    assert_fails(&folder, no_file, &["lights.sources.csv", "light MAP --sources"]);
    let sources = repository().join("tables/inputs/lights.csv");
    let csv = format!("light {} --sources 4 --out b.csv", sources.display());
    assert_fails(&folder, &csv, &["--sources needs a map"]);
}
