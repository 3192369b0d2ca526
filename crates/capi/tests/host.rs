//! The library exports what the header declares, and the C program of `example/` passes its checks
//! on the host, compiled with sanitizers and linked with the static library.
#![cfg(unix)]

#[path = "support/golden_header.rs"]
mod golden_header;

#[path = "support/pictures.rs"]
mod pictures;

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The static library, with checked arithmetic: the newest of those that Cargo built beside this
/// test, which depends on it. Its name ends in a hash.
fn library() -> PathBuf {
    let test = env::current_exe().expect("the path of this test");
    let folder = fs::read_dir(test.parent().expect("a folder")).expect("the folder of this test");
    let libraries = folder.map(|entry| entry.expect("an entry").path()).filter(|path| {
        let name = path.file_name().map(|name| name.to_string_lossy());
        name.is_some_and(|name| name.starts_with("libeigenshade_capi-") && name.ends_with(".a"))
    });
    let modified = |path: &PathBuf| fs::metadata(path).and_then(|of| of.modified()).ok();
    libraries.max_by_key(modified).expect("a static library beside this test")
}

/// Runs a command that must succeed, and returns its output.
fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{text}{errors}");
    text
}

/// Compiles a program from these sources.
fn compiled(name: &str, sources: &[&Path], flags: &[&str]) -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let to = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("capi").join(name);
    fs::create_dir_all(to).expect("a directory of its own");
    let golden = golden_header::text().expect("the golden file");
    fs::write(to.join("golden.h"), golden).expect("the header is written");
    let program = to.join("program");
    let compiler = env::var_os("CC").unwrap_or_else(|| OsString::from("cc"));
    let mut command = Command::new(compiler);
    command.args(["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]);
    command.args(["-g", "-O1"]);
    command.args(flags).arg("-I").arg(here.join("include")).arg("-I").arg(to);
    command.args(sources).arg(library()).args(["-lm", "-lpthread", "-ldl"]);
    run(command.arg("-o").arg(&program));
    program
}

/// src/header.rs compares their types.
#[test]
fn the_library_exports_the_functions_of_the_header() {
    let symbols = run(Command::new("nm").args(["-g", "--defined-only"]).arg(library()));
    let names = symbols.lines().filter_map(|line| Some(line.rsplit_once(' ')?.1));
    // On some systems C's names have an underscore in front.
    let names = names.map(|name| name.trim_start_matches('_'));
    let exported: BTreeSet<&str> = names.filter(|name| name.starts_with("eigenshade_")).collect();
    let headers = concat!(
        include_str!("../include/eigenshade.h"),
        include_str!("../include/eigenshade_color.h"),
        include_str!("../include/eigenshade_presets.h"),
    );
    let names = headers.split(['(', ';']);
    let words = names.filter_map(|text| text.split([' ', '`', '*']).next_back());
    let declared: BTreeSet<&str> = words.filter(|word| word.starts_with("eigenshade_")).collect();
    // Names of types end a definition as a constant's name does.
    let declared =
        declared.into_iter().filter(|name| !name.ends_with("_t") && *name != "eigenshade_status");
    let declared: BTreeSet<&str> = declared.collect();
    assert_eq!(exported, declared);
}

#[test]
fn the_checks_hold_under_sanitizers() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("example");
    let sources = ["host", "print", "all", "checks", "golden_vectors", "faults"];
    let sources = sources.into_iter().chain(["color", "color_faults"]);
    let sources: Vec<PathBuf> = sources.map(|name| example.join(format!("{name}.c"))).collect();
    let sources: Vec<&Path> = sources.iter().map(PathBuf::as_path).collect();
    let sanitizers = "-fsanitize=address,undefined";
    let program = compiled("checks", &sources, &[sanitizers, "-fno-sanitize-recover=all"]);
    let pictures = pictures::lines().expect("pictures");
    assert_eq!(run(&mut Command::new(program)), format!("{pictures}0 faults\n"));
}

/// The README's sphere is that of the README of the runtime: in integers the same pixels, in floats to
/// one level of a channel.
#[test]
fn the_readme_draws_the_same_sphere_as_rust() {
    let readme = include_str!("../README.md");
    let (_, rest) = readme.split_once("```c\n").expect("an example in C");
    let (example, _) = rest.split_once("```").expect("its end");
    let main = "#include <stdio.h>\nint main(void) {\n  const eigenshade_status status = draw();\n  \
                for (size_t k = 0; k < 240 * 240; k++) printf(\"%u\\n\", (unsigned)screen[k]);\n  \
                return status;\n}\n";
    let drawn = |format: &str| -> Vec<u16> {
        let example = example.replace("f32", format);
        let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("readme_{format}.c"));
        fs::write(&source, example + main).expect("the example is written");
        let name = format!("readme_{format}");
        let program = compiled(&name, &[&source], &["-fsanitize=address,undefined"]);
        let text = run(&mut Command::new(program));
        text.lines().map(|line| line.parse().expect("a pixel")).collect()
    };
    let expected = pictures::gold_sphere(240).expect("a sphere");
    assert!(drawn("q15") == expected);
    for (found, expected) in drawn("f32").into_iter().zip(expected) {
        for (low, bits) in [(0, 5), (5, 6), (11, 5)] {
            let level = |pixel: u16| (pixel >> low) & ((1 << bits) - 1);
            assert!(level(found).abs_diff(level(expected)) <= 1);
        }
    }
}
