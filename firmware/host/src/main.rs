//! Builds the programs for the emulated boards, runs them, checks the linked files, and counts
//! instructions: see `firmware/README.md`.

#[path = "../../programs/list.rs"]
mod list;

mod program;

mod toolchain;

mod gate;

mod budget;
mod page;
mod row;

use list::Listed;
use program::{BOARDS, Board, Kind};
use row::Row;
use std::collections::BTreeMap;
use std::process::ExitCode;
use toolchain::Compiler;

const USAGE: &str = "usage: firmware/run BOARD... | all [--check] [--update], \
                     firmware/run BOARD PROGRAM..., firmware/run gates, firmware/run pages
boards: microbit mps2-an385 mps2-an386 riscv32; programs: bin in firmware/programs/Cargo.toml";

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
        ["all"] => boards(&BOARDS, &options),
        _ => chosen(&names, &options),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::from(1)
        }
    }
}

/// Runs the boards of these names, or some programs of one board.
fn chosen(names: &[&str], options: &[&str]) -> Result<()> {
    let found = |name: &&str| BOARDS.into_iter().find(|board| board.name == *name);
    let chosen: Vec<Board> = names.iter().map_while(found).collect();
    match (&chosen[..], &names[chosen.len()..]) {
        (_, []) => boards(&chosen, options),
        (&[board], programs) if options.is_empty() => some_programs(board, programs),
        (&[_], _) => Err(format!("{} is for whole boards\n{USAGE}", options.join(" "))),
        (_, [name, ..]) => Err(format!("`{name}` is unexpected\n{USAGE}")),
    }
}

/// Builds, runs and checks some programs of a board, and prints their counts.
fn some_programs(board: Board, names: &[&str]) -> Result<()> {
    let listed: Vec<Listed> = program::of_board(board).collect();
    if let Some(name) = names.iter().find(|name| !listed.iter().any(|one| one.name == **name)) {
        return Err(format!("no program {name} on {}\n{USAGE}", board.name));
    }
    let wanted = |one: &Listed| one.kind() == Kind::Empty || names.contains(&one.name);
    let programs: Vec<Listed> = listed.into_iter().filter(wanted).collect();
    println!("{}", row::HEADER);
    let rows = run(board, &programs, &Compiler::new(board.target))?;
    rows.iter().for_each(|row| println!("{row}"));
    Ok(())
}

/// Builds, runs and checks all programs of these boards, and prints the counts as CSV.
fn boards(boards: &[Board], options: &[&str]) -> Result<()> {
    let mut rows = Vec::new();
    let mut compilers = BTreeMap::new();
    println!("{}", row::HEADER);
    for &board in boards {
        let compiler = Compiler::new(board.target);
        let programs: Vec<Listed> = program::of_board(board).collect();
        for row in run(board, &programs, &compiler)? {
            println!("{row}");
            rows.push(row);
        }
        compilers.insert(board.name, compiler.version()?);
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

/// Builds, runs and checks programs, of which the first is the empty one.
fn run(board: Board, programs: &[Listed], compiler: &Compiler) -> Result<Vec<Row>> {
    for profile in ["fast", "small"] {
        let of_profile = programs.iter().filter(|program| program.profile() == profile);
        let names: Vec<&str> = of_profile.map(|program| program.name).collect();
        compiler.build("programs", &names, profile)?;
    }
    let mut empty = gate::Sizes::default();
    let mut rows = Vec::new();
    for program in programs {
        let path = compiler.binary(program.profile(), program.name);
        let linked = gate::Linked::read(&path)?;
        gate::check(board, program.name, &linked)?;
        let output = toolchain::run(board, &path)?;
        let sizes = linked.sizes();
        match program.kind() {
            Kind::Empty => empty = sizes,
            Kind::Demonstration => eprint!("{}: {}\n{output}", board.name, program.name),
            _ => rows.extend(Row::of_program(board, program, &output, sizes, empty)?),
        }
    }
    Ok(rows)
}
