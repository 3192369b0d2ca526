//! Whether the gates are shut: each of the programs in `gates/` has one thing that must
//! not be there, and has to be refused for it.

use crate::Result;
use crate::board::Board;
use crate::linked::Linked;
use crate::{compiler, gate};

/// Who refuses a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    Linker,
    Check,
}

/// A program, the board that it is refused on, by whom, and a word of why.
const REFUSED: [(&str, Board, By, &str); 6] = [
    ("panics", Board::An386, By::Linker, "undefined symbol: a_panic_can_be_reached"),
    ("formats", Board::An386, By::Check, "core::fmt is linked"),
    ("doubles", Board::An386, By::Check, "arithmetic in f64 is linked"),
    ("floats", Board::Microbit, By::Check, "arithmetic in f32 is linked"),
    ("initialised", Board::Microbit, By::Check, ".data is linked"),
    ("allocates", Board::An386, By::Check, "a heap is linked"),
];

/// Builds and checks each; says what happened.
///
/// # Errors
///
/// A program that is let through, or refused for another reason.
pub fn run() -> Result<()> {
    for (program, board, by, reason) in REFUSED {
        let compiler = compiler::Compiler::new(board.target());
        let built = compiler.build("gates", &[program.into()], "fast");
        let checked = match by {
            By::Linker => built,
            By::Check => {
                built?;
                let linked = Linked::read(&compiler.binary("fast", program))?;
                gate::check(board, program, &linked)
            }
        };
        match checked {
            Err(fault) if fault.contains(reason) => {
                let line = fault.lines().find(|line| line.contains(reason)).unwrap_or_default();
                println!("{program}: refused: {}", line.trim());
            }
            Err(fault) => {
                return Err(format!("{program} is refused, but not because {reason}: {fault}"));
            }
            Ok(()) => return Err(format!("{program} is let through: the gate is open")),
        }
    }
    Ok(())
}
