//! Counts instructions by callgrind, for the instruction set that this is built for: `--write`
//! writes them to counts.csv, `--check` fails where a path takes more than that file has.

use eigenshade_benches::paths::{self, Path};
use eigenshade_benches::sheet::{self, Row};
use std::process::{Command, ExitCode};

const FILE: &str = "counts.csv";
const COLUMNS: [&str; 4] = ["path", "multiply-adds", "SSE2", "AVX2"];
/// The column of this build.
const BUILD: &str = if cfg!(target_feature = "fma") { COLUMNS[3] } else { COLUMNS[2] };

/// A path takes no more than this times the instructions of the file: other compilers write other
/// code.
const MORE: f64 = 1.1;

fn main() -> ExitCode {
    let mut paths = paths::all();
    let argument = std::env::args().nth(1);
    match argument.as_deref() {
        None => paths.iter_mut().for_each(|path| counted_by_callgrind(&mut path.run)),
        Some("--write") => sheet::write(FILE, &COLUMNS, &counts(&paths), |count| {
            ((100.0 * count).round() / 100.0).to_string()
        }),
        Some("--check") => {
            if !sheet::check(FILE, &counts(&paths), |stated, found| found <= MORE * stated + 0.05) {
                eprintln!("{BUILD}: if this is intended, run `benches/run` and commit");
                return ExitCode::FAILURE;
            }
        }
        Some(_) => {
            eprintln!("usage: eigenshade-benches [--write | --check]");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}

/// The function in which instructions are counted.
const COUNTED: &str = "eigenshade_benches::counted_by_callgrind";

#[inline(never)]
fn counted_by_callgrind(run: &mut dyn FnMut()) {
    run();
    // Callgrind sees its end, because this does not become a jump.
    std::hint::black_box(());
}

/// Runs this program without arguments under callgrind, which writes the instructions of each path.
fn counts(paths: &[Path]) -> Vec<Row> {
    let program = std::env::current_exe().expect("this program");
    let file = program.with_extension("callgrind");
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--combine-dumps=yes"])
        .args(["--toggle-collect", "--dump-after"].map(|option| format!("{option}={COUNTED}")))
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(program)
        .output()
        .expect("valgrind: install it");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let text = std::fs::read_to_string(file).expect("callgrind's file");
    let totals: Vec<f64> = text
        .lines()
        .filter_map(|line| line.strip_prefix("totals: ")?.parse().ok())
        .filter(|&total| total > 0.0)
        .collect();
    assert_eq!(totals.len(), paths.len(), "callgrind counted other paths");
    let row = |(path, total): (&Path, f64)| Row {
        name: vec![path.name.clone()],
        cells: vec![
            (COLUMNS[1].to_owned(), path.multiply_adds as f64),
            (BUILD.to_owned(), total / path.count as f64),
        ],
    };
    paths.iter().zip(totals).map(row).collect()
}
