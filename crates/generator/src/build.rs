//! A scene's table as Rust statics, in the build script of a crate that uses it.
//!
//! With `eigenshade-generator` among the `[build-dependencies]`, `build.rs` is
//!
//! ```no_run
//! use eigenshade_generator::build::{self, Format};
//!
//! build::statics("scene.toml", "table.rs", &[Format::Q15]);
//! ```
//!
//! and the crate has a module `table` with
//! `include!(concat!(env!("OUT_DIR"), "/table.rs"));`: what `eigenshade::sphere` is of the
//! shipped scene, its integers in `table::q15`.
//!
//! Cargo does not optimise build scripts unless it is asked to, and the generator is much
//! slower so; this in the crate's `Cargo.toml` asks for it:
//!
//! ```toml
//! [profile.dev.build-override]
//! opt-level = 2
//! [profile.release.build-override]
//! opt-level = 2
//! ```

use crate::scene_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::write_atomically;
use eigenshade_table::statics;
use std::path::Path;
use std::{env, process};

pub use eigenshade_table::quantise::Format;

/// Writes the statics of the scene at `scene` into the build script's `OUT_DIR`, as
/// `name`: in `f32`, and in a module `q15` or `q31` for each of `integers`.
///
/// Speaks to cargo on standard output: what the statics are made of, a warning for each
/// format of integers that does not serve the scene, and is left out, and of a fault
/// one line, with which the process ends.
pub fn statics(scene: impl AsRef<Path>, name: &str, integers: &[Format]) {
    let scene = scene.as_ref();
    for input in scene_file::inputs(scene) {
        println!("cargo::rerun-if-changed={}", input.display());
    }
    let written = env::var_os("OUT_DIR")
        .ok_or_else(|| Error::new("OUT_DIR is not set", "call this from a build script"))
        .and_then(|folder| write(scene, &Path::new(&folder).join(name), integers));
    match written {
        Ok(warnings) => warnings.iter().for_each(|line| println!("cargo::warning={line}")),
        Err(error) => {
            println!("cargo::error={error}");
            process::exit(1);
        }
    }
}

/// Writes the statics of a scene to the file `out`. Gives a line for each format that
/// does not serve it.
///
/// # Errors
///
/// Those of [`scene_file::load`] and [`Loaded::build`](scene_file::Loaded::build), a
/// scene that stores transfers alone, and the faults of writing.
pub fn write(scene: &Path, out: &Path, integers: &[Format]) -> Result<Vec<String>> {
    let table = scene_file::load(scene)?.build().map_err(|error| error.in_file(scene))?;
    let command = format!("eigenshade-generator, from {}", scene.display());
    let statics = statics::module(&table, &command, integers).map_err(|_| {
        let what = "it stores transfers alone, which are no statics";
        Error::new(what, "set store = \"projection\"").in_file(scene)
    })?;
    write_atomically(out, |to| {
        to.write_all(statics.text.as_bytes()).map_err(|error| Error::io(out, &error))
    })?;
    let line = |(format, error): &(Format, _)| {
        format!("{}: no {}: {error}", scene.display(), format.name())
    };
    Ok(statics.left_out.iter().map(line).collect())
}
