//! Lights and materials as options name them: shipped ones, all of a file, or one of a file.

use crate::highlights;
use eigenshade_model::database::{Lights, Materials, Named, name_remedy};
use eigenshade_model::error::{Error, Result, STANDARD_INPUT};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::inputs::gloss_csv::read_glosses;
use eigenshade_model::inputs::input_file::{InputFile, is_file};
use eigenshade_model::inputs::source_csv::read_sources;
use eigenshade_model::inputs::source_error_csv::read_source_errors;
use eigenshade_model::shipped;
use eigenshade_model::source::{NamedGloss, Source as SmallSource, SourceError};
use std::convert::Infallible;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// The name of a shipped light or material, a file, or `FILE:NAME`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The file, or the shipped name.
    path: PathBuf,
    entry: Entry,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Entry {
    /// The path is the name of something shipped.
    Shipped,
    /// All entries of the file.
    All,
    /// The entry of this name.
    Named(String),
}

impl FromStr for Source {
    type Err = Infallible;

    /// A file that exists is taken as such. Otherwise, an entry's name follows the last colon that
    /// has a file before it, or else the last one. One word without an extension, or with digits as
    /// in `dielectric-0.2`, is a shipped name.
    fn from_str(text: &str) -> std::result::Result<Self, Infallible> {
        let path = Path::new(text);
        let end = path.extension().unwrap_or_default().as_encoded_bytes();
        let is_word = !text.contains(['/', '\\']) && end.iter().all(u8::is_ascii_digit);
        let of_a_file = |&(place, _): &(usize, &str)| is_file(Path::new(&text[..place]));
        let colon =
            text.rmatch_indices(':').find(of_a_file).or_else(|| text.rmatch_indices(':').next());
        let (path, entry) = match colon.map(|(place, _)| (&text[..place], &text[place + 1..])) {
            _ if is_file(path) || text == STANDARD_INPUT => (text, Entry::All),
            Some((path, name))
                if !path.is_empty() && (!name.is_empty() || is_file(Path::new(path))) =>
            {
                (path, Entry::Named(name.to_owned()))
            }
            None if is_word => (text, Entry::Shipped),
            _ => (text, Entry::All),
        };
        Ok(Self { path: path.into(), entry })
    }
}

impl Source {
    /// All entries of a file, or the one of this name.
    #[must_use]
    pub fn of_file(path: impl Into<PathBuf>, name: Option<String>) -> Self {
        Self { path: path.into(), entry: name.map_or(Entry::All, Entry::Named) }
    }

    /// The file, or the shipped name.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Its name, or that of its file without folders, and of the chosen entry.
    #[must_use]
    pub fn short(&self) -> String {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        match &self.entry {
            Entry::Named(entry) => format!("{name}:{entry}"),
            Entry::Shipped | Entry::All => name.into_owned(),
        }
    }

    /// Whether it is the name of something shipped.
    #[must_use]
    pub fn is_shipped(&self) -> bool {
        self.entry == Entry::Shipped
    }

    /// The path or the name, and whether it is the name of something shipped.
    #[must_use]
    pub fn named(&self) -> (&Path, bool) {
        (self.path(), self.is_shipped())
    }

    /// The files with the light: its own, and those beside it with its sources and their errors.
    #[must_use]
    pub fn light_files(&self) -> Vec<PathBuf> {
        self.with_existing([SOURCES, SOURCE_ERRORS])
    }

    /// The files with the material: its own, and the one beside it with its gloss.
    #[must_use]
    pub fn material_files(&self) -> Vec<PathBuf> {
        self.with_existing([GLOSS])
    }

    fn with_existing<const N: usize>(&self, endings: [&str; N]) -> Vec<PathBuf> {
        let beside = endings.into_iter().filter_map(|ending| existing(&self.path, ending));
        [self.path.clone()].into_iter().chain(beside).collect()
    }

    /// The lights.
    ///
    /// # Errors
    ///
    /// As [`read_lights`], and if no light has the name; the message offers similar names.
    pub fn lights(&self) -> Result<Lights> {
        let file = InputFile::new(&self.path);
        let extension = file.extension();
        if is_file(&self.path) && MAPS.contains(&extension.as_str()) {
            let is_picture = ["png", "jpg", "jpeg"].contains(&extension.as_str());
            let kind = if is_picture { "a picture" } else { "an environment map" };
            let what = format!("it is {kind}, not a light CSV");
            let remedy = "run `eigenshade light` on the map, and use the light CSV that it writes";
            return Err(Error::new(what, remedy).in_file(&self.path));
        }
        let Lights { degree, entries } = match self.entry {
            Entry::Shipped => shipped::lights()?,
            _ => read_lights(file, None)?,
        };
        Ok(Lights { degree, entries: self.chosen("light", entries)? })
    }

