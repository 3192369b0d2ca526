//! Objects with too few normals, and databases with little variance: each table has the components
//! that they determine, and its pictures are right. Pictures of the databases are compared with
//! quadrature of (3), which shares no code with them.

use crate::oracle;
use crate::support::{DEGREE, Folder, ORDER, PAIR, SHADED, difference, numbers, rows, scene};
use crate::tolerances;
use eigenshade_index::{light, material};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt::Write;

/// The lines of a CSV of normals with weights.
fn csv(normals: impl IntoIterator<Item = ([f64; 3], f64)>) -> String {
    let mut text = "x,y,z,weight\n".to_owned();
    for ([x, y, z], weight) in normals {
        writeln!(text, "{x},{y},{z},{weight}").expect("text");
    }
    text
}

/// The largest error of the pictures of these normals by their table, relative to the largest |I|,
/// and the number of components.
fn errors_of_pictures(name: &str, normals: &str) -> (f64, usize) {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for criterion in ["image-centered", "standard"] {
        let folder = Folder::new();
        folder.write("object.csv", normals);
        let text = scene(criterion, 10_000, "[]");
        folder.write("scene.toml", text.replace("\"sphere\"", "\"object.csv\""));
        folder.ok("basis --scene scene.toml --out b.bin");
        let shaded = |options: &str| {
            let shade = format!("shade b.bin {PAIR} --normals object.csv {options}");
            numbers(&rows(&folder.ok(&shade), SHADED), 3)
        };
        let reference = shaded("--method modes");
        let ours = shaded("--method polynomial --format f64");
        let error = difference(&ours, &reference);
        assert!(error.is_finite(), "{name}, {criterion}");
        worst = worst.max(error);
        count = count.max(folder.ok("eigenvalues b.bin").lines().count() - 1);
    }
    println!("{name}: {count} components, pictures {worst:.1e}");
    (worst, count)
}

fn assert_object(name: &str, normals: &str, most: usize) {
    let (worst, count) = errors_of_pictures(name, normals);
    assert!(worst <= tolerances::GENERAL_PICTURES, "{name}: {worst:e}");
    assert!(count <= most, "{name}: {count} components, where at most {most} are possible");
}

#[test]
fn one_normal() {
    assert_object("toward the camera", "x,y,z\n0,0,1\n", 1);
    assert_object("on the rim", "x,y,z\n0,1,0\n", 1);
    assert_object("aslant, a hundred times", &csv((0..100).map(|_| ([0.6, 0.0, 0.8], 1.0))), 1);
}

#[test]
fn normals_on_a_line() {
    let arc = |slant: f64| [slant.sin(), 0.0, slant.cos()];
    let normals = (-40..=40).map(|k| (arc(FRAC_PI_2 * f64::from(k) / 40.0), 1.0));
    assert_object("a half circle", &csv(normals), 17);
    let two = [([0.6, 0.0, 0.8], 1.0), ([-0.6, 0.0, 0.8], 3.0)];
    assert_object("a roof", &csv(two), 2);
}

/// The visible half of a cylinder across the picture.
#[test]
fn a_cylinder() {
    let normals = (0..=60).map(|k| {
        let (sine, cosine) = (FRAC_PI_2 * f64::from(k - 30) / 30.0).sin_cos();
        ([0.0, sine, cosine.max(0.0)], cosine.max(0.0))
    });
    assert_object("a cylinder", &csv(normals), 17);
}

#[test]
fn all_on_the_rim() {
    let normals = (0..64).map(|k| {
        let (y, x) = (TAU * f64::from(k) / 64.0).sin_cos();
        ([x, y, 0.0], 1.0)
    });
    assert_object("the rim", &csv(normals), 9);
}

/// Two normals within 1e-9, and a patch of a hundredth of a degree.
#[test]
fn normals_that_hardly_differ() {
    let two = [([0.6, 0.0, 0.8], 1.0), ([0.6 + 1e-9, 0.0, 0.8], 1.0)];
    assert_object("two within 1e-9", &csv(two), 2);
    let patch = (0..400).map(|k| {
        let (x, y) = (f64::from(k % 20) * 1e-5, f64::from(k / 20) * 1e-5);
        ([x, y, 1.0], 1.0)
    });
    assert_object("a patch of 2e-4", &csv(patch), 10);
}

