//! `experiments paper`: the files that it writes, and its report on a folder that differs.

use crate::support::{Folder, assert_fails, repository};
use eigenshade_cli::picture::Canvas;
use eigenshade_generator::png_samples;
use experiments::paper::compare::compare;
use experiments::paper::output_file::{Content, OutputFile};
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

/// Every file in `docs` is shown by the page and names its command. Damage to each of them is
/// found, and the file is named. That the command makes these files, `paper --check docs` checks.
#[test]
fn damage_to_every_committed_file_is_found() {
    let (folder, docs) = (Folder::new(), repository().join("docs"));
    let figures = names(&docs.join("paper")).into_iter().map(|name| format!("paper/{name}"));
    let files: Vec<OutputFile> =
        figures.chain(["paper.md".into()]).map(|name| committed(&name)).collect();
    let [numbers, pixels] = compare(&files, &docs).unwrap_or_else(|error| panic!("{error}"));
    assert!(numbers > 38_000 && pixels > 5_000_000, "{numbers} {pixels}");
    for file in &files {
        if let Content::Text(text) = &file.content {
            let first = text.lines().next().unwrap();
            assert!(first.replace(" -- ", " ").contains("experiments paper"), "{}", file.name);
        }
        file.write(&folder.path(".")).expect("written");
    }
    // The page shows every file, and no others.
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
    for file in &files {
        if let Content::Picture(canvas) = &file.content {
            damage_to_a_picture_is_found(&file.name, canvas);
        }
    }
    folder.write("paper/old.svg", "<svg/>");
    found("paper/old.svg", &["no such figure", "remove"]);
    fs::remove_file(folder.path("paper/old.svg")).unwrap();
    check().expect("all is whole again");
}

/// In a folder of its own, so that no other picture is read again.
fn damage_to_a_picture_is_found(name: &str, canvas: &Canvas) {
    let folder = Folder::new();
    let file = |canvas: &Canvas| OutputFile {
        name: name.into(),
        content: Content::Picture(canvas.clone()),
    };
    let whole = [file(canvas)];
    let found = |words: &[&str]| {
        let error = compare(&whole, &folder.path(".")).expect_err(name).to_string();
        for word in [&[name, "paper --out"], words].concat() {
            assert!(error.contains(word), "{name}: {error}");
        }
        assert!(!error.contains('\n'), "{error}");
    };
    // One pixel in the middle of the picture, three levels brighter.
    let mut changed = canvas.clone();
    let (column, row) = (canvas.width / 2, canvas.height / 2);
    let byte = &mut changed.bytes[3 * (row * canvas.width + column)];
    *byte = byte.checked_add(3).unwrap_or(0);
    file(&changed).write(&folder.path(".")).expect("written");
    found(&[&format!("pixel ({column}, {row})"), "belongs"]);
    let mut short = canvas.clone();
    short.bytes.truncate(3 * canvas.width * (canvas.height - 1));
    short.height -= 1;
    file(&short).write(&folder.path(".")).expect("written");
    found(&["pixels where"]);
    whole[0].write(&folder.path(".")).expect("written");
    compare(&whole, &folder.path(".")).expect("nothing is damaged");
    let good = fs::read(folder.path(name)).unwrap();
    folder.write(name, &good[..good.len() / 2]);
    found(&["cut short"]);
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
