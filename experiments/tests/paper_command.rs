//! `experiments paper`: the files that it writes, and its report on a folder that differs.

use crate::support::{Folder, assert_fails, repository};
use eigenshade_cli::picture::Canvas;
use eigenshade_generator::png_samples;
use experiments::figures::{Content, OutputFile};
use experiments::paper::FIGURES;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    entries.map(|entry| entry.expect("an entry").file_name().into_string().unwrap()).collect()
}

/// A committed file, as the command would make it.
fn committed(name: &str) -> OutputFile {
    let path = repository().join("docs").join(name);
    let content = if name.ends_with(".png") {
        let found = png_samples::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let mut canvas = Canvas::new(found.width, found.height, [0; 3]);
        let samples = found.colors.as_flattened().iter();
        canvas.bytes = samples.map(|&one| u8::try_from(one).expect("8 bits")).collect();
        Content::Picture(canvas)
    } else {
        Content::Text(fs::read_to_string(path).expect("a text"))
    };
    OutputFile { name: name.into(), content }
}

/// Every file in `docs` is shown by the page and names its command. That one is missing, foreign or
/// cut short is found, and the file is named. That the command makes these files, `paper --check
/// docs` checks.
#[test]
fn damage_to_every_committed_file_is_found() {
    let docs = repository().join("docs");
    let figures = names(&docs.join("paper")).into_iter().map(|name| format!("paper/{name}"));
    let files: Vec<OutputFile> =
        figures.chain(["paper.md".into()]).map(|name| committed(&name)).collect();
    let [numbers, pixels] =
        FIGURES.compare(&files, &docs).unwrap_or_else(|error| panic!("{error}"));
    assert!(numbers > 38_000 && pixels > 5_000_000, "{numbers} {pixels}");
    let page = fs::read_to_string(docs.join("paper.md")).expect("a page");
    for file in &files {
        let name = &file.name;
        assert!(name == "paper.md" || page.contains(&format!("]({name})")), "{name}");
        damage_is_found(file);
    }
}

/// In a folder of its own, so that no other file is read again.
fn damage_is_found(file: &OutputFile) {
    let (folder, name) = (Folder::new(), file.name.as_str());
    let compare = || FIGURES.compare(std::slice::from_ref(file), &folder.path("."));
    let found = |words: &[&str]| {
        let message = compare().expect_err(name).to_string();
        for word in [&[name], words].concat() {
            assert!(message.contains(word), "{name}: {message}");
        }
        assert!(!message.contains('\n'), "{message}");
    };
    fs::create_dir(folder.path("paper")).unwrap();
    found(&["missing", "paper --out"]);
    file.write(&folder.path(".")).expect("written");
    compare().expect("nothing is damaged");
    folder.write("paper/old.svg", "<svg/>");
    let message = compare().expect_err(name).to_string();
    assert!(message.contains("old.svg: the program makes no such figure; remove"), "{message}");
    fs::remove_file(folder.path("paper/old.svg")).unwrap();
    let good = fs::read(folder.path(name)).unwrap();
    folder.write(name, &good[..good.len() / 2]);
    found(&[if name.ends_with(".png") { "cut short" } else { "paper --out" }]);
    if let Content::Text(text) = &file.content {
        let first = text.lines().next().unwrap();
        assert!(first.replace(" -- ", " ").contains("experiments paper"), "{name}");
    }
}

/// Of both commands, whose work takes minutes.
#[test]
fn bad_folders_fail_before_the_work() {
    let folder = Folder::new();
    folder.write("file", "");
    for (command, file) in [("paper", "paper.md"), ("accuracy-cost", "accuracy-cost.csv")] {
        assert_fails(&folder, &format!("{command} --out file"), &["file"]);
        assert_fails(&folder, &format!("{command} --check nowhere"), &["nowhere", file]);
        for usage in ["", "--out a --check b"] {
            let status = folder.run(&format!("{command} {usage}")).status;
            assert_eq!(status.code(), Some(2), "{command} {usage}");
        }
    }
    folder.write("paper.md", "a page without tables\n");
    assert_fails(&folder, "paper --out .", &["paper.md", "markers"]);
    fs::create_dir(folder.path("docs")).unwrap();
    folder.write("docs/accuracy-cost.csv", "");
    let missing = &["esplanade.exr", "no such map", "--maps"];
    assert_fails(&folder, "accuracy-cost --check docs --maps nowhere", missing);
    fs::create_dir(folder.path("maps")).unwrap();
    folder.write("maps/esplanade.exr", "no map");
    assert_fails(&folder, "accuracy-cost --check docs --maps maps", &["esplanade.exr"]);
}
