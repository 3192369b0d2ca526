//! The C program of `example/` on the host: its checks, compiled by the host's C compiler
//! with sanitizers, linked with the static library.
#![cfg(unix)]

mod golden_header;

use std::f64::consts::PI;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The static library, its arithmetic checked. What Cargo builds for the tests themselves
/// has no name of its own; so it is asked once more, and has it.
fn library() -> PathBuf {
    run(Command::new(env!("CARGO")).args(["build", "--quiet", "-p", env!("CARGO_PKG_NAME")]));
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the target directory");
    target.join("debug/libeigenshade_capi.a")
}

/// Runs a command that has to succeed, and gives what it says.
fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let complained = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{said}{complained}");
    said
}

/// The program of these sources.
fn compiled(name: &str, sources: &[&Path], flags: &[&str]) -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let to = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("capi").join(name);
    fs::create_dir_all(to).expect("a directory of its own");
    let golden = golden_header::text().expect("the golden file");
    fs::write(to.join("golden.h"), golden).expect("the header is written");
    let program = to.join("program");
    let compiler = env::var_os("CC").unwrap_or_else(|| OsString::from("cc"));
    let mut command = Command::new(compiler);
    command.args(["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-g", "-O1"]);
    command.args(flags).arg("-I").arg(here.join("include")).arg("-I").arg(to);
    command.args(sources).arg(library()).args(["-lm", "-lpthread", "-ldl"]);
    run(command.arg("-o").arg(&program));
    program
}

#[test]
fn the_checks_hold_under_sanitizers() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("example");
    let sources = ["host.c", "say.c", "checks.c", "faults.c"].map(|name| example.join(name));
    let sources: Vec<&Path> = sources.iter().map(PathBuf::as_path).collect();
    let sanitizers = "-fsanitize=address,undefined";
    let program = compiled("checks", &sources, &[sanitizers, "-fno-sanitize-recover=all"]);
    assert_eq!(run(&mut Command::new(program)), "0 faults\n");
}

/// The README's example is a program, and right: 3.5 Y_0^0 at the rim, 2/3 of Y_1^0 more
/// where the normal faces the camera. Fifty components give two digits.
#[test]
fn the_readme_is_right() {
    let readme = include_str!("../README.md");
    let (_, rest) = readme.split_once("```c\n").expect("an example in C");
    let (example, _) = rest.split_once("```").expect("its end");
    let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme.c");
    fs::write(&source, example).expect("the example is written");
    let program = compiled("readme", &[&source], &["-fsanitize=address,undefined"]);
    let rim = 3.5 * (1.0 / (4.0 * PI)).sqrt();
    let facing = rim + 2.0 / 3.0 * (3.0 / (4.0 * PI)).sqrt();
    let said = format!("{facing:.2} facing, {rim:.2} at the rim\n");
    assert_eq!(run(&mut Command::new(program)), said);
}

/// The two faces of integers are one text: what reads them for the header expands no macros,
/// so they stand twice, and may differ where their formats do and nowhere else.
#[test]
fn the_faces_of_integers_are_one_text() {
    let short = include_str!("../src/q15.rs");
    let renamed = short.replace("Q15", "Q31").replace("q15", "q31").replace("i16", "i32");
    let apart = |line: &&str| {
        !line.starts_with("//") && !line.contains("numbers: [i") && !line.contains("exponents: [i")
    };
    let lines =
        |text: &str| -> Vec<String> { text.lines().filter(apart).map(Into::into).collect() };
    assert_eq!(lines(&renamed), lines(include_str!("../src/q31.rs")));
}
