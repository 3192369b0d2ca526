//! The normal of each pixel of an image.

use crate::sphere_view::SphereView;
use eigenshade_generator::error::{Error, Result};
use eigenshade_generator::inputs::normals::{read_normals, visible};
use eigenshade_generator::inputs::{normal_map, png_samples};
use std::path::Path;

/// A normal map's vector below this length is background: real ones have length 1,
/// up to rounding and filtering.
const SHORTEST: f64 = 0.5;

/// Reads the unit normal, z >= 0, of each pixel of an image of this size (`count`
/// pixels); none where there is no object.
///
/// `source` is the word `sphere`, a sphere whose disc the image encloses as
/// [`SphereView`] has it, centred; or a PNG of the image's size with
/// (n + 1)/2 in r, g and b; or a CSV `x,y,z` with a row for each pixel, row by row.
/// In a PNG what is transparent, shorter than 1/2 or turned away is background.
///
/// # Errors
///
/// `sphere` for an image without size, a file of another size than the image, and the
/// faults of the file.
pub fn read(
    source: &Path,
    size: Option<[usize; 2]>,
    count: usize,
) -> Result<Vec<Option<[f64; 3]>>> {
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
        of_png(source, size)?
    } else {
        read_normals(source)?.into_iter().map(Some).collect()
    };
    if normals.len() != count {
        return Err(Error::new(
            format!("it holds {} normals, the image {count} pixels", normals.len()),
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

fn of_png(path: &Path, size: Option<[usize; 2]>) -> Result<Vec<Option<[f64; 3]>>> {
    let png = png_samples::read(path)?;
    if let Some([width, height]) = size
        && (width, height) != (png.width, png.height)
    {
        return Err(Error::new(
            format!("it is {} x {} pixels, the image {width} x {height}", png.width, png.height),
            "give a normal map of the image's size",
        )
        .in_file(path));
    }
    let normal = |(colour, opacity): (&[u16; 3], &u16)| {
        let vector = normal_map::vector(*colour, png.full);
        let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
        let is_there = *opacity > 0 && length >= SHORTEST;
        is_there.then(|| visible(vector).ok()).flatten()
    };
    Ok(png.colours.iter().zip(&png.opacities).map(normal).collect())
}
