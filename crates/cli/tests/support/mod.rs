//! The program on small scenes in folders of their own. The tests of the experiments use it as
//! well.
#![allow(dead_code, reason = "no package uses all of it")]
pub mod files;

pub use eigenshade_testing::repository;

use eigenshade_index::{light, material};
use eigenshade_table::{Table, decode};
use eigenshade_testing::largest;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::OnceLock;
use tempfile::TempDir;

/// Degree and order of the small scene.
pub const DEGREE: usize = 4;
pub const ORDER: usize = 3;

/// The options and the header of `shade`.
pub const PAIR: &str = "--light lights.csv --material materials.csv";
pub const SHADED: &str = "light,material,normal,r,g,b";

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

    /// Runs the program in this folder; arguments are split at blanks.
    pub fn run(&self, arguments: &str) -> Output {
        let command = arguments.split_whitespace().next().unwrap_or_default();
        Command::new(crate::program(command))
            .current_dir(self.0.path())
            .args(arguments.split_whitespace())
            .output()
            .expect("the program runs")
    }

    /// The standard output of a command that has to succeed.
    pub fn ok(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments}: {errors}");
        String::from_utf8(output.stdout).expect("text")
    }

    /// The standard error of a command that has to succeed.
    pub fn messages(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        let messages = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{arguments}: {messages}");
        messages
    }

    /// The same folder with the table of its scene as `b.bin`.
    pub fn with_table() -> Self {
        static FILES: OnceLock<[Vec<u8>; 2]> = OnceLock::new();
        const NAMES: [&str; 2] = ["b.bin", "b.manifest.csv"];
        let made = || {
            let folder = Self::new();
            folder.ok("basis --scene scene.toml --out b.bin");
            NAMES.map(|name| fs::read(folder.path(name)).expect("a file"))
        };
        let folder = Self::new();
        for (name, bytes) in NAMES.iter().zip(FILES.get_or_init(made)) {
            folder.write(name, bytes);
        }
        folder
    }

    /// The table in this file.
    pub fn table(&self, name: &str) -> Table {
        decode(&fs::read(self.path(name)).expect("a file")).expect("a table")
    }

    /// The irradiance that `shade` gives with the table `b.bin`.
    pub fn shaded(&self, options: &str) -> Vec<f64> {
        self.shaded_by("b.bin", options)
    }

    /// The irradiance that `shade` gives with this table.
    pub fn shaded_by(&self, table: &str, options: &str) -> Vec<f64> {
        let text =
            self.ok(&format!("shade --table {table} {PAIR} --normals normals.csv {options}"));
        numbers(&rows(&text, SHADED), 3)
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

/// Asserts exit status 1, one line that begins with `error: ` and contains the fragments, and no
/// new file.
pub fn assert_fails(folder: &Folder, arguments: &str, fragments: &[&str]) {
    let before = folder.names();
    let output = folder.run(arguments);
    let line = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments}: {line}");
    assert!(line.starts_with("error: ") && line.lines().count() == 1, "{arguments}: {line}");
    assert!(line.contains("; "), "no remedy: {line}");
    assert!(!line.contains(".eigenshade-"), "a temporary name: {line}");
    for fragment in fragments {
        assert!(line.contains(fragment), "{arguments}: no `{fragment}` in {line}");
    }
    assert_eq!(folder.names(), before, "{arguments}");
}

/// The fields of a CSV below its header; all rows are as long as it.
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

/// Numbers in [-1/2, 1/2], the same in every run.
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

/// Gray materials with these shares of green and blue.
pub fn colored(gray: &str, [green, blue]: [f64; 2]) -> String {
    let row = |line: &str| match line.rsplit_once(',').expect("a row") {
        (places, "value") => format!("{places},r,g,b\n"),
        (places, value) => {
            let red: f64 = value.parse().expect("a number");
            format!("{places},{red},{},{}\n", green * red, blue * red)
        }
    };
    gray.lines().map(row).collect()
}

/// The CSV of `count` normals, each of which represents an equal area of a sphere's picture.
pub fn of_equal_areas(count: usize) -> String {
    let normals = eigenshade_testing::fixtures::of_equal_areas(count).into_iter();
    "x,y,z\n".to_owned() + &normals.map(|[x, y, z]| format!("{x},{y},{z}\n")).collect::<String>()
}

/// Normals, with the pole and the rim.
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

/// The largest |a - b|, relative to the largest |b|.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    largest(a.iter().zip(b).map(|(a, b)| a - b)) / largest(b.iter().copied())
}
