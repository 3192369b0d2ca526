//! Tables of ways, ratios and errors, as Markdown.

use std::fmt::Write;

/// One comparison.
pub struct Table {
    pub title: &'static str,
    /// What is compared with what.
    pub note: String,
    /// Heads of the columns after that of the ways: times first, then errors.
    pub heads: Vec<String>,
    pub rows: Vec<Row>,
}

/// One way.
pub struct Row {
    pub way: String,
    /// In the comparison's unit, if times were measured.
    pub ratio: Option<f64>,
    /// Who is ahead; empty where there is nothing to say.
    pub standing: String,
    /// One for each head of errors, None where there is nothing to compare; NaN where it
    /// gives no number.
    pub errors: Vec<Option<f64>>,
}

/// Below this an error is rounding, which differs from host to host.
pub const ROUNDING: f64 = 1e-5;

/// Two digits, as people write them.
pub fn two_digits(value: f64) -> String {
    if !value.is_finite() {
        "no number".into()
    } else if value == 0.0 {
        "0".into()
    } else if !(0.01..1e6).contains(&value) {
        format!("{value:.1e}")
    } else {
        let decimals = 1 - value.log10().floor() as i32;
        let power = 10f64.powi(decimals);
        let text = format!("{:.*}", decimals.max(0) as usize, (value * power).round() / power);
        match text.len() {
            thousands @ 4.. if decimals <= 0 => {
                let (front, back) = text.split_at(thousands - 3);
                format!("{front},{back}")
            }
            _ => text,
        }
    }
}

/// Who is ahead, `factor` being their time in ours.
pub fn standing(ours: &str, theirs: &str, factor: f64) -> String {
    if factor > 1.05 {
        format!("{ours} is {} times as fast", two_digits(factor))
    } else if factor < 1.0 / 1.05 {
        format!("**we are not ahead**: {theirs} is {} times as fast", two_digits(1.0 / factor))
    } else {
        format!("{ours} and {theirs} are as fast")
    }
}

impl Table {
    pub fn markdown(&self) -> String {
        let mut text = format!("### {}\n\n{}\n\n| way | ", self.title, self.note);
        text += &self.heads.join(" | ");
        text += " |\n|---|---:|---";
        text += &"|---:".repeat(self.heads.len() - 2);
        text += "|\n";
        for row in &self.rows {
            let ratio = row.ratio.map_or(String::new(), two_digits);
            write!(text, "| {} | {ratio} | {} |", row.way, row.standing).expect("a string grows");
            for &error in &row.errors {
                let error = error.map_or(String::new(), two_digits);
                write!(text, " {error} |").expect("a string grows");
            }
            text.push('\n');
        }
        text
    }

    /// What differs from the errors that a page states: `stated` is the part of it between the
    /// marks of some build.
    pub fn faults(&self, stated: &str, relative: f64, rounding: f64) -> Vec<String> {
        let lines = stated.split("\n### ").find_map(|part| part.strip_prefix(self.title));
        let Some(lines) = lines else { return vec![format!("{}: not on the page", self.title)] };
        let mut faults = Vec::new();
        for row in &self.rows {
            let start = format!("\n| {} |", row.way);
            let line = lines.split_once(&start).and_then(|(_, rest)| rest.lines().next());
            let Some(line) = line else {
                faults.push(format!("{}, {}: not on the page", self.title, row.way));
                continue;
            };
            let cells: Vec<&str> = line.trim_end_matches('|').split('|').map(str::trim).collect();
            for (k, error) in row.errors.iter().enumerate() {
                let Some(error) = *error else { continue };
                let cell = cells.get(2 + k).copied().unwrap_or_default();
                if !agrees(cell, error, relative, rounding) {
                    let head = &self.heads[2 + k];
                    let (title, way) = (self.title, &row.way);
                    faults.push(format!(
                        "{title}, {way}, {head}: {error:.3e}, the page has `{cell}`"
                    ));
                }
            }
        }
        faults
    }
}

fn agrees(cell: &str, error: f64, relative: f64, rounding: f64) -> bool {
    match cell.parse::<f64>() {
        Err(_) => cell == two_digits(error),
        Ok(stated) if stated < ROUNDING => error <= rounding * stated,
        Ok(stated) => (error - stated).abs() <= relative * stated,
    }
}
