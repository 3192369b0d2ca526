//! Pictures: begun once from light, material and sources, then shaded.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Place, disjoint};
use crate::constants::SOURCES;
use crate::format::Format;
use crate::packed_object::{self, PackedObject};
use crate::records_f32::PictureF32;
use crate::records_q15::PictureQ15;
use crate::sources::{Gloss, Source, with_sources};
use crate::status::Status;
use eigenshade::{Error, Highlights, Q15, Rgb};

/// The contents of a picture's memory. The mark comes first, where every format looks for it.
#[repr(C)]
pub(crate) struct Picture<F: Format> {
    state: Mark,
    scene: F::Scene,
    highlights: Option<Highlighted<F>>,
}

/// Adds highlights to the irradiance of a scene.
type Add<F> = fn(
    &<F as Format>::Highlights,
    Rgb<<F as Format>::Channel>,
    <F as Format>::Normal,
) -> Rgb<<F as Format>::Channel>;

/// Highlights, and how they are added: a program that gives its pictures none does not link it.
struct Highlighted<F: Format> {
    add: Add<F>,
    highlights: F::Highlights,
}

// It fits into the memory of C.
const _: () = assert!(size_of::<Picture<f32>>() <= size_of::<PictureF32>());
const _: () = assert!(align_of::<Picture<f32>>() <= align_of::<PictureF32>());
const _: () = assert!(size_of::<Picture<Q15>>() <= size_of::<PictureQ15>());
const _: () = assert!(align_of::<Picture<Q15>>() <= align_of::<PictureQ15>());

/// A picture, or baked maps, once they are checked.
pub(crate) struct Opened<S> {
    pub(crate) shade: S,
    /// The exponents of the channels, 0 in `f32`.
    pub(crate) exponents: [i32; 3],
    pub(crate) places: [Place; 2],
}

/// The irradiance of a normal in each channel.
pub(crate) trait Shade<F: Format>: Fn(F::Normal) -> Rgb<F::Channel> {}
impl<F: Format, S: Fn(F::Normal) -> Rgb<F::Channel>> Shade<F> for S {}

/// The irradiances of a normal and its mirror images in each channel.
pub(crate) trait ShadeMirrored<F: Format>: Fn(F::Normal) -> [Rgb<F::Channel>; 4] {}
impl<F: Format, S: Fn(F::Normal) -> [Rgb<F::Channel>; 4]> ShadeMirrored<F> for S {}

/// The picture in this memory, unless it was never begun.
fn begun<F: Format>(memory: &Input<F::PictureBuffer>) -> Result<&Picture<F>, Status> {
    let picture = core::ptr::from_ref(memory.value()?).cast::<Picture<F>>();
    // SAFETY: it lies in the memory of C, and any bytes are a mark.
    if unsafe { (&raw const (*picture).state).read() } != Mark::COMPUTED {
        return Err(Status::Picture);
    }
    // SAFETY: as above, and this library wrote it.
    Ok(unsafe { &*picture })
}

/// Writes a picture without highlights. It is marked once its scene is written.
///
/// # Safety
///
/// The memory overlaps nothing that is in use.
unsafe fn written<'a, F: Format>(
    memory: &Output<F::PictureBuffer>,
    scene: impl FnOnce(&mut F::Scene) -> Result<(), Status>,
) -> Result<&'a mut Picture<F>, Status> {
    // SAFETY: this function's caller promises as much.
    let picture = core::ptr::from_mut(unsafe { memory.zeroed() }?).cast::<Picture<F>>();
    // SAFETY: it lies in the memory of C; zeros are a mark and a scene.
    let picture = unsafe {
        (&raw mut (*picture).highlights).write(None);
        &mut *picture
    };
    scene(&mut picture.scene)?;
    picture.state = Mark::COMPUTED;
    Ok(picture)
}

