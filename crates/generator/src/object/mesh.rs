//! Meshes (.obj, .stl, .ply): their triangles and their surface.

use crate::object::mesh_data::Mesh;
use crate::object::surface::{Surface, View};
use crate::object::{mesh_obj, mesh_ply, mesh_stl};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;

/// The triangles in a file, and what it states at their corners.
///
/// # Errors
///
/// If the file is broken or does not match its header, a face has fewer than three corners or is not
/// covered by a fan of triangles, or there are more than 2²² corners or triangles.
pub fn load(file: &InputFile) -> Result<Mesh> {
    match file.extension().as_str() {
        "obj" => mesh_obj::read(file),
        "stl" => mesh_stl::read(file),
        _ => mesh_ply::read(file),
    }
}

/// The surface of the mesh in a file. Corners run counterclockwise as seen from outside.
///
/// # Errors
///
/// Those of [`load`]; if a corner does not exist or is not finite, or most of what the camera sees
/// faces away.
pub fn surface(file: &InputFile, view: &View) -> Result<Surface> {
    let surface = Surface::new(file, &load(file)?, view)?;
    surface.check_front()?;
    Ok(surface)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write;

    /// Largest number of bytes that a reader may hold for each corner.
    const MOST: usize = 64;

    /// A grid of corners, with two facets for each.
    fn net(side: u32) -> (Vec<[u32; 2]>, Vec<[u32; 3]>) {
        let corners = (0..side).flat_map(|y| (0..side).map(move |x| [x, y])).collect();
        let cells = (0..side - 1).flat_map(|y| (0..side - 1).map(move |x| y * side + x));
        let facets = |k| [[k, k + 1, k + side], [k + 1, k + side + 1, k + side]];
        (corners, cells.flat_map(facets).collect())
    }

    #[test]
    fn readers_keep_64_bytes_of_a_corner() {
        let (corners, facets) = net(100);
        let (mut obj, mut stl) = (String::new(), "solid net\n".to_owned());
        let mut ply = format!(
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
             property float z\nelement face {}\nproperty list uchar int vertex_indices\n\
             end_header\n",
            corners.len(),
            facets.len()
        );
        for [x, y] in &corners {
            writeln!(obj, "v {x} {y} 0").expect("text");
            writeln!(ply, "{x} {y} 0").expect("text");
        }
        for facet in &facets {
            let [a, b, c] = facet.map(|k| k + 1);
            writeln!(obj, "f {a} {b} {c}").expect("text");
            writeln!(ply, "3 {} {} {}", facet[0], facet[1], facet[2]).expect("text");
            writeln!(stl, "facet normal 0 0 1\nouter loop").expect("text");
            for [x, y] in facet.map(|k| corners[k as usize]) {
                writeln!(stl, "vertex {x} {y} 0").expect("text");
            }
            writeln!(stl, "endloop\nendfacet").expect("text");
        }
        stl.push_str("endsolid net\n");
        let folder = tempfile::tempdir().expect("a folder");
        let expected: Vec<_> = facets
            .iter()
            .map(|facet| {
                facet.map(|k| corners[k as usize]).map(|[x, y]| [f64::from(x), f64::from(y), 0.0])
            })
            .collect();
        for (name, text) in [("net.obj", obj), ("net.ply", ply), ("net.stl", stl)] {
            let path = folder.path().join(name);
            std::fs::write(&path, text).expect("a file");
            let mesh = load(&path.into()).expect("a mesh");
            let found: Result<Vec<_>> = mesh.triangles().collect();
            assert_eq!(found.as_ref(), Ok(&expected), "{name}");
            let kept = 24 * mesh.corners.capacity() + 12 * mesh.triangles.capacity();
            assert!(kept <= MOST * mesh.corners.len(), "{name}: {kept} bytes");
        }
    }
}
