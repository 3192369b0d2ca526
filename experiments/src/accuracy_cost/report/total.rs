//! The total errors of ways to a picture, and of their rivals.

use super::{MISSING, difference, instructions, percent};
use crate::accuracy_cost::Measured;
use crate::accuracy_cost::total::subjects::ALL;
use crate::accuracy_cost::total::{MATCAP, PREFILTERED};
use crate::pages;
use crate::sheet::{Counts, M4F, Record};

/// The ways to a picture whose total errors the page shows for all kinds of materials.
const SHOWN: [&str; 17] = [
    "2/0 all nine-terms f32",
    "2/2 all polynomial f32",
    "4/3 all polynomial f32",
    "6/5 all polynomial f32",
    "9/7 all polynomial f32",
    "9/7 all polynomial f32 sources1",
    "9/7 all polynomial f32 sources2",
    "9/7 all polynomial f32 sources4",
    "9/7 all polynomial f32 sources8",
    "12/12 K400 polynomial f32",
    "12/12 K400 polynomial f32 sources4",
    "12/12 K400 polynomial f32 sources8",
    "16/16 K400 polynomial f32",
    "sphere.bin f32",
    "sphere.bin q15",
    "color.bin f32",
    "pbr.bin f32",
];

/// The row of total errors of a way to a picture, for a kind of materials.
pub fn of_kind<'a>(rows: &'a [Record], setting: &str, kind: &str) -> Option<&'a Record> {
    rows.iter().find(|row| (row.text("setting"), row.text("kind")) == (setting, kind))
}

/// The total errors by kind of material.
pub fn table(measured: &Measured) -> String {
    let columns = "setting | glTF, median: | 95 of 100: | matte: | 95 of 100: | measured: | \
                   95 of 100: | all: | 95 of 100: | worst pixel: | 95 of 100: | color: | \
                   95 of 100:";
    let row = |setting: &str| {
        let mut fields = vec![format!("`{setting}`")];
        let mut add = |kind, error: &str, format: fn(f64) -> String| {
            for column in ["median", "most"] {
                let row = of_kind(&measured.total, setting, kind);
                let number = row.and_then(|row| row.number(&format!("{error}_{column}")));
                fields.push(number.map_or(MISSING.into(), format));
            }
        };
        ["gltf", "matte", "measured", ALL].into_iter().for_each(|kind| add(kind, "rms", percent));
        add(ALL, "pixel", percent);
        add(ALL, "difference", difference);
        fields
    };
    pages::table(columns, SHOWN.map(row))
}

/// The instructions of a pixel of a matcap on a Cortex-M4F. A baked map that is looked up by points
/// is the same look-up: its points are the matcap's normals.
pub fn matcap_pixel() -> Option<f64> {
    Counts::recorded().get(M4F, "baked_point", "instructions").map(|count| count as f64)
}

/// The instructions of a pixel of prefiltered maps on a Cortex-M4F.
pub fn prefiltered_pixel() -> Option<f64> {
    Counts::recorded().get(M4F, "prefiltered", "instructions").map(|count| count as f64)
}

/// The settings that the page compares with their rivals.
const COMPARED: [&str; 11] = [
    "2/0 all nine-terms f32",
    MATCAP,
    PREFILTERED,
    "9/7 K9 trim1e-1 polynomial f32",
    "9/7 K25 trim3e-2 polynomial f32",
    "9/7 K130 trim2e-4 polynomial f32",
    "9/7 K130 trim2e-4 polynomial f32 sources4",
    "9/7 all bilinear32 f32",
    "9/7 all bilinear32 f32 sources4",
    "12/12 K400 bilinear32 f32",
    "12/12 K400 bilinear32 f32 sources8",
];

/// The ways to draw glTF materials, with their costs.
pub fn rivals(measured: &Measured) -> String {
    let columns = "way | rms, median: | 95 of 100: | worst pixel: | 95 of 100: | color: | \
                   95 of 100: | a pixel, instructions:";
    let row = |setting: &str| {
        let mut fields = vec![format!("`{setting}`")];
        for (error, format) in
            [("rms", percent as fn(f64) -> String), ("pixel", percent), ("difference", difference)]
        {
            for column in ["median", "most"] {
                let row = of_kind(&measured.total, setting, "gltf");
                let number = row.and_then(|row| row.number(&format!("{error}_{column}")));
                fields.push(number.map_or(MISSING.into(), format));
            }
        }
        let is_it = |row: &&Record| row.text("setting") == setting;
        let pixel = match setting {
            MATCAP => matcap_pixel(),
            PREFILTERED => prefiltered_pixel(),
            _ => measured.settings.iter().find(is_it).and_then(|row| row.number("m4f_pixel")),
        };
        fields.push(pixel.map_or(MISSING.into(), instructions));
        fields
    };
    pages::table(columns, COMPARED.map(row))
}
