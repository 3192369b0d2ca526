//! The nine-term formula against the harmonics of degree 2 themselves, integrated.

use crate::invariants::integer::Integer;
use crate::oracle::{ExplicitLight, irradiance};
use eigenshade::index::light;
use eigenshade::quantized;
use eigenshade::{Light, NineTerms, Normal, Normals, Q15, Q31};
use eigenshade_testing::fixtures::spiral;

/// The nine-term formula in f64 against the integral of harmonics of degree 2: rounding of a few
/// dozen sums of numbers below 1.
const NINE_TERMS_F64: f64 = 1e-15;

/// The same in integers, of the sum of its coefficients' sizes: six roundings to 14 bits of that
/// sum, 5.2e-5 found, and to 30, 8.2e-10.
const NINE_TERMS_Q15: f64 = 6e-5;

/// See [`NINE_TERMS_Q15`].
const NINE_TERMS_Q31: f64 = 1e-9;

/// Directions all over the visible hemisphere, with pole and rim.
fn normals() -> Vec<[f64; 3]> {
    spiral((0..=60).map(|k| f64::from(k) / 60.0))
}

fn unit_light(mode: usize) -> [f64; 9] {
    std::array::from_fn(|k| f64::from(u8::from(k == mode)))
}

/// Under each harmonic alone; f = 0.7/π is b_00^0 = 1.4.
#[test]
fn nine_terms_are_the_harmonics_of_degree_two_on_a_lambertian_material() {
    for (mode, (l, m)) in light::indices(2).enumerate() {
        let light = unit_light(mode);
        let formula = NineTerms::lambertian(&Light::new(&light).unwrap(), 0.7);
        let light = ExplicitLight::new(&light);
        for normal @ [x, y, z] in normals() {
            let found = formula.shade(Normal::new(x, y, z).unwrap());
            let off = (found - irradiance(&light, &[(0, 0, 0, 1.4)], normal)).abs();
            assert!(off <= NINE_TERMS_F64, "{l} {m} at {normal:?}: {off:e}");
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
        let one = unit_light(term).map(|one| one as i32);
        let in_q15 = quantized::NineTerms::<Q15>::new(one.map(|one| one << 14), -14);
        let in_q31 = quantized::NineTerms::<Q31>::new(one.map(|one| one << 28), -28);
        for normal in normals() {
            let [x, y, z] = normal;
            let found = formula.shade(Normal::new(x, y, z).unwrap());
            assert!(close(found, function(normal), 1e-15), "{term} at {normal:?}: {found}");
            let (found, rounded) = shaded(&in_q15, normal);
            assert!(close(found, function(rounded), 1e-4), "{term} at {normal:?}: {found}");
            let (found, rounded) = shaded(&in_q31, normal);
            assert!(close(found, function(rounded), 1e-8), "{term} at {normal:?}: {found}");
        }
    }
}

/// The irradiance of a rounded normal, and that normal.
fn shaded<Q: Integer>(formula: &quantized::NineTerms<Q>, normal: [f64; 3]) -> (f64, [f64; 3]) {
    let normal = Q::normal(normal.map(Q::rounded)).expect("a unit normal");
    let found = f64::from(formula.shade(normal)) * f64::from(formula.exponent()).exp2();
    (found, normal.components().map(Q::to_f64))
}

/// Sums of the largest coefficients fit: signs as bad as they can be, of the sum of their sizes
/// against f64.
fn worst<Q: Integer>() -> f64 {
    let largest = 2f64.powi(Q::FORMAT.bits()) - 1.0;
    let off = (0..512u32).flat_map(|signs| {
        let c = std::array::from_fn(|k| if signs >> k & 1 == 0 { largest } else { -largest });
        let formula = quantized::NineTerms::<Q>::new(c.map(|one| one as i32), -8);
        let off = move |normal| {
            let (found, [x, y, z]) = shaded(&formula, normal);
            let terms = [1.0, x, y, z, x * x - y * y, x * y, x * z, y * z, z * z];
            let expected: f64 = c.iter().zip(terms).map(|(c, term)| c * term).sum();
            (256.0 * found - expected) / (9.0 * largest)
        };
        normals().into_iter().map(off)
    });
    eigenshade_testing::largest(off)
}

#[test]
fn integers_do_not_wrap() {
    let (q15, q31) = (worst::<Q15>(), worst::<Q31>());
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
