//! The normal and the weight of each pixel of an image.

use crate::picture::SphereView;
use eigenshade_generator::object::normal_map;
use eigenshade_generator::png_samples;
use eigenshade_model::database::luminance;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::read_normals;
use eigenshade_model::inputs::sheet::{Row, Sheet};
use std::path::Path;

/// Bytes per optional normal.
const BYTES_PER_NORMAL: u64 = size_of::<Option<[f64; 3]>>() as u64;

/// The largest weight: its square times any number of pixels is finite.
const LARGEST: f64 = 1e100;

/// Bytes per weight.
const BYTES_PER_WEIGHT: u64 = size_of::<f64>() as u64;

/// Reads the unit normal, z >= 0, of each pixel of an image of this size; `None` where there is no
/// object.
///
/// `source` is one of three: the name `sphere`, for a centered sphere that fills the image as in
/// [`SphereView`]; a PNG of the image's size, read as a [`normal_map`]; or a CSV `x,y,z` with a row
/// for each pixel, row by row. `counts` states for each pixel whether it is used; in a normal map,
/// unused pixels may face away.
///
/// # Errors
///
/// If `sphere` is given for an image without a size, the file has another size than the image, or
/// the file cannot be read.
pub fn normals(
    source: impl Into<InputFile>,
    size: Option<[usize; 2]>,
    counts: &[bool],
) -> Result<Vec<Option<[f64; 3]>>> {
    let file = source.into();
    let source = file.path();
    if source == Path::new("sphere") {
        return size.map(normals_of_sphere).ok_or_else(|| {
            Error::new(
                "a list of pixels shows no sphere",
                "give --normals a CSV with a row for each of them",
            )
        });
    }
    let is_png = source.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let found = if is_png {
        normals_of_png(&file, size, counts)?
    } else {
        read_normals(file.clone())?.into_iter().map(Some).collect()
    };
    if found.len() != counts.len() {
        return Err(Error::new(
            format!("it holds {} normals, the image {} pixels", found.len(), counts.len()),
            "give one normal for each pixel, row by row from the top",
        )
        .in_file(source));
    }
    Ok(found)
}

fn normals_of_sphere([width, height]: [usize; 2]) -> Vec<Option<[f64; 3]>> {
    let side = width.min(height);
    let (left, top) = ((width - side) / 2, (height - side) / 2);
    let view = SphereView::new(side);
    let mut normals = vec![None; width * height];
    for (pixel, normal) in view.pixels.iter().zip(&view.normals) {
        if pixel.is_inside {
            normals[(top + pixel.row) * width + left + pixel.column] = Some(*normal);
        }
    }
    normals
}

fn normals_of_png(
    file: &InputFile,
    size: Option<[usize; 2]>,
    counts: &[bool],
) -> Result<Vec<Option<[f64; 3]>>> {
    let path = file.path();
    let png = png_samples::read(file.clone().with_bytes_beside(BYTES_PER_NORMAL))?;
    let (width, height) = (png.width, png.height);
    let what = match size {
        Some([w, h]) if [w, h] != [width, height] => format!("the image {w} x {h}"),
        None if counts.len() != width * height => format!("the image has {}", counts.len()),
        _ => return normal_map::normals(&png, counts).map_err(|error| error.in_file(path)),
    };
    let what = format!("it is {width} x {height} pixels, {what}");
    Err(Error::new(what, "give a normal map of the image's size").in_file(path))
}

/// Reads a weight for each pixel, either from a PNG of the image's size (luminance times opacity, 0
/// to 1) or from a CSV with the column `weight` (0 or more).
///
/// # Errors
///
/// If the file has another size than the image, a weight is negative, or the file cannot be read.
pub fn weights(
    file: impl Into<InputFile>,
    size: Option<[usize; 2]>,
    count: usize,
) -> Result<Vec<f64>> {
    let file = file.into();
    let path = file.path();
    let is_png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let found = if is_png { weights_of_png(&file, size)? } else { weights_of_csv(&file)? };
    if found.len() != count {
        return Err(Error::new(
            format!("it holds {} weights, the image {count} pixels", found.len()),
            "give one weight for each pixel, row by row from the top",
        )
        .in_file(path));
    }
    Ok(found)
}

fn weights_of_png(file: &InputFile, size: Option<[usize; 2]>) -> Result<Vec<f64>> {
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
        luminance(share) * f64::from(*opacity) / full
    };
    Ok(png.colors.iter().zip(&png.opacities).map(weight).collect())
}

fn weights_of_csv(file: &InputFile) -> Result<Vec<f64>> {
    let sheet = Sheet::read(file.clone(), "weight")?;
    let [column] = sheet.columns(["weight"]).ok_or_else(|| sheet.wrong_header("`weight`"))?;
    let weight = |row: Row<'_>| {
        let weight = row.number(column)?;
        if weight != 0.0 && !(1.0 / LARGEST..=LARGEST).contains(&weight) {
            let remedy = "give 0, or weights from 1e-100 to 1e100";
            return Err(row.fault(format!("the weight is {weight}"), remedy));
        }
        Ok(weight)
    };
    sheet.rows().map(weight).collect()
}
