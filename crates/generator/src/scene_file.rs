//! Reads a scene file and its databases.

use crate::basis;
use crate::basis::choice::Choice;
use crate::highlights::{HighlightFiles, Highlights};
use crate::material::analytic;
use crate::material::brdf::Measure;
use eigenshade_model::database::{Lights, Materials, Named, name_remedy};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials_and_order};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::parallel;
use eigenshade_table::effect::Effects;
use eigenshade_table::highlights::MAX_SOURCES;
use eigenshade_table::scene::{self, is_share};
use eigenshade_table::{Scene, Table};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::DeTable;

/// A scene with the databases that it names.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// The lights, truncated to the scene's degree.
    pub lights: Lights,
    /// The materials, truncated to the scene's order.
    pub materials: Materials,
    /// The order that all material files reach, at least the scene's.
    pub order_of_file: usize,
    /// Sources and gloss for a build script, if the scene names them.
    pub highlights: Option<Highlights>,
}

/// A scene file: the scene of a table, and the files of its highlights, which no table holds.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    light: scene::Light,
    material: scene::Material,
    basis: scene::Basis,
    #[serde(default)]
    effects: scene::Effects,
    highlights: Option<HighlightFiles>,
}

impl File {
    fn parts(self) -> (Scene, Option<HighlightFiles>) {
        let Self { light, material, basis, effects, highlights } = self;
        (Scene { light, material, basis, effects }, highlights)
    }
}

impl Loaded {
    /// Makes the scene's table.
    ///
    /// # Errors
    ///
    /// The errors of [`basis::build`].
    pub fn build(&self) -> Result<Table> {
        self.chosen().map(|(table, _)| table)
    }

    /// Like [`build`](Self::build), and also reports what was chosen if the scene gives a
    /// tolerance.
    ///
    /// # Errors
    ///
    /// The errors of [`basis::build`].
    pub fn chosen(&self) -> Result<(Table, Option<Choice>)> {
        basis::chosen(&self.scene, &self.lights, &self.materials)
    }
}

/// Maximum size of a scene file in bytes, enough for a weight for each of ten thousand materials.
const LONGEST: u64 = 1 << 20;

/// Reads a scene file and the files that it names. Paths in the scene are relative to the scene
/// file.
///
/// # Errors
///
/// If a file is missing; a field is unknown, missing or out of range; a database is broken or does
/// not reach the degree or order; or a name is not in its database.
pub fn load(file: impl Into<InputFile>) -> Result<Loaded> {
    let file = file.into();
    let path = file.path();
    let text = text(&file)?;
    check_sphere(&text, path)?;
    let (scene, highlights) = from_toml::<File>(&text, path)?.parts();
    check(&scene, highlights.as_ref()).map_err(|error| error.in_file(path))?;
    let folder = file.folder();
    let is_missing = |name: &&String| !folder.join(name).exists();
    let missing = named_files(&scene, highlights.as_ref()).find(is_missing).cloned();
    if let Some(name) = missing {
        let place = folder.join(".").canonicalize().unwrap_or_else(|_| folder.to_owned());
        let what = format!(
            "it names the file `{name}`, which does not exist; relative paths in a scene start at \
             its folder, here {}",
            place.display()
        );
        return Err(Error::new(what, "copy the file there, or correct its path").in_file(path));
    }
    let lights = file.other(folder.join(&scene.light.database));
    let lights = read_lights(lights, Some(scene.light.degree))?;
    let databases = scene.material.database.iter().map(|path| folder.join(path));
    let order = scene.material.order;
    let (mut materials, order_of_file) = together(databases, |path| {
        if path.extension().is_some_and(|end| end == "toml") {
            return Ok((projected(path, order)?, order));
        }
        read_materials_and_order(file.other(path), Some(order))
    })?;
    if !scene.material.names.is_empty() {
        materials.entries = named(&materials, &scene.material.names)
            .map_err(|error| error.in_file(folder.join(scene.material.database.join(", "))))?;
    }
    let highlights = match &highlights {
        Some(files) => Some(Highlights::read(files, &file, &lights, &materials)?),
        None => None,
    };
    Ok(Loaded { scene, lights, materials, order_of_file, highlights })
}