    /// The first small sources of one light, at most this many.
    ///
    /// # Errors
    ///
    /// If the sources of a light CSV, which are in a file beside it, cannot be read; or if there
    /// are none for the light, or one that the runtime refuses in f32.
    pub fn sources(&self, light: &str, most: usize) -> Result<Vec<SmallSource>> {
        if self.entry == Entry::Shipped {
            let named = shipped::sources()?.into_iter().find(|named| named.name == light);
            let named = named.ok_or_else(|| {
                let what =
                    format!("the shipped light `{light}` has no map, so no sources are known");
                Error::new(what, "take another light, or leave --sources out")
            })?;
            return Ok(named.first(most).to_vec());
        }
        let Some(file) = beside(&self.path, SOURCES) else {
            let what = "only a file whose name ends in .csv has sources beside it";
            return Err(Error::new(what, FIND_SOURCES).in_file(&self.path));
        };
        if !is_file(&file) {
            let what = "there are no sources beside the light CSV";
            return Err(Error::new(what, FIND_SOURCES).in_file(file));
        }
        let lights = read_sources(InputFile::new(&file))?;
        let named = lights.into_iter().find(|named| named.name == light).ok_or_else(|| {
            let what = format!("it has no sources of the light `{light}`");
            Error::new(what, FIND_SOURCES).in_file(&file)
        })?;
        let sources = named.first(most);
        if let Some(bad) = sources.iter().position(|one| highlights::source(one).is_err()) {
            let what = format!("source {} of `{light}` is not one", bad + 1);
            let remedy = "a source has a unit direction, energies of at least 0, and a spread of 0 to \
                          0.5";
            return Err(Error::new(what, remedy).in_file(file));
        }
        Ok(sources.to_vec())
    }

    /// The errors of pictures with the small sources of one light, if they are known.
    ///
    /// # Errors
    ///
    /// If the errors of a light CSV, which are in a file beside it, cannot be read.
    pub fn source_errors(&self, light: &str) -> Result<Vec<SourceError>> {
        let errors = match self.entry {
            Entry::Shipped => shipped::source_errors()?,
            _ => {
                let Some(file) = existing(&self.path, SOURCE_ERRORS) else { return Ok(Vec::new()) };
                read_source_errors(InputFile::new(file))?
            }
        };
        Ok(errors.into_iter().filter(|one| one.light == light).collect())
    }

    /// The gloss of one material, if it is known.
    ///
    /// # Errors
    ///
    /// If the gloss of a material CSV, which is in a file beside it, cannot be read.
    pub fn gloss(&self, material: &str) -> Result<Option<NamedGloss>> {
        let glosses = match self.entry {
            Entry::Shipped => shipped::glosses()?,
            _ => {
                let Some(file) = existing(&self.path, GLOSS) else { return Ok(None) };
                read_glosses(InputFile::new(file))?
            }
        };
        Ok(glosses.into_iter().find(|one| one.name == material))
    }

    /// The gloss of one material.
    ///
    /// # Errors
    ///
    /// As [`gloss`](Self::gloss), and if it is not known.
    pub fn known_gloss(&self, material: &str) -> Result<NamedGloss> {
        self.gloss(material)?.ok_or_else(|| {
            let remedy = "leave --sources out, name a shipped material in color, or make the CSV with \
                          `eigenshade material .. --out FILE.csv`, which writes FILE.gloss.csv";
            let error = Error::new(format!("the gloss of `{material}` is not known"), remedy);
            let file = || beside(&self.path, GLOSS).unwrap_or_else(|| self.path.clone());
            if self.is_shipped() { error } else { error.in_file(file()) }
        })
    }

    /// The materials, shipped ones for a table of this order.
    ///
    /// # Errors
    ///
    /// As [`lights`](Self::lights).
    pub fn materials(&self, order: usize) -> Result<Materials> {
        let file = InputFile::new(&self.path);
        if is_file(&self.path) && file.extension() == "toml" {
            let what = "it holds formulas, not coefficients";
            let remedy = "run `eigenshade material` on it, and use the material CSV that it writes";
            return Err(Error::new(what, remedy).in_file(&self.path));
        }
        let Materials { order, entries } = match self.entry {
            Entry::Shipped => shipped::named_materials(order)?,
            _ => read_materials(file, None)?,
        };
        Ok(Materials { order, entries: self.chosen("material", entries)? })
    }

    /// The entries that are asked for, of a `light` or a `material`.
    fn chosen(&self, kind: &str, mut entries: Vec<Named>) -> Result<Vec<Named>> {
        let path = self.path.display();
        let (name, what, otherwise) = match &self.entry {
            Entry::All => return Ok(entries),
            Entry::Shipped => {
                let name = path.to_string();
                let of_the_other = match kind {
                    "light" => shipped::named_materials(0)?.entries,
                    _ => shipped::lights()?.entries,
                };
                let what = if of_the_other.iter().any(|other| other.name == name) {
                    let other = if kind == "light" { "material" } else { "light" };
                    format!("`{name}` is a {other}, not a {kind}")
                } else {
                    format!("`{name}` is neither a file nor a shipped {kind}")
                };
                (name, what, OTHERWISE[usize::from(kind == "material")])
            }
            Entry::Named(name) => {
                (name.clone(), format!("it has no {kind} `{name}`"), "another name from it")
            }
        };
        if let Some(place) = entries.iter().position(|entry| entry.name == name) {
            return Ok(vec![entries.swap_remove(place)]);
        }
        let names = entries.iter().map(|entry| entry.name.as_str());
        if self.entry == Entry::Shipped {
            return Err(Error::new(what, name_remedy(&name, names, otherwise)));
        }
        let remedy = if let [one] = &entries[..] {
            format!("its only name is `{}`", one.name)
        } else if entries.len() <= NAMED {
            let names = names.map(|name| format!("`{name}`"));
            format!("its names are {}", names.collect::<Vec<_>>().join(", "))
        } else {
            name_remedy(&name, names, otherwise)
        };
        Err(Error::new(what, remedy).in_file(&self.path))
    }

