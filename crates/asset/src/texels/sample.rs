//! The normal and the material parameters of one sample of a picture.

use crate::asset::{Asset, Map, Material};
use crate::tangents::{Tangent, places};
use eigenshade_generator::object::facet::{Frame, Plane};
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::vector::{cross, dot};

/// The reflectance of dielectrics at normal incidence.
const DIELECTRIC: f32 = 0.04;

/// The surface at a sample.
pub(super) struct Shown {
    /// The unit normal of the surface.
    pub(super) smooth: [f64; 3],
    /// The normal of the normal map, of the length of the mean over the sample's area.
    pub(super) bumped: [f64; 3],
    /// base color (1 - metallic) (1 - f0), times the occlusion.
    pub(super) matte: [f32; 3],
    /// f0.
    pub(super) reflectance: [f32; 3],
    pub(super) metallic: f32,
    pub(super) roughness: f32,
}

/// Evaluates an object's surface at samples.
pub(super) struct Sampler<'a> {
    asset: &'a Asset,
    surface: &'a Surface,
    frame: &'a Frame,
    tangents: &'a [[Tangent; 3]],
    /// The facet of the last sample.
    last: Option<(u32, Corners)>,
}

/// The corners of a facet.
struct Corners {
    plane: Plane,
    colors: [[f32; 4]; 3],
    base_color: Option<Places>,
    metallic_roughness: Option<Places>,
    occlusion: Option<Places>,
    normal: Option<Places>,
}

/// The corners of a facet on a texture.
struct Places {
    map: Map,
    corners: [[f32; 2]; 3],
    /// Of the area of a sample.
    level: f32,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(
        asset: &'a Asset,
        surface: &'a Surface,
        frame: &'a Frame,
        tangents: &'a [[Tangent; 3]],
    ) -> Self {
        Self { asset, surface, frame, tangents, last: None }
    }

    fn triangle(&self, facet: u32) -> usize {
        self.surface.triangles[facet as usize] as usize
    }

    fn material(&self, facet: u32) -> &'a Material {
        &self.asset.materials[self.asset.material_of[self.triangle(facet)] as usize]
    }

    /// Whether a facet shows the side that the camera sees; `None` if it is not there.
    pub(super) fn side(&self, facet: u32) -> Option<bool> {
        let faces_camera = self.surface.facets[facet as usize].projected_area > 0.0;
        let shows = faces_camera || self.material(facet).is_double_sided;
        (shows || self.asset.backs_hide).then_some(shows)
    }

    /// Whether a sample falls through a hole of a facet.
    pub(super) fn is_hole(&mut self, facet: u32, column: usize, row: usize) -> bool {
        let material = self.material(facet);
        let Some(cutoff) = material.cutoff else { return false };
        let corners = corners(&mut self.last, self.asset, self.surface, self.frame, facet);
        let Some(weights) = corners.weights(column, row) else { return false };
        self.base_color(facet, weights)[3] < cutoff
    }

    /// The base color and the opacity at a point of the last facet.
    fn base_color(&self, facet: u32, weights: [f64; 3]) -> [f32; 4] {
        let mut color = self.material(facet).base_color;
        let Some((_, corners)) = &self.last else { return color };
        let of_corners = mean(corners.colors, weights);
        let of_map = corners.base_color.as_ref().map_or([1.0; 4], |of| self.look_up(of, weights));
        for (factor, (a, b)) in color.iter_mut().zip(of_corners.into_iter().zip(of_map)) {
            *factor = (*factor * a * b).clamp(0.0, 1.0);
        }
        color
    }

    fn look_up(&self, places: &Places, weights: [f64; 3]) -> [f32; 4] {
        let texture = &self.asset.textures[places.map.texture];
        texture.at(mean(places.corners, weights), &places.map, places.level)
    }

    /// The surface of a facet at the sample in this column and row; rows count upward.
    pub(super) fn shown(&mut self, facet: u32, column: usize, row: usize) -> Option<Shown> {
        let number = facet as usize;
        let plain = self.surface.facets.get(number)?;
        let weights = corners(&mut self.last, self.asset, self.surface, self.frame, facet)
            .weights(column, row)
            .unwrap_or([1.0 / 3.0; 3]);
        let material = self.material(facet);
        let (_, corners) = self.last.as_ref()?;
        let [r, g, b, _] = self.base_color(facet, weights);
        let (mut metallic, mut roughness) = (material.metallic, material.roughness);
        if let Some(places) = &corners.metallic_roughness {
            let [_, of_roughness, of_metallic, _] = self.look_up(places, weights);
            (metallic, roughness) = (metallic * of_metallic, roughness * of_roughness);
        }
        let occlusion = match (&corners.occlusion, material.occlusion_map) {
            (Some(places), Some((_, strength))) => {
                1.0 + strength * (self.look_up(places, weights)[0] - 1.0)
            }
            _ => 1.0,
        };
        let reflectance = [r, g, b].map(|base| DIELECTRIC + (base - DIELECTRIC) * metallic);
        let matte = |(base, f0): (f32, f32)| base * (1.0 - metallic) * (1.0 - f0) * occlusion;
        let [r, g, b] = [(r, reflectance[0]), (g, reflectance[1]), (b, reflectance[2])].map(matte);
        let smooth = unit(self.surface.normal(number, weights)).unwrap_or(plain.normal);
        let bumped = match (&corners.normal, material.normal_map) {
            (Some(places), Some((_, scale))) => {
                let [x, y, z, length] = self.look_up(places, weights);
                let tangent = mean(self.tangents[number], weights);
                bumped(smooth, tangent, [scale * x, scale * y, z], length)
            }
            _ => smooth,
        };
        let sign = if plain.projected_area > 0.0 { 1.0 } else { -1.0 };
        // A normal that points away where its facet is seen is at the rim.
        let [x, y, z] = smooth.map(|c| sign * c);
        let smooth = unit([x, y, z.max(0.0)]).unwrap_or(plain.normal);
        let bumped = if corners.normal.is_some() { bumped.map(|c| sign * c) } else { smooth };
        Some(Shown { smooth, bumped, matte: [r, g, b], reflectance, metallic, roughness })
    }
}

