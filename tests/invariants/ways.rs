//! The public interface beside the pixel: any bits never panic, and every way to a pixel keeps near
//! the polynomials.

use super::Reader;
use eigenshade::mathematics::{Libm, SinglePrecision, Tabled};
use eigenshade::quantized;
use eigenshade::{
    Light, MapPoint, NegativePolicy, Normal, Normals, Q15, Q31, Rotation, Tolerance, Truncation,
    Window, sphere,
};
use eigenshade_index::{light, material};

/// Energy of a light of any moderate numbers that was turned in f32.
const TURNED_ENERGY: f64 = 5e-6;

/// Look-ups of 8 knots and maps of 2 x 2 against their polynomials, of Σ |d|: the largest |U| is
/// some 10, and that of a polynomial continued beyond the rim ten times that.
const LARGEST_IMAGE: f64 = 100.0;

const LIGHT: usize = light::count(sphere::DEGREE);
const TURN: usize = Light::<f32>::turn_len(sphere::DEGREE);

/// Look-ups, baking, rotation, windows, truncation, estimates and sizes, of any numbers.
pub fn every_way(input: &mut Reader<'_>) {
    indices(input);
    let is_moderate = input.byte().is_multiple_of(2);
    let rotation = any_rotation(input);
    let any = |input: &mut Reader<'_>| match is_moderate {
        true => input.moderate(),
        false => f32::from_le_bytes(input.bytes()),
    };
    let coefficients: Vec<f32> = (0..LIGHT).map(|_| any(input)).collect();
    let light = Light::new(&coefficients).expect("a light");
    turn(&light, &rotation, is_moderate);
    let d: [f32; sphere::COMPONENTS] = std::array::from_fn(|_| any(input));
    look_up(&d, input, is_moderate);
}

fn float(input: &mut Reader<'_>) -> f32 {
    f32::from_le_bytes(input.bytes())
}

/// Sizes and places of anything: meaningless at worst.
fn indices(input: &mut Reader<'_>) {
    let [a, b, c] = [(); 3].map(|()| u64::from_le_bytes(input.bytes()) as usize);
    let _ = (light::position(a, b.cast_signed()), material::position(a, b, c), light::count(a));
    let _ = (eigenshade_index::pair::position(a, b), eigenshade_index::pair::count(a));
    let _ = (eigenshade_index::layout::factors(a, b, c, a), material::count(a));
    let _ = (Light::<f32>::turn_len(a), Light::<f32>::new(&[0.0; 30][..b % 31]));
    let _ = eigenshade::Material::<f32>::checked(&[0.0; 30][..c % 31]);
}

/// Of any numbers an error, or a matrix that is a rotation.
fn any_rotation(input: &mut Reader<'_>) -> Rotation<f32> {
    let mut rotation = Rotation::NONE;
    for _ in 0..input.up_to(4) {
        let found = match input.byte() % 5 {
            0 => Rotation::from_quaternion([(); 4].map(|()| float(input))),
            1 => {
                let quaternion = [(); 4].map(|()| f32::from(input.byte().cast_signed()));
                Rotation::from_quaternion(quaternion)
            }
            2 => Rotation::from_euler::<Libm>(float(input), float(input), float(input)),
            3 => {
                let [a, b, c] = [(); 3].map(|()| f32::from(input.byte().cast_signed()) / 40.0);
                Rotation::from_euler::<SinglePrecision>(a, b, c)
            }
            _ => {
                // Next to a rotation, or anything.
                let change = f32::from(input.byte().cast_signed()) * 1e-5;
                let mut matrix = rotation.matrix();
                matrix[usize::from(input.byte() % 3)][usize::from(input.byte() % 3)] += change;
                Rotation::from_matrix(matrix)
            }
        };
        let Ok(found) = found else { continue };
        rotation = found.after(rotation);
        for (i, a) in rotation.matrix().iter().enumerate() {
            for (j, b) in rotation.matrix().iter().enumerate() {
                let product: f64 =
                    a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum();
                let off = (product - f64::from(u8::from(i == j))).abs();
                assert!(off <= super::ORTHONORMAL_F32, "{off:e}: {rotation:?}");
            }
        }
    }
    rotation
}

