//! Shading. Floats, and scenes within a tolerance: any bits never panic; finite numbers of moderate
//! size give finite answers, and bounds that are finite and kept. Integers: in range, never
//! wrapping, each step as exact arithmetic has it.

use super::integer::{Mantissa as _, Relit, normals, shipped};
use super::{Reader, integer};
use eigenshade::truncation::{Tolerance, Truncation};
use eigenshade::{Error, Light, Material, Normal, Normals, Q15, q15, sphere};
use eigenshade_table::{light, material};

/// What counts as moderate: sums of products of two stay below f32's largest.
const MODERATE: f32 = 1e12;

/// Any light, material and normals, by every way to a pixel.
pub fn shade_floats(input: &mut Reader<'_>) {
    let degree = input.up_to(sphere::BASIS.degree());
    let coefficients = input.floats(light::count(degree), false);
    let light = Light::from_finite(&coefficients).expect("a light");
    let order = input.up_to(sphere::BASIS.order());
    let of_material = input.floats(material::count(order), false);
    let material = Material::from_finite(&of_material).expect("a material");
    let moderate = coefficients.iter().chain(&of_material).all(|value| value.abs() <= MODERATE);

    let projected = sphere::project(&light, &material).expect("it fits");
    let transfer = sphere::transfer(&material).expect("it fits");
    let relit = sphere::relight(&transfer, &light).expect("it fits");
    let mut axes = [vec![0.0], vec![0.0], vec![1.0]];
    while !input.is_empty() {
        let [x, y, z] = [(); 3].map(|()| input.float(false));
        let Ok(normal) = Normal::new(x, y, z) else { continue };
        let components = normal.components();
        let length = components.map(f64::from).into_iter().fold(0.0, f64::hypot);
        let is_unit = (length - 1.0).abs() < 1e-6 && components[2] >= 0.0;
        assert!(is_unit, "{normal:?} is no visible unit vector");
        axes.iter_mut().zip(components).for_each(|(axis, component)| axis.push(component));
    }
    let [x, y, z] = &axes;
    let normals = Normals::new(x, y, z).expect("one length");
    for d in [&projected, &relit] {
        let scene = sphere::collapse(d);
        let mut shaded = vec![0.0; normals.len()];
        scene.shade_slice(normals, &mut shaded).expect("one length");
        for (normal, shaded) in normals.iter().zip(shaded) {
            let one = scene.shade(normal);
            assert!(!moderate || one.is_finite(), "{one} of finite inputs");
            assert!(one.to_bits() == shaded.to_bits() || one.is_nan() && shaded.is_nan());
        }
    }
}

/// Any images in one shape, each its own peak or that of its color.
pub fn collapse_sets(input: &mut Reader<'_>) {
    let channels = 1 + input.up_to(2);
    let count = channels * input.up_to(3);
    let share = 2f32.powi(-1 - input.up_to(20) as i32);
    let is_moderate = input.byte().is_multiple_of(2);
    let numbers = input.floats(count * sphere::COMPONENTS, is_moderate);
    let (images, _) = numbers.as_chunks::<{ sphere::COMPONENTS }>();
    let mut lengths = [0; sphere::DEGREE + 1];
    let mut report = vec![Truncation::default(); count];
    let mut buffer = vec![0.0; count * sphere::SCENE];
    let tolerance = Tolerance::OfPeak(share);
    let shape = sphere::BASIS
        .collapse_set_within(images, channels, tolerance, &mut lengths, &mut buffer, &mut report)
        .expect("sizes");
    assert!(shape.terms() <= sphere::SCENE && shape.components <= sphere::COMPONENTS);
    for (numbers, report) in buffer.chunks_exact(sphere::SCENE).zip(&report) {
        let scene = shape.scene(numbers).expect("enough");
        if !is_moderate {
            continue;
        }
        let rounding = super::TRUNCATED_PARTS as f32;
        let within = report.bound <= share * report.peak * (1.0 + rounding);
        assert!(report.bound.is_finite() && within, "{report:?}");
        let parts = report.left_out_by_components.hypot(report.left_out_by_terms);
        assert!((parts - report.bound).abs() <= rounding * report.bound, "{report:?}");
        for [x, y, z] in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-0.36, 0.48, 0.8]] {
            let normal = Normal::new(x, y, z).expect("visible");
            assert!(scene.shade(normal).is_finite(), "{report:?}");
        }
    }
}

