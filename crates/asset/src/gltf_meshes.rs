//! The meshes of glTF, placed by their nodes, in rest pose.

use crate::accessor::{Accessors, broken};
use crate::asset::{Asset, MOST_TRIANGLES};
use eigenshade_generator::object::mesh_data::{Attribute, Mesh};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;
use gltf::mesh::Mode;
use gltf::{Document, Node, Primitive, Semantic};
use std::collections::BTreeSet;

/// The most nodes that are visited: a cycle has no end.
const MOST_NODES: usize = 1 << 16;

/// By columns, as in the file.
type Matrix = [[f64; 4]; 4];

/// The meshes of the default scene, or of the first one, or of all nodes.
pub(crate) fn read(
    file: &InputFile,
    document: &Document,
    accessors: &Accessors<'_>,
) -> Result<Asset> {
    let mut reader = Reader { file, accessors, asset: Asset::default(), ignored: BTreeSet::new() };
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let one = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| f64::from(u8::from(i == k))));
    let has_scene = scene.is_some();
    let mut open: Vec<(Node<'_>, Matrix)> = match scene {
        Some(scene) => scene.nodes().map(|node| (node, one)).collect(),
        None => document.nodes().map(|node| (node, one)).collect(),
    };
    open.reverse();
    let mut visited = 0;
    while let Some((node, above)) = open.pop() {
        visited += 1;
        if visited > MOST_NODES {
            return Err(broken("its nodes form a cycle, or are too many"));
        }
        let local = node.transform().matrix().map(|column| column.map(f64::from));
        let matrix = product(above, local);
        if let Some(mesh) = node.mesh() {
            if node.skin().is_some() {
                reader.ignored.insert("skins (the mesh is drawn as it is bound)");
            }
            let weights = node.weights().or_else(|| mesh.weights()).unwrap_or_default();
            if weights.iter().any(|weight| *weight != 0.0) {
                reader.ignored.insert("morph targets");
            }
            // A skinned mesh is placed by its joints, and not by its node.
            let matrix = if node.skin().is_some() { one } else { matrix };
            for primitive in mesh.primitives() {
                reader.push(&primitive, matrix)?;
            }
        }
        if has_scene {
            open.extend(node.children().map(|child| (child, matrix)));
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
    fn push(&mut self, primitive: &Primitive<'_>, matrix: Matrix) -> Result<()> {
        let Some(positions) = primitive.get(&Semantic::Positions) else { return Ok(()) };
        let positions = self.accessors.numbers::<3>(&positions)?;
        let count = positions.len();
        let places = match primitive.indices() {
            Some(indices) => self.accessors.indices(&indices)?,
            None => (0..count as u32).collect(),
        };
        if let Some(place) = places.iter().find(|place| **place as usize >= count) {
            return Err(broken(format!("corner {place} does not exist: there are {count}")));
        }
        let is_mirrored = determinant(matrix) < 0.0;
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
            let (b, c) = if is_mirrored { (c, b) } else { (b, c) };
            [a, b, c].map(|corner| first + corner)
        });
        let triangles: Vec<[u32; 3]> = triangles.collect();
        let material = primitive.material().index().map_or(0, |index| index as u32 + 1);
        self.asset.material_of.extend(triangles.iter().map(|_| material));
        self.attributes(primitive, matrix, count, &triangles)?;
        let mesh = &mut self.asset.mesh;
        mesh.triangles.extend(triangles);
        mesh.corners.extend(positions.iter().map(|at| {
            let moved = times(matrix, at.map(f64::from));
            [0, 1, 2].map(|axis| moved[axis] + matrix[3][axis])
        }));
        Ok(())
    }

    /// Adds what else a primitive has at its corners.
    fn attributes(
        &mut self,
        primitive: &Primitive<'_>,
        matrix: Matrix,
        count: usize,
        triangles: &[[u32; 3]],
    ) -> Result<()> {
        let normals = self.attribute::<3>(primitive, Semantic::Normals, count)?;
        let tangents = self.attribute::<4>(primitive, Semantic::Tangents, count)?;
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
        all.values.extend(normals.into_iter().map(|normal| normal_of(matrix, normal)));
        let tangents = tangents.unwrap_or_else(|| vec![[0.0; 4]; count]);
        let sign = determinant(matrix).signum() as f32;
        asset.tangents.values.extend(tangents.into_iter().map(|[x, y, z, w]| {
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

fn product(a: Matrix, b: Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

/// The vector, without the translation.
fn times(matrix: Matrix, vector: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|row| (0..3).map(|k| matrix[k][row] * vector[k]).sum())
}

fn determinant([a, b, c, _]: Matrix) -> f64 {
    let [a, b, c] = [a, b, c].map(|[x, y, z, _]| [x, y, z]);
    eigenshade_model::vector::dot(a, eigenshade_model::vector::cross(b, c))
}

/// A normal by the inverse of the transposed matrix, up to its length.
fn normal_of(matrix: Matrix, normal: [f32; 3]) -> [f32; 3] {
    use eigenshade_model::vector::cross;
    let sign = determinant(matrix).signum();
    let [a, b, c] = [0, 1, 2].map(|k| [0, 1, 2].map(|row| matrix[k][row]));
    let cofactors = [cross(b, c), cross(c, a), cross(a, b)];
    let normal = normal.map(f64::from);
    let turned: [f64; 3] =
        [0, 1, 2].map(|row| sign * (0..3).map(|k| cofactors[k][row] * normal[k]).sum::<f64>());
    let length = turned.iter().map(|x| x * x).sum::<f64>().sqrt();
    let length = if length > 0.0 { length } else { 1.0 };
    turned.map(|x| (x / length) as f32)
}
