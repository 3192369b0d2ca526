//! Difficult inputs of users: normals of 8 bits and behind the rim, a sun, and a light that rings.
//! Images of the shipped table are compared with its sums in f64, component by component.

use super::maps::harmonics;
use super::{Figure, exactly, least, most};
use crate::tolerances;
use eigenshade::mathematics::Libm;
use eigenshade::{MapPoint, NegativePolicy, Normal, Normals, Q15, Tolerance, quantized, sphere};
use eigenshade_model::database::Named;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::shipped;
use eigenshade_table::{Table, decode};
use eigenshade_testing::fixtures::{ROOT, captured};
use eigenshade_testing::images::{coefficients, single};
use eigenshade_testing::largest;
use std::f64::consts::PI;

/// The shipped materials, every `step`-th.
fn materials(step: usize) -> Vec<Vec<f64>> {
    let materials = shipped::materials().expect("the shipped materials").truncated(7);
    materials.entries.iter().step_by(step).map(Named::luminance).collect()
}

/// Unit normals of a picture of a sphere.
fn disc(across: i32) -> Vec<[f64; 3]> {
    let place = |k: i32| f64::from(2 * k + 1) / f64::from(across) - 1.0;
    let pixels = (0..across).flat_map(|j| (0..across).map(move |k| (place(k), place(j))));
    let visible = pixels.filter(|(x, y)| x * x + y * y <= 1.0);
    visible.map(|(x, y)| [x, y, (1.0 - x * x - y * y).sqrt()]).collect()
}

/// Normals and weights that integrate squares of images over a sphere's normals.
fn quadrature() -> (Vec<[f64; 3]>, Vec<f64>) {
    let at = |(z, weight): (f64, f64)| {
        (0..40).map(move |k| {
            let (sine, cosine) = (PI * f64::from(k) / 20.0).sin_cos();
            let root = (1.0 - z * z).sqrt();
            ([root * cosine, root * sine, z], 2.0 * z * weight / 40.0)
        })
    };
    gauss_legendre(48, 0.0, 1.0).into_iter().flat_map(at).unzip()
}

/// The shipped table in f64 at some normals.
struct Reference {
    table: Table,
    normals: Vec<Normal<f64>>,
}

impl Reference {
    fn new(normals: &[[f64; 3]]) -> Self {
        let normals = OwnedNormals::new(normals).each().expect("visible normals");
        Self { table: decode(shipped::TABLE).expect("the shipped table"), normals }
    }

    fn image(&self, light: &[f64], material: &[f64]) -> Vec<f64> {
        let owned = OwnedBasis::<f64>::new(&self.table);
        let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
        shader.eigen((9, light), (7, material), &self.normals).expect("coefficients")
    }
}

/// A scene in f32 with the same light on the same material.
fn scene(light: &[f64], material: &[f64]) -> (sphere::Coefficients, sphere::Scene) {
    let d = coefficients(&single(light.to_vec()), &single(material.to_vec()));
    let scene = sphere::collapse(&d).expect("it fits");
    (d, scene)
}

/// An image in integers: mantissas and their common unit.
type Integers = (Vec<i32>, f64);

fn floats((mantissas, unit): &Integers) -> Vec<f64> {
    mantissas.iter().map(|&mantissa| f64::from(mantissa) * unit).collect()
}

fn in_integers(normal: [f64; 3]) -> quantized::Normal<Q15> {
    let [x, y, z] = normal.map(|c| (c * f64::from(i32::MAX)) as i32);
    quantized::Normal::along(x, y, z).expect("a direction")
}

