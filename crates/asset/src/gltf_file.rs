//! glTF files (.glb, .gltf).

use crate::accessor::{Accessors, broken};
use crate::asset::Asset;
use crate::{buffers, gltf_materials, gltf_meshes};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use gltf::{Document, Gltf};

/// The extensions that are read, or that change nothing about a picture of an object.
const KNOWN: [&str; 6] = [
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    "KHR_materials_variants",
    "KHR_xmp_json_ld",
    "KHR_animation_pointer",
];

/// Reads a file with its buffers and textures.
pub(crate) fn read(file: &InputFile) -> Result<Asset> {
    let bytes = file.bytes()?;
    let Gltf { document, blob } = parse(file, &bytes)?;
    drop(bytes);
    let buffers = buffers::all(file, &document, blob)?;
    let accessors = Accessors { buffers: &buffers };
    let mut asset = gltf_meshes::read(file, &document, &accessors)?;
    gltf_materials::read(file, &document, &accessors, &mut asset)?;
    Ok(asset)
}

/// The parsed file, whose extensions are known, or else named in a warning.
fn parse(file: &InputFile, bytes: &[u8]) -> Result<Gltf> {
    let fault = |error: gltf::Error| match error {
        gltf::Error::Validation(faults) => {
            let named = |(path, error)| format!("`{path}`: {error}");
            let first = faults.into_iter().next().map(named).unwrap_or_default();
            broken(format!("it is no valid glTF file ({first})"))
        }
        error => broken(format!("it is not a complete glTF file ({error})").replace('\n', " ")),
    };
    let Gltf { document, blob } = Gltf::from_slice_without_validation(bytes).map_err(fault)?;
    let mut root = document.into_json();
    if let Some(name) = root.extensions_required.iter().find(|name| !is_known(name)) {
        let what = format!("it requires the extension {name}, which is not supported");
        return Err(Error::new(what, "export it without compression and extensions"));
    }
    let ignored: Vec<&str> =
        root.extensions_used.iter().map(String::as_str).filter(|name| !is_known(name)).collect();
    if !ignored.is_empty() {
        file.warn(format!(
            "extensions that may change its look are ignored: {}",
            ignored.join(", ")
        ));
    }
    // The library's validation expects that these exist.
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut places = primitives.flat_map(|primitive| primitive.attributes.values());
    if places.any(|place| place.value() >= root.accessors.len()) {
        return Err(broken("a mesh names an accessor that does not exist"));
    }
    for (number, image) in root.images.iter_mut().enumerate() {
        if image.uri.is_none() && image.buffer_view.is_none() {
            return Err(broken(format!("its image {number} has no bytes")));
        }
        // Not needed here, and by the library.
        image.mime_type.get_or_insert_with(|| gltf::json::image::MimeType("image/png".to_owned()));
    }
    // Known here, and not to the library.
    root.extensions_required.clear();
    let document = Document::from_json(root).map_err(fault)?;
    Ok(Gltf { document, blob })
}

fn is_known(name: &str) -> bool {
    KNOWN.contains(&name)
}
