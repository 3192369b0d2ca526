//! What all commands have in common: names and files, standard input, JSON, messages, help.

use crate::PROGRAM;
use crate::support::{
    Folder, PAIR, SHADE, assert_contains, assert_fails, error_line, shipped_path, stderr,
};
use eigenshade_model::shipped;
use serde_json::Value;
use std::fs;
use std::io::Write;
use std::process::{Command, Output, Stdio};

/// Runs the program with this standard input.
fn fed(folder: &Folder, arguments: &str, input: &[u8]) -> Output {
    let mut child = Command::new(PROGRAM)
        .current_dir(folder.path("."))
        .args(arguments.split_whitespace())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that fails may have closed the pipe.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

/// The shipped tables by name are those of the repository, and one is the default.
#[test]
fn tables_have_names() {
    let folder = Folder::with_table();
    for name in ["color", "sphere", "curet"] {
        let of = |table: &str| folder.ok(&format!("eigenvalues -t {table}"));
        assert_eq!(of(name), of(&shipped_path(&format!("{name}.bin"))));
    }
    assert_eq!(folder.ok("info"), folder.ok("info --table color"));
    let project = "project --light park --material chrome --components 2";
    assert_eq!(folder.ok(project), folder.ok(&format!("{project} --table color")));
    // A file has precedence.
    fs::copy(folder.path("b.bin"), folder.path("sphere")).unwrap();
    assert_eq!(folder.ok("info -t sphere"), folder.ok("info -t b.bin"));
    // Reading with a shipped table uses the shipped databases, wherever the program runs.
    folder.ok("render -l park -m 07-velvet -s 48 -t curet -o v.png");
    let by_name = folder.ok("read v.png -n sphere -t curet");
    let curet = shipped_path("curet.bin");
    assert_eq!(by_name, folder.ok(&format!("read v.png -n sphere -t {curet}")));
}

/// Each database of `read` has its own default.
#[test]
fn one_database_of_two() {
    let folder = Folder::new();
    folder.ok("render -l workshop -m pearl-paint -s 48 -o ball.png");
    let light = format!("-l {}", shipped_path("inputs/lights.csv"));
    for (options, count) in [("-m pearl-paint", "of 1 "), (&light, "of 72 "), ("", "of 72 ")] {
        let summary = folder.messages(&format!("read ball.png -n sphere -o b.csv {options}"));
        assert_contains(&summary, &["nearest materials", count]);
    }
}

/// Folders and outputs may have the names of shipped tables, lights and materials.
#[test]
fn folders_do_not_hide_names() {
    let folder = Folder::with_table();
    let export = "export --lang c -l park -m chrome -o";
    folder.ok(&format!("{export} park"));
    fs::remove_file(folder.path("park")).unwrap();
    for name in ["color", "park", "chrome"] {
        fs::create_dir(folder.path(name)).unwrap();
    }
    folder.ok(&format!("{export} pair.h"));
    assert_fails(&folder, "info -t none", &["neither a file", "`color`, `sphere`, `curet`"]);
}

/// `--light` and `--material` mean the same in each command.
#[test]
fn one_entry_of_a_file() {
    let folder = Folder::with_table();
    let rows = |text: String, start: &str| -> Vec<String> {
        text.lines().filter(|row| row.starts_with(start)).map(str::to_owned).collect()
    };
    let one = "-l lights.csv:light-1 -m materials.csv:material-2";
    for command in ["project -t b.bin", "shade -t b.bin -n normals.csv"] {
        let found = rows(folder.ok(&format!("{command} {one}")), "light-");
        let all = folder.ok(&format!("{command} {PAIR}"));
        assert!(!found.is_empty());
        assert_eq!(found, rows(all, "light-1,material-2,"));
    }
    folder.write("colon.csv", folder.read("lights.csv").replace("light-1", "light:1"));
    let of = |light: &str| folder.ok(&format!("project -t b.bin -l {light} -m materials.csv"));
    assert_eq!(of("colon.csv:light:1").replace(':', "-"), of("lights.csv:light-1"));
    let misnamed = "project -t b.bin -l lights.csv:lihgt-1 -m materials.csv";
    assert_fails(&folder, misnamed, &["lights.csv: it has no light `lihgt-1`", "`light-1`"]);
}

/// A table, a scene, and each CSV.
#[test]
fn standard_input_in_place_of_a_file() {
    let folder = Folder::with_table();
    // The file of this name is fed.
    let outputs_agree = |fed_by: &str, by_name: &str, input: &str| {
        let output = fed(&folder, fed_by, &folder.bytes(input));
        assert_eq!(output.status.code(), Some(0), "{fed_by}: {}", stderr(&output));
        assert_eq!(String::from_utf8_lossy(&output.stdout), folder.ok(by_name), "{fed_by}");
    };
    for name in ["b.bin", "lights.csv", "materials.csv", "normals.csv"] {
        outputs_agree(&SHADE.replace(name, "-"), SHADE, name);
    }
    let project = "project -t b.bin -m materials.csv";
    outputs_agree(
        &format!("{project} --light=-:light-1"),
        &format!("{project} --light lights.csv:light-1"),
        "lights.csv",
    );
    outputs_agree("light - --degree 2", "light lights.csv --degree 2", "lights.csv");
    let basis = fed(&folder, "basis --scene - --check b.bin", &folder.bytes("scene.toml"));
    assert_eq!(basis.status.code(), Some(0));
    let render = "render -t b.bin -l lights.csv:light-1 -s 8 -o a.png --material";
    let material = folder.bytes("materials.csv");
    let drawn = fed(&folder, &format!("{render}=-:material-1"), &material);
    assert_eq!(drawn.status.code(), Some(0));
    let by_input = folder.bytes("a.png");
    folder.ok(&format!("{render} materials.csv:material-1"));
    assert_eq!(by_input, folder.bytes("a.png"));
    let shade = SHADE.replace("lights.csv", "-");
    let lights = folder.read("lights.csv");
    for (arguments, input, fragment) in [
        (&shade, "name,l,m\n", "error: standard input:1: its header"),
        (&shade.replace("normals.csv", "-"), &lights, "read twice"),
    ] {
        let output = fed(&folder, arguments, input.as_bytes());
        let line = stderr(&output);
        assert!(output.status.code() == Some(1) && line.contains(fragment), "{line}");
    }
}

#[test]
fn answers_as_json() {
    let folder = Folder::with_table();
    let parsed = |arguments: &str| -> Value {
        serde_json::from_str(&folder.ok(&format!("{arguments} --json"))).unwrap()
    };
    let table = folder.table("b.bin");
    let info = parsed("info -t b.bin");
    assert_eq!(info["degree"], 4);
    assert_eq!(info["components"], table.count());
    assert_eq!(info["bytes"]["file"], folder.bytes("b.bin").len());
    // The same names as in the text.
    for name in info.as_object().unwrap().keys().filter(|name| *name != "bytes") {
        let text = folder.ok("info -t b.bin");
        let has = |line: &str| line.starts_with(&format!("{} ", name.replace('_', " ")));
        assert!(text.lines().any(has), "{name}");
    }
    folder.ok("pack -t b.bin -f q15 -o w.esw");
    assert_eq!(parsed("info -t w.esw")["format"], "q15");
    let eigenvalues = parsed("eigenvalues -t b.bin");
    assert_eq!(eigenvalues.as_array().unwrap().len(), table.spectrum.len());
    assert_eq!((&eigenvalues[0]["m"], &eigenvalues[0]["eigenvalue"]), (&0.into(), &Value::Null));
    assert_eq!(eigenvalues[1]["eigenvalue"].as_f64(), table.spectrum[1].1);
    let list = parsed("list");
    let names = shipped::lights().unwrap().entries.len()
        + shipped::named_materials(7).unwrap().entries.len();
    assert_eq!(list.as_array().unwrap().len(), names);
    let demo = parsed("demo -o d -s 16");
    assert_eq!(demo, serde_json::json!({ "files": ["d/demo.png"] }));
}

/// Each command has a page, and each shell completions that know the commands.
#[test]
fn pages_and_completions() {
    let folder = Folder::new();
    folder.ok("man share/man1");
    let page = folder.read("share/man1/eigenshade-render.1");
    assert_contains(&page, &[".TH", "\\-\\-exposure"]);
    for name in ["eigenshade.1", "eigenshade-demo.1", "eigenshade-material-ggx.1"] {
        assert!(folder.path("share/man1").join(name).is_file(), "{name}");
    }
    let script = |shell: &str| folder.ok(&format!("completions {shell}"));
    for shell in ["elvish", "powershell"] {
        assert_contains(&script(shell), &["render", "exposure"]);
    }
    // The shipped names, and files beside them: bash has these where no name fits.
    for (shell, files) in [("bash", "-o default"), ("zsh", "; _files}"), ("fish", "-F -a \"")] {
        let script = script(shell);
        let words = ["render", "exposure", "esplanade", "gold-metallic-paint", files];
        assert_contains(&script, &words);
        // In zsh, a colon ends the name of a value.
        assert!(!script.contains("FILE[:NAME]"), "{shell}");
    }
    folder.ok("completions bash -o e.bash");
    let typed = "source e.bash; COMP_WORDS=(eigenshade render -l par); COMP_CWORD=3; \
                 _eigenshade eigenshade par -l; echo \"${COMPREPLY[@]}\"";
    let offered = Command::new("bash").args(["-c", typed]).current_dir(folder.path(".")).output();
    assert_eq!(String::from_utf8_lossy(&offered.unwrap().stdout), "park\n");
    assert!(folder.shell("bash -n e.bash").status.success());
}

/// The same option has the same letter and the same form in every command.
#[test]
fn options_are_spelled_alike() {
    let folder = Folder::new();
    let help = folder.ok("--help");
    let commands = help.split_once("Commands:").unwrap().1.split_once("Options:").unwrap().0;
    let commands = commands.lines().filter_map(|line| line.split_whitespace().next());
    let commands: Vec<&str> = commands.filter(|name| *name != "help").collect();
    assert!(commands.len() >= 15, "{commands:?}");
    let mut found: Vec<(String, String, &str)> = Vec::new();
    for command in commands {
        for line in folder.ok(&format!("{command} -h")).lines() {
            let line = line.trim_start();
            let Some(at) = line.find("--").filter(|_| line.starts_with('-')) else { continue };
            let long = line[at..].split([' ', '[']).next().unwrap().to_owned();
            let short = line[..at].trim_end_matches([' ', ',']).to_owned();
            found.push((long, short, command));
        }
    }
    for one in &found {
        for other in &found {
            let is_same_letter = one.1 == other.1 && !one.1.is_empty();
            assert!(one.0 == other.0 || !is_same_letter, "{one:?} and {other:?}");
            assert!(one.0 != other.0 || one.1 == other.1, "{one:?} and {other:?}");
        }
    }
    assert!(found.iter().filter(|(long, ..)| long == "--table").count() >= 8);
}

/// An output device without room is an error, whatever is written.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device() {
    let folder = Folder::with_table();
    for arguments in [
        "light lights.csv --degree 2 -o",
        "eigenvalues -t b.bin -o",
        "eigenvalues --json -t b.bin -o",
        "pack -t b.bin -o",
        "completions bash -o",
    ] {
        let fragments = ["/dev/full", "No space left", "free some space"];
        assert_fails(&folder, &format!("{arguments} /dev/full"), &fragments);
    }
    // By its name, a picture.
    std::os::unix::fs::symlink("/dev/full", folder.path("full.png")).unwrap();
    let render = "render -l park -m chrome -s 64 -o full.png";
    assert_fails(&folder, render, &["full.png", "No space left"]);
    for arguments in ["list", "info -t b.bin", "eigenvalues --json -t b.bin"] {
        let output = folder.shell(&format!("exec {PROGRAM} {arguments} > /dev/full"));
        let line = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{arguments}: {line}");
        assert!(line.starts_with("error: standard output: No space left"), "{line}");
    }
}

/// An output that does not fit is not there in part, and the error names it, not the temporary
/// file.
#[cfg(unix)]
#[test]
fn outputs_on_a_full_disk() {
    let folder = Folder::with_table();
    let before = folder.names();
    for (arguments, error) in [
        ("render -l park -m chrome -s 128 -o a.png", ".png: File too large"),
        ("demo -s 32 -o .", ".png: File too large"),
        (&format!("{SHADE} --out new.csv"), "error: new.csv: File too large"),
    ] {
        // A limit of the shell takes the place of a full disk.
        let script = format!("trap '' XFSZ; ulimit -f 1; exec {PROGRAM} {arguments}");
        let line = error_line(&folder.shell(&script));
        assert!(line.contains(error) && !line.contains(".eigenshade-"), "{line}");
        assert_eq!(folder.names(), before, "{arguments}");
    }
}
