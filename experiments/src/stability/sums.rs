//! Sums over very many pixels, in f32 and in integers.

use super::{Figure, exactly, least, most, tight};
use crate::tolerances;
use eigenshade::{Argument, Error, Normal, Q15, quantized, sphere};
use eigenshade_testing::fixtures::disc;
use eigenshade_testing::images::coefficients;
use eigenshade_testing::{largest, relative_error};

/// d by scalar product over a million pixels, against sums in f64.
pub(super) fn million() -> Vec<Figure> {
    // A light from the side and a material with a rim, so that every component contributes.
    let light: Vec<f32> = (0..100).map(|k| 1.5 / (1.0 + k as f32).sqrt()).collect();
    let material: Vec<f32> = (0..40).map(|k| 1.0 / (1.0 + k as f32)).collect();
    let d = coefficients(&light, &material);
    let scene = sphere::collapse(&d).expect("it fits");
    // The eigenimages one by one, for both reference sums.
    let images: [_; sphere::COMPONENTS] = std::array::from_fn(|k| {
        let unit: [f32; sphere::COMPONENTS] = std::array::from_fn(|i| f32::from(u8::from(i == k)));
        sphere::collapse(&sphere::Coefficients::from(unit)).expect("it fits")
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
    let places = [quantized::Profile::new(0, -3, [0, quantized::Profile::NONE], [u16::MAX; 2])];
    let largest_table = quantized::Basis::<Q15>::new(quantized::Parts {
        degree: 0,
        order: 0,
        effects: eigenshade::Effects::ALL,
        components: 1,
        profiles: &places,
        lengths: &[3],
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        terms: &[Q15(i16::MAX); 3],
    });
    let largest_table = largest_table.expect("parts that fit");
    let pole = quantized::Normal::along(0, 0, i32::MAX).expect("a direction");
    let seen = |basis: &quantized::Basis<'_, Q15>, pixels: u32, weight: u16| {
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
