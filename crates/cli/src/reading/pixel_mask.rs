//! The weight of each pixel of an image.

use eigenshade_generator::picture::png_samples;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::Sheet;

/// The largest weight: its square times any number of pixels is finite.
const LARGEST: f64 = 1e100;

/// Bytes per weight.
const BYTES_PER_WEIGHT: u64 = size_of::<f64>() as u64;

/// Reads a weight for each pixel, either from a PNG of the image's size (luminance times opacity, 0
/// to 1) or from a CSV with the column `weight` (0 or more).
///
/// # Errors
///
/// If the file has another size than the image, a weight is negative, or the file cannot be read.
pub fn read(
    file: impl Into<InputFile>,
    size: Option<[usize; 2]>,
    count: usize,
) -> Result<Vec<f64>> {
    let file = file.into();
    let path = file.path();
    let is_png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let weights = if is_png { of_png(&file, size)? } else { of_csv(&file)? };
    if weights.len() != count {
        return Err(Error::new(
            format!("it holds {} weights, the image {count} pixels", weights.len()),
            "give one weight for each pixel, row by row from the top",
        )
        .in_file(path));
    }
    Ok(weights)
}

fn of_png(file: &InputFile, size: Option<[usize; 2]>) -> Result<Vec<f64>> {
    let png = png_samples::read(file.clone().with_bytes_beside(BYTES_PER_WEIGHT))?;
    if let Some([width, height]) = size
        && (width, height) != (png.width, png.height)
    {
        return Err(Error::new(
            format!("it is {} x {} pixels, the image {width} x {height}", png.width, png.height),
            "give a mask of the image's size",
        )
        .in_file(file.path()));
    }
    let full = f64::from(png.full);
    let weight = |(color, opacity): (&[u16; 3], &u16)| {
        let share = color.map(|sample| f64::from(sample) / full);
        eigenshade_model::database::luminance(share) * f64::from(*opacity) / full
    };
    Ok(png.colors.iter().zip(&png.opacities).map(weight).collect())
}

fn of_csv(file: &InputFile) -> Result<Vec<f64>> {
    let sheet = Sheet::read(file.clone(), "weight")?;
    let [column] = sheet.columns(["weight"]).ok_or_else(|| sheet.wrong_header("`weight`"))?;
    let weight = |row: eigenshade_model::inputs::sheet::Row<'_>| {
        let weight = row.number(column)?;
        if weight != 0.0 && !(1.0 / LARGEST..=LARGEST).contains(&weight) {
            let remedy = "give 0, or weights from 1e-100 to 1e100";
            return Err(row.fault(format!("the weight is {weight}"), remedy));
        }
        Ok(weight)
    };
    sheet.rows().map(weight).collect()
}
