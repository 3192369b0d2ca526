//! Sums over a million pixels in f32.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade::{Light, Material, Normal, sphere};
use eigenshade_testing::largest;

/// Error of d by a plain f32 sum over a million pixels, relative to the largest d: an addition near
/// its end loses up to 6e-8 of the sum, and runs of pixels lose in the same direction. The total is
/// 1e-5, of which a fifth is required.
const NAIVE_SUM: f64 = 2e-6;

pub const MILLION: Case = Case {
    name: "d by scalar product over a million pixels in f32",
    naively: "each addition loses what lies below the last bit of a sum that keeps growing",
    here: "compensated sums: an addition carries what the last one lost",
    measure,
};

/// Width of the picture in pixels, for a disc of a million pixels.
const SIZE: i32 = 1130;

fn measure() -> Vec<Figure> {
    // A light from the side and a material with a rim, so that every component contributes.
    let light: Vec<f32> = (0..100).map(|k| 1.5 / (1.0 + k as f32).sqrt()).collect();
    let material: Vec<f32> = (0..40).map(|k| 1.0 / (1.0 + k as f32)).collect();
    let light = Light::new(9, &light).expect("100 coefficients");
    let material = Material::new(7, &material).expect("40 coefficients");
    let d = sphere::project(&light, &material).expect("it fits");
    let scene = sphere::collapse(&d).expect("it fits");
    let mut ours = sphere::BASIS.estimate::<{ sphere::COMPONENTS }>().expect("it fits");
    let mut plain = [0.0f32; sphere::COMPONENTS];
    let mut exact = [0.0f64; sphere::COMPONENTS];
    // The eigenimages one by one, for both reference sums.
    let mut pixels = 0u32;
    let images: Vec<_> = (0..sphere::COMPONENTS)
        .map(|k| {
            let unit: sphere::Coefficients =
                (0..sphere::COMPONENTS).map(|i| f32::from(u8::from(i == k))).collect();
            sphere::collapse(&unit).expect("it fits")
        })
        .collect();
    for row in 0..SIZE {
        for column in 0..SIZE {
            let at = |k: i32| (2.0 * k as f32 + 1.0) / SIZE as f32 - 1.0;
            let (x, y) = (at(column), -at(row));
            let square = x * x + y * y;
            if square >= 1.0 {
                continue;
            }
            let normal = Normal::new(x, y, (1.0 - square).sqrt()).expect("visible");
            let seen = scene.shade(normal);
            ours.add(normal, seen, 1.0);
            pixels += 1;
            for ((image, plain), exact) in images.iter().zip(&mut plain).zip(&mut exact) {
                let value = image.shade(normal);
                *plain += seen * value;
                *exact += f64::from(seen) * f64::from(value);
            }
        }
    }
    let ours = ours.coefficients().expect("a million pixels");
    let exact = exact.map(|sum| sum / f64::from(pixels));
    let scale = largest(exact);
    let error = |found: &[f32]| {
        largest(found.iter().zip(&exact).map(|(found, exact)| f64::from(*found) - exact)) / scale
    };
    let plain = plain.map(|sum| sum / pixels as f32);
    // The pixel raster is not an exact quadrature. This is its error, which no summation can avoid.
    let raster = largest(exact.iter().zip(&d).map(|(a, b)| a - f64::from(*b))) / scale;
    vec![
        Figure::least("plain sum, of the largest d", error(&plain), NAIVE_SUM),
        Figure::most("compensated, of the largest d", error(&ours), tolerances::MILLION_PIXELS),
        Figure::most("the raster's own, of the largest d", raster, tolerances::RASTER),
    ]
}
