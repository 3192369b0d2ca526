//! The counts as CSV, and the recorded ones in `counts.csv`.

use crate::Result;
use crate::gate::Sizes;
use crate::list::Program;
use crate::program::{BOARDS, Board, Kind};
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

/// The CSV's first line.
pub const HEADER: &str = "board,operation,format,instructions,flash_bytes,ram_bytes,stack_bytes";

/// Separates the name of a scene from that of an operation.
const SCENE: char = '/';

/// The recorded counts. The comments name the compiler of each board.
pub const RECORD: &str = "counts.csv";

/// Bytes of flash by which two checkouts may differ. Names contain a hash of the path of the
/// sources, and functions are compiled and linked in the order of names: this changes padding and,
/// in the largest functions, which numbers stay in registers. The largest difference between
/// checkouts was 100 bytes of 53,268, and between versions that changed other code 84 bytes of
/// 18,500, a 220th.
fn of_the_path(flash: u64) -> u64 {
    (flash / 128).max(32)
}

/// The costs of an operation on a board. Empty numbers are not measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Board, operation and format.
    pub key: [String; 3],
    /// Instructions, bytes of flash, of RAM, of stack.
    pub numbers: [Option<u64>; 4],
}

impl Row {
    /// The rows of a program. That of an operation has flash and RAM beyond those of `empty`; that
    /// of a complete program has totals, and its RAM includes the stack. A scene has a row for each
    /// operation, such as `NAME/pixel`, and `NAME/scene` with its memory beyond that of `empty`.
    pub fn of_program(
        board: Board,
        program: &Program,
        output: &str,
        sizes: Sizes,
        empty: Sizes,
    ) -> Result<Vec<Self>> {
        let row = |part: &str, numbers| {
            let operation = program.operation.to_owned() + part;
            Self { key: [board.name.into(), operation, program.format.into()], numbers }
        };
        let flash = || Some(sizes.flash.saturating_sub(empty.flash));
        let ram = || Some(sizes.ram - empty.ram + held(output));
        match program.kind() {
            Kind::Empty | Kind::Answers => Ok(Vec::new()),
            Kind::Operation => {
                let (instructions, stack) = measured(board, output)?;
                Ok(vec![row("", [Some(instructions), flash(), ram(), Some(stack)])])
            }
            Kind::Scene => {
                let (mut rows, mut deepest) = (Vec::new(), 0);
                for part in output.split("operation ").skip(1) {
                    let (operation, output) = part.split_once('\n').unwrap_or((part, ""));
                    let (instructions, stack) = measured(board, output)?;
                    deepest = deepest.max(stack);
                    let numbers = [Some(instructions), None, None, Some(stack)];
                    rows.push(row(&format!("{SCENE}{operation}"), numbers));
                }
                rows.push(row(&format!("{SCENE}scene"), [None, flash(), ram(), Some(deepest)]));
                Ok(rows)
            }
            Kind::Complete => {
                let stack = numbers(output, "stack", 1)?[0];
                let numbers = [None, Some(sizes.flash), Some(sizes.ram + stack), Some(stack)];
                Ok(vec![row("", numbers)])
            }
        }
    }

    pub fn is_of_scene(&self) -> bool {
        self.key[1].contains(SCENE)
    }
}

/// Instructions of an operation, rounded to the nearest, and bytes of stack.
fn measured(board: Board, output: &str) -> Result<(u64, u64)> {
    let numbers = |word: &str, count: usize| numbers(output, word, count);
    let tick = numbers("tick", 2)?;
    let half_instructions = board.half_instructions_in_a_tick;
    let expected = 2 * tick[0] / half_instructions;
    if tick[1].abs_diff(expected) > 2 {
        let (found, name) = (tick[1], board.name);
        return Err(format!("{name}: {expected} ticks expected of its clock, {found} found"));
    }
    let count = numbers("count", 3)?;
    let doubled = count[1].saturating_sub(count[2]) * half_instructions;
    Ok(((doubled + count[0]) / (2 * count[0]), numbers("stack", 1)?[0]))
}

