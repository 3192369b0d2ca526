//! Building of programs: with rustup's targets, or, where these cannot be had, with
//! Debian's compiler, which builds `core` itself.

use crate::Result;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Debian's compiler and linker.
const DEBIAN: [&str; 2] = ["/usr/bin/rustc", "ld.lld-22"];

/// What builds for one target.
#[derive(Clone, Debug)]
pub struct Compiler {
    target: &'static str,
    debian: bool,
}

/// The compiler for this target. `EIGENSHADE_CI_DEBIAN=1` asks for Debian's.
pub fn for_target(target: &'static str) -> Result<Compiler> {
    let debian = std::env::var_os("EIGENSHADE_CI_DEBIAN").is_some() || !has_target(target)?;
    if debian && !Path::new(DEBIAN[0]).exists() {
        let remedy = "apt-get install rustc-web rust-web-src lld-22, or rustup target add";
        return Err(format!("neither rustup nor Debian can build for {target}: {remedy} {target}"));
    }
    Ok(Compiler { target, debian })
}

/// Whether rustup has the target, or can get it.
fn has_target(target: &str) -> Result<bool> {
    let sysroot = said(Command::new("rustc").args(["--print", "sysroot"]))?;
    if Path::new(sysroot.trim()).join("lib/rustlib").join(target).exists() {
        return Ok(true);
    }
    let status = Command::new("timeout").args(["300", "rustup", "target", "add", target]).status();
    Ok(status.is_ok_and(|status| status.success()))
}

impl Compiler {
    /// Builds programs of a package.
    ///
    /// # Errors
    ///
    /// What the compiler or the linker said.
    pub fn build(&self, package: &str, binaries: &[String], profile: &str) -> Result<()> {
        if binaries.is_empty() {
            return Ok(());
        }
        let mut command = Command::new("cargo");
        command.args(["build", "--quiet", "--profile", profile, "--target", self.target]);
        command.args(["-p", package]);
        for binary in binaries {
            command.args(["--bin", binary]);
        }
        if self.debian {
            let key = self.target.to_uppercase().replace('-', "_");
            command
                .args(["-Zbuild-std=core", "--target-dir", "target/debian"])
                .env("RUSTC", DEBIAN[0])
                .env("RUSTC_BOOTSTRAP", "1")
                .env(format!("CARGO_TARGET_{key}_LINKER"), DEBIAN[1]);
        }
        let output = command.output().map_err(|error| format!("cargo: {error}"))?;
        if output.status.success() {
            return Ok(());
        }
        Err(format!("{command:?}\n{}", String::from_utf8_lossy(&output.stderr)))
    }

    /// Where a program is.
    pub fn binary(&self, profile: &str, name: &str) -> PathBuf {
        let folder = if self.debian { "target/debian" } else { "target" };
        Path::new(folder).join(self.target).join(profile).join(name)
    }

    /// The compiler's name and version, on which counts depend.
    pub fn version(&self) -> Result<String> {
        let compiler = if self.debian { DEBIAN[0] } else { "rustc" };
        Ok(said(Command::new(compiler).arg("--version"))?.trim().into())
    }
}

fn said(command: &mut Command) -> Result<String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
