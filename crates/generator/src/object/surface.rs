//! The facets of a mesh as a camera sees them: turned, in a unit of their own, with normals at their
//! corners.

use crate::object::depth_buffer::DepthBuffer;
use crate::object::facet::{Facet, Frame};
use crate::object::mesh_data::{Mesh, broken};
use crate::object::smooth::corner_normals;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::vector::{cross, dot};

/// The height of a facet, relative to its longest side, below which its direction is that of the
/// rounding of its corners.
const THIN: f64 = 1e-5;

fn is_thin(facet: &Facet) -> bool {
    let [a, b, c] = facet.corners;
    let square = |from: [f64; 3], to: [f64; 3]| {
        (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>()
    };
    let longest = square(a, b).max(square(b, c)).max(square(c, a));
    let edge = |to: [f64; 3]| [0, 1, 2].map(|axis| to[axis] - a[axis]);
    let area = cross(edge(b), edge(c));
    dot(area, area).sqrt() < THIN * longest
}

/// How a mesh is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Whether facets have their own normals alone.
    pub is_flat: bool,
    /// The rotation of the mesh about the origin, by rows.
    pub rotation: [[f64; 3]; 3],
}

impl Default for View {
    /// Smooth, from +z.
    fn default() -> Self {
        Self { is_flat: false, rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] }
    }
}

impl View {
    /// A vector of the mesh, as the camera has it.
    #[must_use]
    pub fn turned(&self, vector: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| dot(row, vector))
    }
}

/// The facets of a mesh with their normals.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// The facets with an area.
    pub facets: Vec<Facet>,
    /// The triangle of each facet.
    pub triangles: Vec<u32>,
    /// The unit normals at the corners of each facet; empty if they are the facets' own.
    pub normals: Vec<[[f64; 3]; 3]>,
}

impl Surface {
    /// The surface of a mesh, in a unit in which no coordinate exceeds 1.
    ///
    /// Normals are those of the file. A corner without, or whose normal has no direction or points
    /// to the back of its facet, has the one of [`corner_normals`]; a warning counts the latter. At
    /// slivers, whose direction is that of rounding, the file's normals count.
    /// Triangles without an area are left out.
    ///
    /// # Errors
    ///
    /// If a corner does not exist or is not finite, or there is no triangle.
    pub fn new(file: &InputFile, mesh: &Mesh, view: &View) -> Result<Self> {
        let mut largest: f64 = 0.0;
        for (number, corners) in mesh.triangles().enumerate() {
            let corners = corners?;
            if !corners.iter().flatten().all(|value| value.is_finite()) {
                return Err(broken(format!("facet {number} has a corner that is not finite")));
            }
            largest = corners.iter().flatten().fold(largest, |most, value| most.max(value.abs()));
        }
        let count = mesh.triangles.len();
        if count == 0 {
            return Err(broken("it contains no triangle"));
        }
        // Scale to the mesh's own size, so that areas of very small and very large meshes stay in
        // range.
        let mut surface = Self {
            facets: Vec::with_capacity(count),
            triangles: Vec::with_capacity(count),
            normals: Vec::new(),
        };
        for (number, corners) in (0..).zip(mesh.triangles()) {
            let corners = corners?.map(|corner| view.turned(corner.map(|x| x / largest)));
            if let Some(facet) = Facet::new(corners) {
                surface.facets.push(facet);
                surface.triangles.push(number);
            }
        }
        if !view.is_flat {
            surface.normals = surface.smooth(file, mesh, view);
        }
        Ok(surface)
    }

    /// The normals at the corners.
    fn smooth(&self, file: &InputFile, mesh: &Mesh, view: &View) -> Vec<[[f64; 3]; 3]> {
        let (mut is_whole, mut wrong) = (true, 0_usize);
        let mut normals = Vec::with_capacity(self.facets.len());
        for (facet, number) in self.facets.iter().zip(&self.triangles) {
            let number = *number as usize;
            let is_thin = is_thin(facet);
            normals.push(mesh.normals.at(number, mesh.triangles[number]).map(|of_file| {
                let normal = view.turned(of_file?.map(f64::from));
                let length = dot(normal, normal).sqrt();
                let is_right = length.is_normal() && (is_thin || dot(normal, facet.normal) > 0.0);
                wrong += usize::from(!is_right);
                is_right.then(|| normal.map(|x| x / length))
            }));
            is_whole &= normals.last().is_some_and(|three| three.iter().all(Option::is_some));
        }
        if wrong > 0 {
            file.warn(format!(
                "normals that have no direction or point to the back of their facet are replaced: \
                 {wrong}"
            ));
        }
        let own = if is_whole { Vec::new() } else { corner_normals(&self.facets) };
        let corner = |facet: usize, k: usize| {
            let found: Option<[f64; 3]> = normals[facet][k];
            found.unwrap_or_else(|| own[facet][k])
        };
        (0..normals.len()).map(|facet| [0, 1, 2].map(|k| corner(facet, k))).collect()
    }

    /// The normal of facet `number` at a point with these weights of its corners, not normalized.
    #[must_use]
    pub fn normal(&self, number: usize, [a, b, c]: [f64; 3]) -> [f64; 3] {
        self.normals.get(number).map_or(self.facets[number].normal, |corners| {
            [0, 1, 2].map(|axis| a * corners[0][axis] + b * corners[1][axis] + c * corners[2][axis])
        })
    }

    /// Checks that the camera sees the front.
    ///
    /// # Errors
    ///
    /// If most of what the camera at +z sees faces away.
    pub fn check_front(&self) -> Result<()> {
        if faces_away(&self.facets) {
            return Err(Error::new(
                "most of what the camera at +z sees of it faces away",
                "reverse the order of the corners, or turn it",
            ));
        }
        Ok(())
    }
}

/// Samples across and down for [`faces_away`].
const COARSE: usize = 128;

/// Whether most of what the camera at +z meets first faces away from it: more than three fifths, so
/// that half does not depend on where samples fall.
fn faces_away(facets: &[Facet]) -> bool {
    let frame = Frame::new(facets, COARSE);
    let mut buffer = DepthBuffer::new(COARSE);
    for facet in facets {
        buffer.draw(&frame.place(facet));
    }
    let mut is_shown = vec![false; COARSE * COARSE];
    for facet in facets.iter().filter(|facet| facet.projected_area > 0.0) {
        buffer.visit_seen(&frame.place(facet), |place, _| is_shown[place] = true);
    }
    let shown = is_shown.iter().filter(|is_shown| **is_shown).count();
    5 * shown < 2 * buffer.covered()
}
