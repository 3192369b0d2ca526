//! Every way to a pixel. Projection, then reconstruction, in every format, against f64; the public
//! interface beside the pixel: any bits never panic, and every way keeps near the polynomials.

use super::Reader;
use super::drawing::drawing;
use super::integer::{Mantissa as _, Relit, normal, normals, shipped};
use super::shading::{ANY_PIXEL_Q15, near};
use eigenshade::lights::Window;
use eigenshade::object::MapPoint;
use eigenshade::screen::NegativePolicy;
use eigenshade::truncation::{Tolerance, Truncation};
use eigenshade::{Effect, Light, Material, Normal, Normals, Q15, Rotation, q15, sphere};
use eigenshade_table::record::ProfilePlace;
use eigenshade_table::{light, material};

/// d of any light and material, of what its addends could be, all of the largest size and of one
/// sign: some roundings of 24 bits, of addends far smaller.
const ANY_D_F32: f64 = 2e-8;

/// Any light and material of moderate size, rounded to each format by the runtime.
pub fn project_reconstruct(bytes: &[u8]) {
    let input = &mut Reader::new(bytes);
    let degree = input.up_to(sphere::BASIS.degree());
    let light = input.floats(light::count(degree), true);
    let order = input.up_to(sphere::BASIS.order());
    let material = input.floats(material::count(order), true);
    let wide = |numbers: &[f32]| numbers.iter().map(|&one| one.into()).collect::<Vec<f64>>();
    let reference = shipped().project(&wide(&light), &wide(&material));
    let scales = shipped().scales(largest(&light), &of_orders(order, &material));
    let case = Case { light, order, material, reference, scales };
    let seen = normals(input);
    case.in_floats(&seen);
    case.in_integers(&normals(&mut Reader::new(&[])));
    case.in_integers(&seen);
}

/// Upper bound of what f32 rounds in a pixel of `d`. The number of roundings of each term, of half a
/// unit of 24 bits: the stored term, its product with d, a sum for each profile of its azimuth,
/// Horner's rule with t rounded, and five for each step in w̄, whose two products are at most √2.
fn rounded(d: &[f64]) -> f64 {
    let parts = sphere::BASIS.parts();
    let mut terms = parts.terms;
    let weight = |index: Option<u16>| index.map_or(0.0, |index| d[usize::from(index)].abs());
    let of_profile = |place: &ProfilePlace| {
        let azimuth = place.azimuth();
        let profiles = parts.profiles.iter().filter(|other| other.azimuth() == azimuth).count();
        let (of_profile, rest) = terms.split_at(parts.lengths[azimuth].into());
        terms = rest;
        let size: f64 = of_profile.iter().map(|term| f64::from(term.abs())).sum();
        let roundings = 2 + profiles + 3 * of_profile.len() + 5 * azimuth;
        roundings as f64 * size * (weight(place.plus()) + weight(place.minus()))
    };
    2f64.powi(-24) * parts.profiles.iter().map(of_profile).sum::<f64>()
}

fn largest(numbers: &[f32]) -> f64 {
    numbers.iter().fold(0.0f32, |most, number| most.max(number.abs())).into()
}

/// The largest coefficient of each o.
fn of_orders(order: usize, material: &[f32]) -> Vec<f64> {
    let of = |o: usize| &material[material::position(o, o % 2, o % 2)..material::count(o)];
    (0..=order).map(|o| largest(of(o))).collect()
}

struct Case {
    light: Vec<f32>,
    order: usize,
    material: Vec<f32>,
    reference: Vec<f64>,
    scales: Vec<f64>,
}

impl Case {
    /// d, of what its addends could be.
    fn projected(&self, found: &[f64], part: f64, common: f64) {
        near(found, &self.reference, &self.scales, [part, common, f32::MIN_POSITIVE.into()]);
    }

    /// The pixel is within `allowed` of Σ d_i U_i in f64.
    fn image(d: &[f64], normal: [f64; 3], found: f64, allowed: f64) {
        let expected = shipped().reconstruct(d, normal);
        let off = (found - expected).abs();
        let allowed = allowed + f64::from(f32::MIN_POSITIVE);
        assert!(off <= allowed, "{found}, not {expected}: {off}, of {allowed} allowed");
    }

