//! Objects with their shadows: `render --shadows`, `pack-object --shadows` and scenes with an object.

use super::render::no_material;
use eigenshade_asset::asset::Asset;
use eigenshade_cli::messages::{grouped, print_message, progress_bar};
use eigenshade_generator::object::mesh;
use eigenshade_generator::object::surface::{Surface, View};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_shading::presets::Source;
use eigenshade_shadows::light_root::Turns;
use eigenshade_shadows::material::{MOST_ORDER, Material};
use eigenshade_shadows::object::Object;
use eigenshade_shadows::packed::Compression;
use eigenshade_shadows::textured::Textured;
use eigenshade_shadows::visibility::hidden_share;
use eigenshade_table::light;
use indicatif::ProgressBar;
use std::path::Path;

/// The order of the series of shipped materials.
const ORDER: usize = 12;

/// Pixels across a packed object, and the degree of its light.
pub const SIZE: usize = 240;
pub const DEGREE: usize = light::MAX_DEGREE;

/// Contents of a packed object.
pub struct Packing<'a> {
    pub file: &'a InputFile,
    pub view: View,
    /// Pixels across.
    pub size: usize,
    /// The degree of the light.
    pub degree: usize,
    /// None for those of the file.
    pub material: Option<&'a Source>,
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
        let compression = Compression { codes: self.codes, ..Compression::default() };
        let Some(material) = self.material else { return self.pack_own(compression) };
        let (parts, _) = Parts::of(material)?;
        let object =
            drawn(self.file, &self.view, self.size, &parts, |surface, parts, progress| {
                Object::new(surface, self.size, self.degree, parts, progress)
            })?;
        let bytes = object.packed(self.lights, self.turns, &parts.shares, compression)?;
        let covered = object.pixels.len();
        Ok(PackedObject { bytes, covered, codes: self.codes.min(covered), degree: self.degree })
    }

    /// Packs it in its own materials.
    fn pack_own(&self, compression: Compression) -> Result<PackedObject> {
        let asset =
            Asset::read(self.file)?.ok_or_else(|| no_material().in_file(self.file.path()))?;
        let object = Textured::new(self.file, asset, self.size, &self.view)?;
        let progress = progress_bar("pixels with shadows", Object::steps(self.size));
        let transports = object.transports(self.degree, &progress)?;
        progress.finish_and_clear();
        let bytes = transports.packed(self.lights, self.turns, compression)?;
        notes(&object).into_iter().for_each(print_message);
        let covered = object.pixels.len();
        let codes = self.codes.min(2 * covered);
        Ok(PackedObject { bytes, covered, codes, degree: self.degree })
    }
}

/// How far the one roughness of an object with shadows may be from that of its pixels, as a share.
const CLOSE: f32 = 0.15;

/// How an object in its own materials is drawn with shadows.
pub fn notes(object: &Textured) -> Vec<String> {
    let roughness = (!object.is_of_one_roughness(CLOSE)).then(|| {
        let ([low, high], mean) = (object.roughnesses, object.roughness);
        format!(
            "warning: shadows have one roughness, here the mean {mean:.2}; nine tenths of the \
             object have {low:.2} to {high:.2}"
        )
    });
    let occlusion = "occlusion maps are left out: shadows take their place";
    roughness.into_iter().chain(object.has_occlusion.then(|| occlusion.to_owned())).collect()
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
    /// One part if the material has no color, and else one for each channel; and the material.
    pub fn of(material: &Source) -> Result<(Self, Materials)> {
        let order = if material.is_shipped() { ORDER } else { usize::MAX };
        let materials = material.materials(order)?;
        if materials.order > MOST_ORDER {
            print_message(format_args!(
                "warning: coefficients of orders above {MOST_ORDER} are left out: an object with \
                 shadows takes no more"
            ));
        }
        let Materials { order, entries } = materials;
        let entry = material.only(entries)?;
        let [r, g, b] = entry.rgb.clone();
        let parts = if r == g && g == b {
            Self { channels: vec![r], shares: vec![[1.0; 3]] }
        } else {
            let shares = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            Self { channels: vec![r, g, b], shares }
        };
        Ok((parts, Materials { order, entries: vec![entry] }))
    }
}

/// Calls `draw` with the surface of a mesh, the parts of a material and a progress bar.
pub fn drawn<T>(
    file: &InputFile,
    view: &View,
    size: usize,
    parts: &Parts,
    draw: impl FnOnce(&Surface, &[Material<'_>], &ProgressBar) -> Result<T>,
) -> Result<T> {
    let made = || {
        let surface = surface(file, view)?.ok_or_else(|| {
            let what = "only a mesh has shadows";
            Error::new(what, "give an .obj, .stl, .ply, .glb or .gltf")
        })?;
        let materials: Vec<Material<'_>> =
            parts.channels.iter().map(|channel| Material::Series(channel)).collect();
        let progress = progress_bar("pixels with shadows", Object::steps(size));
        draw(&surface, &materials, &progress)
    };
    made().map_err(|error: Error| error.in_file(file.path()))
}

/// The surface of a mesh; none if the file is not one.
fn surface(file: &InputFile, view: &View) -> Result<Option<Surface>> {
    Ok(match Asset::read(file)? {
        Some(asset) => Some(Surface::new(file, &asset.mesh, view)?),
        None if file.is_mesh() => Some(mesh::surface(file, view)?),
        None => None,
    })
}

/// The least share of hidden light that is worth a warning.
const NOTICED: f64 = 0.005;

/// A warning if a mesh, which is drawn without shadows, hides light from itself.
pub fn warning(path: &Path, view: &View) -> Result<Option<String>> {
    // Its own warnings have been printed.
    let hidden =
        surface(&InputFile::new(path), view)?.map_or(0.0, |surface| hidden_share(&surface));
    Ok((hidden > NOTICED).then(|| {
        format!(
            "warning: shadows are left out: the object hides {:.0} % of uniform light from itself, \
             and sources shine through it; `--shadows` draws it with its shadows",
            (100.0 * hidden).max(1.0)
        )
    }))
}
