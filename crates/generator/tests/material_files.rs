//! Files of materials: measured BRDFs as text in both layouts, and tables in the format of the MERL
//! database, written here from a formula, read back and projected. Every fault is named with its
//! file, its line and a remedy.

use eigenshade_generator::material::brdf::projection::{project, project_orders, project_with};
use eigenshade_generator::material::brdf::{Abc, Brdf, Geometry, Ggx, Measure, Sgd, Surface};
use eigenshade_generator::material::files::{self, Source};
use eigenshade_generator::material::measurements::Measured;
use eigenshade_generator::material::merl::{self, BINS, BYTES, Merl, SCALES};
use eigenshade_model::error::Result;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Debug;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A tabulated lobe of 9 degrees between the centers of bins, relative: linear interpolation over a
/// degree in θ_d and up to two in θ_h.
const MERL_VALUE: f64 = 0.01;

/// Coefficients of the same table, of the largest: the last center is half a degree from grazing,
/// beyond which the table is constant and the formula grows.
const MERL_PROJECTION: f64 = 0.01;

/// Channels that are projected together, of the largest coefficient, and the part of the energy
/// left out: rounding.
const TOGETHER: f64 = 1e-12;

/// A tabulated BRDF of a constant, or with light and view exchanged, relative: weighted means of
/// eight numbers.
const MERL_ROUNDING: f64 = 3e-15;

/// The measurements that a path names.
fn measured(path: impl AsRef<Path>) -> Result<Vec<Measured>> {
    let measured = |source: Source| match source {
        Source::Measured(measured) => measured,
        Source::Surface(surface) => panic!("`{}` is a formula", surface.name),
    };
    Ok(files::read(path.as_ref())?.into_iter().map(measured).collect())
}

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn plain(text: &str) -> Result<Vec<Measured>> {
    let folder = folder(&[("wool.csv", text)]);
    measured(folder.path().join("wool.csv"))
}

fn curet(table: &str, values: &str) -> Result<Vec<Measured>> {
    let folder = folder(&[("table.txt", table), ("abrdf.dat", values)]);
    measured(folder.path())
}

/// Asserts one line with the place, the fault, and a remedy after it.
fn assert_fault<T: Debug>(result: Result<T>, place: &str, fault: &str) {
    let text = result.unwrap_err().to_string();
    assert!(text.contains(&format!("{place}: ")), "`{text}`: {place}");
    assert!(text.contains(fault), "`{text}`: {fault}");
    assert!(!text.contains('\n') && text.split("; ").count() >= 2, "{text}");
}

const HEADER: &str = "theta_i,phi_i,theta_r,phi_r,r,g,b\n";
const DIRECTIONS: &str = "1 0.5 0.25 1.0 1.25\r\n2 0.0 0.0 0.75 0.0";

#[test]
fn plain_csv_is_read() {
    let text = "# by hand\nnote,theta_i,phi_i,theta_r,phi_r,g,r,b\n\
        x,0.5,1,0.25,3,0.2,0.1,0.3\ny, 1.5707963268 ,0,0,0,-0.01,0,0\n";
    let [wool] = &plain(text).unwrap()[..] else { panic!("one material") };
    let [first, second] = wool.samples[..] else { panic!("two measurements") };
    assert_eq!(wool.name, "wool");
    assert_eq!((first.theta_i, first.theta_r), (0.5, 0.25));
    assert_eq!((first.delta_phi, first.rgb), (-2.0, [0.1, 0.2, 0.3]));
    // A little beyond the rim is the rim, and noise may be negative.
    assert_eq!(second.theta_i, FRAC_PI_2);
    assert_eq!(second.rgb, [0.0, -0.01, 0.0]);
}

#[test]
fn gray_values_are_three_channels() {
    let wool = plain("theta_i,phi_i,theta_r,phi_r,value\n0,0,0,0,0.5\n").unwrap();
    assert_eq!(wool[0].samples[0].rgb, [0.5; 3]);
}

