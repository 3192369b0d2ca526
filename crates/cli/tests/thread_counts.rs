//! A table does not depend on the run or on the number of threads.

use crate::support::{Folder, repository};
use std::fs;
use std::process::Command;

/// What gives the number of threads.
const VARIABLE: &str = "RAYON_NUM_THREADS";

/// Every component of the shipped scene, order, sign and last bit: two runs with each number of
/// threads. Each azimuth and each profile is one thread's; built with faer's `rayon` a sum would be
/// several threads', and its last bits would follow their number.
#[test]
fn tables_are_the_same_to_the_byte() {
    let folder = Folder::new();
    let inputs = repository().join("tables");
    let text = fs::read_to_string(inputs.join("sphere.toml")).expect("the shipped scene");
    let inputs = inputs.join("inputs").canonicalize().expect("the shipped inputs");
    let line = |line: &str| match line.split_once(" = ") {
        Some(("components", _)) => "components = 10000\n".to_owned(),
        Some(("rank_cutoff", _)) => "rank_cutoff = 1e-13\n".to_owned(),
        _ => format!("{line}\n"),
    };
    let text: String = text.lines().map(line).collect();
    let text = text.replace("\"inputs/", &format!("\"{}/", inputs.display()));
    folder.write("scene.toml", text);
    let table = |threads: &str, name: &str| {
        let output = Command::new(env!("CARGO_BIN_EXE_eigenshade"))
            .current_dir(folder.path("."))
            .env(VARIABLE, threads)
            .args(["basis", "--scene", "scene.toml", "--out", name])
            .output()
            .expect("the program runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        fs::read(folder.path(name)).expect("a table")
    };
    let first = table("1", "first.bin");
    assert!(first.len() > 1 << 18, "{} bytes", first.len());
    for (run, threads) in ["1", "2", "2", "3", "3"].into_iter().enumerate() {
        assert!(table(threads, &format!("{run}.bin")) == first, "{threads} threads, run {run}");
    }
}
