//! A sun, and databases that leave little to be learned, through the command line. Pictures
//! with all components are compared with quadrature of (3), which shares no code with them.

use crate::oracle;
use crate::support::{Folder, numbers, rows, scene};
use crate::tolerances;
use eigenshade_index::{light, material};
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

/// The same of databases and irradiances that go through files.
const ALL_COMPONENTS_FEW_FILES: f64 = 2e-12;

/// The same of two lights whose exposures are 1e-6 apart: the one component has 1e-12 of the
/// variance, which is all that is known of it.
const ALL_COMPONENTS_ALIKE: f64 = 1e-6;

const DEGREE: usize = 4;
const ORDER: usize = 3;

/// Lights of noise around an ambient term of 1: in the exposure that statistics give them, for a basis by
/// the standard criterion of one material has no other.
fn lights(count: usize) -> Vec<Vec<f64>> {
    let mut numbers = oracle::Numbers(61);
    let mut value = |l: usize| {
        let one = numbers.next();
        if l == 0 { 1.0 } else { 0.3 * one / l as f64 }
    };
    (0..count).map(|_| light::indices(DEGREE).map(|(l, _)| value(l)).collect()).collect()
}

/// Materials of noise around a matte one.
fn materials(count: usize) -> Vec<Vec<f64>> {
    let mut numbers = oracle::Numbers(62);
    let mut value = |sum: usize| {
        let one = numbers.next();
        if sum == 0 { 1.5 + 0.5 * one } else { one / sum as f64 }
    };
    let mut one = || material::indices(ORDER).map(|(o, p, q)| value(o + p + q)).collect();
    (0..count).map(|_| one()).collect()
}

/// The pole, the rim, as near to both as matters, and between.
fn normals() -> Vec<[f64; 3]> {
    let at = |slant: f64, tilt: f64| {
        let z = if slant == FRAC_PI_2 { 0.0 } else { slant.cos() };
        [slant.sin() * tilt.cos(), slant.sin() * tilt.sin(), z]
    };
    let tilts = [0.0, 0.4, 1.3, 2.6, -2.0, -0.7];
    let slants = [0.0, 1e-9, 0.5, 1.2, FRAC_PI_2 - 1e-9, FRAC_PI_2];
    slants.into_iter().zip(tilts).map(|(slant, tilt)| at(slant, tilt)).collect()
}

/// A folder with these coefficients and normals as its files.
fn folder(lights: &[Vec<f64>], materials: &[Vec<f64>]) -> Folder {
    let folder = Folder::new();
    let mut text = String::from("name,l,m,value\n");
    for (name, coefficients) in lights.iter().enumerate() {
        for ((l, m), value) in light::indices(DEGREE).zip(coefficients) {
            writeln!(text, "light-{name},{l},{m},{value:e}").expect("a string");
        }
    }
    folder.write("lights.csv", text);
    let mut text = String::from("name,o,p,q,value\n");
    for (name, coefficients) in materials.iter().enumerate() {
        for ((o, p, q), value) in material::indices(ORDER).zip(coefficients) {
            writeln!(text, "material-{name},{o},{p},{q},{value:e}").expect("a string");
        }
    }
    folder.write("materials.csv", text);
    let mut text = String::from("x,y,z\n");
    for [x, y, z] in normals() {
        writeln!(text, "{x:e},{y:e},{z:e}").expect("a string");
    }
    folder.write("normals.csv", text);
    folder
}

/// One picture of the normals by quadrature.
fn picture(light: &[f64], material: &[f64]) -> Vec<f64> {
    let explicit = oracle::ExplicitLight::new(light);
    let indices = material::indices(ORDER).zip(material);
    let terms: Vec<_> = indices.map(|((o, p, q), b)| (o, p, q, *b)).collect();
    normals().into_iter().map(|normal| oracle::irradiance(&explicit, &terms, normal)).collect()
}

