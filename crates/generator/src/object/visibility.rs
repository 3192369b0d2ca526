//! Computes the visible part of each facet of a mesh with an orthographic depth buffer.

use crate::object::depth_buffer::{Count, DepthBuffer};
pub use crate::object::facet::CONTACT;
use crate::object::facet::{Facet, Frame, Placed, Plane};

/// The share, 0..=1, of each facet's projection that the camera at +z sees.
///
/// The box around the mesh's projection is sampled by `samples` x `samples` points. The share of a
/// facet that faces the camera is the fraction of its samples where no other facet lies in front. A
/// facet that covers no sample, or is long and covers few, is decided by points of its own: the
/// centroid, or those of 4 or 16 equal parts. So the share is exactly 1 where nothing is hidden and
/// exactly 0 where everything is. The error of the visible area of partly hidden facets is at most
/// the length of their outlines and of the lines where they are cut, times the diagonal of a
/// sample; for slivers longer than four samples it is at most a tenth of each.
///
/// A facet that faces away or is seen edge on has a share of 0; one that faces away still hides
/// others. Facets that touch within [`CONTACT`], such as neighbors and the two sides of a sheet, do
/// not hide each other; two copies of a facet both count.
///
/// Memory: 8 `samples`² bytes, 12 for each facet, and at most about 80 MiB for the facets' own
/// points. Time: proportional to the number of facets, and to the number of samples that each of
/// them shows. A hidden facet that fills the picture takes as long as a few thousand samples.
#[must_use]
pub fn seen_shares(facets: &[Facet], samples: usize) -> Vec<f64> {
    let frame = Frame::new(facets, samples);
    // Draw the nearest facets first, so that those behind are quickly known to be hidden.
    let nearest = |number: u32| {
        let [a, b, c] = facets[number as usize].corners;
        a[2].max(b[2]).max(c[2])
    };
    let mut nearest_first: Vec<u32> = (0..facets.len() as u32).collect();
    nearest_first.sort_by(|&a, &b| nearest(b).total_cmp(&nearest(a)));
    let placed = || nearest_first.iter().map(|&number| frame.place(&facets[number as usize]));
    let mut buffer = DepthBuffer::new(samples);
    for facet in placed() {
        buffer.draw(&facet);
    }
    let mut shares = vec![0.0; facets.len()];
    let mut rows = vec![Row::default(); samples];
    let mut points = 0;
    for (number, facet) in facets.iter().enumerate() {
        let facet = frame.place(facet);
        if !facet.faces_camera {
            continue;
        }
        let parts = facet.parts();
        let Count { covered, seen } = buffer.count(&facet, parts * parts);
        if covered >= parts * parts {
            shares[number] = seen as f64 / covered as f64;
            continue;
        }
        // A power of two, so the shares of all points sum to exactly 1.
        let share = 1.0 / (parts * parts) as f64;
        for [x, y, depth] in facet.centroids(parts) {
            let limit = depth + facet.contact;
            rows[cell(y, samples)].points.push(Point {
                x,
                y,
                limit,
                facet: number,
                share,
                is_hidden: false,
            });
        }
        points += parts * parts;
        if points >= MOST_POINTS {
            settle(placed(), &mut rows, &mut shares);
            points = 0;
        }
    }
    settle(placed(), &mut rows, &mut shares);
    shares
}

/// Samples across and down for [`faces_away`].
const COARSE: usize = 128;

/// Whether most of what the camera at +z meets first faces away from it: more than three fifths, so
/// that half does not depend on where samples fall.
pub(crate) fn faces_away(facets: &[Facet]) -> bool {
    let frame = Frame::new(facets, COARSE);
    let mut buffer = DepthBuffer::new(COARSE);
    for facet in facets {
        buffer.draw(&frame.place(facet));
    }
    let mut is_shown = vec![false; COARSE * COARSE];
    for facet in facets.iter().filter(|facet| facet.projected_area > 0.0) {
        buffer.visit_seen(&frame.place(facet), |place, _| is_shown[place] = true);
    }
    let shown = is_shown.iter().filter(|is_shown| **is_shown).count();
    5 * shown < 2 * buffer.covered()
}

/// Number of points that are decided at once: 48 MiB, plus the memory of growing lists.
const MOST_POINTS: usize = 1 << 20;

/// Adds the shares of all points that nothing hides to their facets, and removes the points.
fn settle(facets: impl Iterator<Item = Placed>, rows: &mut [Row], shares: &mut [f64]) {
    hide(facets, rows);
    for row in rows {
        for point in row.points.drain(..).filter(|point| !point.is_hidden) {
            shares[point.facet] += point.share;
        }
    }
}

/// A facet's own point, which is not on the sample grid.
#[derive(Clone, Debug)]
struct Point {
    x: f64,
    y: f64,
    /// Anything nearer to the camera than this hides the point.
    limit: f64,
    facet: usize,
    /// The point's share of its facet.
    share: f64,
    is_hidden: bool,
}

/// The points whose cells are in one row of samples.
#[derive(Clone, Debug, Default)]
struct Row {
    points: Vec<Point>,
    /// Lower bound of the limits of the points that are not hidden.
    least: f64,
    /// Number of hidden points.
    hidden: usize,
}

impl Row {
    /// Removes the hidden points.
    fn tidy(&mut self) {
        self.points.retain(|point| !point.is_hidden);
        self.least = self.points.iter().map(|point| point.limit).fold(f64::INFINITY, f64::min);
        self.hidden = 0;
    }
}

/// Marks the points, listed by row, that a facet hides.
fn hide(facets: impl Iterator<Item = Placed>, rows: &mut [Row]) {
    for row in rows.iter_mut() {
        row.points.sort_by(|a, b| a.x.total_cmp(&b.x));
        row.tidy();
    }
    for facet in facets {
        let plane = Plane::new(&facet);
        let nearest = facet.range(2)[1] - facet.contact;
        let [low, high] = facet.range(1).map(|y| cell(y, rows.len()));
        for (number, row) in rows.iter_mut().enumerate().take(high + 1).skip(low) {
            if nearest <= row.least {
                continue;
            }
            let [left, right] = facet.band([number as f64, (number + 1) as f64]);
            let first = row.points.partition_point(|point| point.x < left);
            let near = row.points[first..].iter_mut().take_while(|point| point.x <= right);
            for point in near.filter(|point| !point.is_hidden) {
                let depth = plane.depth(point.x, point.y);
                point.is_hidden = depth.is_some_and(|depth| depth - facet.contact > point.limit);
                row.hidden += usize::from(point.is_hidden);
            }
            if 2 * row.hidden > row.points.len() {
                row.tidy();
            }
        }
    }
}

/// The row or column of the sample whose cell contains a coordinate.
fn cell(coordinate: f64, samples: usize) -> usize {
    // The cast converts negative coordinates to 0.
    (coordinate as usize).min(samples.saturating_sub(1))
}
