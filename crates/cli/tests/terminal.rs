//! Names in files may hold anything; a terminal is to obey none of it.

use crate::support::{DEGREE, Folder, ORDER, lights, materials};
use std::process::Output;

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
    // A report on standard output, names that a fault lists, a file's name.
    assert_harmless(folder.ok("info b.bin").as_bytes());
    let render = "render b.bin --light lights.csv --material materials.csv --out new.png";
    assert_harmless(&failed(folder.run(render)));
    assert_harmless(&failed(folder.run(&format!("info {NAME}"))));
    // Data keep them.
    let project = folder.ok("project b.bin --lights lights.csv --materials materials.csv");
    assert!(project.contains(NAME));
}

/// The first line of a file is read in a terminal, too.
#[test]
fn control_characters_of_arguments_are_spelled_out_in_files() {
    let folder = Folder::new();
    std::fs::copy(folder.path("lights.csv"), folder.path(&format!("{NAME}.csv"))).unwrap();
    folder.ok(&format!("light {NAME}.csv --degree 2 --out new.csv"));
    let text = folder.read("new.csv");
    assert_harmless(text.lines().next().unwrap().as_bytes());
}
