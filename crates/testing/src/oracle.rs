//! Direct quadrature of (3): an oracle that shares no code with (11)-(14).
//!
//! Harmonics come from the derivative of the Legendre polynomial's explicit sum, Zernike
//! polynomials from their factorial sum, and rotation from a matrix. The integral uses
//! Clenshaw-Curtis quadrature in θ and the trapezoid rule in φ.

use std::f64::consts::PI;

fn factorial(n: usize) -> f64 {
    (1..=n).map(|k| k as f64).product()
}

/// The coefficients c_k of the polynomial Σ_k c_k z^k that gives N_l^m P_l^m, m >= 0, when
/// multiplied by sin^m.
fn legendre_coefficients(l: usize, m: usize) -> Vec<f64> {
    let mut coefficients = vec![0.0; l + 1];
    for k in 0..=l / 2 {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        coefficients[l - 2 * k] = sign * factorial(2 * l - 2 * k)
            / (2f64.powi(l as i32) * factorial(k) * factorial(l - k) * factorial(l - 2 * k));
    }
    for _ in 0..m {
        coefficients = (1..coefficients.len()).map(|k| k as f64 * coefficients[k]).collect();
    }
    let normalization =
        ((2 * l + 1) as f64 * factorial(l - m) / (4.0 * PI * factorial(l + m))).sqrt();
    let sign = if m.is_multiple_of(2) { 1.0 } else { -1.0 };
    coefficients.iter().map(|c| sign * normalization * c).collect()
}

fn horner(coefficients: &[f64], z: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * z + c)
}

/// A light as explicit polynomials.
pub struct ExplicitLight {
    /// (m >= 0, its polynomial, coefficients of +m and -m).
    terms: Vec<(usize, Vec<f64>, f64, f64)>,
}

impl ExplicitLight {
    /// A light with coefficients in the order (0,0), (1,-1), (1,0), (1,1), (2,-2), ...
    pub fn new(coefficients: &[f64]) -> Self {
        let degree = (coefficients.len() as f64).sqrt() as usize - 1;
        let mut terms = Vec::new();
        for l in 0..=degree {
            for m in 0..=l {
                let plus = coefficients[l * l + l + m];
                let minus = coefficients[l * l + l - m];
                if [plus, minus] == [0.0; 2] {
                    continue;
                }
                terms.push((m, legendre_coefficients(l, m), plus, minus));
            }
        }
        Self { terms }
    }

    /// L(x, y, z) by (4), (46), (47), with the signed m taken literally.
    pub fn radiance(&self, [x, y, z]: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        for (m, polynomial, plus, minus) in &self.terms {
            let legendre = horner(polynomial, z);
            if *m == 0 {
                sum += plus * legendre;
                continue;
            }
            // sin^m (cos mφ, sin mφ) as a power of x + iy.
            let (mut re, mut im) = (1.0, 0.0);
            for _ in 0..*m {
                (re, im) = (re * x - im * y, re * y + im * x);
            }
            // P_l^-m includes (-1)^m, and sin(-mφ) = -sin(mφ).
            let reflected = if m % 2 == 0 { -1.0 } else { 1.0 };
            sum += 2f64.sqrt() * legendre * (plus * re + reflected * minus * im);
        }
        sum
    }
}

/// R_n^m(ρ) by the factorial sum.
pub fn zernike(n: usize, m: usize, rho: f64) -> f64 {
    (0..=(n - m) / 2)
        .map(|k| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            sign * factorial(n - k)
                / (factorial(k) * factorial((n + m) / 2 - k) * factorial((n - m) / 2 - k))
                * rho.powi((n - 2 * k) as i32)
        })
        .sum()
}

