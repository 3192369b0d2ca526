//! Whether the gates are shut: each of the programs in `gates/` has one thing that must
//! not be there, and has to be refused for it.

use crate::Result;
use crate::board::Board;
use crate::linked::Linked;
use crate::{compiler, gate};

/// A program, the board that it is refused on, and a word of why.
const REFUSED: [(&str, Board, &str); 6] = [
    ("panics", Board::An386, "a_panic_can_be_reached"),
    ("formats", Board::An386, "core::fmt"),
    ("doubles", Board::An386, "arithmetic in f64"),
    ("floats", Board::Microbit, "arithmetic in f32"),
    ("initialised", Board::Microbit, ".data"),
    ("allocates", Board::An386, "a heap"),
];

/// Builds and checks each; says what happened.
///
/// # Errors
///
/// A program that is let through, or refused for another reason.
pub fn run() -> Result<()> {
    for (program, board, reason) in REFUSED {
        let compiler = compiler::for_target(board.target())?;
        let checked = compiler.build("gates", &[program.into()], "fast").and_then(|()| {
            let linked = Linked::read(&compiler.binary("fast", program))?;
            gate::check(board, program, &linked)
        });
        match checked {
            Err(fault) if fault.contains(reason) => {
                let line = fault.lines().find(|line| line.contains(reason)).unwrap_or_default();
                println!("{program}: refused: {}", line.trim());
            }
            Err(fault) => return Err(format!("{program} is refused, but not for {reason}: {fault}")),
            Ok(()) => return Err(format!("{program} is let through: the gate of {reason} is open")),
        }
    }
    Ok(())
}
