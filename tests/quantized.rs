//! The integer path: that its ways agree, and what it refuses.

use eigenshade::quantized::{Basis, Light, Material, Normal, Parts, Profile, Transfer};
use eigenshade::sphere::{q15, q31};
use eigenshade::{Argument, Error, FixedPoint, Q15, Q31};
use eigenshade_shading::integer_shader::Integer;
use eigenshade_table::quantize::{self, Format};
use std::f64::consts::SQRT_2;

/// d from pixels in mantissas of 15 bits, of the largest: the images of weak components are trimmed
/// to 1e-5 over their share of the database's rms, some 1e-3 in the weakest.
const ESTIMATE_Q15: f64 = 5e-3;

/// The same in 31 bits, trimmed to 1e-8.
const ESTIMATE_Q31: f64 = 1e-6;

/// An irradiance of coefficients below 2^16, in units of its scene: roundings of some ten terms and
/// steps.
const SMALL_D: f64 = 8.0;

const ORDER: usize = 7;

/// Coefficients that fall with the degree or order.
fn numbers(count: usize, seed: f32) -> Vec<f32> {
    (0..count).map(|k| (seed * (k as f32 + 1.0)).sin() / (1.0 + 0.2 * k as f32)).collect()
}

/// Unit normals over the hemisphere, the pole and the rim among them.
fn normals<Q: Integer>() -> Vec<Normal<Q>> {
    let mut normals = Vec::new();
    for k in 0..300 {
        let z = 1.0 - f64::from(k) / 299.0;
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.4 * f64::from(k));
        normals.push(Q::normal([sine * tilt.cos(), sine * tilt.sin(), z]).expect("a normal"));
    }
    normals
}

macro_rules! in_format {
    ($name:ident, $format:ident, $module:ident) => {
        /// The unrolled pixel, the stored slices and the vectors on the stack give the same
        /// bits; fewer coefficients are as if the others were zero.
        #[test]
        fn $name() {
            for seed in [0.3, 0.7, 1.1, 1.9] {
                let mut mantissas = [$format::default(); 100];
                let light = numbers(100, seed);
                let light = Light::quantize(&light, &mut mantissas).expect("a light");
                let (mut mantissas, mut exponents) = ([$format::default(); 40], [0; 8]);
                let material = numbers(40, 1.0 + seed);
                let material = Material::quantize(&material, &mut mantissas, &mut exponents)
                    .expect("a material");
                let transfer = $module::transfer(&material).expect("it fits");
                let d = $module::relight(&transfer.view(), &light).expect("it fits");
                let scene = $module::collapse(&d).expect("it fits");
                let mut few = d.mantissas().to_vec();
                few[20..].fill(0);
                let zeros = $module::BASIS
                    .collapse_into(&few, d.exponent(), vec![0; $module::SCENE])
                    .expect("it fits");
                let few = $module::BASIS
                    .collapse_into(&few[..20], d.exponent(), vec![0; $module::SCENE])
                    .expect("it fits");
                assert_eq!(few.exponent(), zeros.exponent());
                for normal in normals() {
                    assert_eq!(scene.shade(normal), (*scene).shade(normal));
                    assert_eq!(few.shade(normal), zeros.shade(normal));
                }
            }
        }
    };
}
in_format!(q15_agrees_with_itself, Q15, q15);
in_format!(q31_agrees_with_itself, Q31, q31);

