//! The methods of `shade` against the direct sum, and its options: tolerances, windows, clamping.

use crate::support::{DEGREE, Folder, PAIR, SHADE, assert_fails, lights};
use crate::tolerances;
use eigenshade_table::light;
use eigenshade_testing::largest;
use std::f64::consts::{PI, TAU};

/// Methods of `shade`, all components of a scene of degree 4 and order 3 against the direct sum:
/// the rms error relative to the largest irradiance. It is the interpolation error of such smooth
/// images.
const METHODS: [(&str, f64); 3] = [
    ("--method baked --size 32", 1.2e-4),
    ("--method baked --size 64", 2.5e-5),
    ("--method baked --size 128", 7e-6),
];

/// An image's error at 600 normals over the bound that `shade --tolerance` prints: with so few
/// normals, errors are accurate to a few hundredths, and white is metered to within 7 %.
const PRINTED_BOUND: f64 = 1.12;

/// The largest error of twelve images by `shade --tolerance`, as a share of the tolerance, with error
/// and white at 600 normals. The program meters white at others, in steps of 9 %.
const SHADED_WITHIN: [f64; 2] = [0.7, 1.1];

/// The rms of a - b, relative to the largest |b|.
fn rms(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (square / a.len() as f64).sqrt() / largest(b.iter().copied())
}

/// White of an image of 600 normals, as the meter states it: the brightest hundredth is beyond, or up
/// to a tenth if the median would be darker than 0.12.
fn white(image: &[f64]) -> f64 {
    let mut brightness: Vec<f64> =
        image.chunks(3).map(|rgb| largest(rgb.iter().copied())).collect();
    brightness.sort_by(f64::total_cmp);
    let at = |share: f64| brightness[((brightness.len() - 1) as f64 * share) as usize];
    at(0.99).min((at(0.5) / 0.12).max(at(0.9)))
}

/// The largest rms error of a channel of an image of 600 normals, relative to white.
fn worst_channel(images: &[f64], exact: &[f64]) -> f64 {
    let of_image = |(image, exact): (&[f64], &[f64])| {
        let of_channel = |channel: usize| {
            let pairs = image.iter().zip(exact).skip(channel).step_by(3);
            pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>()
        };
        let square = largest([0, 1, 2].map(of_channel));
        (square / 600.0).sqrt() / white(exact)
    };
    largest(images.chunks(1800).zip(exact.chunks(1800)).map(of_image))
}

/// With all components, only the error of the method is left.
#[test]
fn methods_are_as_exact_as_they_can_be() {
    let folder = Folder::with_table();
    let reference = folder.shaded("--method modes");
    for (options, most) in METHODS {
        let found = rms(&folder.shaded(options), &reference);
        println!("{options}: {found:e}");
        assert!(found <= most, "{options}: {found:e}");
        // Otherwise this is not the method, but the polynomials.
        assert!(found >= 0.25 * most, "{options}: {found:e} is too good");
    }
    let defaults = folder.shaded("--method baked");
    assert_eq!(defaults, folder.shaded("--method baked --size 64"));
}

/// Over a sphere the error of each channel is within the share of white, and all channels have the
/// same numbers of terms.
#[test]
fn a_tolerance_is_a_share_of_white() {
    let folder = Folder::with_table();
    let text = lights(DEGREE, 3).lines().skip(1).map(dimmed).collect::<String>();
    folder.write("lights.csv", format!("name,l,m,r,g,b\n{text}"));
    folder.write("normals.csv", disc());
    let whole = folder.shaded("--format f64");
    for (option, share) in [("3e-2", 3e-2), ("1e-2", 1e-2), ("1e-3", 1e-3)] {
        let within = folder.shaded(&format!("--tolerance {option}"));
        let most = worst_channel(&within, &whole) / share;
        println!("{option}: {most}");
        let [least, allowed] = SHADED_WITHIN;
        assert!(most <= allowed && most >= least, "{option}: {most}");
    }
    // The dim channel needs nothing: without it the numbers of terms are the same.
    folder.write("materials.csv", "name,o,p,q,value\nmatte,0,0,0,2\n");
    let kept = |of: &dyn Fn(&str) -> String| {
        let rows = text.lines().take(light::count(DEGREE)).map(of).collect::<String>();
        folder.write("lights.csv", format!("name,l,m,r,g,b\n{rows}"));
        let report = folder.messages(&format!("{SHADE} --tolerance 1e-2"));
        report.lines().find(|line| line.starts_with("kept: ")).expect("what was kept").to_owned()
    };
    let all = kept(&|row| format!("{row}\n"));
    assert!(!all.contains(" to "), "{all}");
    assert_eq!(all, kept(&|row| format!("{},0\n", row.rsplit_once(',').expect("fields").0)));
    // By itself its error would be relative to its own, smaller peak.
    let alone = kept(&|row| {
        let (rest, blue) = row.rsplit_once(',').expect("fields");
        let names = rest.splitn(4, ',').take(3).collect::<Vec<_>>().join(",");
        format!("{names},0,0,{blue}\n")
    });
    assert_ne!(all, alone);
}

/// Also in f32, where rounding is the largest part of the error.
#[test]
fn a_printed_bound_holds() {
    let folder = Folder::with_table();
    folder.write("normals.csv", disc());
    let whole = folder.shaded("--format f64");
    for option in ["1e-2", "1e-4", "1e-6", "1e-7"] {
        let options = format!("--format f32 --tolerance {option}");
        let found = worst_channel(&folder.shaded(&options), &whole);
        let report = folder.messages(&format!("{SHADE} {options}"));
        let (_, rest) = report.split_once("at most ").expect("a bound");
        let bound: f64 = rest.split(' ').next().and_then(|one| one.parse().ok()).expect("a number");
        assert!(found <= PRINTED_BOUND * bound, "{option}: {found:e} of {bound:e}");
    }
}

