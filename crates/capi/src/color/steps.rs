//! From light and material to a scene and a pixel, in three channels.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::{Channels, Format, check_size, places, thirds_mut};
use super::picture::{Opened, Picture};
use crate::boundary::{Input, Output, Place, disjoint};
use crate::float;
use crate::status::Status;

/// Writes the transfers of three channels. Those of a gray material are computed once.
fn transfers<F: Format>(
    Channels([r, g, b]): &Channels<F::Material>,
    Channels([to_r, to_g, to_b]): &mut Channels<F::Transfer>,
) -> Result<(), Status> {
    F::transfer(r, to_r)?;
    if F::same(r, g) && F::same(r, b) {
        to_g.clone_from(to_r);
        to_b.clone_from(to_r);
        return Ok(());
    }
    F::transfer(g, to_g)?;
    F::transfer(b, to_b)
}

pub(crate) fn color_transfer<F: Format>(
    material: Input<Channels<F::Material>>,
    transfer: Output<Channels<F::Transfer>>,
) -> Result<(), Status> {
    let material = material.value()?;
    let read = places(material, F::material)?;
    disjoint(&[transfer.place()], read.as_flattened())?;
    // SAFETY: it overlaps no other.
    transfers::<F>(material, unsafe { transfer.zeroed() }?)
}

pub(crate) fn color_relight<F: Format>(
    transfer: Input<Channels<F::Transfer>>,
    light: Input<Channels<F::Light>>,
    scene: Output<Channels<F::Scene>>,
) -> Result<(), Status> {
    let (transfer, light) = (transfer.value()?, light.value()?);
    let read = places(light, F::light)?;
    disjoint(&[scene.place()], &[Place::of(transfer)])?;
    disjoint(&[scene.place()], read.as_flattened())?;
    // SAFETY: it overlaps no other.
    let scene = unsafe { scene.zeroed() }?;
    for ((transfer, light), to) in transfer.0.iter().zip(&light.0).zip(&mut scene.0) {
        F::relight(transfer, light, to)?;
    }
    Ok(())
}

pub(crate) fn color_scene<F: Format>(
    light: Input<Channels<F::Light>>,
    material: Input<Channels<F::Material>>,
    scene: Output<Channels<F::Scene>>,
) -> Result<(), Status> {
    let (light, material) = (light.value()?, material.value()?);
    let of_light = places(light, F::light)?;
    let of_material = places(material, F::material)?;
    disjoint(&[scene.place()], of_light.as_flattened())?;
    disjoint(&[scene.place()], of_material.as_flattened())?;
    // SAFETY: it overlaps no other.
    let scene = unsafe { scene.zeroed() }?;
    let mut transfer = F::NO_TRANSFER;
    let mut before = None;
    for ((material, light), to) in material.0.iter().zip(&light.0).zip(&mut scene.0) {
        // A gray material is transferred once.
        if !before.is_some_and(|before| F::same(before, material)) {
            F::transfer(material, &mut transfer)?;
        }
        before = Some(material);
        F::relight(&transfer, light, to)?;
    }
    Ok(())
}

pub(crate) fn color_shade<F: Format>(
    picture: Input<impl Picture<F>>,
    x: F,
    y: F,
    z: F,
    irradiance: Output<[F::Irradiance; 3]>,
) -> Result<(), Status> {
    let Opened { shade, places, .. } = picture.value()?.open()?;
    disjoint(&[irradiance.place()], &places)?;
    let found = shade(F::normal(x, y, z)?)?;
    // SAFETY: it overlaps no other.
    *unsafe { irradiance.zeroed() }? = found;
    Ok(())
}

/// Turns a light by a function of the format.
fn turned<F: Format, const N: usize>(
    from: &Input<Channels<F::Light>>,
    by: &Input<[F::Angle; N]>,
    numbers: &Output<F::LightBuffer>,
    to: &Output<Channels<F::Light>>,
    turn: impl Fn(&[F::Light; 3], &[F::Angle; N], &mut F::LightBuffer) -> Result<[F::Light; 3], Status>,
) -> Result<(), Status> {
    let (from, by) = (from.value()?, by.value()?);
    let written = [numbers.place(), to.place()];
    let read = places(from, F::light)?;
    disjoint(&written, &[Place::of(by)])?;
    disjoint(&written, read.as_flattened())?;
    // SAFETY: nothing overlaps.
    let (numbers, to) = unsafe { (numbers.zeroed()?, to.zeroed()?) };
    to.0 = turn(&from.0, by, numbers)?;
    Ok(())
}

pub(crate) fn color_turn<F: Format>(
    from: Input<Channels<F::Light>>,
    quaternion: Input<[F::Angle; 4]>,
    numbers: Output<F::LightBuffer>,
    to: Output<Channels<F::Light>>,
) -> Result<(), Status> {
    turned::<F, 4>(&from, &quaternion, &numbers, &to, F::turn)
}

pub(crate) fn color_turn_about_view<F: Format>(
    from: Input<Channels<F::Light>>,
    angle: Input<[F::Angle; 2]>,
    numbers: Output<F::LightBuffer>,
    to: Output<Channels<F::Light>>,
) -> Result<(), Status> {
    turned::<F, 2>(&from, &angle, &numbers, &to, F::turn_about_view)
}

pub(crate) fn color_metallic_roughness<F: Format>(
    base_color: Input<[F; 3]>,
    metallic: F,
    roughness: F,
    numbers: Output<F::MaterialBuffer>,
    to: Output<Channels<F::Material>>,
) -> Result<(), Status> {
    let base_color = base_color.value()?;
    disjoint(&[numbers.place(), to.place()], &[Place::of(base_color)])?;
    // SAFETY: nothing overlaps.
    let (numbers, to) = unsafe { (numbers.zeroed()?, to.zeroed()?) };
    to.0 = F::metallic_roughness(base_color, metallic, roughness, numbers)?;
    Ok(())
}

pub(crate) fn color_bake<F: Format>(
    scene: Input<Channels<float::Scene>>,
    size: usize,
    texels: Output<F::Texel>,
    length: usize,
    map: Output<F::Baked>,
) -> Result<(), Status> {
    let scene = scene.value()?;
    check_size(size, length)?;
    disjoint(&[texels.place_of_array(length)?, map.place()], &[Place::of(scene)])?;
    // SAFETY: C promises memory for `length` texels; nothing overlaps.
    let (numbers, map) = unsafe { (texels.zeroed_array(length)?, map.zeroed()?) };
    let exponents = F::bake(&scene.0, size, thirds_mut(numbers)?)?;
    *map = F::baked(size, texels.to_input(), length, exponents);
    Ok(())
}
