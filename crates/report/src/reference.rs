//! Pictures of a sphere by direct integration under environment maps, and the errors of truncated
//! sums against them.
//!
//! The error of a map is the rms over the sphere's normals and the three channels, relative to the
//! largest |I| of the direct integration over all of them.

use crate::light_tree::LightTree;
use crate::sphere::{self, Picture, Sphere};
use eigenshade_generator::material::brdf::Surface;
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::sphere_rings::rings;
use eigenshade_table::light;
use indicatif::ProgressBar;

/// The widest spacing of normals in radians.
const WIDEST: f64 = 0.06;
/// Spacing of the normals, in widths of the narrowest lobe.
const SPACING: f64 = 1.25;

/// A surface under environment maps, integrated directly.
pub struct Reference {
    pub sphere: Sphere,
    pictures: Vec<Picture>,
    peaks: Vec<f64>,
}

/// The lights of these names, in order.
pub fn named<'a>(all: &Lights, names: impl Iterator<Item = &'a str>) -> Result<Lights> {
    let find = |name: &str| {
        let found = all.entries.iter().find(|light| light.name == name).cloned();
        found.ok_or_else(|| {
            let what = format!("no light has the name of the map `{name}`");
            Error::new(what, "make the light of the map with `eigenshade light`")
        })
    };
    Ok(Lights { degree: all.degree, entries: names.map(find).collect::<Result<_>>()? })
}

/// The picture of the direct sum (15) under each light up to a degree and an order.
pub fn sums(sphere: &Sphere, lights: &Lights, size: (usize, usize), on: &Named) -> Vec<Picture> {
    let (count, maps) = (light::count(size.0), lights.entries.len());
    let channel = |c: usize| {
        let lights = lights.entries.iter().map(|light| &light.rgb[c][..count]);
        (lights.collect(), &on.rgb[c][..])
    };
    let images = sphere.direct(size, &[0, 1, 2].map(channel));
    (0..maps).map(|map| [0, 1, 2].map(|c| images[c * maps + map].clone())).collect()
}

impl Reference {
    pub fn new(surface: &Surface, maps: &LightTree, progress: &ProgressBar) -> Self {
        let parts = surface.parts();
        // The narrowest lobe is resolved.
        let width = parts.iter().map(|part| part.brdf.width()).fold(1.0, f64::min);
        let sphere = Sphere::new(rings((SPACING * width).min(WIDEST)));
        progress.set_length(sphere.normals.len() as u64);
        let pictures = maps.pictures(surface, &sphere.normals, progress);
        // A narrow lobe peaks where it mirrors the sun, which is between the normals of the rings.
        let mirrors: Vec<_> = (0..maps.maps()).map(|map| maps.mirror(map)).collect();
        let at_mirrors = maps.pictures(surface, &mirrors, &());
        let largest = |(map, picture): (usize, &Picture)| {
            let at_mirror = at_mirrors[map].iter().map(|channel| channel[map].abs());
            at_mirror.fold(sphere::peak(picture), f64::max)
        };
        let peaks = pictures.iter().enumerate().map(largest).collect();
        Self { sphere, pictures, peaks }
    }

    /// The error for each map of the direct sum (15) up to a degree and an order. `lights` are the
    /// projections of the maps and must reach the degree; `material` is that of the surface, of
    /// this order.
    pub fn of_sum(&self, lights: &Lights, size: (usize, usize), material: &Named) -> Vec<f64> {
        self.errors(sums(&self.sphere, lights, size, material).into_iter())
    }

    /// The rms over normals and channels relative to the peak, by map.
    fn errors(&self, found: impl Iterator<Item = Picture>) -> Vec<f64> {
        let expected = self.pictures.iter().zip(&self.peaks);
        let error = |(found, (expected, peak))| self.sphere.apart(&found, expected) / peak;
        found.zip(expected).map(error).collect()
    }
}
