//! In float: `f32`, for machines with a float unit.
#![expect(unsafe_code, reason = "exported symbols and pointers from C")]

use crate::boundary::{
    Place, Plain, disjoint, exclusive, shared, slice, slice_to_change, slice_to_write,
};
use crate::sizes;
use crate::sizes::{
    EIGENSHADE_COMPONENTS, EIGENSHADE_DEGREE, EIGENSHADE_ORDER, EIGENSHADE_SCENE_F32,
    EIGENSHADE_TRANSFER_F32, EIGENSHADE_WORKSPACE_F32,
};
use crate::status::Status;
use eigenshade::index::{light, material};
use eigenshade::{Light, Material, Normal, Normals, sphere};

/// One channel of distant light: spherical harmonic coefficients L_l^m in radiance, l from
/// 0, m from -l to l, that of l and m at l*l + l + m.
///
/// The harmonics carry the Condon-Shortley phase, x points to the right, y up, z to the
/// camera. Take them finite: one that is not spoils the image, and
/// `eigenshade_check_light_f32` finds it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct LightF32 {
    /// Largest l, at most EIGENSHADE_DEGREE; above it the light is zero.
    pub degree: usize,
    /// Number of coefficients: (degree + 1)^2.
    pub length: usize,
    /// The coefficients; the caller's.
    pub coefficients: *const f32,
}

/// One channel of an isotropic material: Koenderink-van Doorn coefficients b_op^q of its
/// BRDF in 1/sr, by o, then p, then q: 000, 111, 200, 220, 222, 311, ... White matte is
/// the one coefficient 2.
///
/// Take them finite: one that is not spoils the image, and `eigenshade_check_material_f32`
/// finds it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct MaterialF32 {
    /// Largest o, at most EIGENSHADE_ORDER; above it the material is zero.
    pub order: usize,
    /// Number of coefficients: 1, 2, 5, 8, 14, 20, 30, 40 for orders 0 to 7.
    pub length: usize,
    /// The coefficients; the caller's.
    pub coefficients: *const f32,
}

/// Scratch memory; holds nothing between two calls.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct WorkspaceF32 {
    /// Scratch.
    pub numbers: [f32; EIGENSHADE_WORKSPACE_F32],
}

/// The transfer of a material, as `eigenshade_transfer_f32` writes it. May be kept in flash.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct TransferF32 {
    /// Its numbers.
    pub numbers: [f32; EIGENSHADE_TRANSFER_F32],
}

/// The coefficients d of one image, component by component.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CoefficientsF32 {
    /// d.
    pub numbers: [f32; EIGENSHADE_COMPONENTS],
}

/// One image, as `eigenshade_collapse_f32` writes it. May be kept in flash.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SceneF32 {
    /// Its polynomials.
    pub terms: [f32; EIGENSHADE_SCENE_F32],
}

// SAFETY: consists only of floats.
unsafe impl Plain for WorkspaceF32 {}
// SAFETY: consists only of floats.
unsafe impl Plain for TransferF32 {}
// SAFETY: consists only of floats.
unsafe impl Plain for CoefficientsF32 {}
// SAFETY: consists only of floats.
unsafe impl Plain for SceneF32 {}

impl LightF32 {
    /// # Safety
    ///
    /// As [`slice`] asks.
    pub(crate) unsafe fn view<'a>(&self) -> Result<Light<'a, f32>, Status> {
        if self.degree > EIGENSHADE_DEGREE {
            return Err(Status::LightBeyond);
        }
        if self.length != light::count(self.degree) {
            return Err(Status::LightLength);
        }
        // SAFETY: this function's caller promises as much.
        let coefficients = unsafe { slice(self.coefficients, self.length) }?;
        Ok(Light::new(coefficients)?)
    }

    /// Where it and its coefficients lie.
    pub(crate) fn places(&self) -> Result<[Place; 2], Status> {
        Ok([Place::of(self), Place::many(self.coefficients, self.length)?])
    }
}

impl MaterialF32 {
    /// # Safety
    ///
    /// As [`slice`] asks.
    pub(crate) unsafe fn view<'a>(&self) -> Result<Material<'a, f32>, Status> {
        if self.order > EIGENSHADE_ORDER {
            return Err(Status::MaterialBeyond);
        }
        if self.length != material::count(self.order) {
            return Err(Status::MaterialLength);
        }
        // SAFETY: this function's caller promises as much.
        let coefficients = unsafe { slice(self.coefficients, self.length) }?;
        Ok(Material::new(coefficients)?)
    }

