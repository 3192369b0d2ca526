//! In integers: mantissas of 15 or 31 bits, for machines without a float unit.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, Plain, disjoint, normals};
use crate::export::{export, records};
use crate::float;
use crate::status::{Status, light_shape, material_shape};
use crate::table::q31::{PROFILES, TRANSFER, WORKSPACE};
use crate::table::{self, COMPONENTS};
use core::marker::PhantomData;
use eigenshade::quantized::{Basis, Normal, Parts};
use eigenshade::specialized::checked;
use eigenshade::{Error, FixedPoint, Q15, Q31, quantized};

/// The largest exponent of d. Lights and materials reach less than half of it.
const EXPONENT: u32 = 2_048;

/// An integer format and its shipped basis.
pub(crate) trait Shipped: FixedPoint<Wide: Plain> + Plain {
    /// The polynomials of a scene.
    type Terms: AsRef<[i32]> + AsMut<[i32]> + Plain;
    /// The complete basis, which computes transfers.
    fn basis() -> &'static Basis<'static, Self>;
    /// The basis without the factors of transfers: a program whose transfers are computed
    /// beforehand links no factors.
    fn relight_only() -> &'static Basis<'static, Self>;
    fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error>;
    /// The irradiance, with every size a constant.
    fn irradiance(scene: &quantized::Scene<'_, Self, &[i32]>, normal: Normal<Self>) -> i32;
}

macro_rules! shipped {
    ($format:ident, $table:ident) => {
        impl Shipped for $format {
            type Terms = [i32; table::$table::SCENE];
            fn basis() -> &'static Basis<'static, Self> {
                &table::$table::BASIS
            }
            fn relight_only() -> &'static Basis<'static, Self> {
                static BASIS: Basis<'static, $format> = checked(Basis::<$format>::new(Parts {
                    polar: &[],
                    polar_exponents: &[],
                    factors: &[],
                    factor_exponents: &[],
                    ..*table::$table::BASIS.parts()
                }));
                &BASIS
            }
            #[inline]
            fn normal(x: Self, y: Self, z: Self) -> Result<Normal<Self>, Error> {
                Normal::<Self>::from_unit(x, y, z)
            }
            // Shared by `shade` and `shade_many`.
            #[inline(never)]
            fn irradiance(scene: &quantized::Scene<'_, Self, &[i32]>, normal: Normal<Self>) -> i32 {
                table::$table::shade(scene, normal)
            }
        }
    };
}
shipped!(Q15, q15);
shipped!(Q31, q31);

records! {
    Light<Q> = "light" Q:
        degree: usize, length: usize, mantissas: Input<Q>, exponent: i32;
    Material<Q> = "material" Q:
        order: usize, length: usize, mantissas: Input<Q>,
        exponents_length: usize, exponents: Input<i8>;
    Workspace<Q> = "workspace" Q: numbers: [Q::Wide; WORKSPACE];
    Transfer<Q> = "transfer" Q: numbers: [Q; TRANSFER], exponents: [i16; PROFILES];
    Coefficients<Q> = "coefficients" Q:
        mantissas: [i32; COMPONENTS], exponent: i32, format: PhantomData<Q>;
    Scene<Q> = "scene" Q: terms: Q::Terms, exponent: i32, state: Mark;
}

impl<Q: Shipped> Light<Q> {
    /// The light, and where it lies.
    pub(crate) fn view(&self) -> Result<(quantized::Light<'_, Q>, [Place; 2]), Status> {
        light_shape(self.degree, self.length)?;
        // SAFETY: C promises `length` mantissas.
        let mantissas = unsafe { self.mantissas.array(self.length) }?;
        let light = quantized::Light::new(self.exponent, mantissas)?;
        Ok((light, [Place::of(self), Place::of(mantissas)]))
    }
}

impl<Q: Shipped> Scene<Q> {
    /// Refuses a scene that was never computed.
    pub(crate) fn check(&self) -> Result<(), Status> {
        if self.state == Mark::COMPUTED { Ok(()) } else { Err(Status::Scene) }
    }
}

