//! Materials of high order: GGX lobes on a matte base, projected onto (8) by a coarse product rule.
//! The tests need this kind of material, not accurate coefficients.
//!
//! The microfacet model is that of Walter et al., "Microfacet Models for Refraction through Rough
//! Surfaces", 2007, with Smith's height-correlated masking and Schlick's Fresnel term; α is
//! roughness².

use eigenshade_model::database::{Materials, Named};
use eigenshade_model::irradiance::slant_radials;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_table::{material, pair};
use std::f64::consts::{PI, TAU};

/// Ten roughnesses, 0.1 to 1, each as a dielectric on a matte base and as a metal.
pub fn materials(order: usize) -> Materials {
    let mut entries = Vec::new();
    for step in 1..=10 {
        let roughness = 0.1 * f64::from(step);
        for (kind, reflectance, albedo) in [("dielectric", 0.04, 0.5), ("metal", 0.9, 0.0)] {
            let mut coefficients = project(order, roughness * roughness, reflectance);
            // b_00^0 = 2 alone is f = 1/π.
            coefficients[0] += 2.0 * albedo;
            let name = format!("{kind}-{roughness:.1}");
            entries.push(Named { name, rgb: [0, 1, 2].map(|_| coefficients.clone()) });
        }
    }
    Materials { order, entries }
}

/// Coefficients b_op^q. The disc mapping preserves area, so (8) is orthonormal under dω_i dω_r.
fn project(order: usize, alpha: f64, reflectance: f64) -> Vec<f64> {
    // Enough nodes to resolve the lobe and the products of the modes.
    let count = (2.5 / alpha).clamp(2.0 * order as f64 + 16.0, 240.0) as usize;
    let nodes = gauss_legendre(count, 0.0, 1.0);
    let radials: Vec<Vec<f64>> =
        nodes.iter().map(|(z, _)| slant_radials(order, z.acos())).collect();
    let steps = gauss_legendre(64, 0.0, 1.0);
    let mut coefficients = vec![0.0; material::count(order)];
    let mut waves = vec![0.0; order + 1];
    for (i, (z_i, w_i)) in nodes.iter().enumerate() {
        for (r, (z_r, w_r)) in nodes.iter().enumerate().take(i + 1) {
            waves.fill(0.0);
            // `width` is the lobe's width in azimuth, regardless of its width in slant. The
            // substitution Δφ = π - width sinh(s) resolves it. Both halves of the circle are equal.
            let width = alpha * (z_i + z_r) + (z_i - z_r).abs();
            let last = (PI / width).asinh();
            for (step, weight) in &steps {
                let (sinh, cosh) = ((last * step).sinh(), (last * step).cosh());
                let cosine = -(width * sinh).cos();
                let value = 2.0 * weight * last * width * cosh;
                let value = value * ggx(*z_i, *z_r, cosine, alpha, reflectance);
                let (mut before, mut wave) = (cosine, 1.0);
                for sum in &mut waves {
                    *sum += value * wave;
                    (before, wave) = (wave, 2.0 * cosine * wave - before);
                }
            }
            let both = if i == r { 1.0 } else { 2.0 };
            let area = both * w_i * w_r * TAU;
            for ((o, p, q), sum) in material::indices(order).zip(&mut coefficients) {
                let (first, second) = (pair::position(o, q), pair::position(p, q));
                let radial =
                    radials[i][first] * radials[r][second] + radials[i][second] * radials[r][first];
                *sum += area * waves[q] * radial;
            }
        }
    }
    for ((o, p, q), sum) in material::indices(order).zip(&mut coefficients) {
        let doubled = |equal: bool| if equal { 2.0 } else { 1.0 };
        *sum *= (((o + 1) * (p + 1)) as f64 / (doubled(o == p) * doubled(q == 0))).sqrt() / TAU;
    }
    coefficients
}

/// f in 1/sr; `cosine` is the cosine of φ_i - φ_r, 1 for backscatter.
fn ggx(z_i: f64, z_r: f64, cosine: f64, alpha: f64, reflectance: f64) -> f64 {
    let sine = |z: f64| ((1.0 - z) * (1.0 + z)).sqrt();
    let between = z_i * z_r + sine(z_i) * sine(z_r) * cosine;
    // |i + r|² = 2 + 2 i·r gives the cosines of the half vector.
    let length = (2.0 + 2.0 * between).max(1e-30).sqrt();
    let (to_normal, to_light) = ((z_i + z_r) / length, 0.5 * length);
    let square = alpha * alpha;
    let spread = to_normal * to_normal * (square - 1.0) + 1.0;
    let density = square / (PI * spread * spread);
    let masked = |a: f64, b: f64| a * (square + (1.0 - square) * b * b).sqrt();
    let visible = 0.5 / (masked(z_i, z_r) + masked(z_r, z_i));
    let fresnel = reflectance + (1.0 - reflectance) * (1.0 - to_light).powi(5);
    density * visible * fresnel
}