/// A pixel of any coefficients against f64 on the same mantissas, of the range of 17 bits: (n_x + i
/// n_y)^m has 14, and each step of some fifty rounds by one unit.
pub const ANY_PIXEL_Q15: f64 = 3e-4;

/// Any mantissas and exponents of light and material, up to the table's degree and
/// order: d near the f64 sum, the image as of any coefficients.
pub fn shade_integers(input: &mut Reader<'_>) {
    let basis = &sphere::q15::BASIS;
    let (exponent, mantissas) = any_light(input);
    let light = q15::Light::new(exponent, &mantissas).expect("a light");
    let order = input.up_to(basis.order());
    let exponents: Vec<i8> = (0..=order).map(|_| input.byte().cast_signed()).collect();
    let of_material: Vec<Q15> = (0..material::count(order)).map(|_| Q15::read(input)).collect();
    let material = q15::Material::new(&exponents, &of_material).expect("a material");

    let made = Relit::new(&light, &material);
    relit(&made, &mantissas, exponent);

    let scaled = |mantissa: Q15, exponent: i32| mantissa.mantissa() as f64 * 2f64.powi(exponent);
    let of_order = |(&b, (o, _, _)): (&Q15, (usize, usize, usize))| scaled(b, exponents[o].into());
    let of_material: Vec<f64> =
        of_material.iter().zip(material::indices(order)).map(of_order).collect();
    let of_light: Vec<f64> = mantissas.iter().map(|&one| scaled(one, exponent)).collect();
    // What is lost follows from the exponents, which may be far apart.
    let most = |exponent: i32| 2f64.powi(exponent + 15);
    let of_order: Vec<f64> = exponents.iter().map(|&one| most(one.into())).collect();
    let scales = shipped().scales(most(exponent), &of_order);
    let unit = 2f64.powi(made.exponent);
    let found: Vec<f64> = made.d.iter().map(|&d| unit * f64::from(d)).collect();
    let allowed = [super::ANY_D_Q15, super::ANY_D_COMMON, 0.0];
    near(&found, &shipped().project(&of_light, &of_material), &scales, allowed);
    seen(&made.d, made.exponent, &normals(input));
}

/// Any transfer: refused, or relit as exact arithmetic has it.
pub fn shade_transfer(input: &mut Reader<'_>) {
    let basis = &sphere::q15::BASIS;
    let (exponent, mantissas) = any_light(input);
    let light = q15::Light::new(exponent, &mantissas).expect("a light");
    let shift = u32::from(input.byte()) % (15 + 1);
    let narrower = |number: Q15| Q15::nearest(((number.mantissa()) >> shift) as f64);
    let exponents: Vec<i16> =
        (0..basis.profiles()).map(|_| i16::from_le_bytes(input.bytes())).collect();
    let numbers: Vec<Q15> = (0..basis.transfer_len()).map(|_| narrower(Q15::read(input))).collect();
    let mut d = vec![0; basis.components()];
    match basis.relight_into(&q15::Transfer::new(&numbers, &exponents), &light, &mut d) {
        Ok(of_d) => {
            let made = Relit { numbers, exponents, d, exponent: of_d };
            relit(&made, &mantissas, exponent);
            seen(&made.d, of_d, &normals(input));
        }
        Err(error) => assert!(error == Error::Bound && !within_bounds(&numbers), "{error}"),
    }
}

/// Any coefficients: as many as there are components, or fewer.
pub fn shade_coefficients(input: &mut Reader<'_>) {
    let exponent = input.i32();
    let count = input.up_to(sphere::q15::BASIS.components());
    let d: Vec<i32> = (0..count).map(|_| input.i32()).collect();
    seen(&d, exponent, &normals(input));
}

fn any_light(input: &mut Reader<'_>) -> (i32, Vec<Q15>) {
    let exponent = i32::from(input.byte().cast_signed());
    let degree = input.up_to(sphere::q15::BASIS.degree());
    (exponent, (0..light::count(degree)).map(|_| Q15::read(input)).collect())
}

