//! A facet of a mesh: its normal, its area as projected to the camera, and the samples of a picture
//! that it covers.

use std::ops::Range;

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

/// How far in front of a facet's plane another surface may be without hiding it, relative to the
/// longest side of the mesh's box. Corners in f32 are no more precise.
pub const CONTACT: f64 = 1e-6;

/// A facet in units of samples: the sample in column i and row k is at i + 1/2, k + 1/2.
pub struct Placed {
    /// x and y in samples, z in the mesh's unit above its smallest z.
    corners: [[f64; 3]; 3],
    /// How far along z a surface in contact may be.
    pub(super) contact: f64,
}

/// A frame of `samples` x `samples` points over the box around the projection of the facets.
pub struct Frame {
    samples: usize,
    least: [f64; 3],
    sides: [f64; 3],
}

/// Places the facets in a frame of `samples` x `samples` points over the box around their
/// projection.
#[cfg(test)]
pub(super) fn placed(facets: &[Facet], samples: usize) -> Vec<Placed> {
    let frame = Frame::new(facets, samples);
    facets.iter().map(|facet| frame.place(facet)).collect()
}

impl Frame {
    pub(super) fn new(facets: &[Facet], samples: usize) -> Self {
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for corner in facets.iter().flat_map(|facet| &facet.corners) {
            for axis in 0..3 {
                least[axis] = least[axis].min(corner[axis]);
                most[axis] = most[axis].max(corner[axis]);
            }
        }
        Self { samples, least, sides: [0, 1, 2].map(|axis| most[axis] - least[axis]) }
    }

    /// The square around that box, with a margin of samples around its longer side.
    #[must_use]
    pub fn square(facets: &[Facet], samples: usize, margin: f64) -> Self {
        let mut frame = Self::new(facets, samples);
        let longer = frame.sides[0].max(frame.sides[1]);
        let side = longer * samples as f64 / (samples as f64 - 2.0 * margin);
        for axis in 0..2 {
            frame.least[axis] -= 0.5 * (side - frame.sides[axis]);
            frame.sides[axis] = side;
        }
        frame
    }

    /// Converts a facet to units of samples; rows run upward.
    #[must_use]
    pub fn place(&self, facet: &Facet) -> Placed {
        let [wide, tall, deep] = self.sides;
        let (longer, cosine) = (wide.max(tall), facet.normal[2].abs());
        let place = |corner: [f64; 3]| {
            let across = |axis: usize| {
                // In a box without width, no facet has a projected area.
                let side = if self.sides[axis] > 0.0 { self.sides[axis] } else { 1.0 };
                (corner[axis] - self.least[axis]) / side * self.samples as f64
            };
            [across(0), across(1), corner[2] - self.least[2]]
        };
        Placed {
            corners: facet.corners.map(place),
            // The extents along z of distances from the plane; infinite if seen edge on.
            contact: CONTACT * longer.max(deep) / cosine,
        }
    }
}

impl Placed {
    /// The rows and columns, out of `samples`, that the facet may cover.
    #[must_use]
    pub fn ranges(&self, samples: usize) -> [Range<usize>; 2] {
        [1, 0].map(|axis| samples_within(self.range(axis), samples))
    }

