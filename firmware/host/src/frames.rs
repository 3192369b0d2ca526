//! The tables of frames a second: the clock of a chip by the instructions of a frame.

use crate::Result;
use crate::program::{AN386, Board, MICROBIT};
use crate::row::{self, Row};

/// Chips with the processors of the boards: name, board, number format, clock in MHz.
const CHIPS: [(&str, Board, &str, u64); 3] = [
    ("RP2040, Cortex-M0+", MICROBIT, "q15", 133),
    ("nRF52840, Cortex-M4F", AN386, "f32", 64),
    ("STM32F411, Cortex-M4F", AN386, "f32", 100),
];

/// The operations that are a frame, and their objects.
const OBJECTS: [(&str, &str); 8] = [
    ("watch", "the watch, 128 x 128"),
    ("watch_240", "240 x 240"),
    ("watch_240_still", "light at rest"),
    ("frame", "a sphere of gold, 240 x 240"),
    ("frame_still", "light at rest"),
    ("frame_sources", "with 4 sources"),
    ("frame_textured", "a textured object, 120 x 120"),
    ("frame_shadowed", "an object with shadows, 96 x 96"),
];

/// The ways to draw a sphere, and the columns of the color difference.
const WAYS: [(&str, &str, &str); 4] = [
    ("frame", "a palette of its normals", "palette565"),
    ("frame_shaded", "every pixel shaded", "rgb565"),
    ("frame_nine_terms", "every pixel by the nine-term formula, light at rest", "degree2"),
    ("frame_matcap", "a matcap that stands still", "still"),
];

/// The color differences of pictures.
const DIFFERENCES: &str = "../docs/palette.csv";

/// Frames a second if an instruction takes a cycle.
fn rate(rows: &[Row], operation: &str, chip: usize) -> String {
    let (_, board, format, megahertz) = CHIPS[chip];
    let instructions = row::instructions(rows, [board.name, operation, format]);
    let rate = instructions.map(|instructions| megahertz as f64 * 1e6 / instructions as f64);
    rate.map_or(" |".into(), |rate| format!(" {rate:.1} |"))
}

/// A line for each chip.
pub fn objects(rows: &[Row]) -> String {
    let mut text = String::from("| frames a second, at most |");
    text.extend(OBJECTS.map(|(_, object)| format!(" {object} |")));
    text += &format!("\n|---|{}\n", "---:|".repeat(OBJECTS.len()));
    for (index, (chip, _, format, megahertz)) in CHIPS.into_iter().enumerate() {
        let format = if format == "f32" { "f32" } else { "Q15" };
        text += &format!("| {chip}, {megahertz} MHz, {format} |");
        text.extend(OBJECTS.map(|(operation, _)| rate(rows, operation, index)));
        text.push('\n');
    }
    text
}

/// A line for each way to draw a sphere, with its color difference in the median picture.
pub fn ways(rows: &[Row]) -> Result<String> {
    let csv =
        std::fs::read_to_string(DIFFERENCES).map_err(|error| format!("{DIFFERENCES}: {error}"))?;
    let mut text = String::from(
        "| a sphere of gold under a turning light, 240 x 240 | RP2040, Q15, frames a second | nRF52840, f32 | color difference |\n|---|---:|---:|---:|\n",
    );
    for (operation, way, column) in WAYS {
        let median = |part: &str| median(&csv, &format!("{column}_{part}"));
        text += &format!("| {way} |{}{}", rate(rows, operation, 0), rate(rows, operation, 1));
        text += &format!(" {:.1} / {:.1} |\n", median("mean")?, median("p95")?);
    }
    Ok(text)
}

/// The median of a column.
fn median(csv: &str, column: &str) -> Result<f64> {
    let fault = || format!("{DIFFERENCES}: no numbers in the column {column}");
    let mut lines = csv.lines().filter(|line| !line.starts_with('#'));
    let header = lines.next().ok_or_else(fault)?;
    let place = header.split(',').position(|name| name == column).ok_or_else(fault)?;
    let numbers = lines.map(|line| line.split(',').nth(place)?.parse::<f64>().ok());
    let mut numbers: Vec<f64> = numbers.collect::<Option<_>>().ok_or_else(fault)?;
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().ok_or_else(fault)
}

#[cfg(test)]
mod tests {
    use super::{median, objects};

    #[test]
    fn frames_are_the_clock_by_the_instructions() {
        let rows = ["microbit,watch,q15,26600000,1,1,1".parse().unwrap()];
        let text = objects(&rows);
        assert!(text.contains("| RP2040, Cortex-M0+, 133 MHz, Q15 | 5.0 | |"), "{text}");
        assert!(text.contains("| nRF52840, Cortex-M4F, 64 MHz, f32 | | |"), "{text}");
    }

    #[test]
    fn the_median_is_that_of_the_column() {
        let csv = "# a\nx,y_mean\na,3\nb,1\nc,2.5\n";
        assert_eq!(median(csv, "y_mean"), Ok(2.5));
        assert!(median(csv, "y").unwrap_err().contains("column y"));
    }
}
