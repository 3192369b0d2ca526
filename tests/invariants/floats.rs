//! Floats, and scenes within a tolerance: any bits never panic; finite numbers of moderate size give
//! finite answers, and bounds that are finite and kept.

use super::Reader;
use eigenshade::{Light, Material, Normal, Normals, Tolerance, Truncation, sphere};
use eigenshade_index::{light, material};

/// What counts as moderate: sums of products of two stay below f32's largest.
const MODERATE: f32 = 1e12;

/// Any light, material and normals, by every way to a pixel.
pub fn shade_floats(input: &mut Reader<'_>) {
    let any = |input: &mut Reader<'_>| f32::from_le_bytes(input.bytes());
    let degree = input.up_to(sphere::BASIS.degree());
    let coefficients: Vec<f32> = (0..light::count(degree)).map(|_| any(input)).collect();
    let light = Light::new(&coefficients).expect("a light");
    let order = input.up_to(sphere::BASIS.order());
    let of_material: Vec<f32> = (0..material::count(order)).map(|_| any(input)).collect();
    let material = Material::new(&of_material).expect("a material");
    let moderate = coefficients.iter().chain(&of_material).all(|value| value.abs() <= MODERATE);

    let projected = sphere::project(&light, &material).expect("it fits");
    let folded = sphere::transfer(&material).expect("it fits");
    let relit = sphere::relight(&folded, &light).expect("it fits");
    let mut normals = vec![Normal::new(0.0, 0.0, 1.0).expect("a normal")];
    while !input.is_empty() {
        normals.extend(Normal::new(any(input), any(input), any(input)));
    }
    for normal in &normals {
        let [x, y, z] = normal.components();
        let length = f64::from(x).hypot(y.into()).hypot(z.into());
        assert!((length - 1.0).abs() < 1e-6 && z >= 0.0, "{normal:?} is no visible unit vector");
    }
    let axis = |axis: usize| normals.iter().map(|one| one.components()[axis]).collect::<Vec<_>>();
    let (x, y, z) = (axis(0), axis(1), axis(2));
    for d in [&projected, &relit] {
        let scene = sphere::collapse(d).expect("it fits");
        let mut shaded = vec![0.0; normals.len()];
        let slices = Normals::new(&x, &y, &z).expect("one length");
        scene.shade_slice(slices, &mut shaded).expect("one length");
        for (normal, shaded) in normals.iter().zip(shaded) {
            let one = scene.shade(*normal);
            assert!(!moderate || one.is_finite(), "{one} of finite inputs");
            assert!(one.to_bits() == shaded.to_bits() || one.is_nan() && shaded.is_nan());
        }
    }
}

/// Any images in one shape, each its own peak or that of its color.
pub fn collapse_sets(input: &mut Reader<'_>) {
    let channels = 1 + input.up_to(2);
    let count = channels * input.up_to(3);
    let share = 2f32.powi(-1 - input.up_to(20) as i32);
    let is_moderate = input.byte().is_multiple_of(2);
    let mut number = || match is_moderate {
        true => input.moderate(),
        false => f32::from_le_bytes(input.bytes()),
    };
    let images: Vec<[f32; sphere::COMPONENTS]> =
        (0..count).map(|_| std::array::from_fn(|_| number())).collect();
    let mut lengths = [0; sphere::DEGREE + 1];
    let mut report = vec![Truncation::default(); count];
    let mut buffer = vec![0.0; count * sphere::SCENE];
    let tolerance = Tolerance::OfPeak(share);
    let shape = sphere::BASIS
        .collapse_set_within(&images, channels, tolerance, &mut lengths, &mut buffer, &mut report)
        .expect("sizes");
    assert!(shape.terms() <= sphere::SCENE && shape.components <= sphere::COMPONENTS);
    for (numbers, report) in buffer.chunks_exact(sphere::SCENE).zip(&report) {
        let scene = shape.scene(numbers).expect("enough");
        if !is_moderate {
            continue;
        }
        let rounding = super::ECONOMY_PARTS as f32;
        let within = report.bound <= share * report.peak * (1.0 + rounding);
        assert!(report.bound.is_finite() && within, "{report:?}");
        let parts = report.left_out_by_components.hypot(report.left_out_by_terms);
        assert!((parts - report.bound).abs() <= rounding * report.bound, "{report:?}");
        for [x, y, z] in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-0.36, 0.48, 0.8]] {
            let normal = Normal::new(x, y, z).expect("visible");
            assert!(scene.shade(normal).is_finite(), "{report:?}");
        }
    }
}