/// Gives each picture its highlights of sources.
// Not inlined, so that its memory is free again when the rest runs.
#[inline(never)]
fn add_highlights<F: Format, const N: usize>(
    mut pictures: [&mut Picture<F>; N],
    sources: &[Source],
    highlights: impl FnOnce(&[eigenshade::Source]) -> Result<[Highlights<SOURCES>; N], Error>,
) -> Result<(), Status> {
    pictures.iter_mut().for_each(|picture| picture.highlights = None);
    if sources.is_empty() {
        return Ok(());
    }
    let found = with_sources(sources, |all| Ok(highlights(all)?))?;
    for (picture, found) in pictures.into_iter().zip(&found) {
        let highlights = F::highlights(found, &picture.scene)?;
        picture.highlights = Some(Highlighted { add: F::add, highlights });
    }
    Ok(())
}

/// A picture that was begun, to be changed.
///
/// # Safety
///
/// The memory overlaps nothing that is in use.
unsafe fn begun_mut<'a, F: Format>(
    memory: &Output<F::PictureBuffer>,
) -> Result<&'a mut Picture<F>, Status> {
    // SAFETY: this function's caller promises as much.
    let [memory] = unsafe { memory.array(1) }? else { return Err(Status::Internal) };
    begun::<F>(&Input(memory))?;
    // SAFETY: it was begun, so this library wrote it.
    Ok(unsafe { &mut *core::ptr::from_mut(memory).cast::<Picture<F>>() })
}

/// A light without sources. It points to `buffer`.
// As above.
#[inline(never)]
fn rest<F: Format>(
    light: Rgb<F::OfLight<'_>>,
    sources: &[Source],
    buffer: &mut F::LightBuffer,
) -> Result<F::Light, Status> {
    with_sources(sources, |sources| F::residual(light, sources, buffer))
}

/// The scene of a light.
// As above.
#[inline(never)]
fn scene<F: Format>(
    light: Rgb<F::OfLight<'_>>,
    material: Rgb<F::OfMaterial<'_>>,
    to: &mut F::Scene,
) -> Result<(), Status> {
    F::scene(light, material, to)
}

pub(crate) fn begin<F: Format>(
    light: &Input<F::Light>,
    material: &Input<F::Material>,
    picture: &Output<F::PictureBuffer>,
) -> Result<(), Status> {
    let (light, material) = (F::light(light.value()?)?, F::material(material.value()?)?);
    F::check(light.value)?;
    disjoint(&[picture.place()], &light.places)?;
    disjoint(&[picture.place()], &material.places)?;
    // SAFETY: it overlaps no other.
    unsafe { written::<F>(picture, |to| scene::<F>(light.value, material.value, to)) }?;
    Ok(())
}

pub(crate) fn begin_glossy<F: Format>(
    light: &Input<F::Light>,
    material: &Input<F::Material>,
    gloss: &Input<Gloss>,
    sources: &Input<Source>,
    count: usize,
    picture: &Output<F::PictureBuffer>,
) -> Result<(), Status> {
    let (light, material) = (F::light(light.value()?)?, F::material(material.value()?)?);
    F::check(light.value)?;
    let gloss = gloss.value()?;
    // SAFETY: C promises `count` sources.
    let sources = unsafe { sources.array(count) }?;
    let place = [picture.place()];
    disjoint(&place, &light.places)?;
    disjoint(&place, &material.places)?;
    disjoint(&place, &[Place::of(gloss), Place::of(sources)])?;
    let gloss = gloss.view()?;
    let mut buffer = F::LIGHT_BUFFER;
    let rest = rest::<F>(light.value, sources, &mut buffer)?;
    let rest = F::light(&rest)?.value;
    // SAFETY: it overlaps no other.
    let picture = unsafe { written::<F>(picture, |to| scene::<F>(rest, material.value, to)) }?;
    add_highlights([picture], sources, |all| Ok([Highlights::new(&gloss, all)?]))
}

pub(crate) fn relight<F: Format>(
    transfer: &Input<F::Transfer>,
    light: &Input<F::Light>,
    picture: &Output<F::PictureBuffer>,
) -> Result<(), Status> {
    let (transfer, light) = (transfer.value()?, F::light(light.value()?)?);
    F::check(light.value)?;
    disjoint(&[picture.place()], &[Place::of(transfer)])?;
    disjoint(&[picture.place()], &light.places)?;
    // SAFETY: it overlaps no other.
    unsafe { written::<F>(picture, |to| F::relight(transfer, light.value, to)) }?;
    Ok(())
}

