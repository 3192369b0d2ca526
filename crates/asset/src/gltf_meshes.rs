//! The meshes of glTF at rest.

use crate::accessor::{Accessors, broken};
use crate::asset::{Asset, MOST_TRIANGLES};
use crate::gltf_pose::{Nodes, Placement, determinant, morph, normal_of, times};
use eigenshade_generator::object::mesh_data::{Attribute, Mesh};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;
use gltf::mesh::{Mode, MorphTarget};
use gltf::{Document, Primitive, Semantic};
use std::collections::BTreeSet;

/// The meshes of the default scene, or of the first one, or of all nodes.
pub(crate) fn read(
    file: &InputFile,
    document: &Document,
    accessors: &Accessors<'_>,
) -> Result<Asset> {
    let mut reader = Reader { file, accessors, asset: Asset::default(), ignored: BTreeSet::new() };
    if document.animations().len() > 0 {
        reader.ignored.insert("animations (the object is drawn at rest)");
    }
    let nodes = Nodes::new(document)?;
    for (node, matrix) in &nodes.shown {
        let Some(mesh) = node.mesh() else { continue };
        let weights = node.weights().or_else(|| mesh.weights()).unwrap_or_default();
        // A skinned mesh is placed by its joints, and not by its node.
        let joints = node.skin().map(|skin| nodes.joints(&skin, accessors)).transpose()?;
        for primitive in mesh.primitives() {
            let placement = match &joints {
                Some(joints) => Placement::of_joints(&primitive, joints.clone(), accessors)?,
                None => Placement::Node(*matrix),
            };
            reader.push(&primitive, &placement, weights)?;
        }
    }
    if !reader.ignored.is_empty() {
        let list: Vec<&str> = reader.ignored.into_iter().collect();
        file.warn(format!("ignored: {}", list.join(", ")));
    }
    if reader.asset.mesh.triangles.is_empty() {
        return Err(broken("it contains no triangle"));
    }
    Ok(reader.asset)
}

struct Reader<'a> {
    file: &'a InputFile,
    accessors: &'a Accessors<'a>,
    asset: Asset,
    /// Names of the features that are ignored, for a warning.
    ignored: BTreeSet<&'static str>,
}

