//! The program on small scenes in folders of their own. The tests of the report use it as
//! well.
#![allow(dead_code, reason = "no package uses all of it")]
pub mod files;

pub use eigenshade_testing::repository;

use eigenshade_table::{Table, decode, light, material};
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

/// All lights and all materials.
pub const PAIR: &str = "--light lights.csv --material materials.csv";

/// Shades the small scene.
pub const SHADE: &str =
    "shade --table b.bin --light lights.csv --material materials.csv --normals normals.csv";

/// The header of `shade`.
pub const SHADED: &str = "light,material,normal,r,g,b";

/// The header of `project`.
pub const PROJECTED: &str = "light,material,component,r,g,b";

/// Makes the table of the small scene.
pub const BASIS: &str = "basis --scene scene.toml --out b.bin";

/// The same under the name of another table.
pub const NEW_BASIS: &str = "basis --scene scene.toml --out new.bin";

/// The header of a file of sources, with its line end.
pub const SOURCES: &str = "light,x,y,z,r,g,b,spread\n";

/// A folder with `lights.csv`, `materials.csv`, `normals.csv` and `scene.toml`.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self::of_size(DEGREE, ORDER, [3, 4])
    }

    /// The same of another degree and order, with these numbers of lights and materials.
    pub fn of_size(degree: usize, order: usize, counts: [usize; 2]) -> Self {
        let folder = Self(TempDir::new().expect("a folder"));
        folder.write("lights.csv", lights(degree, counts[0]));
        folder.write("materials.csv", materials(order, counts[1]));
        // With the pole and the rim.
        folder.write("normals.csv", normals("0,0,1\n1,0,0\n0,-1,0\n", 13, 40));
        folder.write("scene.toml", scene("image-centered", 10_000, "[]"));
        folder.replace("scene.toml", "degree = 4", &format!("degree = {degree}"));
        folder.replace("scene.toml", "order = 3", &format!("order = {order}"));
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

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).expect("a file")
    }

    /// Replaces every occurrence of a text in a file.
    pub fn replace(&self, name: &str, from: &str, to: &str) {
        self.write(name, self.read(name).replace(from, to));
    }

    /// Runs the program in this folder; arguments are split at blanks. A test that fails shows the
    /// last command.
    pub fn run(&self, arguments: &str) -> Output {
        println!("{arguments}");
        let command = arguments.split_whitespace().next().unwrap_or_default();
        Command::new(crate::program(command))
            .current_dir(self.0.path())
            .args(arguments.split_whitespace())
            .output()
            .expect("the program runs")
    }

    /// Runs a line of the shell in this folder.
    pub fn shell(&self, script: &str) -> Output {
        println!("{script}");
        let shell = Command::new("sh").args(["-c", script]).current_dir(self.0.path()).output();
        shell.expect("a shell")
    }

    /// The standard output and the standard error of a command that has to succeed.
    pub fn both(&self, arguments: &str) -> (String, String) {
        let output = self.run(arguments);
        let errors = stderr(&output);
        assert_eq!(output.status.code(), Some(0), "{arguments}: {errors}");
        (String::from_utf8(output.stdout).expect("text"), errors)
    }

    /// The standard output of a command that has to succeed.
    pub fn ok(&self, arguments: &str) -> String {
        self.both(arguments).0
    }

    /// The standard error of a command that has to succeed.
    pub fn messages(&self, arguments: &str) -> String {
        self.both(arguments).1
    }

    /// The messages of `render` but the line that says what a picture was drawn with.
    pub fn notes(&self, arguments: &str) -> String {
        let messages = self.messages(arguments);
        let notes = messages.lines().filter(|line| !line.starts_with("drawn with "));
        notes.map(|line| format!("{line}\n")).collect()
    }

    /// The same folder with the table of its scene as `b.bin`.
    pub fn with_table() -> Self {
        static FILES: OnceLock<[Vec<u8>; 2]> = OnceLock::new();
        const NAMES: [&str; 2] = ["b.bin", "b.manifest.csv"];
        let made = || {
            let folder = Self::new();
            folder.ok(BASIS);
            NAMES.map(|name| folder.bytes(name))
        };
        let folder = Self::new();
        for (name, bytes) in NAMES.iter().zip(FILES.get_or_init(made)) {
            folder.write(name, bytes);
        }
        folder
    }

    /// The table in this file.
    pub fn table(&self, name: &str) -> Table {
        decode(&self.bytes(name)).expect("a table")
    }

    /// The irradiance that `shade` gives with the table `b.bin`.
    pub fn shaded(&self, options: &str) -> Vec<f64> {
        self.shaded_by("b.bin", options)
    }

    /// The irradiance that `shade` gives with this table.
    pub fn shaded_by(&self, table: &str, options: &str) -> Vec<f64> {
        self.irradiance(&format!("--table {table} {PAIR} --normals normals.csv {options}"))
    }

    /// The irradiance that `shade` gives with these options.
    pub fn irradiance(&self, options: &str) -> Vec<f64> {
        numbers(&rows(&self.ok(&format!("shade {options}")), SHADED), 3)
    }

    /// The coefficients that `project` gives with these options.
    pub fn projected(&self, options: &str) -> Vec<f64> {
        numbers(&rows(&self.ok(&format!("project {options}")), PROJECTED), 3)
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
    let line = error_line(&folder.run(arguments));
    assert!(line.contains("; "), "no remedy: {line}");
    assert!(!line.contains(".eigenshade-"), "a temporary name: {line}");
    assert_contains(&line, fragments);
    assert_eq!(folder.names(), before, "{arguments}");
}