pub(crate) fn highlights<F: Format>(
    gloss: &Input<Gloss>,
    sources: &Input<Source>,
    count: usize,
    picture: &Output<F::PictureBuffer>,
) -> Result<(), Status> {
    begun::<F>(&Input(picture.0))?;
    let gloss = gloss.value()?;
    // SAFETY: C promises `count` sources.
    let sources = unsafe { sources.array(count) }?;
    disjoint(&[picture.place()], &[Place::of(gloss), Place::of(sources)])?;
    let gloss = gloss.view()?;
    // SAFETY: it overlaps no other.
    let picture = unsafe { begun_mut::<F>(picture) }?;
    add_highlights([picture], sources, |all| Ok([Highlights::new(&gloss, all)?]))
}

pub(crate) fn region_highlights<F: Format>(
    object: &Input<PackedObject>,
    region: usize,
    sources: &Input<Source>,
    count: usize,
    tinted: &Output<F::PictureBuffer>,
    plain: &Output<F::PictureBuffer>,
) -> Result<(), Status> {
    begun::<F>(&Input(tinted.0))?;
    begun::<F>(&Input(plain.0))?;
    let object = packed_object::open(object, packed_object::NO_ROWS)?;
    let region = object.region(region)?;
    // SAFETY: C promises `count` sources.
    let sources = unsafe { sources.array(count) }?;
    let written = [tinted.place(), plain.place()];
    disjoint(&written, &object.places)?;
    disjoint(&written, &[Place::of(sources)])?;
    // SAFETY: nothing overlaps.
    let pictures = unsafe { [begun_mut::<F>(tinted)?, begun_mut::<F>(plain)?] };
    add_highlights(pictures, sources, |all| region.highlights(all))
}

pub(crate) fn open<F: Format>(
    picture: &Input<F::PictureBuffer>,
) -> Result<Opened<impl Shade<F>>, Status> {
    let Picture { scene, highlights, .. } = begun::<F>(picture)?;
    let shade = move |normal| {
        let irradiance = F::shade(scene, normal);
        match highlights {
            Some(Highlighted { add, highlights }) => add(highlights, irradiance, normal),
            None => irradiance,
        }
    };
    let places = [Place::of(picture.value()?), Place::default()];
    Ok(Opened { shade, exponents: F::exponents(scene), places })
}

/// The picture in this memory, which shades a normal and its mirror images together.
pub(crate) fn open_mirrored<F: Format>(
    picture: &Input<F::PictureBuffer>,
) -> Result<Opened<impl ShadeMirrored<F>>, Status> {
    let Picture { scene, highlights, .. } = begun::<F>(picture)?;
    let shade = move |normal| {
        let mut irradiances = F::shade_mirrored(scene, normal);
        if let Some(Highlighted { add, highlights }) = highlights {
            for (irradiance, image) in irradiances.iter_mut().zip(F::mirrored(normal)) {
                *irradiance = add(highlights, *irradiance, image);
            }
        }
        irradiances
    };
    let places = [Place::of(picture.value()?), Place::default()];
    Ok(Opened { shade, exponents: F::exponents(scene), places })
}

/// The scene of a picture without highlights, which are too sharp for baked maps.
pub(crate) fn matte_scene(picture: &Input<PictureF32>) -> Result<&<f32 as Format>::Scene, Status> {
    let Picture { scene, highlights, .. } = begun::<f32>(picture)?;
    if highlights.is_some() { Err(Status::Highlights) } else { Ok(scene) }
}

pub(crate) fn shade<F: Format>(
    picture: Opened<impl Shade<F>>,
    x: F,
    y: F,
    z: F,
    irradiance: &Output<F::Irradiance>,
) -> Result<(), Status> {
    let Opened { shade, exponents, places } = picture;
    disjoint(&[irradiance.place()], &places)?;
    let found = shade(F::normal(x, y, z)?);
    // SAFETY: it overlaps no other.
    *unsafe { irradiance.zeroed() }? = F::irradiance(found, exponents);
    Ok(())
}
