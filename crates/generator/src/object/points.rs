//! The points of a surface that the samples of a picture show.

use crate::object::facet::Plane;
use crate::object::picture::{frame, in_front, toward_camera};
use crate::object::surface::Surface;

/// A point that the camera at +z sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The pixel that shows it: column, from the left, and row, from the top.
    pub pixel: [usize; 2],
    /// In the unit of the surface.
    pub position: [f64; 3],
    /// The unit normal, z >= 0.
    pub normal: [f64; 3],
    /// The facet's own unit normal, z > 0.
    pub facet: [f64; 3],
}

/// The points that the camera sees in the samples of a picture of `size` x `size` pixels with a margin
/// of half a pixel around the longer side of the surface; `across` samples along a pixel.
#[must_use]
pub fn points(surface: &Surface, size: usize, across: usize) -> Vec<Point> {
    let samples = across * size;
    let frame = frame(&surface.facets, size, samples);
    let mut points = Vec::new();
    for (place, number) in in_front(&surface.facets, &frame, samples).into_iter().enumerate() {
        let Some(facet) = surface.facets.get(number as usize) else { continue };
        let (row, column) = (place / samples, place % samples);
        let plane = Plane::new(&frame.place(facet));
        let weights = plane.weights(column as f64 + 0.5, row as f64 + 0.5);
        let weights = weights.unwrap_or([1.0 / 3.0; 3]);
        let normal = surface.normal(number as usize, weights);
        let position = [0, 1, 2].map(|axis: usize| {
            (0..3).map(|corner| weights[corner] * facet.corners[corner][axis]).sum()
        });
        points.push(Point {
            // Samples run upward.
            pixel: [column / across, size - 1 - row / across],
            position,
            normal: toward_camera(normal).unwrap_or(facet.normal),
            facet: facet.normal,
        });
    }
    points
}
