//! Coefficients that are tiny or huge, the share of f32 numbers that are subnormal when the light
//! is at 1e-30, and sums over very many pixels, in f32 and in integers.

use super::degrees::coefficients;
use super::{Figure, exactly, least, most, tight};
use crate::tolerances;
use eigenshade::{Argument, Error, Light, Material, Normal, Q15, q15, sphere};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::Table;
use eigenshade_table::record::Azimuth;
use eigenshade_testing::fixtures::{self, disc};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::{images, largest, relative_error};

/// 2^100 = 1.3e30.
const FAR: i32 = 100;

pub(super) fn double() -> Vec<Figure> {
    let found = Found::new(answers_in_f64, |value| value == 0.0);
    vec![
        exactly("coefficients that differ in a bit", found.coefficients, 0),
        exactly("pixels that differ in a bit", found.pixels, 0),
        exactly("answers that are not finite", found.infinite, 0),
    ]
}

pub(super) fn single() -> Vec<Figure> {
    let found = Found::new(answers, |value| value as f32 == 0.0);
    vec![
        exactly("pixels that differ in a bit", found.pixels, 0),
        exactly("first 50 coefficients that differ in a bit", found.shipped, 0),
        tight("all coefficients, of the largest", found.apart, tolerances::SCALED_F32),
        exactly("answers that are not finite", found.infinite, 0),
        exactly("answers of 1e-60 that are not 0", found.not_zero, 0),
    ]
}

/// Compares the results for scaled inputs with the scaled results, bit for bit.
#[derive(Default)]
struct Found {
    coefficients: usize,
    /// For the coefficients of as many components as the shipped table has.
    shipped: usize,
    pixels: usize,
    /// The largest difference of two coefficients, relative to the largest coefficient.
    apart: f64,
    infinite: usize,
    not_zero: usize,
}

impl Found {
    /// By [`answers`] or [`answers_in_f64`].
    fn new(answers: impl Fn(&Table, &[f64], &[f64]) -> Answers, is_zero: fn(f64) -> bool) -> Self {
        let table = fixtures::table(&fixtures::shipped("curet"));
        let mut numbers = Numbers(41);
        let light = fixtures::lights(9, 1, &mut numbers).entries[0].luminance();
        let material = fixtures::materials(7, 1, &mut numbers).entries[0].luminance();
        let scaled = |values: &[f64], power: i32| -> Vec<f64> {
            values.iter().map(|value| value * 2f64.powi(power)).collect()
        };
        let plain = answers(&table, &light, &material);
        let mut all = Self::default();
        let both = [(FAR, -FAR), (-FAR, FAR), (-FAR, -FAR)];
        let one = [(FAR, 0), (-FAR, 0), (0, FAR), (0, -FAR)];
        for (of_light, of_material) in one.into_iter().chain(both) {
            let (light, material) = (scaled(&light, of_light), scaled(&material, of_material));
            let found = answers(&table, &light, &material);
            let count = |is: fn(&f64) -> bool| {
                found.iter().flatten().flatten().filter(|value| is(value)).count()
            };
            all.infinite += count(|value| !value.is_finite());
            // 1e-60 is zero in f32.
            if is_zero(2f64.powi(of_light + of_material)) {
                all.not_zero += count(|value| *value != 0.0);
                continue;
            }
            for ([d, pixels], [plain_d, plain_pixels]) in found.iter().zip(&plain) {
                let [d, pixels] = [d, pixels].map(|one| scaled(one, -of_light - of_material));
                all.coefficients += different(&d, plain_d);
                all.shipped += different(&d[..sphere::COMPONENTS], plain_d);
                all.pixels += different(&pixels, plain_pixels);
                all.apart = largest([all.apart, relative_error(&d, plain_d)]);
            }
        }
        all
    }
}

/// The number of values that differ in a bit.
fn different(a: &[f64], b: &[f64]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a.to_bits() != b.to_bits()).count()
}

/// Coefficients by projection, then by transfer and new light, each with its pixels.
type Answers = [[Vec<f64>; 2]; 2];

/// In f32, with pixels by collapsed polynomials and component by component.
fn answers(table: &Table, light: &[f64], on: &[f64]) -> Answers {
    let owned = OwnedBasis::new(table).expect("a table for f32");
    let basis = owned.basis().expect("a basis");
    coefficients(&basis, light, on).map(|d| {
        let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
        let pixels = fixtures::normals(&fixtures::SLANTS, 5).into_iter().flat_map(|normal| {
            let normal = fixtures::normal(normal);
            let summed = basis.reconstruct(&d, normal).expect("all components");
            [scene.shade(normal), summed].map(f64::from)
        });
        let pixels = pixels.collect();
        [d.into_iter().map(f64::from).collect(), pixels]
    })
}

