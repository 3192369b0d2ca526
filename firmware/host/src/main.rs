//! Builds the programs for the emulated boards, runs them, checks the linked files, and counts
//! instructions: see `firmware/README.md`.

#[expect(dead_code, reason = "the build script reads the tables")]
#[path = "../../programs/list.rs"]
mod list;

mod program;

mod toolchain;

mod frames;
mod gate;

mod limits;
mod page;
mod row;

use list::Program;
use program::{BOARDS, Board, Kind};
use rayon::prelude::*;
use row::Row;
use std::collections::BTreeMap;
use std::process::ExitCode;

const USAGE: &str = "usage: firmware/run BOARD... | all [--check] [--update], \
                     firmware/run BOARD PROGRAM..., firmware/run gates, firmware/run pages
boards: microbit mps2-an386, counted; mps2-an385 riscv32, whose answers are checked
programs: OPERATION_FORMAT of firmware/operations.csv, TABLE_FORMAT of firmware/tables/sizes.csv";

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

/// Builds, runs and checks some programs of a board, with their limits, and prints their counts.
fn some_programs(board: Board, names: &[&str]) -> Result<()> {
    let listed = program::of_board(board);
    if let Some(name) = names.iter().find(|name| !listed.iter().any(|one| one.name() == **name)) {
        return Err(format!("no program {name} on {}\n{USAGE}", board.name));
    }
    let wanted = |one: &Program| one.kind() == Kind::Empty || names.contains(&&*one.name());
    let programs: Vec<Program> = listed.into_iter().filter(wanted).collect();
    println!("{}", row::HEADER);
    build(&[(board, &programs)])?;
    let rows = run(board, &programs, &mut BTreeMap::new())?;
    rows.iter().for_each(|row| println!("{row}"));
    limits::within(&rows)
}

/// Builds, runs and checks all programs of these boards, and prints the counts as CSV.
fn boards(boards: &[Board], options: &[&str]) -> Result<()> {
    let of_board = |&board: &Board| (board, program::of_board(board));
    let boards: Vec<(Board, Vec<Program>)> = boards.iter().map(of_board).collect();
    let listed: Vec<_> = boards.iter().map(|(board, programs)| (*board, &programs[..])).collect();
    build(&listed)?;
    let (mut rows, mut compilers, mut pictures) = (Vec::new(), BTreeMap::new(), BTreeMap::new());
    println!("{}", row::HEADER);
    for (board, programs) in listed {
        for row in run(board, programs, &mut pictures)? {
            println!("{row}");
            rows.push(row);
        }
        if board.is_counted() {
            compilers.insert(board.name, toolchain::version()?);
        }
    }
    if options.contains(&"--update") {
        row::record(&rows, &compilers)?;
        page::write()?;
    }
    limits::within(&rows)?;
    if options.contains(&"--check") {
        row::same_as_recorded(&rows, &compilers)?;
        page::check()?;
    }
    Ok(())
}

/// Builds the programs of boards. One run of cargo builds those that have the same boards, for all
/// of these side by side.
fn build(boards: &[(Board, &[Program])]) -> Result<()> {
    page::write_programs()?;
    let mut groups: BTreeMap<(&str, Vec<&str>), Vec<Program>> = BTreeMap::new();
    for program in list::programs() {
        let runs = |programs: &[Program]| programs.iter().any(|one| one.name() == program.name());
        let of_program = boards.iter().filter(|(_, programs)| runs(programs));
        let targets = of_program.map(|(board, _)| board.target).collect();
        groups.entry((program.opt_level(), targets)).or_default().push(program);
    }
    groups.into_iter().try_for_each(|((opt_level, targets), programs)| {
        let names: Vec<String> = programs.iter().map(Program::name).collect();
        toolchain::build(&targets, "programs", &names, opt_level)
    })
}

/// Runs and checks programs; on a board that is counted, the empty one is the first. Complete
/// programs must draw the picture that they drew on another board.
fn run(
    board: Board,
    programs: &[Program],
    pictures: &mut BTreeMap<String, String>,
) -> Result<Vec<Row>> {
    let mut empty = gate::Sizes::default();
    let mut rows = Vec::new();
    for (program, (sizes, output)) in programs.iter().zip(outputs(board, programs)?) {
        let (kind, name) = (program.kind(), program.name());
        if kind == Kind::Complete {
            let picture = output.split("stack").next().unwrap_or_default();
            if picture != pictures.entry(name.clone()).or_insert(picture.into()) {
                return Err(format!("{name} draws another picture on {}:\n{picture}", board.name));
            }
        }
        match kind {
            Kind::Empty => empty = sizes,
            Kind::Answers => eprintln!("{}: {name} passes: {}", board.name, output.trim()),
            _ if !board.is_counted() => eprintln!("{}: {name} passes", board.name),
            _ => rows.extend(Row::of_program(
                program.machine(board),
                program,
                &output,
                sizes,
                empty,
            )?),
        }
    }
    Ok(rows)
}

/// Checks what was linked and runs it, on all processors: sizes and output of each program.
fn outputs(board: Board, programs: &[Program]) -> Result<Vec<(gate::Sizes, String)>> {
    let outputs = programs.par_iter().map(|program| {
        let path = toolchain::binary(board.target, &program.name());
        let linked = gate::Linked::read(&path)?;
        gate::check(board, &program.name(), &linked)?;
        Ok((linked.sizes, toolchain::run(program.machine(board), &path)?))
    });
    outputs.collect()
}
