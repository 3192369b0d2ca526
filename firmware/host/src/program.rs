//! The programs.

use crate::board::Board;

/// What a program is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// All that the measured programs have, but no operation.
    Nothing,
    /// One operation, measured.
    Operation,
    /// A scene of the ablation, or a table of the ladder: several operations of one program,
    /// and what it takes in all.
    Scene,
    /// A whole program, whose size has a budget.
    Whole,
    /// Shows something, or fails.
    Demonstration,
}

/// A program: `OPERATION_FORMAT` in `programs/src/bin`.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// What it does.
    pub operation: &'static str,
    /// In which number format.
    pub format: &'static str,
    /// What it is for.
    pub kind: Kind,
    /// How often the operation is done: rows of a matrix of which the program has one.
    pub times: u64,
}

impl Program {
    /// The name of its binary.
    pub fn binary(&self) -> String {
        match self.kind {
            Kind::Nothing => self.operation.into(),
            _ => format!("{}_{}", self.operation, self.format),
        }
    }

    /// The profile that it is built with.
    pub const fn profile(&self) -> &'static str {
        match self.kind {
            Kind::Whole => "small",
            _ => "fast",
        }
    }
}

/// Operations that exist in all three formats.
const OPERATIONS: [&str; 6] =
    ["shade", "shade_lambertian", "relight", "collapse", "relight_collapse", "transfer"];

/// The scenes of `firmware/scenes`, in the order of `docs/ablation.md`.
const SCENES: [&str; 10] = [
    "ambient_lambertian",
    "ambient_velvet",
    "sky_lambertian",
    "park_lambertian",
    "park_lambertian_fine",
    "studio_plaster",
    "studio_velvet",
    "sun_leather",
    "sun_leather_colour",
    "sun_leather_turning",
];

/// The scene that integers, which do not turn lights, have no program of.
const TURNING: &str = "sun_leather_turning";

/// The list of the tables of which a pixel and a new light are counted.
const LADDER: &str = include_str!("../../tables/ladder.csv");

/// Components K of the shipped table.
const COMPONENTS: u64 = 50;

/// The names of the ladder's tables.
fn ladder() -> impl Iterator<Item = &'static str> {
    let rows = LADDER.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.filter_map(|row| row.split(',').next())
}

/// The programs that run on a board, the empty one first.
pub fn of_board(board: Board) -> impl Iterator<Item = Program> {
    let one = |operation, format, kind| Program { operation, format, kind, times: 1 };
    let mut all = vec![one("empty", "none", Kind::Nothing)];
    for format in ["f32", "q15", "q31"] {
        all.push(one("golden", format, Kind::Demonstration));
        all.push(one("sphere", format, Kind::Demonstration));
        all.extend(OPERATIONS.map(|operation| one(operation, format, Kind::Operation)));
    }
    all.extend(
        ["project", "collapse_within", "nine_terms"].map(|name| one(name, "f32", Kind::Operation)),
    );
    all.push(one("nine_terms", "q15", Kind::Operation));
    for format in ["f32", "q15"] {
        all.extend(["baked", "baked_point"].map(|name| one(name, format, Kind::Operation)));
    }
    all.push(Program { times: COMPONENTS, ..one("dense_row", "q15", Kind::Operation) });
    all.push(one("any_material", "q15", Kind::Whole));
    all.push(one("one_material", "q15", Kind::Whole));
    for name in ladder() {
        // Without a float unit integers take a twentieth of the instructions.
        if board.has_float_unit() {
            all.push(one(name, "f32", Kind::Scene));
        }
        all.push(one(name, "q15", Kind::Scene));
    }
    // On the processor without a float unit, and on the one with it.
    match board {
        Board::Microbit => {
            let still = SCENES.into_iter().filter(|name| *name != TURNING);
            all.extend(still.map(|name| one(name, "q15", Kind::Scene)));
        }
        Board::An386 => all.extend(SCENES.map(|name| one(name, "f32", Kind::Scene))),
        _ => {}
    }
    all.into_iter().filter(move |program| board.takes_floats() || program.format != "f32")
}
