//! The ways to a pixel against the direct sum over modes, and what is done to a light
//! before and to irradiance after.

use crate::support::{DEGREE, Folder, assert_fails, lights, numbers, rows};
use crate::tolerances;
use eigenshade_index::light;
use std::f64::consts::TAU;

/// Ways of `shade` to a pixel, all components of a scene of degree 4 and order 3 against the direct sum, rms of
/// the largest irradiance of all: what each leaves of so smooth images; cubics come down to the rounding of f32.
const WAYS: [(&str, f64); 7] = [
    ("--method table --knots 32 --interpolation linear", 1.5e-5),
    ("--method table --knots 128 --interpolation linear", 8e-7),
    ("--method table --knots 128 --interpolation cubic", 1e-7),
    ("--method baked --size 32 --interpolation linear", 1.2e-4),
    ("--method baked --size 64 --interpolation linear", 2.5e-5),
    ("--method baked --size 128 --interpolation linear", 7e-6),
    ("--method baked --size 64 --interpolation nearest", 3e-3),
];

/// An image's error at 600 normals over the bound that `shade --tolerance` prints: both errors and
/// peaks of so few normals are off by a few hundredths.
const PRINTED_BOUND: f64 = 1.05;

/// Largest error of the channels of twelve images that `shade --tolerance` made, of the tolerance,
/// at 600 normals for both the error and the peak: 0.9 to 1.
const SHADED_WITHIN: [f64; 2] = [0.8, 1.02];

const PAIR: &str = "--lights lights.csv --materials materials.csv --normals normals.csv";
const HEADER: &str = "light,material,normal,r,g,b";

fn shaded(folder: &Folder, options: &str) -> Vec<f64> {
    numbers(&rows(&folder.ok(&format!("shade b.bin {PAIR} {options}")), HEADER), 3)
}

/// Rms of a - b, of the largest |b|.
fn rms(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let peak = b.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (square / a.len() as f64).sqrt() / peak
}

/// All components are the truth, so all that is left is the way's error.
#[test]
fn ways_are_as_exact_as_they_can_be() {
    let folder = Folder::with_table();
    let truth = shaded(&folder, "--method modes");
    for (options, most) in WAYS {
        for format in ["f32", "f64"] {
            let found = rms(&shaded(&folder, &format!("{options} --format {format}")), &truth);
            println!("{options}, {format}: {found:e}");
            assert!(found <= most, "{options}, {format}: {found:e}");
            // Another way than the polynomials, or nothing is tested.
            assert!(found >= 0.25 * most, "{options}: {found:e} is too good");
        }
    }
    // What is left out is the scene's, or the default.
    let scene = folder.read("scene.toml").replace("[basis]", "[basis]\nknots = 32");
    folder.write("knots.toml", scene);
    folder.ok("basis --scene knots.toml --out knots.bin");
    let of_scene = folder.ok(&format!("shade knots.bin {PAIR} --method table"));
    assert_eq!(of_scene, folder.ok(&format!("shade b.bin {PAIR} --method table --knots 32")));
    for (short, long) in [
        ("--method table", "--method table --knots 256 --interpolation cubic"),
        ("--method baked", "--method baked --size 64 --interpolation linear"),
    ] {
        assert_eq!(shaded(&folder, short), shaded(&folder, long));
    }
}

