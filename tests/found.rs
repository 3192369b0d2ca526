//! Inputs that once overflowed, lost what they should keep, or gave what is not so: each
//! found by any bytes, by name.

use eigenshade::q15::{Basis, Light, Material, Parts, Profile, Transfer};
use eigenshade::{Error, Normal, Q15};
use eigenshade_table::record::Azimuth;

const NONE: u16 = Profile::NONE;

/// A basis of degree 1 that takes transfers alone: one component of m = 0, and of m = 1
/// one of +m and one of -m.
fn of_transfers(terms: &[Q15]) -> Parts<'_> {
    const PLACES: [Profile; 2] = [
        Profile::new(0, -3, [0, NONE], [u16::MAX, u16::MAX]),
        Profile::new(1, -3, [1, 2], [u16::MAX, u16::MAX]),
    ];
    const AZIMUTHS: [Azimuth; 2] = [
        Azimuth { first: 0, profiles: 1, start: 0, terms: 0, rows: 0 },
        Azimuth { first: 1, profiles: 1, start: 1, terms: 1, rows: 2 },
    ];
    Parts {
        degree: 1,
        order: 0,
        components: 3,
        profiles: &PLACES,
        azimuths: &AZIMUTHS,
        lengths: &[1, 1],
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        terms,
    }
}

fn transferred<'a>(
    basis: &Basis<'_>,
    material: &Material<'_>,
    numbers: &'a mut [Q15],
    exponents: &'a mut [i16],
) -> Transfer<'a> {
    let mut workspace = vec![0; basis.workspace_len()];
    basis.transfer_into(material, &mut workspace, numbers, exponents).expect("it fits");
    Transfer::new(numbers, exponents)
}

/// Coefficients of a high o meet Ĉ of a low one, so their sum's exponent is neither's: it
/// overflowed.
#[cfg(feature = "baked")]
#[test]
fn exponents_that_rise_with_the_order() {
    use eigenshade::sphere::q15::{BASIS, PROFILES, TRANSFER};
    let mut alone = [Q15(0); 40];
    for k in [25, 30, 38] {
        alone[k] = Q15(32_767);
    }
    let image = |exponents: [i8; 8]| {
        let material = Material::new(&exponents, &alone).expect("a material");
        let (mut numbers, mut of_profiles) = ([Q15(0); TRANSFER], [0; PROFILES]);
        transferred(&BASIS, &material, &mut numbers, &mut of_profiles);
        (numbers, of_profiles)
    };
    // What stands below is zero, and has one exponent or another.
    let (numbers, exponents) = image([-128, -128, -128, -128, -128, -128, 100, 100]);
    let (same, lower) = image([100; 8]);
    for ((a, b), k) in numbers.iter().zip(&same).zip(0..) {
        assert!((a.0 - b.0).abs() <= 1, "number {k}: {a:?}, {b:?}");
    }
    assert_eq!(exponents, lower);
}

/// An order without coefficients had the exponent of 1, and took the bits of all others.
#[cfg(feature = "baked")]
#[test]
fn an_order_of_zeros() {
    use eigenshade::sphere::q15;
    let scaled = |scale: f32| {
        let mut material = [0.0; 40];
        for k in [0, 2, 3, 4] {
            material[k] = scale / (k as f32 + 1.0);
        }
        let (mut mantissas, mut exponents) = ([Q15(0); 40], [0; 8]);
        let material = Material::quantize(&material, &mut mantissas, &mut exponents);
        q15::transfer(&material.expect("a material")).expect("it fits")
    };
    let (one, small) = (scaled(1.0), scaled(f32::from_bits((127 - 60) << 23)));
    let light = [Q15(32_767); 100];
    let light = Light::new(0, &light).expect("a light");
    let (one, small) = (q15::relight(&one.view(), &light), q15::relight(&small.view(), &light));
    let (one, small) = (one.expect("it fits"), small.expect("it fits"));
    assert_eq!(one.mantissas(), small.mantissas());
    assert_eq!(one.exponent(), small.exponent() + 60);
}

/// The exponent of coefficients by hand overflowed the scene's.
#[cfg(feature = "baked")]
#[test]
fn exponents_of_coefficients_by_hand() {
    use eigenshade::q15::Coefficients;
    use eigenshade::sphere::q15::{BASIS, SCENE};
    for exponent in [i32::MAX, i32::MIN, 65_537, -65_537] {
        assert_eq!(BASIS.collapse::<SCENE>(&[1 << 29], exponent).err(), Some(Error::Exponent));
        assert_eq!(Coefficients::<1>::new([1 << 29], exponent), Err(Error::Exponent));
    }
    for exponent in [65_536, -65_536] {
        let scene = BASIS.collapse::<SCENE>(&[1 << 29], exponent).expect("an exponent");
        let found = scene.exponent() - exponent;
        let at_zero = BASIS.collapse::<SCENE>(&[1 << 29], 0).expect("an exponent");
        assert_eq!((found, scene.terms()), (at_zero.exponent(), at_zero.terms()));
    }
}

