//! The CSV files. A row is a [`Record`] from its measurement to the charts.

use eigenshade_cli::output::Rows;
use eigenshade_cli::output::exact;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::Sheet;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::Path;

/// The first line of each file, after its comment sign.
pub const COMMAND: &str = "experiments accuracy-cost";
/// Significant digits of errors and costs.
const DIGITS: usize = 4;

/// The form of a CSV file.
pub struct Form {
    /// The file's name.
    pub name: &'static str,
    /// Its columns.
    pub columns: &'static str,
    /// The columns that identify a row.
    pub keys: &'static [&'static str],
}

/// The settings: errors of the method (`unseen_` over materials that the basis never saw), the
/// error of the model, bytes, times, and costs on each machine.
pub const SETTINGS: Form = Form {
    name: "accuracy-cost.csv",
    columns: "knob,setting,degree,order,components,modes,effects,azimuths,way,format,terms,\
              rms_median,rms_worst,rms_median_db,rms_worst_db,\
              largest_median,largest_worst,largest_median_db,largest_worst_db,\
              unseen_rms_median,unseen_rms_most,unseen_rms_worst,\
              unseen_largest_median,unseen_largest_most,unseen_largest_worst,\
              model_median,model_worst,table_bytes,state_bytes,\
              host_pixel_ns,host_light_ns,host_pixel,host_light,\
              m0_pixel,m0_light,m0_flash,m0_ram,m3_pixel,m3_light,m3_flash,m3_ram,\
              m4f_pixel,m4f_light,m4f_flash,m4f_ram,rv32_pixel,rv32_light,rv32_flash,rv32_ram,\
              wasm_pixel,wasm_light",
    keys: &["setting"],
};
/// The errors of the model by map.
pub const MODEL: Form = Form {
    name: "model.csv",
    columns: "surface,degree,order,median,worst,esplanade,hall,park,sky,studio,venice",
    keys: &["surface", "degree", "order"],
};
/// The growth curves, with separate columns for counts and nanoseconds.
pub const GROWTH: Form = Form {
    name: "growth.csv",
    columns: "quantity,measure,unit,size,counted,host_ns",
    keys: &["quantity", "measure", "unit", "size"],
};

/// A row: texts by column. Columns without a text are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record(BTreeMap<String, String>);

impl Record {
    /// The text in a column.
    pub fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", String::as_str)
    }

    /// The number in a column, if it has one.
    pub fn number(&self, column: &str) -> Option<f64> {
        self.text(column).parse().ok()
    }

    /// The texts that identify the row.
    pub fn key(&self, form: &Form) -> Vec<&str> {
        form.keys.iter().map(|column| self.text(column)).collect()
    }

    /// Fills in a text or an exact number.
    pub fn put(&mut self, column: impl Into<String>, value: impl Display) {
        self.0.insert(column.into(), value.to_string());
    }

    /// Fills in an error or a cost with few digits, if there is one.
    pub fn measure(&mut self, column: impl Into<String>, value: impl Into<Option<f64>>) {
        if let Some(value) = value.into() {
            self.put(column, digits(value));
        }
    }
}

/// Formats a number with few significant digits.
fn digits(value: f64) -> String {
    exact(format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value))
}

/// The records as CSV, below a line that names the command.
pub fn csv(form: &Form, records: &[Record]) -> Result<String> {
    let mut bytes = format!("# {COMMAND}\n").into_bytes();
    let mut rows = Rows::new(&mut bytes, form.columns.split(','))?;
    for record in records {
        rows.row(form.columns.split(',').map(|column| record.text(column)))?;
    }
    rows.finish()?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The records of a file.
///
/// # Errors
///
/// If the file cannot be read, or lacks a column.
pub fn read(form: &Form, folder: &Path) -> Result<Vec<Record>> {
    let sheet = open(form, folder)?;
    let records = sheet.rows().map(|row| {
        let fields = sheet.header().zip(row.texts());
        Record(fields.map(|(column, text)| (column.to_owned(), text.to_owned())).collect())
    });
    Ok(records.collect())
}

/// The file in this folder, with all columns.
///
/// # Errors
///
/// See [`read`].
pub fn open(form: &Form, folder: &Path) -> Result<Sheet> {
    let sheet = Sheet::read(folder.join(form.name), form.columns)?;
    if form.columns.split(',').any(|column| sheet.column(column).is_none()) {
        return Err(sheet.wrong_header(form.columns));
    }
    Ok(sheet)
}
