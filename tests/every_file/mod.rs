//! Whether every file of tests is in some binary: one that nobody names would be compiled into
//! nothing, without a word.

/// Files in the folder that this `main.rs` does not name, but for itself and those with a binary
/// of their own.
pub fn left_out(folder: &str, main: &str, apart: &[&str]) -> Vec<String> {
    let names = std::fs::read_dir(folder).expect("a folder").map(|entry| {
        entry.expect("an entry").file_name().into_string().expect("a name of letters")
    });
    let files = names.filter_map(|name| name.strip_suffix(".rs").map(str::to_owned));
    let is_named = |name: &str| main.lines().any(|line| line == format!("mod {name};"));
    files
        .filter(|name| name != "main" && !apart.contains(&name.as_str()) && !is_named(name))
        .collect()
}
