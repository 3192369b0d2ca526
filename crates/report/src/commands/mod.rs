//! The commands. Those with many options are structs in files of their own.

mod files;
mod highlights;
mod pages;
mod pictures;
mod shadow_picture;

use clap::{Args, Parser};
use eigenshade_cli::messages::{printable, progress_bar, spinner};
use eigenshade_cli::output;
use eigenshade_cli::picture::Canvas;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::write_error;
use eigenshade_shading::picture::write_png;
use report::shadow_lights::Lit;
use report::shadow_shapes::SHAPES;
use report::sheet::{Purpose, compare_cells};
use report::{objects, palette_errors, reading, roughness_weights, shadows, sheet, stability};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Where a command writes its CSV.
#[derive(Args, Debug)]
pub struct Csv {
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// The file that a command makes.
#[derive(Args, Debug)]
pub struct OutputFile {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// Measures what the documentation of eigenshade states.
///
/// Run it from the repository's root. Messages go to standard error. Exit status: 0, 1 if a check
/// fails or an input is bad, 2 for wrong usage.
#[derive(Debug, Parser)]
pub enum Command {
    /// The figures of Nillius and Eklundh (2003) and their numbers, on the shipped data
    ///
    /// --out writes CSV files and PNG pictures. --check recomputes everything and compares the CSV
    /// files: counts and words must be equal, other numbers within two units of six digits, or one
    /// of the last digit where there are fewer. Both take a minute.
    Paper(Purpose),
    /// All presets, docs/presets.png: the materials in the lobby with one exposure, then the lights
    /// on gold paint, each with a window and its own exposure
    ContactSheet(OutputFile),
    /// An object of docs/objects.md as a glTF file
    ObjectFile {
        /// Its name
        object: String,
        #[command(flatten)]
        file: OutputFile,
    },
    AccuracyCost(files::AccuracyCost),
    /// The tables and charts of the documentation, from the CSV files that the other commands write
    ///
    /// Writes the tables of README.md and docs/*.md, and the charts of docs/accuracy-cost and
    /// docs/paper. Takes seconds.
    Pages,
    /// The numerically hard cases, measured, docs/stability.csv
    Stability(Purpose),
    /// Errors of estimates from degraded images, docs/reading-*.csv
    Reading {
        #[command(flatten)]
        purpose: Purpose,
        /// Folder of the shipped tables
        #[arg(long, value_name = "DIR", default_value = "tables")]
        tables: PathBuf,
    },
    /// Results of the runtime, tests/golden/sphere.csv
    ///
    /// Integers must be equal; floats may differ by the tolerance that the file states.
    Golden(Purpose),
    /// The gloss of the shipped materials in color, tables/inputs/gloss.csv
    ///
    /// One GGX lobe over a matte base is fitted to each. `error` is the rms of what it leaves of
    /// pictures under points of light, relative to that of the pictures.
    Gloss(Csv),
    /// GGX lobes at order 32, as a material CSV
    GlossyMaterials {
        /// The file to write
        #[arg(value_name = "FILE")]
        out: PathBuf,
    },
    /// Errors of pictures with small sources, docs/highlights.csv
    ///
    /// The pictures are of GGX metals under the captured lights as they are and turned, and under
    /// three synthetic ones. The reference is direct integration of the whole map. Takes some five
    /// minutes on two cores.
    Highlights(Csv),
    /// Spheres with sources beside those without, and direct integration, docs/highlights.png
    HighlightPicture(OutputFile),
    /// Total errors of the shipped materials, tables/inputs/merl.errors.csv
    ///
    /// The reference is direct integration of each BRDF under the environment maps, without degree
    /// or order; PTFE, which was measured, is its own coefficients. Errors are CIEDE2000 on a
    /// screen: the mean and the 95th percentile of pixels, of the median map and of that which 95
    /// of 100 do not exceed, at 9/7 and at 12/12, with no source and with 8. The normals are evenly
    /// spaced ones, and others that mirror the lamps of the maps. Takes some ten minutes on two
    /// cores.
    MaterialErrors(Csv),
    /// Pictures from a palette of normals against every pixel shaded, docs/palette.csv
    ///
    /// A sphere of 240 x 240 pixels in each shipped material in color under five lights. Errors are
    /// CIEDE2000 against the picture that is not rounded to the levels of a display.
    PaletteErrors(Csv),
    /// Spheres from a palette beside those with every pixel shaded, enlarged, docs/palette.png
    PalettePicture(OutputFile),
    /// Pictures of objects in their own materials against direct integration, docs/objects.csv
    ///
    /// Six objects with textures, made for this, under four captured lights with eight sources. The
    /// reference has 144 samples a pixel and no shadows. Takes some three minutes on two cores.
    ObjectErrors(Csv),
    /// The same pictures under one light beside the reference, docs/objects.png
    ObjectPicture(OutputFile),
    /// Pictures of objects with shadows against direct sums, docs/shadows.csv
    ///
    /// Six shapes of 96 x 96 pixels in four materials, under every third map, turned eight times. The
    /// reference is the direct sum over the whole map with the same visibility. Takes some five
    /// minutes on two cores.
    Shadows(Csv),
    /// Objects without shadows, with them as the runtime draws them, and by direct sums, enlarged,
    /// docs/shadows.png
    ShadowPicture(OutputFile),
    /// A shape of docs/shadows.csv, as a mesh in .obj
    ShadowShape {
        /// The name of the shape
        shape: String,
        #[command(flatten)]
        file: OutputFile,
    },
    /// Coefficients of glTF materials, tables/inputs/metallic-roughness.csv
    ///
    /// A material's coefficients are albedo (1 - f0) `matte` + `rim` + f0 `metal`. `matte` does not
    /// depend on roughness; `rim` and `metal` are sums of Chebyshev polynomials T_k in
    /// (roughness - 0.6) / 0.4. Writes the CSV `order,k,o,p,q,matte,rim,metal`.
    MetallicRoughness(OutputFile),
    /// Weights of the images of five roughnesses, tables/inputs/roughness-weights.csv
    ///
    /// Fitted by least squares to pictures of a metal and of a dielectric by the table `pbr`, under
    /// every second shipped light, rotated. Takes seconds.
    RoughnessWeights(Csv),
    /// Compares the order and the sign of two tables' components
    ///
    /// Tables of one scene that two instruction sets make differ in their weakest components by far
    /// more than rounding, but order and sign must agree. Compares components whose eigenvalues
    /// exceed 1e-24 of the largest.
    SameOrder {
        #[arg(value_name = "A.bin")]
        one: PathBuf,
        #[arg(value_name = "B.bin")]
        other: PathBuf,
    },
}

impl Command {
    pub fn run(self) -> Result<()> {
        match self {
            Self::Paper(purpose) => files::paper(&purpose),
            Self::ContactSheet(file) => pictures::contact_sheet(&file.out),
            Self::ObjectFile { object, file } => {
                let all = objects::all();
                let names: Vec<_> = all.iter().map(|(name, _)| *name).collect();
                let remedy = format!("give one of {}", names.join(", "));
                let (_, glb) = all.iter().find(|(name, _)| *name == object).ok_or_else(|| {
                    Error::new(format!("no object {}", printable(&object)), remedy)
                })?;
                output::write_all(Some(&file.out), glb.bytes())
            }
            Self::AccuracyCost(command) => command.run(),
            Self::Pages => pages::write(),
            Self::Stability(purpose) => {
                let progress = spinner("cases");
                let rows = stability::rows(|name| progress.set_message(name.to_owned()));
                progress.finish_and_clear();
                let remedy =
                    "every bound must hold, and a tight one be at most ten times the error";
                let rows = rows.map_err(|fault| Error::new(fault, remedy))?;
                let command = "report stability --out docs/stability.csv";
                let text = sheet::csv(command, stability::COLUMNS, rows)?;
                let same = |old: &str, new: &str| compare_cells(old, new, stability::same);
                purpose.write_or_compare("", &text, command, same)
            }
            Self::Reading { purpose, tables } => {
                let command = "report reading --out docs";
                let same = |old: &str, new: &str| compare_cells(old, new, reading::same);
                let names = ["reading-estimates.csv", "reading-scenes.csv"];
                names.into_iter().zip(reading::csv(&tables)?).try_for_each(|(name, text)| {
                    purpose.write_or_compare(name, &text, command, same)
                })
            }
            Self::Golden(purpose) => files::golden(&purpose),
            Self::Gloss(csv) => highlights::gloss(csv.out.as_deref()),
            Self::GlossyMaterials { out } => files::glossy_materials(&out),
            Self::Highlights(csv) => highlights::errors(csv.out.as_deref()),
            Self::HighlightPicture(file) => highlights::picture(&file.out),
            Self::MaterialErrors(csv) => highlights::material_errors(csv.out.as_deref()),
            Self::PaletteErrors(csv) => {
                let rows = palette_errors::errors(&[], &progress_bar("materials", 0))?;
                let rows = rows.iter().map(palette_errors::Row::fields);
                write_csv(csv.out.as_deref(), palette_errors::COLUMNS, rows)
            }
            Self::PalettePicture(file) => pictures::palettes(&file.out),
            Self::ObjectErrors(csv) => {
                let (progress, mut rows) = (progress_bar("texels", 0), Vec::new());
                for light in objects::LIGHTS {
                    let pairs = objects::pairs(light, &[], &inputs().join("maps"), &progress)?;
                    rows.extend(pairs.iter().map(objects::Pair::fields));
                }
                progress.finish_and_clear();
                write_csv(csv.out.as_deref(), objects::COLUMNS, rows)
            }
            Self::ObjectPicture(file) => {
                let progress = progress_bar("texels", 0);
                let maps = inputs().join("maps");
                let pairs = objects::pairs(objects::LIGHTS[0], &[], &maps, &progress)?;
                progress.finish_and_clear();
                let Canvas { width, height, bytes } = objects::canvas(&pairs);
                write_png(&file.out, width, height, &bytes)
            }
            Self::Shadows(csv) => {
                let shapes = SHAPES.map(|(name, _)| name);
                let lit = Lit::new(&inputs().join("maps"))?;
                let bar = progress_bar("objects", 0);
                let rows = shadows::errors(&shapes, &shadows::MATERIALS, &lit, &bar)?;
                let rows = rows.iter().map(shadows::Row::fields);
                write_csv(csv.out.as_deref(), shadows::COLUMNS, rows)
            }
            Self::ShadowPicture(file) => shadow_picture::picture(&file.out),
            Self::ShadowShape { shape, file } => files::shadow_shape(&shape, &file.out),
            Self::MetallicRoughness(file) => files::metallic_roughness(&file.out),
            Self::RoughnessWeights(csv) => {
                let rows = roughness_weights::rows()?;
                write_csv(csv.out.as_deref(), roughness_weights::COLUMNS, rows)
            }
            Self::SameOrder { one, other } => files::same_order(&one, &other),
        }
    }
}

/// The folder of the shipped tables' inputs, from the repository's root.
fn inputs() -> &'static Path {
    Path::new("tables/inputs")
}

/// The command that makes a file, `report ...`, which its first line states.
fn command_line() -> String {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    format!("report {}", printable(&arguments.join(" ")))
}

/// Writes a CSV below a comment with the command.
fn write(out: Option<&Path>, csv: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    output::write(out, |out| {
        writeln!(out, "# {}", command_line()).map_err(write_error)?;
        csv(out)
    })
}

/// The same for these rows; `columns` are separated by commas.
fn write_csv<R: IntoIterator<Item: AsRef<[u8]>>>(
    out: Option<&Path>,
    columns: &str,
    rows: impl IntoIterator<Item = R>,
) -> Result<()> {
    output::write_all(out, sheet::csv(&command_line(), columns, rows)?)
}
