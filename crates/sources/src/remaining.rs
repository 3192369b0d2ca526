//! The errors that sources leave: pictures of metals against direct integration of the whole map.

use crate::response::{Glossy, Place, Response};
use crate::sphere::{Picture, Sphere, peak};
use crate::view::View;
use eigenshade::mathematics::Libm;
use eigenshade::{Highlights, Normal};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_index::highlights::MAX_SOURCES;
use eigenshade_index::light;
use eigenshade_model::error::Result;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::{Gloss, SetError, SetErrors, SourceSets};
use eigenshade_shading::shader::fault;
use eigenshade_shading::{highlights, parallel};

/// The degrees and orders.
const SIZES: [(usize, usize); 4] = [(9, 7), (12, 12), (24, 24), (32, 32)];

/// The light as it is, and after a rotation that no source is fitted to or chosen by.
const VIEWS: [Option<Rotation>; 2] = [None, Some(Rotation { alpha: 0.6, beta: 1.3, gamma: -2.2 })];

/// Spacing of the normals in radians.
const SPACING: f64 = 0.09;

/// Metals of these roughnesses; those whose pictures are compared are of
/// [`ROUGHNESS`](eigenshade_index::highlights::ROUGHNESS).
///
/// # Errors
///
/// Those of [`Glossy::new`].
pub fn metals(roughness: &[f64]) -> Result<Vec<Glossy>> {
    let of = |&roughness: &f64| Glossy::new([roughness, 1.0, 0.0], &SIZES);
    roughness.iter().map(of).collect()
}

/// The errors of the pictures of these metals under a map, without sources and with each set: the
/// larger of two views.
///
/// # Errors
///
/// Those of [`View::new`], and if the runtime refuses a source.
pub fn errors(map: &EnvironmentMap, sets: &SourceSets, metals: &[Glossy]) -> Result<Vec<SetError>> {
    let degree = SIZES.iter().map(|size| size.0).max().unwrap_or(0);
    let mut found: Vec<SetError> = Vec::new();
    for size in SIZES {
        let counts = sets.sets.iter().map(|(most, _)| *most);
        found.extend(std::iter::once(0).chain(counts).map(|most| SetError {
            light: sets.name.clone(),
            most,
            size,
            errors: [SetErrors::default(); 6],
        }));
    }
    for rotation in VIEWS {
        let view = View::new(map, rotation, degree)?;
        let sphere = view.sphere(SPACING);
        for (place, metal) in metals.iter().enumerate() {
            let reference = view.pictures(metal, &sphere.normals).reference;
            for one in &mut found {
                let size = SIZES.iter().position(|size| *size == one.size);
                let Some(response) = size.and_then(|size| metal.responses.get(size)) else {
                    continue;
                };
                let picture = picture(&view, [response; 3], &metal.gloss, sets, one.most, &sphere)?;
                let [rms, worst] = off(&sphere, &picture, &reference);
                let errors = &mut one.errors[place];
                errors.rms = errors.rms.max(rms);
                errors.worst = errors.worst.max(worst);
            }
        }
    }
    Ok(found)
}

/// The root mean square and the largest difference of two pictures, of the peak of the second.
#[must_use]
pub fn off(sphere: &Sphere, found: &Picture, reference: &Picture) -> [f64; 2] {
    let pairs = found.iter().flatten().zip(reference.iter().flatten());
    let worst = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    [sphere.error(found, reference), worst / peak(reference)]
}

/// The picture of a material by harmonics and at most this many sources, both in f64.
///
/// # Errors
///
/// If the runtime refuses a source or the gloss.
pub fn picture(
    view: &View,
    responses: [&Response; 3],
    gloss: &Gloss,
    sets: &SourceSets,
    most: usize,
    sphere: &Sphere,
) -> Result<Picture> {
    let degree = responses[0].degree();
    let mut rest = view.light().each_ref().map(|light| light[..light::count(degree)].to_vec());
    let turned = sets.of_most(most).iter().map(|source| view.turned(source)).collect::<Vec<_>>();
    highlights::take_out(&mut rest, degree, &turned)?;
    let turned = turned.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
    let lobes = Highlights::<f64, MAX_SOURCES>::new::<Libm>(&highlights::gloss(gloss)?, &turned);
    let lobes = lobes.map_err(fault)?;
    let images = [0, 1, 2].map(|c: usize| responses[c].under(&rest[c]));
    let color = |k: usize| {
        let [x, y, z] = sphere.normals[k];
        let lit: [f64; 3] = lobes.shade(Normal::new(x, y, z).map_err(fault)?).into();
        let at = Place::new([x, y, z], degree);
        let smooth = images.each_ref().map(|image| image.irradiance(&at));
        Ok([0, 1, 2].map(|c: usize| smooth[c] + lit[c]))
    };
    let colors = parallel::map(sphere.normals.len(), &(), color);
    let colors = colors.into_iter().collect::<Result<Vec<[f64; 3]>>>()?;
    Ok([0, 1, 2].map(|c: usize| colors.iter().map(|color| color[c]).collect()))
}
