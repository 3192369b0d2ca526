//! Meshes (.obj, .stl, .ply): the normals of what the camera sees of their facets.

use super::facet::Facet;
use super::visibility::seen_shares;
use super::{mesh_ply, mesh_stl};
use crate::error::{Error, Result};
use std::io::Cursor;
use std::path::Path;

/// Triangles, as the files' readers give them.
pub(crate) type Triangles = Vec<[[f64; 3]; 3]>;

/// Samples across and down the picture in which facets are looked for: 8 MiB.
const SAMPLES: usize = 1024;

/// The normal of each facet that the camera sees under orthographic view, x right, y up, z
/// toward it, weighted by the projected area of the part that is seen.
///
/// What another facet hides does not count, to the accuracy of [`seen_shares`] with 1024 x
/// 1024 samples; a convex object's facets count with their exact areas. Corners run
/// counterclockwise seen from outside: a facet that faces away hides what is behind it and
/// does not count itself. Normals are the facets' own: smoothed ones in the file (`vn`; `nx`,
/// `ny`, `nz`) are not used. Facets without area are left out.
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
        "stl" => mesh_stl::read(bytes),
        _ => mesh_ply::read(&bytes),
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
    let facets: Vec<Facet> = scaled.filter_map(Facet::new).collect();
    let shares = seen_shares(&facets, SAMPLES);
    let seen = facets.iter().zip(shares).filter(|(_, share)| *share > 0.0);
    Ok(seen.map(|(facet, share)| (facet.normal, share * facet.projected_area)).collect())
}

/// A fault of the file, to be exported anew.
pub(crate) fn broken(what: impl Into<String>) -> Error {
    Error::new(what, "export the mesh again, as triangles")
}

fn obj(bytes: &[u8]) -> Result<Triangles> {
    // The library takes faces of fewer corners for lines and points, and leaves them out.
    for (number, line) in bytes.split(|&byte| byte == b'\n').enumerate() {
        let line = String::from_utf8_lossy(line);
        let mut words = line.split_whitespace();
        if words.next() == Some("f") && !line.contains('\\') && words.count() < 3 {
            return Err(broken(format!(
                "line {} has a face of fewer than three corners",
                number + 1
            )));
        }
    }
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
