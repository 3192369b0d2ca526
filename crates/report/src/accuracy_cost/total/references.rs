//! Pictures by direct integration under the shipped maps, with no degree and no order.

use crate::light_tree::LightTree;
use crate::mirrored;
use crate::reference::named;
use crate::sphere::{Picture, Sphere};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::named_maps;
use eigenshade_generator::material::brdf::Surface;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use std::path::Path;

/// Distance of the evenly spaced normals in radians: 500, and 450 that mirror lamps of the maps.
pub const SPACING: f64 = 0.113;
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
