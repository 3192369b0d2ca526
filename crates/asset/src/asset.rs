//! An object: triangles, materials and textures.

use crate::texture::Texture;
use crate::{gltf_file, wavefront};
use eigenshade_generator::object::mesh;
use eigenshade_generator::object::mesh_data::{Attribute, Mesh};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;

/// The most triangles that an object with materials may have.
pub const MOST_TRIANGLES: u64 = 500_000;

/// The extensions of files that may have materials of their own.
pub const EXTENSIONS: [&str; 4] = ["glb", "gltf", "obj", "ply"];

/// An object with materials of its own.
#[derive(Clone, Debug, Default)]
pub struct Asset {
    /// The triangles, with normals where the file has them.
    pub mesh: Mesh,
    /// Two sets of texture coordinates, (0, 0) at the upper left corner.
    pub coordinates: [Attribute<2>; 2],
    /// Linear colors and opacities, which multiply the base color.
    pub colors: Attribute<4>,
    /// Tangents, and the sign of the bitangent; 0 where there is none.
    pub tangents: Attribute<4>,
    /// The number of the material of each triangle.
    pub material_of: Vec<u32>,
    /// The materials.
    pub materials: Vec<Material>,
    /// The textures.
    pub textures: Vec<Texture>,
    /// Whether a triangle seen from behind hides what it covers, unless it is double-sided. In glTF
    /// it is not there.
    pub backs_hide: bool,
}

/// A material of glTF: a base color, metallic and roughness.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Linear base color and opacity, which multiply those of the texture.
    pub base_color: [f32; 4],
    /// Metallic, which multiplies the texture's.
    pub metallic: f32,
    /// Roughness, which multiplies the texture's.
    pub roughness: f32,
    /// Base color and opacity.
    pub base_color_map: Option<Map>,
    /// Roughness in green, metallic in blue.
    pub metallic_roughness_map: Option<Map>,
    /// Occlusion in red, and how much of it counts.
    pub occlusion_map: Option<(Map, f32)>,
    /// Normals in tangent space, and the factor of their x and y.
    pub normal_map: Option<(Map, f32)>,
    /// The opacity below which the object has a hole; without, it has none.
    pub cutoff: Option<f32>,
    /// Whether both sides of a triangle are seen.
    pub is_double_sided: bool,
}

/// A texture on an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Map {
    /// The number of the texture.
    pub texture: usize,
    /// The set of texture coordinates, 0 or 1.
    pub set: usize,
    /// The rows of a matrix that coordinates (u, v, 1) are multiplied by.
    pub transform: [[f32; 3]; 2],
    /// How u and v outside 0 to 1 are looked up.
    pub wrap: [Wrap; 2],
}

/// How coordinates outside a texture are looked up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// The texture repeats.
    Repeat,
    /// The texture repeats, mirrored every second time.
    Mirror,
    /// The nearest texel at the edge.
    Clamp,
}

impl Map {
    /// The whole texture, repeated.
    #[must_use]
    pub fn plain(texture: usize) -> Self {
        let transform = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        Self { texture, set: 0, transform, wrap: [Wrap::Repeat; 2] }
    }

    /// Coordinates on the texture.
    #[must_use]
    pub fn place(&self, [u, v]: [f32; 2]) -> [f32; 2] {
        self.transform.map(|[a, b, c]| a * u + b * v + c)
    }
}

impl Default for Material {
    /// glTF's default: white, rough metal.
    fn default() -> Self {
        Self {
            base_color: [1.0; 4],
            metallic: 1.0,
            roughness: 1.0,
            base_color_map: None,
            metallic_roughness_map: None,
            occlusion_map: None,
            normal_map: None,
            cutoff: None,
            is_double_sided: false,
        }
    }
}

impl Material {
    /// A matte material of a linear color.
    #[must_use]
    pub fn matte([r, g, b]: [f32; 3]) -> Self {
        Self { base_color: [r, g, b, 1.0], metallic: 0.0, ..Self::default() }
    }
}

impl Asset {
    /// Reads an object with materials: glTF, or an `.obj` that names an `.mtl`, or a `.ply` with
    /// colors. `None` if the file has no materials or colors, or is of another kind.
    ///
    /// # Errors
    ///
    /// If the file, or one that it names, cannot be read or is broken; or it has more than 500,000
    /// triangles or is otherwise too large.
    pub fn read(file: &InputFile) -> Result<Option<Self>> {
        let named = |error: Error| error.in_file(file.path());
        let asset = match file.extension().as_str() {
            "glb" | "gltf" => Some(gltf_file::read(file).map_err(named)?),
            "obj" => wavefront::read(file).map_err(named)?,
            "ply" => Self::with_colors(file).map_err(named)?,
            _ => None,
        };
        if let Some(asset) = &asset {
            let triangles = asset.mesh.triangles.len() as u64;
            file.at_most(triangles, MOST_TRIANGLES, "triangles with materials")?;
            if asset.colors.values.iter().flatten().any(|color| !color.is_finite()) {
                let what = "the color of a corner is not finite";
                return Err(Error::new(what, "export the object again").in_file(file.path()));
            }
        }
        Ok(asset)
    }

    /// A polygon file with colors, which are matte.
    fn with_colors(file: &InputFile) -> Result<Option<Self>> {
        let mut mesh = mesh::load(file)?;
        let values = std::mem::take(&mut mesh.colors.values);
        if values.is_empty() {
            return Ok(None);
        }
        let material_of = vec![0; mesh.triangles.len()];
        Ok(Some(Self {
            mesh,
            colors: Attribute { values, places: Vec::new() },
            material_of,
            materials: vec![Material::matte([1.0; 3])],
            backs_hide: true,
            ..Self::default()
        }))
    }
}
