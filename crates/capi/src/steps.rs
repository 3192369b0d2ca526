//! Lights and materials in three channels: turned, without sources, from parameters, transferred.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, disjoint};
use crate::format::Format;
use crate::sources::{Source, with_sources};
use crate::status::Status;
use eigenshade::Rgb;

pub(crate) fn transfer<F: Format>(
    material: &Input<F::Material>,
    transfer: &Output<F::Transfer>,
) -> Result<(), Status> {
    let material = F::material(material.value()?)?;
    disjoint(&[transfer.place()], &material.places)?;
    // SAFETY: it overlaps no other.
    F::transfer(material.value, unsafe { transfer.zeroed() }?)
}

/// Modifies a light by a function of the format.
pub(crate) fn modified<F: Format>(
    from: &Input<F::Light>,
    by: Place,
    buffer: &Output<F::LightBuffer>,
    to: &Output<F::Light>,
    modify: impl FnOnce(Rgb<F::OfLight<'_>>, &mut F::LightBuffer) -> Result<F::Light, Status>,
) -> Result<(), Status> {
    let from = F::light(from.value()?)?;
    let written = [buffer.place(), to.place()];
    disjoint(&written, &from.places)?;
    disjoint(&written, &[by])?;
    // SAFETY: nothing overlaps.
    let (buffer, to) = unsafe { (buffer.zeroed()?, to.zeroed()?) };
    *to = modify(from.value, buffer)?;
    Ok(())
}

pub(crate) fn turn<F: Format>(
    from: &Input<F::Light>,
    quaternion: &Input<F::Angle>,
    buffer: &Output<F::LightBuffer>,
    to: &Output<F::Light>,
) -> Result<(), Status> {
    // SAFETY: C promises four numbers.
    let by = unsafe { quaternion.numbers::<4>() }?;
    modified::<F>(from, Place::of(by), buffer, to, |from, buffer| F::turn(from, by, buffer))
}

pub(crate) fn turn_about_view<F: Format>(
    from: &Input<F::Light>,
    angle: &Input<F::Angle>,
    buffer: &Output<F::LightBuffer>,
    to: &Output<F::Light>,
) -> Result<(), Status> {
    // SAFETY: C promises two numbers.
    let by = unsafe { angle.numbers::<2>() }?;
    modified::<F>(from, Place::of(by), buffer, to, |from, buffer| {
        F::turn_about_view(from, by, buffer)
    })
}

pub(crate) fn residual<F: Format>(
    from: &Input<F::Light>,
    sources: &Input<Source>,
    count: usize,
    buffer: &Output<F::LightBuffer>,
    to: &Output<F::Light>,
) -> Result<(), Status> {
    // SAFETY: C promises `count` sources.
    let sources = unsafe { sources.array(count) }?;
    modified::<F>(from, Place::of(sources), buffer, to, |from, buffer| {
        with_sources(sources, |sources| F::residual(from, sources, buffer))
    })
}

pub(crate) fn metallic_roughness<F: Format>(
    base_color: &Input<F>,
    metallic: F,
    roughness: F,
    buffer: &Output<F::MaterialBuffer>,
    to: &Output<F::Material>,
) -> Result<(), Status> {
    // SAFETY: C promises three numbers.
    let base_color = unsafe { base_color.numbers::<3>() }?;
    disjoint(&[buffer.place(), to.place()], &[Place::of(base_color)])?;
    // SAFETY: nothing overlaps.
    let (buffer, to) = unsafe { (buffer.zeroed()?, to.zeroed()?) };
    *to = F::metallic_roughness(base_color, metallic, roughness, buffer)?;
    Ok(())
}
