//! Scenes within a tolerance: any bits never panic; of finite coefficients the bound is finite
//! and kept, and the scenes are.

use super::Reader;
use eigenshade::{Economy, Normal, Tolerance, sphere};

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
    let mut told = vec![Economy::default(); count];
    let mut buffer = vec![0.0; count * sphere::SCENE];
    let tolerance = Tolerance::OfPeak(share);
    let shape = sphere::BASIS
        .collapse_set_within(&images, channels, tolerance, &mut lengths, &mut buffer, &mut told)
        .expect("sizes");
    assert!(shape.terms() <= sphere::SCENE && shape.components <= sphere::COMPONENTS);
    for (numbers, told) in buffer.chunks_exact(sphere::SCENE).zip(&told) {
        let scene = shape.scene(numbers).expect("enough");
        if !is_moderate {
            continue;
        }
        let rounding = super::ECONOMY_PARTS as f32;
        let within = told.bound <= share * told.peak * (1.0 + rounding);
        assert!(told.bound.is_finite() && within, "{told:?}");
        let parts = told.left_out_by_components.hypot(told.left_out_by_terms);
        assert!((parts - told.bound).abs() <= rounding * told.bound, "{told:?}");
        for [x, y, z] in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-0.36, 0.48, 0.8]] {
            let normal = Normal::new(x, y, z).expect("visible");
            assert!(scene.shade(normal).is_finite(), "{told:?}");
        }
    }
}
