//! `eigenshade export`: writes lights, materials and tables for other programs.

use super::options::{Destination, TableChoice, count};
use clap::{Args, ValueEnum};
use eigenshade_cli::export::entry::{Format, entries, identifier, quoted_entries};
use eigenshade_cli::export::highlights::SourcesAndGloss;
use eigenshade_cli::export::{c, js, rust};
use eigenshade_cli::messages::print_message;
use eigenshade_cli::output;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::estimate::{counted, gloss_note};
use eigenshade_shading::presets::Source;
use eigenshade_shading::shader::{fitted, of_higher_order};
use eigenshade_table::highlights::{MAX_SOURCES, SHIPPED_SOURCES};
use eigenshade_table::light::MAX_DEGREE;
use eigenshade_table::quantize::{TOLERANCE, integers};
use eigenshade_table::{FormatError, Table, statics};
use std::path::{Path, PathBuf};

/// Export lights, materials and tables to Rust, C or JavaScript
///
/// With --light and --material, exports these, to the degree and order of the table, or a light to
/// --degree. With neither, exports the table. For numpy there is a package for Python.
#[derive(Args, Debug)]
pub struct Export {
    /// Language
    #[arg(long, value_enum)]
    lang: Lang,
    /// Light: the name of a shipped one, a light CSV, or one light of a CSV
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    light: Option<Source>,
    /// Material: the name of a shipped one, a material CSV, or one material of a CSV
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    material: Option<Source>,
    /// The degree of the light, up to 16, for objects with shadows [default: that of the table]
    #[arg(long, value_name = "L", value_parser = count(0, MAX_DEGREE as u64), requires = "light",
        conflicts_with = "material")]
    degree: Option<usize>,
    #[command(flatten)]
    table: TableChoice,
    /// Number format of rust and c [default: f32]
    #[arg(short, long, value_enum)]
    format: Option<Format>,
    /// Add the first K small sources of each light, or fewer if it has no more, and the gloss of
    /// each material, for sharp highlights; for rust, c (up to 16) and js. They are in f32, and so
    /// are the lights of rust, out of which the runtime takes the sources
    #[arg(long, value_name = "K", value_parser = count(1, MAX_SOURCES as u64))]
    sources: Option<usize>,
    #[command(flatten)]
    out: Destination,
}

/// What source files say made them.
const COMMAND: &str = "eigenshade export";

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Lang {
    /// A module of constants
    Rust,
    /// A header of constant records
    C,
    /// A module of typed arrays
    Js,
}

impl Export {
    pub fn run(self) -> Result<()> {
        let [light, material] = [&self.light, &self.material].map(Option::as_ref);
        let mut inputs = light.map_or_else(Vec::new, Source::light_files);
        inputs.extend(material.into_iter().flat_map(Source::material_files));
        let inputs = inputs.iter().map(PathBuf::as_path).chain([self.table.path()]);
        output::refuse_collisions(&self.out.path, inputs)?;
        self.check()?;
        let table = self.table.read()?;
        let none = Lights { degree: 0, entries: Vec::new() };
        let lights = light.map_or(Ok(none), Source::lights)?;
        let none = Materials { order: 0, entries: Vec::new() };
        let order = table.gram.order;
        let of_file = material.map_or(Ok(none), |one| one.materials(order))?;
        let (of_table, materials) = fitted(&table, &lights, &of_file);
        let lights = match (self.degree, light) {
            (Some(degree), Some(source)) if degree > lights.degree => {
                let what = format!("the light has degree {}, not {degree}", lights.degree);
                let remedy = "project it again with `eigenshade light --degree`";
                return Err(Error::new(what, remedy).in_file(source.path()));
            }
            (Some(degree), _) => lights.truncated(degree),
            (None, _) => of_table,
        };
        if light.is_none() && material.is_none() {
            let contents = self.table_source(&table);
            let contents = contents.map_err(|error| error.in_file(self.table.path()))?;
            return output::write_all(self.out.path.as_deref(), contents);
        }
        let highlights = self.sources.map(|most| self.highlights(most, &lights, &materials));
        let highlights = highlights.transpose()?;
        let entries = (&lights, &materials, highlights.as_ref());
        let contents = self.coefficients(entries)?;
        output::write_all(self.out.path.as_deref(), contents)?;
        let order = table.gram.order;
        let higher = material.and_then(|one| of_higher_order(one.named(), of_file.order, order));
        higher.iter().for_each(print_message);
        Ok(())
    }