macro_rules! sparse {
    ($name:ident, $format:ident, $module:ident) => {
        /// One coefficient of a light on a material with few of them, large and small: the
        /// generated functions give what the general ones give, bit for bit.
        #[test]
        fn $name() {
            use $module::{BASIS, COMPONENTS, PROFILES, SCENE, TRANSFER, WORKSPACE};
            let most = $format::default().0.wrapping_sub(1).cast_unsigned() >> 1;
            let few = |count: usize, start: usize, step: usize| {
                let mut mantissas = vec![$format::default(); count];
                for (k, mantissa) in mantissas.iter_mut().skip(start).step_by(step).enumerate() {
                    mantissa.0 = (most >> (3 * k % 14)) as _;
                    if k % 2 == 1 {
                        mantissa.0 = -mantissa.0;
                    }
                }
                mantissas
            };
            for (start, step) in [(0, 40), (0, 1), (1, 7), (5, 11), (12, 40), (20, 13), (39, 1)] {
                let mantissas = few(40, start, step);
                for exponents in [[-15_i8; 8], [0, 1, -2, -3, -30, -40, -60, -50]] {
                    let material = Material::new(&exponents, &mantissas).expect("one");
                    let transfer = $module::transfer(&material).expect("it fits");
                    let general = BASIS.transfer::<WORKSPACE, TRANSFER, PROFILES>(&material);
                    assert_eq!(Ok(&transfer), general.as_ref());
                    for (start, step) in [(0, 1), (0, 100), (2, 3), (3, 100), (50, 9), (98, 100)] {
                        let mantissas = few(100, start, step);
                        let light = Light::new(3, &mantissas).expect("a light");
                        let d = $module::relight(&transfer.view(), &light).expect("it fits");
                        let general = BASIS.relight::<COMPONENTS>(&transfer.view(), &light);
                        assert_eq!(Ok(&d), general.as_ref());
                        let scene = $module::collapse(&d).expect("it fits");
                        let general = BASIS.collapse::<SCENE>(d.mantissas(), d.exponent());
                        assert_eq!(Ok((*scene).clone()), general);
                    }
                }
            }
        }
    };
}
sparse!(q15_agrees_of_few_coefficients, Q15, q15);
sparse!(q31_agrees_of_few_coefficients, Q31, q31);

/// Mantissas made on the device from f32 are those made on the host.
#[test]
fn inputs_are_quantized_alike() {
    for seed in [0.1, 0.5, 2.0, 1e-20, 1e20] {
        let values: Vec<f32> = numbers(100, 1.7).into_iter().map(|value| value * seed).collect();
        let wide: Vec<f64> = values.iter().copied().map(f64::from).collect();
        let (host, exponent) = quantize::row(&wide, 15, i64::MAX);
        let mut mantissas = [Q15::default(); 100];
        let light = Light::quantize(&values, &mut mantissas).expect("a light");
        let expected: Vec<Q15> = host.into_iter().map(Q15::of).collect();
        assert_eq!(Light::new(exponent.into(), &expected), Ok(light));
        let (host, exponents) = quantize::material(ORDER, &wide[..40], Format::Q31);
        let (mut mantissas, mut found) = ([Q31::default(); 40], [0; 8]);
        let material = Material::quantize(&values[..40], &mut mantissas, &mut found).expect("one");
        let expected: Vec<Q31> = host.into_iter().map(Q31::of).collect();
        assert_eq!(Material::new(&exponents, &expected), Ok(material));
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
        let transfer = q15::transfer(material).expect("it fits");
        let d = q15::relight(&transfer.view(), light).expect("it fits");
        assert!(d.mantissas().iter().all(|d| *d == 0));
        let scene = q15::collapse(&d).expect("it fits");
        assert!(normals().into_iter().all(|normal| scene.shade(normal) == 0));
    }
    let transfer = q15::transfer(&material).expect("it fits");
    let once = q15::relight(&transfer.view(), &light).expect("it fits");
    let mut scaled = [Q15::default(); 100];
    let values: Vec<f32> = mantissas.iter().map(|value| value * 1024.0).collect();
    let scaled = Light::quantize(&values, &mut scaled).expect("a light");
    let more = q15::relight(&transfer.view(), &scaled).expect("it fits");
    assert_eq!(more.mantissas(), once.mantissas());
    assert_eq!(more.exponent(), once.exponent() + 10);
}

/// Sums of light that need all their bits, and round beyond them.
#[test]
fn generated_ways_saturate_like_the_general_ones() {
    let mut numbers = [Q31(0); q31::TRANSFER];
    numbers[..2].fill(Q31(-i32::MAX));
    let light = [Q31(i32::MIN); 100];
    let light = Light::new(0, &light).expect("a light");
    let transfer = q31::BASIS.checked_transfer(&numbers, &[0; q31::PROFILES]).expect("it fits");
    let d = q31::relight(&transfer, &light).expect("it fits");
    assert_eq!(d.mantissas()[0], 1 << 30);
    assert_eq!(Ok(d), q31::BASIS.relight(&transfer, &light));
    let mut numbers = [Q15(0); q15::TRANSFER];
    numbers[..2].fill(Q15(-i16::MAX));
    let light = [Q15(i16::MIN); 100];
    let light = Light::new(0, &light).expect("a light");
    let transfer = q15::BASIS.checked_transfer(&numbers, &[0; q15::PROFILES]).expect("it fits");
    let d = q15::relight(&transfer, &light).expect("it fits");
    assert_eq!(Ok(d), q15::BASIS.relight(&transfer, &light));
}