/// Turned and windowed light: finite of moderate numbers, of the same energy.
fn turn(light: &Light<'_, f32>, rotation: &Rotation<f32>, is_moderate: bool) {
    let turned = light.turned::<LIGHT, TURN>(rotation).expect("room");
    for width in [0.5, 10.0, f32::NAN] {
        let window = Window::SincFourth { width };
        let windowed = light.windowed::<Tabled, LIGHT>(window).expect("room");
        assert!(!is_moderate || windowed.iter().all(|value| value.is_finite()));
    }
    if !is_moderate {
        return;
    }
    let energy = |values: &[f32]| values.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>();
    let (before, after) = (energy(light.coefficients()), energy(&turned));
    // What is subnormal in f32 is lost.
    let off = (after - before).abs();
    assert!(off <= TURNED_ENERGY * before + 1e-30, "{before:e} {after:e}");
}

/// Every way to the pixels of any image.
fn look_up(d: &[f32; sphere::COMPONENTS], input: &mut Reader<'_>, is_moderate: bool) {
    let scene = sphere::BASIS.collapse::<{ sphere::SCENE }>(d).expect("sizes");
    let knots = 8 + input.up_to(56);
    let size = 2 + input.up_to(30);
    let lookup = scene.sampled_into(knots, vec![0.0; scene.sampled_len::<f32>(knots)]);
    let lookup = lookup.expect("knots");
    let map = scene.bake_into(size, vec![0.0; size * size]).expect("a size");
    let integers = scene.bake_integers_into(size, vec![0; size * size]);
    assert!(!is_moderate || integers.is_ok(), "{:?}", integers.err());
    let (mut lengths, mut report) = ([0; sphere::DEGREE + 1], [Truncation::default()]);
    let tolerance = Tolerance::Decibels(input.byte().max(1));
    let mut room = [0.0; sphere::SCENE];
    let shape = sphere::BASIS
        .collapse_set_within(&[d], 1, tolerance, &mut lengths, &mut room, &mut report)
        .expect("sizes");
    let within = shape.scene(&room).expect("numbers");
    let mut estimate = sphere::BASIS.estimate::<{ sphere::COMPONENTS }>().expect("room");
    let mut of_integers = sphere::q15::BASIS.estimate::<{ sphere::COMPONENTS }>().expect("room");
    while !input.is_empty() {
        let vector = [(); 3].map(|()| float(input));
        let [x, y, z] = vector.map(|c| [c]);
        let raw = Normals::new(&x, &y, &z).expect("one length").iter().next().expect("one");
        let point = MapPoint::new(x[0], y[0]);
        let _ = (lookup.linear(raw), lookup.cubic(raw), map.bilinear(point), map.nearest(point));
        let _ = (map.bilinear(MapPoint::of(raw)), within.shade(raw), MapPoint::of(raw).direction());
        let [u, v] = vector.map(|c| Q15((c.to_bits() >> 16) as u16 as i16))[..2] else {
            unreachable!("two of three")
        };
        if let Ok(integers) = &integers {
            let point = MapPoint::new(u, v);
            let _ = (integers.bilinear(point), integers.nearest(point));
        }
        let [a, b, c] = vector.map(|c| c.to_bits().cast_signed());
        if let Ok(normal) = quantized::Normal::<Q15>::along(a, b, c) {
            let [x, y, z] = normal.components();
            assert!(quantized::Normal::<Q15>::new(x, y, z).is_ok(), "{normal:?} is no unit vector");
            of_integers.add(normal, u, b as u16);
        }
        if let Ok(normal) = quantized::Normal::<Q31>::along(a, b, c) {
            let [x, y, z] = normal.components();
            assert!(quantized::Normal::<Q31>::new(x, y, z).is_ok(), "{normal:?} is no unit vector");
        }
        estimate.add(raw, y[0], z[0]);
        let [mut x, mut y, mut z] = [x, y, z];
        let Ok(normals) = Normals::normalized::<Libm>(&mut x, &mut y, &mut z) else { continue };
        let normal = normals.iter().next().expect("one");
        if !is_moderate {
            continue;
        }
        let exact = scene.shade(normal);
        let most = d.iter().map(|d| f64::from(d.abs())).sum::<f64>() * LARGEST_IMAGE;
        for found in
            [lookup.linear(normal), lookup.cubic(normal), map.bilinear(MapPoint::of(normal))]
        {
            // Eight knots and four texels are coarse; but they stay in proportion.
            assert!(f64::from((found - exact).abs()) <= most, "{found} {exact}");
        }
        assert!(NegativePolicy::Clamped.of(exact) >= 0.0);
    }
    let (_, _): (Result<_, _>, Result<_, _>) =
        (estimate.coefficients(), of_integers.coefficients(i32::from(u16::MAX)));
    let _ = of_integers.coefficients(-15);
    let normal = Normal::new(0.0, 0.6, 0.8).expect("visible");
    assert!(!is_moderate || within.shade(normal).is_finite());
}
