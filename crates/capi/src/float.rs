//! In float: `f32`, for machines with a float unit.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint, normals};
use crate::export::{export, records};
use crate::status::{Status, light_shape, material_shape};
use crate::table::{self, COMPONENTS, SCENE, TRANSFER, WORKSPACE};
use eigenshade::specialized::checked;
use eigenshade::{Basis, Normal, Normals, Parts};

/// The basis without the factors of transfers: a program whose transfers are computed beforehand
/// links no factors.
static RELIGHT_ONLY: Basis<'static> =
    checked(Basis::new(Parts { polar: &[], factors: &[], ..*table::BASIS.parts() }));

records! {
    Light = "light" f32: degree: usize, length: usize, coefficients: Input<f32>;
    Material = "material" f32: order: usize, length: usize, coefficients: Input<f32>;
    Workspace = "workspace" f32: numbers: [f32; WORKSPACE];
    Transfer = "transfer" f32: numbers: [f32; TRANSFER];
    Coefficients = "coefficients" f32: numbers: [f32; COMPONENTS];
    Scene = "scene" f32: terms: [f32; SCENE], state: Mark;
}

impl Light {
    /// The light, and where it lies.
    pub(crate) fn view(&self) -> Result<(eigenshade::Light<'_>, [Place; 2]), Status> {
        light_shape(self.degree, self.length)?;
        // SAFETY: C promises `length` coefficients.
        let coefficients = unsafe { self.coefficients.array(self.length) }?;
        let places = [Place::of(self), Place::of(coefficients)];
        Ok((eigenshade::Light::from_finite(coefficients)?, places))
    }
}

impl Scene {
    /// Refuses a scene that was never computed.
    pub(crate) fn check(&self) -> Result<(), Status> {
        if self.state == Mark::COMPUTED { Ok(()) } else { Err(Status::Scene) }
    }
}

impl Material {
    /// The material, and where it lies.
    pub(crate) fn view(&self) -> Result<(eigenshade::Material<'_>, [Place; 2]), Status> {
        material_shape(self.order, self.length)?;
        // SAFETY: C promises `length` coefficients.
        let coefficients = unsafe { self.coefficients.array(self.length) }?;
        let places = [Place::of(self), Place::of(coefficients)];
        Ok((eigenshade::Material::from_finite(coefficients)?, places))
    }
}

/// Writes the transfer of a material.
pub(crate) fn transferred(
    material: &eigenshade::Material<'_>,
    workspace: &mut [f32; WORKSPACE],
    transfer: &mut Transfer,
) -> Result<(), Status> {
    Ok(table::BASIS.transfer_into(material, workspace, &mut transfer.numbers)?)
}

/// Computes d from a transfer.
pub(crate) fn relit(
    transfer: &Transfer,
    light: &eigenshade::Light<'_>,
    d: &mut [f32; COMPONENTS],
) -> Result<(), Status> {
    Ok(RELIGHT_ONLY.relight_into(&transfer.numbers, light, d)?)
}

/// Sums the first components to a scene.
pub(crate) fn collapsed(d: &[f32], scene: &mut Scene) -> Result<(), Status> {
    RELIGHT_ONLY.collapse_into(d, &mut scene.terms[..])?;
    scene.state = Mark::COMPUTED;
    Ok(())
}

/// The image, for steps that the runtime alone has.
pub(crate) fn view(scene: &Scene) -> Result<eigenshade::Scene<'_, &[f32]>, Status> {
    scene.check()?;
    Ok(RELIGHT_ONLY.scene(&scene.terms[..])?)
}

/// The irradiance, with every size a constant.
// Shared by all that shades.
#[inline(never)]
pub(crate) fn irradiance(scene: &Scene, normal: Normal) -> f32 {
    table::shade_terms(&scene.terms, normal)
}

pub(crate) fn transfer(
    material: Input<Material>,
    workspace: Output<Workspace>,
    transfer: Output<Transfer>,
) -> Result<(), Status> {
    let (material, read) = material.value()?.view()?;
    disjoint(&[workspace.place(), transfer.place()], &read)?;
    // SAFETY: nothing overlaps.
    let (workspace, transfer) = unsafe { (workspace.zeroed()?, transfer.zeroed()?) };
    transferred(&material, &mut workspace.numbers, transfer)
}

pub(crate) fn relight(
    transfer: Input<Transfer>,
    light: Input<Light>,
    coefficients: Output<Coefficients>,
) -> Result<(), Status> {
    let transfer = transfer.value()?;
    let (light, [of_light, of_numbers]) = light.value()?.view()?;
    disjoint(&[coefficients.place()], &[Place::of(transfer), of_light, of_numbers])?;
    // SAFETY: it overlaps no other.
    let coefficients = unsafe { coefficients.zeroed() }?;
    relit(transfer, &light, &mut coefficients.numbers)
}