/// A material whose exponents rise with the order, and a transfer by hand: the generated
/// functions give what the general ones give, bit for bit.
#[test]
fn generated_ways_are_the_general_ones() {
    let mantissas = quantize::row(
        &numbers(40, 1.3).into_iter().map(f64::from).collect::<Vec<_>>(),
        15,
        i64::MAX,
    )
    .0;
    let mantissas: Vec<Q15> = mantissas.into_iter().map(Q15::of).collect();
    for exponents in [[0_i8; 8], [0, 0, -3, 1, 9, 2, 14, 20], [9, 7, 5, 3, 1, 0, -1, -2]] {
        let material = Material::new(&exponents, &mantissas).expect("a material");
        let generated = q15::transfer(&material).expect("it fits");
        let general = q15::BASIS
            .transfer::<{ q15::WORKSPACE }, { q15::TRANSFER }, { q15::PROFILES }>(&material)
            .expect("it fits");
        assert_eq!(generated, general, "{exponents:?}");
    }
    let numbers = [Q15(i16::MIN); q15::TRANSFER];
    let transfer = Transfer::new(&numbers, &[0; q15::PROFILES]);
    let light = [Q15(i16::MIN); 100];
    let light = Light::new(0, &light).expect("a light");
    assert_eq!(q15::relight(&transfer, &light), Err(Error::Bound));
    let estimate = q15::BASIS.estimate::<50>().expect("fifty components");
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
    let beyond = Error::Beyond { argument: Argument::Material, basis: 7, found: 8 };
    assert_eq!(q15::transfer(&material), Err(beyond));
    let transfer = ([Q15(0); q15::TRANSFER], [0; q15::PROFILES]);
    let transfer = Transfer::new(&transfer.0, &transfer.1);
    let beyond = Error::Beyond { argument: Argument::Light, basis: 9, found: 10 };
    assert_eq!(q15::relight(&transfer, &light), Err(beyond));
    assert!(q15::BASIS.collapse_into(&[0; 51], 0, [0; q15::SCENE]).is_err());
    assert!(q15::BASIS.collapse_into(&[0; 50], 0, [0; 3]).is_err());
    for (x, y, z, error) in [
        (32_767, 32_767, 0, Error::Normal),
        (0, 0, 0, Error::Normal),
        (0, 32_767, -1, Error::Hidden),
        (i16::MIN, i16::MIN, i16::MIN, Error::Normal),
    ] {
        assert_eq!(Normal::<Q15>::new(Q15(x), Q15(y), Q15(z)), Err(error));
    }
    assert!(Normal::<Q15>::new(Q15(i16::MIN), Q15(0), Q15(0)).is_ok());
    // A row of factors whose sum can leave its accumulator.
    let parts = *q15::BASIS.parts();
    let mut factors = parts.factors.to_vec();
    factors[..3].fill(Q15(i16::MAX));
    assert!(matches!(Basis::<Q15>::new(Parts { factors: &factors, ..parts }), Err(Error::Bound)));
    // A profile whose terms are larger than it states.
    let mut profiles = parts.profiles.to_vec();
    profiles[5] = Profile::new(0, 0, [41, Profile::NONE], [142, 1091]);
    assert!(matches!(Basis::<Q15>::new(Parts { profiles: &profiles, ..parts }), Err(Error::Bound)));
    let of_transfers =
        Parts { polar: &[], polar_exponents: &[], factors: &[], factor_exponents: &[], ..parts };
    let of_transfers = Basis::<Q15>::new(of_transfers).expect("a basis of transfers");
    let material = Material::new(&[0], &numbers[..1]).expect("a material");
    let error = of_transfers
        .transfer::<{ q15::WORKSPACE }, { q15::TRANSFER }, { q15::PROFILES }>(&material);
    assert_eq!(error, Err(Error::TransfersOnly));
}

