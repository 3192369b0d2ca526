//! What Q15 and Q31 have in common, and the checks of what C hands over.
#![expect(unsafe_code, reason = "arrays come from C")]

use crate::boundary::{Plain, apart, slice, slice_to_write};
use crate::sizes::{EIGENSHADE_DEGREE, EIGENSHADE_ORDER};
use crate::status::Status;
use eigenshade::index::{light, material};
use eigenshade::quantised::{Basis, Light, Material, Normal, Transfer};
use eigenshade::{Error, Fixed, Q15, Q31, sphere};

/// The largest exponent of d or of a scene: what light and material can bring about is a
/// quarter of it.
const EXPONENT: u32 = 2_048;

/// An integer format and its shipped basis.
pub(crate) trait Shipped: Fixed + Plain {
    fn basis() -> &'static Basis<'static, Self>;
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error>;
}

impl Shipped for Q15 {
    fn basis() -> &'static Basis<'static, Self> {
        &sphere::q15::BASIS
    }
    #[inline]
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error> {
        Normal::<Self>::new(x, y, z)
    }
}

impl Shipped for Q31 {
    fn basis() -> &'static Basis<'static, Self> {
        &sphere::q31::BASIS
    }
    #[inline]
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error> {
        Normal::<Self>::new(x, y, z)
    }
}

/// A light whose degree, length and exponent are in order.
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
    Ok(Light::new(degree, exponent, mantissas)?)
}

/// A material whose order and lengths are in order.
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
    Ok(Material::new(order, exponents, mantissas)?)
}

/// Folds a material in.
pub(crate) fn fold<Q: Shipped>(
    material: &Material<'_, Q>,
    workspace: &mut [Q::Wide],
    numbers: &mut [Q],
    exponents: &mut [i16],
) -> Result<(), Status> {
    Ok(Q::basis().fold_into(material, workspace, numbers, exponents)?)
}

/// d and its exponent.
pub(crate) fn relight<Q: Shipped>(
    numbers: &[Q],
    exponents: &[i16],
    light: &Light<'_, Q>,
    mantissas: &mut [i32],
) -> Result<i32, Status> {
    Ok(Q::basis().relight_into(&Transfer::new(numbers, exponents), light, mantissas)?)
}

/// The first components of d, if there are so many and their exponent is in range.
pub(crate) fn first(mantissas: &[i32], exponent: i32, components: usize) -> Result<&[i32], Status> {
    if exponent.unsigned_abs() > EXPONENT {
        return Err(Status::Exponent);
    }
    mantissas.get(..components).ok_or(Status::Components)
}

/// A scene's terms, and its exponent.
pub(crate) fn collapse<Q: Shipped>(
    mantissas: &[i32],
    exponent: i32,
    terms: &mut [i32],
) -> Result<i32, Status> {
    Ok(Q::basis().collapse_into(mantissas, exponent, terms)?.exponent())
}

/// The irradiance of one normal.
pub(crate) fn shade<Q: Shipped>(terms: &[i32], [x, y, z]: [Q; 3]) -> Result<i32, Status> {
    let normal = Q::normal(x, y, z)?;
    Ok(Q::basis().scene(0, terms)?.shade(normal))
}

/// The irradiance of many.
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
    apart(irradiance, [x, y, z], count)?;
    // SAFETY: this function's caller promises as much, and they do not overlap.
    let (x, y, z, irradiance) = unsafe {
        (slice(x, count)?, slice(y, count)?, slice(z, count)?, slice_to_write(irradiance, count)?)
    };
    let scene = Q::basis().scene(0, terms)?;
    for (((irradiance, &x), &y), &z) in irradiance.iter_mut().zip(x).zip(y).zip(z) {
        *irradiance = scene.shade(Q::normal(x, y, z)?);
    }
    Ok(())
}