/// The bytes of RAM in a program's `holds` lines.
fn held(output: &str) -> u64 {
    let held = output.lines().filter_map(|line| line.strip_prefix("holds "));
    held.filter_map(|bytes| bytes.parse::<u64>().ok()).sum()
}

/// The numbers after the word that starts a line.
fn numbers(output: &str, word: &str, count: usize) -> Result<Vec<u64>> {
    let line = output.lines().find_map(|line| line.strip_prefix(word));
    let numbers: Option<Vec<u64>> =
        line.map(|line| line.split_whitespace().filter_map(|one| one.parse().ok()).collect());
    numbers
        .filter(|numbers| numbers.len() == count)
        .ok_or(format!("no {count} numbers after `{word}` in the output of the program:\n{output}"))
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.key.join(","))?;
        for number in self.numbers {
            write!(f, ",{}", number.map_or(String::new(), |number| number.to_string()))?;
        }
        Ok(())
    }
}

impl FromStr for Row {
    type Err = String;

    fn from_str(line: &str) -> Result<Self> {
        let parsed = || {
            let mut fields = line.split(',');
            let key = [fields.next()?, fields.next()?, fields.next()?].map(Into::into);
            let number = |one: &str| {
                if one.is_empty() { Some(None) } else { one.parse::<u64>().ok().map(Some) }
            };
            let numbers: Vec<Option<u64>> = fields.map(number).collect::<Option<_>>()?;
            Some(Self { key, numbers: numbers.try_into().ok()? })
        };
        parsed().ok_or_else(|| format!("`{line}` is not a row of {HEADER}"))
    }
}

/// The comments and the rows of a CSV file.
pub fn read(path: &str) -> Result<(Vec<String>, Vec<Row>)> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let (comments, lines): (Vec<&str>, Vec<&str>) =
        text.lines().partition(|line| line.starts_with('#'));
    let rows = lines.into_iter().filter(|line| *line != HEADER);
    let rows = rows.map(|line| line.parse().map_err(|fault| format!("{path}: {fault}")));
    Ok((comments.into_iter().map(Into::into).collect(), rows.collect::<Result<_>>()?))
}

pub fn instructions(rows: &[Row], key: [&str; 3]) -> Option<u64> {
    rows.iter().find(|row| row.key == key)?.numbers[0]
}

fn comment(board: &str, compiler: &str) -> String {
    format!("# {board}: {compiler}")
}

/// Records counts, replacing those of the same boards.
pub fn record(rows: &[Row], compilers: &BTreeMap<&str, String>) -> Result<()> {
    let (mut comments, mut all) = read(RECORD).unwrap_or_default();
    comments.retain(|one| !compilers.keys().any(|board| one.starts_with(&comment(board, ""))));
    comments.extend(compilers.iter().map(|(board, compiler)| comment(board, compiler)));
    comments.sort();
    all.retain(|row| !compilers.contains_key(row.key[0].as_str()));
    all.extend(rows.iter().cloned());
    all.sort_by_key(|row| BOARDS.iter().position(|board| board.name == row.key[0]));
    let lines = comments.into_iter().chain([HEADER.into()]).chain(all.iter().map(Row::to_string));
    let text: String = lines.map(|line| line + "\n").collect();
    std::fs::write(RECORD, text).map_err(|error| format!("{RECORD}: {error}"))
}

