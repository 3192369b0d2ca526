//! In integers: mantissas of 15 bits, for machines without a float unit.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint, normals};
use crate::export::{export, records};
use crate::float;
use crate::status::{Status, light_shape, material_shape};
use crate::table::q15::{PROFILES, SCENE, TRANSFER, WORKSPACE};
use crate::table::{self, COMPONENTS};
use eigenshade::Q15;
use eigenshade::q15::{self, Basis, Normal, Parts};
use eigenshade::specialized::checked;

/// The largest exponent of d. Lights and materials reach less than half of it.
const EXPONENT: u32 = 2_048;

/// The complete basis, which computes transfers.
fn basis() -> &'static Basis<'static> {
    &table::q15::BASIS
}

/// The basis without the factors of transfers: a program whose transfers are computed beforehand
/// links no factors.
fn relight_only() -> &'static Basis<'static> {
    static BASIS: Basis<'static> = checked(Basis::new(Parts {
        polar: &[],
        polar_exponents: &[],
        factors: &[],
        factor_exponents: &[],
        ..*table::q15::BASIS.parts()
    }));
    &BASIS
}

records! {
    Light = "light" Q15:
        degree: usize, length: usize, mantissas: Input<Q15>, exponent: i32;
    Material = "material" Q15:
        order: usize, length: usize, mantissas: Input<Q15>,
        exponents_length: usize, exponents: Input<i8>;
    Workspace = "workspace" Q15: numbers: [i32; WORKSPACE];
    Transfer = "transfer" Q15: numbers: [Q15; TRANSFER], exponents: [i16; PROFILES];
    Coefficients = "coefficients" Q15:
        mantissas: [i32; COMPONENTS], exponent: i32;
    Scene = "scene" Q15: terms: [i32; SCENE], exponent: i32, state: Mark;
}

