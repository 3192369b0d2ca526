//! Meshes (.obj, .stl, .ply): the normals of their facets under orthographic view.

use crate::error::{Error, Result};
use std::io::Cursor;
use std::path::Path;

/// Triangles, as the files' readers give them.
type Triangles = Vec<[[f64; 3]; 3]>;

/// The normal of each facet that faces the camera, x right, y up, z toward it, weighted
/// by its projected area.
///
/// Facets count as seen if they face the camera: objects are convex, so none hides
/// another. Corners run counterclockwise seen from outside. Facets without area are left
/// out.
///
/// # Errors
///
/// A file that is broken or promises more than it holds, a corner that does not exist or
/// is not finite.
pub fn read(path: &Path) -> Result<Vec<([f64; 3], f64)>> {
    let bytes = std::fs::read(path).map_err(|error| Error::io(path, &error))?;
    let extension = path.extension().and_then(|one| one.to_str()).unwrap_or_default();
    let triangles = match extension.to_ascii_lowercase().as_str() {
        "obj" => obj(&bytes),
        "stl" => stl(&bytes),
        _ => super::mesh_ply::read(&bytes),
    };
    let triangles = triangles.map_err(|error| error.in_file(path))?;
    if triangles.is_empty() {
        return Err(broken("there is no triangle in it").in_file(path));
    }
    let mut largest: f64 = 0.0;
    for (number, corners) in triangles.iter().enumerate() {
        if !corners.iter().flatten().all(|value| value.is_finite()) {
            return Err(
                broken(format!("facet {number} has a corner that is not finite")).in_file(path)
            );
        }
        largest = corners.iter().flatten().fold(largest, |most, value| most.max(value.abs()));
    }
    // In its own size, so that areas of small and of large meshes are numbers.
    let scaled = triangles.iter().map(|corners| corners.map(|corner| corner.map(|x| x / largest)));
    let pairs = scaled.filter_map(|corners| facet(&corners)).collect();
    Ok(pairs)
}

/// The normal of a facet and its projected area, if it faces the camera.
///
/// Edges are scaled by the largest first, so that small facets keep their direction.
fn facet(&[a, b, c]: &[[f64; 3]; 3]) -> Option<([f64; 3], f64)> {
    let edge = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
    let (u, v) = (edge(b), edge(c));
    let scale = u.iter().chain(&v).fold(0.0, |most: f64, value| most.max(value.abs()));
    let ([u0, u1, u2], [v0, v1, v2]) = (u.map(|x| x / scale), v.map(|x| x / scale));
    let normal = [u1 * v2 - u2 * v1, u2 * v0 - u0 * v2, u0 * v1 - u1 * v0];
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    // Below rounding of the products the direction means nothing; NaN if all edges are 0.
    let has_area = length > 4.0 * f64::EPSILON;
    (has_area && normal[2] > 0.0).then_some((normal, 0.5 * normal[2] * scale * scale))
}

/// A fault of the file, to be exported anew.
pub(crate) fn broken(what: impl Into<String>) -> Error {
    Error::new(what, "export the mesh again, as triangles")
}

fn obj(bytes: &[u8]) -> Result<Triangles> {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(bytes), &options, |_| {
        // Materials are not wanted.
        Ok((Vec::new(), Default::default()))
    })
    .map_err(|error| broken(format!("it is no whole OBJ ({error})")))?;
    let mut triangles = Vec::new();
    for model in models {
        let corners: &[[f64; 3]] = model.mesh.positions.as_chunks().0;
        for indices in model.mesh.indices.as_chunks::<3>().0 {
            let at = |index: u32| {
                corners
                    .get(index as usize)
                    .copied()
                    .ok_or_else(|| broken(format!("corner {index} does not exist")))
            };
            triangles.push([at(indices[0])?, at(indices[1])?, at(indices[2])?]);
        }
    }
    Ok(triangles)
}

fn stl(bytes: &[u8]) -> Result<Triangles> {
    if !bytes.starts_with(b"solid") {
        // 80 bytes of header, a count, 50 bytes a facet.
        let count = bytes.get(80..84).and_then(|count| count.try_into().ok());
        let count = count.map(u32::from_le_bytes).map_or(0, u64::from);
        let (expected, found) = (84 + 50 * count, bytes.len() as u64);
        if found < 84 || found < expected {
            return Err(broken(format!("{expected} bytes promised, {found} found")));
        }
    }
    let mesh = stl_io::create_stl_reader(&mut Cursor::new(bytes))
        .and_then(Iterator::collect::<std::io::Result<Vec<_>>>)
        .map_err(|error| broken(format!("it is no whole STL ({error})")))?;
    Ok(mesh.iter().map(|facet| facet.vertices.map(|corner| corner.0.map(f64::from))).collect())
}
