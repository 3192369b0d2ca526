//! Lights turned in integers: against the generator's rotations in f64, and the same bits on every
//! machine.

use crate::invariants::integer::Mantissa as _;
use crate::oracle::Numbers;
use eigenshade::q15::{Light, LightBuffer, Rotation};
use eigenshade::{Argument, Error, Q15, Rgb};
use eigenshade_model::rotation;
use eigenshade_testing::largest;
use std::f64::consts::PI;

/// The error of a coefficient, of the root of the energy of its degree: as documented. A dozen
/// roundings of numbers of 15 bits.
const OF_ENERGY: f64 = 1.0 / 4_096.0;

/// A number from -1 to 1, cut off to a mantissa.
fn fraction(number: f64) -> Q15 {
    Q15((number * 32_767.0) as i16)
}

/// The coefficients of a light.
fn values(light: Light<'_>) -> Vec<f64> {
    let scale = f64::from(light.exponent()).exp2();
    light.mantissas().iter().map(|mantissa| mantissa.mantissa() as f64 * scale).collect()
}

/// The largest error of a coefficient, less `units` of the mantissas, relative to the root of the
/// energy of its degree.
fn worst(light: Light<'_>, exact: &[f64], found: Light<'_>, units: f64) -> f64 {
    let unit = f64::from(found.exponent()).exp2();
    let found = values(found);
    let degree = (exact.len() as f64).sqrt() as usize - 1;
    largest((0..=degree).map(|l| {
        let apart = largest((l * l..(l + 1) * (l + 1)).map(|k| found[k] - exact[k]));
        let over = (apart - 1.0001 * units * unit).max(0.0);
        if over > 0.0 { over / energy(&values(light), l).sqrt() } else { 0.0 }
    }))
}

/// The energy of a degree.
fn energy(light: &[f64], l: usize) -> f64 {
    light[l * l..(l + 1) * (l + 1)].iter().map(|x| x * x).sum()
}

/// Angles in general, at the poles, next to them, and half turns.
fn angles() -> Vec<[f64; 3]> {
    let mut numbers = Numbers(21);
    let mut angles: Vec<_> = (0..300).map(|_| [0; 3].map(|_| PI * numbers.next())).collect();
    let special = [0.0, 1e-9, 1e-4, 0.14, 0.5 * PI, PI - 1e-6, PI];
    angles.extend(special.iter().flat_map(|&a| [[0.3, a, -0.7], [a, 0.0, a], [0.0, -a, 0.0]]));
    angles
}

/// The quaternion of Euler angles, to 30 bits.
fn quaternion([a, b, c]: [f64; 3]) -> [i32; 4] {
    let (sb, cb) = (0.5 * b).sin_cos();
    let (sum, difference) = (0.5 * (a + c), 0.5 * (a - c));
    [-sb * difference.sin(), sb * difference.cos(), cb * sum.sin(), cb * sum.cos()]
        .map(|x| (x * 1_073_741_823.0).round() as i32)
}

/// Lights of one size, of falling size, of one order, of nothing but one coefficient.
fn lights(degree: usize, numbers: &mut Numbers) -> Vec<Vec<Q15>> {
    let count = (degree + 1) * (degree + 1);
    let noise = |numbers: &mut Numbers| (0..count).map(|_| numbers.next()).collect::<Vec<_>>();
    let falling = noise(numbers).iter().enumerate().map(|(k, x)| x / (1 + k) as f64).collect();
    let full = noise(numbers).iter().map(|x| x.signum()).collect();
    let mut single = vec![0.0; count];
    single[count - 1 - degree] = -1.0;
    let faint = noise(numbers).iter().map(|x| x * 0.003).collect();
    [noise(numbers), falling, full, single, faint]
        .map(|light: Vec<f64>| light.into_iter().map(fraction).collect())
        .into()
}

