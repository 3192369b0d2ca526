//! `experiments golden`: the results that every machine must reproduce in every number format.

use super::page;
use super::purpose::Purpose;
use clap::Args;
use eigenshade_model::error;
use eigenshade_testing::golden::answers;
use eigenshade_testing::golden::record::{self, Row};

const COMMAND: &str = "cargo run --release -p experiments -- golden --out tests/golden/sphere.csv";

/// Results of the runtime, tests/golden/sphere.csv
///
/// Integers must be equal; floats may differ by the tolerance that the file states.
#[derive(Args, Debug)]
pub struct Golden {
    #[command(flatten)]
    purpose: Purpose,
}

impl Golden {
    pub fn run(self) -> error::Result<()> {
        let answered = answers::golden();
        let text = answered.text(&[COMMAND, "What the rows are: docs/formats.md"]);
        page::write_or_compare(&self.purpose, &text, COMMAND, |recorded, _| {
            compare(&record::Golden::parse(recorded)?, &answered)
        })
    }
}

fn compare(recorded: &record::Golden, answered: &record::Golden) -> Result<(), String> {
    if recorded.rows.len() != answered.rows.len() {
        return Err("it has other rows".into());
    }
    for (old, new) in recorded.rows.iter().zip(&answered.rows) {
        if old != new && !near(old, new)? {
            let (pair, array) = (new.pair.join(" "), &new.array);
            return Err(format!("{} {pair} {array}: it is another now", new.format));
        }
    }
    Ok(())
}

/// Whether both are the same array of floats, up to the tolerance times the largest value.
fn near(old: &Row, new: &Row) -> Result<bool, String> {
    if old.format != "f32" || (&old.pair, &old.array) != (&new.pair, &new.array) {
        return Ok(false);
    }
    let (old, new) = (old.floats()?, new.floats()?);
    let largest = new.iter().fold(0.0f32, |most, number| most.max(number.abs()));
    let within = |(a, b): (&f32, &f32)| (a - b).abs() <= answers::GOLDEN_F32 * largest;
    Ok(old.len() == new.len() && old.iter().zip(&new).all(within))
}
