//! In integers: mantissas of 15 bits, for machines without a float unit.
#![expect(unsafe_code, reason = "exported symbols and pointers from C")]

use crate::boundary::{Place, Plain, disjoint, exclusive, shared};
use crate::float::{LightF32, MaterialF32};
use crate::integers;
use crate::sizes::{
    EIGENSHADE_COMPONENTS, EIGENSHADE_PROFILES, EIGENSHADE_SCENE_Q15, EIGENSHADE_TRANSFER,
    EIGENSHADE_WORKSPACE,
};
use crate::status::Status;
use eigenshade::Q15;
use eigenshade::quantized::{Light, Material};

/// One channel of distant light: as `eigenshade_light_f32_t`, in mantissas times 2^exponent.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct LightQ15 {
    /// Largest l, at most EIGENSHADE_DEGREE; above it the light is zero.
    pub degree: usize,
    /// Number of mantissas: (degree + 1)^2.
    pub length: usize,
    /// The mantissas; the caller's. The more bits the largest has, the better.
    pub mantissas: *const Q15,
    /// The exponent of all of them, from -128 to 128.
    pub exponent: i32,
}

/// One channel of an isotropic material: as `eigenshade_material_f32_t`, in mantissas times
/// 2^exponent, an exponent for each o.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct MaterialQ15 {
    /// Largest o, at most EIGENSHADE_ORDER; above it the material is zero.
    pub order: usize,
    /// Number of mantissas: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7.
    pub length: usize,
    /// The mantissas; the caller's. The more bits the largest of each o has, the better.
    pub mantissas: *const Q15,
    /// Number of exponents: order + 1.
    pub exponents_length: usize,
    /// For each o the exponent of its mantissas; the caller's.
    pub exponents: *const i8,
}

/// Scratch memory; holds nothing between two calls.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct WorkspaceQ15 {
    /// Scratch.
    pub numbers: [i32; EIGENSHADE_WORKSPACE],
}

/// The transfer of a material, as `eigenshade_transfer_q15` writes it. May be kept in flash.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct TransferQ15 {
    /// Its mantissas.
    pub numbers: [Q15; EIGENSHADE_TRANSFER],
    /// Its exponents.
    pub exponents: [i16; EIGENSHADE_PROFILES],
}

/// The coefficients d of one image, component by component: mantissas times 2^exponent.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CoefficientsQ15 {
    /// Mantissas of at most 2^30.
    pub mantissas: [i32; EIGENSHADE_COMPONENTS],
    /// The exponent of all of them.
    pub exponent: i32,
}

/// One image, as `eigenshade_collapse_q15` writes it. May be kept in flash.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SceneQ15 {
    /// Its polynomials.
    pub terms: [i32; EIGENSHADE_SCENE_Q15],
    /// The exponent of every irradiance.
    pub exponent: i32,
}

// SAFETY: of integers and a pointer that nothing is read through before it is checked.
unsafe impl Plain for LightQ15 {}
// SAFETY: as above, of two pointers.
unsafe impl Plain for MaterialQ15 {}
// SAFETY: consists only of integers.
unsafe impl Plain for WorkspaceQ15 {}
// SAFETY: consists only of integers.
unsafe impl Plain for TransferQ15 {}
// SAFETY: consists only of integers.
unsafe impl Plain for CoefficientsQ15 {}
// SAFETY: consists only of integers.
unsafe impl Plain for SceneQ15 {}

impl LightQ15 {
    /// # Safety
    ///
    /// As [`integers::light_of`] asks.
    unsafe fn view<'a>(&self) -> Result<Light<'a, Q15>, Status> {
        // SAFETY: this function's caller promises as much.
        unsafe { integers::light_of(self.degree, self.exponent, self.mantissas, self.length) }
    }

    /// Where it and its mantissas lie.
    fn places(&self) -> Result<[Place; 2], Status> {
        Ok([Place::of(self), Place::many(self.mantissas, self.length)?])
    }
}

impl MaterialQ15 {
    /// # Safety
    ///
    /// As [`integers::material_of`] asks.
    unsafe fn view<'a>(&self) -> Result<Material<'a, Q15>, Status> {
        let mantissas = (self.mantissas, self.length);
        let exponents = (self.exponents, self.exponents_length);
        // SAFETY: this function's caller promises as much.
        unsafe { integers::material_of(self.order, mantissas, exponents) }
    }