/// Compares counts with the recorded ones if the compiler is the same.
pub fn same_as_recorded(rows: &[Row], compilers: &BTreeMap<&str, String>) -> Result<()> {
    let (comments, recorded) = read(RECORD)?;
    let mut faults = Vec::new();
    for (board, compiler) in compilers {
        if !comments.contains(&comment(board, compiler)) {
            eprintln!(
                "{board}: counts not compared, because they were recorded with a compiler other than {compiler}"
            );
            continue;
        }
        let of_board = |row: &&Row| row.key[0] == *board;
        let (now, then): (Vec<_>, Vec<_>) =
            (rows.iter().filter(of_board).collect(), recorded.iter().filter(of_board).collect());
        for row in &now {
            let record = then.iter().find(|one| one.key == row.key);
            if !record.is_some_and(|record| same(row, record)) {
                let record = record.map_or("nothing".into(), ToString::to_string);
                faults.push(format!("{row} but {RECORD} has {record}"));
            }
        }
        if now.len() < then.len() {
            faults.push(format!("{RECORD} has rows of {board} without a program"));
        }
    }
    if faults.is_empty() {
        return Ok(());
    }
    Err(format!("{}\nif intended, run `firmware/run all --update`", faults.join("\n")))
}

/// Whether the numbers are the recorded ones: flash to [`of_the_path`], instructions to a 256th and
/// stack to 16 bytes, because a change elsewhere in the crate can move registers and branches, RAM
/// exactly.
fn same(row: &Row, record: &Row) -> bool {
    let [instructions, flash, ram, stack] = row.numbers;
    let [instructions_then, flash_then, ram_then, stack_then] = record.numbers;
    let near = |found: Option<u64>, then: Option<u64>, allowed: u64| match (found, then) {
        (Some(found), Some(then)) => found.abs_diff(then) <= allowed,
        (found, then) => found == then,
    };
    let moved = instructions_then.unwrap_or_default() / 256;
    near(instructions, instructions_then, moved.max(1))
        && near(flash, flash_then, of_the_path(flash_then.unwrap_or_default()))
        && near(stack, stack_then, 16)
        && ram == ram_then
}

#[cfg(test)]
mod tests {
    use super::{Row, same};
    use crate::gate::Sizes;
    use crate::list::Program;
    use crate::program::AN386;

    #[test]
    fn counts_are_compared_up_to_padding_and_ticks() {
        let row = |text: &str| text.parse::<Row>().unwrap();
        let record = row("b,shade,q15,100,2000,50,60");
        assert!(same(&row("b,shade,q15,101,2004,50,60"), &record));
        for other in
            ["100,2040,50,60", "102,2000,50,60", "100,2000,54,60", "100,2000,50,80", "100,2000,,60"]
        {
            assert!(!same(&row(&format!("b,shade,q15,{other}")), &record), "{other}");
        }
        let large = row("b,relight,f32,,40960,,");
        assert!(same(&row("b,relight,f32,,41280,,"), &large));
        assert!(!same(&row("b,relight,f32,,41284,,"), &large));
    }

    #[test]
    fn a_scene_has_a_row_for_each_operation_and_one_of_its_memory() {
        let program = Program { operation: "full", format: "f32", source: "scene", table: "full" };
        let sizes = |flash, ram| Sizes { flash, ram, initialized: 0 };
        let of = |operation: &str, ticks: u32, stack: u32| {
            format!(
                "operation {operation}\ntick 1048576 26214\ncount 10 {ticks} 5\nstack {stack}\n"
            )
        };
        let output = format!("holds 8\n{}{}", of("light", 105, 90), of("pixel", 15, 30));
        let rows = Row::of_program(AN386, &program, &output, sizes(900, 50), sizes(100, 40));
        let rows: Vec<String> = rows.unwrap().iter().map(ToString::to_string).collect();
        let board = "mps2-an386,full";
        assert_eq!(rows[0], format!("{board}/light,f32,400,,,90"));
        assert_eq!(rows[1], format!("{board}/pixel,f32,40,,,30"));
        assert_eq!(rows[2], format!("{board}/scene,f32,,800,18,90"));
        assert!(rows.iter().all(|row| row.parse::<Row>().unwrap().is_of_scene()));
    }
}
