//! `eigenshade pack-normals`: makes a normal map for the runtime.

use super::options::{Memory, count};
use clap::Args;
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
/// pixel, or Rust source with the map as the static `MAP`. Normals are within 0.51 degrees.
#[derive(Args, Debug)]
pub struct PackNormals {
    /// `sphere`, a normal map (.png), or a mesh (.obj, .stl, .ply)
    #[arg(value_name = "NORMALS")]
    normals: PathBuf,
    /// Pixels across the longer side, 2 to 4096; a normal map can only shrink [default: 240, or all
    /// of a normal map]
    #[arg(short, long, value_name = "N", value_parser = count(2, 4096))]
    size: Option<usize>,
    /// Write bytes (.bin) or Rust source (.rs) to this file
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
}

impl PackNormals {
    pub fn run(self, memory: Memory) -> Result<()> {
        output::refuse_collisions([&self.out], [&self.normals])?;
        let extension = self.out.extension().unwrap_or_default().to_ascii_lowercase();
        let is_source = match extension.to_str() {
            Some("rs") => true,
            Some("bin") => false,
            _ => {
                let remedy = "name it .bin for bytes, or .rs for Rust source";
                return Err(Error::new("unknown kind of output", remedy).in_file(&self.out));
            }
        };
        let is_map = self.normals.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
        let size = self.size.or((!is_map).then_some(SIZE));
        let view = ObjectView::read(memory.file(&self.normals), size)?;
        let codes = view.codes()?;
        let bytes = codes.as_flattened();
        let map = format!("eigenshade::NormalMap::new({}, {}, ", view.width, view.height);
        let (contents, line) = if is_source {
            (self.source(&map, bytes), format!("mod {};", stem(&self.out)))
        } else {
            let file = self.out.display();
            (bytes.to_vec(), format!("{map}include_bytes!({:?}))", file.to_string()))
        };
        output::write_all(Some(&self.out), contents)?;
        let covered = grouped(view.pixels.len());
        output::report(format!(
            "{:<12} {} x {}, {covered} with an object\n{:<12} {}\n{:<12} {line}\n",
            "pixels",
            view.width,
            view.height,
            "bytes",
            grouped(bytes.len()),
            "in Rust",
        ))
    }

    /// Source that holds the map, below a comment with the command, without folders.
    fn source(&self, map: &str, bytes: &[u8]) -> Vec<u8> {
        let name =
            |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let size = self.size.map(|size| format!(" --size {size}")).unwrap_or_default();
        let command = format!("{}{size} --out {}", name(&self.normals), name(&self.out));
        let count = bytes.len();
        let mut text = format!(
            "// eigenshade pack-normals {}\n\n/// The map.\n\
             pub static MAP: eigenshade::NormalMap<'static> =\n    \
             eigenshade::specialized::checked({map}&CODES));\n\n\
             #[rustfmt::skip]\nstatic CODES: [u8; {count}] = [\n",
            printable(&command)
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

/// The name of the module that a source file is.
fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