impl Reader<'_> {
    /// Adds the triangles of a primitive.
    fn push(
        &mut self,
        primitive: &Primitive<'_>,
        placement: &Placement,
        weights: &[f32],
    ) -> Result<()> {
        let Some(positions) = primitive.get(&Semantic::Positions) else { return Ok(()) };
        let mut positions = self.accessors.numbers::<3>(&positions)?;
        morph(&mut positions, primitive, weights, MorphTarget::positions, self.accessors)?;
        let count = positions.len();
        let places = match primitive.indices() {
            Some(indices) => self.accessors.indices(&indices)?,
            None => (0..count as u32).collect(),
        };
        if let Some(place) = places.iter().find(|place| **place as usize >= count) {
            return Err(broken(format!("corner {place} does not exist: there are {count}")));
        }
        let first = self.asset.mesh.corners.len() as u32;
        let triangles: Vec<[u32; 3]> = match primitive.mode() {
            Mode::Triangles => places.as_chunks().0.to_vec(),
            Mode::TriangleStrip => (0..places.len().saturating_sub(2))
                .map(|k| [places[k], places[k + 1 + k % 2], places[k + 2 - k % 2]])
                .collect(),
            Mode::TriangleFan => (1..places.len().saturating_sub(1))
                .map(|k| [places[0], places[k], places[k + 1]])
                .collect(),
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => {
                self.ignored.insert("points and lines");
                return Ok(());
            }
        };
        let all = self.asset.mesh.triangles.len() + triangles.len();
        self.file.at_most(all as u64, MOST_TRIANGLES, "triangles")?;
        self.file.at_most(u64::from(first) + count as u64, 1 << 22, "corners")?;
        let triangles = triangles.into_iter().map(|[a, b, c]| {
            let is_mirrored = determinant(placement.at(a as usize)) < 0.0;
            let (b, c) = if is_mirrored { (c, b) } else { (b, c) };
            [a, b, c].map(|corner| first + corner)
        });
        let triangles: Vec<[u32; 3]> = triangles.collect();
        let material = primitive.material().index().map_or(0, |index| index as u32 + 1);
        self.asset.material_of.extend(triangles.iter().map(|_| material));
        self.attributes(primitive, (placement, weights), count, &triangles)?;
        let mesh = &mut self.asset.mesh;
        mesh.triangles.extend(triangles);
        mesh.corners.extend(positions.iter().enumerate().map(|(corner, at)| {
            let matrix = placement.at(corner);
            let moved = times(matrix, at.map(f64::from));
            [0, 1, 2].map(|axis| moved[axis] + matrix[3][axis])
        }));
        Ok(())
    }

    /// Adds what else a primitive has at its corners.
    fn attributes(
        &mut self,
        primitive: &Primitive<'_>,
        (placement, weights): (&Placement, &[f32]),
        count: usize,
        triangles: &[[u32; 3]],
    ) -> Result<()> {
        let mut normals = self.attribute::<3>(primitive, Semantic::Normals, count)?;
        if let Some(normals) = &mut normals {
            morph(normals, primitive, weights, MorphTarget::normals, self.accessors)?;
        }
        let mut tangents = self.attribute::<4>(primitive, Semantic::Tangents, count)?;
        if let Some(tangents) = &mut tangents {
            morph(tangents, primitive, weights, MorphTarget::tangents, self.accessors)?;
        }
        let coordinates = [0, 1].map(Semantic::TexCoords);
        let coordinates =
            coordinates.map(|semantic| self.attribute::<2>(primitive, semantic, count));
        let colors = match primitive.get(&Semantic::Colors(0)) {
            Some(accessor) if accessor.dimensions() == gltf::accessor::Dimensions::Vec3 => {
                let rgb = self.attribute::<3>(primitive, Semantic::Colors(0), count)?;
                rgb.map(|all| all.into_iter().map(|[r, g, b]| [r, g, b, 1.0]).collect())
            }
            _ => self.attribute::<4>(primitive, Semantic::Colors(0), count)?,
        };
        let asset = &mut self.asset;
        let Mesh { normals: all, .. } = &mut asset.mesh;
        // Those without normals have none at their triangles.
        let none = [Attribute::<3>::NONE; 3];
        let has_normals = normals.is_some();
        all.places
            .extend(triangles.iter().map(|corners| if has_normals { *corners } else { none }));
        let normals = normals.unwrap_or_else(|| vec![[0.0; 3]; count]);
        let placed = (0..).map(|corner| placement.at(corner));
        let normals = normals.into_iter().zip(placed.clone());
        all.values.extend(normals.map(|(normal, matrix)| normal_of(matrix, normal)));
        let tangents = tangents.unwrap_or_else(|| vec![[0.0; 4]; count]);
        asset.tangents.values.extend(tangents.into_iter().zip(placed).map(|(tangent, matrix)| {
            let ([x, y, z, w], sign) = (tangent, determinant(matrix).signum() as f32);
            let [x, y, z] = times(matrix, [x, y, z].map(f64::from)).map(|c| c as f32);
            [x, y, z, w * sign]
        }));
        for (all, of_set) in asset.coordinates.iter_mut().zip(coordinates) {
            all.values.extend(of_set?.unwrap_or_else(|| vec![[0.0; 2]; count]));
        }
        asset.colors.values.extend(colors.unwrap_or_else(|| vec![[1.0; 4]; count]));
        Ok(())
    }

    fn attribute<const N: usize>(
        &self,
        primitive: &Primitive<'_>,
        semantic: Semantic,
        count: usize,
    ) -> Result<Option<Vec<[f32; N]>>> {
        let Some(accessor) = primitive.get(&semantic) else { return Ok(None) };
        let values = self.accessors.numbers(&accessor)?;
        if values.len() != count {
            let what = format!("{count} positions have {} of {semantic:?}", values.len());
            return Err(broken(what));
        }
        Ok(Some(values))
    }
}
