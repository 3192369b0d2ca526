//! Lights, materials and normals in integers.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, disjoint};
use crate::constants::MATERIAL_BUFFER;
use crate::format::Format;
use crate::records_f32::{ColorLightF32, ColorMaterialF32};
use crate::records_q15::{
    ColorLightQ15, ColorMaterialQ15, LightBufferQ15, LightQ15, MaterialBufferQ15, MaterialQ15,
};
use crate::status::Status;
use crate::table::LIGHT;
use eigenshade::q15::{Light, LightBuffer, Material, Normal};
use eigenshade::{Q15, Rgb};
use eigenshade_table::material;

/// A light of C whose mantissas are the first ones of these.
pub(crate) fn pointing(to: &[Q15; LIGHT], length: usize, exponent: i32) -> LightQ15 {
    let degree = length.isqrt().saturating_sub(1);
    LightQ15 { degree, length, mantissas: to.as_ptr(), exponent }
}

/// A light of C from the coefficients of each channel.
pub(crate) fn quantized<B: AsRef<[f32]>>(
    from: &Rgb<B>,
    buffer: &mut LightBufferQ15,
) -> Result<ColorLightQ15, Status> {
    let channels = Rgb::from(buffer.mantissas.each_mut()).zip(from.each_ref());
    let channels = channels.try_map(|(to, from)| {
        let length = from.as_ref().len();
        let numbers = to.get_mut(..length).ok_or(Status::Internal)?;
        let exponent = Light::quantize(from.as_ref(), numbers)?.exponent();
        Ok::<_, Status>(pointing(to, length, exponent))
    })?;
    Ok(ColorLightQ15 { r: channels.r, g: channels.g, b: channels.b })
}

/// A channel of a material of C in this memory.
fn material_in(mantissas: &[Q15], exponents: &[i8], order: usize) -> MaterialQ15 {
    MaterialQ15 {
        order,
        length: material::count(order),
        mantissas: mantissas.as_ptr(),
        exponents_length: order + 1,
        exponents: exponents.as_ptr(),
    }
}

/// A light of C from one of the runtime, whose mantissas it copies to `to`.
fn stored(from: Light<'_>, to: &mut [Q15; LIGHT]) -> LightQ15 {
    let (mantissas, exponent) = (from.mantissas(), from.exponent());
    to.iter_mut().zip(mantissas).for_each(|(to, &from)| *to = from);
    pointing(to, mantissas.len(), exponent)
}

/// Stores turned lights.
pub(crate) fn stored_lights(
    turned: &Rgb<LightBuffer<LIGHT>>,
    buffer: &mut LightBufferQ15,
) -> Result<ColorLightQ15, Status> {
    let ([to_r, to_g, to_b], Rgb { r, g, b }) = (&mut buffer.mantissas, turned.lights()?);
    Ok(ColorLightQ15 { r: stored(r, to_r), g: stored(g, to_g), b: stored(b, to_b) })
}

/// Stores materials, whose mantissas it modifies.
pub(crate) fn stored_materials(
    from: Rgb<Material<'_>>,
    buffer: &mut MaterialBufferQ15,
    modify: impl Fn(&mut [Q15; MATERIAL_BUFFER]),
) -> ColorMaterialQ15 {
    let numbers = Rgb::from(buffer.mantissas.each_mut());
    let numbers = numbers.zip(Rgb::from(buffer.exponents.each_mut())).zip(from);
    let channels = numbers.map(|((mantissas, exponents), from)| {
        mantissas.iter_mut().zip(from.mantissas()).for_each(|(to, &from)| *to = from);
        exponents.iter_mut().zip(from.exponents()).for_each(|(to, &from)| *to = from);
        modify(mantissas);
        material_in(mantissas, exponents, from.exponents().len().saturating_sub(1))
    });
    ColorMaterialQ15 { r: channels.r, g: channels.g, b: channels.b }
}

pub(crate) fn quantize_light(
    from: &Input<ColorLightF32>,
    buffer: &Output<LightBufferQ15>,
    to: &Output<ColorLightQ15>,
) -> Result<(), Status> {
    let from = f32::light(from.value()?)?;
    disjoint(&[buffer.place(), to.place()], &from.places)?;
    // SAFETY: nothing overlaps.
    let (buffer, to) = unsafe { (buffer.zeroed()?, to.zeroed()?) };
    *to = quantized(&from.value.map(|light| light.coefficients()), buffer)?;
    Ok(())
}

pub(crate) fn quantize_material(
    from: &Input<ColorMaterialF32>,
    buffer: &Output<MaterialBufferQ15>,
    to: &Output<ColorMaterialQ15>,
) -> Result<(), Status> {
    let from = f32::material(from.value()?)?;
    disjoint(&[buffer.place(), to.place()], &from.places)?;
    // SAFETY: nothing overlaps.
    let (buffer, to) = unsafe { (buffer.zeroed()?, to.zeroed()?) };
    let numbers = Rgb::from(buffer.mantissas.each_mut());
    let numbers = numbers.zip(Rgb::from(buffer.exponents.each_mut())).zip(from.value);
    let channels = numbers.try_map(|((mantissas, exponents), from)| {
        let (order, coefficients) = (from.order(), from.coefficients());
        let of_material = mantissas.get_mut(..coefficients.len()).ok_or(Status::Internal)?;
        let of_orders = exponents.get_mut(..=order).ok_or(Status::Internal)?;
        Material::quantize(coefficients, of_material, of_orders)?;
        Ok::<_, Status>(material_in(mantissas, exponents, order))
    })?;
    *to = ColorMaterialQ15 { r: channels.r, g: channels.g, b: channels.b };
    Ok(())
}

pub(crate) fn normalize(vector: &Input<i32>, normal: &Output<Q15>) -> Result<(), Status> {
    // SAFETY: C promises three numbers.
    let vector = unsafe { vector.numbers::<3>() }?;
    disjoint(&[normal.place_of_array(3)?], &[Place::of(vector)])?;
    let [x, y, z] = *vector;
    let found = Normal::new(x, y, z)?;
    // SAFETY: C promises memory for three numbers, which overlaps no other.
    let normal = unsafe { normal.zeroed_array(3) }?;
    normal.iter_mut().zip(found.components()).for_each(|(to, from)| *to = from);
    Ok(())
}
