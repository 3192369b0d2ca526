//! Gives the linker the memory of the board that the target stands for.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    println!("cargo::rerun-if-changed=memory");
    let target = env::var("TARGET").unwrap_or_default();
    let board = match target.as_str() {
        "thumbv6m-none-eabi" => "microbit",
        "thumbv7m-none-eabi" | "thumbv7em-none-eabihf" => "mps2",
        "riscv32imac-unknown-none-elf" => "virt",
        // A host, where the programs are checked but not linked.
        _ => return,
    };
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    let from = format!("memory/{board}.x");
    let written = fs::read(&from).and_then(|text| fs::write(out.join("memory.x"), text));
    if let Err(error) = written {
        println!("cargo::error={from}: {error}");
    }
    println!("cargo::rustc-link-search={}", out.display());
}
