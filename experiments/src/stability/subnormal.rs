//! The share of f32 numbers that are subnormal when the light is at 1e-30, and the time that they
//! take.

use super::{Figure, exactly, most, report};
use crate::accuracy_cost::times::least;
use crate::tolerances;
use eigenshade::{Light, Material, sphere};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_testing::fixtures::{self, disc};
use eigenshade_testing::images::{coefficients, single};
use eigenshade_testing::oracle::Numbers;
use std::hint::black_box;

/// 2^-100 = 8e-31.
const FAR: f32 = 7.888_609e-31;

/// Number of subnormal values.
fn subnormal(values: &[f32]) -> usize {
    values.iter().filter(|value| value.is_subnormal()).count()
}

/// Share of the nonzero products that are subnormal.
fn share(products: &[f32]) -> f64 {
    let nonzero = products.iter().filter(|&&product| product != 0.0).count();
    subnormal(products) as f64 / nonzero as f64
}

/// The products of a linear map, which is given by its answers to unit vectors.
fn products_of_map(values: &[f32], map: impl Fn(&[f32]) -> Vec<f32>) -> Vec<f32> {
    let mut products = Vec::new();
    for (k, value) in values.iter().enumerate() {
        let mut unit = vec![0.0; values.len()];
        unit[k] = 1.0;
        products.extend(map(&unit).iter().map(|factor| factor * value));
    }
    products
}

/// A pixel and its products: first with its azimuths by Horner's rule, as the shipped table uses
/// them, then with the powers of n_x + i n_y, as any table does.
fn products_of_pixel(mut terms: &[f32], [x, y, z]: [f32; 3]) -> [(f32, Vec<f32>); 2] {
    let mut products = Vec::new();
    let times = |products: &mut Vec<f32>, a: f32, b: f32| {
        products.push(a * b);
        a * b
    };
    // The highest term of a polynomial comes first.
    let mut polynomial = |length: u16| {
        let (polynomial, rest) = terms.split_at(length.into());
        terms = rest;
        let next = |sum, term| times(&mut products, sum, 2.0 * z - 1.0) + term;
        polynomial.iter().copied().reduce(next).unwrap_or(0.0)
    };
    let of_azimuth = |(m, &length): (usize, &u16)| {
        [polynomial(length), if m == 0 { 0.0 } else { polynomial(length) }]
    };
    let lengths = sphere::BASIS.parts().lengths;
    let azimuths: Vec<[f32; 2]> = lengths.iter().enumerate().map(of_azimuth).collect();
    let (mut horner, mut powers) = (products.clone(), products);
    let [pixel, _] = azimuths.iter().rev().fold([0.0; 2], |[real, imaginary], [plus, minus]| {
        let mut times = |a, b| times(&mut horner, a, b);
        [plus + times(real, x) + times(imaginary, y), minus + times(imaginary, x) - times(real, y)]
    });
    let (mut cosine, mut sine, mut sum) = (1.0, 0.0, 0.0);
    for [plus, minus] in azimuths {
        let mut times = |a, b| times(&mut powers, a, b);
        sum += times(plus, cosine) + times(minus, sine);
        (cosine, sine) = (times(cosine, x) - times(sine, y), times(cosine, y) + times(sine, x));
    }
    [(pixel, horner), (sum, powers)]
}

/// The time with the first input relative to that with the second.
fn time<T>([first, second]: [&T; 2], task: impl Fn(&T)) -> f64 {
    let works: Vec<Box<dyn FnMut() + '_>> =
        vec![Box::new(|| task(black_box(first))), Box::new(|| task(black_box(second)))];
    let times = least(works, 100);
    times[0] / times[1]
}

