//! Decodes the shipped table into typed statics, and generates the table of a scene if the feature
//! `generate` is enabled.

use eigenshade_table::quantize::{Format, integers};
use eigenshade_table::{rust_quantized, rust_source};
use std::path::PathBuf;
use std::{env, fs, process};

fn main() {
    println!("cargo::rerun-if-changed=tables/sphere.bin");
    #[cfg(feature = "generate")]
    generate();
    if env::var_os("CARGO_FEATURE_BAKED").is_none() {
        return;
    }
    if let Err(error) = bake("tables/sphere.bin", "sphere") {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// Writes the statics of the scene that `EIGENSHADE_SCENE` names, or of the shipped scene, to
/// generated.rs in the output folder.
#[cfg(feature = "generate")]
fn generate() {
    use eigenshade_generator::build::{self, Format};

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
    build::statics(scene, "generated.rs", &[Format::Q15, Format::Q31]);
}

/// Writes the statics of the table at `from` to the output folder: floats to `name`.rs, integers to
/// `name`_q15.rs and `name`_q31.rs.
fn bake(from: &str, name: &str) -> Result<(), String> {
    let bytes = fs::read(from).map_err(|error| format!("{from}: {error}"))?;
    let table = eigenshade_table::decode(&bytes).map_err(|error| format!("{from}: {error}"))?;
    if !table.has_projection() {
        return Err(format!(
            "{from} stores only transfers; set store = \"projection\" in its scene"
        ));
    }
    let command = format!("build.rs, from {from}");
    write(&format!("{name}.rs"), &rust_source::module(&table, &command))?;
    for (format, suffix) in [(Format::Q15, "q15"), (Format::Q31, "q31")] {
        let parts = integers(&table, format, format.tolerance())
            .map_err(|error| format!("{from}: {error}"))?;
        write(&format!("{name}_{suffix}.rs"), &rust_quantized::module(&parts, format, &command))?;
    }
    Ok(())
}

/// Writes a file to the output folder.
fn write(name: &str, text: &str) -> Result<(), String> {
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(name);
    fs::write(&to, text).map_err(|error| format!("{}: {error}", to.display()))
}
