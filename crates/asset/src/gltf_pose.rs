//! Where nodes, joints and morph targets place the corners of glTF's meshes at rest.

use crate::accessor::{Accessors, broken};
use eigenshade_model::error::Result;
use eigenshade_model::vector::{cross, dot};
use gltf::mesh::MorphTarget;
use gltf::{Accessor, Document, Node, Primitive, Semantic, Skin};

/// The most nodes that are visited: one with two parents is visited twice.
const MOST_NODES: usize = 1 << 16;

/// By columns, as in the file.
pub(crate) type Matrix = [[f64; 4]; 4];

const ONE: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The nodes of a file, placed by those above them.
pub(crate) struct Nodes<'a> {
    /// The nodes of the default scene, or of the first one, or all.
    pub(crate) shown: Vec<(Node<'a>, Matrix)>,
    /// The matrix of each node of the file.
    placed: Vec<Matrix>,
}

impl<'a> Nodes<'a> {
    /// # Errors
    ///
    /// If nodes form a cycle.
    pub(crate) fn new(document: &'a Document) -> Result<Self> {
        let count = document.nodes().len();
        let mut has_parent = vec![false; count];
        let children = document.nodes().flat_map(|node| node.children());
        children.for_each(|child| has_parent[child.index()] = true);
        let scene = document.default_scene().or_else(|| document.scenes().next());
        let mut is_shown = vec![scene.is_none(); count];
        let roots = scene.into_iter().flat_map(|scene| scene.nodes());
        roots.for_each(|node| is_shown[node.index()] = true);
        let mut open: Vec<(Node<'_>, Matrix)> = document
            .nodes()
            .filter(|node| !has_parent[node.index()])
            .map(|node| (node, ONE))
            .collect();
        open.reverse();
        let (mut shown, mut placed, mut visited) = (Vec::new(), vec![None; count], 0);
        while let Some((node, above)) = open.pop() {
            visited += 1;
            if visited > MOST_NODES {
                return Err(broken("its nodes are too many"));
            }
            let local = node.transform().matrix().map(|column| column.map(f64::from));
            let matrix = product(above, local);
            placed[node.index()] = Some(matrix);
            for child in node.children() {
                is_shown[child.index()] |= is_shown[node.index()];
                open.push((child, matrix));
            }
            if is_shown[node.index()] {
                shown.push((node, matrix));
            }
        }
        let placed: Option<Vec<Matrix>> = placed.into_iter().collect();
        Ok(Self { shown, placed: placed.ok_or_else(|| broken("its nodes form a cycle"))? })
    }

    /// The matrices of the joints of a skin, each times its inverse bind matrix.
    ///
    /// # Errors
    ///
    /// If these matrices are broken.
    pub(crate) fn joints(&self, skin: &Skin<'_>, accessors: &Accessors<'_>) -> Result<Vec<Matrix>> {
        let binds = match skin.inverse_bind_matrices() {
            Some(binds) => accessors.numbers::<16>(&binds)?,
            None => Vec::new(),
        };
        let joint = |(number, node): (usize, Node<'_>)| {
            let bind = binds.get(number).map_or(ONE, |bind| {
                [0, 1, 2, 3].map(|c| [0, 1, 2, 3].map(|row| f64::from(bind[4 * c + row])))
            });
            product(self.placed[node.index()], bind)
        };
        Ok(skin.joints().enumerate().map(joint).collect())
    }
}

/// The matrices of the corners of a primitive.
pub(crate) enum Placement {
    /// The same for all.
    Node(Matrix),
    /// A mean of the matrices of joints.
    Joints {
        /// The matrices.
        joints: Vec<Matrix>,
        /// The numbers and the weights of four joints, for each corner, once or more.
        sets: Vec<[Vec<[f32; 4]>; 2]>,
    },
}

impl Placement {
    /// The placement of a primitive by joints.
    ///
    /// # Errors
    ///
    /// If a corner has a joint that does not exist.
    pub(crate) fn of_joints(
        primitive: &Primitive<'_>,
        joints: Vec<Matrix>,
        accessors: &Accessors<'_>,
    ) -> Result<Self> {
        let mut sets = Vec::new();
        for set in 0.. {
            let found = [Semantic::Joints(set), Semantic::Weights(set)];
            let [Some(numbers), Some(weights)] = found.map(|semantic| primitive.get(&semantic))
            else {
                break;
            };
            let set = [accessors.numbers::<4>(&numbers)?, accessors.numbers::<4>(&weights)?];
            let pairs = set[0].as_flattened().iter().zip(set[1].as_flattened());
            let mut pairs = pairs.filter(|(_, weight)| **weight != 0.0);
            if let Some((joint, _)) = pairs.find(|(joint, _)| **joint as usize >= joints.len()) {
                let count = joints.len();
                return Err(broken(format!("joint {joint} does not exist: its skin has {count}")));
            }
            sets.push(set);
        }
        Ok(Self::Joints { joints, sets })
    }

    /// The matrix of a corner.
    pub(crate) fn at(&self, corner: usize) -> Matrix {
        let (joints, sets) = match self {
            Self::Node(matrix) => return *matrix,
            Self::Joints { joints, sets } => (joints, sets),
        };
        let (mut sum, mut total) = ([[0.0; 4]; 4], 0.0);
        for [numbers, weights] in sets {
            let of_corner = numbers.get(corner).zip(weights.get(corner));
            for (joint, weight) in of_corner.into_iter().flat_map(|(a, b)| a.iter().zip(b)) {
                let Some(matrix) = joints.get(*joint as usize) else { continue };
                let weight = f64::from(*weight);
                total += weight;
                let sums = sum.as_flattened_mut().iter_mut();
                sums.zip(matrix.as_flattened()).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        match total {
            0.0 => ONE,
            _ => sum.map(|column| column.map(|value| value / total)),
        }
    }
}

/// Adds the morph targets that have a weight to positions, normals or tangents.
///
/// # Errors
///
/// If a target has another number of corners.
pub(crate) fn morph<'a, const N: usize>(
    values: &mut [[f32; N]],
    primitive: &Primitive<'a>,
    weights: &[f32],
    of: impl Fn(&MorphTarget<'a>) -> Option<Accessor<'a>>,
    accessors: &Accessors<'_>,
) -> Result<()> {
    for (target, weight) in primitive.morph_targets().zip(weights) {
        let Some(accessor) = of(&target).filter(|_| *weight != 0.0) else { continue };
        let moves = accessors.numbers::<3>(&accessor)?;
        if moves.len() != values.len() {
            let what = format!("{} corners have {} of a morph target", values.len(), moves.len());
            return Err(broken(what));
        }
        for (value, by) in values.iter_mut().zip(moves) {
            value.iter_mut().zip(by).for_each(|(value, by)| *value += weight * by);
        }
    }
    Ok(())
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    b.map(|column| [0, 1, 2, 3].map(|row| (0..4).map(|k| a[k][row] * column[k]).sum()))
}

/// The vector, without the translation.
pub(crate) fn times(matrix: Matrix, vector: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|row| (0..3).map(|k| matrix[k][row] * vector[k]).sum())
}

pub(crate) fn determinant([a, b, c, _]: Matrix) -> f64 {
    let [a, b, c] = [a, b, c].map(|[x, y, z, _]| [x, y, z]);
    dot(a, cross(b, c))
}

/// A normal by the inverse of the transposed matrix, up to its length.
pub(crate) fn normal_of(matrix: Matrix, normal: [f32; 3]) -> [f32; 3] {
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
