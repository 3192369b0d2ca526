//! Types and parsers of options that commands share.

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use eigenshade::Effect;
use eigenshade::screen::Exposure;
use eigenshade_cli::messages::print_message;
use eigenshade_cli::object::ObjectOptions;
use eigenshade_cli::table;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::window::Window;
use eigenshade_shading::presets::Source;
use eigenshade_table::Table;
use eigenshade_table::highlights::MAX_SOURCES;
#[cfg(feature = "generate")]
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

/// What clap's parsers return.
pub type Parsed<T> = std::result::Result<T, String>;

/// A file whose warnings are printed.
pub fn input_file(path: impl AsRef<Path>) -> InputFile {
    InputFile::new(path).with_warnings(|path, what| {
        print_message(format_args!("warning: {}: {what}", path.display()));
    })
}

/// The green channel of a normal map.
#[derive(Args, Clone, Copy, Debug)]
pub struct Green {
    /// Turn y of a normal map round, whose green points down, as in DirectX
    #[arg(long = "flip-green", requires = "normals")]
    pub is_flipped: bool,
}

/// How a mesh is drawn.
#[derive(Args, Clone, Copy, Debug)]
pub struct Pose {
    /// Draw the facets of a mesh flat. Without, its normals are those of the file, or else smooth
    /// across edges of up to 30 degrees
    #[arg(long = "flat", requires = "normals")]
    is_flat: bool,
    /// The side of a mesh that the camera sees: from +z, -z, +x, -x, +y or -y, where y is up
    #[arg(long, value_parser = views(), requires = "normals")]
    view: Option<NamedView>,
    /// Rotate a mesh by Rz(A) Ry(B) Rz(C) in the camera's frame, radians
    #[arg(long, value_name = "A,B,C", value_parser = angles, allow_hyphen_values = true,
        requires = "normals")]
    rotate_object: Option<Rotation>,
}

