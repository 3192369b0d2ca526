//! Small sources of light and their sharp highlights.
#![expect(unsafe_code, reason = "memory of C")]

use super::format::{Channels, Format, places};
use super::picture::{Opened, Picture, Shade};
use crate::boundary::{Input, Output, Place, Plain, disjoint};
use crate::export::{export, records};
use crate::status::Status;
use crate::{float, integers};
pub(crate) use eigenshade::index::highlights::SHIPPED_SOURCES as SOURCES;
use eigenshade::{Highlights, Q15, Rotation};

records! {
    Source = "source" f32:
        direction: [f32; 3], energy: [f32; 3], spread: f32;
    Gloss = "gloss" f32:
        roughness: f32, reflectance: [f32; 3], grazing: [f32; 3], albedo: [f32; 3];
    GlossyF32 = "color_glossy" f32:
        scene: Input<Channels<float::Scene>>, gloss: Input<Gloss>,
        sources: Input<Source>, count: usize;
    GlossyQ15 = "color_glossy" Q15:
        scene: Input<Channels<integers::Scene>>, gloss: Input<Gloss>,
        sources: Input<Source>, count: usize;
}

impl Source {
    /// The source, for the runtime.
    fn view(&self) -> Result<eigenshade::Source, Status> {
        let Self { direction, energy, spread } = *self;
        Ok(eigenshade::Source::new(direction, energy, spread)?)
    }
}

impl Gloss {
    /// The gloss, for the runtime.
    fn view(&self) -> Result<eigenshade::Gloss, Status> {
        let gloss = eigenshade::Gloss::new(self.roughness, self.reflectance, self.albedo)?;
        Ok(gloss.with_grazing(self.grazing)?)
    }
}

/// Calls a function with the sources, once they are checked.
fn with_sources<T>(
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

pub(crate) fn color_residual<F: Format>(
    from: Input<Channels<float::Light>>,
    sources: Input<Source>,
    count: usize,
    buffer: Output<F::LightBuffer>,
    to: Output<Channels<F::Light>>,
) -> Result<(), Status> {
    let from = from.value()?;
    // SAFETY: C promises `count` sources.
    let sources = unsafe { sources.array(count) }?;
    let written = [buffer.place(), to.place()];
    disjoint(&written, places(from, <f32 as Format>::light)?.as_flattened())?;
    disjoint(&written, &[Place::of(sources)])?;
    // SAFETY: nothing overlaps.
    let (numbers, to) = unsafe { (buffer.zeroed()?, to.zeroed()?) };
    to.0 = with_sources(sources, |sources| F::residual(&from.0, sources, numbers))?;
    Ok(())
}

fn source_turn(
    from: Input<Source>,
    quaternion: Input<[f32; 4]>,
    to: Output<Source>,
) -> Result<(), Status> {
    let (from, quaternion) = (from.value()?, quaternion.value()?);
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

fn gloss_metallic_roughness(
    base_color: Input<[f32; 3]>,
    metallic: f32,
    roughness: f32,
    gloss: Output<Gloss>,
) -> Result<(), Status> {
    let base_color = base_color.value()?;
    disjoint(&[gloss.place()], &[Place::of(base_color)])?;
    let found = eigenshade::Gloss::metallic_roughness(*base_color, metallic, roughness)?;
    let [reflectance, grazing] = [found.reflectance(), found.grazing()].map(Into::into);
    // SAFETY: nothing overlaps.
    *unsafe { gloss.zeroed() }? =
        Gloss { roughness, reflectance, grazing, albedo: found.albedo().into() };
    Ok(())
}

fn gloss_fewest_sources(
    gloss: Input<Gloss>,
    errors: Input<[f32; 6]>,
    length: usize,
    tolerance: f32,
    count: Output<usize>,
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

impl<S> Opened<S> {
    /// The same picture with the highlights of sources.
    fn glossy<F: Format>(
        self,
        of: Place,
        gloss: &Input<Gloss>,
        sources: &Input<Source>,
        count: usize,
    ) -> Result<Opened<impl Shade<F>>, Status>
    where
        S: Shade<F>,
    {
        let gloss = gloss.value()?;
        // SAFETY: C promises `count` sources.
        let sources = unsafe { sources.array(count) }?;
        let Self { shade, exponents, places: [of_scene, ..] } = self;
        let of_gloss = gloss.view()?;
        let highlights = with_sources(sources, |sources| {
            let found = Highlights::<SOURCES>::new(&of_gloss, sources)?;
            F::highlights(found, exponents)
        })?;
        let shade = move |normal| Ok(F::add(&highlights, shade(normal)?, normal));
        let places = [of, of_scene, Place::of(gloss), Place::of(sources)];
        Ok(Opened { shade, exponents, places })
    }
}

impl Picture<f32> for GlossyF32 {
    fn open(&self) -> Result<Opened<impl Shade<f32>>, Status> {
        let scene = Picture::<f32>::open(self.scene.value()?)?;
        scene.glossy(Place::of(self), &self.gloss, &self.sources, self.count)
    }
}

impl Picture<Q15> for GlossyQ15 {
    fn open(&self) -> Result<Opened<impl Shade<Q15>>, Status> {
        let scene = Picture::<Q15>::open(self.scene.value()?)?;
        scene.glossy(Place::of(self), &self.gloss, &self.sources, self.count)
    }
}

export! { functions "f32"
    source_turn(from: Input<Source>, quaternion: Input<[f32; 4]>, to: Output<Source>)
    gloss_metallic_roughness(
        base_color: Input<[f32; 3]>, metallic: f32, roughness: f32, gloss: Output<Gloss>
    )
    gloss_fewest_sources(
        gloss: Input<Gloss>, errors: Input<[f32; 6]>, length: usize, tolerance: f32,
        count: Output<usize>
    )
}