/// 600 normals with equal shares of the disc.
fn disc() -> String {
    let normal = |k: u32| {
        let square = (f64::from(k) + 0.5) / 600.0;
        let (y, x) = (TAU * 0.618_034 * f64::from(k)).sin_cos();
        let radius = square.sqrt();
        format!("{},{},{}\n", radius * x, radius * y, (1.0 - square).sqrt())
    };
    "x,y,z\n".to_owned() + &(0..600).map(normal).collect::<String>()
}

/// A row of a light whose blue is dim.
fn dimmed(row: &str) -> String {
    let (rest, blue) = row.rsplit_once(',').expect("fields");
    format!("{rest},{}\n", 1e-2 * blue.parse::<f64>().expect("a number"))
}

/// Integer formats agree with the direct sum, and support only polynomials.
#[test]
fn integers_agree_with_the_direct_sum() {
    let folder = Folder::with_table();
    let reference = folder.shaded("--method modes");
    for (format, most) in [("q15", tolerances::SHADED_Q15)] {
        let found = rms(&folder.shaded(&format!("--format {format}")), &reference);
        println!("{format}: {found:e}");
        assert!(found <= most, "{format}: {found:e}");
        let shade = format!("{SHADE} --format {format} --out new.csv --method");
        for method in ["eigen", "baked"] {
            assert_fails(&folder, &format!("{shade} {method}"), &["polynomial"]);
        }
        assert_fails(&folder, &format!("{shade} modes"), &["f64"]);
    }
}

/// A window multiplies the coefficients of the light.
#[test]
fn windows_weaken_the_light() {
    let folder = Folder::with_table();
    let windowed = folder.shaded("--method modes --window 5.5");
    let text = folder.read("lights.csv");
    let weakened = |row: &str| {
        let fields: Vec<&str> = row.split(',').collect();
        let number = |field: &str| field.parse::<f64>().expect("a number");
        let x = PI * number(fields[1]) / 5.5;
        let factor = if x == 0.0 { 1.0 } else { (x.sin() / x).powi(4) };
        let [r, g, b] = [3, 4, 5].map(|field| factor * number(fields[field]));
        format!("{},{r:?},{g:?},{b:?}\n", fields[..3].join(","))
    };
    let rows: String = text.lines().skip(1).map(weakened).collect();
    folder.write("lights.csv", format!("name,l,m,r,g,b\n{rows}"));
    let expected = folder.shaded("--method modes");
    assert!(rms(&windowed, &expected) <= tolerances::DENSE_PROJECTION);
}

/// Irradiance below zero is clamped to zero, and the least value is reported.
#[test]
fn irradiance_below_zero_is_clamped_on_request() {
    let folder = Folder::with_table();
    // Much more light from behind than from everywhere.
    folder.write("lights.csv", "name,l,m,value\na,0,0,1\na,1,-1,0\na,1,0,-3\na,1,1,0\n");
    let kept = folder.shaded("");
    let least = kept.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(least < 0.0, "nothing to clamp");
    for method in ["polynomial", "modes"] {
        let kept = folder.shaded(&format!("--method {method}"));
        let clamped = folder.shaded(&format!("--method {method} --clamp"));
        assert!(kept.iter().zip(&clamped).all(|(kept, clamped)| *clamped == kept.max(0.0)));
        assert!(kept.iter().any(|kept| *kept < 0.0), "{method}");
    }
    let report = folder.messages(&format!("{SHADE} --clamp"));
    let lines: Vec<&str> = report.lines().collect();
    assert_eq!(lines[0], format!("least irradiance {least:?}, clamped"));
    assert!(lines.len() == 2 && lines[1].starts_with("note: 4 of 4 images"), "{report}");
}

#[test]
fn tolerances_and_sizes_are_refused_where_they_cannot_hold() {
    let folder = Folder::with_table();
    for (options, fragments) in [
        ("--table b.bin --tolerance 1e-2 --format q15", ["--tolerance", "polynomial in f32"]),
        ("--table b.bin --tolerance 1e-2 --method eigen", ["--tolerance", "polynomial in f32"]),
        ("--table b.bin --tolerance 1e-2 --format f64", ["--tolerance", "polynomial in f32"]),
        ("--table b.bin --method baked --format f64", ["baked", "only f32"]),
        ("--table b.bin --method eigen --size 64", ["--size", "--method baked"]),
        ("--table b.bin --size 32", ["--size", "--method baked"]),
    ] {
        assert_fails(&folder, &format!("shade {PAIR} --normals normals.csv {options}"), &fragments);
    }
}

/// What `render` draws, unless there is a file of normals of that name.
#[test]
fn objects_are_no_normals() {
    let folder = Folder::with_table();
    for (name, kind) in [
        ("sphere", "a sphere"),
        ("map.png", "a normal map"),
        ("mesh.obj", "a mesh"),
        ("mesh.STL", "a mesh"),
    ] {
        let what = format!("{name}: it is {kind}");
        let fragments = [what.as_str(), "a normals CSV, `x,y,z`", "`render`"];
        assert_fails(&folder, &SHADE.replace("normals.csv", name), &fragments);
    }
    folder.write("sphere", folder.read("normals.csv"));
    assert_eq!(folder.ok(&SHADE.replace("normals.csv", "sphere")), folder.ok(SHADE));
}
