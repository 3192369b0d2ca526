//! The normal of each pixel of an image.

use crate::picture::sphere_view::SphereView;
use eigenshade_generator::object::normal_map;
use eigenshade_generator::picture::png_samples;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::read_normals;
use std::path::Path;

/// Bytes per optional normal.
const BYTES_PER_NORMAL: u64 = size_of::<Option<[f64; 3]>>() as u64;

/// Reads the unit normal, z >= 0, of each pixel of an image of this size; `None` where there is no
/// object.
///
/// `source` is one of three: the word `sphere`, for a centered sphere that fills the image as in
/// [`SphereView`]; a PNG of the image's size, read as a [`normal_map`]; or a CSV `x,y,z` with a row
/// for each pixel, row by row. `counts` states for each pixel whether it is used; in a normal map,
/// unused pixels may face away.
///
/// # Errors
///
/// If `sphere` is given for an image without a size, the file has another size than the image, or
/// the file cannot be read.
pub fn read(
    source: impl Into<InputFile>,
    size: Option<[usize; 2]>,
    counts: &[bool],
) -> Result<Vec<Option<[f64; 3]>>> {
    let file = source.into();
    let source = file.path();
    if source == Path::new("sphere") {
        return size.map(sphere).ok_or_else(|| {
            Error::new(
                "a list of pixels shows no sphere",
                "give --normals a CSV with a row for each of them",
            )
        });
    }
    let is_png = source.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let normals = if is_png {
        of_png(&file, size, counts)?
    } else {
        read_normals(file.clone())?.into_iter().map(Some).collect()
    };
    if normals.len() != counts.len() {
        return Err(Error::new(
            format!("it holds {} normals, the image {} pixels", normals.len(), counts.len()),
            "give one normal for each pixel, row by row from the top",
        )
        .in_file(source));
    }
    Ok(normals)
}

fn sphere([width, height]: [usize; 2]) -> Vec<Option<[f64; 3]>> {
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

fn of_png(
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
