//! The CSV files, in which a row is a [`Record`] from its measurement to the charts, and their
//! comparison with fresh errors, bytes and counts, but not times or what depends on them.

use crate::figures::{self, OutputFile};
use crate::sheet::{Form, Record, read};
use eigenshade_model::error::{Error, Result};
use std::path::Path;

/// The settings: errors of the method (`unseen_` over materials that the basis never saw), the
/// error of the model, the total error over all its pictures, bytes, times, and costs on each
/// machine.
pub const SETTINGS: Form = Form {
    name: "accuracy-cost.csv",
    columns: "parameter,setting,degree,order,components,effects,way,format,sources,terms,\
              rms_median,rms_worst,rms_median_db,rms_worst_db,\
              largest_median,largest_worst,largest_median_db,largest_worst_db,\
              unseen_rms_median,unseen_rms_most,unseen_rms_worst,\
              unseen_largest_median,unseen_largest_most,unseen_largest_worst,\
              model_median,model_worst,total_mean_median,total_mean_most,\
              total_p95_median,total_p95_most,total_below_mean_median,total_below_mean_most,\
              total_below_p95_median,total_below_p95_most,total_white_median,total_white_most,\
              table_bytes,state_bytes,\
              host_pixel_ns,host_light_ns,host_pixel,host_light,\
              m0_pixel,m0_light,m0_flash,m0_ram,m4f_pixel,m4f_light,m4f_flash,m4f_ram",
    keys: &["setting"],
};
/// The errors of the model by map.
pub const MODEL: Form = Form {
    name: "model.csv",
    columns: "surface,degree,order,median,worst,esplanade,hall,park,sky,studio,venice",
    keys: &["surface", "degree", "order"],
};
/// The total error by kind of material, of the settings, the shipped tables and their rivals.
pub const TOTAL: Form = Form {
    name: "total.csv",
    columns: "setting,sources,kind,pictures,close,mean_median,mean_most,p95_median,p95_most,\
              below_mean_median,below_mean_most,below_p95_median,below_p95_most,\
              white_median,white_most,f32_bytes,q15_bytes",
    keys: &["setting", "sources", "kind"],
};
pub fn csv(form: &Form, records: &[Record]) -> Result<OutputFile> {
    let rows = records.iter().map(|record| form.columns.split(',').map(|one| record.text(one)));
    figures::csv("accuracy-cost --out docs/accuracy-cost", form.name, form.columns, rows)
}

/// The allowed relative difference of an error: hosts round differently, and rounding may end a
/// polynomial a term earlier or later.
const ERROR: f64 = 0.02;
/// The always allowed difference of CIEDE2000: pixels of 8 bits change by a step.
const STEP: f64 = 0.02;
/// The always allowed difference of another error: f32 rounding, which a fused multiplication
/// halves.
const ROUNDING: f64 = 1e-6;
/// The allowed relative difference of bytes: one such term in all profiles of an azimuth.
const BYTES: f64 = 0.02;

/// The allowed relative and absolute difference of a column's numbers.
fn tolerance(column: &str) -> [f64; 2] {
    let ends = |ends: &[&str]| ends.iter().any(|end| column.ends_with(end));
    if column == "close" {
        [0.0, STEP]
    } else if ["mean", "p95"].iter().any(|measure| column.contains(measure)) {
        [ERROR, STEP]
    } else if ends(&["median", "most", "worst"]) {
        [ERROR, ROUNDING]
    } else if column.ends_with("_bytes") {
        [BYTES, 0.0]
    } else if column == "terms" {
        [BYTES, 2.0]
    } else {
        [0.0, 0.0]
    }
}

/// Whether a column is not compared: times, and decibels, which repeat the errors.
fn is_time(column: &str) -> bool {
    column.starts_with("host_") || column.ends_with("_db")
}

/// What to do where a file differs.
const REMEDY: &str = "make it again with `cargo run --release -p report -- accuracy-cost --out \
                      docs/accuracy-cost --keep-times`";

/// Compares these records with those of the file in `folder`. With `whole`, the file must not have
/// other rows; otherwise fields that the records lack are skipped. Returns the numbers of rows and of
/// numbers compared. The error is the first difference, with its file and line.
pub fn compare(form: &Form, fresh: &[Record], folder: &Path, whole: bool) -> Result<[usize; 2]> {
    let path = folder.join(form.name);
    let recorded = read(form, folder)?;
    let fault = |what: String| Error::new(what, REMEDY);
    let (rows, mut numbers) = (fresh.len(), 0);
    for record in fresh {
        let (key, name) = (record.key(form), record.key(form).join(", "));
        let missing = || fault(format!("it has no row of `{name}`")).in_file(&path);
        let other = recorded.iter().find(|other| other.key(form) == key).ok_or_else(missing)?;
        for column in form.columns.split(',').filter(|column| !is_time(column)) {
            let ([new, old], [relative, least]) =
                ([record, other].map(|record| record.text(column)), tolerance(column));
            let is_near = match number(new).zip(number(old)) {
                Some((new, old)) => {
                    numbers += 1;
                    (new - old).abs() <= (relative * new.abs().max(old.abs())).max(least)
                }
                // A quick run lacks the error of the model.
                None => new == old || new.is_empty() && relative > 0.0 && !whole,
            };
            if !is_near {
                let what = format!("`{name}`: {column} is {old} where {new} belongs");
                return Err(fault(what).at_line(&path, other.line));
            }
        }
    }
    let there = recorded.len();
    if whole && there != rows {
        return Err(fault(format!("it has {there} rows where {rows} belong")).in_file(path));
    }
    Ok([rows, numbers])
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite())
}
