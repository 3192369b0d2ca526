//! The pixels that show an object, and the points of its surface in each.

use eigenshade_generator::object::points::{Point, points};
use eigenshade_generator::object::surface::Surface;
use eigenshade_model::error::{Error, Result};

/// Samples along each side of a pixel: those that are shaded, and those that its coverage counts.
const SHADED: usize = 2;
const COUNTED: usize = 4;

/// The largest picture, in pixels across.
pub(crate) const MOST_SIDE: usize = 512;

/// The pixels of a square picture that show an object, row by row from the top.
pub struct Pixels {
    /// The column and row of each pixel, and its coverage of 255.
    pub covered: Vec<([usize; 2], u8)>,
    /// Up to four points of each.
    points: Vec<Vec<Point>>,
}

impl Pixels {
    /// The pixels of a surface in a picture with a margin of half a pixel, seen from +z. Each has 2 x 2
    /// points, and its coverage is counted in 4 x 4.
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
        let mut shaded = self::points(surface, size, SHADED);
        if shaded.is_empty() {
            let remedy = "turn it with --view or --rotate-object, or draw it larger";
            return Err(Error::new("nothing of it is seen", remedy));
        }
        shaded.sort_by_key(|point| (point.pixel[1], point.pixel[0]));
        let points: Vec<Vec<Point>> =
            shaded.chunk_by(|a, b| a.pixel == b.pixel).map(<[Point]>::to_vec).collect();
        let mut counts = vec![0; size * size];
        let counted = self::points(surface, size, COUNTED);
        counted.iter().for_each(|point| counts[point.pixel[1] * size + point.pixel[0]] += 1);
        let coverage = |points: &Vec<Point>| {
            let [column, row] = points[0].pixel;
            ([column, row], (255 * counts[row * size + column] / COUNTED.pow(2)) as u8)
        };
        Ok(Self { covered: points.iter().map(coverage).collect(), points })
    }

    /// Up to four points of each pixel.
    #[must_use]
    pub fn points(&self) -> Vec<&[Point]> {
        self.points.iter().map(Vec::as_slice).collect()
    }
}