/// The formulas of a file, projected to this order.
fn projected(path: &Path, order: usize) -> Result<Materials> {
    let surfaces = analytic::read(path)?;
    let project = |k: usize| surfaces[k].project(order, Measure::default()).material;
    Ok(Materials { order, entries: parallel::map(surfaces.len(), &(), project) })
}

/// The files from which the table of a scene file is made, starting with the scene file itself,
/// whether or not they exist. If the file is not a scene, only the file itself.
#[must_use]
pub fn inputs(path: &Path) -> Vec<PathBuf> {
    let text = InputFile::from(path).text().unwrap_or_default();
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut inputs = vec![path.to_owned()];
    if let Ok(file) = toml::from_str::<File>(&text) {
        let (scene, highlights) = file.parts();
        inputs.extend(named_files(&scene, highlights.as_ref()).map(|file| folder.join(file)));
    }
    inputs
}

/// The files that a scene names.
fn named_files<'a>(
    scene: &'a Scene,
    highlights: Option<&'a HighlightFiles>,
) -> impl Iterator<Item = &'a String> {
    let databases = std::iter::once(&scene.light.database).chain(&scene.material.database);
    let highlights = highlights.into_iter().flat_map(|files| [&files.sources, &files.gloss]);
    databases.chain(highlights)
}

/// The materials of several files, to the lowest of their orders, and the highest order that all
/// files have. `read` reads one of them.
///
/// # Errors
///
/// If a file cannot be read, or a name is in two of them.
pub fn together(
    files: impl IntoIterator<Item = PathBuf>,
    read: impl Fn(&Path) -> Result<(Materials, usize)>,
) -> Result<(Materials, usize)> {
    let mut all: Option<(Materials, usize)> = None;
    for file in files {
        let (more, order_of_file) = read(&file)?;
        let Some((materials, least)) = &mut all else {
            all = Some((more, order_of_file));
            continue;
        };
        let has = |name: &String| materials.entries.iter().any(|entry| entry.name == *name);
        if let Some(twice) = more.entries.iter().find(|entry| has(&entry.name)) {
            let what = format!("material `{}` is also in another database", twice.name);
            return Err(Error::new(what, "rename one of them").in_file(file));
        }
        let order = materials.order.min(more.order);
        *materials = materials.truncated(order);
        materials.entries.extend(more.truncated(order).entries);
        *least = order_of_file.min(*least);
    }
    all.ok_or_else(|| Error::new("no material database", "name at least one file"))
}

fn named(materials: &Materials, names: &[String]) -> Result<Vec<Named>> {
    let find = |name: &String| {
        let entry = materials.entries.iter().find(|entry| entry.name == *name);
        entry.cloned().ok_or_else(|| {
            let all = materials.entries.iter().map(|entry| entry.name.as_str());
            let remedy = name_remedy(name, all, "another name from the database");
            Error::new(format!("no material `{name}`"), remedy)
        })
    };
    names.iter().map(find).collect()
}

/// The text of a scene file.
///
/// # Errors
///
/// If it cannot be read or is too long.
pub fn text(file: &InputFile) -> Result<String> {
    let text = file.text()?;
    if text.len() as u64 > LONGEST {
        let what = format!("it has {} bytes, too many for a scene", text.len());
        return Err(Error::new(what, format!("give at most {LONGEST}")).in_file(file.path()));
    }
    Ok(text)
}

/// Whether the scene is of an object with shadows, which `eigenshade basis` packs: it has
/// `geometry.object`.
#[must_use]
pub fn has_object(text: &str) -> bool {
    let scene = text.parse::<toml::Table>().unwrap_or_default();
    scene.get("geometry").is_some_and(|geometry| geometry.get("object").is_some())
}

