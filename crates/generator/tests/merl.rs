//! Files in the format of the MERL database: written here from a formula, read back,
//! projected.

use eigenshade_generator::material::brdf::projection::{project, project_with};
use eigenshade_generator::material::brdf::{BINS, Brdf, Geometry, Ggx, Measure, Merl};
use eigenshade_generator::material::merl::{BYTES, SCALES, read};
use std::f64::consts::{FRAC_PI_2, PI};
use std::fs;
use std::path::PathBuf;

/// A tabulated lobe of 9 degrees between the centres of bins, relative: linear interpolation over a
/// degree in θ_d and up to two in θ_h.
const MERL_VALUE: f64 = 0.01;

/// Coefficients of the same table, of the largest: the last centre is half a degree from grazing,
/// beyond which the table is constant and the formula grows.
const MERL_PROJECTION: f64 = 0.01;

/// A tabulated BRDF of a constant, or with light and view exchanged, relative: weighted means of
/// eight numbers.
const MERL_ROUNDING: f64 = 3e-15;

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

/// The bytes of a file whose bins hold f at their centres, three channels in the
/// ratio 1 : 1/2 : 1/4; -1 where a direction is below the surface.
fn file(brdf: &dyn Brdf) -> Vec<u8> {
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

fn written(bytes: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::TempDir::new().unwrap();
    let path = folder.path().join("gloss.binary");
    fs::write(&path, bytes).unwrap();
    (folder, path)
}

#[test]
fn a_file_comes_back_as_the_function_it_holds() {
    let formula = Ggx::new(0.4, 0.3, 0.2).unwrap();
    let bytes = file(&formula);
    assert_eq!(bytes.len() as u64, BYTES);
    let (_folder, path) = written(&bytes);
    let surface = read(path).unwrap();
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
fn bins_without_a_value_are_left_to_their_neighbours() {
    let values: Vec<f64> = (0..BINS.iter().product())
        .map(|k| {
            let (h, d, p) = (k / (90 * 180), k / 180 % 90, k % 180);
            let centre = |bin: usize, count: usize| (bin as f64 + 0.5) / count as f64;
            let theta_h = FRAC_PI_2 * centre(h, 90).powi(2);
            let at = directions(theta_h, FRAC_PI_2 * centre(d, 90), PI * centre(p, 180));
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
        let message = read(&path).err().expect("a fault").to_string();
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
    let last = good.len() - 8;
    assert!(fault(&changed(last, &f64::INFINITY.to_le_bytes())).contains("blue"));
    let empty = good[..12].iter().copied().chain((-1f64).to_le_bytes().into_iter().cycle());
    let empty: Vec<u8> = empty.take(BYTES as usize).collect();
    assert!(fault(&empty).contains("no bin has a value"));
}
