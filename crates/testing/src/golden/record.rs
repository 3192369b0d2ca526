//! Reads and writes the golden file.
//!
//! Lines that start with `#` come first, then a header and one row for each array:
//! `format,light,material,channel,array,exponents,numbers`. Exponents and numbers are separated by
//! spaces, without quotes. docs/formats.md describes the arrays.
//!
//! Depends only on the standard library, because build scripts of other workspaces include it.

use std::fmt::Display;

const HEADER: &str = "format,light,material,channel,array,exponents,numbers";

/// One array.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// `f32` or `q15`.
    pub format: String,
    /// Light, material and channel; empty if the array belongs to all pairs.
    pub pair: [String; 3],
    /// The name of the array.
    pub array: String,
    /// One exponent for the whole array, or one for each o of a material; empty for floats.
    pub exponents: Vec<i32>,
    /// The numbers.
    pub numbers: Vec<String>,
}

impl Row {
    /// A row with these numbers.
    pub fn new<T: Display>(
        format: &str,
        pair: [&str; 3],
        array: &str,
        exponents: &[i32],
        numbers: &[T],
    ) -> Self {
        Self {
            format: format.into(),
            pair: pair.map(Into::into),
            array: array.into(),
            exponents: exponents.into(),
            numbers: numbers.iter().map(ToString::to_string).collect(),
        }
    }

    /// The numbers as integers.
    ///
    /// # Errors
    ///
    /// If one is not an integer.
    pub fn integers(&self) -> Result<Vec<i32>, String> {
        self.parsed()
    }

    /// The numbers as floats.
    ///
    /// # Errors
    ///
    /// If one is not a float.
    pub fn floats(&self) -> Result<Vec<f32>, String> {
        self.parsed()
    }

    fn parsed<T: std::str::FromStr>(&self) -> Result<Vec<T>, String> {
        let one = |text: &String| {
            let fault = || format!("`{text}` in {} {} is no such number", self.format, self.array);
            text.parse().map_err(|_| fault())
        };
        self.numbers.iter().map(one).collect()
    }
}

/// The whole file.
#[derive(Clone, Debug, PartialEq)]
pub struct Golden {
    /// Its rows.
    pub rows: Vec<Row>,
}

impl Golden {
    /// Parses the text of a file.
    ///
    /// # Errors
    ///
    /// If a line is not a row; the message has its line number.
    pub fn parse(text: &str) -> Result<Self, String> {
        let lines = text.lines().enumerate().filter(|(_, line)| !line.starts_with('#'));
        let mut rows = Vec::new();
        for (number, line) in lines.filter(|(_, line)| *line != HEADER) {
            let fault = || format!("line {}: it is no row `{HEADER}`", number + 1);
            let fields: Vec<&str> = line.split(',').collect();
            let &[format, light, material, channel, array, exponents, numbers] = &fields[..] else {
                return Err(fault());
            };
            let exponents = exponents.split_whitespace().map(str::parse).collect::<Result<_, _>>();
            rows.push(Row {
                exponents: exponents.map_err(|_| fault())?,
                numbers: numbers.split_whitespace().map(Into::into).collect(),
                ..Row::new::<i32>(format, [light, material, channel], array, &[], &[])
            });
        }
        Ok(Self { rows })
    }

    /// The text of the file, which starts with the lines `head` as comments.
    pub fn text(&self, head: &[&str]) -> String {
        let mut text: String = head.iter().map(|line| format!("# {line}\n")).collect();
        text += &format!("{HEADER}\n");
        for Row { format, pair, array, exponents, numbers } in &self.rows {
            let exponents: Vec<String> = exponents.iter().map(ToString::to_string).collect();
            let (pair, exponents, numbers) =
                (pair.join(","), exponents.join(" "), numbers.join(" "));
            text += &format!("{format},{pair},{array},{exponents},{numbers}\n");
        }
        text
    }

    /// An array of a pair, or an array that belongs to all pairs.
    ///
    /// # Errors
    ///
    /// If the file does not have the array.
    pub fn find(&self, format: &str, pair: [&str; 3], array: &str) -> Result<&Row, String> {
        let found = |row: &&Row| row.format == format && row.pair == pair && row.array == array;
        let fault = || format!("no row {format},{},{array}", pair.join(","));
        self.rows.iter().find(found).ok_or_else(fault)
    }

    /// The pairs of light, material and channel, in file order.
    pub fn pairs(&self) -> Vec<[&str; 3]> {
        let mut pairs: Vec<[&str; 3]> = Vec::new();
        for row in self.rows.iter().filter(|row| row.array == "light") {
            let pair = [&row.pair[0][..], &row.pair[1], &row.pair[2]];
            if !pairs.contains(&pair) {
                pairs.push(pair);
            }
        }
        pairs
    }
}