impl<Q: Shipped> Material<Q> {
    /// The material, and where it lies.
    pub(crate) fn view(&self) -> Result<(quantized::Material<'_, Q>, [Place; 3]), Status> {
        material_shape(self.order, self.length)?;
        if self.exponents_length != self.order + 1 {
            return Err(Status::MaterialLength);
        }
        // SAFETY: C promises `length` mantissas.
        let mantissas = unsafe { self.mantissas.array(self.length) }?;
        // SAFETY: C promises `exponents_length` exponents.
        let exponents = unsafe { self.exponents.array(self.exponents_length) }?;
        let material = quantized::Material::new(exponents, mantissas)?;
        Ok((material, [Place::of(self), Place::of(mantissas), Place::of(exponents)]))
    }
}

pub(crate) fn quantize_light<Q: Shipped>(
    from: Input<float::Light>,
    mantissas: Output<Q>,
    length: usize,
    to: Output<Light<Q>>,
) -> Result<(), Status> {
    let from = from.value()?;
    if length != from.length {
        return Err(Status::LightLength);
    }
    let (light, read) = from.view()?;
    disjoint(&[to.place(), mantissas.place_of_array(length)?], &read)?;
    // SAFETY: C promises memory for `length` numbers, which overlaps no other.
    let numbers = unsafe { mantissas.zeroed_array(length) }?;
    let exponent = quantized::Light::quantize(light.coefficients(), numbers)?.exponent();
    // SAFETY: it overlaps no other.
    let to = unsafe { to.zeroed() }?;
    *to = Light { degree: from.degree, length, mantissas: mantissas.to_input(), exponent };
    Ok(())
}

pub(crate) fn quantize_material<Q: Shipped>(
    from: Input<float::Material>,
    mantissas: Output<Q>,
    length: usize,
    exponents: Output<i8>,
    exponents_length: usize,
    to: Output<Material<Q>>,
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
    quantized::Material::quantize(material.coefficients(), numbers, powers)?;
    // SAFETY: it overlaps no other.
    let to = unsafe { to.zeroed() }?;
    let (mantissas, exponents) = (mantissas.to_input(), exponents.to_input());
    let order = from.order;
    *to = Material { order, length, mantissas, exponents_length, exponents };
    Ok(())
}

/// Writes the transfer of a material.
pub(crate) fn transferred<Q: Shipped>(
    material: &quantized::Material<'_, Q>,
    workspace: &mut [Q::Wide; WORKSPACE],
    transfer: &mut Transfer<Q>,
) -> Result<(), Status> {
    let Transfer { numbers, exponents } = transfer;
    Ok(Q::basis().transfer_into(material, workspace, numbers, exponents)?)
}

pub(crate) fn transfer<Q: Shipped>(
    material: Input<Material<Q>>,
    workspace: Output<Workspace<Q>>,
    transfer: Output<Transfer<Q>>,
) -> Result<(), Status> {
    let (material, read) = material.value()?.view()?;
    disjoint(&[workspace.place(), transfer.place()], &read)?;
    // SAFETY: nothing overlaps.
    let (workspace, transfer) = unsafe { (workspace.zeroed()?, transfer.zeroed()?) };
    transferred(&material, &mut workspace.numbers, transfer)
}

/// Computes d from a transfer.
#[inline(always)]
pub(crate) fn relit<Q: Shipped>(
    transfer: &Transfer<Q>,
    light: &quantized::Light<'_, Q>,
    coefficients: &mut Coefficients<Q>,
) -> Result<(), Status> {
    let transfer = quantized::Transfer::new(&transfer.numbers, &transfer.exponents);
    let mantissas = &mut coefficients.mantissas;
    coefficients.exponent = Q::relight_only().relight_into(&transfer, light, mantissas)?;
    Ok(())
}

pub(crate) fn relight<Q: Shipped>(
    transfer: Input<Transfer<Q>>,
    light: Input<Light<Q>>,
    coefficients: Output<Coefficients<Q>>,
) -> Result<(), Status> {
    let transfer = transfer.value()?;
    let (light, [of_light, of_mantissas]) = light.value()?.view()?;
    disjoint(&[coefficients.place()], &[Place::of(transfer), of_light, of_mantissas])?;
    // SAFETY: it overlaps no other.
    relit(transfer, &light, unsafe { coefficients.zeroed() }?)
}

