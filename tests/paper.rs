//! The paper's direct sum and principal components, checked on the shipped databases.

use crate::{oracle, tolerances};
use eigenshade_generator::basis::gram;
use eigenshade_generator::basis::moments::{self, LightMoments, MaterialMoments};
use eigenshade_generator::basis::pca::{Block, principal};
use eigenshade_model::database::Named;
use eigenshade_model::irradiance::slant_rotation;
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::scene::Normalize;
use eigenshade_table::{GramFactor, light, material, mode};
use eigenshade_testing::fixtures::{self, direct_images, shipped};
use eigenshade_testing::{largest, relative_error};
use std::f64::consts::{FRAC_PI_2, PI};

/// Eigenvalues of +m and -m, of the largest: the same numbers by another way.
const EQUAL_EIGENVALUES: f64 = 2e-15;

#[test]
fn the_direct_sum_is_the_integral() {
    let loaded = shipped("curet");
    let reference = DirectSum::new(9, 7);
    let picture: Vec<_> = grid(20, 40).into_iter().map(|normal| reference.at(normal)).collect();
    let mut numbers = oracle::Numbers(1);
    let mut worst: f64 = 0.0;
    for case in 0..200 {
        // Half of the pairs are of the database, half are noise.
        let pick = |entries: &[Named], numbers: &mut oracle::Numbers| {
            entries[(numbers.next().abs() * entries.len() as f64) as usize].luminance()
        };
        let mut light = pick(&loaded.lights.entries, &mut numbers);
        let mut material = pick(&loaded.materials.entries, &mut numbers);
        if case % 2 == 1 {
            light.iter_mut().for_each(|value| *value = numbers.next());
            material.iter_mut().for_each(|value| *value = numbers.next());
        }
        let tilt = PI * numbers.next();
        let near = |slant: f64| [slant.sin() * tilt.cos(), slant.sin() * tilt.sin(), slant.cos()];
        let normal = match case % 10 {
            0 => [0.0, 0.0, 1.0],
            1 => near(1e-9),
            2 => [tilt.cos(), tilt.sin(), 0.0],
            3 => near(FRAC_PI_2 - 1e-9),
            _ => numbers.normal(),
        };
        let explicit: Vec<_> =
            material::indices(7).zip(&material).map(|((o, p, q), b)| (o, p, q, *b)).collect();
        let expected = oracle::irradiance(&oracle::ExplicitLight::new(&light), &explicit, normal);
        let modes = reference.at(normal);
        let found = modes.irradiance(&light, &modes.scatter(&material));
        let peak = largest(
            picture.iter().map(|modes| modes.irradiance(&light, &modes.scatter(&material))),
        );
        worst = worst.max((found - expected).abs() / peak);
    }
    println!("direct sum against quadrature: {worst:.1e} of the peak");
    assert!(worst <= tolerances::DIRECT_SUM, "{worst}");
}

/// Normals from the pole to the rim.
fn grid(slants: usize, tilts: usize) -> Vec<[f64; 3]> {
    let mut normals = Vec::new();
    for slant in 0..slants {
        let (sine, z) = (FRAC_PI_2 * slant as f64 / (slants - 1) as f64).sin_cos();
        for tilt in 0..tilts {
            let (y, x) = (2.0 * PI * tilt as f64 / tilts as f64).sin_cos();
            normals.push([sine * x, sine * y, z.max(0.0)]);
        }
    }
    normals
}

#[test]
fn all_components_in_f32_are_the_direct_sum() {
    let loaded = shipped("curet");
    let table = fixtures::table(&loaded);
    let owned = OwnedBasis::new(&table).expect("a table for f32");
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    // The device is given the reference's input, rounded.
    let rounded = |normal: [f64; 3]| normal.map(|x| f64::from(x as f32));
    let normals: Vec<_> = grid(14, 24).into_iter().map(rounded).collect();
    let rounded = OwnedNormals::new(&normals);
    let images = direct_images(&loaded.lights, &loaded.materials, &normals);
    let worst = largest(images.iter().map(|(light, material, expected)| {
        let found = shader.polynomial(light, material, &rounded).expect("it fits");
        relative_error(&found.into_iter().map(f64::from).collect::<Vec<_>>(), expected)
    }));
    println!("{} components in f32: {worst:.2e} of the peak", table.count());
    assert!(worst <= tolerances::POLYNOMIAL_F32, "{worst}");
}

