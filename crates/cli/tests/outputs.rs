//! Where outputs go: permissions, links, pipes, signals, collisions; and names that a terminal
//! would interpret.
#![cfg(unix)]

use crate::PROGRAM;
use crate::support::files::{READ, map, with_image};
use crate::support::{BASIS, DEGREE, Folder, ORDER, PAIR, assert_fails, lights, materials, rows};
use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const WRITE: &str = "light lights.csv --degree 2 --out";

/// The permissions of a file.
fn mode(folder: &Folder, name: &str) -> u32 {
    fs::metadata(folder.path(name)).unwrap().mode() & 0o7777
}

fn set_mode(folder: &Folder, name: &str, bits: u32) {
    fs::set_permissions(folder.path(name), Permissions::from_mode(bits)).unwrap();
}

#[test]
fn a_replaced_output_keeps_its_mode() {
    let folder = Folder::new();
    for bits in [0o600, 0o640, 0o666, 0o755, 0o200] {
        folder.write("old.csv", "old");
        set_mode(&folder, "old.csv", bits);
        folder.ok(&format!("{WRITE} old.csv"));
        assert_eq!(mode(&folder, "old.csv"), bits);
        set_mode(&folder, "old.csv", 0o600);
        assert!(folder.read("old.csv").contains("light-2,2,2,"));
    }
    // A new output has the mode of any new file.
    folder.ok(&format!("{WRITE} new.csv"));
    folder.write("plain.csv", "");
    assert_eq!(mode(&folder, "new.csv"), mode(&folder, "plain.csv"));
}

#[test]
fn a_read_only_output_is_refused() {
    let folder = with_image();
    folder.write("old.csv", "old");
    set_mode(&folder, "old.csv", 0o444);
    symlink("old.csv", folder.path("link.csv")).unwrap();

    for (command, name) in [
        (format!("{WRITE} old.csv"), "old.csv"),
        (format!("{WRITE} link.csv"), "link.csv"),
        ("basis --scene scene.toml --out old.csv".to_owned(), "old.csv"),
        (format!("{READ} --out new.csv --light-out old.csv"), "old.csv"),
    ] {
        assert_fails(&folder, &command, &[name, "read-only", "make it writable"]);
        assert_eq!(folder.read("old.csv"), "old");
        assert_eq!(mode(&folder, "old.csv"), 0o444);
    }
    // A table stays with its manifest.
    folder.write("b.bin", "old");
    set_mode(&folder, "b.manifest.csv", 0o444);
    assert_fails(&folder, BASIS, &["b.manifest.csv", "read-only"]);
    assert_eq!(folder.read("b.bin"), "old");
}

#[test]
fn an_output_may_be_a_pipe() {
    let folder = Folder::new();
    folder.ok(&format!("{WRITE} file.csv"));
    let piped = folder.ok(&format!("{WRITE} /dev/stdout"));
    let rows = |text: &str| rows(text, "name,l,m,r,g,b");
    assert_eq!(rows(&piped), rows(&folder.read("file.csv")));
}

#[test]
fn links_are_followed() {
    let folder = Folder::new();
    fs::create_dir(folder.path("sub")).unwrap();
    symlink("sub/second.csv", folder.path("first.csv")).unwrap();
    symlink("../end.csv", folder.path("sub/second.csv")).unwrap();
    folder.ok(&format!("{WRITE} first.csv"));
    for link in ["first.csv", "sub/second.csv"] {
        assert!(fs::symlink_metadata(folder.path(link)).unwrap().is_symlink());
    }
    assert!(fs::symlink_metadata(folder.path("end.csv")).unwrap().is_file());
    assert_eq!(folder.read("end.csv"), folder.read("first.csv"));
    symlink("none/new.csv", folder.path("nowhere.csv")).unwrap();
    assert_fails(&folder, &format!("{WRITE} nowhere.csv"), &["nowhere.csv", "folder exists"]);
    symlink("circle.csv", folder.path("circle.csv")).unwrap();
    assert_fails(&folder, &format!("{WRITE} circle.csv"), &["circle.csv"]);
}

