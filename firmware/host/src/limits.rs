//! Limits of the counts, which `operations.csv` has for any compiler.

use crate::Result;
use crate::list::{self, Operation};
use crate::row::Row;

/// The board and the format of each limit, the number's place in a row and its unit.
const LIMITS: [(&str, &str, usize, &str); 5] = [
    ("microbit", "q15", 0, "instructions"),
    ("mps2-an386", "f32", 0, "instructions"),
    ("mps2-an386", "q15", 0, "instructions"),
    ("microbit", "q15", 1, "bytes of flash"),
    ("microbit", "q15", 2, "bytes of RAM"),
];

/// Checks rows against the limits of their operations.
pub fn within(rows: &[Row]) -> Result<()> {
    let faults: Vec<String> =
        list::operations().flat_map(|operation| over(rows, &operation)).collect();
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

fn over(rows: &[Row], operation: &Operation) -> Vec<String> {
    let mut faults = Vec::new();
    for (limit, (board, format, place, unit)) in operation.limits.iter().zip(LIMITS) {
        let key = [board, operation.name, format];
        let Some(row) = rows.iter().find(|row| row.key == key) else { continue };
        let found = row.numbers[place].unwrap_or(u64::MAX);
        // A limit that is no number allows nothing.
        if !limit.is_empty() && !limit.parse().is_ok_and(|limit: u64| found <= limit) {
            let key = key.join(",");
            faults.push(format!("{key}: {found} {unit}, operations.csv allows {limit}"));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::over;
    use crate::list::Operation;

    #[test]
    fn counts_beyond_a_limit_fail() {
        let operation = Operation {
            name: "shade",
            source: "",
            table: "",
            formats: "f32 q15",
            limits: ["100", "9", "", "", "50"],
            description: "",
        };
        let over = |rows: &str| {
            let rows: Vec<_> = rows.lines().map(|line| line.parse().unwrap()).collect();
            over(&rows, &operation)
        };
        let other = "mps2-an386,shade,q15,9999,1,1,1\nmicrobit,other,q15,9999,1,1,1\n";
        assert_eq!(over(&format!("{other}microbit,shade,q15,100,9999,50,9999")), [""; 0]);
        let found = over("microbit,shade,q15,101,1,51,1\nmps2-an386,shade,f32,10,1,1,1");
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(found[0].contains("101 instructions") && found[2].contains("51 bytes of RAM"));
    }
}