/// The blocks of -m, built from D_l^-m,q itself, have the eigenvalues of +m.
#[test]
fn signs_of_m_have_equal_eigenvalues() {
    let loaded = shipped("curet");
    let light = LightMoments::new(&loaded.lights, Normalize::UnitAmbient).expect("positive lights");
    let material = MaterialMoments::new(&loaded.materials);
    let plus = gram::of_sphere(9, 7);
    let minus = GramFactor { rotations: negative_rotations(&plus), ..plus.clone() };
    assert_ne!(plus.rotations, minus.rotations);
    let (mut worst, mut largest) = (0.0f64, 0.0f64);
    for azimuth in 1..=9 {
        let criterion = loaded.scene.basis.criterion;
        let deviations = moments::deviations(&light, &material, criterion, azimuth);
        let values = |gram: &GramFactor| {
            let block = Block::new(gram, azimuth, &|_, _, _, _| true).expect("finite");
            let images = block.images(gram, &deviations);
            principal(&images, None, azimuth).expect("finite").singular_values
        };
        for (plus, minus) in values(&plus).iter().zip(values(&minus)) {
            largest = largest.max(plus * plus);
            worst = worst.max((plus * plus - minus * minus).abs());
        }
    }
    println!("eigenvalues of +m and -m: {:.1e} of the largest", worst / largest);
    assert!(worst <= EQUAL_EIGENVALUES * largest);
}

/// D_l^-m,q / Φ_-m at the nodes, in the layout of [`GramFactor::rotations`].
fn negative_rotations(gram: &GramFactor) -> Vec<f64> {
    let mut values = Vec::new();
    for azimuth in 0..=gram.degree {
        for l in azimuth..=gram.degree {
            for q in 0..=l.min(gram.order) {
                for z in &gram.nodes {
                    let column = slant_rotation(l, -azimuth.cast_signed(), q, z.acos());
                    values.push(*column.last().expect("|m| and q are at most l"));
                }
            }
        }
    }
    values
}

/// W is orthonormal, and UᵀM in factors is UᵀM by multiplication: U through A, then M = AᵀA.
#[test]
fn factored_rows_are_the_products() {
    let table = fixtures::table(&shipped("curet"));
    assert!(table.components.len() >= 100);
    let mut apart: f64 = 0.0;
    for (i, a) in table.profiles.iter().enumerate() {
        for (j, b) in table.profiles.iter().enumerate().take(i + 1) {
            if a.azimuth == b.azimuth {
                let pairs = a.node_values.iter().zip(&b.node_values);
                let product: f64 = pairs.map(|(a, b)| a * b).sum();
                apart = apart.max((product - f64::from(u8::from(i == j))).abs());
            }
        }
    }
    println!("|WᵀW - I| {apart:.1e} on {}", table.profiles.len());
    assert!(apart <= tolerances::ORTHONORMAL_NODES, "{apart}");
    let mut worst: f64 = 0.0;
    for profile in &table.profiles {
        let columns = table.gram.columns(profile.azimuth);
        let row = table.gram_row(profile);
        assert_eq!(row.len(), mode::count(9, 7, profile.azimuth));
        for (column, entry) in columns.iter().zip(row) {
            let product: f64 = column.iter().zip(&profile.node_values).map(|(a, w)| a * w).sum();
            worst = worst.max((product - entry).abs());
        }
    }
    println!("rows of UᵀM: {worst:.1e}");
    assert!(worst <= tolerances::ORTHONORMAL_NODES);
    assert_eq!(light::count(9), 100);
}
