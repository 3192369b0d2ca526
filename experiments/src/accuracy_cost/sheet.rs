//! The CSV files. A row is a [`Record`] from its measurement to the charts.

use crate::figures::{Figures, OutputFile};
use crate::sheet::{Form, Record};
use eigenshade_model::error::Result;

/// The files of the command.
pub const FIGURES: Figures = Figures { command: "accuracy-cost", folder: "", is_exact: true };

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

/// The file of these records.
pub fn csv(form: &Form, records: &[Record]) -> Result<OutputFile> {
    let rows = records.iter().map(|record| form.columns.split(',').map(|one| record.text(one)));
    FIGURES.csv(form.name, form.columns, rows)
}