impl Light {
    /// The light, and where it lies.
    pub(crate) fn view(&self) -> Result<(q15::Light<'_>, [Place; 2]), Status> {
        light_shape(self.degree, self.length)?;
        // SAFETY: C promises `length` mantissas.
        let mantissas = unsafe { self.mantissas.array(self.length) }?;
        let light = q15::Light::new(self.exponent, mantissas)?;
        Ok((light, [Place::of(self), Place::of(mantissas)]))
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
    pub(crate) fn view(&self) -> Result<(q15::Material<'_>, [Place; 3]), Status> {
        material_shape(self.order, self.length)?;
        if self.exponents_length != self.order + 1 {
            return Err(Status::MaterialLength);
        }
        // SAFETY: C promises `length` mantissas.
        let mantissas = unsafe { self.mantissas.array(self.length) }?;
        // SAFETY: C promises `exponents_length` exponents.
        let exponents = unsafe { self.exponents.array(self.exponents_length) }?;
        let material = q15::Material::new(exponents, mantissas)?;
        Ok((material, [Place::of(self), Place::of(mantissas), Place::of(exponents)]))
    }
}

pub(crate) fn quantize_light(
    from: Input<float::Light>,
    mantissas: Output<Q15>,
    length: usize,
    to: Output<Light>,
) -> Result<(), Status> {
    let from = from.value()?;
    if length != from.length {
        return Err(Status::LightLength);
    }
    let (light, read) = from.view()?;
    disjoint(&[to.place(), mantissas.place_of_array(length)?], &read)?;
    // SAFETY: C promises memory for `length` numbers, which overlaps no other.
    let numbers = unsafe { mantissas.zeroed_array(length) }?;
    let exponent = q15::Light::quantize(light.coefficients(), numbers)?.exponent();
    // SAFETY: it overlaps no other.
    let to = unsafe { to.zeroed() }?;
    *to = Light { degree: from.degree, length, mantissas: mantissas.to_input(), exponent };
    Ok(())
}

pub(crate) fn quantize_material(
    from: Input<float::Material>,
    mantissas: Output<Q15>,
    length: usize,
    exponents: Output<i8>,
    exponents_length: usize,
    to: Output<Material>,
) -> Result<(), Status> {
    let from = from.value()?;
    if length != from.length || exponents_length.wrapping_sub(1) != from.order {
        return Err(Status::MaterialLength);
    }
    let (material, read) = from.view()?;
    let of_mantissas = mantissas.place_of_array(length)?;
    disjoint(&[to.place(), of_mantissas, exponents.place_of_array(exponents_length)?], &read)?;
    // SAFETY: C promises memory for `length` numbers, which overlaps no other.
    let numbers = unsafe { mantissas.zeroed_array(length) }?;
    // SAFETY: C promises memory for `exponents_length` numbers, which overlaps no other.
    let powers = unsafe { exponents.zeroed_array(exponents_length) }?;
    q15::Material::quantize(material.coefficients(), numbers, powers)?;
    // SAFETY: it overlaps no other.
    let to = unsafe { to.zeroed() }?;
    let (mantissas, exponents) = (mantissas.to_input(), exponents.to_input());
    let order = from.order;
    *to = Material { order, length, mantissas, exponents_length, exponents };
    Ok(())
}

/// Writes the transfer of a material.
pub(crate) fn transferred(
    material: &q15::Material<'_>,
    workspace: &mut [i32; WORKSPACE],
    transfer: &mut Transfer,
) -> Result<(), Status> {
    let Transfer { numbers, exponents } = transfer;
    Ok(basis().transfer_into(material, workspace, numbers, exponents)?)
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

/// Computes d from a transfer.
#[inline(always)]
pub(crate) fn relit(
    transfer: &Transfer,
    light: &q15::Light<'_>,
    coefficients: &mut Coefficients,
) -> Result<(), Status> {
    let transfer = q15::Transfer::new(&transfer.numbers, &transfer.exponents);
    let mantissas = &mut coefficients.mantissas;
    coefficients.exponent = relight_only().relight_into(&transfer, light, mantissas)?;
    Ok(())
}

pub(crate) fn relight(
    transfer: Input<Transfer>,
    light: Input<Light>,
    coefficients: Output<Coefficients>,
) -> Result<(), Status> {
    let transfer = transfer.value()?;
    let (light, [of_light, of_mantissas]) = light.value()?.view()?;
    disjoint(&[coefficients.place()], &[Place::of(transfer), of_light, of_mantissas])?;
    // SAFETY: it overlaps no other.
    relit(transfer, &light, unsafe { coefficients.zeroed() }?)
}

pub(crate) fn project(
    light: Input<Light>,
    material: Input<Material>,
    workspace: Output<Workspace>,
    transfer: Output<Transfer>,
    coefficients: Output<Coefficients>,
) -> Result<(), Status> {
    let (light, of_light) = light.value()?.view()?;
    let (material, of_material) = material.value()?.view()?;
    let written = [workspace.place(), transfer.place(), coefficients.place()];
    disjoint(&written, &of_light)?;
    disjoint(&written, &of_material)?;
    // SAFETY: nothing overlaps.
    let (workspace, transfer) = unsafe { (workspace.zeroed()?, transfer.zeroed()?) };
    // SAFETY: it overlaps no other.
    let coefficients = unsafe { coefficients.zeroed() }?;
    transferred(&material, &mut workspace.numbers, transfer)?;
    relit(transfer, &light, coefficients)
}

pub(crate) fn collapse(
    coefficients: Input<Coefficients>,
    components: usize,
    scene: Output<Scene>,
) -> Result<(), Status> {
    let coefficients = coefficients.value()?;
    disjoint(&[scene.place()], &[Place::of(coefficients)])?;
    let &Coefficients { ref mantissas, exponent, .. } = coefficients;
    if exponent.unsigned_abs() > EXPONENT {
        return Err(Status::Exponent);
    }
    let first = mantissas.get(..components).ok_or(Status::Components)?;
    // SAFETY: it overlaps no other.
    collapsed(first, exponent, unsafe { scene.zeroed() }?)
}

/// Sums the first components to a scene.
pub(crate) fn collapsed(mantissas: &[i32], exponent: i32, scene: &mut Scene) -> Result<(), Status> {
    let Scene { terms, exponent: of_scene, state } = scene;
    *of_scene = relight_only().collapse_into(mantissas, exponent, terms)?.exponent();
    *state = Mark::COMPUTED;
    Ok(())
}

/// The irradiance of a normal, times 2 to the scene's negative exponent, with every size a constant.
// Shared by all that shades.
#[inline(never)]
pub(crate) fn irradiance(scene: &Scene, normal: Normal) -> i32 {
    table::q15::shade_terms(&scene.terms, normal)
}

pub(crate) fn normalize(vector: Input<i32>, normal: Output<Q15>) -> Result<(), Status> {
    // SAFETY: C promises three numbers.
    let vector = unsafe { vector.array(3) }?;
    disjoint(&[normal.place_of_array(3)?], &[Place::of(vector)])?;
    let &[x, y, z] = vector else { return Err(Status::Internal) };
    let found = Normal::new(x, y, z)?;
    // SAFETY: C promises memory for three numbers, which overlaps no other.
    let normal = unsafe { normal.zeroed_array(3) }?;
    normal.iter_mut().zip(found.components()).for_each(|(to, from)| *to = from);
    Ok(())
}

pub(crate) fn shade(
    scene: Input<Scene>,
    x: Q15,
    y: Q15,
    z: Q15,
    irradiance: Output<i32>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    disjoint(&[irradiance.place()], &[Place::of(scene)])?;
    scene.check()?;
    let normal = Normal::from_unit(x, y, z)?;
    let found = self::irradiance(scene, normal);
    // SAFETY: it overlaps no other.
    *unsafe { irradiance.zeroed() }? = found;
    Ok(())
}

pub(crate) fn shade_many(
    scene: Input<Scene>,
    count: usize,
    x: Input<Q15>,
    y: Input<Q15>,
    z: Input<Q15>,
    irradiance: Output<i32>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    scene.check()?;
    // SAFETY: C promises `count` numbers each.
    let ([x, y, z], irradiance) =
        unsafe { normals(Place::of(scene), count, [&x, &y, &z], &irradiance) }?;
    for (((irradiance, &x), &y), &z) in irradiance.iter_mut().zip(x).zip(y).zip(z) {
        *irradiance = self::irradiance(scene, Normal::from_unit(x, y, z)?);
    }
    Ok(())
}

export! { functions "q15"
    quantize_light(
        from: Input<float::Light>, mantissas: Output<Q15>, length: usize,
        to: Output<Light>
    )
    quantize_material(
        from: Input<float::Material>, mantissas: Output<Q15>, length: usize,
        exponents: Output<i8>, exponents_length: usize, to: Output<Material>
    )
    transfer(
        material: Input<Material>, workspace: Output<Workspace>,
        transfer: Output<Transfer>
    )
    relight(
        transfer: Input<Transfer>, light: Input<Light>,
        coefficients: Output<Coefficients>
    )
    project(
        light: Input<Light>, material: Input<Material>,
        workspace: Output<Workspace>, transfer: Output<Transfer>,
        coefficients: Output<Coefficients>
    )
    collapse(
        coefficients: Input<Coefficients>, components: usize, scene: Output<Scene>
    )
    normalize(vector: Input<i32>, normal: Output<Q15>)
    shade(scene: Input<Scene>, x: Q15, y: Q15, z: Q15, irradiance: Output<i32>)
    shade_many(
        scene: Input<Scene>, count: usize, x: Input<Q15>, y: Input<Q15>, z: Input<Q15>,
        irradiance: Output<i32>
    )
}
