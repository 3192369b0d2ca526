//! Small sources of light, and the gloss of a material.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::constants::SOURCES;
use crate::status::Status;
use eigenshade::Rotation;

/// A small bright source of light, as `eigenshade light --sources` writes it. May be kept in flash.
#[repr(C)]
pub struct Source {
    /// A unit vector from the object to the light, in the camera's frame.
    pub direction: [f32; 3],
    /// The integral of radiance over solid angle: red, green and blue, at least 0.
    pub energy: [f32; 3],
    /// The standard deviation of the round blob in radians, from 0 to 0.5.
    pub spread: f32,
}

/// A GGX lobe over a matte base; all numbers are from 0 to 1. May be kept in flash.
#[repr(C)]
pub struct Gloss {
    /// The roughness; below 0.065 it counts as 0.065.
    pub roughness: f32,
    /// The reflectance at normal incidence: the base color of a metal, 0.04 of other materials.
    pub reflectance: [f32; 3],
    /// The reflectance at grazing incidence, usually 1.
    pub grazing: [f32; 3],
    /// The color of the matte base: 0 of a metal.
    pub albedo: [f32; 3],
}

// SAFETY: consists of numbers.
unsafe impl Plain for Source {}
// SAFETY: as above.
unsafe impl Plain for Gloss {}

impl Source {
    /// The source, for the runtime.
    fn view(&self) -> Result<eigenshade::Source, Status> {
        let Self { direction, energy, spread } = *self;
        Ok(eigenshade::Source::new(direction, energy, spread)?)
    }
}

impl Gloss {
    /// The gloss, for the runtime.
    pub(crate) fn view(&self) -> Result<eigenshade::Gloss, Status> {
        let gloss = eigenshade::Gloss::new(self.roughness, self.reflectance, self.albedo)?;
        Ok(gloss.with_grazing(self.grazing)?)
    }
}

/// Calls a function with the sources, once they are checked.
pub(crate) fn with_sources<T>(
    sources: &[Source],
    run: impl FnOnce(&[eigenshade::Source]) -> Result<T, Status>,
) -> Result<T, Status> {
    let Some((first, _)) = sources.split_first() else { return run(&[]) };
    let mut views = [first.view()?; SOURCES];
    let views = views.get_mut(..sources.len()).ok_or(Status::Source)?;
    for (to, from) in views.iter_mut().zip(sources) {
        *to = from.view()?;
    }
    run(views)
}

pub(crate) fn source_turn(
    from: &Input<Source>,
    quaternion: &Input<f32>,
    to: &Output<Source>,
) -> Result<(), Status> {
    // SAFETY: C promises four numbers.
    let (from, quaternion) = (from.value()?, unsafe { quaternion.numbers::<4>() }?);
    disjoint(&[to.place()], &[Place::of(from), Place::of(quaternion)])?;
    let turned = from.view()?.turned(Rotation::from_quaternion(*quaternion)?);
    // SAFETY: nothing overlaps.
    *unsafe { to.zeroed() }? = Source {
        direction: turned.direction(),
        energy: turned.energy().into(),
        spread: turned.spread(),
    };
    Ok(())
}

pub(crate) fn gloss_metallic_roughness(
    base_color: &Input<f32>,
    metallic: f32,
    roughness: f32,
    gloss: &Output<Gloss>,
) -> Result<(), Status> {
    // SAFETY: C promises three numbers.
    let base_color = unsafe { base_color.numbers::<3>() }?;
    disjoint(&[gloss.place()], &[Place::of(base_color)])?;
    let found = eigenshade::Gloss::metallic_roughness(*base_color, metallic, roughness)?;
    let [reflectance, grazing] = [found.reflectance(), found.grazing()].map(Into::into);
    // SAFETY: nothing overlaps.
    *unsafe { gloss.zeroed() }? =
        Gloss { roughness, reflectance, grazing, albedo: found.albedo().into() };
    Ok(())
}

pub(crate) fn gloss_fewest_sources(
    gloss: &Input<Gloss>,
    errors: &Input<[f32; 6]>,
    length: usize,
    tolerance: f32,
    count: &Output<usize>,
) -> Result<(), Status> {
    let gloss = gloss.value()?;
    // SAFETY: C promises `length` rows.
    let errors = unsafe { errors.array(length) }?;
    disjoint(&[count.place()], &[Place::of(gloss), Place::of(errors)])?;
    let fewest = gloss.view()?.fewest_sources(errors, tolerance).unwrap_or(length);
    // SAFETY: nothing overlaps.
    *unsafe { count.zeroed() }? = fewest;
    Ok(())
}