#[test]
fn folder_is_all_its_csv_files_by_name() {
    let text = format!("{HEADER}0,0,0,0,1,1,1\n");
    let folder = folder(&[("b.csv", &text), ("a.CSV", &text), ("notes.txt", "none")]);
    let names: Vec<String> =
        measured(folder.path()).unwrap().into_iter().map(|material| material.name).collect();
    assert_eq!(names, ["a", "b"]);
}

#[test]
fn faults_of_plain_csv_are_named() {
    let row = |row: &str| plain(&format!("# one\n{HEADER}# two\n0,0,0,0,1,1,1\n{row}\n"));
    assert_fault(plain("theta_i,phi_i\n"), "wool.csv:1", "theta_i,phi_i");
    assert_fault(plain("theta_i,phi_i,theta_r,phi_r,r,g\n"), "wool.csv:1", "header");
    assert_fault(plain(""), "wool.csv", "it is empty");
    assert_fault(plain(HEADER), "wool.csv", "no measurement");
    assert_fault(row("0,0,0,0,1,1"), "wool.csv:5", "7 fields, but this row has 6");
    assert_fault(row("0,0,0,0,1,1,1,1"), "wool.csv:5", "7 fields, but this row has 8");
    assert_fault(row("0,0,0,0,1,NaN,1"), "wool.csv:5", "`NaN`");
    assert_fault(row("0,inf,0,0,1,1,1"), "wool.csv:5", "`inf`");
    assert_fault(row("0,0,0,0,1,1,dark"), "wool.csv:5", "`dark`");
    assert_fault(row("1.58,0,0,0,1,1,1"), "wool.csv:5", "theta_i = 1.58 is outside");
    assert_fault(row("0,0,45,0,1,1,1"), "wool.csv:5", "theta_r = 45 is outside");
    assert_fault(row("-0.1,0,0,0,1,1,1"), "wool.csv:5", "theta_i = -0.1 is outside");
}

/// The BRDFs that a file of published fits has.
fn fits(text: &str) -> Result<Vec<Surface>> {
    let folder = folder(&[("fits.csv", text)]);
    let surface = |source: Source| match source {
        Source::Surface(surface) => surface,
        Source::Measured(measured) => panic!("`{}` is measured", measured.name),
    };
    Ok(files::read(folder.path().join("fits.csv"))?.into_iter().map(surface).collect())
}

const ABC: &str = "name,kd_r,kd_g,kd_b,a_r,a_g,a_b,b,c,ior\n";

#[test]
fn published_fits_are_read() {
    let read = fits(&format!("# of paint\n{ABC}red,0.2,0.1,0.05,1.5,1.4,1.3,40,2,1.6\n")).unwrap();
    assert_eq!((read.len(), read[0].name.as_str(), read[0].channels()), (1, "red", 3));
    let at = Geometry::from_angles(0.3, 0.8, 2.5);
    for (channel, (k, a)) in [(0.2, 1.5), (0.1, 1.4), (0.05, 1.3)].into_iter().enumerate() {
        let expected = Abc::new(k, [a, 40.0, 2.0], 1.6).unwrap().value(at);
        assert_eq!(read[0].channel(channel).value(at), expected);
    }
    let parameters = "rho_d rho_s alpha p f0 f1 kappa lambda c k theta0";
    let numbers = [0.2, 0.1, 0.4, 0.5, 0.06, -0.3, 3.8, 2.3, 0.04, 7.5, 0.2];
    let (mut header, mut row) = ("name".to_owned(), "cloth".to_owned());
    for (name, number) in parameters.split(' ').zip(numbers) {
        for (channel, factor) in [("r", 1.0), ("g", 0.9), ("b", 0.8)] {
            header += &format!(",{name}_{channel}");
            row += &format!(",{}", factor * number);
        }
    }
    let read = fits(&format!("{header}\n{row}\n")).unwrap();
    for (channel, factor) in [1.0, 0.9, 0.8].into_iter().enumerate() {
        let [matte, glossy, alpha, power, f0, f1, scale, lambda, c, k, theta] =
            numbers.map(|number| factor * number);
        let (fresnel, shadowing) = ([f0, f1], [lambda, c, k, theta]);
        let expected = Sgd { matte, glossy, alpha, power, fresnel, scale, shadowing };
        assert_eq!(read[0].channel(channel).value(at), expected.value(at));
    }
}