/// The BRDF (7)-(8) at two angles, with the terms `(o, p, q, b)`: q and the factor of cos q Δφ.
fn cosines(
    terms: &[(usize, usize, usize, f64)],
    theta_i: f64,
    theta_r: f64,
) -> impl Iterator<Item = (usize, f64)> {
    let (rho_i, rho_r) = (2f64.sqrt() * (0.5 * theta_i).sin(), 2f64.sqrt() * (0.5 * theta_r).sin());
    terms.iter().map(move |&(o, p, q, b)| {
        let doubled = if o == p { 2.0 } else { 1.0 } * if q == 0 { 2.0 } else { 1.0 };
        let root = (((o + 1) * (p + 1)) as f64 / doubled).sqrt() / (2.0 * PI);
        let radial = zernike(o, q, rho_i) * zernike(p, q, rho_r)
            + zernike(p, q, rho_i) * zernike(o, q, rho_r);
        (q, b * root * radial)
    })
}

/// The BRDF (7)-(8) with the terms `(o, p, q, b)`.
pub fn brdf(terms: &[(usize, usize, usize, f64)], theta_i: f64, theta_r: f64, dphi: f64) -> f64 {
    cosines(terms, theta_i, theta_r).map(|(q, factor)| factor * (q as f64 * dphi).cos()).sum()
}

/// `count` + 1 Clenshaw-Curtis nodes and weights on [0, 1], `count` even.
pub fn clenshaw_curtis(count: usize) -> Vec<(f64, f64)> {
    (0..=count)
        .map(|k| {
            let angle = PI * k as f64 / count as f64;
            let mut weight = 1.0;
            for j in 1..=count / 2 {
                let half = if 2 * j == count { 0.5 } else { 1.0 };
                weight -= 2.0 * half * (2.0 * j as f64 * angle).cos() / ((4 * j * j - 1) as f64);
            }
            let end = if k == 0 || k == count { 0.5 } else { 1.0 };
            (0.5 * (1.0 - angle.cos()), end * weight / count as f64)
        })
        .collect()
}

/// The irradiance (3) at a unit normal.
pub fn irradiance(
    light: &ExplicitLight,
    material: &[(usize, usize, usize, f64)],
    [x, y, z]: [f64; 3],
) -> f64 {
    let sine = x.hypot(y);
    let alpha = sine.atan2(z);
    let (cb, sb) = if sine > 0.0 { (x / sine, y / sine) } else { (1.0, 0.0) };
    let mut sum = 0.0;
    for (fraction, weight) in clenshaw_curtis(48) {
        let theta = 0.5 * PI * fraction;
        let (st, ct) = theta.sin_cos();
        let mut cosines_of = vec![0.0; 1 + material.iter().map(|term| term.2).max().unwrap_or(0)];
        cosines(material, theta, alpha).for_each(|(q, factor)| cosines_of[q] += factor);
        let around = (0..40).map(|k| {
            let phi = 2.0 * PI * f64::from(k) / 40.0;
            // The local direction, rotated about y by alpha, then about z.
            let (u, v, w) = (st * phi.cos(), st * phi.sin(), ct);
            let (a, c) = (u * z + w * sine, w * z - u * sine);
            let direction = [a * cb - v * sb, a * sb + v * cb, c];
            let of_q = |(q, factor): (usize, &f64)| factor * (q as f64 * (phi - PI)).cos();
            light.radiance(direction) * cosines_of.iter().enumerate().map(of_q).sum::<f64>()
        });
        sum += weight * ct * st * around.sum::<f64>();
    }
    sum * 0.5 * PI * 2.0 * PI / 40.0
}

/// GGX with Smith's correlated shadowing, Schlick's Fresnel term and a matte base, computed from
/// vectors as in the literature: f in 1/sr for unit vectors to the light and to the viewer, about
/// the normal z. The product's implementation uses three cosines.
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

/// A small generator of reproducible pseudorandom numbers in [-1, 1).
pub struct Numbers(pub u64);

impl Numbers {
    /// The next number.
    #[expect(clippy::should_implement_trait, reason = "it never ends")]
    pub fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64) / (1u64 << 52) as f64 - 1.0
    }

    /// A normal of the visible hemisphere.
    pub fn normal(&mut self) -> [f64; 3] {
        let (tilt, z) = (PI * self.next(), 0.5 * (self.next() + 1.0));
        let sine = (1.0 - z * z).sqrt();
        [sine * tilt.cos(), sine * tilt.sin(), z]
    }
}
