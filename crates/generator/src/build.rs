//! Generates a scene's table as Rust statics in the build script of a crate that uses it.
//!
//! Add `eigenshade-generator` to the `[build-dependencies]` and write this `build.rs`:
//!
//! ```no_run
//! use eigenshade_generator::build;
//!
//! build::statics("scene.toml", "table.rs");
//! ```
//!
//! In the crate, add a module `table` that contains `include!(concat!(env!("OUT_DIR"),
//! "/table.rs"));`. It has the same contents for your scene as `eigenshade::sphere` has for the
//! shipped scene, with the integer statics in `table::q15`.
//!
//! Cargo does not optimize build scripts by default, which makes the generator much slower. Turn
//! optimization on in the crate's `Cargo.toml`:
//!
//! ```toml
//! [profile.dev.build-override]
//! opt-level = 2
//! [profile.release.build-override]
//! opt-level = 2
//! ```

use crate::highlights::Highlights;
use crate::scene_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::write_atomically;
use eigenshade_table::statics;
use std::path::Path;
use std::{env, process};

/// Writes the statics of the scene at `scene` to the file `name` in the build script's `OUT_DIR`:
/// in `f32`, and in integers in a module `q15`. If the scene has a section `[highlights]`, the
/// modules `sources` and `gloss` hold the small sources of its lights and the gloss of its
/// materials.
///
/// Prints directives for cargo on standard output: the files that the statics depend on, and a
/// warning if integers do not suit the scene and `q15` is left out, for lights without sources and
/// for materials without gloss. On an error it prints one line and ends the process.
pub fn statics(scene: impl AsRef<Path>, name: &str) {
    let scene = scene.as_ref();
    for input in scene_file::inputs(scene) {
        println!("cargo::rerun-if-changed={}", input.display());
    }
    let written = env::var_os("OUT_DIR")
        .ok_or_else(|| Error::new("OUT_DIR is not set", "call this from a build script"))
        .and_then(|folder| write(scene, &Path::new(&folder).join(name)));
    match written {
        Ok(warnings) => warnings.iter().for_each(|line| println!("cargo::warning={line}")),
        Err(error) => {
            println!("cargo::error={error}");
            process::exit(1);
        }
    }
}

/// Writes the statics of a scene to the file `out`. Returns one line if integers do not suit
/// the scene, and one for each thing that its highlights lack.
///
/// # Errors
///
/// The errors of [`scene_file::load`] and [`Loaded::build`](scene_file::Loaded::build), those of
/// [`statics::module`], and errors of writing.
pub fn write(scene: &Path, out: &Path) -> Result<Vec<String>> {
    let loaded = scene_file::load(scene)?;
    let table = loaded.build().map_err(|error| error.in_file(scene))?;
    let command = format!("eigenshade-generator, from {}", scene.display());
    let statics = statics::module(&table, &command)
        .map_err(|error| Error::of_line(error, "make another table").in_file(scene))?;
    let text = statics.text + &loaded.highlights.iter().map(Highlights::text).collect::<String>();
    write_atomically(out, |to| {
        to.write_all(text.as_bytes()).map_err(|error| Error::io(out, &error))
    })?;
    let line = |error| format!("{}: no q15: {error}", scene.display());
    let missing = loaded.highlights.iter().flat_map(Highlights::warnings);
    let missing = missing.map(|line| format!("{}: {line}", scene.display()));
    Ok(statics.without_integers.map(line).into_iter().chain(missing).collect())
}
