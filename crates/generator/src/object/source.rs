//! Reads the normals of an object that a scene file names.

use crate::object::geometry::{Geometry, WeightedNormals};
use crate::object::{density, mesh, normal_map};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals;
use eigenshade_table::scene;

/// Reads the geometry of a scene of the given `degree`. Paths are relative to the folder of the
/// scene file, and each file is read within the scene file's budget.
///
/// # Errors
///
/// If the format is unknown, a mask or a density is given where it has no meaning, or a density is
/// missing, or the file itself has an error.
pub fn read(geometry: &scene::Geometry, degree: usize, scene: &InputFile) -> Result<Geometry> {
    let folder = scene.folder();
    let name = geometry.normals.as_str();
    let path = folder.join(name);
    let file = scene.other(&path);
    let extension = path.extension().and_then(|one| one.to_str()).unwrap_or_default();
    let extension = extension.to_ascii_lowercase();
    if geometry.mask.is_some() && extension != "png" {
        return Err(Error::new(
            format!("geometry.mask with normals = \"{name}\""),
            "leave it out: only a normal map takes a mask",
        ));
    }
    if geometry.density.is_some() != (name == "slant-density") {
        return Err(Error::new(
            "geometry.density and normals = \"slant-density\" go together",
            "set both or neither",
        ));
    }
    let pairs = match (name, extension.as_str()) {
        ("sphere", _) => return Ok(Geometry::Sphere),
        ("slant-density", _) => {
            let density = geometry.density.as_deref().unwrap_or_default();
            density::read(density, folder, degree)?
        }
        (_, "csv") => normals::read_weighted_normals(file)?,
        (_, "obj" | "stl" | "ply") => mesh::read(file)?,
        (_, "png") => {
            let mask = geometry.mask.as_ref().map(|mask| folder.join(mask));
            normal_map::read(file, mask.as_deref())?
        }
        _ => {
            return Err(Error::new(
                format!("geometry.normals = \"{name}\" is of no known kind"),
                "give `sphere`, `slant-density`, or a .csv, .obj, .stl, .ply or .png",
            ));
        }
    };
    WeightedNormals::new(pairs).map(Geometry::Listed).map_err(|error| error.in_file(&path))
}
