//! Results that a number format does not hold are refused, and nothing is written.

use crate::support::{DEGREE, Folder, ORDER, assert_fails, lights, materials, numbers, rows};
use crate::tolerances;

const SHADE: &str =
    "shade b.bin --lights lights.csv --materials materials.csv --normals normals.csv";

/// The last channel of every row times 10 to a power.
fn times(text: &str, power: &str) -> String {
    let (header, rest) = text.split_once('\n').unwrap();
    let rows: String = rest.lines().map(|line| format!("{line}e{power}\n")).collect();
    format!("{header}\n{rows}")
}

fn with_light(power: &str) -> Folder {
    let folder = Folder::with_table();
    folder.write("lights.csv", times(&lights(DEGREE, 1), power));
    folder
}

#[test]
fn images_beyond_a_format_are_refused() {
    let folder = with_light("300");
    let words = ["light `light-0` on material `material-0`", "the range of", "towards 1", "e300"];
    for options in [
        "--format f32",
        "--format f32 --clamp",
        "--format f32 --method eigen",
        "--format f32 --method table",
        "--format f32 --method table --interpolation linear",
        "--format f32 --method baked",
        "--format f32 --method baked --interpolation nearest",
        "--format f32 --tolerance 1e-3",
        "--format q15",
        "--format q31",
    ] {
        let format = options.split(' ').nth(1).unwrap();
        let words = [&words[..], &[format]].concat();
        assert_fails(&folder, &format!("{SHADE} {options} --out new.csv"), &words);
    }
    let render = "render b.bin --light lights.csv --material materials.csv:material-0";
    assert_fails(&folder, &format!("{render} --out new.png"), &words);
    // f64 holds it.
    let found = folder.ok(&format!("{SHADE} --format f64"));
    let values = numbers(&rows(&found, "light,material,normal,r,g,b"), 1);
    assert!(values.iter().all(|value| value.is_finite()) && values.iter().any(|&v| v > 1e299));
}

#[test]
fn products_beyond_f64_are_refused() {
    let folder = with_light("300");
    folder.write("materials.csv", times(&materials(ORDER, 1), "10"));
    let words = ["light `light-0` on material `material-0`", "f64", "e300", "e10", "towards 1"];
    for options in ["--format f64", "--method modes", "--method modes --clamp"] {
        assert_fails(&folder, &format!("{SHADE} {options} --out new.csv"), &words);
    }
    let project = "project b.bin --lights lights.csv --materials materials.csv";
    assert_fails(&folder, &format!("{project} --out new.csv"), &words);
}

/// Coefficients of a light and of a material go to 2^127 times the largest mantissa.
#[test]
fn integers_are_right_up_to_the_size_at_which_they_saturate() {
    for (format, right, too_large, tolerance) in
        [("q15", "41", "43", tolerances::SHADED_Q15), ("q31", "46", "48", tolerances::SHADED_Q31)]
    {
        let folder = with_light(right);
        let shaded = |format: &str| {
            let text = folder.ok(&format!("{SHADE} --format {format}"));
            numbers(&rows(&text, "light,material,normal,r,g,b"), 1)
        };
        let (found, expected) = (shaded(format), shaded("f64"));
        let peak = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let squares = found.iter().zip(&expected).map(|(a, b)| ((a - b) / peak).powi(2));
        let rms = (squares.sum::<f64>() / found.len() as f64).sqrt();
        assert!(rms <= tolerance, "{format}: {rms:e}");
        folder.write("lights.csv", times(&lights(DEGREE, 1), too_large));
        let shade = format!("{SHADE} --format {format} --out new.csv");
        assert_fails(&folder, &shade, &["light-0", format, "towards 1"]);
        folder.write("lights.csv", lights(DEGREE, 1));
        folder.write("materials.csv", times(&materials(ORDER, 1), too_large));
        assert_fails(&folder, &shade, &["material-0", format, "towards 1"]);
    }
}

/// The mean image is as large as the images are.
#[test]
fn a_wire_file_beyond_f32_is_refused() {
    let folder = Folder::new();
    let standard = folder
        .read("scene.toml")
        .replace("image-centered", "standard")
        .replace("rotation = \"any\"", "rotation = \"any\"\nnormalize = \"none\"");
    folder.write("scene.toml", standard);
    folder.write("lights.csv", times(&lights(DEGREE, 3), "50"));
    folder.ok("basis --scene scene.toml --out b.bin");
    assert_fails(&folder, "pack b.bin --out new.esw", &["b.bin", "f32", "towards 1"]);
}