/// The channels of a fit are integrated together, as accurately as each by itself.
#[test]
fn channels_of_published_fits_are_projected_together() {
    let read = fits(&format!("{ABC}red,0.2,0,0.05,1.5,1.4,0,90,1.2,1.6\n")).unwrap();
    for measure in [Measure::Projected, Measure::SolidAngle] {
        let found = read[0].project_orders(&[5, 8], measure);
        let each = [0, 1, 2].map(|c| project_orders(read[0].channel(c), &[5, 8], measure));
        for (k, found) in found.iter().enumerate() {
            let (mut apart, mut left_out): (f64, f64) = (0.0, 0.0);
            for (found, expected) in found.material.rgb.iter().zip(&each) {
                let expected = &expected[k];
                let largest = expected.coefficients.iter().fold(0.0_f64, |m, b| m.max(b.abs()));
                for (found, expected) in found.iter().zip(&expected.coefficients) {
                    apart = apart.max((found - expected).abs() / largest);
                }
                left_out = left_out.max(expected.left_out);
            }
            println!("{apart:.1e} {:.1e}", found.left_out - left_out);
            assert!(apart <= TOGETHER && (found.left_out - left_out).abs() <= TOGETHER);
        }
    }
}

#[test]
fn faults_of_published_fits_are_named() {
    let row = |row: &str| fits(&format!("{ABC}{row}\n")).map(|read| read.len());
    assert_fault(fits(ABC).map(|read| read.len()), "fits.csv", "no material");
    assert_fault(row("red,0.2,0.1,0.05,1.5,1.4,1.3,40,2"), "fits.csv:2", "10 fields");
    assert_fault(row("red,0.2,0.1,0.05,1.5,dark,1.3,40,2,1.6"), "fits.csv:2", "`dark`");
    assert_fault(row("red,0.2,-0.1,0.05,1.5,1.4,1.3,40,2,1.6"), "fits.csv:2", "k = -0.1");
    assert_fault(row(",0.2,0.1,0.05,1.5,1.4,1.3,40,2,1.6"), "fits.csv:2", "name is empty");
}

#[test]
fn faults_of_paths_are_named() {
    let empty = folder(&[("notes.txt", "none")]);
    assert_fault(measured(empty.path()), "", "no materials in this folder");
    let missing = Path::new("no-such-folder").join("wool.csv");
    assert_fault(measured(missing), "wool.csv", "o such file");
    let lone = folder(&[("abrdf.dat", "1 0.1")]);
    assert_fault(measured(lone.path()), "table.txt", "o such file");
}

#[test]
fn curet_is_read() {
    let folder = folder(&[
        ("table.txt", DIRECTIONS),
        ("abrdf.dat", "3 0.1 0.2\n11   0.3 -1e-3\n29 1 1\n4 1 1\n"),
        ("samples.csv", "id,name\n3,Plaster_b\n29,Polyester (2 zoomed)\n4,\n"),
    ]);
    let materials = measured(folder.path()).unwrap();
    let names: Vec<&str> = materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["03-plaster-b", "sample-11", "29-polyester-2-zoomed", "sample-04"]);
    let [first, second] = materials[1].samples[..] else { panic!("two measurements") };
    // The table gives the view first.
    assert_eq!((first.theta_i, first.theta_r, first.delta_phi), (1.0, 0.5, 1.0));
    assert_eq!((first.rgb, second.rgb), ([0.3; 3], [-1e-3; 3]));
}