pub(crate) fn project<Q: Shipped>(
    light: Input<Light<Q>>,
    material: Input<Material<Q>>,
    workspace: Output<Workspace<Q>>,
    transfer: Output<Transfer<Q>>,
    coefficients: Output<Coefficients<Q>>,
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

pub(crate) fn collapse<Q: Shipped>(
    coefficients: Input<Coefficients<Q>>,
    components: usize,
    scene: Output<Scene<Q>>,
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
pub(crate) fn collapsed<Q: Shipped>(
    mantissas: &[i32],
    exponent: i32,
    scene: &mut Scene<Q>,
) -> Result<(), Status> {
    let Scene { terms, exponent: of_scene, state } = scene;
    *of_scene = Q::relight_only().collapse_into(mantissas, exponent, terms.as_mut())?.exponent();
    *state = Mark::COMPUTED;
    Ok(())
}

/// The irradiance of a normal, times 2 to the scene's negative exponent.
#[inline]
pub(crate) fn irradiance<Q: Shipped>(scene: &Scene<Q>, normal: Normal<Q>) -> Result<i32, Status> {
    Ok(Q::irradiance(&Q::relight_only().scene(0, scene.terms.as_ref())?, normal))
}

pub(crate) fn normalize<Q: Shipped>(vector: Input<i32>, normal: Output<Q>) -> Result<(), Status> {
    // SAFETY: C promises three numbers.
    let vector = unsafe { vector.array(3) }?;
    disjoint(&[normal.place_of_array(3)?], &[Place::of(vector)])?;
    let &[x, y, z] = vector else { return Err(Status::Internal) };
    let found = Normal::<Q>::new(x, y, z)?;
    // SAFETY: C promises memory for three numbers, which overlaps no other.
    let normal = unsafe { normal.zeroed_array(3) }?;
    normal.iter_mut().zip(found.components()).for_each(|(to, from)| *to = from);
    Ok(())
}

pub(crate) fn shade<Q: Shipped>(
    scene: Input<Scene<Q>>,
    x: Q,
    y: Q,
    z: Q,
    irradiance: Output<i32>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    disjoint(&[irradiance.place()], &[Place::of(scene)])?;
    scene.check()?;
    let normal = Q::normal(x, y, z)?;
    let found = self::irradiance(scene, normal)?;
    // SAFETY: it overlaps no other.
    *unsafe { irradiance.zeroed() }? = found;
    Ok(())
}

pub(crate) fn shade_many<Q: Shipped>(
    scene: Input<Scene<Q>>,
    count: usize,
    x: Input<Q>,
    y: Input<Q>,
    z: Input<Q>,
    irradiance: Output<i32>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    scene.check()?;
    // SAFETY: C promises `count` numbers each.
    let ([x, y, z], irradiance) =
        unsafe { normals(Place::of(scene), count, [&x, &y, &z], &irradiance) }?;
    let scene = Q::relight_only().scene(0, scene.terms.as_ref())?;
    for (((irradiance, &x), &y), &z) in irradiance.iter_mut().zip(x).zip(y).zip(z) {
        *irradiance = Q::irradiance(&scene, Q::normal(x, y, z)?);
    }
    Ok(())
}

macro_rules! exported {
    ($module:ident $format:literal $q:ty) => {
        export! { $module $format
            quantize_light(
                from: Input<float::Light>, mantissas: Output<$q>, length: usize,
                to: Output<Light<$q>>
            )
            quantize_material(
                from: Input<float::Material>, mantissas: Output<$q>, length: usize,
                exponents: Output<i8>, exponents_length: usize, to: Output<Material<$q>>
            )
            transfer(
                material: Input<Material<$q>>, workspace: Output<Workspace<$q>>,
                transfer: Output<Transfer<$q>>
            )
            relight(
                transfer: Input<Transfer<$q>>, light: Input<Light<$q>>,
                coefficients: Output<Coefficients<$q>>
            )
            project(
                light: Input<Light<$q>>, material: Input<Material<$q>>,
                workspace: Output<Workspace<$q>>, transfer: Output<Transfer<$q>>,
                coefficients: Output<Coefficients<$q>>
            )
            collapse(
                coefficients: Input<Coefficients<$q>>, components: usize, scene: Output<Scene<$q>>
            )
            normalize(vector: Input<i32>, normal: Output<$q>)
            shade(scene: Input<Scene<$q>>, x: $q, y: $q, z: $q, irradiance: Output<i32>)
            shade_many(
                scene: Input<Scene<$q>>, count: usize, x: Input<$q>, y: Input<$q>, z: Input<$q>,
                irradiance: Output<i32>
            )
        }
    };
}
exported!(q15_functions "q15" Q15);
exported!(q31_functions "q31" Q31);
