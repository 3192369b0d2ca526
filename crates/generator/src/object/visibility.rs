//! Which part of each facet of a mesh the camera sees: an orthographic depth buffer.

use crate::object::depth_buffer::{Count, DepthBuffer};
use crate::object::facet::Facet;
pub use crate::object::facet_samples::CONTACT;
use crate::object::facet_samples::{Frame, Placed, Plane};

/// The share, 0..=1, of each facet's projection that the camera at +z sees.
///
/// The box around the mesh's projection is sampled by `samples` x `samples` points. Of a
/// facet that faces the camera the share is that of its samples where no other facet lies in
/// front of it. One that covers no sample, or is long and covers few, is decided by points of
/// its own: the centroid, or those of 4 or 16 equal parts. So where nothing is hidden the share
/// is 1 exactly, and where all is, 0. The visible area of facets that are partly hidden is off
/// by no more than the length of their outlines and of the lines where they are cut, times the
/// diagonal of a sample; of slivers longer than four samples, by a tenth of each.
///
/// A facet that faces away hides as any does, but has no share; nor has one seen edge on.
/// Facets that touch within [`CONTACT`], as neighbours and the two sides of a sheet, do not
/// hide each other; of two copies of a facet both count.
///
/// Memory: 8 `samples`² bytes, 12 for a facet, and at most some 80 MiB for points of their own.
/// Time: in proportion to the facets, and to the samples that each of them shows. Behind others,
/// a facet that fills the picture takes as long as a few thousand samples.
#[must_use]
pub fn seen_shares(facets: &[Facet], samples: usize) -> Vec<f64> {
    let frame = Frame::new(facets, samples);
    // The nearest first, so that what lies behind them is soon known to be hidden.
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
        // A power of two: all of them are exactly 1.
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

/// Points that are settled at once: 48 MiB, and what lists take as they grow.
const MOST_POINTS: usize = 1 << 20;

/// Gives the facets the shares of their points that nothing hides, and forgets the points.
fn settle(facets: impl Iterator<Item = Placed>, rows: &mut [Row], shares: &mut [f64]) {
    hide(facets, rows);
    for row in rows {
        for point in row.points.drain(..).filter(|point| !point.is_hidden) {
            shares[point.facet] += point.share;
        }
    }
}

/// A point of a facet beside the samples.
#[derive(Clone, Debug)]
struct Point {
    x: f64,
    y: f64,
    /// What is nearer to the camera than this hides it.
    limit: f64,
    facet: usize,
    /// Of its facet.
    share: f64,
    is_hidden: bool,
}

/// The points in the cells of one row of samples.
#[derive(Clone, Debug, Default)]
struct Row {
    points: Vec<Point>,
    /// None of those that are not hidden has a lesser limit.
    least: f64,
    /// How many of them are hidden.
    hidden: usize,
}

impl Row {
    /// Without those that are hidden.
    fn tidy(&mut self) {
        self.points.retain(|point| !point.is_hidden);
        self.least = self.points.iter().map(|point| point.limit).fold(f64::INFINITY, f64::min);
        self.hidden = 0;
    }
}

/// Finds out which points, listed by row, any facet hides.
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

/// The row or column of samples in whose cell a coordinate lies.
fn cell(coordinate: f64, samples: usize) -> usize {
    // A negative one is taken for 0.
    (coordinate as usize).min(samples.saturating_sub(1))
}