/// In f64, by the host.
fn answers_in_f64(table: &Table, light: &[f64], on: &[f64]) -> Answers {
    let evaluator = Evaluator::new(table);
    let eigenimages = evaluator.eigenimages(&fixtures::normals(&fixtures::SLANTS, 5));
    let transfer = evaluator.transfer(on).expect("a table that projects");
    let projected = evaluator.project(light, on).expect("a table that projects");
    [projected, evaluator.relight(&transfer, light)].map(|d| {
        let pixels = eigenimages.reconstruct(&d);
        [d, pixels]
    })
}

/// 2^-100 = 8e-31.
const TINY: f32 = 7.888_609e-31;

fn count_subnormal(values: &[f32]) -> usize {
    values.iter().filter(|value| value.is_subnormal()).count()
}

/// Share of the nonzero products that are subnormal.
fn share(products: &[f32]) -> f64 {
    let nonzero = products.iter().filter(|&&product| product != 0.0).count();
    count_subnormal(products) as f64 / nonzero as f64
}

/// The products of a linear map, which is given by its answers to unit vectors.
fn products_of_map(values: &[f32], map: impl Fn(&[f32]) -> Vec<f32>) -> Vec<f32> {
    let products = |(k, value): (usize, &f32)| {
        let mut unit = vec![0.0; values.len()];
        unit[k] = 1.0;
        map(&unit).iter().map(|factor| factor * value).collect::<Vec<f32>>()
    };
    values.iter().enumerate().flat_map(products).collect()
}

