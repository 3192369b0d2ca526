//! The common part of Q15 and Q31, and the checks of arguments from C.
#![expect(unsafe_code, reason = "arrays come from C")]

use crate::boundary::{Place, Plain, disjoint, slice, slice_to_write};
use crate::float::{LightF32, MaterialF32};
use crate::sizes;
use crate::sizes::{EIGENSHADE_DEGREE, EIGENSHADE_ORDER};
use crate::status::Status;
use eigenshade::index::{light, material};
use eigenshade::quantized::{Basis, Light, Material, Normal, Scene, Transfer};
use eigenshade::{Error, FixedPoint, Q15, Q31, sphere};

/// The largest exponent of d. Lights and materials reach less than half of it.
const EXPONENT: u32 = 2_048;

/// An integer format and its shipped basis.
pub(crate) trait Shipped: FixedPoint + Plain {
    /// The complete basis, which computes transfers.
    fn basis() -> &'static Basis<'static, Self>;
    /// The basis without factors.
    fn relight_only() -> &'static Basis<'static, Self>;
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error>;
    /// The irradiance, with every size a constant.
    fn irradiance(scene: &Scene<'_, Self, &[i32]>, normal: Normal<Self>) -> i32;
}

impl Shipped for Q15 {
    fn basis() -> &'static Basis<'static, Self> {
        &sphere::q15::BASIS
    }
    fn relight_only() -> &'static Basis<'static, Self> {
        &sizes::BASIS_Q15
    }
    #[inline]
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error> {
        Normal::<Self>::new(x, y, z)
    }
    // Shared by `shade` and `shade_many`.
    #[inline(never)]
    fn irradiance(scene: &Scene<'_, Self, &[i32]>, normal: Normal<Self>) -> i32 {
        sphere::q15::shade(scene, normal)
    }
}

impl Shipped for Q31 {
    fn basis() -> &'static Basis<'static, Self> {
        &sphere::q31::BASIS
    }
    fn relight_only() -> &'static Basis<'static, Self> {
        &sizes::BASIS_Q31
    }
    #[inline]
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error> {
        Normal::<Self>::new(x, y, z)
    }
    // Shared by `shade` and `shade_many`.
    #[inline(never)]
    fn irradiance(scene: &Scene<'_, Self, &[i32]>, normal: Normal<Self>) -> i32 {
        sphere::q31::shade(scene, normal)
    }
}

/// A light with checked degree, length and exponent.
///
/// # Safety
///
/// As [`slice`] asks.
pub(crate) unsafe fn light_of<'a, Q: Shipped>(
    degree: usize,
    exponent: i32,
    mantissas: *const Q,
    length: usize,
) -> Result<Light<'a, Q>, Status> {
    if degree > EIGENSHADE_DEGREE {
        return Err(Status::LightBeyond);
    }
    if length != light::count(degree) {
        return Err(Status::LightLength);
    }
    // SAFETY: this function's caller promises as much.
    let mantissas = unsafe { slice(mantissas, length) }?;
    Ok(Light::new(exponent, mantissas)?)
}

/// A material with checked order and lengths.
///
/// # Safety
///
/// As [`slice`] asks, of both arrays.
pub(crate) unsafe fn material_of<'a, Q: Shipped>(
    order: usize,
    (mantissas, length): (*const Q, usize),
    (exponents, of_exponents): (*const i8, usize),
) -> Result<Material<'a, Q>, Status> {
    if order > EIGENSHADE_ORDER {
        return Err(Status::MaterialBeyond);
    }
    if length != material::count(order) || of_exponents != order + 1 {
        return Err(Status::MaterialLength);
    }
    // SAFETY: this function's caller promises as much.
    let (mantissas, exponents) =
        unsafe { (slice(mantissas, length)?, slice(exponents, of_exponents)?) };
    Ok(Material::new(exponents, mantissas)?)
}

/// Writes the mantissas of a light and returns their exponent. `to` is the place of the light
/// itself, which is written later.
///
/// # Safety
///
/// As [`slice`] asks, of the light's array, and [`slice_to_write`] of the mantissas.
pub(crate) unsafe fn quantize_light<Q: Shipped>(
    from: &LightF32,
    (mantissas, length): (*mut Q, usize),
    to: Place,
) -> Result<i32, Status> {
    if length != from.length {
        return Err(Status::LightLength);
    }
    // SAFETY: this function's caller promises as much.
    let light = unsafe { from.view() }?;
    disjoint(&[to, Place::many(mantissas, length)?], &from.places()?)?;
    // SAFETY: this function's caller promises as much; it overlaps no other.
    let mantissas = unsafe { slice_to_write(mantissas, length) }?;
    Ok(Light::quantize(light.coefficients(), mantissas)?.exponent())
}

