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

impl Compiler {
    /// The compiler for this target: rustup's, or with `EIGENSHADE_CI_DEBIAN=1`, which
    /// `firmware/run` sets where that has no targets, Debian's.
    pub fn new(target: &'static str) -> Self {
        Self { target, debian: std::env::var_os("EIGENSHADE_CI_DEBIAN").is_some() }
    }

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
