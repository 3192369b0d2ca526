//! `shade --method modes --format f64` on the shipped table against direct
//! quadrature of (3), which shares no code with it.

use crate::oracle;
use crate::support::Folder;
use crate::tolerances;
use eigenshade_index::{light, material};
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// Random coefficients that fall with their degree.
fn falling(count: usize, numbers: &mut oracle::Numbers) -> Vec<f64> {
    (0..count).map(|k| numbers.next() / (1.0 + 0.05 * k as f64)).collect()
}

/// Five lights x four materials x ten normals are 200 cases.
#[test]
fn modes_are_the_integral() {
    let mut numbers = oracle::Numbers(7);
    let lights: Vec<Vec<f64>> = (0..5).map(|_| falling(100, &mut numbers)).collect();
    let materials: Vec<Vec<f64>> = (0..4).map(|_| falling(40, &mut numbers)).collect();
    // The pole, as near to it as matters, the rim, as near to that, and between.
    let at =
        |slant: f64, tilt: f64| [slant.sin() * tilt.cos(), slant.sin() * tilt.sin(), slant.cos()];
    let mut normals =
        vec![[0.0, 0.0, 1.0], at(1e-9, 0.4), [0.6, -0.8, 0.0], at(FRAC_PI_2 - 1e-9, 2.0)];
    normals.extend((0..6).map(|_| numbers.normal()));

    let mut text = String::from("name,l,m,value\n");
    for (name, coefficients) in lights.iter().enumerate() {
        for ((l, m), value) in light::indices(9).zip(coefficients) {
            writeln!(text, "light-{name},{l},{m},{value:e}").expect("a string");
        }
    }
    let folder = Folder::new();
    folder.write("lights.csv", text);
    let mut text = String::from("name,o,p,q,value\n");
    for (name, coefficients) in materials.iter().enumerate() {
        for ((o, p, q), value) in material::indices(7).zip(coefficients) {
            writeln!(text, "material-{name},{o},{p},{q},{value:e}").expect("a string");
        }
    }
    folder.write("materials.csv", text);
    let mut text = String::from("x,y,z\n");
    for [x, y, z] in &normals {
        writeln!(text, "{x:e},{y:e},{z:e}").expect("a string");
    }
    folder.write("normals.csv", text);

    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/sphere.bin");
    let shaded = folder.ok(&format!(
        "shade {table} --lights lights.csv --materials materials.csv --normals normals.csv \
         --method modes --format f64"
    ));
    let mut found: HashMap<[String; 3], f64> = HashMap::new();
    for row in csv::Reader::from_reader(shaded.as_bytes()).records() {
        let row = row.expect("a row");
        let key = std::array::from_fn(|k| row[k].to_owned());
        found.insert(key, row[3].parse().expect("a number"));
    }
    assert_eq!(found.len(), 200);
    let mut worst: f64 = 0.0;
    for (a, light) in lights.iter().enumerate() {
        let light = oracle::ExplicitLight::new(light);
        for (b, material) in materials.iter().enumerate() {
            let terms: Vec<_> = eigenshade_index::material::indices(7)
                .zip(material)
                .map(|((o, p, q), b)| (o, p, q, *b))
                .collect();
            let expected: Vec<f64> =
                normals.iter().map(|normal| oracle::irradiance(&light, &terms, *normal)).collect();
            let peak = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
            for (k, expected) in expected.iter().enumerate() {
                let key = [format!("light-{a}"), format!("material-{b}"), k.to_string()];
                worst = worst.max((found[&key] - expected).abs() / peak);
            }
        }
    }
    println!("shade --method modes against quadrature: {worst:.1e} of the peak");
    assert!(worst <= tolerances::DIRECT_SUM, "{worst}");
}
