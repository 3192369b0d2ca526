//! Objects with their shadows: `render --shadows`, `pack-object --shadows` and scenes with an object.

use eigenshade_asset::asset::Asset;
use eigenshade_cli::messages::{grouped, print_message, progress_bar};
use eigenshade_generator::object::mesh;
use eigenshade_generator::object::surface::{Surface, View};
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_shading::presets::Source;
use eigenshade_shadows::light_root::Turns;
use eigenshade_shadows::material::{MOST_ORDER, Material};
use eigenshade_shadows::object::Object;
use eigenshade_shadows::packed::Compression;

/// The order of the series of shipped materials.
const ORDER: usize = 12;

/// Pixels across a packed object, and the degree of its light.
pub const SIZE: usize = 240;
pub const DEGREE: usize = 9;

/// Contents of a packed object.
pub struct Packing<'a> {
    pub file: &'a InputFile,
    pub view: View,
    /// Pixels across.
    pub size: usize,
    /// The degree of the light.
    pub degree: usize,
    pub material: &'a Source,
    /// The lights that it is made for, and how they turn.
    pub lights: &'a Lights,
    pub turns: Turns,
    /// The most codes.
    pub codes: usize,
}

/// A packed object.
pub struct PackedObject {
    pub bytes: Vec<u8>,
    /// The number of its pixels.
    pub covered: usize,
    codes: usize,
    degree: usize,
}

impl Packing<'_> {
    /// Packs the object.
    pub fn pack(&self) -> Result<PackedObject> {
        let parts = Parts::of(self.material)?;
        let object = object(self.file, &self.view, self.size, self.degree, &parts)?;
        let compression = Compression { codes: self.codes, ..Compression::default() };
        let bytes = object.packed(self.lights, self.turns, &parts.shares, compression)?;
        let covered = object.pixels.len();
        Ok(PackedObject { bytes, covered, codes: self.codes.min(covered), degree: self.degree })
    }
}

impl PackedObject {
    /// Lines of a report.
    pub fn notes(&self) -> String {
        let each = self.bytes.len() as f64 / self.covered as f64;
        format!(
            "{:<12} {each:.1}\n{:<12} {}\n{:<12} {}\n",
            "a pixel",
            "colors",
            grouped(self.codes),
            "degree",
            self.degree,
        )
    }
}

/// A material, and the shares of its parts in the channels.
pub struct Parts {
    channels: Vec<Vec<f64>>,
    pub shares: Vec<[f64; 3]>,
}

impl Parts {
    /// One part if the material has no color, and else one for each channel.
    pub fn of(material: &Source) -> Result<Self> {
        let order = if material.is_shipped() { ORDER } else { usize::MAX };
        let materials = material.materials(order)?;
        if materials.order > MOST_ORDER {
            print_message(format_args!(
                "warning: coefficients of orders above {MOST_ORDER} are left out: an object with \
                 shadows takes no more"
            ));
        }
        let Named { rgb: [r, g, b], .. } = material.only(materials.entries)?;
        Ok(if r == g && g == b {
            Self { channels: vec![r], shares: vec![[1.0; 3]] }
        } else {
            let shares = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            Self { channels: vec![r, g, b], shares }
        })
    }
}

/// The object of a mesh with its shadows.
pub fn object(
    file: &InputFile,
    view: &View,
    size: usize,
    degree: usize,
    parts: &Parts,
) -> Result<Object> {
    let made = || {
        let surface = match Asset::read(file)? {
            Some(asset) => Surface::new(file, &asset.mesh, view)?,
            None if file.is_mesh() => mesh::surface(file, view)?,
            None => {
                let what = "only a mesh has shadows";
                return Err(Error::new(what, "give an .obj, .stl, .ply, .glb or .gltf"));
            }
        };
        let materials: Vec<Material<'_>> =
            parts.channels.iter().map(|channel| Material::Series(channel)).collect();
        let progress = progress_bar("pixels with shadows", Object::steps(size));
        Object::new(&surface, size, degree, &materials, &progress)
    };
    made().map_err(|error: Error| error.in_file(file.path()))
}
