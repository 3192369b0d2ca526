//! BRDFs as functions, and their projection, against what shares no code with it.

use crate::tolerances;
use eigenshade_generator::material::brdf::projection::{
    Projection, nodes, project, project_orders, project_with,
};
use eigenshade_generator::material::brdf::{
    Abc, Brdf, Geometry, Ggx, Lambertian, Measure, OrenNayar, Sgd,
};
use eigenshade_index::material;
use eigenshade_model::scattering;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use eigenshade_testing::{largest, oracle, relative_error, vectors};

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

/// Coefficients with twice the nodes, of the largest: 20^-12 and less but for the lobe of 1e-3 rad
/// at grazing angles.
const PROJECTION_NODES: f64 = 4e-8;

/// The same without cosines: f grows without bound to the last panel before π/2.
const PROJECTION_NODES_GRAZING: f64 = 4e-7;

/// Coefficients against 400 midpoints an angle, of the largest: midpoints are off by 1/400² and,
/// where f grows, by ten times that.
const PROJECTION_MIDPOINT: f64 = 1e-4;

/// Energy left out against 64 midpoints in azimuth, relative: a small difference, half of it at
/// grazing angles.
const LEFT_OUT_MIDPOINT: f64 = 0.005;

fn ggx(roughness: f64, f0: f64, albedo: f64) -> Ggx {
    Ggx::new(roughness, f0, albedo).unwrap()
}

