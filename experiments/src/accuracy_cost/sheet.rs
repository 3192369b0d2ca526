//! The CSV files: every point, and every surface of the model.

use super::COMMAND;
use super::growth::Growth;
use super::machine::Machine;
use super::method::Spread;
use super::model::{MAPS, Row};
use super::points::Point;
use eigenshade_cli::output::Rows;
use eigenshade_cli::output::exact;
use eigenshade_cli::table;
use eigenshade_model::error::Result;

/// The file of all points.
pub const POINTS: &str = "accuracy-cost.csv";
/// The file of the model's errors.
pub const MODEL: &str = "model.csv";
/// The file of the growth curves.
pub const GROWTH: &str = "growth.csv";
/// Significant digits of errors and costs.
const DIGITS: usize = 4;

/// Formats a number with few significant digits.
#[must_use]
pub fn digits(value: f64) -> String {
    exact(format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value))
}

/// Formats an error relative to the peak in decibels.
#[must_use]
pub fn decibels(error: f64) -> String {
    format!("{:.1}", -20.0 * error.log10())
}

/// The columns of [`POINTS`].
#[must_use]
pub fn columns() -> Vec<String> {
    let mut columns: Vec<String> = [
        "knob",
        "setting",
        "degree",
        "order",
        "components",
        "modes",
        "effects",
        "azimuths",
        "way",
        "format",
        "terms",
        "rms_median",
        "rms_worst",
        "rms_median_db",
        "rms_worst_db",
        "largest_median",
        "largest_worst",
        "largest_median_db",
        "largest_worst_db",
        "unseen_rms_median",
        "unseen_rms_most",
        "unseen_rms_worst",
        "unseen_largest_median",
        "unseen_largest_most",
        "unseen_largest_worst",
        "model_median",
        "model_worst",
        "table_bytes",
        "state_bytes",
        "host_pixel_ns",
        "host_light_ns",
    ]
    .map(str::to_owned)
    .to_vec();
    for machine in Machine::ALL {
        let key = machine.key();
        columns.extend([format!("{key}_pixel"), format!("{key}_light")]);
        if machine.counts() {
            columns.extend([format!("{key}_flash"), format!("{key}_ram")]);
        }
    }
    columns
}

/// All points as CSV.
///
/// # Errors
///
/// Never in practice: the rows are as long as the header.
pub fn points(points: &[Point]) -> Result<String> {
    text(&columns(), points.iter().map(fields))
}

fn fields(point: &Point) -> Vec<String> {
    let setting = &point.setting;
    let optional = |value: Option<usize>| value.map_or(String::new(), |value| value.to_string());
    let number = |value: Option<f64>| value.map_or(String::new(), digits);
    let spread = |spread: &Spread| [digits(spread.median), digits(spread.worst)];
    let (seen, unseen) = (&point.method.seen, &point.method.unseen);
    let mut fields = vec![
        point.knob.to_owned(),
        setting.to_string(),
        setting.recipe.degree.to_string(),
        setting.recipe.order.to_string(),
        optional(setting.recipe.components),
        optional(setting.recipe.modes),
        table::effect_names(setting.recipe.effects),
        optional(setting.recipe.azimuths),
        setting.way.to_string(),
        setting.format.to_string(),
        point.method.terms.to_string(),
    ];
    for errors in [&seen.rms, &seen.largest] {
        fields.extend(spread(errors));
        fields.extend([decibels(errors.median), decibels(errors.worst)]);
    }
    for errors in [&unseen.rms, &unseen.largest] {
        fields.extend([errors.median, errors.most, errors.worst].map(digits));
    }
    fields.extend([
        number(point.model.map(|one| one.median)),
        number(point.model.map(|one| one.worst)),
    ]);
    fields.extend([point.bytes.table.to_string(), point.bytes.state.to_string()]);
    fields
        .extend([number(point.cost.map(|one| one.pixel)), number(point.cost.map(|one| one.light))]);
    for machine in Machine::ALL {
        let price = point.prices.get(&machine).copied().unwrap_or_default();
        fields.extend([number(price.pixel), number(price.light)]);
        if machine.counts() {
            fields.extend([optional(price.flash), optional(price.ram)]);
        }
    }
    fields
}

/// The columns of [`MODEL`].
#[must_use]
pub fn model_columns() -> Vec<String> {
    let names = ["surface", "degree", "order", "median", "worst"].map(str::to_owned);
    names.into_iter().chain(MAPS.map(str::to_owned)).collect()
}

/// The model's errors as CSV.
///
/// # Errors
///
/// Never in practice.
pub fn model(rows: &[Row]) -> Result<String> {
    let row = |row: &Row| {
        let spread = Spread::of(&row.errors);
        let mut fields = vec![row.surface.clone(), row.degree.to_string(), row.order.to_string()];
        fields.extend([spread.median, spread.worst].map(digits));
        fields.extend(row.errors.iter().map(|&error| digits(error)));
        fields
    };
    text(&model_columns(), rows.iter().map(row))
}

/// The growth curves as CSV, with separate columns for counts and nanoseconds.
///
/// # Errors
///
/// Never in practice.
pub fn growth(growths: &[Growth]) -> Result<String> {
    let columns = ["quantity", "measure", "unit", "size", "counted", "host_ns"].map(str::to_owned);
    let rows = growths.iter().flat_map(|growth| {
        growth.points.iter().map(|&(size, value)| {
            let is_time = growth.unit == "ns";
            let names = [growth.quantity, growth.measure, growth.unit].map(str::to_owned);
            let [counted, time] = match is_time {
                true => [String::new(), digits(value)],
                false => [value.to_string(), String::new()],
            };
            names.into_iter().chain([size.to_string(), counted, time]).collect()
        })
    });
    text(&columns, rows)
}

/// CSV below a line that names the command.
///
/// # Errors
///
/// Never in practice: the rows are as long as the header.
pub fn text(columns: &[String], rows: impl Iterator<Item = Vec<String>>) -> Result<String> {
    let mut bytes = format!("# {COMMAND}\n").into_bytes();
    let mut sheet = Rows::new(&mut bytes, columns)?;
    for row in rows {
        sheet.row(row)?;
    }
    sheet.finish()?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
