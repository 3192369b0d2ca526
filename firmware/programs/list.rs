//! The list of programs, which is `bin` in Cargo.toml. The build script and the host share this
//! file.

/// A program of the list.
#[derive(Clone, Copy, Debug)]
pub struct Listed {
    /// Its name.
    pub name: &'static str,
    /// The file in `src` with its source, without `.rs`.
    pub source: &'static str,
    /// Whether it needs the feature `tables`.
    pub needs_tables: bool,
}

/// All programs, in the order of the list.
pub fn programs() -> impl Iterator<Item = Listed> {
    let lines = include_str!("Cargo.toml").lines().map(str::trim);
    lines.filter(|line| line.starts_with("{ name")).map(|line| {
        let texts: Vec<&str> = line.split('"').collect();
        let [_, name, _, path, _, rest @ ..] = &texts[..] else {
            panic!("`{line}` lists no program")
        };
        let source = path.trim_start_matches("src/").trim_end_matches(".rs");
        Listed { name, source, needs_tables: rest.contains(&"tables") }
    })
}

/// The parts of a program's name: an operation or a table; and the number format.
pub fn parts(name: &str) -> (&str, &str) {
    name.rsplit_once('_').unwrap_or((name, "none"))
}
