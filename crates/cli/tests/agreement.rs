//! What the commands give agrees with what it should be.

use crate::support::{Folder, numbers, repository, rows, scene};
use crate::tolerances;
use std::fs;

/// Pictures under a light turned with its normals against those as they were, of the peak: sums of
/// 25 terms, and angles of 16 digits.
const ROTATED_LIGHT: f64 = 2e-15;

const PAIR: &str = "--lights lights.csv --materials materials.csv --normals normals.csv";
const HEADER: &str = "light,material,normal,r,g,b";

/// Largest |a - b|, of the largest |b|.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let peak = b.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / peak
}

fn shaded(folder: &Folder, options: &str) -> Vec<f64> {
    numbers(&rows(&folder.ok(&format!("shade b.bin {PAIR} {options}")), HEADER), 3)
}

#[test]
fn all_components_are_the_truth() {
    for criterion in ["image-centered", "standard"] {
        let folder = Folder::new();
        folder.write("scene.toml", scene(criterion, 10_000, "[]"));
        folder.ok("basis --scene scene.toml --out b.bin");
        let truth = shaded(&folder, "--method modes");
        for method in ["polynomial", "eigen"] {
            let ours = shaded(&folder, &format!("--method {method} --format f64"));
            let found = apart(&ours, &truth);
            println!("{criterion}, {method}: {found:e}");
            assert!(found < tolerances::ALL_COMPONENTS, "{criterion}, {method}: {found:e}");
            let ours = shaded(&folder, &format!("--method {method}"));
            let found = apart(&ours, &truth);
            println!("{criterion}, {method}, f32: {found:e}");
            assert!(found < tolerances::ALL_COMPONENTS_F32, "{criterion}, {method}: {found:e}");
        }
    }
}

/// What a format computed comes out with all its digits.
#[test]
fn f32_reads_back() {
    let folder = Folder::with_table();
    assert!(shaded(&folder, "").iter().all(|&value| f64::from(value as f32) == value));
}

/// R = Rz(A) Ry(B) Rz(C) turns the light: under Rz alone, and under a half turn
/// about y.
#[test]
fn the_light_turns() {
    let folder = Folder::with_table();
    folder.write("turned.csv", {
        let text = folder.read("normals.csv");
        let angle = 0.7f64;
        let turn = |line: &str| {
            let n: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
            let (sine, cosine) = angle.sin_cos();
            format!("{},{},{}\n", cosine * n[0] - sine * n[1], sine * n[0] + cosine * n[1], n[2])
        };
        format!("x,y,z\n{}", text.lines().skip(1).map(turn).collect::<String>())
    });
    let straight = shaded(&folder, "--method modes");
    for rotation in ["0.7,0,0", "0,0,0.7", "1.0,0,-0.3", "0.7,-0,0"] {
        let command = format!("shade b.bin {PAIR} --method modes --rotate {rotation}");
        let command = command.replace("normals.csv", "turned.csv");
        let turned = numbers(&rows(&folder.ok(&command), HEADER), 3);
        assert!(apart(&turned, &straight) < ROTATED_LIGHT, "{rotation}");
    }
    // A light of degree 1, L_1^1 alone, is -x; Ry(pi/2) brings x to -z, so it is z: L_1^0 = -1.
    let light =
        |m0: f64, m1: f64| format!("name,l,m,value\na,0,0,4\na,1,-1,0\na,1,0,{m0}\na,1,1,{m1}\n");
    folder.write("lights.csv", light(0.0, 1.0));
    let turned = shaded(&folder, "--rotate 0,1.5707963267948966,0 --method modes");
    folder.write("lights.csv", light(1.0, 0.0));
    assert!(apart(&turned, &shaded(&folder, "--method modes")) < ROTATED_LIGHT);
}

/// `evaluate` against 25-digit values; a column `value` is replaced.
#[test]
fn functions_agree_with_the_vectors() {
    let folder = Folder::new();
    for function in
        ["spherical-harmonic", "wigner-d", "zernike-radial", "polar-integral", "irradiance-mode"]
    {
        let name = format!("{}.csv", function.replace('-', "_"));
        let vectors = repository().join("crates/generator/tests/vectors").join(name);
        let given = fs::read_to_string(&vectors).unwrap();
        let header = given.lines().next().unwrap();
        let text = folder.ok(&format!("evaluate {function} {}", vectors.display()));
        let (ours, given) = (rows(&text, header), rows(&given, header));
        assert_eq!(ours.len(), given.len());
        for (ours, given) in ours.iter().zip(&given) {
            let last = given.len() - 1;
            assert_eq!(ours[..last], given[..last]);
            let [a, b] = [ours, given].map(|row| row[last].parse::<f64>().unwrap());
            // C itself grows without bound.
            let scale = if function == "polar-integral" { b.abs().max(1.0) } else { 1.0 };
            assert!(
                (a - b).abs() <= tolerances::SPECIAL_HIGH * scale,
                "{function}: {given:?}: {a}"
            );
        }
    }
}

#[test]
fn evaluate_keeps_other_columns() {
    let folder = Folder::new();
    folder.write("p.csv", "# points\nnote,rho,value,q,o\na,0.5,9,0,2\n\"b,c\",1,9,2,2\n");
    let text = folder.ok("evaluate zernike-radial p.csv");
    assert_eq!(text, "note,rho,q,o,value\na,0.5,0,2,-0.5\n\"b,c\",1,2,2,1\n");
}