    fn in_floats(&self, normals: &[q15::Normal]) {
        let light = Light::from_finite(&self.light).expect("a light");
        let material = Material::from_finite(&self.material).expect("a material");
        let d = sphere::project(&light, &material).expect("it fits");
        let wide: Vec<f64> = d.iter().map(|&d| d.into()).collect();
        self.projected(&wide, ANY_D_F32, 0.0);
        self.projected(&self.of_effects(), ANY_D_F32, 0.0);
        let scene = sphere::collapse(&d);
        let allowed = rounded(&wide);
        for normal in normals {
            let [x, y, z] = normal.components().map(|one| one.mantissa() as f32);
            let normal = Normal::new(x, y, z).expect("a normal");
            let at = normal.components().map(f64::from);
            Self::image(&wide, at, scene.shade(normal).into(), allowed);
        }
    }

    /// d, the sum of that of each effect.
    fn of_effects(&self) -> Vec<f64> {
        let mut sum = vec![0.0; sphere::COMPONENTS];
        for effect in Effect::ALL {
            let (mut light, mut material) = (self.light.clone(), self.material.clone());
            effect.mask_light(&mut light);
            effect.mask_material(&mut material);
            let light = Light::from_finite(&light).expect("a light");
            let material = Material::from_finite(&material).expect("a material");
            let d = sphere::project(&light, &material).expect("it fits");
            sum.iter_mut().zip(&d).for_each(|(sum, &d)| *sum += f64::from(d));
        }
        sum
    }

    fn in_integers(&self, normals: &[q15::Normal]) {
        let mut mantissas = vec![Q15(0); self.light.len()];
        let light = q15::Light::quantize(&self.light, &mut mantissas).expect("a light");
        let mut of_material = vec![Q15(0); self.material.len()];
        let mut exponents = vec![0; self.order + 1];
        let material = q15::Material::quantize(&self.material, &mut of_material, &mut exponents);
        let Relit { d, exponent, .. } = Relit::new(&light, &material.expect("a material"));
        let scale = 2f64.powi(exponent);
        let wide: Vec<f64> = d.iter().map(|&d| scale * f64::from(d)).collect();
        self.projected(&wide, super::ANY_D_Q15, super::ANY_D_COMMON);
        let (basis, room) = (&sphere::q15::BASIS, vec![0; sphere::q15::SCENE]);
        let scene = basis.collapse_into(&d, exponent, room).expect("a moderate exponent");
        let unit = 2f64.powi(scene.exponent());
        // The rounding of a pixel is relative to the range of the scene's terms.
        let rounded = ANY_PIXEL_Q15 * 2f64.powi(17) * unit;
        let allowed = shipped().lost(&wide) + rounded;
        for &normal in normals {
            // As long as it is: U is a polynomial of its components.
            let found = f64::from(scene.shade(normal)) * unit;
            Self::image(&wide, normal.components().map(Q15::to_f64), found, allowed);
        }
    }
}

/// Energy of a light of any moderate numbers that was turned in f32.
const TURNED_ENERGY: f64 = 5e-6;

/// Roundings of f32 between texels, of the largest of them.
const BETWEEN_TEXELS: f64 = 1e-6;

const LIGHT: usize = light::count(sphere::DEGREE);

/// Look-ups, baking, rotation, windows, truncation, estimates and sizes, of any numbers.
pub fn public_interface(bytes: &[u8]) {
    let input = &mut Reader::new(bytes);
    indices(input);
    let is_moderate = input.byte().is_multiple_of(2);
    let rotation = any_rotation(input);
    let coefficients = input.floats(LIGHT, is_moderate);
    let light = Light::from_finite(&coefficients).expect("a light");
    turn(&light, &rotation, is_moderate);
    let d = std::array::from_fn(|_| input.float(is_moderate));
    look_up(&d, input, is_moderate);
    drawing(input);
}

/// Sizes and places of anything: meaningless at worst.
fn indices(input: &mut Reader<'_>) {
    let [a, b, c] = [(); 3].map(|()| u64::from_le_bytes(input.bytes()) as usize);
    let _ = (light::position(a, b.cast_signed()), material::position(a, b, c), light::count(a));
    let _ = (eigenshade_table::pair::position(a, b), eigenshade_table::pair::count(a));
    let _ = (eigenshade_table::layout::rows(a, b, c), material::count(a));
    let _ = Light::new(&[0.0; 30][..b % 31]);
    let _ = Material::new(&[0.0; 30][..c % 31]);
}

