//! Programs in C, linked with the static library.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The static library, with checked arithmetic: of those that Cargo built beside this test, which
/// depends on it, the newest with the same table. Its name ends in a hash.
pub fn library() -> PathBuf {
    let test = env::current_exe().expect("the path of this test");
    let folder = fs::read_dir(test.parent().expect("a folder")).expect("the folder of this test");
    let libraries = folder.map(|entry| entry.expect("an entry").path()).filter(|path| {
        let name = path.file_name().map(|name| name.to_string_lossy());
        name.is_some_and(|name| name.starts_with("libeigenshade_capi-") && name.ends_with(".a"))
    });
    let modified = |path: &PathBuf| fs::metadata(path).and_then(|of| of.modified()).ok();
    // As the compiler names what is in the module `generated`.
    let has_own_table = |path: &PathBuf| {
        let bytes = fs::read(path).expect("a library");
        bytes.windows(20).any(|name| name == b"eigenshade9generated")
    };
    let libraries = libraries.filter(|path| has_own_table(path) == cfg!(feature = "own-table"));
    libraries.max_by_key(modified).expect("a static library beside this test")
}

/// Runs a command that must succeed, and returns its output.
pub fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{text}{errors}");
    text
}

/// Compiles a program from these sources under sanitizers, with headers of its own, by name and
/// text, beside those of the library or in place of one.
pub fn compiled(name: &str, sources: &[&Path], headers: &[(&str, &str)]) -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let to = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("capi").join(name);
    fs::create_dir_all(to).expect("a directory of its own");
    for entry in fs::read_dir(here.join("include")).expect("the headers") {
        let entry = entry.expect("a header");
        fs::copy(entry.path(), to.join(entry.file_name())).expect("the header is copied");
    }
    for (name, text) in headers {
        fs::write(to.join(name), text).expect("the header is written");
    }
    let program = to.join("program");
    let compiler = env::var_os("CC").unwrap_or_else(|| OsString::from("cc"));
    let mut command = Command::new(compiler);
    command.args(["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]);
    command.args(["-g", "-O1"]);
    command.args(["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]);
    command.arg("-I").arg(to);
    command.args(sources).arg(library()).args(["-lm", "-lpthread", "-ldl"]);
    run(command.arg("-o").arg(&program));
    program
}
