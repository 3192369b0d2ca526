//! Decodes the shipped table into typed statics, and generates the table of a scene if the feature
//! `generate` is enabled.

#[path = "build/files.rs"]
mod files;
#[path = "build/metallic_roughness.rs"]
mod metallic_roughness;
#[path = "build/presets.rs"]
mod presets;

use eigenshade_table::source;
use eigenshade_table::wire::{Fault, aligned, read_floats, read_integers};
use std::{env, fs, process};

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "generate")]
    generate();
    let has = |feature| env::var_os(feature).is_some();
    let sphere = if has("CARGO_FEATURE_BAKED") { sphere() } else { Ok(()) };
    let presets = if has("CARGO_FEATURE_PRESETS") {
        presets::write().and_then(|()| metallic_roughness::write())
    } else {
        Ok(())
    };
    if let Err(error) = sphere.and(presets) {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// Writes the statics of the shipped table in each format.
fn sphere() -> Result<(), String> {
    bake("f32", |bytes, command| Ok(source::floats::module(&read_floats(bytes)?, command)))?;
    bake("q15", |bytes, command| Ok(source::integers::module(&read_integers(bytes)?, command)))
}

/// Writes the statics of the scene that `EIGENSHADE_SCENE` names, or of the shipped scene, to
/// generated.rs in the output folder.
#[cfg(feature = "generate")]
fn generate() {
    use eigenshade_generator::build;
    use std::path::PathBuf;

    println!("cargo::rerun-if-env-changed=EIGENSHADE_SCENE");
    let scene = env::var_os("EIGENSHADE_SCENE").map(PathBuf::from);
    if let Some(path) = scene.as_ref().filter(|path| !path.is_absolute()) {
        println!(
            "cargo::error=EIGENSHADE_SCENE: `{}` is not absolute, and where a build script runs \
             is not where you are; give the whole path of the scene file",
            path.display()
        );
        process::exit(1);
    }
    let scene = scene.unwrap_or_else(|| "tables/sphere.toml".into());
    build::statics(scene, "generated.rs");
}

/// Writes the statics of the shipped table in this format to `sphere_FORMAT.rs` in the output
/// folder.
fn bake(
    format: &str,
    module: impl FnOnce(&[u8], &str) -> Result<String, Fault>,
) -> Result<(), String> {
    let from = format!("tables/sphere.{format}.esw");
    println!("cargo::rerun-if-changed={from}");
    let bytes = fs::read(&from).map_err(|error| format!("{from}: {error}"))?;
    let mut room = vec![0; bytes.len().div_ceil(4)];
    let text = aligned(&bytes, &mut room)
        .and_then(|bytes| module(bytes, &format!("build.rs, from {from}")))
        .map_err(|fault| format!("{from}: {fault}"))?;
    files::write_output(&format!("sphere_{format}.rs"), &text)
}
