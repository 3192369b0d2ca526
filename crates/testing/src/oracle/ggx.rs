//! GGX with Smith's correlated shadowing, Schlick's Fresnel term and a matte base, computed from
//! vectors as in the literature. It is an oracle that shares no code with the product's
//! implementation, which uses three cosines.

use std::f64::consts::PI;

/// f in 1/sr for unit vectors to the light and to the viewer, about the normal z.
pub fn ggx(roughness: f64, f0: f64, albedo: f64, i: [f64; 3], r: [f64; 3]) -> f64 {
    let sum = [0, 1, 2].map(|k| i[k] + r[k]);
    let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
    let h = sum.map(|x| x / length);
    let v_h: f64 = (0..3).map(|k| r[k] * h[k]).sum();
    let alpha2 = roughness.powi(4);
    let d = alpha2 / (PI * (h[2] * h[2] * (alpha2 - 1.0) + 1.0).powi(2));
    // Smith's Λ; V = G / 4 cos cos.
    let lambda = |z: f64| ((1.0 + alpha2 * (1.0 - z * z) / (z * z)).sqrt() - 1.0) / 2.0;
    let g = 1.0 / (1.0 + lambda(i[2]) + lambda(r[2]));
    let fresnel = f0 + (1.0 - f0) * (1.0 - v_h).powi(5);
    (1.0 - fresnel) * albedo / PI + fresnel * d * g / (4.0 * i[2] * r[2])
}
