//! The integer path: that its ways agree, and what it refuses.

use crate::invariants::integer::{Mantissa as _, eigenimage, normal, shipped, specialized};
use crate::oracle::Numbers;
use eigenshade::q15::{Basis, Light, Material, Normal, Parts, Transfer};
use eigenshade::sphere::q15;
use eigenshade::{Argument, Error, Q15};
use eigenshade_table::quantize;
use eigenshade_testing::fixtures::{of_equal_areas, spiral};
use eigenshade_testing::relative_error;

/// d from pixels in mantissas of 15 bits, of the largest: the images of weak components are trimmed
/// to 1e-5 over their share of the database's rms, some 1e-3 in the weakest.
const ESTIMATE_Q15: f64 = 5e-3;

/// An irradiance of coefficients below 2^16, in units of its scene: roundings of some ten terms and
/// steps.
const SMALL_D: f64 = 8.0;

const ORDER: usize = 7;

/// Coefficients that fall with the degree or order.
fn numbers(count: usize, seed: f32) -> Vec<f32> {
    (0..count).map(|k| (seed * (k as f32 + 1.0)).sin() / (1.0 + 0.2 * k as f32)).collect()
}

/// Unit normals over the hemisphere, the pole and the rim among them.
fn normals() -> Vec<Normal> {
    let heights = (0..300).map(|k| f64::from(k) / 299.0);
    let rounded = |at: [f64; 3]| normal(at.map(Q15::rounded)).expect("a normal");
    spiral(heights).into_iter().map(rounded).collect()
}

/// The unrolled pixel, the stored slices and the vectors on the stack give the same bits; fewer
/// coefficients are as if the others were zero.
#[test]
fn ways_agree() {
    for seed in [0.3, 0.7, 1.1, 1.9] {
        let mut mantissas = [Q15(0); 100];
        let light = numbers(100, seed);
        let light = Light::quantize(&light, &mut mantissas).expect("a light");
        let (mut mantissas, mut exponents) = ([Q15(0); 40], [0; 8]);
        let material = numbers(40, 1.0 + seed);
        let material = Material::quantize(&material, &mut mantissas, &mut exponents);
        let material = material.expect("a material");
        let [(d, exponent), _] = specialized(&light, &material, &normals()).expect("they fit");
        let mut padded = d.clone();
        padded[20..].fill(0);
        let [few, zeros] = [&d[..20], &padded].map(|d| {
            q15::BASIS.collapse_into(d, exponent, vec![0; q15::BASIS.scene_len()]).expect("it fits")
        });
        assert_eq!(few.exponent(), zeros.exponent());
        for normal in normals() {
            assert_eq!(few.shade(normal), zeros.shade(normal));
        }
    }
}

/// One coefficient of a light on a material with few of them, large and small: the generated
/// functions give what the general ones give, bit for bit.
#[test]
fn ways_agree_of_few_coefficients() {
    let most = i16::MAX;
    let few = |count: usize, start: usize, step: usize| {
        let mut mantissas = vec![Q15(0); count];
        for (k, mantissa) in mantissas.iter_mut().skip(start).step_by(step).enumerate() {
            let size = most >> (3 * k % 14);
            *mantissa = Q15(if k % 2 == 1 { -size } else { size });
        }
        mantissas
    };
    for (start, step) in [(0, 40), (0, 1), (1, 7), (5, 11), (12, 40), (20, 13), (39, 1)] {
        let mantissas = few(40, start, step);
        for exponents in [[-15_i8; 8], [0, 1, -2, -3, -30, -40, -60, -50]] {
            let material = Material::new(&exponents, &mantissas).expect("one");
            for (start, step) in [(0, 1), (0, 100), (2, 3), (3, 100), (50, 9), (98, 100)] {
                let mantissas = few(100, start, step);
                let light = Light::new(3, &mantissas).expect("a light");
                specialized(&light, &material, &[]).expect("they fit");
            }
        }
    }
}

/// Mantissas made on the device from f32 are those made on the host.
#[test]
fn inputs_are_quantized_alike() {
    for seed in [0.1, 0.5, 2.0, 1e-20, 1e20] {
        let values: Vec<f32> = numbers(100, 1.7).into_iter().map(|value| value * seed).collect();
        let wide: Vec<f64> = values.iter().copied().map(f64::from).collect();
        let (host, exponent) = quantize::row(&wide, i64::MAX);
        let mut mantissas = [Q15::default(); 100];
        let light = Light::quantize(&values, &mut mantissas).expect("a light");
        assert_eq!(Light::new(exponent.into(), &host), Ok(light));
        let (host, exponents) = quantize::material(ORDER, &wide[..40]);
        let (mut mantissas, mut found) = ([Q15(0); 40], [0; 8]);
        let material = Material::quantize(&values[..40], &mut mantissas, &mut found).expect("one");
        assert_eq!(Material::new(&exponents, &host), Ok(material));
    }
}