/// Asserts exit status 1, and that the standard error, which is returned, is one line that begins
/// with `error: `.
pub fn error_line(output: &Output) -> String {
    let line = stderr(output);
    assert_eq!(output.status.code(), Some(1), "{line}");
    assert!(line.starts_with("error: ") && line.lines().count() == 1, "{line}");
    line
}

pub fn assert_contains(text: &str, fragments: &[&str]) {
    for fragment in fragments {
        assert!(text.contains(fragment), "no `{fragment}` in {text}");
    }
}

/// Asserts that each command is a usage error, and makes no new file.
pub fn assert_usage_errors(folder: &Folder, commands: &[&str]) {
    let before = folder.names();
    for command in commands {
        assert_eq!(folder.run(command).status.code(), Some(2), "{command}");
        assert_eq!(folder.names(), before, "{command}");
    }
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The text of a file of the repository.
pub fn repository_text(name: &str) -> String {
    fs::read_to_string(repository().join(name)).expect("a text")
}

/// The path of a file of the folder `tables`.
pub fn shipped_path(name: &str) -> String {
    repository().join("tables").join(name).display().to_string()
}

/// The scene file `tables/NAME.toml` with paths that hold in any folder.
pub fn shipped_scene(name: &str) -> String {
    let text = repository_text(&format!("tables/{name}.toml"));
    text.replace("\"inputs/", &format!("\"{}/", shipped_path("inputs")))
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

/// The CSV of normals: these rows, and random ones.
pub fn normals(rows: &str, seed: u64, count: usize) -> String {
    let mut noise = noise(seed);
    let random = (0..count).map(|_| format!("{},{},{}\n", noise(), noise(), noise().abs()));
    format!("x,y,z\n{rows}{}", random.collect::<String>())
}

pub fn scene(criterion: &str, components: usize, names: &str) -> String {
    format!(
        "[light]\ndegree = {DEGREE}\ndatabase = \"lights.csv\"\n\
         [material]\norder = {ORDER}\ndatabase = \"materials.csv\"\nnames = {names}\n\
         [basis]\ncriterion = \"{criterion}\"\ncomponents = {components}\n\
         profile_tolerance = 1e-12\n"
    )
}

/// Prints how far numbers are from the expected ones, relative to the largest of these, and asserts
/// that it is within a tolerance.
#[track_caller]
pub fn assert_near(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let error = difference(found, expected);
    println!("{what}: {error:.1e}");
    assert!(error <= tolerance, "{what}: {error:e}");
}

/// The largest |a - b|, relative to the largest |b|.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    largest(a.iter().zip(b).map(|(a, b)| a - b)) / largest(b.iter().copied())
}
