//! Limits of the counts: `budgets.csv`, which has the columns of the counts. An empty field is no
//! limit.

use crate::Result;
use crate::row::{self, Row};

const BUDGETS: &str = "budgets.csv";
const NAMES: [&str; 4] = ["instructions", "bytes of flash", "bytes of RAM", "bytes of stack"];

/// Checks rows against the budgets of their boards.
pub fn within(rows: &[Row]) -> Result<()> {
    let (_, budgets) = row::read(BUDGETS)?;
    let mut faults = over(rows, &budgets);
    faults.extend(expensive(rows));
    result(&faults)
}

/// Checks rows of some programs, without the budgets of other operations.
pub fn within_measured(rows: &[Row]) -> Result<()> {
    let (_, mut budgets) = row::read(BUDGETS)?;
    budgets.retain(|budget| rows.iter().any(|row| row.key == budget.key));
    result(&over(rows, &budgets))
}

fn result(faults: &[String]) -> Result<()> {
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

fn over(rows: &[Row], budgets: &[Row]) -> Vec<String> {
    let measured = |budget: &&Row| rows.iter().any(|row| row.key[0] == budget.key[0]);
    let mut faults = Vec::new();
    for budget in budgets.iter().filter(measured) {
        let name = budget.key.join(",");
        let Some(row) = rows.iter().find(|row| row.key == budget.key) else {
            faults.push(format!("{BUDGETS}: {name} was not measured"));
            continue;
        };
        for ((limit, found), what) in budget.numbers.iter().zip(row.numbers).zip(NAMES) {
            let (Some(limit), found) = (limit, found.unwrap_or(u64::MAX)) else { continue };
            if found > *limit {
                faults.push(format!("{name}: {found} {what}, {BUDGETS} allows {limit}"));
            }
        }
    }
    faults
}

/// Maximum cost of `collapse_within` as a multiple of `project`'s on the same board.
const MAX_PROJECTIONS: u64 = 3;

fn expensive(rows: &[Row]) -> Vec<String> {
    let boards = rows.iter().filter(|row| row.key[1] == "collapse_within").map(|row| &row.key[0]);
    let mut faults = Vec::new();
    for board in boards {
        let [Some(within), Some(project)] = ["collapse_within", "project"]
            .map(|name| row::instructions(rows, [board, name, "f32"]))
        else {
            faults.push(format!("{board}: project or collapse_within was not measured"));
            continue;
        };
        if within > MAX_PROJECTIONS * project {
            faults.push(format!(
                "{board},collapse_within,f32: {within} instructions, more than {MAX_PROJECTIONS} times \
                 project's {project}"
            ));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::{expensive, over};

    #[test]
    fn scenes_within_a_tolerance_take_few_projections() {
        let rows = |text: &str| text.lines().map(|line| line.parse().unwrap()).collect::<Vec<_>>();
        let both = "b,project,f32,100,1,1,1\nb,collapse_within,f32,";
        assert_eq!(expensive(&rows(&format!("{both}300,1,1,1"))), [""; 0]);
        assert!(expensive(&rows(&format!("{both}301,1,1,1")))[0].contains("301"));
        assert!(expensive(&rows("b,collapse_within,f32,1,1,1,1"))[0].contains("not measured"));
    }

    #[test]
    fn budgets_fail_when_exceeded_or_not_measured() {
        let rows = |text: &str| text.lines().map(|line| line.parse().unwrap()).collect::<Vec<_>>();
        let budgets = rows("b,shade,q15,100,,50,\nb,transfer,q15,9,,,\nother,shade,q15,1,,,");
        let within = rows("b,shade,q15,100,9999,50,9999\nb,transfer,q15,9,1,1,1");
        assert_eq!(over(&within, &budgets), [""; 0]);
        let found = over(&rows("b,shade,q15,101,1,51,1"), &budgets);
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[0].contains("101 instructions") && found[2].contains("not measured"));
    }
}
