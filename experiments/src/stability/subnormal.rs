//! The share of f32 numbers that are subnormal when the light is at 1e-30, and the time that they
//! take.

use super::{Figure, exactly, most, report};
use crate::tolerances;
use eigenshade::{Light, Material, Normal, sphere};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_testing::fixtures;
use eigenshade_testing::images::{coefficients, single};
use eigenshade_testing::oracle::Numbers;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// 2^-100 = 8e-31.
const FAR: i32 = -100;

/// Unit normals of a picture of a sphere, 48 pixels wide.
fn normals() -> Vec<[f32; 3]> {
    let at = |k: u8| (2.0 * f32::from(k) + 1.0) / 48.0 - 1.0;
    let pixels = (0..48).flat_map(|row| (0..48).map(move |column| (at(column), at(row))));
    let inside = pixels.filter(|(x, y)| x * x + y * y < 1.0);
    inside.map(|(x, y)| [x, y, (1.0 - x * x - y * y).sqrt()]).collect()
}

fn relight(transfer: &sphere::Transfer, light: &[f32]) -> sphere::Coefficients {
    sphere::relight(transfer, &Light::new(light).expect("coefficients")).expect("it fits")
}

fn shaded(scene: &sphere::Scene, normals: &[[f32; 3]]) -> Vec<f32> {
    let normal = |&[x, y, z]: &[f32; 3]| Normal::new(x, y, z).expect("visible");
    normals.iter().map(|at| sphere::shade(scene, normal(at))).collect()
}

/// The terms of all polynomials of an image.
fn terms(d: &[f32]) -> Vec<f32> {
    let mut terms = vec![0.0; sphere::SCENE];
    sphere::BASIS.collapse_into(d, &mut terms[..]).expect("sizes");
    terms
}

fn subnormal(values: &[f32]) -> usize {
    values.iter().filter(|value| value.is_subnormal()).count()
}

/// Counts how many of the nonzero products are subnormal.
#[derive(Default)]
struct Share([usize; 2]);

impl Share {
    fn times(&mut self, a: f32, b: f32) -> f32 {
        let product = a * b;
        self.0[0] += usize::from(product.is_subnormal());
        self.0[1] += usize::from(product != 0.0);
        product
    }

    /// Of the products of a linear map, which is given by its answers to unit vectors.
    fn of_map(values: &[f32], map: impl Fn(&[f32]) -> Vec<f32>) -> Self {
        let mut share = Self::default();
        for (k, &value) in values.iter().enumerate() {
            let mut unit = vec![0.0; values.len()];
            unit[k] = 1.0;
            for factor in map(&unit) {
                share.times(factor, value);
            }
        }
        share
    }

    fn value(&self) -> f64 {
        self.0[0] as f64 / self.0[1].max(1) as f64
    }

    /// A pixel, with its azimuths by Horner's rule, as the shipped table uses them, or by the
    /// powers of n_x + i n_y, as any table does.
    fn shade(&mut self, mut terms: &[f32], [x, y, z]: [f32; 3], by_powers: bool) -> f32 {
        let t = 2.0 * z - 1.0;
        let mut values = Vec::new();
        for (m, &length) in sphere::BASIS.parts().lengths.iter().enumerate() {
            let mut of_azimuth = [0.0; 2];
            for value in &mut of_azimuth[..if m == 0 { 1 } else { 2 }] {
                // The highest term comes first.
                let (polynomial, rest) = terms.split_at(length.into());
                let sum = polynomial.iter().copied().reduce(|sum, term| self.times(sum, t) + term);
                (*value, terms) = (sum.unwrap_or(0.0), rest);
            }
            values.push(of_azimuth);
        }
        if by_powers {
            let (mut cosine, mut sine, mut sum) = (1.0, 0.0, 0.0);
            for [plus, minus] in values {
                sum += self.times(plus, cosine) + self.times(minus, sine);
                (cosine, sine) = (
                    self.times(cosine, x) - self.times(sine, y),
                    self.times(cosine, y) + self.times(sine, x),
                );
            }
            return sum;
        }
        values.into_iter().rev().fold([0.0; 2], |[real, imaginary], [plus, minus]| {
            [
                plus + self.times(real, x) + self.times(imaginary, y),
                minus + self.times(imaginary, x) - self.times(real, y),
            ]
        })[0]
    }
}