/// Rows over l, with the azimuth and the components of each.
fn rows(numbers: &[Q15]) -> impl Iterator<Item = (usize, [u16; 2], &[Q15])> {
    let parts = &shipped().parts;
    let mut rest = numbers;
    parts.profiles.iter().map(move |place| {
        let azimuth = usize::from(place.azimuth);
        let (row, after) = rest.split_at(parts.degree + 1 - azimuth);
        rest = after;
        (azimuth, [place.plus, place.minus], row)
    })
}

fn within_bounds(numbers: &[Q15]) -> bool {
    rows(numbers)
        .all(|(_, _, row)| row.iter().map(|number| number.mantissa().abs()).sum::<i128>() < 2 << 15)
}

/// d is Σ_l T_i,l L_l^m to one unit, and its mantissas have at most 30 bits.
fn relit(made: &Relit, light: &[Q15], of_light: i32) {
    let Relit { numbers, exponents, d, exponent: of_d } = made;
    assert!(within_bounds(numbers), "a row of a transfer");
    assert!(d.iter().all(|d| d.unsigned_abs() <= 1 << 30), "more than 30 bits");
    for ((azimuth, components, row), &exponent) in rows(numbers).zip(exponents) {
        let order = azimuth.cast_signed();
        for (component, m) in components.into_iter().zip([order, -order]) {
            let Some(&found) = d.get(usize::from(component)) else { continue };
            let product = |(l, number): (usize, &Q15)| {
                number.mantissa()
                    * light.get(light::position(l, m)).map_or(0, |&one| one.mantissa())
            };
            let sum: i128 = (azimuth..).zip(row).map(product).sum();
            let sum = if m < 0 && azimuth % 2 == 1 { -sum } else { sum };
            if sum == 0 {
                assert_eq!(found, 0, "component {component}");
                continue;
            }
            // In units of d; of a sum the upper 31 bits are taken.
            let by = i32::from(exponent) + of_light - of_d;
            let expected = sum as f64 * 2f64.powi(by);
            let cut = 2f64.powi(by - 1);
            let off = (f64::from(found) - expected).abs();
            assert!(off <= 0.5 + cut, "component {component}: {found}, not {expected}");
        }
    }
}

/// d is near the f64 sum: to a part of what its addends could be, a part of the most that those of
/// any component could be, and a number.
pub fn near(found: &[f64], reference: &[f64], scales: &[f64], allowed: [f64; 3]) {
    let [part, common, least] = allowed;
    let largest = scales.iter().copied().fold(0.0, f64::max);
    for (k, ((found, reference), scale)) in found.iter().zip(reference).zip(scales).enumerate() {
        let allowed = part * scale + common * largest + least;
        let off = (found - reference).abs();
        assert!(off <= allowed, "component {k}: {found}, not {reference}; {allowed}");
    }
}

/// The image: every step within the format's bits, both ways to a pixel the same bits,
/// near the f64 sum.
fn seen(d: &[i32], exponent: i32, normals: &[q15::Normal]) {
    let basis = &sphere::q15::BASIS;
    let scene = basis.collapse_into(d, exponent, vec![0; basis.scene_len()]);
    if scene.as_ref().err() == Some(&Error::Exponent) && exponent.unsigned_abs() > 1 << 16 {
        return;
    }
    let scene = scene.expect("an exponent within bounds");
    let lengths = basis.parts().lengths;
    let terms = scene.terms().try_into().expect("a scene of the table");
    // In units of the scene.
    let scale = 2f64.powi(exponent.saturating_sub(scene.exponent()));
    let floats: Vec<f64> = d.iter().map(|&d| scale * f64::from(d)).collect();
    for &normal in normals {
        let pixel = scene.shade(normal);
        assert_eq!(pixel, sphere::q15::shade_terms(terms, normal), "two ways to a pixel");
        let exact = integer::exact(lengths, scene.terms(), normal);
        assert_eq!(i128::from(pixel), exact, "a pixel");
        let at = normal.components().map(Q15::to_f64);
        let expected = shipped().reconstruct_quantized(&floats, at);
        let off = (f64::from(pixel) - expected).abs() / 2f64.powi(17);
        assert!(off <= ANY_PIXEL_Q15, "a pixel of {pixel}, not {expected}: {off} of the range");
    }
}
