//! BRDFs as functions, against what shares no code with them.

use eigenshade_generator::material::brdf::{Abc, Brdf, Geometry, Ggx, Lambertian, OrenNayar, Sgd};
use eigenshade_testing::{oracle, vectors};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// BRDF models by three cosines against the literature's vectors, relative: α² = 1e-4 under
/// cancellation of 1 - (n h)² near the mirror leaves twelve digits of sixteen.
const BRDF_MODEL: f64 = 1e-10;

/// The ABC model by three cosines against its printed formula, relative: 1 - cos θ_h by the
/// vectors loses up to four digits.
const ABC_MODEL: f64 = 1e-11;

/// The SGD model by three cosines against its printed formula, relative: tan² θ_h / α by the
/// vectors loses up to five digits.
const SGD_MODEL: f64 = 1e-9;

/// Directional albedo of the ABC model by 400 midpoints an angle against 1000 x 180, relative.
const ABC_ALBEDO: f64 = 1e-5;

pub fn ggx(roughness: f64, f0: f64, albedo: f64) -> Ggx {
    Ggx::new(roughness, f0, albedo).unwrap()
}

pub fn at(brdf: &dyn Brdf, theta_i: f64, theta_r: f64, delta_phi: f64) -> f64 {
    brdf.value(Geometry::from_angles(theta_i, theta_r, delta_phi))
}

/// The oracle at (θ_i, θ_r, Δφ).
fn ggx_by_vectors(roughness: f64, f0: f64, albedo: f64, angles: [f64; 3]) -> f64 {
    let [i, r] = directions(angles);
    oracle::ggx(roughness, f0, albedo, i, r)
}

/// Unit vectors to the light and to the viewer at (θ_i, θ_r, Δφ).
fn directions([theta_i, theta_r, delta_phi]: [f64; 3]) -> [[f64; 3]; 2] {
    [vectors::at(theta_i, delta_phi), vectors::at(theta_r, 0.0)]
}

/// n • h and i • h.
fn half_way([i, r]: [[f64; 3]; 2]) -> [f64; 2] {
    let half = vectors::unit(vectors::sum(i, 1.0, r));
    [half[2], vectors::dot(i, half)]
}

/// The largest relative difference of a model from a formula of (θ_i, θ_r, Δφ).
fn worst(model: &dyn Brdf, formula: impl Fn([f64; 3]) -> f64) -> f64 {
    let mut worst: f64 = 0.0;
    for theta_i in [0.0, 0.3, 0.9, 1.5] {
        for theta_r in [0.0, 0.31, 1.2, 1.56] {
            for delta_phi in [0.0, 0.7, 2.0, 3.0, PI] {
                let ours = at(model, theta_i, theta_r, delta_phi);
                worst = worst.max((ours / formula([theta_i, theta_r, delta_phi]) - 1.0).abs());
            }
        }
    }
    worst
}

#[test]
fn models_are_those_of_the_literature() {
    for (roughness, f0, albedo) in [(0.1, 0.9, 0.0), (0.5, 0.04, 0.5), (1.0, 0.3, 1.0)] {
        let theirs = |angles| ggx_by_vectors(roughness, f0, albedo, angles);
        assert!(worst(&ggx(roughness, f0, albedo), theirs) <= BRDF_MODEL, "{roughness}");
    }
    let (square, albedo) = (0.3f64 * 0.3, 0.7);
    let (a, b) = (1.0 - 0.5 * square / (square + 0.33), 0.45 * square / (square + 0.09));
    let oren_nayar = |[theta_i, theta_r, delta_phi]: [f64; 3]| {
        let lobe = theta_i.max(theta_r).sin() * theta_i.min(theta_r).tan();
        albedo / PI * (a + b * delta_phi.cos().max(0.0) * lobe)
    };
    assert!(worst(&OrenNayar::new(albedo, 0.3).unwrap(), oren_nayar) <= BRDF_MODEL);
}

/// k, a, b, c and the index of two published fits, red.
const TEFLON: [f64; 5] = [0.321152, 1.787717, 41.644257, 2.066234, 1.611215];
const SILVER_PAINT: [f64; 5] = [0.159599, 1.151248, 38.884895, 1.971779, 8.336617];