/// Over a sphere each channel is within the tolerance of the brightest one's peak, and all have
/// one shape.
#[test]
fn a_tolerance_is_of_the_brightest_channel() {
    let folder = Folder::with_table();
    let text = lights(DEGREE, 3).lines().skip(1).map(dimmed).collect::<String>();
    folder.write("lights.csv", format!("name,l,m,r,g,b\n{text}"));
    folder.write("normals.csv", "x,y,z\n".to_owned() + &(0..600).map(normal).collect::<String>());
    let whole = shaded(&folder, "--format f64");
    let images = 3 * 4;
    for (option, share) in [("3e-2", 3e-2), ("40dB", 1e-2), ("1e-3", 1e-3)] {
        let within = shaded(&folder, &format!("--format f64 --tolerance {option}"));
        let mut most: f64 = 0.0;
        for k in 0..images {
            let of = |all: &[f64]| all[1800 * k..1800 * (k + 1)].to_vec();
            let (whole, within) = (of(&whole), of(&within));
            let peak = whole.iter().fold(0.0, |most: f64, value| most.max(*value));
            for channel in 0..3 {
                let pairs = whole.iter().zip(&within).skip(channel).step_by(3);
                let square: f64 = pairs.map(|(a, b)| (a - b).powi(2)).sum();
                most = most.max((square / 600.0).sqrt() / (share * peak));
            }
        }
        println!("{option}: {most}");
        let [least, allowed] = SHADED_WITHIN;
        assert!(most <= allowed && most >= least, "{option}: {most}");
    }
    // The dim channel asks for nothing: without it the shape is the same.
    folder.write("materials.csv", "name,o,p,q,value\nmatte,0,0,0,2\n");
    let kept = |of: &dyn Fn(&str) -> String| {
        let rows = text.lines().take(light::count(DEGREE)).map(of).collect::<String>();
        folder.write("lights.csv", format!("name,l,m,r,g,b\n{rows}"));
        let output = folder.run(&format!("shade b.bin {PAIR} --tolerance 1e-2"));
        let told = String::from_utf8(output.stderr).expect("text");
        told.lines().find(|line| line.starts_with("kept: ")).expect("what was kept").to_owned()
    };
    let all = kept(&|row| format!("{row}\n"));
    assert!(!all.contains(" to "), "{all}");
    assert_eq!(all, kept(&|row| format!("{},0\n", row.rsplit_once(',').expect("fields").0)));
    // By itself it would be off by no more than its own, smaller peak allows.
    let alone = kept(&|row| {
        let (rest, blue) = row.rsplit_once(',').expect("fields");
        let names = rest.splitn(4, ',').take(3).collect::<Vec<_>>().join(",");
        format!("{names},0,0,{blue}\n")
    });
    assert_ne!(all, alone);
}

/// In f32 too, where rounding is most of it.
#[test]
fn a_printed_bound_holds() {
    let folder = Folder::with_table();
    folder.write("normals.csv", "x,y,z\n".to_owned() + &(0..600).map(normal).collect::<String>());
    let whole = shaded(&folder, "--format f64");
    for option in ["1e-2", "1e-4", "1e-6", "1e-7"] {
        let options = format!("--format f32 --tolerance {option}");
        let within = shaded(&folder, &options);
        let output = folder.run(&format!("shade b.bin {PAIR} {options}"));
        let told = String::from_utf8(output.stderr).expect("text");
        let (_, rest) = told.split_once("at most ").expect("a bound");
        let bound: f64 = rest.split(' ').next().and_then(|one| one.parse().ok()).expect("a number");
        for (whole, within) in whole.chunks(1800).zip(within.chunks(1800)) {
            let peak = whole.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            for channel in 0..3 {
                let pairs = whole.iter().zip(within).skip(channel).step_by(3);
                let square: f64 = pairs.map(|(a, b)| (a - b).powi(2)).sum();
                let found = (square / 600.0).sqrt() / peak;
                let allowed = PRINTED_BOUND * bound;
                assert!(found <= allowed, "{option}: {found:e} of {bound:e}");
            }
        }
    }
}

/// Of 600 equal shares of the disc.
fn normal(k: u32) -> String {
    let square = (f64::from(k) + 0.5) / 600.0;
    let (y, x) = (TAU * 0.618_034 * f64::from(k)).sin_cos();
    let radius = square.sqrt();
    format!("{},{},{}\n", radius * x, radius * y, (1.0 - square).sqrt())
}

/// A row of a light whose blue is dim.
fn dimmed(row: &str) -> String {
    let (rest, blue) = row.rsplit_once(',').expect("fields");
    format!("{rest},{}\n", 1e-2 * blue.parse::<f64>().expect("a number"))
}

/// Integers shade as the direct sum does, and by polynomials alone.
#[test]
fn integers_are_a_format() {
    let folder = Folder::with_table();
    let truth = shaded(&folder, "--method modes");
    for (format, most) in [("q31", tolerances::SHADED_Q31), ("q15", tolerances::SHADED_Q15)] {
        let found = rms(&shaded(&folder, &format!("--format {format}")), &truth);
        println!("{format}: {found:e}");
        assert!(found <= most, "{format}: {found:e}");
        let shade = format!("shade b.bin {PAIR} --format {format} --out new.csv --method");
        for method in ["eigen", "table", "baked"] {
            assert_fails(&folder, &format!("{shade} {method}"), &["polynomial"]);
        }
        assert_fails(&folder, &format!("{shade} modes"), &["f64"]);
    }
}

