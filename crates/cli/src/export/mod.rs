//! Lights, materials and tables for other programs, as source in Rust, C and JavaScript.

pub mod c;
pub mod entry;
pub mod highlights;
pub mod js;
pub mod rust;

use std::fmt::Display;

/// Columns of a line of source.
const COLUMNS: usize = 100;

/// The numbers with commas, in lines that begin with `indent` blanks.
fn lines<T: Display>(numbers: impl IntoIterator<Item = T>, indent: usize) -> String {
    let (mut text, mut column) = (String::new(), usize::MAX);
    for number in numbers {
        let number = format!("{number},");
        if column.saturating_add(1 + number.len()) > COLUMNS {
            if !text.is_empty() {
                text.push('\n');
            }
            text.push_str(&" ".repeat(indent));
            column = indent;
        } else {
            text.push(' ');
            column += 1;
        }
        column += number.len();
        text.push_str(&number);
    }
    text
}

/// A number in `f32` that reads back as the same bits, with a point or an exponent.
fn float(number: f32) -> String {
    format!("{number:?}")
}

/// The text for a comment between `/*` and `*/`.
fn comment(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *")
}