/// A pixel and its products: first with its azimuths by Horner's rule, as the shipped table uses
/// them, then with the powers of n_x + i n_y, as any table does.
fn products_of_pixel(mut terms: &[f32], [x, y, z]: [f32; 3]) -> [(f32, Vec<f32>); 2] {
    let mut products = Vec::new();
    let times = |products: &mut Vec<f32>, a: f32, b: f32| {
        products.push(a * b);
        a * b
    };
    let t = 2.0 * z - 1.0;
    let u = 2.0 * t * t - 1.0;
    // The highest term of a polynomial comes first, alone if their number is odd.
    let mut polynomial = |length: u16| {
        let (polynomial, rest) = terms.split_at(length.into());
        terms = rest;
        let (alone, halves) = polynomial.split_at(polynomial.len() % 2);
        let sum = halves.as_chunks().0.iter().fold(alone.first().copied(), |sum, &[odd, even]| {
            let half = times(&mut products, odd, t) + even;
            Some(sum.map_or(half, |sum| times(&mut products, sum, u) + half))
        });
        sum.unwrap_or(0.0)
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

pub(super) fn subnormal() -> Vec<Figure> {
    let on = fixtures::materials(7, 1, &mut Numbers(42)).entries[0].luminance();
    let light = fixtures::lights(9, 1, &mut Numbers(43)).entries[0].luminance();
    let (material, plain) = (images::single(on.clone()), images::single(light));
    let tiny: Vec<f32> = plain.iter().map(|value| value * TINY).collect();
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
    let rounded_normals = OwnedNormals::new(&normals);
    let each = rounded_normals.each().expect("visible normals");
    let shaded = |scene: &sphere::Scene| -> Vec<f32> {
        each.iter().map(|&normal| scene.shade(normal)).collect()
    };
    let [d, of_plain] = [&tiny, &plain].map(|light| relit(light));
    let scenes = [&d, &of_plain].map(sphere::collapse);
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
    let other = pixels.iter().zip(&scaled).filter(|(a, b)| **a != **b * TINY).count();
    // All components of the shipped scene.
    let owned =
        OwnedBasis::new(&fixtures::table(&fixtures::shipped("curet"))).expect("a table for f32");
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let far: Vec<f64> = tiny.iter().copied().map(f64::from).collect();
    let all = shader.project(&far, &on).expect("coefficients");

    let of_terms = count_subnormal(&of_image) as f64 / of_image.len() as f64;
    let of_components = count_subnormal(all) as f64 / all.len() as f64;
    vec![
        exactly("subnormal coefficients", count_subnormal(&d), 0),
        // The highest terms are 1e-8 of the strongest.
        most("subnormal terms, of all", of_terms, 0.1),
        exactly("subnormal pixels", count_subnormal(&pixels), 0),
        most("subnormal products in relighting, of all", share(&of_light), 0.0),
        most("subnormal products in collapsing", share(&products_of_map(&d, terms)), 0.03),
        // And t and n_x are small somewhere.
        most("subnormal products in shading", share(&horner), 0.12),
        most("subnormal products in shading by powers", share(&powers), 0.12),
        // Those with amplitudes weaker than 1e-8 of the strongest.
        most("subnormal coefficients of all components, of all", of_components, 0.5),
        most("subnormal products in shading, light scaled to 1", share(&of_scaled), 0.0),
        exactly("pixels that differ in a bit, scaled back", other, 0),
    ]
}

/// d by scalar product over a million pixels, against sums in f64.
pub(super) fn million() -> Vec<Figure> {
    // A light from the side and a material with a rim, so that every component contributes.
    let light: Vec<f32> = (0..100).map(|k| 1.5 / (1.0 + k as f32).sqrt()).collect();
    let material: Vec<f32> = (0..40).map(|k| 1.0 / (1.0 + k as f32)).collect();
    let d = images::coefficients(&light, &material);
    let scene = sphere::collapse(&d);
    // The eigenimages one by one, for both reference sums.
    let images: [_; sphere::COMPONENTS] = std::array::from_fn(|k| {
        let unit: [f32; sphere::COMPONENTS] = std::array::from_fn(|i| f32::from(u8::from(i == k)));
        sphere::collapse(&sphere::Coefficients::from(unit))
    });
    let mut ours = sphere::BASIS.estimate::<{ sphere::COMPONENTS }>().expect("it fits");
    let (mut plain, mut exact) = ([0.0f32; sphere::COMPONENTS], [0.0f64; sphere::COMPONENTS]);
    let normals = disc(1130);
    for [x, y, z] in &normals {
        let normal = Normal::new(*x as f32, *y as f32, *z as f32).expect("visible");
        let seen = scene.shade(normal);
        ours.add(normal, seen, 1.0);
        for ((image, plain), exact) in images.iter().zip(&mut plain).zip(&mut exact) {
            let value = image.shade(normal);
            *plain += seen * value;
            *exact += f64::from(seen) * f64::from(value);
        }
    }
    let ours = ours.coefficients().expect("a million pixels");
    let exact = exact.map(|sum| sum / normals.len() as f64);
    let plain = plain.map(|sum| sum / normals.len() as f32);
    let error = |found: &[f32]| {
        relative_error(&found.iter().copied().map(f64::from).collect::<Vec<_>>(), &exact)
    };
    vec![
        // An addition near the end loses up to 6e-8 of the sum, and runs of pixels lose in the same
        // direction: 1e-5 in total, of which a fifth is required.
        least("plain sum, of the largest d", error(&plain), 2e-6),
        tight("compensated, of the largest d", error(&ours), tolerances::MILLION_PIXELS),
        // The raster is not an exact quadrature, whatever the summation.
        tight("the raster's own, of the largest d", error(&d), tolerances::RASTER),
    ]
}

/// A table whose single image is as large as Q15 allows, and the shipped table.
pub(super) fn full_weight() -> Vec<Figure> {
    let places = [q15::Profile::new(0, -3, [0, q15::Profile::NONE], [u16::MAX; 2])];
    let largest_table = q15::Basis::new(q15::Parts {
        degree: 0,
        order: 0,
        components: 1,
        profiles: &places,
        azimuths: &[Azimuth { first: 0, profiles: 1, start: 0, terms: 0, rows: 0 }],
        lengths: &[3],
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        terms: &[Q15(i16::MAX); 3],
    });
    let largest_table = largest_table.expect("parts that fit");
    let pole = q15::Normal::new(0, 0, i32::MAX).expect("a direction");
    let seen = |basis: &q15::Basis<'_>, pixels: u32, weight: u16| {
        let mut estimate = basis.estimate::<50>().expect("room");
        (0..pixels).for_each(|_| estimate.add(pole, Q15(i16::MIN), weight));
        estimate.coefficients(-15)
    };
    let d = |pixels: u32, weight: u16| {
        let found = seen(&largest_table, pixels, weight).expect("sums that fit");
        f64::from(found.mantissas()[0]) * 2f64.powi(found.exponent())
    };
    let one = d(1, 1);
    let off = largest([d(1 << 16, 1 << 15) / one - 1.0, d(1 << 15, u16::MAX) / one - 1.0]);
    let refused = Err(Error::Saturated { argument: Argument::Coefficients });
    let is_refused = |basis| usize::from(seen(basis, 1 << 16, u16::MAX) == refused);
    vec![
        exactly("refused by the largest possible table", is_refused(&largest_table), 1),
        exactly("refused by the shipped table", is_refused(&sphere::q15::BASIS), 0),
        // d has 31 bits.
        most("half the weight or half the pixels, relative", off, 1e-8),
    ]
}
