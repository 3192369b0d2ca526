//! `eigenshade pack-normals`: makes a normal map for the runtime.

use super::options::{Green, Pose, count, input_file};
use clap::Args;
use eigenshade_cli::export::c;
use eigenshade_cli::export::entry::identifier;
use eigenshade_cli::messages::{grouped, printable};
use eigenshade_cli::object::ObjectView;
use eigenshade_cli::output;
use eigenshade_model::error::{Error, Result};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Pixels across a sphere and a mesh.
const SIZE: usize = 240;

/// Bytes in a line of source.
const PER_LINE: usize = 20;

/// Pack an object's normals for the runtime's `NormalMap`
///
/// A mesh is seen from +z, with x to the right and y up. A normal map has x in red, y (up) in green
/// and z in blue; its opacity is the object's coverage. The file is the map's bytes, two for each
/// pixel; Rust source with the map as the static `MAP`; or, for F.h, a C header with the constant
/// `normal_map_F` for `eigenshade.h`. Normals are within 0.51 degrees.
#[derive(Args, Debug)]
pub struct PackNormals {
    /// `sphere`, a normal map (.png), or a mesh (.obj, .stl, .ply, .glb, .gltf)
    #[arg(value_name = "NORMALS")]
    normals: PathBuf,
    /// Pixels across the longer side, 2 to 4096; a normal map can only shrink [default: 240, or all
    /// of a normal map]
    #[arg(short, long, value_name = "N", value_parser = count(2, 4096))]
    size: Option<usize>,
    #[command(flatten)]
    green: Green,
    #[command(flatten)]
    pose: Pose,
    /// Write bytes (.bin), Rust source (.rs) or a C header (.h) to this file
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
}

/// The declaration of a file as a module, which has the name of the file if that is one.
fn module(file: &str) -> String {
    let is_name = |stem: &&str| {
        stem.starts_with(|letter: char| letter.is_ascii_lowercase()) && identifier(stem) == **stem
    };
    match file.strip_suffix(".rs").filter(is_name) {
        Some(stem) => format!("mod {stem};"),
        None => format!("#[path = {file:?}] mod normal_map;"),
    }
}

impl PackNormals {
    pub fn run(self) -> Result<()> {
        output::refuse_collisions([&self.out], [&self.normals])?;
        let extension = self.out.extension().unwrap_or_default().to_ascii_lowercase();
        let kind = match extension.to_str() {
            Some("bin") => Kind::Bytes,
            Some("rs") => Kind::Rust,
            Some("h") => Kind::C,
            _ => {
                let remedy = "name it .bin for bytes, .rs for Rust source, or .h for a C header";
                return Err(Error::new("unknown kind of output", remedy).in_file(&self.out));
            }
        };
        let is_map = self.normals.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
        let size = self.size.or((!is_map).then_some(SIZE));
        let view =
            ObjectView::read(input_file(&self.normals), self.pose.options(size, self.green))?;
        let codes = view.codes()?;
        let bytes = codes.as_flattened();
        let map = format!("eigenshade::object::NormalMap::new({}, {}, ", view.width, view.height);
        let stem = self.out.file_stem().unwrap_or_default().to_string_lossy();
        let (contents, (language, line)) = match kind {
            Kind::Bytes => {
                let file = self.out.display().to_string();
                (bytes.to_vec(), ("in Rust", format!("{map}include_bytes!({file:?}))")))
            }
            Kind::Rust => (
                self.source(&map, bytes),
                ("in Rust", module(&self.out.file_name().unwrap_or_default().to_string_lossy())),
            ),
            Kind::C => {
                let name = identifier(&format!("normal map {stem}"));
                let size = [view.width, view.height];
                let text = c::normal_map(&name, size, bytes, &self.command());
                (text.into_bytes(), ("in C", format!("&{name}")))
            }
        };
        output::write_all(Some(&self.out), contents)?;
        let covered = grouped(view.pixels.len());
        output::report(format!(
            "{:<12} {} x {}, {covered} with an object\n{:<12} {}\n{:<12} {}\n",
            "pixels",
            view.width,
            view.height,
            "bytes",
            grouped(bytes.len()),
            language,
            line,
        ))
    }

    /// The command, without folders.
    fn command(&self) -> String {
        let name =
            |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let size = self.size.map(|size| format!(" --size {size}")).unwrap_or_default();
        let flip = if self.green.is_flipped { " --flip-green" } else { "" };
        let pose = self.pose.written();
        let files = format!("{}{size}{flip}{pose} --out {}", name(&self.normals), name(&self.out));
        format!("eigenshade pack-normals {}", printable(&files))
    }

    /// Source that holds the map, below a comment with the command.
    fn source(&self, map: &str, bytes: &[u8]) -> Vec<u8> {
        let count = bytes.len();
        let mut text = format!(
            "// {}\n\n/// The map.\n\
             pub static MAP: eigenshade::object::NormalMap<'static> =\n    \
             eigenshade::specialized::checked({map}&CODES));\n\n\
             #[rustfmt::skip]\nstatic CODES: [u8; {count}] = [\n",
            self.command()
        );
        for line in bytes.chunks(PER_LINE) {
            text.push_str("   ");
            line.iter().for_each(|byte| {
                let _ = write!(text, " {byte},");
            });
            text.push('\n');
        }
        text.push_str("];\n");
        text.into_bytes()
    }
}

/// The kinds of file that hold a normal map.
#[derive(Clone, Copy)]
enum Kind {
    Bytes,
    Rust,
    C,
}
