//! Wavefront files with materials (.mtl).
//!
//! `Kd` is a linear base color, as Blender writes it, `map_Kd` a texture in sRGB. `Pr` and `Pm` are
//! roughness and metallic; without `Pr`, the roughness is that of the exponent `Ns` as in Blender,
//! 1 - √(Ns/1000). Other statements are ignored.

use crate::accessor::broken;
use crate::asset::{Asset, Map, Material};
use crate::buffers::beside;
use crate::image::Image;
use crate::texture::{Kind, Texture};
use eigenshade_generator::object::mesh;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::collections::HashMap;
use std::io::Cursor;

/// Reads an object with its materials; `None` if it names no file of materials.
pub(crate) fn read(file: &InputFile) -> Result<Option<Asset>> {
    let mut mesh = mesh::load(file)?;
    if mesh.libraries.is_empty() {
        return Ok(None);
    }
    let mut asset = Asset { backs_hide: true, ..Asset::default() };
    // Triangles before the first `usemtl`.
    asset.materials.push(Material::matte([0.8; 3]));
    let mut of_name = HashMap::new();
    for name in &mesh.libraries {
        let named = |error: Error| error.of(format_args!("`{name}`"));
        let library = beside(file, name);
        let text = library.bytes_of_text().map_err(named)?;
        let (materials, _) = tobj::load_mtl_buf(&mut Cursor::new(text))
            .map_err(|error| named(broken(format!("it is no complete MTL file ({error})"))))?;
        for material in materials {
            let found = converted(&library, &material, &mut asset).map_err(named)?;
            of_name.insert(material.name, asset.materials.len() as u32);
            asset.materials.push(found);
        }
    }
    asset.material_of = vec![0; mesh.triangles.len()];
    for (first, name) in &mesh.materials {
        let number = of_name.get(name).ok_or_else(|| {
            let what = format!("its material `{name}` is in none of its .mtl files");
            Error::new(what, "export the object again with its materials")
        })?;
        asset.material_of[*first as usize..].fill(*number);
    }
    asset.coordinates[0] = std::mem::take(&mut mesh.coordinates);
    asset.mesh = mesh;
    Ok(Some(asset))
}

fn converted(
    library: &InputFile,
    material: &tobj::Material,
    asset: &mut Asset,
) -> Result<Material> {
    let share = |number: f32| match number {
        0.0..=1.0 => Ok(number),
        _ => Err(broken(format!("`{}` has a number of {number}, not in [0, 1]", material.name))),
    };
    let unknown = |key: &str| material.unknown_param.get(key);
    let number = |key: &str| unknown(key).and_then(|text| text.trim().parse::<f32>().ok());
    let [r, g, b] = material.diffuse.unwrap_or([0.8; 3]);
    let shininess = material.shininess.unwrap_or(250.0).clamp(0.0, 1000.0);
    let roughness = number("Pr").unwrap_or(1.0 - (shininess / 1000.0).sqrt());
    let mut map = |name: &str, kind: Kind| -> Result<Option<Map>> {
        // Options, as in `-s 1 1 1 name`, come first.
        let name =
            if name.starts_with('-') { name.rsplit(' ').next().unwrap_or(name) } else { name };
        let image = beside(library, name).bytes().and_then(|bytes| Image::decode(&bytes));
        let image = image.map_err(|error| error.of(format_args!("`{name}`")))?;
        asset.textures.push(Texture::new(image, kind));
        Ok(Some(Map::plain(asset.textures.len() - 1)))
    };
    let base_color_map = match &material.diffuse_texture {
        Some(name) => map(name, Kind::Color)?,
        None => None,
    };
    let normal_map = match unknown("norm") {
        Some(name) => map(name, Kind::Normals)?.map(|map| (map, 1.0)),
        None => None,
    };
    if material.normal_texture.is_some() {
        library.warn(format!("the bump map of `{}` is ignored", material.name));
    }
    if material.dissolve_texture.is_some() || material.dissolve.is_some_and(|d| d < 1.0) {
        library.warn(format!("the transparency of `{}` is ignored", material.name));
    }
    Ok(Material {
        base_color: [share(r)?, share(g)?, share(b)?, 1.0],
        metallic: share(number("Pm").unwrap_or(0.0))?,
        roughness: share(roughness)?,
        base_color_map,
        normal_map,
        ..Material::default()
    })
}