fn agrees(most: f64) {
    let (mut numbers, mut found) = (Numbers(22), 0.0f64);
    for degree in [1, 2, 9, 12, 16] {
        for (round, angles) in angles().into_iter().enumerate() {
            let [a, b, c] = angles;
            let reference = rotation::Rotation { alpha: b, beta: a, gamma: c };
            let of_quaternion = Rotation::from_quaternion(quaternion(angles)).expect("a rotation");
            let [a, b, c] = angles.map(|angle| angle as f32);
            let floats = eigenshade::Rotation::from_euler(a, b, c).expect("a rotation");
            for mantissas in lights(degree, &mut numbers).iter().skip(round % 2).step_by(2) {
                let light = Light::new(-3, mantissas).expect("a light");
                let exact = reference.turn(degree, &values(light));
                let rotations = [of_quaternion, Rotation::quantize(&floats)];
                for rotation in rotations.iter().take(2) {
                    let turned = light.turned::<289>(rotation).expect("room");
                    found = found.max(worst(light, &exact, turned.light().expect("a light"), 0.5));
                }
            }
        }
    }
    println!("q15: 2^{:.2}", found.log2());
    assert!(found <= most, "{found:e}");
}

#[test]
fn light_turned_in_integers_is_the_generators() {
    agrees(OF_ENERGY);
}

/// By nothing, nothing changes.
#[test]
fn no_turn_changes_nothing() {
    let mut numbers = Numbers(23);
    let mut full: Vec<Q15> =
        (0..100).map(|k| fraction(numbers.next() / f64::from(1 + k))).collect();
    full[0] = Q15(-32_767);
    let light = Light::new(-15, &full).expect("a light");
    for rotation in [
        Rotation::NONE,
        Rotation::from_quaternion([0, 0, 0, -7]).expect("a rotation"),
        Rotation::quantize(&eigenshade::Rotation::NONE),
    ] {
        assert_eq!(rotation, Rotation::NONE);
        let turned = light.turned::<100>(&rotation).expect("room");
        assert_eq!(turned.light().expect("a light"), light);
    }
    let turned = light.turned_about_view::<100>([5, 0]).expect("room");
    assert_eq!(turned.light().expect("a light"), light);
}

/// About the view axis, in buffers of every length: against the generator. Some coefficients take
/// one bit more.
#[test]
fn turned_about_the_view_is_the_generators() {
    fn agrees(most: f64) {
        let (mut numbers, mut found, mut larger) = (Numbers(27), 0.0f64, 0);
        // Of any scale, and as fractions of 2^30.
        let scales = [1e9, 1_073_741_824.0];
        for (degree, scale) in [0, 1, 9, 12].into_iter().flat_map(|l| scales.map(|s| (l, s))) {
            for [angle, ..] in angles() {
                let exact = rotation::Rotation { alpha: 0.0, beta: angle, gamma: 0.0 };
                let along = [angle.cos(), angle.sin()].map(|x| (x * scale).round() as i32);
                for mantissas in lights(degree, &mut numbers) {
                    let light = Light::new(-3, &mantissas).expect("a light");
                    let turned = light.turned_about_view::<169>(along).expect("room");
                    if degree == 9 {
                        let exact = light.turned_about_view::<100>(along).expect("room");
                        assert_eq!(exact.light(), turned.light());
                    }
                    let turned = turned.light().expect("a light");
                    let exact = exact.turn(degree, &values(light));
                    found = found.max(worst(light, &exact, turned, 1.5));
                    larger += i32::from(turned.exponent() > -3);
                }
            }
        }
        println!("q15: 2^{:.2}, larger {larger}", found.log2());
        assert!(found <= most && larger > 0, "{found:e}");
    }
    agrees(OF_ENERGY);
}

/// All channels at once are each channel by itself, of other degrees too.
#[test]
fn color_is_each_channel() {
    let mut numbers = Numbers(24);
    let channels = [100, 16, 49]
        .map(|count: usize| -> Vec<Q15> { (0..count).map(|_| fraction(numbers.next())).collect() });
    let lights =
        Rgb::from(channels.each_ref().map(|channel| Light::new(-15, channel).expect("a light")));
    let rotation = Rotation::from_quaternion([1, -2, 3, 5]).expect("a rotation");
    let turned = lights.turned::<100>(&rotation).expect("room");
    for (turned, light) in <[_; 3]>::from(turned.zip(lights)) {
        assert_eq!(turned, light.turned::<100>(&rotation).expect("room"));
    }
    let mut turned = lights.turned_about_view::<100>([1, 1]).expect("room");
    lights.turn_about_view_into([3, -4], &mut turned).expect("room");
    assert_eq!(lights.turned_about_view::<100>([3, -4]).as_ref(), Ok(&turned));
    for (turned, light) in <[_; 3]>::from(turned.zip(lights)) {
        assert_eq!(turned, light.turned_about_view::<100>([3, -4]).expect("room"));
    }
}

