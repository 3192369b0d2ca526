//! Builds programs and runs them in the emulator.
//!
//! The compiler is that of rustup or, if rustup cannot provide the target, Debian's, which builds
//! `core` itself.

use crate::Result;
use crate::program::Board;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Debian's compiler and linker.
const DEBIAN: [&str; 2] = ["/usr/bin/rustc", "ld.lld-22"];

/// The profile of all programs: what does not depend on `opt_level` is built once.
const PROFILE: &str = "fast";

/// Builds programs of a package, for some targets side by side.
pub fn build(
    targets: &[&str],
    package: &str,
    binaries: &[impl AsRef<OsStr>],
    opt_level: &str,
) -> Result<()> {
    if binaries.is_empty() || targets.is_empty() {
        return Ok(());
    }
    let mut command = Command::new("cargo");
    command
        .args(["build", "--quiet", "--profile", PROFILE, "-p", package])
        .env("CARGO_PROFILE_FAST_OPT_LEVEL", opt_level);
    targets.iter().for_each(|target| _ = command.args(["--target", target]));
    binaries.iter().for_each(|binary| _ = command.arg("--bin").arg(binary));
    if is_debian() {
        command
            .args(["-Zbuild-std=core", "--target-dir", "target/debian"])
            .env("RUSTC", DEBIAN[0])
            .env("RUSTC_BOOTSTRAP", "1");
        for target in targets {
            let key = target.to_uppercase().replace('-', "_");
            command.env(format!("CARGO_TARGET_{key}_LINKER"), DEBIAN[1]);
        }
    }
    let output = command.output().map_err(|error| format!("cargo: {error}"))?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!("{command:?}\n{}", String::from_utf8_lossy(&output.stderr)))
}

/// Whether the compiler is Debian's: `firmware/run` sets `EIGENSHADE_CI_DEBIAN=1` to choose it.
fn is_debian() -> bool {
    std::env::var_os("EIGENSHADE_CI_DEBIAN").is_some()
}

/// The path of a linked program.
pub fn binary(target: &str, name: &str) -> PathBuf {
    let folder = if is_debian() { "target/debian" } else { "target" };
    Path::new(folder).join(target).join(PROFILE).join(name)
}

/// The compiler's name and version, on which the counts depend.
pub fn version() -> Result<String> {
    let compiler = if is_debian() { DEBIAN[0] } else { "rustc" };
    let output = output(Command::new(compiler).arg("--version"))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().into())
}

fn output(command: &mut Command) -> Result<Output> {
    command.output().map_err(|error| format!("{command:?}: {error}"))
}

/// Seconds after which a program is stopped.
const TIMEOUT: &str = "120";

/// Runs a program to its end and returns its output.
pub fn run(board: Board, program: &Path) -> Result<String> {
    let mut command = Command::new("timeout");
    let command = command
        .args([TIMEOUT, board.emulator])
        .args(board.machine)
        .args(["-display", "none", "-monitor", "none", "-serial", "none", "-icount", "shift=0"])
        .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
        .arg(program);
    let output = output(command)?;
    // The emulator writes the program's output to its standard error.
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    if output.status.success() {
        return Ok(text);
    }
    let status = match output.status.code() {
        Some(124) => format!("does not end within {TIMEOUT} s"),
        Some(127) => {
            format!("no {}: apt-get install qemu-system-arm qemu-system-misc", board.emulator)
        }
        code => format!("ends with status {code:?}"),
    };
    Err(format!("{} on {}: {status}\n{text}", program.display(), board.name))
}
