//! Where outputs go: permissions, links, pipes, signals, collisions; and names that a terminal
//! would interpret.
#![cfg(unix)]

use crate::PROGRAM;
use crate::support::files::with_image;
use crate::support::{DEGREE, Folder, ORDER, assert_fails, lights, materials};
use eigenshade_testing::fixtures;
use std::collections::BTreeMap;
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
    // A new output has the mode of any new file.
    folder.ok(&format!("{WRITE} new.csv"));
    folder.write("plain.csv", "");
    assert_eq!(mode(&folder, "new.csv"), mode(&folder, "plain.csv"));
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

/// Neither of two outputs is replaced if one is read-only.
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
fn an_output_may_be_a_pipe() {
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

/// Numbers that a format would round to zero are refused: the image would be black.
#[test]
fn numbers_below_the_range_of_a_format_are_refused() {
    let folder = Folder::with_table();
    let shade =
        "shade --table b.bin --light dark.csv --material materials.csv --normals normals.csv";
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

/// On a full disk the error names the output, not the temporary file.
#[test]
fn a_full_disk_names_the_output() {
    let folder = Folder::with_table();
    let before = folder.names();
    let arguments = "shade --table b.bin --light lights.csv --material materials.csv \
                     --normals normals.csv --out new.csv";
    // A limit of the shell takes the place of a full disk.
    let script = format!("trap '' XFSZ; ulimit -f 1; exec {PROGRAM} {arguments}");
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

/// Signals reach the program while it waits for the reader of a pipe, with another output in a
/// temporary file.
#[test]
fn signals_leave_no_files_behind() {
    for (name, number) in [("INT", 2), ("TERM", 15)] {
        let folder = with_image();
        folder.write("old.csv", "old");
        assert!(Command::new("mkfifo").arg(folder.path("pipe")).status().unwrap().success());
        let before = folder.names();
        let arguments =
            "read image.csv --normals normals.csv --table b.bin --out old.csv --light-out pipe";
        let mut child = Command::new(PROGRAM)
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

/// The bytes of all files.
fn contents(folder: &Folder) -> BTreeMap<String, Vec<u8>> {
    let names = folder.names().into_iter().filter(|name| folder.path(name).is_file());
    names.map(|name| (name.clone(), fs::read(folder.path(&name)).expect("a file"))).collect()
}

/// A folder with inputs for every command.
fn with_everything() -> Folder {
    let folder = with_image();
    let measured = "theta_i,phi_i,theta_r,phi_r,value\n0.1,0,0.2,0,1\n0.3,1,0.2,0,1\n";
    folder.write("m.csv", measured);
    folder.write(
        "matte.toml",
        "[[material]]\nname = \"matte\"\nmodel = \"lambertian\"\nalbedo = 1\n",
    );
    let map = fixtures::pfm(4, &[[1.0; 3]; 4 * 2]);
    folder.write("map.pfm", &map);
    fs::create_dir(folder.path("maps")).expect("a folder");
    folder.write("maps/other.pfm", &map);
    folder.write("points.csv", "o,q,rho\n2,0,0.5\n");
    folder.write("mask.csv", format!("weight\n{}", "1\n".repeat(400)));
    folder.write("s.manifest.csv", folder.read("scene.toml"));
    folder
}

const READ_MASKED: &str = "read image.csv --normals normals.csv --mask mask.csv --table b.bin";

#[test]
fn two_outputs_in_one_file() {
    let folder = with_everything();
    fs::create_dir(folder.path("sub")).expect("a folder");
    for (to, link) in [("new.csv", "dangling.csv"), ("light.csv", "linked.csv"), (".", "here")] {
        symlink(to, folder.path(link)).expect("a link");
    }
    let before = contents(&folder);
    for (arguments, place) in [
        ("material m.csv --order 0 --out new.csv --report new.csv".to_owned(), "new.csv"),
        ("material m.csv --order 0 --out new.csv --report sub/../new.csv".to_owned(), "new.csv"),
        (format!("{READ_MASKED} --out new.csv --light-out ./new.csv"), "./new.csv"),
        (format!("{READ_MASKED} --out new.csv --modes-out new.csv"), "new.csv"),
        (
            format!("{READ_MASKED} --light-out sub/new.csv --modes-out ./sub/new.csv"),
            "./sub/new.csv",
        ),
        (format!("{READ_MASKED} --out new.csv --light-out here/new.csv"), "here/new.csv"),
        (format!("{READ_MASKED} --out new.csv --light-out dangling.csv"), "dangling.csv"),
    ] {
        assert_fails(&folder, &arguments, &[place, "two outputs go there", "its own file"]);
        assert!(contents(&folder) == before, "{arguments}");
    }
    // A link to an input is the input.
    {
        let linked =
            format!("{READ_MASKED} --light light.csv --material material.csv --out linked.csv");
        assert_fails(&folder, &linked, &["linked.csv", "`light.csv`", "another name"]);
        assert!(contents(&folder) == before);
    }
}

#[test]
fn an_input_as_output() {
    let folder = with_everything();
    let before = contents(&folder);
    let pair = "--light light.csv --material material.csv";
    let render = "render --table b.bin --light light.csv:light-0 --material material.csv --size 4";
    let read = format!("{READ_MASKED} {pair}");
    let inputs = |command: &str, inputs: &[&str]| -> Vec<(String, String)> {
        let row = |input: &&str| (format!("{command} --out ./{input}"), (*input).to_owned());
        inputs.iter().map(row).collect()
    };
    let mut rows = [
        inputs(&format!("project --table b.bin {pair}"), &["b.bin", "light.csv", "material.csv"]),
        inputs(
            &format!("shade --table b.bin {pair} --normals normals.csv"),
            &["b.bin", "normals.csv"],
        ),
        inputs("pack --table b.bin", &["b.bin"]),
        inputs("eigenvalues --table b.bin", &["b.bin"]),
        inputs("evaluate zernike-radial points.csv", &["points.csv"]),
        inputs(render, &["b.bin", "light.csv", "material.csv"]),
        inputs("light light.csv --degree 4", &["light.csv"]),
        inputs("light map.pfm maps --degree 4", &["map.pfm", "maps/other.pfm"]),
        inputs("material m.csv matte.toml --order 0", &["m.csv", "matte.toml"]),
        inputs("basis --scene scene.toml", &["scene.toml", "lights.csv", "materials.csv"]),
        inputs(&read, &["image.csv", "normals.csv", "mask.csv", "b.bin", "light.csv"]),
        inputs(READ_MASKED, &["lights.csv", "materials.csv"]),
    ]
    .concat();
    for (arguments, input) in [
        ("material m.csv --order 0 --out new.csv --report ./m.csv", "m.csv"),
        ("basis --scene s.manifest.csv --out s.bin", "s.manifest.csv"),
        (&format!("{READ_MASKED} --out new.csv --light-out ./image.csv"), "image.csv"),
        (&format!("{READ_MASKED} --out new.csv --modes-out ./b.bin"), "b.bin"),
    ] {
        rows.push((arguments.to_owned(), input.to_owned()));
    }
    for (arguments, input) in rows {
        assert_fails(&folder, &arguments, &[&input, "would replace the input", "another name"]);
        assert!(contents(&folder) == before, "{arguments}");
    }
    assert_eq!(fs::read(folder.path("maps/other.pfm")).unwrap(), before["map.pfm"]);
}

/// Outputs that look like collisions but are different files.
#[test]
fn different_files() {
    let folder = with_everything();
    folder.ok(&format!("{READ_MASKED} --out sphere --light-out new.csv --modes-out maps/new.csv"));
    // Again: an earlier output is not an input.
    folder.ok(&format!("{READ_MASKED} --out sphere --light-out new.csv --modes-out maps/new.csv"));
    folder.ok("light maps --degree 2 --out maps/lights.csv");
    folder.ok("light maps --degree 2 --out maps/lights.csv");
    folder.ok(&format!("{READ_MASKED} --out /dev/null --light-out /dev/null"));
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
    let scene = folder.read("scene.toml");
    let spelled = NAME.replace('\u{1b}', "\\u001b").replace('\u{7}', "\\u0007");
    folder.write("scene.toml", scene.replace("names = []", &format!("names = [\"{spelled}\"]")));
    folder.ok("basis --scene scene.toml --out b.bin");
    // A report on standard output, names that an error lists, and the name of a file.
    assert_harmless(folder.ok("info --table b.bin").as_bytes());
    let render = "render --table b.bin --light lights.csv --material materials.csv --out new.png";
    assert_harmless(&failed(folder.run(render)));
    assert_harmless(&failed(folder.run(&format!("info --table {NAME}"))));
    // Data keep the names.
    let project = folder.ok("project --table b.bin --light lights.csv --material materials.csv");
    assert!(project.contains(NAME));
}

/// The comment line of a source file is also safe to print, and has no folders.
#[test]
fn control_characters_of_arguments_are_escaped_in_files() {
    let folder = Folder::new();
    let out = folder.path(&format!("{NAME}.rs"));
    folder.ok(&format!("pack-normals sphere --size 4 --out {}", out.display()));
    let text = fs::read_to_string(out).unwrap();
    let line = text.lines().next().unwrap();
    assert_harmless(line.as_bytes());
    assert!(line.starts_with("// eigenshade pack-normals sphere --size 4 --out na"), "{line}");
}
