//! Images against the direct sum over modes, and the errors of few components.

use crate::support::{Folder, PAIR, difference};
use crate::tolerances;
use eigenshade_cli::picture::SphereView;
use eigenshade_model::database::Named;
use eigenshade_model::{reference_image, shipped};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fitted};
use eigenshade_testing::{assert_recorded, fixtures};

/// Pictures under a light turned with its normals against those as they were, of the peak: sums of
/// 25 terms, and angles of 16 digits.
const ROTATED_LIGHT: f64 = 2e-15;

/// R = Rz(A) Ry(B) Rz(C) rotates the light: under Rz alone, and under a quarter turn about y.
#[test]
fn the_light_rotates() {
    let folder = Folder::with_table();
    let (sine, cosine) = 0.7_f64.sin_cos();
    let turn = |line: &str| {
        let n: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        format!("{},{},{}\n", cosine * n[0] - sine * n[1], sine * n[0] + cosine * n[1], n[2])
    };
    let turned: String = folder.read("normals.csv").lines().skip(1).map(turn).collect();
    folder.write("turned.csv", format!("x,y,z\n{turned}"));
    let straight = folder.shaded("--method modes");
    for rotation in ["0.7,0,0", "0,0,0.7", "1.0,0,-0.3", "0.7,-0,0"] {
        let turned = folder.irradiance(&format!(
            "--table b.bin {PAIR} --normals turned.csv --method modes --rotate {rotation}"
        ));
        assert!(difference(&turned, &straight) < ROTATED_LIGHT, "{rotation}");
    }
    // A light of degree 1, L_1^1 alone, is -x; Ry(pi/2) brings x to -z, so it is z: L_1^0 = -1.
    let light =
        |m0: f64, m1: f64| format!("name,l,m,value\na,0,0,4\na,1,-1,0\na,1,0,{m0}\na,1,1,{m1}\n");
    folder.write("lights.csv", light(0.0, 1.0));
    let turned = folder.shaded("--rotate 0,1.5707963267948966,0 --method modes");
    folder.write("lights.csv", light(1.0, 0.0));
    assert!(difference(&turned, &folder.shaded("--method modes")) < ROTATED_LIGHT);
}

/// As [`tolerances::RECORDED`], for rounding errors of f32, which differ by a half where
/// multiplication and addition are fused.
const RECORDED_ROUNDING: f64 = 0.5;

/// Components of the shipped table.
const SHIPPED: usize = 46;

/// With these, the median and the worst picture's largest error where
/// n_z > 0.3, in per cent of the peak.
const FARTHER_IN: [&str; 2] = ["2.4", "19.2"];

/// With these, rms and largest error of each shown material under
/// each shown light, in per cent of the peak.
const OF_MATERIALS: [[f64; 8]; 7] = [
    [0.21, 2.9, 0.39, 9.0, 0.43, 5.9, 0.49, 5.6],
    [0.18, 0.95, 0.29, 4.8, 0.24, 1.5, 0.50, 2.4],
    [0.37, 2.6, 0.70, 17.0, 0.30, 2.0, 0.80, 6.2],
    [0.48, 2.5, 0.47, 12.0, 0.25, 1.9, 1.00, 6.9],
    [0.32, 1.9, 0.32, 5.7, 0.36, 1.8, 0.59, 3.6],
    [0.51, 3.4, 0.44, 5.7, 0.48, 2.4, 1.3, 7.1],
    [2.2, 14.0, 0.47, 5.0, 1.4, 6.9, 3.8, 19.0],
];

/// Components of the shipped scene, the last all of them, and over the same pictures the median and
/// the worst rms, the median and the worst largest error, of the peak.
const OF_COMPONENTS: [(usize, [f64; 4]); 6] = [
    (9, [3.1e-2, 0.11, 0.21, 0.67]),
    (25, [1.0e-2, 7.7e-2, 8.6e-2, 0.46]),
    (SHIPPED, [4.7e-3, 3.8e-2, 5.0e-2, 0.19]),
    (100, [4.1e-4, 3.3e-3, 3.8e-3, 1.3e-2]),
    (160, [6.3e-7, 2.8e-6, 6.2e-6, 3.3e-5]),
    (218, [5.0e-8, 7.3e-8, 2.3e-7, 4.6e-7]),
];