pub(super) fn measure() -> Vec<Figure> {
    let on = fixtures::materials(7, 1, &mut Numbers(42)).entries[0].luminance();
    let light = fixtures::lights(9, 1, &mut Numbers(43)).entries[0].luminance();
    let (material, plain) = (single(on.clone()), single(light.clone()));
    let tiny: Vec<f32> = plain.iter().map(|value| value * 2f32.powi(FAR)).collect();
    let transfer = Material::new(&material).expect("coefficients");
    let transfer = sphere::transfer(&transfer).expect("it fits");
    let normals = normals();
    let [of_plain, d] = [&plain, &tiny].map(|light| relight(&transfer, light));
    let scenes = [&of_plain, &d].map(|d| sphere::collapse(d).expect("it fits"));
    let [scaled, pixels] = scenes.each_ref().map(|scene| shaded(scene, &normals));
    let of_light = Share::of_map(&tiny, |unit| relight(&transfer, unit).to_vec());
    let of_terms = Share::of_map(&d, terms);
    let [mut horner, mut powers, mut of_scaled] = [(); 3].map(|()| Share::default());
    let (of_image, of_plain_image) = (terms(&d), terms(&of_plain));
    let largest = of_image.iter().fold(0.0f32, |most, term| most.max(term.abs()));
    for (&normal, expected) in normals.iter().zip(&pixels) {
        let found = horner.shade(&of_image, normal, false);
        // Confirms that the counted operations are those of the pixel.
        assert!((found - expected).abs() <= tolerances::SAME_SUM_F32 * largest);
        powers.shade(&of_image, normal, true);
        of_scaled.shade(&of_plain_image, normal, false);
    }
    let other = pixels.iter().zip(&scaled).filter(|(a, b)| **a != **b * 2f32.powi(FAR)).count();
    // All components of the shipped scene.
    let table = fixtures::table(&fixtures::shipped());
    let owned = OwnedBasis::<f32>::new(&table);
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let far: Vec<f64> = tiny.iter().copied().map(f64::from).collect();
    let all = shader.project((9, &far), (7, &on)).expect("coefficients");

    let [relight_time, project_time, collapse_time, shade_time] = [
        ratio([&plain, &tiny], |light| drop(black_box(relight(&transfer, light)))),
        ratio([&plain, &tiny], |light| drop(black_box(coefficients(light, &material)))),
        ratio([&of_plain, &d], |d| drop(black_box(sphere::collapse(d)))),
        ratio(scenes.each_ref(), |scene| drop(black_box(shaded(scene, &normals)))),
    ];
    vec![
        exactly("subnormal coefficients", subnormal(&d), 0),
        exactly("subnormal terms", subnormal(&of_image), 0),
        exactly("subnormal pixels", subnormal(&pixels), 0),
        most("subnormal products in relighting, of all", of_light.value(), 0.0),
        most("subnormal products in collapsing", of_terms.value(), 0.0),
        // The highest terms are 1e-7 of the strongest, and t and n_x are small somewhere: 0.7 %.
        most("subnormal products in shading", horner.value(), 0.02),
        most("subnormal products in shading by powers", powers.value(), 0.02),
        // Those with amplitudes weaker than 1e-8 of the strongest.
        most(
            "subnormal coefficients of all components, of all",
            subnormal(all) as f64 / all.len() as f64,
            0.5,
        ),
        most("subnormal products in shading, light scaled to 1", of_scaled.value(), 0.0),
        exactly("pixels that differ in a bit, scaled back", other, 0),
        report("time of relighting, relative to light at 1", relight_time),
        report("time of projecting", project_time),
        report("time of collapsing", collapse_time),
        report("time of shading", shade_time),
    ]
}

/// The time with the second input relative to that with the first: each is the shortest of many
/// runs, and the two alternate.
fn ratio<T>(inputs: [&T; 2], task: impl Fn(&T)) -> f64 {
    let mut shortest = [Duration::MAX; 2];
    for _ in 0..100 {
        for (shortest, input) in shortest.iter_mut().zip(inputs) {
            let start = Instant::now();
            (0..4).for_each(|_| task(black_box(input)));
            *shortest = start.elapsed().min(*shortest);
        }
    }
    shortest[1].as_secs_f64() / shortest[0].as_secs_f64()
}
