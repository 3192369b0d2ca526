//! `experiments paper`: what it writes, and what it reports about a folder that differs.

use crate::support::{Folder, assert_fails, repository};
use experiments::paper::compare::compare;
use experiments::paper::make;
use experiments::paper::output_file::{Content, OutputFile};
use indicatif::ProgressBar;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    entries.map(|entry| entry.expect("an entry").file_name().into_string().unwrap()).collect()
}

/// The tables and figures in `docs` are those that the command writes, every file. Damage to each
/// of them is found, and the file is named.
#[test]
fn the_committed_figures_are_what_the_command_writes() {
    let (folder, docs) = (Folder::new(), repository().join("docs"));
    let files = make(&docs, &ProgressBar::hidden()).expect("the shipped data");
    let [numbers, pixels] = compare(&files, &docs).unwrap_or_else(|error| panic!("{error}"));
    assert!(numbers > 38_000 && pixels > 5_000_000, "{numbers} {pixels}");
    for file in &files {
        if let Content::Text(text) = &file.content {
            let first = text.lines().next().unwrap();
            assert!(first.replace(" -- ", " ").contains("experiments paper"), "{}", file.name);
        }
        file.write(&folder.path(".")).expect("written");
    }
    assert_eq!(names(&folder.path("paper")), names(&docs.join("paper")));
    // Every figure has its numbers and its picture, and the page shows both.
    let page = folder.read("paper.md");
    for link in page.split("](paper").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(folder.path(&format!("paper{link}")).exists(), "{link}");
    }
    for name in names(&folder.path("paper")) {
        assert!(page.contains(&format!("](paper/{name})")), "{name}");
    }

    let check = || compare(&files, &folder.path(".")).map_err(|error| error.to_string());
    check().expect("nothing is damaged");
    let found = |name: &str, words: &[&str]| {
        let message = check().expect_err(name);
        for word in [&[name][..], words].concat() {
            assert!(message.contains(word), "{name}: {message}");
        }
        assert!(!message.contains('\n'), "{message}");
    };
    // A number, a line of a chart, a row of a table; half a file.
    for (name, from, to) in [
        ("paper/error.csv", "0.0", "0.1"),
        ("paper/bound.svg", "points=\"9", "points=\"6"),
        ("paper.md", "| velvet, forest | 10 %", "| velvet, forest | 11 %"),
    ] {
        let good = folder.read(name);
        let lines: Vec<&str> = good.lines().collect();
        let place = lines.iter().skip(12).position(|line| line.contains(from)).unwrap() + 12;
        let line = lines[place].replacen(from, to, 1);
        folder.write(name, good.replacen(lines[place], &line, 1));
        found(name, &["belongs", "paper --out", &format!("{name}:{}: ", place + 1)]);
        folder.write(name, lines[..lines.len() / 2].join("\n"));
        found(name, &["paper --out"]);
        fs::remove_file(folder.path(name)).unwrap();
        found(name, &["missing", "paper --out"]);
        folder.write(name, good);
    }
    for name in names(&folder.path("paper")).iter().filter(|name| name.ends_with(".png")) {
        let name = format!("paper/{name}");
        let file = files.iter().find(|file| file.name == name);
        let Some(Content::Picture(canvas)) = file.map(|one| &one.content) else { panic!() };
        let write = |content| {
            let file = OutputFile { name: name.clone(), content: Content::Picture(content) };
            file.write(&folder.path(".")).expect("written");
        };
        let good = fs::read(folder.path(&name)).unwrap();
        // One pixel in the middle of the picture, three levels brighter.
        let mut changed = canvas.clone();
        let (column, row) = (canvas.width / 2, canvas.height / 2);
        let byte = &mut changed.bytes[3 * (row * canvas.width + column)];
        *byte = byte.checked_add(3).unwrap_or(0);
        write(changed);
        found(&name, &[&format!("pixel ({column}, {row})"), "belongs", "paper --out"]);
        let mut short = canvas.clone();
        short.bytes.truncate(3 * canvas.width * (canvas.height - 1));
        short.height -= 1;
        write(short);
        found(&name, &["pixels where", "paper --out"]);
        folder.write(&name, &good[..good.len() / 2]);
        found(&name, &["cut short", "paper --out"]);
        folder.write(&name, good);
    }
    folder.write("paper/old.svg", "<svg/>");
    found("paper/old.svg", &["no such figure", "remove"]);
    fs::remove_file(folder.path("paper/old.svg")).unwrap();
    check().expect("all is whole again");
    // Through the command line.
    assert_eq!(folder.ok("paper --check ."), "");
    fs::copy(folder.path("paper/eigenimages_1000.png"), folder.path("paper/eigenimages.png"))
        .unwrap();
    assert_fails(&folder, "paper --check .", &["paper/eigenimages.png", "pixel (", "paper --out"]);
}

#[test]
fn bad_folders_fail_before_the_work() {
    let folder = Folder::new();
    folder.write("file", "");
    let start = std::time::Instant::now();
    assert_fails(&folder, "paper --out file", &["file"]);
    assert_fails(&folder, "paper --check nowhere", &["nowhere", "paper.md"]);
    folder.write("paper.md", "a page without tables\n");
    assert_fails(&folder, "paper --out .", &["paper.md", "markers"]);
    // The work takes a minute.
    assert!(start.elapsed().as_secs() < 30);
    assert_eq!(folder.run("paper").status.code(), Some(2));
    assert_eq!(folder.run("paper --out a --check b").status.code(), Some(2));
}