/// d from pixels one by one, against the mean in f64 of the same pixels and the table's
/// Chebyshev series.
#[test]
fn estimates_are_means() {
    let table = std::fs::read("tables/sphere.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&table).expect("a table");
    fn far<Q: Integer>(
        table: &eigenshade_table::Table,
        basis: &Basis<'_, Q>,
        irradiance: impl Fn(f64) -> Q,
        size: impl Fn(Q) -> f64,
    ) -> f64 {
        let mut estimate = basis.estimate::<50>().expect("fifty components");
        let (mut sums, mut weights) = (vec![0.0; 50], 0.0);
        for k in 0..5000_i32 {
            let z = (1.0 - (f64::from(k) + 0.5) / 5000.0).sqrt();
            let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * f64::from(k));
            let normal = [sine * tilt.cos(), sine * tilt.sin(), z];
            let seen = irradiance(0.6 * z * z + 0.3 * normal[0] * z - 0.2 * normal[1]);
            let weight = (k % 3 * 7) as u16;
            estimate.add(Q::normal(normal).expect("a normal"), seen, weight);
            let seen = size(seen) * f64::from(weight);
            weights += f64::from(weight);
            for (sum, component) in sums.iter_mut().zip(&table.components) {
                let series = &table.profiles[component.profile].chebyshev;
                let angle = (2.0 * z - 1.0).acos();
                let terms = series.iter().enumerate();
                let profile: f64 = terms.map(|(n, term)| term * (n as f64 * angle).cos()).sum();
                let order = f64::from(component.order);
                let around = match component.order {
                    0 => 1.0,
                    1.. => SQRT_2 * (order * tilt).cos(),
                    _ => SQRT_2 * (order * tilt).sin(),
                };
                *sum += seen * profile * sine.powf(order.abs()) * around;
            }
        }
        let found = estimate.coefficients(0).expect("there is a weight");
        let largest = sums.iter().fold(0.0f64, |most, sum| most.max((sum / weights).abs()));
        let found = found.mantissas().iter().map(|&d| f64::from(d) * 2f64.powi(found.exponent()));
        found
            .zip(sums)
            .fold(0.0, |most: f64, (d, sum)| most.max((d - sum / weights).abs() / largest))
    }
    let short = far(&table, &q15::BASIS, |x| Q15((16_384.0 * x) as i16), |q| f64::from(q.0));
    let long = far(&table, &q31::BASIS, |x| Q31((1e9 * x) as i32), |q| f64::from(q.0));
    println!("d from pixels: {short:.1e} in Q15, {long:.1e} in Q31");
    assert!(short <= ESTIMATE_Q15 && long <= ESTIMATE_Q31);
    let empty = q15::BASIS.estimate::<50>().expect("fifty components").coefficients(0);
    assert_eq!(empty, Err(Error::Weight));
    assert!(q15::BASIS.estimate::<49>().is_err());
}

/// However much may be left out, a profile that serves a component keeps a term: generated
/// functions have no blocks of none.
#[test]
fn profiles_keep_a_term() {
    let bytes = std::fs::read("tables/sphere.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&bytes).expect("a table");
    let parts = quantize::integers(&table, Format::Q15, 1e9).expect("parts");
    let served = table.profiles.iter().map(|profile| profile.azimuth).max().expect("profiles");
    assert_eq!(parts.lengths[..=served], vec![1; served + 1]);
}

/// Unit vectors along integers of any scale, within a unit of a component in Q15 and three in Q31:
/// against f64.
#[test]
fn normals_along_integers_are_unit_vectors() {
    fn check<Q: Copy>(
        along: impl Fn(i32, i32, i32) -> Result<Normal<Q>, Error>,
        components: impl Fn(Normal<Q>) -> [f64; 3],
        bits: i32,
    ) {
        let mut state = 1u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 32) as i32
        };
        for round in 0..20_000 {
            let shift = round % 31;
            let vector = [random() >> shift, random() >> (shift / 2), random() >> shift];
            let [x, y, z] = vector.map(f64::from);
            let length = x.hypot(y).hypot(z);
            let found = along(vector[0], vector[1], vector[2]);
            if vector == [0; 3] {
                assert_eq!(found.err(), Some(Error::Normal));
                continue;
            }
            if z < -0.125 * length {
                assert_eq!(found.err(), Some(Error::Hidden), "{vector:?}");
                continue;
            }
            let (z, length) = if z < 0.0 { (0.0, x.hypot(y)) } else { (z, length) };
            let found = components(found.expect("visible"));
            for (found, component) in found.into_iter().zip([x, y, z]) {
                let exact = (component / length * 2f64.powi(bits)).min(2f64.powi(bits) - 1.0);
                let most = if bits == 15 { 1.0 } else { 3.0 };
                assert!((found - exact).abs() <= most, "{vector:?}: {found} {exact}");
            }
        }
    }
    let of_15 = |normal: Normal<Q15>| normal.components().map(|c| f64::from(c.0));
    check(Normal::<Q15>::along, of_15, 15);
    let of_31 = |normal: Normal<Q31>| normal.components().map(|c| f64::from(c.0));
    check(Normal::<Q31>::along, of_31, 31);
    for extreme in
        [[i32::MIN; 3], [i32::MAX; 3], [i32::MIN, 0, 0], [0, i32::MIN, 1], [0, 0, i32::MAX]]
    {
        let [x, y, z] = extreme;
        let found = Normal::<Q31>::along(x, y, z);
        assert_eq!(found.is_err(), x == z && z < 0, "{extreme:?}");
    }
    assert_eq!(Normal::<Q15>::along(0, 0, -1), Err(Error::Hidden));
    assert_eq!(Normal::<Q15>::along(0, 0, 0), Err(Error::Normal));
}