/// Signals reach the program while it waits for the reader of a pipe, with another output in a
/// temporary file.
#[test]
fn signals_leave_no_files_behind() {
    for (name, number) in [("INT", 2), ("TERM", 15)] {
        let folder = with_image();
        folder.write("old.csv", "old");
        assert!(Command::new("mkfifo").arg(folder.path("pipe")).status().unwrap().success());
        let before = folder.names();
        let mut child = Command::new(PROGRAM)
            .args(READ.split(' '))
            .args(["--out", "old.csv", "--light-out", "pipe"])
            .current_dir(folder.path("."))
            .stderr(Stdio::null())
            .spawn()
            .expect("the program runs");
        let start = Instant::now();
        while folder.names() == before {
            assert!(start.elapsed() < Duration::from_secs(60), "no temporary file");
            assert!(child.try_wait().unwrap().is_none(), "it ended");
            std::thread::sleep(Duration::from_millis(5));
        }
        let signal = format!("-{name}");
        let sent = Command::new("kill").args([&signal, &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        assert_eq!(child.wait().unwrap().signal(), Some(number), "SIG{name}");
        assert_eq!(folder.names(), before, "SIG{name}");
        assert_eq!(folder.read("old.csv"), "old");
    }
}

/// Outputs that look like collisions but are different files.
#[test]
fn different_files() {
    let folder = with_image();
    fs::create_dir(folder.path("maps")).expect("a folder");
    folder.write("maps/other.pfm", map(1.0));
    // Twice: an earlier output is not an input.
    for _ in 0..2 {
        let places = "--out sphere --light-out new.csv --modes-out maps/new.csv";
        folder.ok(&format!("{READ} {places}"));
        folder.ok("light maps --degree 2 --out maps/lights.csv");
    }
    folder.ok(&format!("{READ} --out /dev/null --light-out /dev/null"));
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

const NAME: &str = "na\u{1b}[31mme\u{7}\u{202e}";

fn assert_harmless(output: &[u8]) {
    let text = std::str::from_utf8(output).expect("text");
    let is_harmless =
        |letter: char| letter == '\n' || !(letter.is_control() || letter == '\u{202e}');
    assert!(text.chars().all(is_harmless), "{text:?}");
    assert!(text.contains(r"\u{1b}[31m"), "{text:?}");
}

fn failed(output: Output) -> Vec<u8> {
    assert_eq!(output.status.code(), Some(1));
    output.stderr
}

#[test]
fn control_characters_of_names_do_not_reach_the_terminal() {
    let folder = Folder::new();
    let named = |text: String, name: &str| text.replace(name, NAME);
    folder.write("lights.csv", named(lights(DEGREE, 3), "light-1"));
    folder.write("materials.csv", named(materials(ORDER, 3), "material-1"));
    let spelled = NAME.replace('\u{1b}', "\\u001b").replace('\u{7}', "\\u0007");
    folder.replace("scene.toml", "names = []", &format!("names = [\"{spelled}\"]"));
    folder.ok(BASIS);
    // A report on standard output, names that an error lists, and the name of a file.
    assert_harmless(folder.ok("info --table b.bin").as_bytes());
    assert_harmless(&failed(folder.run(&format!("render --table b.bin {PAIR} --out new.png"))));
    assert_harmless(&failed(folder.run(&format!("info --table {NAME}"))));
    // Data keep the names.
    assert!(folder.ok(&format!("project --table b.bin {PAIR}")).contains(NAME));
}

/// The comment line of a source file is also safe to print, and has no folders.
#[test]
fn control_characters_of_arguments_are_escaped_in_files() {
    let folder = Folder::new();
    let out = folder.path(&format!("{NAME}.rs"));
    folder.ok(&format!("pack-object sphere --size 4 --out {}", out.display()));
    let text = fs::read_to_string(out).unwrap();
    let line = text.lines().next().unwrap();
    assert_harmless(line.as_bytes());
    assert!(line.starts_with("// eigenshade pack-object sphere --size 4 --out na"), "{line}");
}