/// Writes the mantissas and exponents of a material. `to` is the place of the material itself,
/// which is written later.
///
/// # Safety
///
/// As [`slice`] asks, of the material's array, and [`slice_to_write`] of the others.
pub(crate) unsafe fn quantize_material<Q: Shipped>(
    from: &MaterialF32,
    (mantissas, length): (*mut Q, usize),
    (exponents, of_exponents): (*mut i8, usize),
    to: Place,
) -> Result<(), Status> {
    if length != from.length || of_exponents.wrapping_sub(1) != from.order {
        return Err(Status::MaterialLength);
    }
    // SAFETY: this function's caller promises as much.
    let material = unsafe { from.view() }?;
    let written = [to, Place::many(mantissas, length)?, Place::many(exponents, of_exponents)?];
    disjoint(&written, &from.places()?)?;
    // SAFETY: this function's caller promises as much, and they do not overlap.
    let (mantissas, exponents) =
        unsafe { (slice_to_write(mantissas, length)?, slice_to_write(exponents, of_exponents)?) };
    Material::quantize(material.coefficients(), mantissas, exponents)?;
    Ok(())
}

/// Scales a vector to the unit normal along it.
///
/// # Safety
///
/// As [`slice`] asks of `vector`, and [`slice_to_write`] of `normal`.
pub(crate) unsafe fn normalize<Q: Shipped>(
    vector: *const i32,
    normal: *mut Q,
) -> Result<(), Status> {
    disjoint(&[Place::many(normal, 3)?], &[Place::many(vector, 3)?])?;
    // SAFETY: this function's caller promises as much.
    let vector = unsafe { slice(vector, 3) }?;
    let &[x, y, z] = vector else { return Err(Status::Internal) };
    let found = Normal::<Q>::along(x, y, z)?;
    // SAFETY: this function's caller promises as much; it overlaps no other.
    let normal = unsafe { slice_to_write(normal, 3) }?;
    normal.iter_mut().zip(found.components()).for_each(|(to, from)| *to = from);
    Ok(())
}

/// Computes the transfer of a material.
pub(crate) fn transfer<Q: Shipped>(
    material: &Material<'_, Q>,
    workspace: &mut [Q::Wide],
    numbers: &mut [Q],
    exponents: &mut [i16],
) -> Result<(), Status> {
    Ok(Q::basis().transfer_into(material, workspace, numbers, exponents)?)
}

/// Computes d and returns its exponent.
pub(crate) fn relight<Q: Shipped>(
    numbers: &[Q],
    exponents: &[i16],
    light: &Light<'_, Q>,
    mantissas: &mut [i32],
) -> Result<i32, Status> {
    Ok(Q::relight_only().relight_into(&Transfer::new(numbers, exponents), light, mantissas)?)
}

/// The first `components` of d, if d has that many and the exponent is in range.
pub(crate) fn first(mantissas: &[i32], exponent: i32, components: usize) -> Result<&[i32], Status> {
    if exponent.unsigned_abs() > EXPONENT {
        return Err(Status::Exponent);
    }
    mantissas.get(..components).ok_or(Status::Components)
}

/// Computes the terms of a scene and returns its exponent.
pub(crate) fn collapse<Q: Shipped>(
    mantissas: &[i32],
    exponent: i32,
    terms: &mut [i32],
) -> Result<i32, Status> {
    Ok(Q::relight_only().collapse_into(mantissas, exponent, terms)?.exponent())
}

/// The irradiance of one normal.
pub(crate) fn shade<Q: Shipped>(terms: &[i32], [x, y, z]: [Q; 3]) -> Result<i32, Status> {
    let normal = Q::normal(x, y, z)?;
    Ok(Q::irradiance(&Q::relight_only().scene(0, terms)?, normal))
}

/// The irradiances of many normals.
///
/// # Safety
///
/// As [`slice`] asks, of the normals, and [`slice_to_write`] of the irradiances, but that
/// they may overlap, which is an error.
pub(crate) unsafe fn shade_many<Q: Shipped>(
    terms: &[i32],
    count: usize,
    [x, y, z]: [*const Q; 3],
    irradiance: *mut i32,
) -> Result<(), Status> {
    let [x_place, y_place, z_place] = [x, y, z].map(|axis| Place::many(axis, count));
    let read = [x_place?, y_place?, z_place?];
    disjoint(&[Place::many(irradiance, count)?], &read)?;
    // SAFETY: this function's caller promises as much, and they do not overlap.
    let (x, y, z, irradiance) = unsafe {
        (slice(x, count)?, slice(y, count)?, slice(z, count)?, slice_to_write(irradiance, count)?)
    };
    let scene = Q::relight_only().scene(0, terms)?;
    for (((irradiance, &x), &y), &z) in irradiance.iter_mut().zip(x).zip(y).zip(z) {
        *irradiance = Q::irradiance(&scene, Q::normal(x, y, z)?);
    }
    Ok(())
}
