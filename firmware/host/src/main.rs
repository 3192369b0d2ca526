//! Builds the programs for the emulated boards, runs them, checks the linked files, and counts
//! instructions: see `firmware/README.md`.

mod program;

mod toolchain;

mod gate;

mod budget;
mod page;
mod row;

use program::{Board, Kind, Program};
use row::Row;
use std::collections::BTreeMap;
use std::process::ExitCode;
use toolchain::Compiler;

const USAGE: &str = "usage: firmware/run BOARD... | all [--check] [--update], firmware/run gates, \
                     firmware/run pages
boards: microbit mps2-an385 mps2-an386 riscv32";

/// The error is a message with the problem and the remedy.
type Result<T> = std::result::Result<T, String>;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (options, names): (Vec<&str>, Vec<&str>) =
        arguments.iter().map(String::as_str).partition(|word| word.starts_with("--"));
    if names.is_empty() || options.iter().any(|option| !["--check", "--update"].contains(option)) {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    }
    let done = match names[..] {
        ["gates"] => gate::test(),
        ["pages"] => page::write(),
        ["all"] => boards(&Board::ALL, &options),
        _ => names
            .iter()
            .map(|name| Board::named(name).ok_or(format!("no board {name}\n{USAGE}")))
            .collect::<Result<Vec<_>>>()
            .and_then(|chosen| boards(&chosen, &options)),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::from(1)
        }
    }
}

/// Builds, runs and checks the programs of these boards, and prints the counts as CSV.
fn boards(boards: &[Board], options: &[&str]) -> Result<()> {
    let mut rows = Vec::new();
    let mut compilers = BTreeMap::new();
    println!("{}", row::HEADER);
    for &board in boards {
        let compiler = Compiler::new(board.target());
        for row in of_board(board, &compiler)? {
            println!("{row}");
            rows.push(row);
        }
        compilers.insert(board.name(), compiler.version()?);
    }
    if options.contains(&"--update") {
        row::record(&rows, &compilers)?;
        page::write()?;
    }
    budget::within(&rows)?;
    if options.contains(&"--check") {
        row::same_as_recorded(&rows, &compilers)?;
        page::check()?;
    }
    Ok(())
}

fn of_board(board: Board, compiler: &Compiler) -> Result<Vec<Row>> {
    let programs: Vec<Program> = program::of_board(board).collect();
    for profile in ["fast", "small"] {
        let of_profile = programs.iter().filter(|program| program.profile() == profile);
        compiler.build(
            "programs",
            &of_profile.map(Program::binary).collect::<Vec<_>>(),
            profile,
        )?;
    }
    let path = |program: &Program| compiler.binary(program.profile(), &program.binary());
    let mut empty = gate::Sizes::default();
    let mut rows = Vec::new();
    for program in &programs {
        let linked = gate::Linked::read(&path(program))?;
        gate::check(board, &program.binary(), &linked)?;
        let output = toolchain::run(board, &path(program))?;
        let sizes = linked.sizes();
        match program.kind {
            Kind::Empty => empty = sizes,
            Kind::Demonstration => eprint!("{}: {}\n{output}", board.name(), program.binary()),
            Kind::Operation => rows.push(Row::of_operation(board, program, &output, sizes, empty)?),
            Kind::Scene => rows.extend(Row::of_scene(board, program, &output, sizes, empty)?),
            Kind::Whole => rows.push(Row::of_whole(board, program, &output, sizes)?),
        }
    }
    Ok(rows)
}