/// A view, and the camera's axes in the mesh's frame.
type NamedView = (&'static str, [[f64; 3]; 3]);

const VIEWS: [NamedView; 6] = [
    ("front", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    ("back", [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]),
    ("right", [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
    ("left", [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]),
    ("top", [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]),
    ("bottom", [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]),
];

fn views() -> impl TypedValueParser<Value = NamedView> {
    choice(VIEWS.map(|view| (view.0, "", view)))
}

/// The camera's axes of a view.
#[cfg(feature = "generate")]
pub fn view_named(name: &str) -> Option<[[f64; 3]; 3]> {
    VIEWS.iter().find(|view| view.0 == name).map(|view| view.1)
}

impl Pose {
    /// The options of an object with this size and this green channel.
    pub fn options(&self, size: Option<usize>, green: Green) -> ObjectOptions {
        let turn = self.rotate_object.map(Rotation::matrix);
        let rotation = match (turn, self.view) {
            (Some(turn), Some((_, view))) => Some(turn.map(|row| {
                [0, 1, 2].map(|column: usize| (0..3).map(|k| row[k] * view[k][column]).sum())
            })),
            (turn, view) => turn.or(view.map(|(_, rotation)| rotation)),
        };
        ObjectOptions { size, flip_green: green.is_flipped, is_flat: self.is_flat, rotation }
    }

    /// The options as they are written, each behind a space.
    #[cfg(feature = "generate")]
    pub fn written(&self) -> String {
        let flat = if self.is_flat { " --flat" } else { "" };
        let view = self.view.map(|(name, _)| format!(" --view {name}")).unwrap_or_default();
        let turn = self.rotate_object.map(|Rotation { alpha, beta, gamma }| {
            format!(" --rotate-object {beta},{alpha},{gamma}")
        });
        format!("{flat}{view}{}", turn.unwrap_or_default())
    }
}

/// The table of a command.
#[derive(Args, Debug)]
pub struct TableChoice {
    /// Table: a file, or the name of a shipped one, which is `color` (160 components), `sphere`
    /// (the one that the runtime contains), `curet`, or `pbr` (250 components of degree and order
    /// 12) [default: color, and sphere for `render`]
    #[arg(id = "table", short, long, value_name = "NAME|FILE")]
    path: Option<PathBuf>,
}

impl TableChoice {
    /// The file, or the shipped name.
    pub fn path(&self) -> &Path {
        self.path.as_deref().unwrap_or(Path::new("color"))
    }

    /// This table, or another shipped one if none is given.
    pub fn or(&self, name: &str) -> Self {
        Self { path: Some(self.path.clone().unwrap_or_else(|| name.into())) }
    }

    /// Reads the table. Fails as [`table::read`] does.
    pub fn read(&self) -> Result<Table> {
        table::read(input_file(self.path()))
    }
}

/// The lights and the materials of a command.
#[derive(Args, Debug)]
pub struct Inputs {
    /// Light: the name of a shipped one, a light CSV, or one light of a CSV
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    pub light: Source,
    /// Material: the name of a shipped one, a material CSV, or one material of a CSV
    #[arg(short, long, value_name = "NAME|FILE[:NAME]")]
    pub material: Source,
}

impl Inputs {
    /// The files, as far as these are files, with those beside them, and others of the command.
    pub fn files(&self, others: &[&Path]) -> Vec<PathBuf> {
        let others = others.iter().map(|path| path.to_path_buf()).collect();
        [self.light.light_files(), self.material.material_files(), others].concat()
    }
}

/// Where a command writes its result.
#[derive(Args, Debug)]
pub struct Destination {
    /// Write to this file instead of standard output
    #[arg(id = "out", short, long, value_name = "FILE")]
    pub path: Option<PathBuf>,
}

/// Parses one of these choices: name, help, which may be empty, and value.
pub fn choice<T: Copy + Send + Sync + 'static, const N: usize>(
    choices: [(&'static str, &'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    let named = |(name, help, _): (&'static str, &'static str, T)| {
        PossibleValue::new(name).help((!help.is_empty()).then_some(help))
    };
    PossibleValuesParser::new(choices.map(named)).try_map(move |name| {
        let found = choices.into_iter().find(|(known, ..)| *known == name);
        found.map(|(.., value)| value).ok_or("no choice")
    })
}

/// Parses a whole number within a range.
pub fn count(low: u64, high: u64) -> impl Fn(&str) -> Parsed<usize> + Clone {
    move |text| match text.parse::<u64>() {
        Ok(number) if (low..=high).contains(&number) => Ok(number as usize),
        _ => Err(format!("expected a whole number from {low} to {high}")),
    }
}

/// Parses a number within a range, or says what is expected.
#[cfg(feature = "generate")]
pub fn number(
    range: RangeInclusive<f64>,
    expected: &'static str,
) -> impl Fn(&str) -> Parsed<f64> + Clone {
    move |text| match text.parse() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!("expected {expected}")),
    }
}

/// How many sources a picture has.
#[derive(Clone, Copy, Debug)]
pub enum Sources {
    /// At most this many.
    Most(usize),
    /// As few as the picture needs.
    Auto,
}

/// Parses a number of sources.
pub fn sources(text: &str) -> Parsed<Sources> {
    match text {
        "auto" => Ok(Sources::Auto),
        _ => count(0, MAX_SOURCES as u64)(text)
            .map(Sources::Most)
            .map_err(|expected| format!("{expected}, or auto")),
    }
}

/// Parses an effect.
pub fn effect(text: &str) -> Parsed<Effect> {
    let found = Effect::ALL.into_iter().find(|effect| effect.name() == text.trim());
    found.ok_or_else(|| "expected ambient, diffuse, broad or gloss".to_owned())
}

/// Parses a share of white.
pub fn tolerance(text: &str) -> Parsed<f64> {
    match text.parse() {
        Ok(share) if (1e-30..1.0).contains(&share) => Ok(share),
        _ => Err("expected a share of white from 1e-30 to less than 1, as in 2e-3".to_owned()),
    }
}

/// The window of a light.
#[derive(Clone, Copy, Debug)]
pub enum WindowChoice {
    /// The weakest without dark rings.
    Auto,
    /// None, or one of a width.
    Given(Window),
}

/// Parses a window.
pub fn window(text: &str) -> Parsed<WindowChoice> {
    match text {
        "auto" => Ok(WindowChoice::Auto),
        "none" => Ok(WindowChoice::Given(Window::None)),
        _ => width(text)
            .map(|width| WindowChoice::Given(Window::SincFourth { width }))
            .map_err(|expected| format!("{expected}, auto, or none")),
    }
}

/// Parses a width in degrees or orders.
pub fn width(text: &str) -> Parsed<f64> {
    match text.parse() {
        Ok(width) if width > 0.0 && f64::is_finite(width) => Ok(width),
        _ => Err("expected a width above 0, as in 12".to_owned()),
    }
}

/// Parses an exposure.
pub fn exposure(text: &str) -> Parsed<Exposure> {
    let exposure = text.parse().ok().and_then(|number| Exposure::new(number).ok());
    exposure.ok_or_else(|| "expected a number from 1e-37 to 3e38, as in 1.5".to_owned())
}

/// Parses the three angles A,B,C of Rz(A) Ry(B) Rz(C).
pub fn angles(text: &str) -> Parsed<Rotation> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite()))
        .collect();
    match numbers.as_deref() {
        // R = Rz(A) Ry(B) Rz(C).
        Some(&[a, b, c]) => Ok(Rotation { alpha: b, beta: a, gamma: c }),
        _ => Err("expected three angles in radians, as in 0.5,1.2,-0.3".to_owned()),
    }
}