/// A light through a window is that light with its coefficients weakened.
#[test]
fn windows_weaken_the_light() {
    let folder = Folder::with_table();
    let windowed = shaded(&folder, "--method modes --window 5.5");
    let text = folder.read("lights.csv");
    let weakened = text.lines().enumerate().map(|(line, text)| {
        if line == 0 {
            return format!("{text}\n");
        }
        let fields: Vec<&str> = text.split(',').collect();
        let x = std::f64::consts::PI * fields[1].parse::<f64>().expect("a degree") / 5.5;
        let factor = if x == 0.0 { 1.0 } else { (x.sin() / x).powi(4) };
        let values = fields[3..]
            .iter()
            .map(|value| format!(",{:?}", factor * value.parse::<f64>().expect("a number")));
        format!("{},{},{}{}\n", fields[0], fields[1], fields[2], values.collect::<String>())
    });
    let weakened: String = weakened.collect();
    folder.write("lights.csv", weakened);
    let expected = shaded(&folder, "--method modes");
    assert!(rms(&windowed, &expected) <= tolerances::DENSE_PROJECTION);
}

/// Clamped to zero, and the least is told.
#[test]
fn irradiance_below_zero_is_clamped_where_asked() {
    let folder = Folder::with_table();
    // Much more light from behind than from everywhere.
    folder.write("lights.csv", "name,l,m,value\na,0,0,1\na,1,-1,0\na,1,0,-3\na,1,1,0\n");
    let kept = shaded(&folder, "");
    let least = kept.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(least < 0.0, "nothing to clamp");
    for method in ["polynomial", "modes"] {
        let kept = shaded(&folder, &format!("--method {method}"));
        let clamped = shaded(&folder, &format!("--method {method} --clamp"));
        assert!(kept.iter().zip(&clamped).all(|(kept, clamped)| *clamped == kept.max(0.0)));
        assert!(kept.iter().any(|kept| *kept < 0.0), "{method}");
    }
    let output = folder.run(&format!("shade b.bin {PAIR} --clamp"));
    let told = String::from_utf8(output.stderr).expect("text");
    let lines: Vec<&str> = told.lines().collect();
    assert_eq!(lines[0], format!("least irradiance {least:?}, clamped"));
    assert!(lines.len() == 2 && lines[1].starts_with("note: 4 of 4 images"), "{told}");
}

#[test]
fn tolerances_are_refused_where_there_is_none() {
    let folder = Folder::with_table();
    for (name, from, to) in
        [("object", "\"sphere\"", "\"normals.csv\""), ("mean", "image-centered", "standard")]
    {
        let other = folder.read("scene.toml").replace(from, to);
        folder.write(&format!("{name}.toml"), other);
        folder.ok(&format!("basis --scene {name}.toml --out {name}.bin"));
    }
    for (options, words) in [
        ("mean.bin --tolerance 1e-2 --effects diffuse", ["ambient", "leave --tolerance out"]),
        ("object.bin --tolerance 1e-2", ["sphere", "leave --tolerance out"]),
        ("b.bin --tolerance 1e-2 --format q15", ["--tolerance", "polynomial in f32 or f64"]),
        ("b.bin --tolerance 1e-2 --method eigen", ["--tolerance", "polynomial in f32 or f64"]),
    ] {
        assert_fails(&folder, &format!("shade {PAIR} {options}"), &words);
    }
}

#[test]
fn options_of_other_methods_are_errors() {
    let folder = Folder::with_table();
    for (options, words) in [
        ("--knots 64", ["--knots", "--method table"]),
        ("--method baked --knots 64", ["--knots", "--method table"]),
        ("--method table --size 64", ["--size", "--method baked"]),
        ("--interpolation linear", ["--interpolation", "--method table"]),
        ("--method table --interpolation nearest", ["nearest", "linear or cubic"]),
        ("--method baked --interpolation cubic", ["cubic", "nearest or linear"]),
    ] {
        assert_fails(&folder, &format!("shade b.bin {PAIR} {options}"), &words);
    }
}
