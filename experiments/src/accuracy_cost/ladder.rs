//! The tables for which programs of `firmware/` count a pixel and a new light, as recipes from
//! `firmware/tables/ladder.csv`. Those programs are built from the same file.

use super::knobs::{DEGREE, ORDER};
use super::setting::{Cut, Recipe};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::{Row, Sheet};
use std::path::Path;

/// The list.
const LADDER: &str = include_str!("../../../firmware/tables/ladder.csv");
const COLUMNS: [&str; 3] = ["name", "components", "trim"];

/// A counted table.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// The name of its rows in `firmware/counts.csv`, before `/`.
    pub name: String,
    /// The recipe of its table.
    pub recipe: Recipe,
}

/// All counted tables.
///
/// # Errors
///
/// Never in practice: the list is compiled in.
pub fn rungs() -> Result<Vec<Rung>> {
    let path = Path::new("firmware/tables/ladder.csv");
    let header = COLUMNS.join(",");
    let sheet = Sheet::parse(LADDER.as_bytes().to_vec(), path, &header)?;
    let columns = sheet.columns(COLUMNS).ok_or_else(|| sheet.wrong_header(&header))?;
    let rung = |row: Row<'_>| {
        let [name, components, trim] = columns;
        let text = row.text(components);
        let fault = |_| row.fault(format!("`{text}` is no count"), "give a number of components");
        let cut = match row.text(trim) {
            "" => Cut::Whole,
            _ => Cut::Trimmed(row.number(trim)?),
        };
        let recipe = Recipe::first(DEGREE, ORDER, text.parse().map_err(fault)?).cut(cut);
        Ok(Rung { name: row.text(name).to_owned(), recipe })
    };
    sheet.rows().map(rung).collect()
}
