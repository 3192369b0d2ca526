//! Scene files of objects with shadows.

use super::options::{input_file, view_named};
use super::shadows::{DEGREE, Packing, SIZE};
use eigenshade_cli::messages::grouped;
use eigenshade_cli::output;
use eigenshade_generator::object::surface::View;
use eigenshade_generator::scene_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::output::writable;
use eigenshade_model::shipped;
use eigenshade_shading::presets::Source;
use eigenshade_shadows::light_root::Turns;
use eigenshade_shadows::packed::Compression;
use eigenshade_table::light;
use serde::Deserialize;
use std::fmt;
use std::path::{Path, PathBuf};

/// A scene of an object with shadows.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ObjectScene {
    geometry: Geometry,
    #[serde(default)]
    light: Light,
    material: Material,
    #[serde(default)]
    basis: Basis,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Geometry {
    /// A mesh.
    object: String,
    /// Pixels across.
    size: Option<usize>,
    /// The side that the camera sees, as `--view`.
    view: Option<String>,
    /// Whether facets are flat, as `--flat`.
    #[serde(default)]
    flat: bool,
}

#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Light {
    degree: Option<usize>,
    /// A light CSV in place of the shipped lights.
    database: Option<String>,
    rotation: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Material {
    /// A material CSV in place of the shipped materials.
    database: Option<String>,
    name: String,
}

#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
struct Basis {
    codes: Option<usize>,
}

impl ObjectScene {
    /// The scene of a file, if it is one of an object with shadows.
    pub fn read(file: &InputFile) -> Result<Option<Self>> {
        let text = scene_file::text(file)?;
        if !scene_file::has_object(&text) {
            return Ok(None);
        }
        scene_file::from_toml(&text, file.path()).map(Some)
    }

    /// Packs the object into a file.
    pub fn pack(&self, scene: &InputFile, out: &Path) -> Result<()> {
        let folder = scene.folder();
        let in_scene = |error: Error| error.in_file(scene.path());
        let object = folder.join(&self.geometry.object);
        let databases = [&self.light.database, &self.material.database];
        let databases = databases.map(|name| name.as_ref().map(|name| folder.join(name)));
        let inputs: Vec<PathBuf> = [scene.path().to_owned(), object.clone()]
            .into_iter()
            .chain(databases.iter().flatten().cloned())
            .collect();
        output::refuse_collisions([out], inputs)?;
        writable(out)?;
        let [lights, materials] = databases;
        let lights = match lights {
            Some(path) => source(path.display()).lights()?,
            None => shipped::lights()?,
        };
        let name = &self.material.name;
        let material = match materials {
            Some(path) => source(format_args!("{}:{name}", path.display())),
            None => source(name),
        };
        if self.material.database.is_none() && !material.is_shipped() {
            let what = format!("material.name = \"{name}\" is not the name of a shipped material");
            return Err(in_scene(Error::new(what, "name the file in material.database")));
        }
        let size = within("geometry.size", self.geometry.size, SIZE, [2, 512]);
        let degree = within("light.degree", self.light.degree, DEGREE, [0, light::MAX_DEGREE]);
        let codes = Compression::default().codes;
        let codes = within("basis.codes", self.basis.codes, codes, [1, 65_535]);
        let degree = degree.map_err(in_scene)?;
        if lights.degree < degree {
            let what = format!("light.degree = {degree}, and its database has {}", lights.degree);
            return Err(in_scene(Error::new(what, "give a lower degree or another database")));
        }
        let packing = Packing {
            file: &input_file(object),
            view: self.view().map_err(in_scene)?,
            size: size.map_err(in_scene)?,
            degree,
            material: Some(&material),
            lights: &lights,
            turns: self.turns().map_err(in_scene)?,
            codes: codes.map_err(in_scene)?,
        };
        let packed = packing.pack()?;
        output::write_all(Some(out), &packed.bytes)?;
        let covered = grouped(packed.covered);
        output::report(format!(
            "{:<12} {size} x {size}, {covered} with an object\n{:<12} {}\n{}",
            "pixels",
            "bytes",
            grouped(packed.bytes.len()),
            packed.notes(),
            size = packing.size,
        ))
    }

    fn view(&self) -> Result<View> {
        let mut view = View { is_flat: self.geometry.flat, ..View::default() };
        if let Some(name) = &self.geometry.view {
            let found = view_named(name).ok_or_else(|| {
                let what = format!("geometry.view = \"{name}\"");
                Error::new(what, "give front, back, right, left, top or bottom")
            })?;
            view.rotation = found;
        }
        Ok(view)
    }

    fn turns(&self) -> Result<Turns> {
        let name = self.light.rotation.as_deref().unwrap_or("any");
        let degrees = name.strip_prefix("tilts ").and_then(|degrees| degrees.trim().parse().ok());
        match degrees {
            _ if name == "any" => Ok(Turns::All),
            Some(degrees) if degrees > 0.0 && degrees <= 90.0 => {
                Ok(Turns::Tilts(f64::to_radians(degrees)))
            }
            _ => {
                let what = format!("light.rotation = \"{name}\"");
                Err(Error::new(what, "give \"any\", or up to 90 degrees as in \"tilts 45\""))
            }
        }
    }
}

/// A number of the scene, or the default.
fn within(
    name: &str,
    value: Option<usize>,
    default: usize,
    [least, most]: [usize; 2],
) -> Result<usize> {
    let value = value.unwrap_or(default);
    if (least..=most).contains(&value) {
        return Ok(value);
    }
    Err(Error::new(format!("{name} = {value}"), format!("give {least} to {most}")))
}

/// A source as options name it.
fn source(text: impl fmt::Display) -> Source {
    let Ok(source) = text.to_string().parse();
    source
}