fn at(brdf: &dyn Brdf, theta_i: f64, theta_r: f64, delta_phi: f64) -> f64 {
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

/// b_00^0 = 2 albedo and nothing else, in both measures, to order 64.
#[test]
fn a_matte_material_has_one_coefficient() {
    let matte = Lambertian::new(0.8).unwrap();
    for (order, measure) in
        [(0, Measure::Projected), (64, Measure::Projected), (12, Measure::SolidAngle)]
    {
        let found = project(&matte, order, measure);
        assert_eq!(found.coefficients.len(), material::count(order));
        let worst = found
            .coefficients
            .iter()
            .enumerate()
            .map(|(k, b)| (b - if k == 0 { 1.6 } else { 0.0 }).abs())
            .fold(0.0, f64::max);
        println!("order {order}: {worst:.1e}, left out {:.1e}", found.left_out);
        assert!(worst <= tolerances::MATTE_PROJECTION, "{order}: {worst}");
        assert!(found.left_out <= tolerances::MATTE_PROJECTION);
        // ∫∫ f² cos cos dω dω = (0.8/π)² π².
        assert!((found.energy / 0.64 - 1.0).abs() <= tolerances::MATTE_PROJECTION);
    }
}

fn apart(a: &Projection, b: &Projection) -> f64 {
    relative_error(&a.coefficients, &b.coefficients)
}

/// Half as many nodes again change nothing: not even for a lobe of 1e-3 rad.
#[test]
fn the_quadrature_has_converged() {
    let matte = OrenNayar::new(0.8, 0.5).unwrap();
    let (projected, grazing) = (Measure::Projected, Measure::SolidAngle);
    let cases: [(&str, &dyn Brdf, usize, Measure); 6] = [
        ("ggx 0.03", &ggx(0.03, 0.9, 0.0), 12, projected),
        ("ggx 0.1", &ggx(0.1, 0.04, 0.5), 12, projected),
        ("ggx 0.5", &ggx(0.5, 0.9, 0.0), 24, projected),
        ("oren-nayar", &matte, 12, projected),
        ("ggx 0.5", &ggx(0.5, 0.9, 0.0), 12, grazing),
        ("oren-nayar", &matte, 12, grazing),
    ];
    for (name, brdf, order, measure) in cases {
        let coarse = project(brdf, order, measure);
        let fine = project_with(brdf, order, measure, nodes(order) * 3 / 2);
        let found = apart(&coarse, &fine);
        println!("{name}, {order}, {measure:?}: {found:.1e}");
        let allowed = match measure {
            Measure::Projected => PROJECTION_NODES,
            Measure::SolidAngle => PROJECTION_NODES_GRAZING,
        };
        assert!(found <= allowed, "{name}, {order}, {measure:?}: {found}");
        assert!((coarse.left_out - fine.left_out).abs() <= allowed);
    }
}

/// One integration for several orders gives what each order's own gives.
#[test]
fn several_orders_share_an_integration() {
    let brdf = ggx(0.3, 0.04, 0.5);
    let orders = [0, 7, 12, 3];
    let cases =
        [(Measure::Projected, PROJECTION_NODES), (Measure::SolidAngle, PROJECTION_NODES_GRAZING)];
    for (measure, allowed) in cases {
        let together = project_orders(&brdf, &orders, measure);
        assert_eq!(together.len(), orders.len());
        for (&order, together) in orders.iter().zip(&together) {
            let alone = project(&brdf, order, measure);
            assert_eq!(together.coefficients.len(), material::count(order));
            let found = apart(together, &alone);
            println!("order {order}, {measure:?}: {found:.1e}");
            assert!(found <= allowed, "{order}, {measure:?}: {found}");
            assert!((together.left_out - alone.left_out).abs() <= allowed);
            assert!((together.energy / alone.energy - 1.0).abs() <= allowed);
        }
    }
}

/// b = ∫∫ f I by a plain product of midpoint rules in cos θ and Δφ.
#[test]
fn coefficients_are_the_integrals_of_the_definition() {
    let (order, count) = (4, 400);
    let brdf = OrenNayar::new(0.8, 0.6).unwrap();
    let found = project(&brdf, order, Measure::SolidAngle);
    let mut expected = vec![0.0; material::count(order)];
    let node = |k: usize| (k as f64 + 0.5) / count as f64;
    for i in 0..count {
        for r in 0..count {
            // z = s², which keeps nodes for the growth at grazing angles.
            let (theta_i, theta_r) = (node(i).powi(2).acos(), node(r).powi(2).acos());
            let polar = scattering::polar_parts(order, theta_i, theta_r);
            let weight = 4.0 * node(i) * node(r) / (count * count) as f64;
            for k in 0..64 {
                let delta_phi = PI * (f64::from(k) + 0.5) / 64.0;
                let value = weight * TAU * TAU / 64.0 * at(&brdf, theta_i, theta_r, delta_phi);
                for ((sum, polar), (_, _, q)) in
                    expected.iter_mut().zip(&polar).zip(material::indices(order))
                {
                    *sum += value * polar * (q as f64 * delta_phi).cos();
                }
            }
        }
    }
    let found = relative_error(&found.coefficients, &expected);
    println!("against midpoints: {found:.1e}");
    assert!(found <= PROJECTION_MIDPOINT, "{found}");
}

/// The coefficients are nearest: no step along any of them is nearer. And the energy left
/// out is what midpoints find, between f and the sum of modes.
#[test]
fn projected_coefficients_are_nearest() {
    assert_nearest(&OrenNayar::new(0.8, 0.6).unwrap());
    assert_nearest(&ggx(0.8, 0.04, 0.5));
}

fn assert_nearest(brdf: &dyn Brdf) {
    let (order, count) = (5, 160);
    let found = project(brdf, order, Measure::Projected);
    let node = |k: usize| (k as f64 + 0.5) / count as f64;
    let (mut energy, mut left) = (0.0, 0.0);
    let mut gradient = vec![0.0; material::count(order)];
    for i in 0..count {
        for r in 0..count {
            // z = s², which keeps nodes for grazing angles.
            let (theta_i, theta_r) = (node(i).powi(2).acos(), node(r).powi(2).acos());
            let polar = scattering::polar_parts(order, theta_i, theta_r);
            let weight =
                4.0 * (node(i) * node(r)).powi(3) * TAU * TAU / (count * count * 64) as f64;
            for k in 0..64 {
                // δ = π s², for the narrow azimuths of lobes at grazing angles.
                let share = (f64::from(k) + 0.5) / 64.0;
                let delta_phi = PI * (1.0 - share * share);
                let weight = weight * 2.0 * share;
                let value = at(brdf, theta_i, theta_r, delta_phi);
                let modes: Vec<f64> = polar
                    .iter()
                    .zip(material::indices(order))
                    .map(|(polar, (_, _, q))| polar * (q as f64 * delta_phi).cos())
                    .collect();
                let sum: f64 = modes.iter().zip(&found.coefficients).map(|(a, b)| a * b).sum();
                energy += weight * value * value;
                left += weight * (value - sum) * (value - sum);
                for (gradient, mode) in gradient.iter_mut().zip(&modes) {
                    *gradient += weight * (value - sum) * mode;
                }
            }
        }
    }
    let steepest = largest(gradient);
    println!("left {} {}, gradient {steepest:.1e}", left / energy, found.left_out);
    assert!(steepest <= PROJECTION_MIDPOINT * energy.sqrt());
    assert!((left / energy / found.left_out - 1.0).abs() <= LEFT_OUT_MIDPOINT);
    let plain = project(brdf, order, Measure::SolidAngle);
    assert!(found.left_out < plain.left_out, "{} {}", found.left_out, plain.left_out);
}

/// More orders leave out less, down to what a kink or a narrow lobe leaves.
#[test]
fn orders_leave_out_less_and_less() {
    for brdf in [ggx(0.3, 0.04, 0.5), ggx(1.0, 0.9, 0.0)] {
        let left: Vec<f64> =
            [0, 4, 8, 16].map(|order| project(&brdf, order, Measure::Projected).left_out).into();
        assert!(left.windows(2).all(|pair| pair[1] < pair[0]), "{left:?}");
        assert!(left.iter().all(|left| (0.0..=1.0).contains(left)));
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