    /// Where it and its coefficients lie.
    pub(crate) fn places(&self) -> Result<[Place; 2], Status> {
        Ok([Place::of(self), Place::many(self.coefficients, self.length)?])
    }
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
pub unsafe extern "C" fn eigenshade_transfer_f32(
    material: *const MaterialF32,
    workspace: *mut WorkspaceF32,
    transfer: *mut TransferF32,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let from = unsafe { shared(material) }?;
        // SAFETY: as this function asks of its caller.
        let material = unsafe { from.view() }?;
        disjoint(&[Place::of(workspace), Place::of(transfer)], &from.places()?)?;
        // SAFETY: as this function asks of its caller; nothing overlaps.
        let (workspace, transfer) = unsafe { (exclusive(workspace)?, exclusive(transfer)?) };
        let (workspace, transfer) = (&mut workspace.numbers, &mut transfer.numbers);
        Ok(sphere::BASIS.transfer_into(&material, workspace, transfer)?)
    })
}

/// Computes d of a new light on a material from its transfer.
///
/// Cost: a multiplication for each number of the transfer. On an error `coefficients` is
/// as it was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `coefficients` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_relight_f32(
    transfer: *const TransferF32,
    light: *const LightF32,
    coefficients: *mut CoefficientsF32,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let (transfer, from) = unsafe { (shared(transfer)?, shared(light)?) };
        // SAFETY: as this function asks of its caller.
        let light = unsafe { from.view() }?;
        let [of_light, of_coefficients] = from.places()?;
        disjoint(&[Place::of(coefficients)], &[Place::of(transfer), of_light, of_coefficients])?;
        // SAFETY: as this function asks of its caller; it overlaps no other.
        let coefficients = unsafe { exclusive(coefficients) }?;
        let (transfer, coefficients) = (&transfer.numbers, &mut coefficients.numbers);
        Ok(sizes::BASIS_F32.relight_into(transfer, &light, coefficients)?)
    })
}

/// Computes d of a light on a material without a transfer, for when both change each time.
///
/// Cost: as `eigenshade_transfer_f32`. On an error `coefficients` is as it was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `workspace` and `coefficients` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_project_f32(
    light: *const LightF32,
    material: *const MaterialF32,
    workspace: *mut WorkspaceF32,
    coefficients: *mut CoefficientsF32,
) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let (of_light, of_material) = unsafe { (shared(light)?, shared(material)?) };
        // SAFETY: as this function asks of its caller.
        let (light, material) = unsafe { (of_light.view()?, of_material.view()?) };
        let read = [of_light.places()?, of_material.places()?];
        disjoint(&[Place::of(workspace), Place::of(coefficients)], read.as_flattened())?;
        // SAFETY: as this function asks of its caller; nothing overlaps.
        let (workspace, coefficients) =
            unsafe { (exclusive(workspace)?, exclusive(coefficients)?) };
        let (workspace, coefficients) = (&mut workspace.numbers, &mut coefficients.numbers);
        Ok(sphere::BASIS.project_into(&light, &material, workspace, coefficients)?)
    })
}

/// Sums the components of each azimuth to a scene, from which pixels are shaded.
///
/// Of d only the first `components` are used, at most EIGENSHADE_COMPONENTS; the others count
/// as zero. On an error `scene` is as it was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `scene` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_collapse_f32(
    coefficients: *const CoefficientsF32,
    components: usize,
    scene: *mut SceneF32,
) -> Status {
    Status::of(|| {
        disjoint(&[Place::of(scene)], &[Place::of(coefficients)])?;
        // SAFETY: as this function asks of its caller.
        let coefficients = unsafe { shared(coefficients) }?;
        let first = coefficients.numbers.get(..components).ok_or(Status::Components)?;
        // SAFETY: as this function asks of its caller.
        let scene = unsafe { exclusive(scene) }?;
        sizes::BASIS_F32.collapse_into(first, &mut scene.terms[..])?;
        Ok(())
    })
}