#[test]
fn faults_of_curet_are_named() {
    let table = |table| curet(table, "1 0.1 0.2");
    let values = |values| curet(DIRECTIONS, values);
    assert_fault(table(""), "table.txt", "no rows");
    assert_fault(table("1 0 0 0"), "table.txt:1", "4 fields");
    assert_fault(table("1 0 0 0 0\n\n3 0 0 0 0"), "table.txt:3", "index 3 where 2");
    assert_fault(table("one 0 0 0 0"), "table.txt:1", "`one`");
    assert_fault(table("1 0 0 nan 0"), "table.txt:1", "`nan`");
    assert_fault(table("1 0 0 1.6 0"), "table.txt:1", "theta_i = 1.6 is outside");
    assert_fault(table("1 -1 0 0 0"), "table.txt:1", "theta_v = -1 is outside");
    assert_fault(values(""), "abrdf.dat", "no rows");
    assert_fault(values("1 0.1 0.2\n2 0.1"), "abrdf.dat:2", "1 values where table.txt has 2");
    assert_fault(values("1 0.1 inf"), "abrdf.dat:1", "`inf`");
    assert_fault(values("wool 0.1 0.2"), "abrdf.dat:1", "`wool`");
    assert_fault(values("1 0 1\n2 0 1\n1 0 1"), "abrdf.dat:3", "given in line 1");
}

#[test]
fn faults_of_sample_names_are_named() {
    let named = |names| {
        let folder = folder(&[
            ("table.txt", DIRECTIONS),
            ("abrdf.dat", "1 0.1 0.2"),
            ("samples.csv", names),
        ]);
        measured(folder.path())
    };
    assert_fault(named("number,name\n1,Felt\n"), "samples.csv:1", "number,name");
    assert_fault(named("id,name\n1,Felt\n1,Wool\n"), "samples.csv:3", "two names");
    assert_fault(named("id,name\n-1,Felt\n"), "samples.csv:2", "negative");
    assert_fault(named("id,name\none,Felt\n"), "samples.csv:2", "`one`");
}

/// Cosines at half-way and difference angles, by rotating the difference vector to the
/// half-way direction; none below the surface.
fn directions(theta_h: f64, theta_d: f64, phi_d: f64) -> Option<Geometry> {
    let ((sin_h, cos_h), (sin_d, cos_d)) = (theta_h.sin_cos(), theta_d.sin_cos());
    let incident = cos_h * cos_d - sin_h * sin_d * phi_d.cos();
    let reflected = cos_h * cos_d + sin_h * sin_d * phi_d.cos();
    (incident > 0.0 && reflected > 0.0).then(|| Geometry {
        incident,
        reflected,
        between: (2.0 * theta_d).cos(),
    })
}

/// The bytes of a file whose bins hold f at their centers, three channels in the
/// ratio 1 : 1/2 : 1/4; -1 where a direction is below the surface.
fn merl_file(brdf: &dyn Brdf) -> Vec<u8> {
    let mut bytes: Vec<u8> = BINS.iter().flat_map(|&bins| (bins as i32).to_le_bytes()).collect();
    for (share, scale) in [1.0, 0.5, 0.25].into_iter().zip(SCALES) {
        for h in 0..BINS[0] {
            let theta_h = FRAC_PI_2 * ((h as f64 + 0.5) / BINS[0] as f64).powi(2);
            for d in 0..BINS[1] {
                let theta_d = FRAC_PI_2 * (d as f64 + 0.5) / BINS[1] as f64;
                for p in 0..BINS[2] {
                    let phi_d = PI * (p as f64 + 0.5) / BINS[2] as f64;
                    let value = directions(theta_h, theta_d, phi_d)
                        .map_or(-1.0, |at| share * brdf.value(at) / scale);
                    bytes.extend(value.to_le_bytes());
                }
            }
        }
    }
    bytes
}

fn written(bytes: &[u8]) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("gloss.binary");
    fs::write(&path, bytes).unwrap();
    (folder, path)
}