/// Nothing in is nothing out, and a power of two comes out as it went in.
#[test]
fn zero_and_powers_of_two() {
    let (zeros, mantissas) = ([Q15(0); 100], numbers(100, 0.9));
    let mut light = [Q15::default(); 100];
    let light = Light::quantize(&mantissas, &mut light).expect("a light");
    let (mut material, mut exponents) = ([Q15::default(); 40], [0; 8]);
    let material = Material::quantize(&mantissas[..40], &mut material, &mut exponents);
    let material = material.expect("a material");
    let dark = Light::new(5, &zeros).expect("a light");
    let black = Material::new(&[0; 8], &zeros[..40]).expect("a material");
    for (light, material) in [(&dark, &material), (&light, &black), (&dark, &black)] {
        let answer = specialized(light, material, &normals()).expect("they fit");
        assert!(answer.iter().flat_map(|(numbers, _)| numbers).all(|number| *number == 0));
    }
    let mut scaled = [Q15::default(); 100];
    let values: Vec<f32> = mantissas.iter().map(|value| value * 1024.0).collect();
    let scaled = Light::quantize(&values, &mut scaled).expect("a light");
    let [once, more] = [&light, &scaled]
        .map(|light| specialized(light, &material, &[]).expect("they fit")[0].clone());
    assert_eq!(more, (once.0, once.1 + 10));
}

/// Sums of light that need all their bits, and round beyond them.
#[test]
fn generated_ways_saturate_like_the_general_ones() {
    let mut numbers = [Q15(0); q15::TRANSFER];
    numbers[..2].fill(Q15(-i16::MAX));
    let light = [Q15(i16::MIN); 100];
    let light = Light::new(0, &light).expect("a light");
    let transfer = q15::BASIS.checked_transfer(&numbers, &[0; q15::PROFILES]).expect("it fits");
    let d = q15::relight(&transfer, &light).expect("it fits");
    assert_eq!(Ok(d), q15::BASIS.relight(&transfer, &light));
}

fn general_transfer(basis: &Basis<'_>, material: &Material<'_>) -> Result<q15::Transfer, Error> {
    basis.transfer::<{ q15::WORKSPACE }, { q15::TRANSFER }, { q15::PROFILES }>(material)
}

/// A material whose exponents rise with the order, and a transfer by hand: the generated
/// functions give what the general ones give, bit for bit.
#[test]
fn generated_ways_are_the_general_ones() {
    let values: Vec<f64> = numbers(40, 1.3).into_iter().map(f64::from).collect();
    let mantissas = quantize::row(&values, i64::MAX).0;
    let largest = vec![Q15(32_767); 40];
    for (exponents, mantissas) in [
        ([0_i8; 8], &mantissas),
        ([0, 0, -3, 1, 9, 2, 14, 20], &mantissas),
        ([9, 7, 5, 3, 1, 0, -1, -2], &mantissas),
        ([-20, -20, -16, -18, -13, -12, -9, -9], &largest),
        ([-20, -9, -20, -9, -9, -20, -20, -9], &largest),
    ]
    .iter()
    .flat_map(|(exponents, mantissas)| {
        // All orders, those up to 4, and the first alone.
        [(8, 40), (5, 14), (1, 1)].map(|(o, count)| (&exponents[..o], &mantissas[..count]))
    }) {
        let material = Material::new(exponents, mantissas).expect("a material");
        let generated = q15::transfer(&material).expect("it fits");
        let general = general_transfer(&q15::BASIS, &material);
        assert_eq!(Ok(generated), general, "{exponents:?}");
    }
    let numbers = [Q15(i16::MIN); q15::TRANSFER];
    let transfer = Transfer::new(&numbers, &[0; q15::PROFILES]);
    let light = [Q15(i16::MIN); 100];
    let light = Light::new(0, &light).expect("a light");
    assert_eq!(q15::relight(&transfer, &light), Err(Error::Bound));
    let estimate = q15::estimate();
    assert_eq!(estimate.coefficients(i32::MAX), Err(Error::Exponent));
}