/// The image in Q15, at normals that are rounded to Q15.
fn integers(light: &[f64], material: &[f64], normals: &[[f64; 3]]) -> Integers {
    let (light, material) = (single(light.to_vec()), single(material.to_vec()));
    let (mut of_light, mut of_material, mut exponents) = ([Q15(0); 100], [Q15(0); 40], [0; 8]);
    let light = quantized::Light::quantize(&light, &mut of_light).expect("a light");
    let material = quantized::Material::quantize(&material, &mut of_material, &mut exponents);
    let folded = sphere::q15::transfer(&material.expect("a material")).expect("it fits");
    let d = sphere::q15::relight(&folded.view(), &light).expect("it fits");
    let scene = sphere::q15::collapse(&d).expect("it fits");
    let seen = |normal: &[f64; 3]| scene.shade(in_integers(*normal));
    (normals.iter().map(seen).collect(), 2f64.powi(scene.exponent()))
}

/// Shaded at decoded 8-bit normals, as they are or scaled to length 1.
pub(super) fn eight_bits() -> Vec<Figure> {
    let normals = disc(64);
    let decode = |c: f64| f64::from(2 * ((c + 1.0) * 127.5).round() as i32 - 255);
    let decoded: Vec<[f64; 3]> = normals.iter().map(|normal| normal.map(decode)).collect();
    let length = |[x, y, z]: [f64; 3]| (x * x + y * y + z * z).sqrt();
    let scaled: Vec<[f64; 3]> = decoded.iter().map(|&v| v.map(|c| c / length(v))).collect();
    let raw =
        [0, 1, 2].map(|axis| decoded.iter().map(|v| v[axis] as f32 / 255.0).collect::<Vec<f32>>());
    let mut normalized = raw.clone();
    let [x, y, z] = &mut normalized;
    Normals::normalized::<Libm>(x, y, z).expect("visible");
    let shaded = |scene: &sphere::Scene, [x, y, z]: &[Vec<f32>; 3]| -> Vec<f64> {
        let mut irradiance = vec![0.0; x.len()];
        let normals = Normals::new(x, y, z).expect("one length");
        scene.shade_slice(normals, &mut irradiance).expect("one length");
        irradiance.into_iter().map(f64::from).collect()
    };
    let reference = Reference::new(&normals);
    let (mut naive, mut ours, mut of_integers) = (Vec::new(), Vec::new(), Vec::new());
    let mut point = 0.0;
    for light in captured(9).entries.iter().step_by(3) {
        for material in materials(5) {
            let light = light.luminance();
            let expected = reference.image(&light, &material);
            let peak = largest(expected.iter().copied());
            let apart = |found: &[f64]| found.iter().zip(&expected).map(|(a, b)| a - b).collect();
            let rms = |apart: &Vec<f64>| {
                (apart.iter().map(|e| e * e).sum::<f64>() / apart.len() as f64).sqrt() / peak
            };
            let (_, scene) = scene(&light, &material);
            naive.push(rms(&apart(&shaded(&scene, &raw))));
            let error = apart(&shaded(&scene, &normalized));
            ours.push(rms(&error));
            point = largest([point, largest(error) / peak]);
            of_integers.push(rms(&apart(&floats(&integers(&light, &material, &scaled)))));
        }
    }
    let [(_, naive), ours, of_integers] = [naive, ours, of_integers].map(|mut errors| {
        errors.sort_by(f64::total_cmp);
        (errors[errors.len() / 2], errors[errors.len() - 1])
    });
    let [median, worst, pixel] = tolerances::EIGHT_BITS;
    vec![
        least("not scaled: rms of the peak, worst", naive, 2.5e-3),
        most("scaled: rms of the peak, median", ours.0, median),
        most("scaled: rms of the peak, worst", ours.1, worst),
        most("scaled: worst pixel, of the peak", point, pixel),
        most("scaled, Q15: rms of the peak, median", of_integers.0, median),
        most("scaled, Q15: rms of the peak, worst", of_integers.1, worst),
    ]
}