    /// Smallest and largest coordinate along an axis.
    pub(super) fn range(&self, axis: usize) -> [f64; 2] {
        let [a, b, c] = self.corners.map(|corner| corner[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// Smallest and largest x where y is in this range, widened slightly for rounding.
    pub(super) fn band(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let [a, b, c] = self.corners;
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let [from, to] = if from[1] <= to[1] { [from, to] } else { [to, from] };
            if to[1] < low || from[1] > high {
                continue;
            }
            for y in [from[1].max(low), to[1].min(high)] {
                let share = (y - from[1]) / (to[1] - from[1]);
                // An edge along the row: take both ends.
                let ends = if share.is_finite() { [share, share] } else { [0.0, 1.0] };
                for share in ends {
                    let x = from[0] + share * (to[0] - from[0]);
                    (left, right) = (left.min(x), right.max(x));
                }
            }
        }
        [left - 1e-6, right + 1e-6]
    }

    /// Visits each of these samples that the facet covers, with row, column and depth.
    pub fn visit(
        &self,
        plane: &Plane,
        [rows, columns]: [Range<usize>; 2],
        mut with: impl FnMut(usize, usize, f64),
    ) {
        for row in rows {
            let y = row as f64 + 0.5;
            let band = samples_within(self.band([y, y]), columns.end);
            for column in band.start.max(columns.start)..band.end {
                if let Some(depth) = plane.depth(column as f64 + 0.5, y) {
                    with(row, column, depth);
                }
            }
        }
    }
}

/// The samples, out of `samples`, that lie in a range of coordinates.
pub(super) fn samples_within([low, high]: [f64; 2], samples: usize) -> Range<usize> {
    // Casts convert negative values to 0.
    let (from, to) = ((low - 0.5).ceil() as usize, (high + 0.5).floor() as usize);
    from..to.min(samples)
}

/// A facet's depth, and the area where it is defined.
pub struct Plane {
    /// For the edge opposite each corner: x and y of a point on it, and its run, with the inner
    /// side positive.
    edges: [[f64; 4]; 3],
    /// Depth of each corner, divided by twice the projected area.
    depths: [f64; 3],
    /// Smallest and largest depth.
    pub(super) range: [f64; 2],
}

impl Plane {
    /// The plane of a facet.
    #[must_use]
    pub fn new(facet: &Placed) -> Self {
        let [a, b, c] = facet.corners;
        let edges = [edge(b, c), edge(c, a), edge(a, b)];
        let area = side(&edges[2], c[0], c[1]);
        let edges = edges.map(|[x, y, u, v]| [x, y, u * area.signum(), v * area.signum()]);
        let depths = facet.corners.map(|corner| corner[2] / area.abs());
        Self { edges, depths, range: facet.range(2) }
    }

    /// The depth at a point, if the facet's projection contains it, including the edges.
    pub(super) fn depth(&self, x: f64, y: f64) -> Option<f64> {
        let sides = self.sides(x, y);
        let is_inside = sides[0] >= 0.0 && sides[1] >= 0.0 && sides[2] >= 0.0;
        let [a, b, c] = self.depths;
        let depth = sides[0] * a + sides[1] * b + sides[2] * c;
        // For a sliver the sides are only rounding; without any area the depth is NaN.
        (is_inside && !depth.is_nan()).then(|| depth.max(self.range[0]).min(self.range[1]))
    }

    /// The area of the facet in the square of samples.
    #[must_use]
    pub fn area(&self) -> f64 {
        let [[x, y, ..], ..] = self.edges;
        0.5 * self.sides(x, y).iter().sum::<f64>()
    }

    /// The weights of the corners at a point, which sum to 1; at the edge nearest to one outside.
    /// `None` if the facet has no projected area.
    #[must_use]
    pub fn weights(&self, x: f64, y: f64) -> Option<[f64; 3]> {
        let sides = self.sides(x, y).map(|side| side.max(0.0));
        let sum = sides.iter().sum::<f64>();
        (sum > 0.0).then(|| sides.map(|side| side / sum))
    }

    /// Twice the area between each edge and a point, positive on the facet's side. Even when
    /// rounded, it never falls and rises again along a row or a column.
    pub(super) fn sides(&self, x: f64, y: f64) -> [f64; 3] {
        self.edges.each_ref().map(|edge| side(edge, x, y))
    }

    /// An upper bound of the depth between points at the corners of a box.
    pub(super) fn nearest(&self, corners: [[f64; 2]; 4]) -> f64 {
        let mut nearest = f64::NEG_INFINITY;
        let mut rounding = 0.0f64;
        for [x, y] in corners {
            let (mut depth, mut size) = (0.0, 0.0);
            for (edge, of_corner) in self.edges.iter().zip(self.depths) {
                let [from_x, from_y, run_x, run_y] = edge;
                let products = (run_x * (y - from_y)).abs() + (run_y * (x - from_x)).abs();
                depth += side(edge, x, y) * of_corner;
                size += products * of_corner.abs();
            }
            nearest = nearest.max(depth);
            rounding = rounding.max(size);
        }
        // About eight roundings of each product.
        let nearest = nearest + 8.0 * f64::EPSILON * rounding;
        let [least, most] = self.range;
        if nearest.is_finite() { nearest.max(least).min(most) } else { most }
    }
}

/// An edge's point and run. The reverse edge has exactly the same values except for the sign of the
/// run, so a point on a shared edge is in at least one of the two facets.
fn edge(from: [f64; 3], to: [f64; 3]) -> [f64; 4] {
    if (from[0], from[1]) < (to[0], to[1]) {
        [from[0], from[1], to[0] - from[0], to[1] - from[1]]
    } else {
        [to[0], to[1], to[0] - from[0], to[1] - from[1]]
    }
}

/// Twice the area between an edge and a point, positive to the left of the edge.
fn side(&[from_x, from_y, run_x, run_y]: &[f64; 4], x: f64, y: f64) -> f64 {
    run_x * (y - from_y) - run_y * (x - from_x)
}