/// By both criteria, in f64 (to `in_f64`) and f32: every picture of the database, each of its peak.
fn assert_pictures(folder: &Folder, lights: &[Vec<f64>], materials: &[Vec<f64>], in_f64: f64) {
    let expected: Vec<Vec<f64>> =
        lights.iter().flat_map(|l| materials.iter().map(|b| picture(l, b))).collect();
    for criterion in ["standard", "image-centered"] {
        folder.write("scene.toml", scene(criterion, 10_000, "[]"));
        folder.ok("basis --scene scene.toml --out b.bin");
        let pair = "--lights lights.csv --materials materials.csv --normals normals.csv";
        for (format, allowed) in [("f64", in_f64), ("f32", tolerances::ALL_COMPONENTS_F32)] {
            let text = folder.ok(&format!("shade b.bin {pair} --format {format}"));
            let found = numbers(&rows(&text, "light,material,normal,r,g,b"), 3);
            assert_eq!(found.len(), 3 * normals().len() * expected.len());
            for (found, expected) in found.chunks(3 * normals().len()).zip(&expected) {
                let peak = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
                for (found, expected) in found.chunks(3).zip(expected) {
                    for channel in found {
                        let apart = (channel - expected).abs() / peak;
                        assert!(apart <= allowed, "{criterion}, {format}: {apart:e}");
                    }
                }
            }
        }
    }
}

/// Eigenvalues of the folder's table, the constant's empty one left out; and how many
/// components there are.
fn eigenvalues(folder: &Folder) -> (Vec<f64>, usize) {
    let rows = rows(&folder.ok("eigenvalues b.bin"), "criterion,index,m,eigenvalue");
    (rows.iter().filter_map(|row| row[3].parse().ok()).collect(), rows.len())
}

/// A sky of 1 with one texel of a million: what `light` makes of it, and its pictures beside
/// those of quiet lights.
#[test]
fn a_sun() {
    const SIZE: [usize; 2] = [64, 32];
    const SUN: [usize; 2] = [45, 9];
    let [width, height] = SIZE;
    let mut map = format!("PF\n{width} {height}\n-1.0\n").into_bytes();
    // From the bottom up.
    for row in (0..height).rev() {
        for column in 0..width {
            let value = if [column, row] == SUN { 1e6f32 } else { 1.0 };
            (0..3).for_each(|_| map.extend(value.to_le_bytes()));
        }
    }
    let folder = folder(&[], &materials(3));
    folder.write("map.pfm", map);
    let text = folder.ok(&format!("light map.pfm --degree {DEGREE}"));
    let found = numbers(&rows(&text, "name,l,m,value"), 1);

    // Harmonics at the texels' centres times their solid angles, term by term.
    let texels: Vec<([f64; 3], f64)> = (0..height)
        .flat_map(|row| (0..width).map(move |column| (column, row)))
        .map(|(column, row)| {
            let edge = |row: usize| PI * row as f64 / height as f64;
            let theta = PI * (row as f64 + 0.5) / height as f64;
            let t = 2.0 * PI * ((column as f64 + 0.5) / width as f64 - 0.5);
            let area = 2.0 * PI / width as f64 * (edge(row).cos() - edge(row + 1).cos());
            let radiance = if [column, row] == SUN { 1e6 } else { 1.0 };
            let direction = [t.sin() * theta.sin(), theta.cos(), -t.cos() * theta.sin()];
            (direction, area * radiance)
        })
        .collect();
    let count = light::count(DEGREE);
    let expected: Vec<f64> = (0..count)
        .map(|place| {
            let unit: Vec<f64> = (0..count).map(|k| f64::from(u8::from(k == place))).collect();
            let harmonic = oracle::ExplicitLight::new(&unit);
            texels.iter().map(|(direction, flux)| flux * harmonic.radiance(*direction)).sum()
        })
        .collect();
    let largest = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        let apart = (found - expected).abs() / largest;
        assert!(apart <= tolerances::WRITTEN_DIGITS, "{found} {expected}");
    }

    let mut all = lights(2);
    all.push(found);
    let with_sun = self::folder(&all, &materials(3));
    assert_pictures(&with_sun, &all, &materials(3), tolerances::ALL_COMPONENTS);
}