pub(super) fn measure() -> Vec<Figure> {
    let on = fixtures::materials(7, 1, &mut Numbers(42)).entries[0].luminance();
    let light = fixtures::lights(9, 1, &mut Numbers(43)).entries[0].luminance();
    let (material, plain) = (single(on.clone()), single(light));
    let tiny: Vec<f32> = plain.iter().map(|value| value * FAR).collect();
    let transfer = Material::new(&material).expect("coefficients");
    let transfer = sphere::transfer(&transfer).expect("it fits");
    let relit = |light: &[f32]| {
        sphere::relight(&transfer, &Light::new(light).expect("coefficients")).expect("it fits")
    };
    // The terms of all polynomials of an image.
    let terms = |d: &[f32]| {
        let mut terms = vec![0.0; sphere::SCENE];
        sphere::BASIS.collapse_into(d, &mut terms[..]).expect("sizes");
        terms
    };
    let normals = disc(48);
    let rounded_normals = OwnedNormals::<f32>::new(&normals);
    let each = rounded_normals.each().expect("visible normals");
    let shaded = |scene: &sphere::Scene| -> Vec<f32> {
        each.iter().map(|&normal| sphere::shade(scene, normal)).collect()
    };
    let [d, of_plain] = [&tiny, &plain].map(|light| relit(light));
    let scenes = [&d, &of_plain].map(|d| sphere::collapse(d).expect("it fits"));
    let [pixels, scaled] = scenes.each_ref().map(shaded);
    let (of_image, of_plain_image) = (terms(&d), terms(&of_plain));
    let largest = of_image.iter().fold(0.0f32, |most, term| most.max(term.abs()));
    let [mut horner, mut powers, mut of_scaled] = [const { Vec::new() }; 3];
    for (normal, expected) in normals.iter().zip(&pixels) {
        let normal = normal.map(|c| c as f32);
        let both = [&mut horner, &mut powers].into_iter();
        for (all, (found, products)) in both.zip(products_of_pixel(&of_image, normal)) {
            // Confirms that the counted operations are those of the pixel.
            assert!((found - expected).abs() <= tolerances::SAME_SUM_F32 * largest);
            all.extend(products);
        }
        let [(_, by_horner), _] = products_of_pixel(&of_plain_image, normal);
        of_scaled.extend(by_horner);
    }
    let of_light = products_of_map(&tiny, |unit| relit(unit).to_vec());
    let other = pixels.iter().zip(&scaled).filter(|(a, b)| **a != **b * FAR).count();
    // All components of the shipped scene.
    let owned = OwnedBasis::<f32>::new(&fixtures::table(&fixtures::shipped()));
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let far: Vec<f64> = tiny.iter().copied().map(f64::from).collect();
    let all = shader.project((9, &far), (7, &on)).expect("coefficients");

    let of_relight = time([&tiny, &plain], |light| drop(black_box(relit(light))));
    let of_project = time([&tiny, &plain], |light| drop(black_box(coefficients(light, &material))));
    let of_collapse = time([&d, &of_plain], |d| drop(black_box(sphere::collapse(d))));
    let of_shade = time(scenes.each_ref(), |scene| drop(black_box(shaded(scene))));
    let of_components = subnormal(all) as f64 / all.len() as f64;
    vec![
        exactly("subnormal coefficients", subnormal(&d), 0),
        exactly("subnormal terms", subnormal(&of_image), 0),
        exactly("subnormal pixels", subnormal(&pixels), 0),
        most("subnormal products in relighting, of all", share(&of_light), 0.0),
        most("subnormal products in collapsing", share(&products_of_map(&d, terms)), 0.0),
        // The highest terms are 1e-7 of the strongest, and t and n_x are small somewhere: 0.7 %.
        most("subnormal products in shading", share(&horner), 0.02),
        most("subnormal products in shading by powers", share(&powers), 0.02),
        // Those with amplitudes weaker than 1e-8 of the strongest.
        most("subnormal coefficients of all components, of all", of_components, 0.5),
        most("subnormal products in shading, light scaled to 1", share(&of_scaled), 0.0),
        exactly("pixels that differ in a bit, scaled back", other, 0),
        report("time of relighting, relative to light at 1", of_relight),
        report("time of projecting", of_project),
        report("time of collapsing", of_collapse),
        report("time of shading", of_shade),
    ]
}