    /// Where it, its mantissas and its exponents lie.
    fn places(&self) -> Result<[Place; 3], Status> {
        let exponents = Place::many(self.exponents, self.exponents_length)?;
        Ok([Place::of(self), Place::many(self.mantissas, self.length)?, exponents])
    }
}

/// A light in these mantissas from one in float, in integer arithmetic throughout.
///
/// Writes `length` mantissas, as many as `from` has coefficients, and the light that they
/// make; they stay the caller's, and the light points to them. On an error
/// nothing is written, unless a number is not finite or it is `to` that is at fault.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, `mantissas`
/// to room for `length` numbers, and it and `to` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_quantize_light_q15(
    from: *const LightF32,
    mantissas: *mut Q15,
    length: usize,
    to: *mut LightQ15,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let from = unsafe { shared(from) }?;
        // SAFETY: as this function asks of its caller.
        let exponent =
            unsafe { integers::quantize_light(from, (mantissas, length), Place::of(to)) }?;
        // SAFETY: as this function asks of its caller.
        let to = unsafe { exclusive(to) }?;
        *to = LightQ15 { degree: from.degree, length, mantissas, exponent };
        Ok(())
    })
}

/// A material in these mantissas from one in float, in integer arithmetic throughout.
///
/// Writes `length` mantissas, as many as `from` has coefficients, `exponents_length`
/// exponents, one for each o, and the material that they make; they stay the caller's, and
/// the material points to them. On an error nothing is written, unless a number is not finite
/// or it is `exponents` or `to` that is at fault.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, `mantissas`
/// and `exponents` to room for as many numbers, and they and `to` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_quantize_material_q15(
    from: *const MaterialF32,
    mantissas: *mut Q15,
    length: usize,
    exponents: *mut i8,
    exponents_length: usize,
    to: *mut MaterialQ15,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let from = unsafe { shared(from) }?;
        let (numbers, powers) = ((mantissas, length), (exponents, exponents_length));
        // SAFETY: as this function asks of its caller.
        unsafe { integers::quantize_material(from, numbers, powers, Place::of(to)) }?;
        // SAFETY: as this function asks of its caller.
        let to = unsafe { exclusive(to) }?;
        let order = from.order;
        *to = MaterialQ15 { order, length, mantissas, exponents_length, exponents };
        Ok(())
    })
}

/// Computes the transfer of a material, for any number of lights.
///
/// Cost: a multiplication for each of the table's factors. On an error `transfer` is as it
/// was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `workspace` and `transfer` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_transfer_q15(
    material: *const MaterialQ15,
    workspace: *mut WorkspaceQ15,
    transfer: *mut TransferQ15,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let from = unsafe { shared(material) }?;
        // SAFETY: as this function asks of its caller.
        let material = unsafe { from.view() }?;
        disjoint(&[Place::of(workspace), Place::of(transfer)], &from.places()?)?;
        // SAFETY: as this function asks of its caller; nothing overlaps.
        let (workspace, transfer) = unsafe { (exclusive(workspace)?, exclusive(transfer)?) };
        let TransferQ15 { numbers, exponents } = transfer;
        integers::transfer(&material, &mut workspace.numbers, numbers, exponents)
    })
}

/// Computes d of a new light on a material from its transfer.
///
/// A transfer that `eigenshade_transfer_q15` did not write is refused if its rows could overflow
/// their sums, and gives meaningless numbers otherwise. Cost: two multiplications for each
/// number of the transfer. On an error `coefficients` is as it was, but that the transfer
/// is refused: then it is zero.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `coefficients` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_relight_q15(
    transfer: *const TransferQ15,
    light: *const LightQ15,
    coefficients: *mut CoefficientsQ15,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let (transfer, from) = unsafe { (shared(transfer)?, shared(light)?) };
        // SAFETY: as this function asks of its caller.
        let light = unsafe { from.view() }?;
        let [of_light, of_mantissas] = from.places()?;
        disjoint(&[Place::of(coefficients)], &[Place::of(transfer), of_light, of_mantissas])?;
        // SAFETY: as this function asks of its caller; it overlaps no other.
        let coefficients = unsafe { exclusive(coefficients) }?;
        let CoefficientsQ15 { mantissas, exponent } = coefficients;
        *exponent = integers::relight(&transfer.numbers, &transfer.exponents, &light, mantissas)?;
        Ok(())
    })
}

