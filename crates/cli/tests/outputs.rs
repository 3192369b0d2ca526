//! Where outputs go: modes, links and signals.
#![cfg(unix)]

use crate::support::reading::with_image;
use crate::support::{Folder, assert_fails};
use std::fs::{self, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const WRITE: &str = "light lights.csv --degree 2 --out";

fn mode(folder: &Folder, name: &str) -> u32 {
    fs::metadata(folder.path(name)).unwrap().mode() & 0o7777
}

#[test]
fn a_replaced_output_keeps_its_mode() {
    let folder = Folder::new();
    for bits in [0o600, 0o640, 0o666, 0o755, 0o200] {
        folder.write("old.csv", "old");
        fs::set_permissions(folder.path("old.csv"), Permissions::from_mode(bits)).unwrap();
        folder.ok(&format!("{WRITE} old.csv"));
        assert_eq!(mode(&folder, "old.csv"), bits);
        fs::set_permissions(folder.path("old.csv"), Permissions::from_mode(0o600)).unwrap();
        assert!(folder.read("old.csv").contains("light-2,2,2,"));
    }
}

#[test]
fn a_read_only_output_is_refused() {
    let folder = with_image();
    folder.write("old.csv", "old");
    fs::set_permissions(folder.path("old.csv"), Permissions::from_mode(0o444)).unwrap();
    symlink("old.csv", folder.path("link.csv")).unwrap();
    let read = "read image.csv --normals normals.csv --table b.bin";
    for (command, name) in [
        (format!("{WRITE} old.csv"), "old.csv"),
        (format!("{WRITE} link.csv"), "link.csv"),
        ("basis --scene scene.toml --out old.csv".to_owned(), "old.csv"),
        (format!("{read} --out new.csv --light-out old.csv"), "old.csv"),
    ] {
        assert_fails(&folder, &command, &[name, "read-only", "make it writable"]);
        assert_eq!(folder.read("old.csv"), "old");
        assert_eq!(mode(&folder, "old.csv"), 0o444);
    }
}

/// Of two outputs none is replaced if one may not be.
#[test]
fn a_table_stays_with_its_manifest() {
    let folder = with_image();
    folder.ok("basis --scene scene.toml --out pair.bin");
    folder.write("pair.bin", "old");
    let manifest = folder.path("pair.manifest.csv");
    fs::set_permissions(&manifest, Permissions::from_mode(0o444)).unwrap();
    assert_fails(
        &folder,
        "basis --scene scene.toml --out pair.bin",
        &["pair.manifest.csv", "read-only"],
    );
    assert_eq!(folder.read("pair.bin"), "old");
}

#[test]
fn a_pipe_takes_an_output() {
    let folder = Folder::new();
    folder.ok(&format!("{WRITE} file.csv"));
    let piped = folder.run(&format!("{WRITE} /dev/stdout"));
    assert!(piped.status.success(), "{}", String::from_utf8_lossy(&piped.stderr));
    let rows = |text: &str| -> Vec<String> {
        text.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect()
    };
    assert_eq!(rows(&String::from_utf8_lossy(&piped.stdout)), rows(&folder.read("file.csv")));
}

#[test]
fn a_link_to_no_file_is_written_where_it_leads() {
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

/// Nonzero numbers that become zeros would be black without a word.
#[test]
fn what_a_format_loses_is_refused() {
    let folder = Folder::with_table();
    let shade = "shade b.bin --lights dark.csv --materials materials.csv --normals normals.csv";
    for value in ["1e-46", "-1e-300"] {
        folder.write("dark.csv", format!("name,l,m,value\ndark,0,0,{value}\n"));
        for format in ["f32", "q31", "q15"] {
            let command = format!("{shade} --format {format}");
            assert_fails(&folder, &command, &["`dark`", "below the range", "scale both"]);
        }
        folder.ok(&format!("{shade} --format f64"));
    }
    folder.write("dark.csv", "name,l,m,value\ndark,0,0,0\n");
    folder.ok(shade);
}

/// What the disk has no room for is a fault of the output, not of the file that it is put into
/// on the way.
#[test]
fn a_full_disk_names_the_output() {
    let folder = Folder::with_table();
    let before = folder.names();
    let arguments = "shade b.bin --lights lights.csv --materials materials.csv \
                     --normals normals.csv --out new.csv";
    // A limit of the shell's stands in for the disk's end.
    let script = format!("trap '' XFSZ; ulimit -f 1; exec {} {arguments}", program());
    let output = Command::new("sh")
        .args(["-c", &script])
        .current_dir(folder.path("."))
        .output()
        .expect("a shell");
    let line = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{line}");
    assert!(line.starts_with("error: new.csv: File too large"), "{line}");
    assert!(!line.contains(".eigenshade-") && line.lines().count() == 1, "{line}");
    assert_eq!(folder.names(), before);
}

fn program() -> &'static str {
    env!("CARGO_BIN_EXE_eigenshade")
}

/// A program that waits for the reader of a pipe, with another output written and not yet in
/// its place.
#[test]
fn signals_leave_no_files_behind() {
    for (name, number) in [("INT", 2), ("TERM", 15)] {
        let folder = with_image();
        folder.write("old.csv", "old");
        assert!(Command::new("mkfifo").arg(folder.path("pipe")).status().unwrap().success());
        let before = folder.names();
        let arguments =
            "read image.csv --normals normals.csv --table b.bin --out old.csv --light-out pipe";
        let mut child = Command::new(program())
            .args(arguments.split(' '))
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
