//! The screen errors with sources: pictures of metals and dielectrics against direct integration
//! of the whole map.

use crate::sources::response::Glossy;
use crate::sources::screen::{self, Reference};
use crate::sources::sphere::{Picture, Sphere};
use crate::sources::view::View;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::error::Result;
use eigenshade_model::highlights::{self, Highlights};
use eigenshade_model::rotation::Rotation;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::source::{Base, Gloss, Source, SourceError};
use eigenshade_model::window::Window;
use eigenshade_table::light;
use std::convert::Infallible;

/// The degrees and orders.
const SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];

/// The light as it is, and after a rotation that no source is fitted to or chosen by.
const VIEWS: [Option<Rotation>; 2] = [None, Some(Rotation { alpha: 0.6, beta: 1.3, gamma: -2.2 })];

/// Spacing of the normals in radians.
const SPACING: f64 = 0.09;

/// The materials of a kind with these roughnesses; materials whose pictures are compared are of
/// [`ROUGHNESS`](eigenshade_table::highlights::ROUGHNESS).
///
/// # Errors
///
/// As [`Glossy::new`].
pub fn materials(base: Base, roughness: &[f64]) -> Result<Vec<Glossy>> {
    let [reflectance, albedo] = match base {
        Base::Metal => [1.0, 0.0],
        Base::Dielectric => [0.04, 0.5],
    };
    let of = |&roughness: &f64| Glossy::new([roughness, reflectance, albedo], &SIZES);
    roughness.iter().map(of).collect()
}

/// The errors of the pictures of these materials of each base under a map, without sources, with the
/// first one, with the first two and so on: the larger of two views.
///
/// # Errors
///
/// As [`View::new`].
pub fn errors(
    map: &EnvironmentMap,
    name: &str,
    sources: &[Source],
    materials: &[(Base, Vec<Glossy>)],
) -> Result<Vec<SourceError>> {
    let degree = SIZES.iter().map(|size| size.0).max().unwrap_or(0);
    let mut found: Vec<SourceError> = Vec::new();
    for size in SIZES {
        for count in 0..=sources.len() {
            found.extend(materials.iter().map(|(base, _)| SourceError {
                light: name.to_owned(),
                sources: count,
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
                for (size, response) in SIZES.iter().zip(&material.responses) {
                    let rows = response.at_all(&sphere.normals);
                    let fits = |one: &&mut SourceError| (one.base, one.size) == (*base, *size);
                    for one in found.iter_mut().filter(fits) {
                        let first = &sources[..one.sources];
                        let rows = [&rows[..]; 3];
                        let picture = picture(&view, size.0, rows, &material.gloss, first, &sphere);
                        let errors = &mut one.errors[place];
                        *errors = errors.max(reference.errors(&picture, &sphere).all);
                    }
                }
            }
        }
    }
    Ok(found)
}

/// The picture of a material by harmonics and sources, both in f64, with the window that
/// `eigenshade render` chooses. `rows` are the responses of each channel at the normals.
#[must_use]
pub fn picture(
    view: &View,
    degree: usize,
    rows: [&[Vec<f64>]; 3],
    gloss: &Gloss,
    sources: &[Source],
    sphere: &Sphere,
) -> Picture {
    let mut rest = view.light().each_ref().map(|light| light[..light::count(degree)].to_vec());
    let turned = sources.iter().map(|source| view.turned(source)).collect::<Vec<_>>();
    highlights::take_out(&mut rest, degree, &turned);
    let lobes = Highlights::new(gloss, &turned);
    let lit: Vec<[f64; 3]> = sphere.normals.iter().map(|&n| lobes.irradiance(n)).collect();
    let Ok(drawn) = screen::windowed(degree, sphere, |window: Window| {
        let channel = |c: usize| {
            let mut rest = rest[c].clone();
            window.apply(&mut rest);
            let pixel = |(row, lit): (&Vec<f64>, &[f64; 3])| {
                lit[c]
                    + row.iter().zip(&rest).map(|(response, light)| response * light).sum::<f64>()
            };
            rows[c].iter().zip(&lit).map(pixel).collect()
        };
        Ok::<Picture, Infallible>([0, 1, 2].map(channel))
    });
    drawn
}