pub(crate) fn project(
    light: Input<Light>,
    material: Input<Material>,
    workspace: Output<Workspace>,
    coefficients: Output<Coefficients>,
) -> Result<(), Status> {
    let (light, of_light) = light.value()?.view()?;
    let (material, of_material) = material.value()?.view()?;
    let written = [workspace.place(), coefficients.place()];
    disjoint(&written, [of_light, of_material].as_flattened())?;
    // SAFETY: nothing overlaps.
    let (workspace, coefficients) = unsafe { (workspace.zeroed()?, coefficients.zeroed()?) };
    let (workspace, coefficients) = (&mut workspace.numbers, &mut coefficients.numbers);
    Ok(table::BASIS.project_into(&light, &material, workspace, coefficients)?)
}

pub(crate) fn collapse(
    coefficients: Input<Coefficients>,
    components: usize,
    scene: Output<Scene>,
) -> Result<(), Status> {
    let coefficients = coefficients.value()?;
    disjoint(&[scene.place()], &[Place::of(coefficients)])?;
    let first = coefficients.numbers.get(..components).ok_or(Status::Components)?;
    // SAFETY: it overlaps no other.
    collapsed(first, unsafe { scene.zeroed() }?)
}

pub(crate) fn shade(
    scene: Input<Scene>,
    x: f32,
    y: f32,
    z: f32,
    irradiance: Output<f32>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    disjoint(&[irradiance.place()], &[Place::of(scene)])?;
    scene.check()?;
    let found = self::irradiance(scene, Normal::new(x, y, z)?);
    // SAFETY: it overlaps no other.
    *unsafe { irradiance.zeroed() }? = found;
    Ok(())
}

pub(crate) fn check_light(light: Input<Light>) -> Result<(), Status> {
    let (light, _) = light.value()?.view()?;
    eigenshade::Light::new(light.coefficients())?;
    Ok(())
}

pub(crate) fn check_material(material: Input<Material>) -> Result<(), Status> {
    let (material, _) = material.value()?.view()?;
    eigenshade::Material::new(material.coefficients())?;
    Ok(())
}

pub(crate) fn normalize(
    x: Output<f32>,
    y: Output<f32>,
    z: Output<f32>,
    count: usize,
    normalized: Output<usize>,
) -> Result<(), Status> {
    let [of_x, of_y, of_z] = [&x, &y, &z].map(|axis| axis.place_of_array(count));
    disjoint(&[of_x?, of_y?, of_z?, normalized.place()], &[])?;
    // SAFETY: C promises `count` numbers each; nothing overlaps.
    let (x, y, z) = unsafe { (x.array(count)?, y.array(count)?, z.array(count)?) };
    // SAFETY: it overlaps no other.
    let normalized = unsafe { normalized.zeroed() }?;
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        (*x, *y, *z) = Normal::new(*x, *y, *z)?.components().into();
        *normalized += 1;
    }
    Ok(())
}

pub(crate) fn shade_many(
    scene: Input<Scene>,
    count: usize,
    x: Input<f32>,
    y: Input<f32>,
    z: Input<f32>,
    irradiance: Output<f32>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    scene.check()?;
    // SAFETY: C promises `count` numbers each.
    let ([x, y, z], irradiance) =
        unsafe { normals(Place::of(scene), count, [&x, &y, &z], &irradiance) }?;
    for (irradiance, normal) in irradiance.iter_mut().zip(Normals::from_unit(x, y, z)?.iter()) {
        *irradiance = self::irradiance(scene, normal);
    }
    Ok(())
}

export! { functions "f32"
    transfer(material: Input<Material>, workspace: Output<Workspace>, transfer: Output<Transfer>)
    relight(transfer: Input<Transfer>, light: Input<Light>, coefficients: Output<Coefficients>)
    project(
        light: Input<Light>, material: Input<Material>,
        workspace: Output<Workspace>, coefficients: Output<Coefficients>
    )
    collapse(coefficients: Input<Coefficients>, components: usize, scene: Output<Scene>)
    shade(scene: Input<Scene>, x: f32, y: f32, z: f32, irradiance: Output<f32>)
    check_light(light: Input<Light>)
    check_material(material: Input<Material>)
    normalize(
        x: Output<f32>, y: Output<f32>, z: Output<f32>, count: usize, normalized: Output<usize>
    )
    shade_many(
        scene: Input<Scene>, count: usize,
        x: Input<f32>, y: Input<f32>, z: Input<f32>, irradiance: Output<f32>
    )
}
