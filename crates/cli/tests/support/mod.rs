//! The program on small scenes in folders of their own.
#![allow(dead_code, reason = "each test takes what it needs")]

pub mod objects;

pub mod reading;

use eigenshade_index::{light, material};
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

/// Degree and order of the small scene.
pub const DEGREE: usize = 4;
pub const ORDER: usize = 3;

/// A folder with `lights.csv`, `materials.csv`, `normals.csv` and `scene.toml`.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        let folder = Self(TempDir::new().expect("a folder"));
        folder.write("lights.csv", lights(DEGREE, 3));
        folder.write("materials.csv", materials(ORDER, 4));
        folder.write("normals.csv", normals());
        folder.write("scene.toml", scene("image-centered", 10_000, "[]"));
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        fs::write(self.path(name), text).expect("a file");
        self.path(name)
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).expect("a text")
    }

    /// The program in this folder; arguments are split at blanks.
    pub fn run(&self, arguments: &str) -> Output {
        let command = arguments.split_whitespace().next().unwrap_or_default();
        Command::new(crate::program(command))
            .current_dir(self.0.path())
            .args(arguments.split_whitespace())
            .output()
            .expect("the program runs")
    }

    /// Its standard output; it has to succeed.
    pub fn ok(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments}: {errors}");
        String::from_utf8(output.stdout).expect("text")
    }

    /// The same folder with the table of its scene as `b.bin`.
    pub fn with_table() -> Self {
        let folder = Self::new();
        folder.ok("basis --scene scene.toml --out b.bin");
        folder
    }

    /// Names of all files, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("a folder");
        let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
        let mut names: Vec<String> = entries.map(|entry| name(entry.expect("an entry"))).collect();
        names.sort();
        names
    }
}

/// Exit status 1, one line that begins with `error: ` and holds `words`, and no
/// other file than before.
pub fn assert_fails(folder: &Folder, arguments: &str, words: &[&str]) {
    let before = folder.names();
    let output = folder.run(arguments);
    let line = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments}: {line}");
    assert!(line.starts_with("error: ") && line.lines().count() == 1, "{arguments}: {line}");
    assert!(line.contains("; "), "no remedy: {line}");
    assert!(!line.contains(".eigenshade-"), "a temporary name: {line}");
    for word in words {
        assert!(line.contains(word), "{arguments}: no `{word}` in {line}");
    }
    assert_eq!(folder.names(), before, "{arguments}");
}

/// Fields of a CSV, the header apart; all rows are as long as it.
pub fn rows(text: &str, header: &str) -> Vec<Vec<String>> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.next(), Some(header));
    let split = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let rows: Vec<_> = lines.map(split).collect();
    assert!(rows.iter().all(|row| row.len() == header.split(',').count()));
    rows
}

/// The last `count` fields of each row as numbers.
pub fn numbers(rows: &[Vec<String>], count: usize) -> Vec<f64> {
    let last = |row: &Vec<String>| row[row.len() - count..].to_vec();
    rows.iter().flat_map(last).map(|field| field.parse().expect("a number")).collect()
}

/// Numbers in [-1/2, 1/2], always the same.
pub fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1u64 << 31) as f64 - 0.5
    }
}

pub fn lights(degree: usize, count: usize) -> String {
    let (mut text, mut noise) = ("name,l,m,r,g,b\n".to_owned(), noise(7));
    for name in 0..count {
        for (l, m) in light::indices(degree) {
            let mut value = || if l == 0 { 2.0 + noise() } else { noise() / l as f64 };
            let (r, g, b) = (value(), value(), value());
            writeln!(text, "light-{name},{l},{m},{r},{g},{b}").expect("text");
        }
    }
    text
}

pub fn materials(order: usize, count: usize) -> String {
    let (mut text, mut noise) = ("name,o,p,q,value\n".to_owned(), noise(11));
    for name in 0..count {
        for (o, p, q) in material::indices(order) {
            let value = if o == 0 { 1.0 + noise() } else { noise() / (o + p + q) as f64 };
            writeln!(text, "material-{name},{o},{p},{q},{value}").expect("text");
        }
    }
    text
}

/// Pole and rim included.
fn normals() -> String {
    let mut text = "x,y,z\n0,0,1\n1,0,0\n0,-1,0\n".to_owned();
    let mut noise = noise(13);
    for _ in 0..40 {
        writeln!(text, "{},{},{}", noise(), noise(), noise().abs()).expect("text");
    }
    text
}

pub fn scene(criterion: &str, components: usize, names: &str) -> String {
    format!(
        "[geometry]\nnormals = \"sphere\"\n\
         [light]\ndegree = {DEGREE}\ndatabase = \"lights.csv\"\nrotation = \"any\"\n\
         [material]\norder = {ORDER}\ndatabase = \"materials.csv\"\nnames = {names}\n\
         [basis]\ncriterion = \"{criterion}\"\ncomponents = {components}\n\
         profile_tolerance = 1e-12\n"
    )
}

pub use eigenshade_testing::repository;

/// What the program in `src/main.rs` of this folder prints, once it is compiled.
pub fn compiled(folder: &Folder) -> String {
    // The lock file keeps the dependencies at those that are there.
    fs::copy(repository().join("Cargo.lock"), folder.path("Cargo.lock")).expect("a lock file");
    folder.write(
        "Cargo.toml",
        format!(
            "[package]\nname = \"baked\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[workspace]\n\
             [dependencies]\neigenshade = {{ path = {:?}, default-features = false }}\n",
            repository().canonicalize().expect("a path")
        ),
    );
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline"])
        .current_dir(folder.path("."))
        .env("CARGO_TARGET_DIR", folder.path("target"))
        .output()
        .expect("cargo runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    String::from_utf8(output.stdout).expect("text")
}