/// Copies of one material: the components and eigenvalues of one.
#[test]
fn all_materials_alike() {
    let (lights, one) = (lights(3), materials(1));
    let single = folder(&lights, &one);
    single.ok("basis --scene scene.toml --out b.bin");
    let (expected, count) = eigenvalues(&single);
    let copies = vec![one[0].clone(); 6];
    let folder = folder(&lights, &copies);
    folder.ok("basis --scene scene.toml --out b.bin");
    let (found, of_copies) = eigenvalues(&folder);
    assert_eq!(of_copies, count);
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() <= tolerances::SINGULAR_VALUE, "{found:e} {expected:e}");
    }
    assert_pictures(&folder, &lights, &copies, ALL_COMPONENTS_FEW_FILES);
}

/// Degrees 0, 1, 2 and 4 reach a matte surface, each |m| by as many profiles as there are
/// degrees from |m| on, and its irradiance has a closed form.
#[test]
fn lambertian_only() {
    let (lights, mut materials) = (lights(4), materials(3));
    materials.iter_mut().for_each(|one| one[1..].fill(0.0));
    let folder = folder(&lights, &materials);
    assert_pictures(&folder, &lights, &materials, ALL_COMPONENTS_FEW_FILES);
    let (_, count) = eigenvalues(&folder);
    assert_eq!(count, 1 + 3 + 2 * (3 + 2 + 1 + 1));
    // A clamped cosine: π, 2π/3, π/4, 0, -π/24; b_00^0 = 2 is f = 1/π.
    let cosine = [PI, 2.0 * PI / 3.0, 0.25 * PI, 0.0, -PI / 24.0];
    for (light, on) in lights.iter().zip(&materials) {
        let clamped: Vec<f64> =
            light::indices(DEGREE).zip(light).map(|((l, _), value)| cosine[l] * value).collect();
        let clamped = oracle::ExplicitLight::new(&clamped);
        let expected: Vec<f64> =
            normals().into_iter().map(|n| 0.5 * on[0] / PI * clamped.radiance(n)).collect();
        let peak = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for (found, expected) in picture(light, on).iter().zip(&expected) {
            assert!((found - expected).abs() <= tolerances::DIRECT_SUM * peak);
        }
    }
}

/// Ambient light of two exposures 1e-6 apart on one material: one component, of known
/// variance.
#[test]
fn a_covariance_of_rank_one() {
    let spread = 0.5e-6;
    let lights: Vec<Vec<f64>> = [1.0 - spread, 1.0 + spread]
        .map(|ambient| {
            let mut light = vec![0.0; light::count(DEGREE)];
            light[0] = ambient;
            light
        })
        .to_vec();
    let materials = materials(1);
    let folder = folder(&lights, &materials);
    let text = scene("standard", 10_000, "[]")
        .replace("rotation = \"any\"", "rotation = \"any\"\nnormalize = \"none\"");
    folder.write("scene.toml", text);
    folder.ok("basis --scene scene.toml --out b.bin");
    let (found, count) = eigenvalues(&folder);
    assert_eq!(count, 1);
    // Under ambient light a picture depends on the slant alone; (cos α)/π over the disc.
    let mean = oracle::ExplicitLight::new(&[1.0]);
    let indices = material::indices(ORDER).zip(&materials[0]);
    let terms: Vec<_> = indices.map(|((o, p, q), b)| (o, p, q, *b)).collect();
    let energy: f64 = oracle::clenshaw_curtis(32)
        .into_iter()
        .map(|(z, weight)| {
            let normal = [(1.0 - z * z).sqrt(), 0.0, z];
            2.0 * z * weight * oracle::irradiance(&mean, &terms, normal).powi(2)
        })
        .sum();
    let expected = spread * spread * energy;
    let apart = (found[0] / expected - 1.0).abs();
    assert!(apart <= tolerances::SMALL_VARIANCE, "{apart:e}");
    assert_pictures(&folder, &lights, &materials, ALL_COMPONENTS_ALIKE);
}
