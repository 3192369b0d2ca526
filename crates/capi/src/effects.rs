//! Lights and materials of one effect.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, disjoint};
use crate::format::Format;
use crate::status::Status;
use crate::steps::modified;

/// A part of a picture: the picture of a masked light on a material masked for the same effect. The
/// pictures of all four sum to the whole.
#[derive(Clone, Copy)]
#[repr(i32)]
pub enum Effect {
    /// l = 0: light that is the same from everywhere.
    Ambient = 0,
    /// l >= 1, o = 0: the light's directions on a Lambertian material.
    Diffuse = 1,
    /// l >= 1, 1 <= o <= 3: rough, backscattering and rim lobes.
    Broad = 2,
    /// l >= 1, o >= 4: highlights.
    Gloss = 3,
}

/// The effect of this number in C.
fn effect(number: i32) -> Result<eigenshade::Effect, Status> {
    let effects = [
        (Effect::Ambient, eigenshade::Effect::Ambient),
        (Effect::Diffuse, eigenshade::Effect::Diffuse),
        (Effect::Broad, eigenshade::Effect::Broad),
        (Effect::Gloss, eigenshade::Effect::Gloss),
    ];
    let found = effects.into_iter().find(|&(of_c, _)| of_c as i32 == number);
    found.map(|(_, effect)| effect).ok_or(Status::Effect)
}

pub(crate) fn mask_light<F: Format>(
    from: &Input<F::Light>,
    number: i32,
    buffer: &Output<F::LightBuffer>,
    to: &Output<F::Light>,
) -> Result<(), Status> {
    let effect = effect(number)?;
    modified::<F>(from, Place::default(), buffer, to, |from, buffer| {
        Ok(F::mask_light(from, effect, buffer))
    })
}

pub(crate) fn mask_material<F: Format>(
    from: &Input<F::Material>,
    number: i32,
    buffer: &Output<F::MaterialBuffer>,
    to: &Output<F::Material>,
) -> Result<(), Status> {
    let effect = effect(number)?;
    let from = F::material(from.value()?)?;
    disjoint(&[buffer.place(), to.place()], &from.places)?;
    // SAFETY: nothing overlaps.
    let (buffer, to) = unsafe { (buffer.zeroed()?, to.zeroed()?) };
    *to = F::mask_material(from.value, effect, buffer);
    Ok(())
}