/// Normals with z = -0.01 and -0.1, by a table of degree 12, whose polynomials are longer than
/// those of the shipped table.
pub(super) fn behind() -> Vec<Figure> {
    let bytes = std::fs::read(format!("{ROOT}/tables/pbr.bin")).expect("the table");
    let owned = OwnedBasis::<f32>::new(&decode(&bytes).expect("a table"));
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let light = captured(9).entries[5].luminance();
    let (mut naive, mut ours, mut of_integers) = ([0.0f64; 2], 0.0f64, 0u16);
    for material in materials(7) {
        shader.project((9, &light), (7, &material)).expect("coefficients");
        let scene = shader.scene().expect("room");
        let seen = |normal: [f64; 3]| {
            let [x, y, z] = normal.map(|c| [c as f32]);
            let normals = Normals::new(&x, &y, &z).expect("one length");
            let as_it_is = normals.iter().next().expect("one normal");
            let moved = Normal::new(x[0], y[0], z[0]).expect("moved to the rim");
            [as_it_is, moved].map(|normal| f64::from(scene.shade(normal)))
        };
        for turn in 0..16 {
            let (sine, cosine) = (PI * f64::from(turn) / 8.0).sin_cos();
            let [rim, _] = seen([cosine, sine, 0.0]);
            for (z, naive) in [-0.01, -0.1].into_iter().zip(&mut naive) {
                let root = (1.0f64 - z * z).sqrt();
                let normal = [cosine * root, sine * root, z];
                let [as_it_is, moved] = seen(normal);
                *naive = naive.max((as_it_is / rim).abs());
                ours = ours.max((moved / rim - 1.0).abs());
                let [at_rim, moved] =
                    [[cosine, sine, 0.0], normal].map(|one| in_integers(one).components());
                let apart = at_rim.iter().zip(&moved).map(|(a, b)| a.0.abs_diff(b.0));
                of_integers = of_integers.max(apart.max().expect("three"));
            }
        }
    }
    vec![
        least("z = -0.01 as it is, relative to the rim", naive[0], 1.01),
        least("z = -0.1 as it is, relative to the rim", naive[1], 1.5),
        // An image's slope times an f32 rounding.
        most("moved to the rim, relative error", ours, 5e-6),
        most("in Q15, units of a component", of_integers.into(), 1.0),
    ]
}

/// An image by each method, and the bound of the scene within a tolerance.
struct Methods {
    f32: Vec<f64>,
    q15: Integers,
    within: Vec<f64>,
    bound: f64,
    baked: Vec<f64>,
    map: Integers,
}

fn every_method(light: &[f64], material: &[f64], normals: &[[f64; 3]]) -> Methods {
    let (d, scene) = scene(light, material);
    let visible = OwnedNormals::<f32>::new(normals).each().expect("visible normals");
    let each = |shade: &dyn Fn(Normal<f32>) -> f32| -> Vec<f64> {
        visible.iter().map(|&normal| shade(normal).into()).collect()
    };
    let mut lengths = [0; sphere::DEGREE + 1];
    let (within, report) = sphere::BASIS
        .collapse_within(&d, Tolerance::OfPeak(1e-2), &mut lengths, [0.0; sphere::SCENE])
        .expect("sizes");
    let baked = scene.bake_into(64, vec![0.0f32; 64 * 64]).expect("sizes");
    let map = scene.bake_integers_into(64, vec![0; 64 * 64]).expect("numbers that fit");
    let point = |normal: &[f64; 3]| MapPoint::of_quantized(in_integers(*normal));
    let of_map = normals.iter().map(|normal| map.bilinear(point(normal))).collect();
    Methods {
        f32: each(&|normal| scene.shade(normal)),
        q15: integers(light, material, normals),
        within: each(&|normal| within.shade(normal)),
        bound: report.bound.into(),
        baked: each(&|normal| baked.bilinear(MapPoint::of(normal))),
        map: (of_map, 2f64.powi(map.exponent())),
    }
}