/// Profiles of the largest stated size under the largest coefficients: a product of 32
/// bits overflowed.
#[test]
fn sizes_at_their_largest() {
    let parts = of_transfers(&[Q15(32_767), Q15(32_767)]);
    let basis = Basis::new(parts).expect("parts that fit");
    for d in [i32::MIN, i32::MAX] {
        let scene = basis.collapse::<3>(&[d; 3], 0).expect("it fits");
        // 3 * 2^31 * 4096 in 17 bits.
        assert!(scene.exponent() >= 28);
    }
}

/// Any numbers could be a transfer, and their sums with a light wrapped.
#[test]
fn transfers_by_hand() {
    let parts = of_transfers(&[Q15(1), Q15(1)]);
    let basis = Basis::new(parts).expect("parts that fit");
    let light = [Q15(i16::MIN); 4];
    let light = Light::new(0, &light).expect("a light");
    let relight = |numbers: &[Q15; 3]| basis.relight::<3>(&Transfer::new(numbers, &[0; 2]), &light);
    let most = [Q15(i16::MIN), Q15(32_767), Q15(i16::MIN)];
    let sums = relight(&most).expect("rows within their bounds");
    // -2^15 (-2^15 + 2^15 - 1), and 2^30 either way, in units of 2.
    assert_eq!((sums.mantissas(), sums.exponent()), ([1 << 14, 1 << 29, -(1 << 29)].as_slice(), 1));
    let more = [Q15(i16::MIN), Q15(i16::MIN), Q15(0)];
    assert_eq!(relight(&more), Err(Error::Bound));
    assert_eq!(basis.checked_transfer(&more, &[0; 2]).err(), Some(Error::Bound));
    assert!(basis.checked_transfer(&most, &[0; 2]).is_ok());
    assert!(matches!(basis.checked_transfer(&most, &[0]), Err(Error::Length { .. })));
    assert!(matches!(basis.checked_transfer(&most[1..], &[0; 2]), Err(Error::Length { .. })));
}

/// A vector so short that its square has few bits gave a normal of another length.
#[test]
fn short_normals() {
    assert_eq!(Normal::new(1e-20f32, 0.0, 2e-20), Err(Error::Normal));
    assert_eq!(Normal::new(f32::MIN_POSITIVE, 0.0, 0.0), Err(Error::Normal));
    let [x, y, z] = Normal::new(3e-18f32, 0.0, 4e-18).expect("a normal").components();
    assert!((x - 0.6).abs() < 1e-6 && y == 0.0 && (z - 0.8).abs() < 1e-6);
}

/// More profiles or degrees than a sum's rounding leaves room for, and an order whose
/// pairs cannot be counted.
#[test]
fn bases_out_of_all_proportion() {
    let places: Vec<_> = (0..512).map(|k| Profile::new(0, 0, [k, NONE], [16, 16])).collect();
    let terms = vec![Q15(1); 512];
    let azimuths =
        [511, 512].map(|profiles| [Azimuth { first: 0, profiles, start: 0, terms: 0, rows: 0 }]);
    let of = |count: usize| Parts {
        degree: 0,
        components: count,
        profiles: &places[..count],
        azimuths: &azimuths[count - 511],
        lengths: &[1],
        terms: &terms[..count],
        ..of_transfers(&[])
    };
    assert_eq!(Basis::new(of(512)).err(), Some(Error::Bound));
    assert!(Basis::new(of(511)).is_ok());
    let high = |degree, order| Some(Error::High { degree, order });
    assert_eq!(Basis::new(Parts { degree: 13, ..of(511) }).err(), high(13, 0));
    assert_eq!(Basis::new(Parts { order: usize::MAX, ..of(511) }).err(), high(0, usize::MAX));
}

/// Two profiles of one component, and another without: d was scaled twice.
#[test]
fn a_component_of_two_profiles() {
    let of = |places: [Profile; 2]| {
        let parts = of_transfers(&[Q15(1), Q15(1)]);
        Basis::new(Parts { profiles: &places, ..parts }).err()
    };
    let first = Profile::new(0, 0, [0, NONE], [16, 16]);
    assert_eq!(of([first, Profile::new(1, 0, [1, 0], [16, 16])]), Some(Error::Parts));
    assert_eq!(of([first, Profile::new(1, 0, [1, 1], [16, 16])]), Some(Error::Parts));
    assert_eq!(of([first, Profile::new(1, 0, [2, 1], [16, 16])]), None);
}
