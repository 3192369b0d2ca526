//! Tangents at the corners of facets: those of the file, or MikkTSpace's.

use crate::asset::{Asset, Map};
use bevy_mikktspace::{Geometry, TangentSpace, generate_tangents};
use eigenshade_generator::object::surface::{Surface, View};

/// A unit tangent and the sign of the bitangent; 0 where texture coordinates have no direction.
pub(crate) type Tangent = [f32; 4];

/// The tangents of each facet whose material has a normal map.
pub(crate) fn of(asset: &Asset, surface: &Surface, view: &View) -> Vec<[Tangent; 3]> {
    let mut tangents = vec![[[0.0; 4]; 3]; surface.facets.len()];
    let maps: Vec<Option<Map>> =
        asset.materials.iter().map(|one| one.normal_map.map(|(map, _)| map)).collect();
    let mut open = Vec::new();
    for (facet, triangle) in surface.triangles.iter().enumerate() {
        let triangle = *triangle as usize;
        let Some(map) = maps[asset.material_of[triangle] as usize] else { continue };
        let corners = asset.mesh.triangles[triangle];
        let given = asset.tangents.at(triangle, corners).map(|of| of.unwrap_or([0.0; 4]));
        let is_given = given.iter().all(|[x, y, z, _]| (x * x + y * y + z * z).is_normal());
        if is_given {
            tangents[facet] = given.map(|[x, y, z, w]| {
                let [x, y, z] = view.turned([x, y, z].map(f64::from)).map(|c| c as f32);
                let length = (x * x + y * y + z * z).sqrt();
                [x / length, y / length, z / length, if w < 0.0 { -1.0 } else { 1.0 }]
            });
        } else {
            open.push((facet as u32, places(asset, &map, triangle)));
        }
    }
    if !open.is_empty() {
        let mut faces = Faces { surface, open: &open, tangents: &mut tangents };
        // It has no errors.
        let _ = generate_tangents(&mut faces);
    }
    tangents
}

/// The finite texture coordinates of a triangle on a map.
pub(crate) fn places(asset: &Asset, map: &Map, triangle: usize) -> [[f32; 2]; 3] {
    let corners = asset.mesh.triangles[triangle];
    asset.coordinates[map.set].at(triangle, corners).map(|of| {
        let place = map.place(of.unwrap_or_default());
        if place.iter().all(|c| c.is_finite()) { place } else { [0.0; 2] }
    })
}

struct Faces<'a> {
    surface: &'a Surface,
    /// Facets, and texture coordinates on their maps.
    open: &'a [(u32, [[f32; 2]; 3])],
    tangents: &'a mut [[Tangent; 3]],
}

impl Faces<'_> {
    fn facet(&self, face: usize) -> usize {
        self.open[face].0 as usize
    }
}

impl Geometry for Faces<'_> {
    fn num_faces(&self) -> usize {
        self.open.len()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.surface.facets[self.facet(face)].corners[corner].map(|x| x as f32)
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        let facet = self.facet(face);
        let own = self.surface.facets[facet].normal;
        self.surface.normals.get(facet).map_or(own, |three| three[corner]).map(|x| x as f32)
    }

    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        // MikkTSpace has v upward.
        let [u, v] = self.open[face].1[corner];
        [u, 1.0 - v]
    }

    fn set_tangent(&mut self, tangent: Option<TangentSpace>, face: usize, corner: usize) {
        let facet = self.facet(face);
        let found = tangent.map_or([0.0; 4], |tangent| tangent.tangent_encoded());
        self.tangents[facet][corner] =
            if found.iter().all(|c| c.is_finite()) { found } else { [0.0; 4] };
    }
}
