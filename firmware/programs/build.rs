//! Writes golden vectors and highlights as statics, and for each program its function and its table.

#[path = "build/golden.rs"]
mod golden;
#[path = "build/highlights.rs"]
mod highlights;
#[expect(dead_code, reason = "the host reads the rest")]
mod list;
#[path = "build/object.rs"]
mod object;
#[path = "build/one_material.rs"]
mod one_material;

use eigenshade::Q15;
use list::Program;
use std::path::PathBuf;
use std::{env, fs, process};

type Result<T> = std::result::Result<T, String>;

/// The shipped table.
const SHIPPED: &str = "../../tables/sphere.bin";

fn main() {
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
        if env::var("TARGET").is_ok_and(|target| target == "thumbv6m-none-eabi") {
            // Memory of the machine that runs them.
            for large in list::programs().iter().filter(|program| program.is_large()) {
                for memory in ["_stack_start=0x20010000", "_flash_size=0x400000"] {
                    println!("cargo::rustc-link-arg-bin={}=--defsym={memory}", large.name());
                }
            }
        }
    }
    if let Err(error) = write_all() {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

fn write_all() -> Result<()> {
    write("golden.rs", golden::modules()?)?;
    write("one_material.rs", of_one_material()?)?;
    write("highlights.rs", highlights::constants()?)?;
    write("ball.bin", object::ball(240)?)?;
    write("object.bin", object::sphere(120)?)?;
    write("shadowed.bin", object::shadowed()?)?;
    let mut programs = list::programs().into_iter();
    programs.try_for_each(|one| write(&format!("programs/{}.rs", one.name()), program(one)))
}

/// The items that `program!` includes: the table, and the function to run.
fn program(Program { operation, format, source, table }: Program) -> String {
    let table = match (table, format) {
        ("", _) => String::new(),
        ("sphere", "f32") => "use eigenshade::sphere as table;\n".into(),
        ("sphere", _) => format!("use eigenshade::sphere::{format} as table;\n"),
        (_, "f32") => format!("use tables::{table} as table;\n"),
        _ => format!("use tables::{table}::{format} as table;\n"),
    };
    // An operation with another table than the usual one has its name after its own.
    let operation = operation.strip_suffix("_full").unwrap_or(operation);
    let function = if source == "scene" { source } else { operation };
    format!("{table}board::program!({function});\n")
}

/// The shipped table in Q15, with the transfer of the first golden material.
fn of_one_material() -> Result<String> {
    let golden = golden::file()?;
    let pair = *golden.pairs().first().ok_or("no pair")?;
    let material = golden.find("q15", pair, "material")?;
    let exponents: Vec<i8> = material.exponents.iter().map(|&one| one as i8).collect();
    let mantissas: Vec<Q15> =
        material.integers()?.into_iter().map(|number| Q15(number as i16)).collect();
    one_material::one_material(&decoded(SHIPPED)?, &exponents, &mantissas)
}

/// Reads a table.
fn decoded(path: &str) -> Result<eigenshade_table::Table> {
    println!("cargo::rerun-if-changed={path}");
    let bytes = fs::read(path).map_err(|error| format!("{path}: {error}"))?;
    eigenshade_table::decode(&bytes).map_err(|error| format!("{path}: {error}"))
}

/// Reads a file, and builds again when it changes.
fn read(path: &str) -> Result<String> {
    println!("cargo::rerun-if-changed={path}");
    fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))
}

/// Writes a file of the output folder.
fn write(name: &str, contents: impl AsRef<[u8]>) -> Result<()> {
    let folder = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?);
    let path = folder.join(name);
    let written =
        fs::create_dir_all(folder.join("programs")).and_then(|()| fs::write(&path, contents));
    written.map_err(|error| format!("{}: {error}", path.display()))
}