/// The mantissa of a number in 31 bits with the least exponent, 2^-127.
#[test]
fn subnormal_numbers_keep_their_size() {
    for (number, expected) in [(0x7f_ffff, 2), (0x40_0000, 1), (0x1f_ffff, 0), (0x80_0000, 2)] {
        let mut mantissas = [Q31(0)];
        let light = Light::quantize(&[f32::from_bits(number)], &mut mantissas).expect("a light");
        assert_eq!(light.exponent(), -127);
        assert_eq!(mantissas, [Q31(expected)], "{number:x}");
    }
}

#[test]
fn normals_are_rounded_to_the_nearest() {
    // 2^15 by √3 is 18,918.6, and by √5 it is 14,654.3, twice of which is 29,308.6.
    for (along, expected) in [([1, 1, 1], [18_919; 3]), ([-2, 0, 1], [-29_309, 0, 14_654])] {
        let normal = Normal::<Q15>::along(along[0], along[1], along[2]).expect("a normal");
        assert_eq!(normal.components(), expected.map(Q15));
    }
}

/// Mantissas are symmetrical, and products are rounded to the nearest.
#[test]
fn numbers_saturate_alike_and_round_to_the_nearest() {
    for (number, expected) in [(-40_000, -32_767), (-32_768, -32_767), (32_768, 32_767), (5, 5)] {
        assert_eq!(Q15::saturate(number), Q15(expected));
    }
    for (number, expected) in [(i64::MIN, -i32::MAX), (i64::MAX, i32::MAX), (-7, -7)] {
        assert_eq!(Q31::saturate(number), Q31(expected));
    }
    let half = 1 << 29;
    for (number, expected) in [(half, 1), (half - 1, 0), (-half, 0), (-half - 1, -1)] {
        assert_eq!(Q31::seen(Q31(number), 1), expected);
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
        for normal in normals::<Q15>() {
            let coarse = f64::from(coarse.shade(normal)) * units[0];
            let fine = f64::from(fine.shade(normal)) * units[1];
            assert!((coarse - fine).abs() <= SMALL_D * units[0], "{d}: {coarse}, {fine}");
        }
    }
}

/// The generated functions refuse exponents that rise with the order, and the general ones serve
/// them.
#[test]
fn exponents_may_rise_with_the_order() {
    let mantissas = [Q15(32_767); 40];
    for exponents in [[-20, -20, -16, -18, -13, -12, -9, -9], [-20, -9, -20, -9, -9, -20, -20, -9]]
    {
        let material = Material::new(&exponents, &mantissas).expect("a material");
        let found = q15::transfer(&material).expect("it fits");
        let expected = q15::BASIS
            .transfer::<{ q15::WORKSPACE }, { q15::TRANSFER }, { q15::PROFILES }>(&material)
            .expect("it fits");
        assert_eq!(found, expected);
    }
}