/// Checks that the scene does not name an object, or a rotation of the light: a table is that of a
/// sphere under light that turns freely.
fn check_sphere(text: &str, path: &Path) -> Result<()> {
    // What is not TOML is an error of `from_toml`.
    let Ok(scene) = DeTable::parse(text) else { return Ok(()) };
    let section = |name: &str| {
        let section = scene.get_ref().iter().find(|(key, _)| key.get_ref() == name);
        let (key, value) = section?;
        Some((key, value.get_ref().as_table()?))
    };
    if let Some((geometry, fields)) = section("geometry") {
        if let Some((field, _)) = fields.iter().find(|(field, _)| field.get_ref() == "object") {
            let what = "geometry.object: the scene is of an object with shadows, not of a table";
            let fault = Error::new(what, "pack it with `eigenshade basis`");
            return Err(fault.at_line(path, line(text, field)));
        }
        let first = fields.keys().next();
        let what = match first {
            Some(field) => format!("geometry.{}: a table is that of a sphere", field.get_ref()),
            None => "[geometry]: a table is that of a sphere".to_owned(),
        };
        let remedy = "leave [geometry] out for a sphere, or name a mesh with geometry.object";
        return Err(Error::new(what, remedy).at_line(path, line(text, first.unwrap_or(geometry))));
    }
    let rotation = section("light")
        .and_then(|(_, fields)| fields.keys().find(|field| field.get_ref() == "rotation"));
    if let Some(rotation) = rotation {
        let what = "light.rotation: the light of a table turns freely";
        let remedy = "leave it out; only a scene with geometry.object takes it";
        return Err(Error::new(what, remedy).at_line(path, line(text, rotation)));
    }
    Ok(())
}

/// The line of a key of a TOML text.
fn line<T>(text: &str, key: &Spanned<T>) -> u64 {
    1 + text[..key.span().start].matches('\n').count() as u64
}

/// Parses the text of a scene file at a path.
///
/// # Errors
///
/// With the line, if a field is unknown or missing, or has another type.
pub fn from_toml<T: DeserializeOwned>(text: &str, path: &Path) -> Result<T> {
    toml::from_str(text).map_err(|error| {
        let what = error.message().lines().next().unwrap_or("not a scene").to_owned();
        let fault = Error::new(what, "see tables/README.md for the fields of a scene");
        match error.span() {
            Some(span) => fault.at_line(path, 1 + text[..span.start].matches('\n').count() as u64),
            None => fault.in_file(path),
        }
    })
}

/// Checks that this version supports the values.
fn check(scene: &Scene, highlights: Option<&HighlightFiles>) -> Result<()> {
    let basis = &scene.basis;
    let fail = |what: String, remedy: &str| Err(Error::new(what, remedy));
    let most = highlights.map_or(1, |files| files.most);
    if !(1..=MAX_SOURCES).contains(&most) {
        let what = format!("highlights.most = {most} is out of range");
        return Err(Error::new(what, format!("give 1 to {MAX_SOURCES} sources")));
    }
    if scene.effects.set() == Effects::NONE {
        return fail(
            "effects.use = []".into(),
            "name at least one effect, or leave it out for all",
        );
    }
    if scene.material.database.is_empty() {
        return fail("material.database = []".into(), "name at least one file");
    }
    let names = &scene.material.names;
    if let Some(place) = (1..names.len()).find(|&place| names[..place].contains(&names[place])) {
        return fail(
            format!("material.names has `{}` twice", names[place]),
            "name each material once",
        );
    }
    if scene.light.degree > 64 || scene.material.order > 64 {
        return fail(
            format!("degree {} or order {} is too high", scene.light.degree, scene.material.order),
            "use at most 64 for each",
        );
    }
    match (basis.components, basis.tolerance) {
        (Some(0), _) => return fail("basis.components = 0".into(), "ask for at least one"),
        (Some(_), Some(_)) | (None, None) => {
            return fail(
                "basis needs either components or tolerance".into(),
                "set one of them, not both",
            );
        }
        (None, Some(tolerance)) if !is_share(tolerance) => {
            return fail(format!("basis.tolerance = {tolerance}"), "set it between 0 and 1");
        }
        _ => {}
    }
    if basis.trim.is_some() && basis.tolerance.is_some() {
        let what = "basis has tolerance and trim";
        return fail(what.into(), "leave one out: a tolerance already trims");
    }
    for (name, value) in [
        ("trim", basis.trim),
        ("rank_cutoff", Some(basis.rank_cutoff)),
        ("profile_tolerance", Some(basis.profile_tolerance)),
    ] {
        if let Some(value) = value.filter(|value| !is_share(*value)) {
            return fail(format!("basis.{name} = {value}"), "set it between 0 and 1");
        }
    }
    Ok(())
}
