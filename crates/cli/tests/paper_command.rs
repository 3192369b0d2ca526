//! `eigenshade paper`: what it writes, and what it says of a folder that is not so.

mod support;

use eigenshade_cli::paper::comparison::compare_texts;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use support::{Folder, assert_fails, repository};

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    entries.map(|entry| entry.expect("an entry").file_name().into_string().unwrap()).collect()
}

/// The page and figures in `docs` are those that the command writes; each damage to
/// them is found.
#[test]
fn the_committed_page_is_what_the_command_writes() {
    let (folder, docs) = (Folder::new(), repository().join("docs"));
    assert_eq!(folder.ok("paper --out ."), "");
    let written = names(&folder.path("paper"));
    assert_eq!(written, names(&docs.join("paper")));
    let mut compared = 0;
    let texts = written.iter().filter(|name| name.ends_with(".csv"));
    let texts = texts.map(|name| format!("paper/{name}")).chain(["paper.md".into()]);
    for name in texts {
        let committed = fs::read_to_string(docs.join(&name)).expect("a text");
        let numbers = compare_texts(&committed, &folder.read(&name));
        compared += numbers.unwrap_or_else(|(line, what)| panic!("{name}:{line}: {what}"));
        let first = committed.lines().next().unwrap();
        assert!(first.contains("eigenshade paper"), "{name}");
    }
    assert!(compared > 20_000, "{compared}");
    // Every figure of the page is there.
    let page = folder.read("paper.md");
    for link in page.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(folder.path(link).exists(), "{link}");
    }

    let sheet = folder.read("paper/error.csv");
    let row = sheet.lines().nth(12).expect("a row").to_owned();
    let doctored = row.replacen("0.0", "0.1", 1);
    assert_ne!(row, doctored);
    folder.write("paper/error.csv", sheet.replace(&row, &doctored));
    assert_fails(&folder, "paper --check .", &["paper/error.csv:13: ", "belongs", "paper --out ."]);
}

#[test]
fn bad_folders_are_told_before_the_work() {
    let folder = Folder::new();
    folder.write("file", "");
    let start = std::time::Instant::now();
    assert_fails(&folder, "paper --out file", &["file"]);
    assert_fails(&folder, "paper --check nowhere", &["nowhere", "paper.md"]);
    assert!(start.elapsed().as_secs() < 3);
    assert_eq!(folder.run("paper").status.code(), Some(2));
    assert_eq!(folder.run("paper --out a --check b").status.code(), Some(2));
}