    /// Whether the options go together.
    fn check(&self) -> Result<()> {
        let fault = |what: &str, remedy: &str| Err(Error::new(what, remedy));
        if self.lang == Lang::C && self.degree.is_some() {
            let what = "the C library takes lights to the degree of its table";
            return fault(what, "leave --degree out, or export it for rust or js");
        }
        if let Some(most) = self.sources {
            if self.light.is_none() && self.material.is_none() {
                let what = "--sources adds sources to lights and gloss to materials";
                return fault(what, "give --light or --material, or leave it out");
            }
            if self.lang == Lang::C && most > SHIPPED_SOURCES {
                let what =
                    format!("the C library draws up to {SHIPPED_SOURCES} sources, not {most}");
                let remedy = format!("give --sources {SHIPPED_SOURCES}, or another language");
                return fault(&what, &remedy);
            }
        }
        match (self.lang, self.format) {
            (Lang::Js, Some(Format::Q15)) => fault(
                "the WebAssembly module takes floats and makes integers of them itself",
                "leave --format out",
            ),
            _ => Ok(()),
        }
    }

    /// The source of a table.
    fn table_source(&self, table: &Table) -> Result<String> {
        let fault = |error: FormatError| Error::of_line(error, "export it in f32");
        match (self.lang, self.format.unwrap_or_default()) {
            (Lang::Rust, Format::F32) => statics::floats(table, COMMAND).map_err(fault),
            (Lang::Rust, Format::Q15) => {
                let parts = integers(table, TOLERANCE).map_err(fault)?;
                Ok(statics::integers(&parts, COMMAND))
            }
            (Lang::C, _) => Err(Error::new(
                "a program in C takes no table: the C library itself is built for one",
                "build the library for the scene of this table (crates/capi/README.md), and export \
                 lights and materials",
            )),
            (Lang::Js, _) => Err(Error::new(
                "a web page takes no table: the WebAssembly module itself is built for one",
                "build the module for this table (crates/wasm/README.md), and export lights and \
                 materials",
            )),
        }
    }

    /// Sources of the lights and gloss of the materials. Notes say where they are fewer than asked
    /// for, or do not show.
    fn highlights(
        &self,
        most: usize,
        lights: &Lights,
        materials: &Materials,
    ) -> Result<SourcesAndGloss> {
        let mut found = SourcesAndGloss::default();
        for (light, Named { name, .. }) in of_each(self.light.as_ref(), &lights.entries) {
            let sources = light.sources(name, most)?;
            if sources.len() < most {
                print_message(format_args!(
                    "note: `{name}` has {}, of {most} asked for",
                    counted(sources.len())
                ));
            }
            found.sources.push((name.clone(), sources));
        }
        for (material, Named { name, .. }) in of_each(self.material.as_ref(), &materials.entries) {
            let known = material.known_gloss(name)?;
            gloss_note(&known).iter().for_each(print_message);
            found.glosses.push(known);
        }
        Ok(found)
    }

    /// The file of lights, materials, or both; either may be empty.
    fn coefficients(
        &self,
        (lights, materials, highlights): (&Lights, &Materials, Option<&SourcesAndGloss>),
    ) -> Result<String> {
        let format = self.format.unwrap_or_default();
        // The runtime takes sources out of lights in floats.
        let in_floats = highlights.is_some() && matches!(self.lang, Lang::Rust);
        let of_lights = if in_floats { Format::F32 } else { format };
        let formats = [of_lights, format];
        let entries = || entries(lights, materials, formats);
        let quoted = || quoted_entries(lights, materials, formats);
        Ok(match self.lang {
            Lang::Rust => rust::module(&entries()?, highlights, COMMAND),
            Lang::C => c::header(&entries()?, highlights, COMMAND, &self.guard()),
            Lang::Js => js::module(&quoted()?, highlights, COMMAND),
        })
    }

    /// The macro against including a header twice: the name of its file.
    fn guard(&self) -> String {
        let stem = self.out.path.as_deref().and_then(Path::file_stem).unwrap_or_default();
        let name = format!("eigenshade export {} h", stem.to_string_lossy());
        identifier(&name).to_uppercase()
    }
}

/// The entries of an input, each with the input.
fn of_each<'a>(
    source: Option<&'a Source>,
    entries: &'a [Named],
) -> impl Iterator<Item = (&'a Source, &'a Named)> {
    source.into_iter().flat_map(move |source| entries.iter().map(move |entry| (source, entry)))
}