/// Median, the mean of the middle two if their number is even, and maximum.
fn median_and_worst(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    let middle = [errors[(errors.len() - 1) / 2], errors[errors.len() / 2]];
    [0.5 * (middle[0] + middle[1]), errors[errors.len() - 1]]
}

#[test]
fn errors_of_few_components_are_as_recorded() {
    let chosen = |entries: &[Named], names: &[&str]| {
        let of = |name: &&str| entries.iter().find(|entry| entry.name == **name).unwrap().clone();
        names.iter().map(of).collect::<Vec<_>>()
    };
    let loaded = fixtures::shipped("sphere");
    let table = fixtures::table(&loaded);
    let all_materials = shipped::named_materials(7).unwrap();
    let (mut lights, mut materials) = fitted(&table, &loaded.lights, &all_materials);
    lights.entries = chosen(&lights.entries, &shipped::SHOWN_LIGHTS);
    materials.entries = chosen(&materials.entries, &shipped::SHOWN_MATERIALS);

    let mut view = SphereView::new(64);
    let mut inside = view.pixels.iter().map(|pixel| pixel.is_inside);
    view.normals.retain(|_| inside.next() == Some(true));
    let normals = OwnedNormals::new(&view.normals);
    let reference = reference_image::images(&lights, &materials, &view.normals, &());
    let basis = OwnedBasis::new(&table).expect("a table for f32");
    let all = table.count();
    assert_eq!(all, OF_COMPONENTS[5].0);
    assert_eq!(eigenshade_table::decode(shipped::TABLE).unwrap().count(), SHIPPED);
    for (components, recorded) in OF_COMPONENTS {
        let mut shader = Shader::new(basis.basis().unwrap(), components);
        let (mut rms, mut largest, mut inner) = (Vec::new(), Vec::new(), Vec::new());
        for light in &lights.entries {
            for material in &materials.entries {
                let ours = shader.color(light, material, &normals).unwrap();
                let (mut squares, mut most, mut peak, mut farther_in) = (0.0, 0f64, 0f64, 0f64);
                for (k, of_pairs) in reference.iter().enumerate() {
                    for (ours, reference) in ours.iter().zip(of_pairs[rms.len()]) {
                        let error = f64::from(ours[k]) - reference;
                        squares += error * error;
                        most = most.max(error.abs());
                        if view.normals[k][2] > 0.3 {
                            farther_in = farther_in.max(error.abs());
                        }
                        peak = peak.max(reference.abs());
                    }
                }
                rms.push((squares / (3.0 * reference.len() as f64)).sqrt() / peak);
                largest.push(most / peak);
                inner.push(farther_in / peak);
            }
        }
        if components == SHIPPED {
            for (k, (material, recorded)) in materials.entries.iter().zip(&OF_MATERIALS).enumerate()
            {
                let of_material = rms.iter().zip(&largest).skip(k).step_by(materials.entries.len());
                let found: Vec<f64> =
                    of_material.flat_map(|(rms, most)| [100.0 * rms, 100.0 * most]).collect();
                assert_recorded(&material.name, &found, recorded, tolerances::RECORDED);
            }
            let found = median_and_worst(inner).map(|error| format!("{:.1}", 100.0 * error));
            assert_eq!(found, FARTHER_IN);
        }
        let found = [median_and_worst(rms), median_and_worst(largest)].concat();
        let tolerance = if components == all { RECORDED_ROUNDING } else { tolerances::RECORDED };
        assert_recorded(&format!("{components} components"), &found, &recorded, tolerance);
    }
}