    /// The only one of these entries.
    ///
    /// # Errors
    ///
    /// If there are several; the message has the first names.
    pub fn only(&self, mut entries: Vec<Named>) -> Result<Named> {
        if entries.len() == 1 {
            return Ok(entries.remove(0));
        }
        let count = entries.len();
        let names = entries.iter().take(NAMED).map(|entry| entry.name.as_str()).collect::<Vec<_>>();
        let more = if count > names.len() { ", ..." } else { "" };
        let (path, names) = (self.path.display(), names.join(", "));
        let remedy = format!("name one as {path}:NAME, with one of {names}{more}");
        Err(Error::new(format!("it has {count} entries"), remedy).in_file(&self.path))
    }
}

/// The most entries of a file that messages list.
const NAMED: usize = 10;

/// What to use for a light and for a material that is not shipped.
const OTHERWISE: [&str; 2] = [
    "a name that `eigenshade list` prints, or a CSV that `eigenshade light` writes",
    "a name that `eigenshade list` prints, or a CSV that `eigenshade material` writes",
];

/// The largest degree and order of these that do not exceed a size, or else the least.
pub(crate) fn largest_within(
    sizes: impl Iterator<Item = (usize, usize)> + Clone,
    (degree, order): (usize, usize),
) -> Option<(usize, usize)> {
    let smaller = sizes.clone().filter(|size| size.0 <= degree && size.1 <= order);
    smaller.max().or(sizes.min())
}

/// The remedy for a light without sources.
const FIND_SOURCES: &str =
    "find them with `eigenshade light MAP --sources 8 --out FILE.csv`, or leave --sources out";

/// The ending of the file beside a light CSV that has the sources of its lights.
pub const SOURCES: &str = "sources.csv";
/// The ending of the file beside them that has the errors that these sources leave.
pub const SOURCE_ERRORS: &str = "sources.errors.csv";
/// The ending of the file beside a material CSV that has the gloss of its materials.
pub const GLOSS: &str = "gloss.csv";

/// The file with an ending beside one that ends in .csv. Others have none: it would belong to both
/// `a.csv` and `a.txt`.
#[must_use]
pub fn beside(file: &Path, ending: &str) -> Option<PathBuf> {
    let is_csv = file.extension().is_some_and(|end| end.eq_ignore_ascii_case("csv"));
    is_csv.then(|| file.with_extension(ending))
}

fn existing(file: &Path, ending: &str) -> Option<PathBuf> {
    beside(file, ending).filter(|file| is_file(file))
}

/// Refuses to write a light CSV beside the sources of other lights, with which the new ones would
/// be drawn.
pub fn refuse_stale_sources(lights: Option<&Path>) -> Result<()> {
    let all = [SOURCES, SOURCE_ERRORS].map(|ending| existing(lights?, ending));
    let beside = all.iter().flatten().map(|file| file.display().to_string());
    let beside: Vec<String> = beside.collect();
    if beside.is_empty() {
        return Ok(());
    }
    let what = format!("{} would be used with the new lights", beside.join(" and "));
    Err(Error::new(what, "delete what belongs to other lights, or write the new ones elsewhere"))
}

/// The extensions of environment maps.
const MAPS: [&str; 6] = ["exr", "hdr", "pfm", "png", "jpg", "jpeg"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_follow_the_last_colon() {
        let parsed = |text: &str| -> Source { text.parse().unwrap() };
        let named = |path: &str, name: &str| Source {
            path: path.into(),
            entry: Entry::Named(name.to_owned()),
        };
        assert_eq!(parsed("no/such:file.csv:felt"), named("no/such:file.csv", "felt"));
        assert_eq!(parsed("-:felt"), named("-", "felt"));
        for (text, entry) in [
            ("no/such.csv", Entry::All),
            ("no/such.csv:", Entry::All),
            ("-", Entry::All),
            ("felt", Entry::Shipped),
            ("dielectric-0.2", Entry::Shipped),
            // A folder, which has no entries.
            ("src", Entry::Shipped),
            ("no/felt", Entry::All),
            ("Cargo.toml", Entry::All),
        ] {
            assert_eq!(parsed(text), Source { path: text.into(), entry }, "{text}");
        }
    }
}