fn abc([matte, a, b, c, index]: [f64; 5]) -> Abc {
    Abc::new(matte, [a, b, c], index).unwrap()
}

/// The formula as its authors print it, with vectors, and with Fresnel's two polarizations by
/// Snell's law.
fn abc_by_vectors([matte, a, b, c, index]: [f64; 5], angles: [f64; 3]) -> f64 {
    let [i, r] = directions(angles);
    let [up, d] = half_way([i, r]);
    let inside = (d.min(1.0).acos().sin() / index).asin().cos();
    let (s, p) =
        ((d - index * inside) / (d + index * inside), (index * d - inside) / (index * d + inside));
    let shadow = 1.0f64.min(2.0 * up * i[2] / d).min(2.0 * up * r[2] / d);
    let lobe = 0.5 * (s * s + p * p) * shadow * a / (1.0 + b * (1.0 - up)).powf(c);
    matte / PI + lobe / (PI * i[2] * r[2])
}

#[test]
fn abc_is_the_printed_formula() {
    for fit in [TEFLON, SILVER_PAINT] {
        assert!(worst(&abc(fit), |angles| abc_by_vectors(fit, angles)) <= ABC_MODEL);
    }
    // By hand: F = ((n - 1) / (n + 1))^2, D = a, G = 1.
    let upright = |[k, a, _, _, n]: [f64; 5]| (k + ((n - 1.0) / (n + 1.0)).powi(2) * a) / PI;
    for fit in [TEFLON, SILVER_PAINT] {
        let ours = at(&abc(fit), 0.0, 0.0, 0.0);
        assert!((ours / upright(fit) - 1.0).abs() <= ABC_MODEL);
    }
}

/// Directional albedos at 20 and 60 degrees, by 1000 x 180 midpoints of the vectors' formula.
const TEFLON_ALBEDO: [f64; 2] = [0.336915, 0.349286];
/// See [`TEFLON_ALBEDO`].
const SILVER_PAINT_ALBEDO: [f64; 2] = [0.286460, 0.279200];

#[test]
fn abc_reflects_no_more_than_it_receives() {
    for (fit, expected) in [(TEFLON, TEFLON_ALBEDO), (SILVER_PAINT, SILVER_PAINT_ALBEDO)] {
        for (theta_i, expected) in [20.0f64, 60.0].into_iter().zip(expected) {
            let (brdf, mut sum) = (abc(fit), 0.0);
            for j in 0..400 {
                let theta_r = (f64::from(j) + 0.5) * FRAC_PI_2 / 400.0;
                for k in 0..400 {
                    let value =
                        at(&brdf, theta_i.to_radians(), theta_r, f64::from(k) * TAU / 400.0);
                    sum += value * theta_r.sin() * theta_r.cos();
                }
            }
            let albedo = sum * FRAC_PI_2 / 400.0 * TAU / 400.0;
            assert!(albedo < 1.0 && (albedo / expected - 1.0).abs() <= ABC_ALBEDO, "{albedo}");
        }
    }
}

#[test]
fn abc_refuses_what_is_no_material() {
    assert!(Abc::new(-0.1, [1.0, 1.0, 1.0], 1.5).is_err());
    assert!(Abc::new(0.1, [1.0, f64::NAN, 1.0], 1.5).is_err());
    assert!(Abc::new(0.1, [1.0, 1.0, f64::INFINITY], 1.5).is_err());
    assert!(Abc::new(0.1, [1.0, 1.0, 1.0], 0.9).is_err());
}

/// ρ_d, ρ_s, α, p, f0, f1, κ, λ, c, k and θ_0 of two published fits: beige fabric, red, and
/// aluminum bronze, green.
const BEIGE_FABRIC: [f64; 11] = [
    0.20926, 0.121663, 0.39455, 0.474725, 0.0559459, -0.318718, 3.8249, 2.26283, 0.0375346,
    7.52635, 0.217453,
];
const ALUM_BRONZE: [f64; 11] = [
    0.0313514, 0.664975, 0.0300126, 0.450056, 0.235756, 0.182842, 24.5961, 2.97371, 1.06401e-7,
    36.2767, 0.066289,
];