/// Computes d of a light on a material: first the `transfer`, then d.
///
/// Cost: as `eigenshade_transfer_q15` and `eigenshade_relight_q15`. On an error `coefficients`
/// is as it was; `transfer` may have changed.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `workspace`, `transfer` and `coefficients` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_project_q15(
    light: *const LightQ15,
    material: *const MaterialQ15,
    workspace: *mut WorkspaceQ15,
    transfer: *mut TransferQ15,
    coefficients: *mut CoefficientsQ15,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let (of_light, of_material) = unsafe { (shared(light)?, shared(material)?) };
        // SAFETY: as this function asks of its caller.
        let (light, material) = unsafe { (of_light.view()?, of_material.view()?) };
        let written = [Place::of(workspace), Place::of(transfer), Place::of(coefficients)];
        disjoint(&written, &of_light.places()?)?;
        disjoint(&written, &of_material.places()?)?;
        // SAFETY: as this function asks of its caller.
        let (workspace, transfer, coefficients) =
            unsafe { (exclusive(workspace)?, exclusive(transfer)?, exclusive(coefficients)?) };
        let TransferQ15 { numbers, exponents } = transfer;
        integers::transfer(&material, &mut workspace.numbers, numbers, exponents)?;
        let CoefficientsQ15 { mantissas, exponent } = coefficients;
        *exponent = integers::relight(numbers, exponents, &light, mantissas)?;
        Ok(())
    })
}

/// Sums the components of each azimuth to a scene, from which pixels are shaded.
///
/// Of d only the first `components` are used, at most EIGENSHADE_COMPONENTS; the others count
/// as zero. Of coefficients that `eigenshade_relight_q15` did not write the exponent has to be
/// 2048 at most, either way. On an error `scene` is as it was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `scene` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_collapse_q15(
    coefficients: *const CoefficientsQ15,
    components: usize,
    scene: *mut SceneQ15,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let CoefficientsQ15 { mantissas, exponent } = unsafe { shared(coefficients) }?;
        disjoint(&[Place::of(scene)], &[Place::of(coefficients)])?;
        let first = integers::first(mantissas, *exponent, components)?;
        // SAFETY: as this function asks of its caller.
        let scene = unsafe { exclusive(scene) }?;
        scene.exponent = integers::collapse::<Q15>(first, *exponent, &mut scene.terms)?;
        Ok(())
    })
}

/// The unit normal along a vector of three integers of any scale, as three mantissas, x, y and z:
/// of a normal map of 8 bits, whose channel c says 2c - 255.
///
/// One that points away by no more than 1/8 is laid on the rim. Cost: a root and three divisions
/// in 64 bits. On an error `normal` is as it was.
///
/// # Safety
///
/// Pointers that are neither NULL nor unaligned point to three numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_normalize_q15(vector: *const i32, normal: *mut Q15) -> Status {
    // SAFETY: as this function asks of its caller.
    Status::of(|| unsafe { integers::normalize(vector, normal) })
}

/// The irradiance of the unit normal (x, y, z), in fractions of 2^15 (1 as 2^15 - 1):
/// `irradiance` times 2 to the scene's exponent, in the light's radiance times sr times the
/// material's 1/sr.
///
/// A scene that `eigenshade_collapse_q15` did not write gives meaningless numbers. On an
/// error `irradiance` is as it was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `irradiance` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_shade_q15(
    scene: *const SceneQ15,
    x: Q15,
    y: Q15,
    z: Q15,
    irradiance: *mut i32,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let scene = unsafe { shared(scene) }?;
        disjoint(&[Place::of(irradiance)], &[Place::of(scene)])?;
        let found = integers::shade(&scene.terms, [x, y, z])?;
        // SAFETY: as this function asks of its caller.
        *unsafe { exclusive(irradiance) }? = found;
        Ok(())
    })
}

/// The irradiances of `count` such normals, into `irradiance`.
///
/// Of no normals the pointers to numbers do not matter. On an error `irradiance` is as it was, but
/// that a normal is at fault: then those before it are written, and zeros from it on.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, the last
/// four to `count` numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_shade_many_q15(
    scene: *const SceneQ15,
    count: usize,
    x: *const Q15,
    y: *const Q15,
    z: *const Q15,
    irradiance: *mut i32,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let scene = unsafe { shared(scene) }?;
        disjoint(&[Place::many(irradiance, count)?], &[Place::of(scene)])?;
        // SAFETY: as this function asks of its caller.
        unsafe { integers::shade_many(&scene.terms, count, [x, y, z], irradiance) }
    })
}