/// A texel of a map of 64 x 32 with radiance 1e6, in a sky of radiance 1, on shipped materials.
pub(super) fn sun() -> Vec<Figure> {
    let (normals, weights) = quadrature();
    let rms = |found: &[f64], expected: &[f64]| {
        let squares = found.iter().zip(expected).map(|(a, b)| (a - b).powi(2));
        squares.zip(&weights).map(|(square, weight)| square * weight).sum::<f64>().sqrt()
    };
    let reference = Reference::new(&normals);
    let mut worst = [0.0f64; 5];
    for direction in [[0.6, 0.0, 0.8], [-0.48, 0.6, 0.64], [0.0, 0.96, -0.28]] {
        let mut light = harmonics(9, direction);
        light.iter_mut().for_each(|value| *value *= 1e6 * 9.6e-3);
        light[0] += (4.0 * PI).sqrt();
        for material in materials(3) {
            let expected = reference.image(&light, &material);
            let peak = largest(expected.iter().copied());
            let all = every_method(&light, &material, &normals);
            let [of_f32, of_q15, of_baked, of_map] =
                [&all.f32, &floats(&all.q15), &all.baked, &floats(&all.map)]
                    .map(|found| rms(found, &expected) / peak);
            let of_bound = rms(&all.within, &expected) / all.bound;
            for (worst, found) in worst.iter_mut().zip([of_f32, of_q15, of_bound, of_baked, of_map])
            {
                *worst = worst.max(found);
            }
        }
    }
    let [of_f32, of_q15, of_bound, of_baked, of_map] = worst;
    vec![
        // As for any light.
        most("f32, rms of the peak", of_f32, 1e-6),
        // The worst pair has 68 dB.
        most("Q15, rms of the peak", of_q15, 4e-4),
        // Images are some thousand times the error, so that rounding may exceed the bound.
        most("within 1e-2: rms, of the reported bound", of_bound, 1.0001),
        // Twice the worst error of the shipped lights.
        most("baked, 64 x 64, rms of the peak", of_baked, 1e-3),
        most("baked in integers, rms of the peak", of_map, 1e-3),
    ]
}

/// Lobes below zero of a light from one direction, to degree 9.
pub(super) fn delta() -> Vec<Figure> {
    let normals = disc(64);
    let reference = Reference::new(&normals);
    let light = harmonics(9, [0.6, 0.0, 0.8]);
    let (mut deepest, mut apart, mut left) = (0.0f64, [0.0f64; 5], 0);
    for material in materials(3) {
        let expected = reference.image(&light, &material);
        let peak = largest(expected.iter().copied());
        let below = expected.iter().copied().fold(f64::INFINITY, f64::min);
        deepest = deepest.max(-below / peak);
        let all = every_method(&light, &material, &normals);
        let found = [all.f32, floats(&all.q15), all.within, all.baked, floats(&all.map)];
        for (apart, mut found) in apart.iter_mut().zip(found) {
            let lowest = NegativePolicy::Clamped.apply(&mut found).expect("pixels");
            *apart = apart.max((lowest - below).abs() / peak);
            left += found.iter().filter(|&&value| value < 0.0).count();
        }
        for (mut mantissas, _) in [all.q15, all.map] {
            let lowest = NegativePolicy::Clamped.apply(&mut mantissas).expect("pixels");
            assert_eq!(lowest < 0, mantissas.contains(&0), "a value below zero became zero");
            left += mantissas.iter().filter(|&&value| value < 0).count();
        }
    }
    let mut figures = vec![least("least value, below zero, of the peak", deepest, 5e-2)];
    let methods = ["f32", "Q15", "a scene within 1e-2", "a map of 64 x 64", "a map of integers"];
    for ((method, apart), bound) in methods.into_iter().zip(apart).zip(tolerances::DELTA) {
        figures.push(most(format!("its error by {method}, of the peak"), apart, bound));
    }
    figures.push(exactly("values below zero that clamping left", left, 0));
    figures
}
