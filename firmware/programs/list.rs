//! The operations and the programs, from `operations.csv` and `tables/sizes.csv`. The build script
//! and the host share this file.

/// A row of `operations.csv`.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    /// Its name.
    pub name: &'static str,
    /// The start of the name of the file with its function.
    pub source: &'static str,
    /// The table: a module of the library or of the package `tables`.
    pub table: &'static str,
    /// The number formats, separated by spaces.
    pub formats: &'static str,
    /// Limits of its counts.
    pub limits: [&'static str; 5],
    /// A sentence for docs/costs.md.
    pub description: &'static str,
}

/// All operations.
pub fn operations() -> impl Iterator<Item = Operation> {
    rows(include_str!("../operations.csv")).map(|line| {
        let fields: Vec<&str> = line.splitn(10, ',').collect();
        let [name, source, table, formats, limits @ .., description] = &fields[..] else {
            panic!("`{line}` has too few fields")
        };
        let limits = limits.try_into().expect("ten fields");
        let description = description.trim_matches('"');
        Operation { name, source, table, formats, limits, description }
    })
}

/// The lines of a CSV file after its header.
fn rows(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1)
}

/// An operation in a number format.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The operation or the table that it measures.
    pub operation: &'static str,
    /// The number format: `f32`, `q15` or nothing.
    pub format: &'static str,
    /// The start of the name of the file in `src` with its function.
    pub source: &'static str,
    /// The table: a module of the library or of the package `tables`.
    pub table: &'static str,
}

/// All programs, the empty one first: of the operations, and one for each table of `sizes.csv`.
pub fn programs() -> Vec<Program> {
    let tables =
        rows(include_str!("../tables/sizes.csv")).filter_map(|line| line.split(',').next());
    let of_tables = tables.map(|table| (table, "scene", table, "f32 q15"));
    let of_operations = operations().map(|one| (one.name, one.source, one.table, one.formats));
    let all = of_operations.chain(of_tables).flat_map(|(operation, source, table, formats)| {
        let in_format = move |format| Program { operation, format, source, table };
        formats.split(' ').map(in_format)
    });
    all.collect()
}

impl Program {
    /// Its name, or that of its source.
    fn in_format(&self, name: &str) -> String {
        if self.format.is_empty() { name.into() } else { format!("{name}_{}", self.format) }
    }

    /// Whether it needs more memory than a micro:bit has.
    pub fn is_large(&self) -> bool {
        ["watch", "frames"].contains(&self.source)
    }

    /// The name of its binary.
    pub fn name(&self) -> String {
        self.in_format(self.operation)
    }

    /// Its source in `src`.
    pub fn file(&self) -> String {
        self.in_format(self.source) + ".rs"
    }
}
