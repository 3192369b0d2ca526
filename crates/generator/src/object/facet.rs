//! A facet of a mesh: its normal, and its area as projected to the camera.

/// A triangle with nonzero area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Corners, counterclockwise as seen from outside; x right, y up, z toward the camera.
    pub corners: [[f64; 3]; 3],
    /// The unit normal, outward.
    pub normal: [f64; 3],
    /// The area of the orthographic projection along z, in the square of the corners' unit, with
    /// the sign of the normal's z.
    pub projected_area: f64,
}

impl Facet {
    /// `None` if the corners are on a line or at a point, up to rounding.
    ///
    /// Edges are scaled by the largest component first, so that small facets keep their direction.
    #[must_use]
    pub fn new(corners: [[f64; 3]; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let edge = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let (u, v) = (edge(b), edge(c));
        let scale = u.iter().chain(&v).fold(0.0, |most: f64, value| most.max(value.abs()));
        let ([u0, u1, u2], [v0, v1, v2]) = (u.map(|x| x / scale), v.map(|x| x / scale));
        let cross = [u1 * v2 - u2 * v1, u2 * v0 - u0 * v2, u0 * v1 - u1 * v0];
        let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
        // Below the rounding of the products the direction is meaningless; it is NaN if all edges
        // are 0.
        (length > 4.0 * f64::EPSILON).then(|| Self {
            corners,
            normal: cross.map(|x| x / length),
            projected_area: 0.5 * cross[2] * scale * scale,
        })
    }
}
