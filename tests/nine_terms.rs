//! The nine-term formula against the harmonics of degree 2 themselves, integrated.

use eigenshade::quantized;
use eigenshade::{FixedPoint, Light, NineTerms, Normal, Normals, Q15, Q31};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

/// The nine-term formula in f64 against the integral of harmonics of degree 2: rounding of a few
/// dozen sums of numbers below 1.
const NINE_TERMS_F64: f64 = 1e-15;

/// The same in integers, of the sum of its coefficients' sizes: six roundings to 14 bits of that
/// sum, 5.2e-5 found, and to 30, 8.2e-10.
const NINE_TERMS_Q15: f64 = 6e-5;

/// See [`NINE_TERMS_Q15`].
const NINE_TERMS_Q31: f64 = 1e-9;

/// Y_l^m of a direction in the paper's convention: associated Legendre functions of cos θ,
/// times (-1)^m √2 cos mφ for m > 0, √2 sin mφ for m < 0.
fn harmonic(l: usize, m: isize, [x, y, z]: [f64; 3]) -> f64 {
    let (sine, azimuth) = ((1.0 - z * z).max(0.0).sqrt(), y.atan2(x));
    let legendre = match (l, m.unsigned_abs()) {
        (0, 0) => 1.0,
        (1, 0) => z,
        (1, 1) => sine,
        (2, 0) => 1.5 * z * z - 0.5,
        (2, 1) => 3.0 * sine * z,
        (2, 2) => 3.0 * sine * sine,
        _ => unreachable!("degree 2 at most"),
    };
    let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
    let order = m.unsigned_abs();
    let norm = (2 * l + 1) as f64 / (4.0 * PI) * factorial(l - order) / factorial(l + order);
    let around = match m {
        0 => 1.0,
        1.. => (-1.0f64).powi(m as i32) * 2.0f64.sqrt() * (m as f64 * azimuth).cos(),
        _ => 2.0f64.sqrt() * (m as f64 * azimuth).sin(),
    };
    norm.sqrt() * legendre * around
}

/// The irradiance of a white Lambertian material, f = 1/π, under Y_l^m: the sum over directions
/// about the normal of radiance times cosine. Exact but for rounding: along the cosine Gauss's
/// rule of four points, around the normal eight directions.
fn irradiance(l: usize, m: isize, normal: [f64; 3]) -> f64 {
    let [x, y, z] = normal;
    let across = if z.abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
    let cross =
        |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [b * f - c * e, c * d - a * f, a * e - b * d];
    let unit = |[a, b, c]: [f64; 3]| {
        let length = (a * a + b * b + c * c).sqrt();
        [a / length, b / length, c / length]
    };
    let first = unit(cross(normal, across));
    let second = cross(normal, first);
    // Points and weights on [-1, 1].
    let far = (3.0 / 7.0 + 2.0 / 7.0 * 1.2f64.sqrt()).sqrt();
    let near = (3.0 / 7.0 - 2.0 / 7.0 * 1.2f64.sqrt()).sqrt();
    let (light, heavy) = ((18.0 - 30.0f64.sqrt()) / 36.0, (18.0 + 30.0f64.sqrt()) / 36.0);
    let mut sum = 0.0;
    for (point, weight) in [(-far, light), (-near, heavy), (near, heavy), (far, light)] {
        let cosine = 0.5 * (point + 1.0);
        let sine = (1.0 - cosine * cosine).sqrt();
        for k in 0..8 {
            let (s, c) = (TAU * f64::from(k) / 8.0).sin_cos();
            let [a, b, n] = [sine * c, sine * s, cosine];
            let direction =
                std::array::from_fn(|i| a * first[i] + b * second[i] + n * [x, y, z][i]);
            sum += 0.5 * weight * TAU / 8.0 * cosine * harmonic(l, m, direction);
        }
    }
    FRAC_1_PI * sum
}

/// Directions all over the visible hemisphere, with pole and rim.
fn normals() -> Vec<[f64; 3]> {
    let spiral = |k: usize| {
        let (z, tilt) = (k as f64 / 60.0, 2.399_963 * k as f64);
        let sine = (1.0f64 - z * z).sqrt();
        [sine * tilt.cos(), sine * tilt.sin(), z]
    };
    (0..=60).map(spiral).collect()
}

fn unit_light(mode: usize) -> [f64; 9] {
    std::array::from_fn(|k| f64::from(u8::from(k == mode)))
}

const MODES: [(usize, isize); 9] =
    [(0, 0), (1, -1), (1, 0), (1, 1), (2, -2), (2, -1), (2, 0), (2, 1), (2, 2)];

#[test]
fn nine_terms_are_the_harmonics_of_degree_two_on_a_lambertian_material() {
    for (mode, (l, m)) in MODES.into_iter().enumerate() {
        let light = unit_light(mode);
        let formula = NineTerms::lambertian(&Light::new(&light).unwrap(), 0.7);
        for [x, y, z] in normals() {
            let found = formula.shade(Normal::new(x, y, z).unwrap());
            let expected = 0.7 * irradiance(l, m, [x, y, z]);
            let off = (found - expected).abs();
            assert!(off <= NINE_TERMS_F64, "{l} {m} at {x} {y} {z}: {off}");
        }
    }
}