/// Of any numbers an error, or a matrix that is a rotation.
fn any_rotation(input: &mut Reader<'_>) -> Rotation {
    let mut rotation = Rotation::NONE;
    for _ in 0..input.up_to(4) {
        let found = match input.byte() % 5 {
            0 => Rotation::from_quaternion([(); 4].map(|()| input.float(false))),
            1 => Rotation::from_quaternion([(); 4].map(|()| input.small())),
            2 => {
                let [a, b, c] = [(); 3].map(|()| input.float(false));
                Rotation::from_euler(a, b, c)
            }
            3 => {
                let [a, b, c] = [(); 3].map(|()| input.small() / 40.0);
                Rotation::from_euler(a, b, c)
            }
            _ => {
                // Next to a rotation, or anything.
                let change = input.small() * 1e-5;
                let mut matrix = rotation.matrix();
                matrix[usize::from(input.byte() % 3)][usize::from(input.byte() % 3)] += change;
                Rotation::from_matrix(matrix)
            }
        };
        let Ok(found) = found else { continue };
        rotation = found.after(rotation);
        for (i, a) in rotation.matrix().iter().enumerate() {
            for (j, b) in rotation.matrix().iter().enumerate() {
                let products = a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b));
                let off = (products.sum::<f64>() - f64::from(u8::from(i == j))).abs();
                assert!(off <= super::ORTHONORMAL_F32, "{off:e}: {rotation:?}");
            }
        }
    }
    rotation
}

/// Turned and windowed light: finite of moderate numbers, of the same energy.
fn turn(light: &Light<'_>, rotation: &Rotation, is_moderate: bool) {
    let turned = light.turned::<LIGHT>(rotation).expect("room");
    for width in [0.5, 10.0, f32::NAN] {
        let window = Window::SincFourth { width };
        let windowed = light.windowed::<LIGHT>(window).expect("room");
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
    let size = 2 + input.up_to(30);
    let map = scene.bake_into(size, vec![0.0; size * size]).expect("a size");
    let integers = scene.bake_integers_into(size, vec![0; size * size]);
    assert!(!is_moderate || integers.is_ok(), "{:?}", integers.err());
    let (mut lengths, mut report) = ([0; sphere::DEGREE + 1], [Truncation::default()]);
    let share = 1.0 / (1.0 + f32::from(input.byte()));
    let tolerance = Tolerance::OfWhite { share: share * share, exposure: 1.5 };
    let mut room = [0.0; sphere::SCENE];
    let shape = sphere::BASIS
        .collapse_set_within(&[d], 1, tolerance, &mut lengths, &mut room, &mut report)
        .expect("sizes");
    let within = shape.scene(&room).expect("numbers");
    let mut estimate = sphere::BASIS.estimate::<{ sphere::COMPONENTS }>().expect("room");
    let mut of_integers = sphere::q15::BASIS.estimate::<{ sphere::COMPONENTS }>().expect("room");
    while !input.is_empty() {
        let vector = [(); 3].map(|()| input.float(false));
        let [x, y, z] = vector.map(|c| [c]);
        let raw = Normals::from_unit(&x, &y, &z).expect("one length").iter().next().expect("one");
        let point = MapPoint::new(x[0], y[0]);
        let _ = (map.bilinear(point), map.bilinear(MapPoint::of(raw)));
        let _ = (within.shade(raw), MapPoint::of(raw).direction());
        let [u, v, _] = vector.map(|c| Q15((c.to_bits() >> 16) as u16 as i16));
        if let Ok(integers) = &integers {
            let _ = integers.bilinear(q15::MapPoint::new(u, v));
        }
        let [a, b, c] = vector.map(|c| c.to_bits().cast_signed());
        if let Ok(normal) = q15::Normal::new(a, b, c) {
            assert!(self::normal(normal.components()).is_ok(), "{normal:?} is no unit vector");
            of_integers.add(normal, u, b as u16);
        }
        estimate.add(raw, y[0], z[0]);
        let [mut x, mut y, mut z] = [x, y, z];
        let Ok(normals) = Normals::normalized(&mut x, &mut y, &mut z) else { continue };
        let normal = normals.iter().next().expect("one");
        if !is_moderate {
            continue;
        }
        let exact = scene.shade(normal);
        // Texels beyond the rim may be large, but nothing is larger than they are.
        let texels = || map.texels().iter().map(|&texel| f64::from(texel));
        let (least, most) = (texels().fold(f64::MAX, f64::min), texels().fold(f64::MIN, f64::max));
        let rounding = BETWEEN_TEXELS * most.max(-least);
        let found = f64::from(map.bilinear(MapPoint::of(normal)));
        let range = least - rounding..=most + rounding;
        assert!(range.contains(&found), "{found}, not within {range:?}");
        assert!(NegativePolicy::Clamped.of(exact) >= 0.0);
    }
    let _ = estimate.coefficients();
    let _ = [i32::from(u16::MAX), -15].map(|exponent| of_integers.coefficients(exponent));
    let normal = Normal::new(0.0, 0.6, 0.8).expect("visible");
    assert!(!is_moderate || within.shade(normal).is_finite());
}
