//! Which part of each facet of a mesh the camera sees: an orthographic depth buffer.

use super::facet::Facet;
pub use super::facet_samples::CONTACT;
use super::facet_samples::{Placed, Plane, placed};

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
/// Memory: 8 `samples`² bytes, some 130 for a facet, and 40 for each of its own points. Time:
/// in proportion to the facets, and to the samples that each of them covers, hidden or not.
#[must_use]
pub fn seen_shares(facets: &[Facet], samples: usize) -> Vec<f64> {
    let placed = placed(facets, samples);
    let mut front = vec![f64::NEG_INFINITY; samples * samples];
    for facet in &placed {
        facet.visit(samples, |place, depth| {
            front[place] = front[place].max(depth - facet.contact);
        });
    }
    let mut shares = vec![0.0; facets.len()];
    let mut rows = vec![Vec::new(); samples];
    for (number, facet) in placed.iter().enumerate().filter(|(_, facet)| facet.faces_camera) {
        let (mut covered, mut seen) = (0, 0);
        facet.visit(samples, |place, depth| {
            covered += 1;
            seen += usize::from(depth + facet.contact >= front[place]);
        });
        let parts = facet.parts();
        if covered >= parts * parts {
            shares[number] = seen as f64 / covered as f64;
            continue;
        }
        for [x, y, depth] in facet.centroids(parts) {
            let limit = depth + facet.contact;
            rows[cell(y, samples)].push(Point { x, y, limit, facet: number, is_hidden: false });
        }
    }
    hide(&placed, &mut rows);
    for point in rows.iter().flatten().filter(|point| !point.is_hidden) {
        // A power of two: all of them are exactly 1.
        let parts = placed[point.facet].parts();
        shares[point.facet] += 1.0 / (parts * parts) as f64;
    }
    shares
}

/// A point of a facet beside the samples.
#[derive(Clone, Debug)]
struct Point {
    x: f64,
    y: f64,
    /// What is nearer to the camera than this hides it.
    limit: f64,
    facet: usize,
    is_hidden: bool,
}

/// Finds out which points, listed by row, any facet hides.
fn hide(placed: &[Placed], rows: &mut [Vec<Point>]) {
    for row in rows.iter_mut() {
        row.sort_by(|a, b| a.x.total_cmp(&b.x));
    }
    for facet in placed {
        let plane = Plane::new(facet);
        let [low, high] = facet.range(1).map(|y| cell(y, rows.len()));
        for (number, row) in rows.iter_mut().enumerate().take(high + 1).skip(low) {
            let [left, right] = facet.band([number as f64, (number + 1) as f64]);
            let first = row.partition_point(|point| point.x < left);
            for point in row[first..].iter_mut().take_while(|point| point.x <= right) {
                let depth = plane.depth(point.x, point.y);
                point.is_hidden |= depth.is_some_and(|depth| depth - facet.contact > point.limit);
            }
        }
    }
}

/// The row or column of samples in whose cell a coordinate lies.
fn cell(coordinate: f64, samples: usize) -> usize {
    // A negative one is taken for 0.
    (coordinate as usize).min(samples.saturating_sub(1))
}