/// Coefficients stand where `new` says.
#[test]
fn each_coefficient_is_of_its_function() {
    let functions: [fn([f64; 3]) -> f64; 9] = [
        |_| 1.0,
        |[x, _, _]| x,
        |[_, y, _]| y,
        |[_, _, z]| z,
        |[x, y, _]| x * x - y * y,
        |[x, y, _]| x * y,
        |[x, _, z]| x * z,
        |[_, y, z]| y * z,
        |[_, _, z]| z * z,
    ];
    let close = |found: f64, expected: f64, most: f64| (found - expected).abs() <= most;
    for (term, function) in functions.into_iter().enumerate() {
        let formula = NineTerms::new(unit_light(term));
        let mut mantissas = [0; 9];
        mantissas[term] = 1 << 14;
        let in_q15 = quantized::NineTerms::<Q15>::new(mantissas, -14);
        let in_q31 = quantized::NineTerms::<Q31>::new(mantissas.map(|one| one << 14), -28);
        for normal in normals() {
            let [x, y, z] = normal;
            let found = formula.shade(Normal::new(x, y, z).unwrap());
            assert!(close(found, function(normal), 1e-15), "{term} at {normal:?}: {found}");
            let (found, rounded) = shaded::<Q15>(&in_q15, normal);
            assert!(close(found, function(rounded), 1e-4), "{term} at {normal:?}: {found}");
            let (found, rounded) = shaded::<Q31>(&in_q31, normal);
            assert!(close(found, function(rounded), 1e-8), "{term} at {normal:?}: {found}");
        }
    }
}

/// An integer format with normals.
trait Integer: FixedPoint {
    fn normal(components: [f64; 3]) -> quantized::Normal<Self>;
    fn number(self) -> f64;
}

macro_rules! integer {
    ($format:ident, $integer:ident) => {
        impl Integer for $format {
            fn normal(components: [f64; 3]) -> quantized::Normal<Self> {
                let one = -f64::from($integer::MIN);
                let [x, y, z] = components.map(|value| {
                    Self((value * one).round().min(f64::from($integer::MAX)) as $integer)
                });
                quantized::Normal::<Self>::new(x, y, z).unwrap()
            }
            fn number(self) -> f64 {
                f64::from(self.0) / -f64::from($integer::MIN)
            }
        }
    };
}
integer!(Q15, i16);
integer!(Q31, i32);

/// The irradiance of a rounded normal, and that normal.
fn shaded<Q: Integer>(formula: &quantized::NineTerms<Q>, normal: [f64; 3]) -> (f64, [f64; 3]) {
    let normal = Q::normal(normal);
    let found = f64::from(formula.shade(normal)) * f64::from(formula.exponent()).exp2();
    (found, normal.components().map(Q::number))
}

/// Sums of the largest coefficients fit: signs as bad as they can be, the answer against f64.
#[test]
fn integers_do_not_wrap() {
    let bad =
        |q15: bool| {
            let largest = if q15 { i32::from(i16::MAX) } else { i32::MAX };
            (0..512u32).map(move |signs| {
                std::array::from_fn::<i32, 9, _>(|k| {
                    if signs >> k & 1 == 0 { largest } else { -largest }
                })
            })
        };
    fn worst<Q: Integer>(coefficients: [i32; 9]) -> f64 {
        let formula = quantized::NineTerms::<Q>::new(coefficients, -8);
        let sum: f64 = coefficients.iter().map(|&one| f64::from(one).abs() / 256.0).sum();
        let off = normals().into_iter().map(|normal| {
            let (found, rounded) = shaded::<Q>(&formula, normal);
            let c = coefficients.map(|one| f64::from(one) / 256.0);
            let [x, y, z] = rounded;
            let expected = c[0]
                + c[1] * x
                + c[2] * y
                + c[3] * z
                + c[4] * (x * x - y * y)
                + c[5] * x * y
                + c[6] * x * z
                + c[7] * y * z
                + c[8] * z * z;
            (found - expected).abs() / sum
        });
        off.fold(0.0, f64::max)
    }
    let q15 = bad(true).map(worst::<Q15>).fold(0.0, f64::max);
    let q31 = bad(false).map(worst::<Q31>).fold(0.0, f64::max);
    println!("{q15:e} {q31:e}");
    assert!(q15 <= NINE_TERMS_Q15, "{q15}");
    assert!(q31 <= NINE_TERMS_Q31, "{q31}");
}

#[test]
fn a_slice_is_shaded_as_its_normals() {
    let all = normals();
    let [x, y, z] = [0, 1, 2].map(|axis| all.iter().map(|n| n[axis] as f32).collect::<Vec<_>>());
    let formula = NineTerms::new([0.9f32, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);
    let normals = Normals::new(&x, &y, &z).unwrap();
    let mut irradiance = vec![0.0; x.len()];
    formula.shade_slice(normals, &mut irradiance).unwrap();
    for (normal, found) in normals.iter().zip(&irradiance) {
        assert_eq!(formula.shade(normal), *found);
    }
    assert!(formula.shade_slice(normals, &mut irradiance[1..]).is_err());
}
