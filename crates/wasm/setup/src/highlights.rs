//! Small sources of a light: taken out of it, and as highlights. Every function returns 0 if its
//! input is invalid.

use crate::inputs::{LIGHT, TURN};
use crate::shared::{LIGHT_COUNT, Shared};
use eigenshade::{Error, Gloss, Highlights, Light, Rgb, Rotation, Source};
use eigenshade_table::highlights::MAX_SOURCES;

/// Constants for a page: the most sources, the reflectance of dielectrics, and the roughness
/// from which on sources change nothing.
#[unsafe(export_name = "limits")]
static LIMITS: [f32; 3] = [MAX_SOURCES as f32, Gloss::DIELECTRIC, Gloss::MATTE];
/// The sources, each with its direction, energy and spread.
#[unsafe(export_name = "sources")]
static SOURCES: Shared<[[f32; 7]; MAX_SOURCES]> = Shared::new([[0.0; 7]; MAX_SOURCES]);
/// The gloss of the material: roughness, reflectance at normal and at grazing incidence, albedo.
#[unsafe(export_name = "gloss")]
static GLOSS: Shared<[f32; 10]> = Shared::new([0.0; 10]);

/// The highlights of the last `highlights`; none if it failed.
pub static HIGHLIGHTS: Shared<Option<Highlights<MAX_SOURCES>>> = Shared::new(None);

/// Takes the first `count` sources out of the light of the next `relight`.
#[unsafe(no_mangle)]
extern "C" fn residual(count: usize) -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (light, sources) = unsafe { (LIGHT.borrow(), SOURCES.borrow()) };
    let mut taken_out = |numbers| {
        let [r, g, b] = &*light;
        let lights = Rgb::new(r, g, b).try_map(|numbers| Light::from_finite(&numbers[..]))?;
        let rest = lights.residual::<LIGHT_COUNT>(&[source(numbers)?])?;
        for (to, from) in light.iter_mut().zip(<[_; 3]>::from(rest)) {
            to.iter_mut().zip(&*from).for_each(|(to, &from)| *to = from);
        }
        Ok::<_, Error>(())
    };
    let taken = sources.get(..count);
    taken.is_some_and(|all| all.iter().all(|source| taken_out(source).is_ok())).into()
}

/// The highlights of the first `count` sources, turned like the light, on the gloss.
#[unsafe(no_mangle)]
extern "C" fn highlights(count: usize) -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (sources, turn, gloss, highlights) =
        unsafe { (SOURCES.borrow(), TURN.borrow(), GLOSS.borrow(), HIGHLIGHTS.borrow()) };
    let [roughness, f0_r, f0_g, f0_b, f90_r, f90_g, f90_b, r, g, b] = *gloss;
    let shaded = || {
        let gloss = Gloss::new(roughness, [f0_r, f0_g, f0_b], [r, g, b])?;
        let gloss = gloss.with_grazing([f90_r, f90_g, f90_b])?;
        let rotation = Rotation::from_quaternion(*turn)?;
        let from = sources.get(..count).unwrap_or_default();
        let mut turned = [source(&NONE)?; MAX_SOURCES];
        let turned = turned.get_mut(..count).unwrap_or_default();
        for (to, from) in turned.iter_mut().zip(from) {
            *to = source(from)?.turned(rotation);
        }
        Highlights::new(&gloss, turned)
    };
    *highlights = shaded().ok();
    highlights.is_some().into()
}

/// A dark source.
const NONE: [f32; 7] = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];

fn source(&[x, y, z, r, g, b, spread]: &[f32; 7]) -> Result<Source, Error> {
    Source::new([x, y, z], [r, g, b], spread)
}
