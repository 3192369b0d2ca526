//! Pictures by direct integration under the shipped maps, with no degree and no order, and the
//! errors of other pictures against them.

use crate::light_tree::LightTree;
use crate::mirrored;
use crate::reference::named;
use crate::sphere::{Picture, Sphere, peak};
use eigenshade::{Display, Exposure, Meter, Rgb, Tone};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::named_maps;
use eigenshade_generator::material::brdf::Surface;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_testing::largest;
use palette::color_difference::Ciede2000;
use palette::{IntoColor, Lab, Srgb};
use std::path::Path;

/// Distance of the evenly spaced normals in radians: 500, and 450 that mirror lamps of the maps.
pub const SPACING: f64 = 0.113;
/// The number of pixels that are metered: each normal counts as many as its weight is of them.
const METERED: f64 = 10_000.0;
/// The display of `eigenshade render`.
static DISPLAY: Display = Display::new(Tone::Linear);

/// The shipped maps, and the normals of the pictures.
pub struct World {
    pub maps: Vec<EnvironmentMap>,
    pub tree: LightTree,
    /// The projections of the maps.
    pub lights: Lights,
    pub sphere: Sphere,
}

impl World {
    /// Reads the maps of a folder, which have lights of their names. The spacing is in radians.
    pub fn new(folder: &Path, lights: &Lights, spacing: f64) -> Result<Self> {
        let files = named_maps(&[folder])?;
        let maps = files.iter().map(|(_, path)| EnvironmentMap::from_path(path));
        let maps = maps.collect::<Result<Vec<_>>>()?;
        let lights = named(lights, files.iter().map(|(name, _)| name.as_str()))?;
        Self::of(maps, lights, spacing)
    }

    /// Maps of one size with their projections.
    pub fn of(maps: Vec<EnvironmentMap>, lights: Lights, spacing: f64) -> Result<Self> {
        let tree = LightTree::new(&maps)?;
        let brightest = (0..maps.len()).map(|map| tree.mirror(map));
        let sphere = mirrored::sphere(&maps, spacing, &brightest.collect::<Vec<_>>());
        Ok(Self { maps, tree, lights, sphere })
    }

    /// The pictures of a surface by direct integration at these normals, by map.
    pub fn pictures(&self, surface: &Surface, normals: &[[f64; 3]]) -> Vec<Picture> {
        self.tree.pictures(surface, normals, &())
    }
}

pub struct ReferencePicture {
    picture: Picture,
    peak: f64,
    exposure: Exposure,
    shown: Vec<Lab>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureError {
    /// The root mean square over the sphere's picture and the channels, relative to the peak.
    pub rms: f64,
    /// The largest error of a pixel in any channel, relative to the peak.
    pub pixel: f64,
    /// CIEDE2000 of the pictures as shown, the mean over the sphere's picture.
    pub difference: f64,
}

impl ReferencePicture {
    pub fn new(picture: Picture, sphere: &Sphere) -> Self {
        let mut meter = Meter::default();
        for (k, weight) in sphere.weights.iter().enumerate() {
            let pixel = pixel(&picture, k);
            (0..(METERED * weight).round() as usize).for_each(|_| meter.add(pixel));
        }
        let exposure = meter.exposure().unwrap_or_default();
        Self { peak: peak(&picture), exposure, shown: shown(&picture, exposure), picture }
    }

    /// The error of a picture at the same normals. It is shown with the exposure of this one.
    pub fn error(&self, found: &Picture, sphere: &Sphere) -> PictureError {
        let pixels = found.iter().flatten().zip(self.picture.iter().flatten());
        let pixel = largest(pixels.map(|(found, expected)| found - expected));
        let shown = shown(found, self.exposure);
        let pairs = shown.into_iter().zip(&self.shown).zip(&sphere.weights);
        let differences = pairs.map(|((a, b), weight)| weight * f64::from(a.difference(*b)));
        PictureError {
            rms: sphere.apart(found, &self.picture) / self.peak,
            pixel: pixel / self.peak,
            difference: differences.sum(),
        }
    }
}

fn pixel(picture: &Picture, k: usize) -> Rgb<f32> {
    [0, 1, 2].map(|c: usize| picture[c][k] as f32).into()
}

/// The pixels of the display.
fn shown(picture: &Picture, exposure: Exposure) -> Vec<Lab> {
    let shown = |k: usize| {
        let Rgb { r, g, b } = DISPLAY.rgb888(exposure.of(pixel(picture, k)));
        Srgb::new(r, g, b).into_format::<f32>().into_color()
    };
    (0..picture[0].len()).map(shown).collect()
}
