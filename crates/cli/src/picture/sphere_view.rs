//! A sphere as the camera sees it: a disc of pixels and their normals.

/// The pixels of a square picture that the sphere covers at least in part.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereView {
    /// Width and height of the picture in pixels.
    pub size: usize,
    /// The pixels, row by row from the top.
    pub pixels: Vec<Pixel>,
    /// The unit normal of each pixel, with z >= 0. If the center of a pixel just misses the sphere,
    /// its normal lies on the rim.
    pub normals: Vec<[f64; 3]>,
}

/// One pixel of the disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Column, from the left.
    pub column: usize,
    /// Row, from the top.
    pub row: usize,
    /// The approximate share of the pixel that the sphere covers.
    pub coverage: f64,
    /// Whether the center of the pixel lies on the sphere.
    pub is_inside: bool,
}

impl SphereView {
    /// A sphere that fills a picture of `size` x `size` pixels up to a margin of half a pixel.
    #[must_use]
    pub fn new(size: usize) -> Self {
        let radius = 0.5 * size as f64 - 0.5;
        let mut view = Self { size, pixels: Vec::new(), normals: Vec::new() };
        let offset = |k: usize| k as f64 + 0.5 - 0.5 * size as f64;
        for row in 0..size {
            for column in 0..size {
                let (x, y) = (offset(column), -offset(row));
                let distance = x.hypot(y);
                let coverage = (radius - distance + 0.5).clamp(0.0, 1.0);
                if coverage > 0.0 {
                    let is_inside = distance < radius;
                    let scale = if is_inside { radius } else { distance }.recip();
                    let (x, y) = (scale * x, scale * y);
                    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
                    view.pixels.push(Pixel { column, row, coverage, is_inside });
                    view.normals.push([x, y, if is_inside { z } else { 0.0 }]);
                }
            }
        }
        view
    }
}