#[test]
fn what_does_not_fit_is_refused() {
    let numbers = [Q15(1); 121];
    let refused = |argument, found| Error::Count { argument, found };
    assert_eq!(Light::new(0, &numbers[..99]), Err(refused(Argument::Light, 99)));
    assert_eq!(Material::new(&[0; 8], &numbers[..39]), Err(refused(Argument::Material, 39)));
    let short = Error::Length { argument: Argument::Material, expected: 8, found: 7 };
    assert_eq!(Material::new(&[0; 7], &numbers[..40]), Err(short));
    assert_eq!(Light::new(129, &numbers[..100]), Err(Error::Exponent));
    let light = Light::new(0, &numbers).expect("a light");
    let material = Material::new(&[0; 9], &numbers[..55]).expect("a material");
    let beyond = Error::Beyond { argument: Argument::Material, most: 7, found: 8 };
    assert_eq!(q15::transfer(&material), Err(beyond));
    let transfer = ([Q15(0); q15::TRANSFER], [0; q15::PROFILES]);
    let transfer = Transfer::new(&transfer.0, &transfer.1);
    let beyond = Error::Beyond { argument: Argument::Light, most: 9, found: 10 };
    assert_eq!(q15::relight(&transfer, &light), Err(beyond));
    assert!(q15::BASIS.collapse_into(&[0; q15::COMPONENTS + 1], 0, [0; q15::SCENE]).is_err());
    assert!(q15::BASIS.collapse_into(&[0; q15::COMPONENTS], 0, [0; 3]).is_err());
    // The last has length 0.977.
    for vector in [[32_767, 32_767, 0], [0; 3], [i16::MIN; 3], [0, 19_207, 25_609]] {
        assert_eq!(normal(vector.map(Q15)), Err(Error::NotUnit));
        let [x, y, z] = vector.map(i32::from);
        assert_eq!(Normal::new(x, y, z).is_ok(), z >= 0 && y != 0, "scaled");
    }
    assert!(Error::NotUnit.to_string().contains("length is not 1; scale it"));
    assert_eq!(Normal::from_unit(Q15(0), Q15(32_767), Q15(-1)), Err(Error::Hidden));
    assert!(Normal::from_unit(Q15(i16::MIN), Q15(0), Q15(0)).is_ok());
    // A row of factors whose sum can leave its accumulator.
    let parts = *q15::BASIS.parts();
    let mut factors = parts.factors.to_vec();
    factors[..3].fill(Q15(i16::MAX));
    assert!(matches!(Basis::new(Parts { factors: &factors, ..parts }), Err(Error::Bound)));
    // A profile whose terms are larger than it states.
    let mut profiles = parts.profiles.to_vec();
    profiles[5].exponent = 0;
    assert!(matches!(Basis::new(Parts { profiles: &profiles, ..parts }), Err(Error::Bound)));
    let of_transfers =
        Parts { polar: &[], polar_exponents: &[], factors: &[], factor_exponents: &[], ..parts };
    let of_transfers = Basis::new(of_transfers).expect("a basis of transfers");
    let material = Material::new(&[0], &numbers[..1]).expect("a material");
    assert_eq!(general_transfer(&of_transfers, &material), Err(Error::TransfersOnly));
}

/// How far d from pixels one by one is from the mean in f64 of the
/// same pixels and the table's Chebyshev series, of the largest.
fn estimated() -> f64 {
    const UNIT: f64 = 16_384.0;
    let table = &shipped().table;
    let mut estimate = q15::BASIS.estimate::<{ q15::COMPONENTS }>().expect("its components");
    let (mut sums, mut weights) = (vec![0.0; q15::COMPONENTS], 0.0);
    for (k, normal @ [x, y, z]) in of_equal_areas(5000).into_iter().enumerate() {
        let seen = (UNIT * (0.6 * z * z + 0.3 * x * z - 0.2 * y)) as i32;
        let weight = (k % 3 * 7) as u16;
        let rounded = self::normal(normal.map(Q15::rounded)).expect("a normal");
        estimate.add(rounded, Q15(seen as i16), weight);
        weights += f64::from(weight);
        for (sum, component) in sums.iter_mut().zip(&table.components) {
            *sum += f64::from(seen) * f64::from(weight) * eigenimage(table, component, normal);
        }
    }
    let found = estimate.coefficients(0).expect("there is a weight");
    let found: Vec<f64> =
        found.mantissas().iter().map(|&d| f64::from(d) * 2f64.powi(found.exponent())).collect();
    sums.iter_mut().for_each(|sum| *sum /= weights);
    relative_error(&found, &sums)
}

