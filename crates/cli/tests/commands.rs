//! Each command once: the form of its output.

use crate::PROGRAM;
use crate::support::files::{decoded, eigenvalues, gray_png, map};
use crate::support::{
    BASIS, DEGREE, Folder, ORDER, PAIR, PROJECTED, SHADE, SHADED, assert_contains, assert_fails,
    materials, numbers, repository_text, rows,
};
use crate::tolerances;
use eigenshade_model::polar_integral;
use png::ColorType;
use std::f64::consts::PI;

/// b_00^0 of a matte surface measured without error, relative: the square of the fit's
/// regularization.
const MATTE_FIT: f64 = 1e-8;

/// Asserts L_0^0 of a light of this radiance from everywhere.
fn assert_mean(light: &str, radiance: f64) {
    let found = numbers(&rows(light, "name,l,m,value"), 1)[0];
    let expected = radiance * (4.0 * PI).sqrt();
    assert!((found - expected).abs() <= tolerances::WRITTEN_DIGITS * expected);
}

#[test]
fn light_projects_maps() {
    let folder = Folder::new();
    folder.write("gray.pfm", map(2.0));
    let (text, report) = folder.both("light gray.pfm --degree 2");
    assert!(report.starts_with("gray: 8 x 4, no negative radiance"), "{report}");
    let found = rows(&text, "name,l,m,value");
    assert_eq!(found.len(), 9);
    assert_mean(&text, 2.0);
    assert!(found.iter().all(|row| row[0] == "gray"));
    // A file has the same bytes as standard output.
    assert_eq!(folder.ok("light gray.pfm --degree 2 --out l.csv"), "");
    assert_eq!(folder.read("l.csv"), text);
    folder.write("below.pfm", map(-1.0));
    let below = folder.messages("light below.pfm --out l.csv");
    assert_contains(&below, &["100.00 % of the radiance is negative"]);
}

/// A white picture is a radiance of 1, and a warning says what a picture lacks.
#[test]
fn light_projects_pictures() {
    let folder = Folder::new();
    folder.write("white.png", gray_png(8, 4, &[255; 32]));
    let (text, report) = folder.both("light white.png --degree 1");
    assert!(report.contains("warning: white.png: light is clipped at white"), "{report}");
    assert_mean(&text, 1.0);
    folder.write("dim.png", gray_png(8, 4, &[254; 32]));
    assert!(!folder.messages("light dim.png --degree 1").contains("warning"));
}

#[test]
fn light_converts_both_ways() {
    let folder = Folder::new();
    let there = folder.ok("light lights.csv --degree 4 --convention graphics");
    let [before, after] =
        [folder.read("lights.csv"), there.clone()].map(|text| rows(&text, "name,l,m,r,g,b"));
    let factor = |row: &[String]| match row[2].parse::<i32>().unwrap() {
        m if m < 0 || m % 2 == 1 => -1.0,
        _ => 1.0,
    };
    for (before, after) in before.iter().zip(&after) {
        let [before_r, after_r] = [before, after].map(|row| row[3].parse::<f64>().unwrap());
        assert_eq!(after_r, factor(before) * before_r);
    }
    folder.write("there.csv", there);
    let values = |light: &str| numbers(&rows(&folder.ok(light), "name,l,m,r,g,b"), 3);
    assert_eq!(values("light there.csv --from graphics --degree 4"), numbers(&before, 3));
    let low: Vec<_> = before.iter().filter(|row| row[1].as_str() <= "1").cloned().collect();
    assert_eq!(values("light lights.csv --degree 1"), numbers(&low, 3));
    assert_fails(&folder, "light lights.csv", &["lights.csv", "--from graphics"]);
    assert_fails(&folder, "light nothing.csv", &["nothing.csv: No such file"]);
    assert_fails(&folder, "light nothing", &["`nothing` is neither", "a map, a folder"]);
}

/// A light that is the same from everywhere has Filament's irradiance over π, which is its
/// radiance, and cmgen's irradiance π times its L_0^0.
#[test]
fn light_converts_for_other_programs() {
    let folder = Folder::new();
    folder.write("gray.pfm", map(1.0));
    folder.ok("light gray.pfm --degree 2 --out l.csv");
    let values = |text: &str| numbers(&rows(text, "name,l,m,value"), 1);
    let before = values(&folder.read("l.csv"));
    for (convention, mean) in [("filament", 1.0), ("cmgen-irradiance", 11.1367), ("cmgen", 3.5449)]
    {
        let other = folder.ok(&format!("light gray.pfm --degree 2 --convention {convention}"));
        let text = folder.ok(&format!("light l.csv --convention {convention}"));
        let converted = values(&text);
        assert!((converted[0] / mean - 1.0).abs() < 1e-3, "{convention}");
        for (a, b) in values(&other).iter().zip(converted) {
            assert!((a - b).abs() < 1e-7, "{a} {b}");
        }
        folder.write("other.csv", text);
        let back = folder.ok(&format!("light other.csv --from {convention} --convention paper"));
        assert!(values(&back).iter().zip(&before).all(|(a, b)| (a - b).abs() < 1e-12));
    }
    // A shipped light by its name is its CSV.
    let named = folder.ok("light park --degree 2 --convention filament");
    folder.write("park.csv", folder.ok("light park --degree 2"));
    assert_eq!(named, folder.ok("light park.csv --convention filament"));
    for (arguments, fragments) in [
        ("park --degree 33", &["park", "degree 32"][..]),
        ("park --from cmgen", &["park", "--from"]),
        ("parkk", &["`parkk` is neither", "use `park`"]),
        ("px.png nx.png py.png ny.png pz.png nz.png", &["six faces", "the folder"]),
        ("lights.csv --degree 4 --convention filament", &["lights.csv", "degree 4", "--degree 2"]),
        ("gray.pfm --from cmgen", &["--from", "one light"]),
    ] {
        assert_fails(&folder, &format!("light {arguments}"), fragments);
    }
}

