//! The screen errors that sources leave: pictures of metals and dielectrics against direct integration
//! of the whole map.

use crate::sources::response::{Glossy, Place, Response};
use crate::sources::screen::{self, Reference};
use crate::sources::sphere::{Picture, Sphere};
use crate::sources::view::View;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::error::Result;
use eigenshade_model::highlights::{self, Highlights};
use eigenshade_model::parallel;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::source::{Base, Gloss, SetError, SourceSets};
use eigenshade_model::window::Window;
use eigenshade_table::light;
use std::convert::Infallible;

/// The degrees and orders.
const SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];

/// The light as it is, and after a rotation that no source is fitted to or chosen by.
const VIEWS: [Option<Rotation>; 2] = [None, Some(Rotation { alpha: 0.6, beta: 1.3, gamma: -2.2 })];

/// Spacing of the normals in radians.
const SPACING: f64 = 0.09;

/// The materials of a kind with these roughnesses; those whose pictures are compared are of
/// [`ROUGHNESS`](eigenshade_table::highlights::ROUGHNESS).
///
/// # Errors
///
/// Those of [`Glossy::new`].
pub fn materials(base: Base, roughness: &[f64]) -> Result<Vec<Glossy>> {
    let [reflectance, albedo] = match base {
        Base::Metal => [1.0, 0.0],
        Base::Dielectric => [0.04, 0.5],
    };
    let of = |&roughness: &f64| Glossy::new([roughness, reflectance, albedo], &SIZES);
    roughness.iter().map(of).collect()
}

/// The errors of the pictures of these materials of each base under a map, without sources and with
/// each set: the larger of two views.
///
/// # Errors
///
/// Those of [`View::new`].
pub fn errors(
    map: &EnvironmentMap,
    sets: &SourceSets,
    materials: &[(Base, Vec<Glossy>)],
) -> Result<Vec<SetError>> {
    let degree = SIZES.iter().map(|size| size.0).max().unwrap_or(0);
    let mut found: Vec<SetError> = Vec::new();
    for size in SIZES {
        for most in std::iter::once(0).chain(sets.sets.iter().map(|(most, _)| *most)) {
            found.extend(materials.iter().map(|(base, _)| SetError {
                light: sets.name.clone(),
                most,
                size,
                base: *base,
                errors: [ScreenError::default(); 6],
            }));
        }
    }
    for rotation in VIEWS {
        let view = View::new(map, rotation, degree)?;
        let sphere = view.sphere(SPACING);
        for (base, materials) in materials {
            for (place, material) in materials.iter().enumerate() {
                let reference = view.pictures(material, &sphere.normals).reference;
                let reference = Reference::new(reference, &sphere);
                for one in found.iter_mut().filter(|one| one.base == *base) {
                    let size = SIZES.iter().position(|size| *size == one.size);
                    let Some(response) = size.and_then(|size| material.responses.get(size)) else {
                        continue;
                    };
                    let responses = [response; 3];
                    let picture =
                        picture(&view, responses, &material.gloss, sets, one.most, &sphere);
                    let errors = &mut one.errors[place];
                    *errors = errors.max(reference.errors(&picture, &sphere).all);
                }
            }
        }
    }
    Ok(found)
}

/// The picture of a material by harmonics and at most this many sources, both in f64, with the
/// window that `eigenshade render` chooses.
#[must_use]
pub fn picture(
    view: &View,
    responses: [&Response; 3],
    gloss: &Gloss,
    sets: &SourceSets,
    most: usize,
    sphere: &Sphere,
) -> Picture {
    let degree = responses[0].degree();
    let mut rest = view.light().each_ref().map(|light| light[..light::count(degree)].to_vec());
    let turned = sets.of_most(most).iter().map(|source| view.turned(source)).collect::<Vec<_>>();
    highlights::take_out(&mut rest, degree, &turned);
    let lobes = Highlights::new(gloss, &turned);
    let at = |k: usize| {
        let normal = sphere.normals[k];
        (Place::new(normal, degree), lobes.irradiance(normal))
    };
    let places = parallel::map(sphere.normals.len(), &(), at);
    let Ok(drawn) = screen::windowed(degree, sphere, |window: Window| {
        let images = [0, 1, 2].map(|c: usize| {
            let mut rest = rest[c].clone();
            window.apply(&mut rest);
            responses[c].under(&rest)
        });
        let channel = |c: usize| {
            let pixel = |(at, lit): &(Place, [f64; 3])| images[c].irradiance(at) + lit[c];
            places.iter().map(pixel).collect()
        };
        Ok::<Picture, Infallible>([channel(0), channel(1), channel(2)])
    });
    drawn
}