#[test]
fn a_file_comes_back_as_the_function_it_holds() {
    let formula = Ggx::new(0.4, 0.3, 0.2).unwrap();
    let bytes = merl_file(&formula);
    assert_eq!(bytes.len() as u64, BYTES);
    let (_folder, path) = written(&bytes);
    let surface = merl::read(path).unwrap();
    assert_eq!((surface.name.as_str(), surface.channels()), ("gloss", 3));

    let mut worst: f64 = 0.0;
    for theta_i in [0.1, 0.5, 1.0, 1.3] {
        for theta_r in [0.05, 0.52, 0.9, 1.25] {
            for delta_phi in [0.2, 1.5, 2.8, PI] {
                let at = Geometry::from_angles(theta_i, theta_r, delta_phi);
                let expected = formula.value(at);
                for (channel, share) in [1.0, 0.5, 0.25].into_iter().enumerate() {
                    let found = surface.channel(channel).value(at) / share;
                    worst = worst.max((found / expected - 1.0).abs());
                }
                let exchanged = Geometry { incident: at.reflected, reflected: at.incident, ..at };
                let (there, back) =
                    (surface.channel(0).value(at), surface.channel(0).value(exchanged));
                assert!((there - back).abs() <= MERL_ROUNDING * there);
            }
        }
    }
    println!("interpolated: {worst:.1e}");
    assert!(worst <= MERL_VALUE, "{worst}");

    let order = 8;
    let expected = project(&formula, order, Measure::Projected);
    let found = project_with(surface.channel(1), order, Measure::Projected, 6);
    let (mut apart, mut largest): (f64, f64) = (0.0, 0.0);
    for (found, expected) in found.coefficients.iter().zip(&expected.coefficients) {
        apart = apart.max((2.0 * found - expected).abs());
        largest = largest.max(expected.abs());
    }
    println!("projected: {:.1e}", apart / largest);
    assert!(apart <= MERL_PROJECTION * largest);
}

/// A constant stays one to the rim although a fifth of the bins have no value.
#[test]
fn bins_without_a_value_are_left_to_their_neighbors() {
    let values: Vec<f64> = (0..BINS.iter().product())
        .map(|k| {
            let (h, d, p) = (k / (90 * 180), k / 180 % 90, k % 180);
            let center = |bin: usize, count: usize| (bin as f64 + 0.5) / count as f64;
            let theta_h = FRAC_PI_2 * center(h, 90).powi(2);
            let at = directions(theta_h, FRAC_PI_2 * center(d, 90), PI * center(p, 180));
            at.map_or(-1.0, |_| 0.25)
        })
        .collect();
    let table = Merl::new(values).unwrap();
    assert!(table.missing() > 0.2, "{}", table.missing());
    for (theta_i, theta_r, delta_phi) in [(0.0, 0.0, 0.0), (1.5, 1.5, PI), (1.5, 0.2, 1.0)] {
        let found = table.value(Geometry::from_angles(theta_i, theta_r, delta_phi));
        assert!((found - 0.25).abs() < MERL_ROUNDING, "{theta_i} {theta_r} {delta_phi}: {found}");
    }
}

#[test]
fn damaged_files_are_faults() {
    let good = {
        let mut bytes: Vec<u8> =
            BINS.iter().flat_map(|&bins| (bins as i32).to_le_bytes()).collect();
        bytes.resize(BYTES as usize, 0);
        bytes
    };
    let fault = |bytes: &[u8]| {
        let (_folder, path) = written(bytes);
        let message = merl::read(&path).err().expect("a fault").to_string();
        assert!(message.contains("gloss.binary") && message.contains("; "), "{message}");
        message
    };
    let changed = |at: usize, with: &[u8]| {
        let mut bytes = good.clone();
        bytes[at..at + with.len()].copy_from_slice(with);
        bytes
    };
    assert!(fault(&good[..good.len() - 8]).contains("bytes"));
    assert!(fault(&good[..5]).contains("5 bytes"));
    assert!(fault(&[]).contains("0 bytes"));
    assert!(fault(&changed(8, &360i32.to_le_bytes())).contains("360"));
    assert!(fault(&changed(0, &i32::MAX.to_le_bytes())).contains("2147483647"));
    assert!(fault(&changed(0, &(-90i32).to_le_bytes())).contains("-90"));
    let red = fault(&changed(12, &f64::NAN.to_le_bytes()));
    assert!(red.contains("not finite") && red.contains("red part"), "{red}");
    assert!(fault(&changed(12, &1e200f64.to_le_bytes())).contains("beyond 1e100"));
    let last = good.len() - 8;
    assert!(fault(&changed(last, &f64::INFINITY.to_le_bytes())).contains("blue"));
    let empty = good[..12].iter().copied().chain((-1f64).to_le_bytes().into_iter().cycle());
    let empty: Vec<u8> = empty.take(BYTES as usize).collect();
    assert!(fault(&empty).contains("no bin has a value"));
}