fn sgd(fit: [f64; 11]) -> Result<Sgd, eigenshade_model::error::Error> {
    let [matte, glossy, alpha, power, f0, f1, scale, lambda, c, k, theta] = fit;
    let (fresnel, shadowing) = ([f0, f1], [lambda, c, k, theta]);
    Sgd { matte, glossy, alpha, power, fresnel, scale, shadowing }.checked()
}

/// The formula as its authors print it, with vectors.
fn sgd_by_vectors(fit: [f64; 11], angles: [f64; 3]) -> f64 {
    let [rho_d, rho_s, alpha, p, f0, f1, kappa, lambda, c, k, theta_0] = fit;
    let ([i, r], [theta_i, theta_r, _]) = (directions(angles), angles);
    let [x, d] = half_way([i, r]);
    let fresnel = f0 - f1 * d + (1.0 - f0) * (1.0 - d).powi(5);
    let u = alpha + (1.0 - x * x) / (x * x * alpha);
    let lobe = kappa * (-u).exp() / (PI * u.powf(p) * x.powi(4));
    let shadow = |theta: f64| {
        let exponent = c * (theta - theta_0).max(0.0).powf(k);
        (1.0 + lambda * (1.0 - exponent.exp())).clamp(0.0, 1.0)
    };
    let shadows = shadow(theta_i) * shadow(theta_r);
    (rho_d + rho_s * fresnel * lobe * shadows / (i[2] * r[2])) / PI
}

#[test]
fn sgd_is_the_printed_formula() {
    for fit in [BEIGE_FABRIC, ALUM_BRONZE] {
        assert!(worst(&sgd(fit).unwrap(), |angles| sgd_by_vectors(fit, angles)) <= SGD_MODEL);
    }
}

#[test]
fn sgd_is_finite_everywhere_and_refuses_what_is_no_material() {
    let mut without_shadow = ALUM_BRONZE;
    without_shadow[7..].copy_from_slice(&[0.0, 1e9, 50.0, -1.0]);
    for fit in [ALUM_BRONZE, without_shadow] {
        let sgd = sgd(fit).unwrap();
        for incident in [1.0, 0.5, 1e-3, 1e-12] {
            for between in [-1.0, -0.999, 0.0, 0.5, 1.0] {
                let value = sgd.value(Geometry { incident, reflected: 1e-12, between });
                assert!(value.is_finite(), "{incident} {between}: {value}");
            }
        }
    }
    for (place, value) in
        [(0, -0.1), (2, 0.0), (3, f64::NAN), (6, f64::INFINITY), (8, -1.0), (9, 0.0)]
    {
        let mut fit = BEIGE_FABRIC;
        fit[place] = value;
        assert!(sgd_error(fit).contains("no valid SGD material"), "{place}");
    }
}

fn sgd_error(fit: [f64; 11]) -> String {
    sgd(fit).unwrap_err().to_string()
}

#[test]
fn models_are_reciprocal() {
    let models: [&dyn Brdf; 5] = [
        &ggx(0.2, 0.04, 0.5),
        &OrenNayar::new(0.8, 0.5).unwrap(),
        &Lambertian::new(0.3).unwrap(),
        &abc(TEFLON),
        &sgd(ALUM_BRONZE).unwrap(),
    ];
    for model in models {
        for (a, b, delta) in [(0.1, 1.5, 3.1), (0.7, 0.71, PI), (0.0, 1.0, 0.4), (1.2, 0.3, 1.0)] {
            let (there, back) = (at(model, a, b, delta), at(model, b, a, -delta));
            assert!((there - back).abs() <= BRDF_MODEL * there, "{there} {back}");
        }
    }
}

#[test]
fn parameters_out_of_range_are_faults() {
    for bad in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        assert!(Lambertian::new(bad).is_err());
        assert!(OrenNayar::new(bad, 0.3).is_err());
        assert!(Ggx::new(0.5, bad, 0.5).is_err());
        assert!(Ggx::new(0.5, 0.5, bad).is_err());
        assert!(Ggx::new(bad, 0.5, 0.5).is_err());
    }
    for bad in [-1e-9, FRAC_PI_2 + 0.1, f64::NAN] {
        assert!(OrenNayar::new(0.5, bad).is_err());
    }
    assert!(Ggx::new(0.0, 0.5, 0.5).unwrap_err().to_string().contains("[0.03, 1]"));
}