/// The irradiance of the normal along (x, y, z), in the light's radiance times sr times the
/// material's 1/sr.
///
/// The normal may have any length from 1e-9 to 1e9; it is scaled, which costs a root. One
/// that points away by no more than 1/8 is laid on the rim. On an error `irradiance` is as
/// it was.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, and
/// `irradiance` to nothing else's memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_shade_f32(
    scene: *const SceneF32,
    x: f32,
    y: f32,
    z: f32,
    irradiance: *mut f32,
) -> Status {
    Status::of(|| {
        disjoint(&[Place::of(irradiance)], &[Place::of(scene)])?;
        // SAFETY: as this function asks of its caller.
        let scene = unsafe { shared(scene) }?;
        let (normal, scene) = (Normal::new(x, y, z)?, sizes::BASIS_F32.scene(&scene.terms[..])?);
        // SAFETY: as this function asks of its caller.
        *unsafe { exclusive(irradiance) }? = scene.shade(normal);
        Ok(())
    })
}

/// Whether a light's degree, length and coefficients are in order, all of these finite: for what
/// arrives at run time. The functions that take a light check all but the last.
///
/// Cost: a comparison for each coefficient.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_check_light_f32(light: *const LightF32) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let light = unsafe { shared(light)?.view() }?;
        Light::checked(light.coefficients())?;
        Ok(())
    })
}

/// Whether a material's order, length and coefficients are in order: as
/// `eigenshade_check_light_f32`.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_check_material_f32(material: *const MaterialF32) -> Status {
    Status::of(|| {
        // SAFETY: as this function asks of its caller.
        let material = unsafe { shared(material)?.view() }?;
        Material::checked(material.coefficients())?;
        Ok(())
    })
}

/// Scales `count` normals to length 1, each where it is, and lays those on the rim that point
/// away by no more than 1/8: those of a mesh, or of a normal map, whose channel c of 8 bits says
/// 2c - 255.
///
/// `normalized` becomes their number. If one has no direction or points away by more, it becomes
/// its place, and it and those after it stay as they were; on any other error nothing is written.
/// Cost: a root for each.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, the first three
/// to `count` numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_normalize_f32(
    x: *mut f32,
    y: *mut f32,
    z: *mut f32,
    count: usize,
    normalized: *mut usize,
) -> Status {
    Status::of(|| {
        let [x_place, y_place, z_place] = [x, y, z].map(|axis| Place::many(axis, count));
        disjoint(&[x_place?, y_place?, z_place?, Place::of(normalized)], &[])?;
        // SAFETY: as this function asks of its caller; nothing overlaps.
        let (x, y, z, normalized) = unsafe {
            (
                slice_to_change(x, count)?,
                slice_to_change(y, count)?,
                slice_to_change(z, count)?,
                exclusive(normalized)?,
            )
        };
        for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
            (*x, *y, *z) = Normal::new(*x, *y, *z)?.components().into();
            *normalized += 1;
        }
        Ok(())
    })
}

/// The irradiances of `count` unit normals with z from 0 to 1, into `irradiance`.
///
/// Normals are neither normalized nor checked: a wrong normal has a meaningless irradiance and
/// affects no other; `eigenshade_normalize_f32` normalizes any vectors. If `count` is 0, the
/// pointers are not read. On an error `irradiance` is unchanged.
///
/// # Safety
///
/// Every pointer that is neither NULL nor unaligned points to a value of its type, the last
/// four to `count` numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eigenshade_shade_many_f32(
    scene: *const SceneF32,
    count: usize,
    x: *const f32,
    y: *const f32,
    z: *const f32,
    irradiance: *mut f32,
) -> Status {
    Status::of(|| {
        let [x_place, y_place, z_place] = [x, y, z].map(|axis| Place::many(axis, count));
        let read = [x_place?, y_place?, z_place?, Place::of(scene)];
        disjoint(&[Place::many(irradiance, count)?], &read)?;
        // SAFETY: as this function asks of its caller.
        let scene = unsafe { shared(scene) }?;
        // SAFETY: as this function asks of its caller.
        let (x, y, z) = unsafe { (slice(x, count)?, slice(y, count)?, slice(z, count)?) };
        // SAFETY: as this function asks of its caller; it overlaps no other.
        let irradiance = unsafe { slice_to_write(irradiance, count) }?;
        let scene = sizes::BASIS_F32.scene(&scene.terms[..])?;
        Ok(scene.shade_slice(Normals::new(x, y, z)?, irradiance)?)
    })
}