#[test]
fn material_fits_and_reports() {
    let folder = Folder::new();
    let angles = (0..64).map(|k| [k / 8, k % 8].map(|k| 0.19 * f64::from(k)));
    let row = |[i, r]: [f64; 2]| format!("{i},0,{r},{},0.25\n", 3.0 * i - r);
    let measured: String = angles.map(row).collect();
    folder.write("chalk.csv", format!("theta_i,phi_i,theta_r,phi_r,value\n{measured}"));
    let (text, message) = folder.both("material chalk.csv --order 2 --report r.csv");
    assert!(message.starts_with("chalk: 64 samples, residual"));
    let found = rows(&text, "name,o,p,q,value");
    assert_eq!(found.len(), 5);
    // 1/4 = b_00^0 / 2 pi.
    let expected = 0.5 * PI;
    assert!((numbers(&found, 1)[0] - expected).abs() < MATTE_FIT * expected);
    let figures = "name,samples,maximum,residual,lowest,highest,condition";
    assert_eq!(rows(&folder.read("r.csv"), figures)[0][..3], ["chalk", "64", "0.25"]);
}

#[test]
fn basis_and_info_describe_a_table() {
    let folder = Folder::new();
    let report = ["rank", "components", "there are no more", "energy kept", "bytes", "time"];
    assert_contains(&folder.ok(BASIS), &report);
    assert!(folder.read("b.manifest.csv").starts_with("entry,value,bytes,crc32\n"));
    let description =
        ["criterion", "image-centered", "degree", "order", "rank", "energy kept", "bytes"];
    assert_contains(&folder.ok("info --table b.bin"), &description);
}

#[test]
fn eigenvalues_fall() {
    let folder = Folder::with_table();
    let found = rows(&folder.ok("eigenvalues --table b.bin"), "criterion,index,m,eigenvalue");
    assert_eq!(found[0], ["image-centered", "0", "0", ""]);
    let values = eigenvalues(&folder);
    assert!(values.len() > 20 && values.is_sorted_by(|a, b| a >= b));
    folder.ok("eigenvalues --table b.bin --out e.csv");
    assert_eq!(rows(&folder.read("e.csv"), "criterion,index,m,eigenvalue"), found);
}

#[test]
fn project_takes_every_pair_and_any_degree() {
    let folder = Folder::with_table();
    let rows = |arguments: &str| rows(&folder.ok(&format!("project {arguments}")), PROJECTED);
    let found = rows(&format!("--table b.bin {PAIR} --components 7"));
    assert_eq!(found.len(), 3 * 4 * 7);
    assert_eq!(found[7][..3], ["light-0", "material-1", "0"]);
    // Higher orders and degrees are dropped, lower ones are used.
    folder.write("high.csv", materials(ORDER + 2, 4));
    folder.write("low.csv", folder.ok(&format!("light lights.csv --degree {}", DEGREE - 2)));
    let all = rows(&format!("--table b.bin {PAIR}")).len();
    assert_eq!(rows("--table b.bin --light low.csv --material high.csv").len(), all);
}

#[test]
fn shade_takes_every_pair_and_normal() {
    let folder = Folder::with_table();
    for options in [
        "--components 20",
        "--method eigen --components 20",
        "--method eigen --format f64",
        "--method modes",
    ] {
        let found = rows(&folder.ok(&format!("{SHADE} {options}")), SHADED);
        assert_eq!(found.len(), 3 * 4 * 43);
        assert_eq!(found[43][..3], ["light-0", "material-1", "0"]);
    }
    // f32 results are written with all their digits.
    assert!(folder.shaded("").iter().all(|&value| f64::from(value as f32) == value));
}

