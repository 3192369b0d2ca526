//! The pixels that show an object, and the points of its surface in each.

use eigenshade_generator::object::points::{Point, points};
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::error::{Error, Result};

/// Samples along each side of a pixel.
const SAMPLES: usize = 4;

/// The largest picture, in pixels across.
const MOST_SIDE: usize = 512;

/// The samples of a whole pixel whose points are kept: one in each row and in each column.
const KEPT: [usize; 4] = [1, 7, 8, 14];

/// The pixels of a square picture that show an object, row by row from the top.
pub struct Pixels {
    /// The column and row of each pixel, and its coverage of 255.
    pub covered: Vec<([usize; 2], u8)>,
    /// Up to four points of each.
    points: Vec<Vec<Point>>,
}

impl Pixels {
    /// The pixels of a surface in a picture with a margin of half a pixel, seen from +z in 4 x 4
    /// samples each.
    ///
    /// # Errors
    ///
    /// If the size is not 2 to 512, nothing is seen, or most of what is seen faces away.
    pub fn new(surface: &Surface, size: usize) -> Result<Self> {
        if !(2..=MOST_SIDE).contains(&size) {
            let what = format!("an object with shadows {size} pixels wide");
            return Err(Error::new(what, format!("use 2 to {MOST_SIDE}")));
        }
        surface.check_front()?;
        let mut points = points(surface, size, SAMPLES);
        if points.is_empty() {
            let remedy = "turn it with --view or --rotate-object, or draw it larger";
            return Err(Error::new("nothing of it is seen", remedy));
        }
        points.sort_by_key(|point| (point.pixel[1], point.pixel[0]));
        let (mut covered, mut kept) = (Vec::new(), Vec::new());
        for of_pixel in points.chunk_by(|a, b| a.pixel == b.pixel) {
            let count = of_pixel.len();
            covered.push((of_pixel[0].pixel, (255 * count / (SAMPLES * SAMPLES)) as u8));
            let mut places = KEPT.map(|place| place * count / (SAMPLES * SAMPLES)).to_vec();
            places.dedup();
            kept.push(places.into_iter().map(|place| of_pixel[place]).collect());
        }
        Ok(Self { covered, points: kept })
    }

    /// Up to four points of each pixel.
    #[must_use]
    pub fn points(&self) -> Vec<&[Point]> {
        self.points.iter().map(Vec::as_slice).collect()
    }
}