/// The corners of a facet, from the last look-up if it was the same.
fn corners<'s>(
    last: &'s mut Option<(u32, Corners)>,
    asset: &Asset,
    surface: &Surface,
    frame: &Frame,
    facet: u32,
) -> &'s Corners {
    let same = last.take().filter(|(number, _)| *number == facet);
    let (_, corners) =
        last.insert(same.unwrap_or_else(|| (facet, Corners::new(asset, surface, frame, facet))));
    corners
}

impl Corners {
    fn new(asset: &Asset, surface: &Surface, frame: &Frame, facet: u32) -> Self {
        let triangle = surface.triangles[facet as usize] as usize;
        let material = &asset.materials[asset.material_of[triangle] as usize];
        let placed = frame.place(&surface.facets[facet as usize]);
        let plane = Plane::new(&placed);
        let area = plane.area();
        let on = |map: Option<Map>| {
            let map = map?;
            let corners = places(asset, &map, triangle);
            let [[a, b], [c, d], [e, f]] = corners.map(|corner| corner.map(f64::from));
            let [width, height] = asset.textures[map.texture].size();
            let texels = ((c - a) * (f - b) - (e - a) * (d - b)).abs() * (width * height) as f64;
            let level = (0.5 * (texels / area).log2()) as f32;
            Some(Places { map, corners, level: if level.is_finite() { level } else { 0.0 } })
        };
        let colors = asset.colors.at(triangle, asset.mesh.triangles[triangle]);
        Self {
            plane,
            colors: colors.map(|color| color.unwrap_or([1.0; 4])),
            base_color: on(material.base_color_map),
            metallic_roughness: on(material.metallic_roughness_map),
            occlusion: on(material.occlusion_map.map(|(map, _)| map)),
            normal: on(material.normal_map.map(|(map, _)| map)),
        }
    }

    fn weights(&self, column: usize, row: usize) -> Option<[f64; 3]> {
        self.plane.weights(column as f64 + 0.5, row as f64 + 0.5)
    }
}

/// The vector of a normal map on a surface, with this length.
fn bumped(smooth: [f64; 3], [x, y, z, w]: Tangent, map: [f32; 3], length: f32) -> [f64; 3] {
    let tangent = [x, y, z].map(f64::from);
    let Some(tangent) = unit(tangent) else { return smooth };
    let bitangent = cross(smooth, tangent).map(|c| f64::from(w.signum()) * c);
    let [x, y, z] = map.map(f64::from);
    let sum = [0, 1, 2].map(|k| x * tangent[k] + y * bitangent[k] + z * smooth[k]);
    unit(sum).map_or(smooth, |unit| unit.map(|c| f64::from(length) * c))
}

fn mean<const N: usize>(corners: [[f32; N]; 3], weights: [f64; 3]) -> [f32; N] {
    let mut sum = [0.0; N];
    for (corner, weight) in corners.iter().zip(weights) {
        sum.iter_mut().zip(corner).for_each(|(sum, c)| *sum += weight * f64::from(*c));
    }
    sum.map(|c| c as f32)
}

fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(vector, vector).sqrt();
    length.is_normal().then(|| vector.map(|c| c / length))
}