#[test]
fn render_makes_a_transparent_picture() {
    let folder = Folder::with_table();
    let choice = "--light lights.csv:light-1 --material materials.csv:material-0";
    folder.ok(&format!("render --table b.bin {choice} --out p.png --size 40"));
    let (width, color, bytes) = decoded(&folder.path("p.png"));
    assert_eq!((width, bytes.len(), color), (40, 4 * 1600, ColorType::Rgba));
    assert_eq!((bytes[3], bytes[4 * (20 * 40 + 20) + 3]), (0, 255));
}

/// The window of a material multiplies the coefficients of each order by the light's factor.
#[test]
fn a_window_attenuates_the_orders_of_a_material() {
    let folder = Folder::new();
    let [plain, windowed] = ["", "--window 8"].map(|window| {
        let formula = format!("material ggx --roughness 0.4 --f0 0.9 --order 5 {window}");
        rows(&folder.ok(&formula), "name,o,p,q,value")
    });
    for (plain, windowed) in plain.iter().zip(&windowed) {
        assert_eq!(plain[..4], windowed[..4]);
        let x = PI * plain[1].parse::<f64>().unwrap() / 8.0;
        let factor = if x == 0.0 { 1.0 } else { (x.sin() / x).powi(4) };
        let [plain, windowed] = [plain, windowed].map(|row| row[4].parse::<f64>().unwrap());
        assert!((windowed - factor * plain).abs() <= 1e-14 * plain.abs());
    }
}

#[test]
fn demo_shows_shipped_data() {
    let folder = Folder::new();
    assert_eq!(folder.ok("demo --out new/demo --size 16"), "");
    let files = || std::fs::read_dir(folder.path("new/demo")).unwrap().count();
    assert_eq!((files(), folder.path("new/demo/demo.png").is_file()), (1, true));
}

/// It is not an error if the reader closes the pipe early.
#[cfg(unix)]
#[test]
fn a_closed_pipe_is_not_an_error() {
    use std::process::{Command, Stdio};
    let folder = Folder::with_table();
    let mut child = Command::new(PROGRAM)
        .current_dir(folder.path("."))
        .args(SHADE.split(' '))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), vec![]));
}

/// `evaluate` against 25-digit values of degrees up to 9 and up to 64, from explicit sums and
/// quadrature in 60-digit arithmetic; a column `value` is replaced.
#[test]
fn functions_agree_with_the_vectors() {
    let folder = Folder::new();
    for function in
        ["spherical-harmonic", "wigner-d", "zernike-radial", "polar-integral", "irradiance-mode"]
    {
        let name = function.replace('-', "_");
        let given = repository_text(&format!("crates/generator/tests/vectors/{name}.csv"));
        folder.write("p.csv", &given);
        let header = given.lines().next().unwrap();
        let text = folder.ok(&format!("evaluate {function} p.csv"));
        let (ours, given) = (rows(&text, header), rows(&given, header));
        assert_eq!(ours.len(), given.len());
        let mut rows_of = [0; 2];
        for (ours, given) in ours.iter().zip(&given) {
            let last = given.len() - 1;
            assert_eq!(ours[..last], given[..last]);
            let [a, b] = [ours, given].map(|row| row[last].parse::<f64>().unwrap());
            let index = |column: usize| given[column].parse::<usize>().unwrap();
            // Of l and o. The error of C is that of N C, the product that is used.
            let (degree, scale) = match function {
                "polar-integral" => {
                    (index(0).max(index(1)), polar_integral::normalization(index(0), index(2)))
                }
                "irradiance-mode" => (index(0).max(index(2)), 1.0),
                _ => (index(0), 1.0),
            };
            rows_of[usize::from(degree > 9)] += 1;
            let allowed =
                if degree > 9 { tolerances::SPECIAL_HIGH } else { tolerances::SPECIAL_LOW };
            assert!(((a - b) * scale).abs() <= allowed, "{function}: {given:?}: {a}");
        }
        assert!(rows_of.iter().all(|rows| *rows > 20), "{function}: {rows_of:?}");
    }
}

#[test]
fn evaluate_keeps_other_columns_and_states_exact_bounds() {
    let folder = Folder::new();
    folder.write("p.csv", "# points\nnote,rho,value,q,o\na,0.5,9,0,2\n\"b,c\",1,9,2,2\n");
    let text = folder.ok("evaluate zernike-radial p.csv");
    assert_eq!(text, "note,rho,q,o,value\na,0.5,0,2,-0.5\n\"b,c\",1,2,2,1\n");
    // A bound that a message gives is one that the function takes.
    for (function, points, message) in [
        (
            "irradiance-mode",
            "l,m,o,p,q,alpha,beta\n0,0,0,0,0,1.5708,0\n",
            "alpha = 1.5708 is out of range; use 0 <= alpha <= pi/2",
        ),
        (
            "wigner-d",
            "l,m,n,alpha\n1,0,0,-1e99\n",
            "alpha = -1e99 is out of range; use 0 <= alpha <= pi",
        ),
    ] {
        folder.write("p.csv", points);
        assert_fails(&folder, &format!("evaluate {function} p.csv"), &[message]);
    }
}
