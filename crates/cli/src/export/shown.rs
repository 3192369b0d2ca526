//! Normals of an export, and the pixels that they have in a picture.

use super::array::Array;
use crate::object::{ObjectOptions, ObjectView};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::read_normals;
use eigenshade_shading::picture::Pixel;

/// Pixels across a sphere and a mesh, unless the caller asks for another number.
const SIZE: usize = 64;

/// The normals at which eigenimages or pictures are exported.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// Unit normals with z >= 0.
    pub normals: Vec<[f64; 3]>,
    /// Their pixels, if they are those of a picture.
    pixels: Vec<Pixel>,
}

impl Shown {
    /// The normals of a CSV `x,y,z`, or of the object that [`ObjectView::read`] reads, in `size`
    /// pixels across; by default 64, and all of a normal map. Fails as reading the file does, and
    /// for a CSV with a size.
    pub fn read(file: InputFile, size: Option<usize>, flip_green: bool) -> Result<Self> {
        let extension = file.extension();
        if extension == "csv" && !flip_green {
            if size.is_some() {
                let what = "a list of normals has no pixels to count";
                return Err(Error::new(what, "leave --size out").in_file(file.path()));
            }
            let normals = read_normals(file)?;
            return Ok(Self { normals, pixels: Vec::new() });
        }
        let size = size.or((extension != "png").then_some(SIZE));
        let options = ObjectOptions { size, flip_green, ..ObjectOptions::default() };
        let ObjectView { normals, pixels, .. } = ObjectView::read(file, options)?;
        Ok(Self { normals, pixels })
    }

    /// The normals, and their pixels if they have any.
    #[must_use]
    pub fn arrays(&self) -> Vec<Array> {
        let count = self.normals.len();
        let mut arrays =
            vec![Array::new("normals", [count, 3], self.normals.as_flattened().to_vec())];
        if !self.pixels.is_empty() {
            let places = self.pixels.iter().flat_map(|one| [one.row as i64, one.column as i64]);
            arrays.push(Array::new("pixels", [count, 2], places.collect::<Vec<_>>()));
            arrays.push(Array::new(
                "coverage",
                [count],
                self.pixels.iter().map(|one| one.coverage).collect::<Vec<_>>(),
            ));
        }
        arrays
    }
}
