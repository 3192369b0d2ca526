//! The eigenimages of the table `pbr`, whose polynomials are too long for powers of t, against
//! their Chebyshev series by cosines.

use eigenshade::{Normal, Scalar};
use eigenshade_shading::owned_basis::OwnedBasis;
use std::f64::consts::SQRT_2;

/// An eigenimage whose polynomial has an even and an odd half of ten terms, of its largest value:
/// its powers of u cancel, up to (1 + √2)^10 = 6,700 to one, and are rounded to 2^-24.
const HALVES_F32: f64 = 4e-4;

/// The same, rounded to 2^-53, after what the table's series was rounded to.
const HALVES_F64: f64 = 2e-12;

/// Each component alone, by collapsing it and by itself; of its largest value, the worst.
fn farthest<S: Scalar + Into<f64>>() -> f64 {
    let bytes = std::fs::read("tables/pbr.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&bytes).expect("a table");
    let owned = OwnedBasis::<S>::new(&table);
    let basis = owned.basis().expect("a basis");
    let lengths = basis.parts().lengths;
    assert!(lengths.iter().filter(|&&length| (17..=32).contains(&length)).count() >= 10);
    let mut worst = 0.0f64;
    for (k, component) in table.components.iter().enumerate() {
        let series = &table.profiles[component.profile].chebyshev;
        let mut d = vec![S::ZERO; table.components.len()];
        d[k] = S::ONE;
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        let (mut off, mut largest) = (0.0f64, 0.0f64);
        for place in 0..200 {
            let z = (f64::from(place) + 0.5) / 200.0;
            let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * f64::from(place));
            let around = match component.order {
                0 => 1.0,
                order @ 1.. => SQRT_2 * (f64::from(order) * tilt).cos(),
                order => SQRT_2 * (f64::from(order) * tilt).sin(),
            };
            let angle = (2.0 * z - 1.0).acos();
            let terms = series.iter().enumerate();
            let profile: f64 = terms.map(|(n, term)| term * (n as f64 * angle).cos()).sum();
            let reference = profile * sine.powi(component.order.abs()) * around;
            let [x, y, z] = [sine * tilt.cos(), sine * tilt.sin(), z].map(S::from_f64);
            let normal = Normal::new(x, y, z).expect("visible");
            let alone = basis.reconstruct(&d, normal).expect("sizes");
            for found in [scene.shade(normal), alone] {
                off = off.max((found.into() - reference).abs());
            }
            largest = largest.max(reference.abs());
        }
        worst = worst.max(off / largest);
    }
    worst
}

#[test]
fn halves_cancel_little() {
    let (single, double) = (farthest::<f32>(), farthest::<f64>());
    println!("of an eigenimage's largest value: {single:.1e} in f32, {double:.1e} in f64");
    assert!(single <= HALVES_F32);
    assert!(double <= HALVES_F64);
}