/// The bits of a sequence of turns, as found once.
#[test]
fn turned_bits_are_the_same_everywhere() {
    fn checksum() -> u32 {
        let mut numbers = Numbers(25);
        let mantissas: Vec<Q15> = (0..100).map(|_| fraction(numbers.next())).collect();
        let light = Light::new(-15, &mantissas).expect("a light");
        let mut turned: LightBuffer<100> = light.turned(&Rotation::NONE).expect("room");
        let mut found = Vec::new();
        for k in 0..20 {
            let rotation =
                Rotation::from_quaternion([k, 3 - k, 2 * k - 9, 11]).expect("a rotation");
            turned = turned.light().and_then(|light| light.turned(&rotation)).expect("room");
            let light = turned.light().expect("a light");
            found.extend(light.mantissas().iter().flat_map(|mantissa| mantissa.0.to_le_bytes()));
            found.extend(light.exponent().to_le_bytes());
        }
        crc32fast::hash(&found)
    }
    assert_eq!(checksum(), 1_175_991_823);
}

#[test]
fn what_cannot_be_turned_is_an_error() {
    assert_eq!(Rotation::from_quaternion([0; 4]), Err(Error::Rotation));
    let none = Rotation::NONE;
    let mantissas = [Q15(i16::MAX); 324];
    let light = Light::new(-15, &mantissas).expect("a light");
    assert_eq!(
        light.turned::<324>(&none).map(|_| ()),
        Err(Error::Beyond { argument: Argument::Light, most: 16, found: 17 })
    );
    let light = Light::new(-15, &mantissas[..196]).expect("a light");
    assert_eq!(
        light.turned_about_view::<196>([1, 0]),
        Err(Error::Beyond { argument: Argument::Light, most: 12, found: 13 })
    );
    let light = Light::new(-15, &mantissas[..100]).expect("a light");
    let error = Error::Capacity { argument: Argument::Light, needed: 100, capacity: 99 };
    assert_eq!(light.turned::<99>(&none), Err(error));
    assert_eq!(light.turned_about_view::<99>([1, 0]), Err(error));
    assert_eq!(light.turned_about_view::<100>([0, 0]), Err(Error::Rotation));
    // The energy of a degree in one coefficient takes more bits.
    let quarter = Rotation::from_quaternion([1, 1, 0, 1]).expect("a rotation");
    let of_exponent = |exponent| Light::new(exponent, &mantissas[..100]).expect("a light");
    assert!(of_exponent(124).turned::<100>(&quarter).is_ok());
    assert_eq!(of_exponent(128).turned::<100>(&quarter), Err(Error::Exponent));
    assert_eq!(of_exponent(128).turned_about_view::<100>([1, 1]), Err(Error::Exponent));
    let zeros = [Q15(0); 100];
    let turned = Light::new(128, &zeros).and_then(|light| light.turned::<100>(&quarter));
    assert_eq!(turned.and_then(|turned| Ok(turned.light()?.exponent())), Ok(-96 - 15));
}

/// Mantissas and quaternions of any bits: nothing overflows, and the energy of each degree stays.
#[test]
fn any_bits_turn() {
    let mut numbers = Numbers(26);
    let mut any = || (numbers.next() * 2_147_483_648.0) as i32;
    for round in 0..3_000 {
        let shift = round % 31;
        let quaternion = [any(), any(), any() >> shift, any() >> (30 - shift)];
        let quaternion =
            if round % 50 == 0 { [i32::MIN, i32::MAX, 0, i32::MIN] } else { quaternion };
        let rotation = Rotation::from_quaternion(quaternion).expect("a rotation");
        let mantissas: [Q15; 289] =
            std::array::from_fn(|_| Q15((any() >> 16 >> (shift / 3)) as i16));
        let light = Light::new(0, &mantissas).expect("a light");
        let turned = light.turned::<289>(&rotation).expect("room");
        let turned = turned.light().expect("a light");
        let unit = f64::from(turned.exponent()).exp2();
        let (before, after) = (values(light), values(turned));
        for l in 0..=16 {
            let [before, after] = [&before, &after].map(|values| energy(values, l).sqrt());
            let allowed = 5.0 * OF_ENERGY * before + 5.0 * unit;
            assert!((before - after).abs() <= allowed, "{before} {after}");
        }
    }
}