/// Weights over twelve decades: the lightest normals hardly count, but their pictures are right.
#[test]
fn weights_over_twelve_decades() {
    let normals = (0..400).map(|k| {
        let z: f64 = (f64::from(k) + 0.5) / 400.0;
        let (y, x) = (2.399_963 * f64::from(k)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        ([radius * x, radius * y, z], 10f64.powf(-12.0 * f64::from(k) / 399.0))
    });
    let (worst, _) = errors_of_pictures("weights", &csv(normals));
    assert!(worst <= tolerances::LIGHTEST_NORMALS, "{worst:e}");
}

/// Facets without area: points, lines, and some that are thinner than rounding errors.
#[test]
fn a_mesh_with_degenerate_triangles() {
    let corners = "v 0 0 0\nv 1 0 0.3\nv 0 1 -0.2\nv 1 1 0.5\nv 2 0 0.6\nv 0.5 1e-17 0.15\n";
    let good = "f 1 2 3\nf 2 4 3\n";
    let bad = "f 1 1 1\nf 1 2 2\nf 1 2 5\nf 1 2 6\n";
    let eigenvalues = |text: String| {
        let folder = Folder::new();
        folder.write("m.obj", text);
        let scene = scene("image-centered", 10_000, "[]").replace("\"sphere\"", "\"m.obj\"");
        folder.write("scene.toml", scene);
        folder.ok("basis --scene scene.toml --out b.bin");
        folder.ok("eigenvalues b.bin")
    };
    let expected = eigenvalues(format!("{corners}{good}"));
    assert_eq!(eigenvalues(format!("{corners}{good}{bad}")), expected);
    assert!(expected.lines().count() > 2);
}

/// As [`tolerances::ALL_COMPONENTS_FEW`], of databases and irradiances that go through files.
const ALL_COMPONENTS_FEW_FILES: f64 = 2e-12;

/// As [`ALL_COMPONENTS_FEW_FILES`], of two lights whose exposures differ by 1e-6: the one component
/// has 1e-12 of the energy, and is known as well.
const ALL_COMPONENTS_ALIKE: f64 = 1e-6;

/// Lights of noise around an ambient term of 1, which is the exposure that statistics normalize to:
/// by the standard criterion, a basis of one material has images of this exposure only.
fn some_lights(count: usize) -> Vec<Vec<f64>> {
    let mut numbers = oracle::Numbers(61);
    let mut value = |l: usize| {
        let one = numbers.next();
        if l == 0 { 1.0 } else { 0.3 * one / l as f64 }
    };
    (0..count).map(|_| light::indices(DEGREE).map(|(l, _)| value(l)).collect()).collect()
}

/// Materials of noise around a matte one.
fn some_materials(count: usize) -> Vec<Vec<f64>> {
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

/// Asserts that every picture of the database, by both criteria, in f64 (to `in_f64`) and in f32,
/// is the quadrature's, relative to its peak.
fn assert_pictures(folder: &Folder, lights: &[Vec<f64>], materials: &[Vec<f64>], in_f64: f64) {
    let expected: Vec<Vec<f64>> =
        lights.iter().flat_map(|l| materials.iter().map(|b| picture(l, b))).collect();
    for criterion in ["standard", "image-centered"] {
        folder.write("scene.toml", scene(criterion, 10_000, "[]"));
        folder.ok("basis --scene scene.toml --out b.bin");
        for (format, allowed) in [("f64", in_f64), ("f32", tolerances::ALL_COMPONENTS_F32)] {
            let found = folder.shaded(&format!("--format {format}"));
            assert_eq!(found.len(), 3 * normals().len() * expected.len());
            for (found, expected) in found.chunks(3 * normals().len()).zip(&expected) {
                let peak = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
                for (found, expected) in found.chunks(3).zip(expected) {
                    for channel in found {
                        let error = (channel - expected).abs() / peak;
                        assert!(error <= allowed, "{criterion}, {format}: {error:e}");
                    }
                }
            }
        }
    }
}

/// The eigenvalues of the folder's table, without the constant's, and the number of components.
fn eigenvalues(folder: &Folder) -> (Vec<f64>, usize) {
    let rows = rows(&folder.ok("eigenvalues b.bin"), "criterion,index,m,eigenvalue");
    (rows.iter().filter_map(|row| row[3].parse().ok()).collect(), rows.len())
}

/// A sky of 1 with one texel of a million: its projection, and its pictures together with those of
/// moderate lights.
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
    let folder = folder(&[], &some_materials(3));
    folder.write("map.pfm", map);
    let text = folder.ok(&format!("light map.pfm --degree {DEGREE}"));
    let found = numbers(&rows(&text, "name,l,m,value"), 1);

    // Harmonics at the texels' centers times their solid angles, term by term.
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
        let error = (found - expected).abs() / largest;
        assert!(error <= tolerances::WRITTEN_DIGITS, "{found} {expected}");
    }

    let mut all = some_lights(2);
    all.push(found);
    let with_sun = self::folder(&all, &some_materials(3));
    assert_pictures(&with_sun, &all, &some_materials(3), tolerances::ALL_COMPONENTS);
}

/// Copies of one material: the components and eigenvalues of one.
#[test]
fn all_materials_alike() {
    let (lights, one) = (some_lights(3), some_materials(1));
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

/// A matte surface depends on degrees 0, 1, 2 and 4 of the light, so that each |m| has as many
/// profiles as there are such degrees >= |m|, and its irradiance has a closed form.
#[test]
fn lambertian_only() {
    let (lights, mut materials) = (some_lights(4), some_materials(3));
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

/// Two ambient lights whose exposures differ by 1e-6, on one material: one component, of known
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
    let materials = some_materials(1);
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
    let error = (found[0] / expected - 1.0).abs();
    assert!(error <= tolerances::SMALL_VARIANCE, "{error:e}");
    assert_pictures(&folder, &lights, &materials, ALL_COMPONENTS_ALIKE);
}
