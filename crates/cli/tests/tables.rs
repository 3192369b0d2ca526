//! The tables of commands in `tests/cmd`: what each command prints, and its status. Every table runs
//! in a folder of its own that holds the small scene, `folder` below. With TRYCMD=overwrite, the
//! answers are written anew.

use crate::PROGRAM;
use crate::support::files::{claims, gray_png, map, normal_map, obj, png, with_image};
use crate::support::{Folder, ORDER, materials, repository_text};
use png::{BitDepth, ColorType};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use tempfile::TempDir;

/// The table and an image of the small scene, and files that are costly to write in a table.
fn folder() -> Folder {
    let folder = with_image();
    folder.write("high.csv", materials(ORDER + 2, 1));
    folder.write("map.pfm", map(1.0));
    folder.write("merl.csv", repository_text("tables/inputs/merl.csv"));
    folder.write("e.obj", obj());
    folder.write("n.png", normal_map(BitDepth::Eight));
    let gray: Vec<u8> = (0..64u32 * 64).map(|k| (k % 199) as u8).collect();
    folder.write("gray.png", gray_png(64, 64, &gray));
    folder.write("image.png", gray_png(20, 20, &[100; 400]));
    folder.write("white.png", gray_png(20, 20, &[255; 400]));
    folder.write("small.png", gray_png(10, 10, &[200; 100]));
    folder.write("flat.png", gray_png(2, 2, &[128; 4]));
    // The second normal points away.
    let behind = [128, 128, 255, 128, 128, 0];
    folder.write("behind.png", png([2, 1], BitDepth::Eight, ColorType::Rgb, &behind));
    folder.write("tiny.png", gray_png(1, 1, &[0]));
    // 2^31 - 1 pixels across and down, in 67 bytes.
    folder.write("absurd.png", claims(gray_png(1, 1, &[0]), u32::MAX >> 1, u32::MAX >> 1));
    folder
}

#[test]
fn tables_of_commands() {
    let (folder, place) = (folder(), TempDir::new().expect("a folder"));
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cmd");
    for entry in fs::read_dir(&tests).expect("tables") {
        let path = entry.expect("a table").path();
        let (Some(name), true) = (path.file_name(), path.is_file()) else { continue };
        let copy = place.path().join(name);
        symlink(&path, &copy).expect("a link");
        symlink(folder.path("."), copy.with_extension("in")).expect("a link");
        fs::create_dir(copy.with_extension("out")).expect("a folder");
    }
    let cases = trycmd::TestCases::new();
    cases
        .register_bin("eigenshade", Path::new(PROGRAM))
        .env("FIXTURE", folder.path(".").display().to_string());
    for script in ["append", "fresh", "unchanged", "write"] {
        cases.register_bin(script, tests.join("bin").join(script).as_path());
    }
    for tool in ["cp", "mkdir", "mv", "rm", "sed", "sh"] {
        let found = ["/bin", "/usr/bin"].map(|place| Path::new(place).join(tool));
        let found = found.into_iter().find(|path| path.exists());
        cases.register_bin(tool, found.expect("a tool of every system"));
    }
    cases.case(place.path().join("*.trycmd"));
}