#[test]
fn estimates_are_means() {
    let found = estimated();
    println!("d from pixels: {found:.1e}");
    assert!(found <= ESTIMATE_Q15);
    let empty = q15::estimate();
    assert_eq!(empty.coefficients(0), Err(Error::Weight));
    assert!(q15::BASIS.estimate::<{ q15::COMPONENTS - 1 }>().is_err());
}

/// However much may be left out, a profile that serves a component keeps a term: generated
/// functions have no blocks of none.
#[test]
fn profiles_keep_a_term() {
    let table = &shipped().table;
    let parts = quantize::integers(table, 1e9).expect("parts");
    let served = table.profiles.iter().map(|profile| profile.azimuth).max().expect("profiles");
    assert_eq!(parts.lengths[..=served], vec![1; served + 1]);
}

/// Unit vectors along integers of any scale, within these units of a component of f64.
#[test]
fn vectors_of_integers_are_scaled() {
    let (most, one) = (1.0, 32_768.0);
    let mut numbers = Numbers(1);
    let mut random = || (numbers.next() * 2f64.powi(31)) as i32;
    for round in 0..20_000 {
        let shift = round % 31;
        let vector = [random() >> shift, random() >> (shift / 2), random() >> shift];
        let [x, y, z] = vector.map(f64::from);
        let length = x.hypot(y).hypot(z);
        let found = Normal::new(vector[0], vector[1], vector[2]);
        if vector == [0; 3] || z < -0.125 * length {
            let error = if vector == [0; 3] { Error::Normal } else { Error::Hidden };
            assert_eq!(found.err(), Some(error), "{vector:?}");
            continue;
        }
        let (z, length) = if z < 0.0 { (0.0, x.hypot(y)) } else { (z, length) };
        for (found, component) in found.expect("visible").components().into_iter().zip([x, y, z]) {
            let exact = (component / length * one).min(one - 1.0);
            let found = found.mantissa() as f64;
            assert!((found - exact).abs() <= most, "{vector:?}: {found} {exact}");
        }
    }
}

#[test]
fn normals_along_integers_are_unit_vectors() {
    let [least, most] = [i32::MIN, i32::MAX];
    for [x, y, z] in [[least; 3], [most; 3], [least, 0, 0], [0, least, 1], [0, 0, most]] {
        let found = Normal::new(x, y, z);
        assert_eq!(found.is_err(), x == z && z < 0, "{x} {y} {z}");
    }
    assert_eq!(Normal::new(0, 0, -1), Err(Error::Hidden));
    assert_eq!(Normal::new(0, 0, 0), Err(Error::Normal));
}

#[test]
fn normals_are_rounded_to_the_nearest() {
    // 2^15 by √3 is 18,918.6, and by √5 it is 14,654.3, twice of which is 29,308.6.
    for ([x, y, z], expected) in [([1; 3], [18_919; 3]), ([-2, 0, 1], [-29_309, 0, 14_654])] {
        let normal = Normal::new(x, y, z).expect("a normal");
        assert_eq!(normal.components(), expected.map(Q15));
    }
}

/// Mantissas are symmetrical.
#[test]
fn numbers_saturate_alike() {
    for (number, expected) in [(-40_000, -32_767), (-32_768, -32_767), (32_768, 32_767), (5, 5)] {
        assert_eq!(Q15::saturate(number), Q15(expected));
    }
}

/// d below 2^16 loses resolution, but wraps nowhere.
#[test]
fn scenes_of_small_coefficients_are_coarse() {
    for d in [1, 999, 30_000, 65_535] {
        let of = |mantissa: i32, exponent: i32| {
            let mantissas = [mantissa; q15::COMPONENTS];
            q15::BASIS.collapse::<{ q15::SCENE }>(&mantissas, exponent).expect("it fits")
        };
        // The second has the same coefficients, in finer units.
        let (coarse, fine) = (of(d, 0), of(d << 14, -14));
        let units = [&coarse, &fine].map(|scene| f64::from(scene.exponent()).exp2());
        for normal in normals() {
            let coarse = f64::from(coarse.shade(normal)) * units[0];
            let fine = f64::from(fine.shade(normal)) * units[1];
            assert!((coarse - fine).abs() <= SMALL_D * units[0], "{d}: {coarse}, {fine}");
        }
    }
}
