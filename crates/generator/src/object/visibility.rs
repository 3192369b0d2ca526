//! Computes the visible part of each facet of a mesh with an orthographic depth buffer.

use crate::object::depth_buffer::{Count, DepthBuffer};
pub use crate::object::facet::CONTACT;
use crate::object::facet::{Facet, Frame};

/// The share, 0..=1, of each facet's projection that the camera at +z sees.
///
/// The box around the mesh's projection is sampled by `samples` x `samples` points. The share of a
/// facet that faces the camera is the fraction of its samples where no other facet lies in front. A
/// facet that covers no sample, or is long and covers few, has 1, 4 or 16 points of its own, the
/// centroids of equal parts, and the nearest sample to each decides: what lies within the width of
/// a sample in front of the facet's plane does not hide it. So the share is exactly 1 where nothing
/// is hidden. The error of the visible area of partly hidden facets is at most the length of their
/// outlines and of the lines where they are cut, times the diagonal of a sample; for slivers longer
/// than four samples it is at most a tenth of each.
///
/// A facet that faces away or is seen edge on has a share of 0; one that faces away still hides
/// others. Facets that touch within [`CONTACT`], such as neighbors and the two sides of a sheet, do
/// not hide each other; two copies of a facet both count.
///
/// Memory: 8 `samples`² bytes, and 4 for each facet. Time: proportional to the number of facets,
/// and to the number of samples that each of them shows. A hidden facet that fills the picture
/// takes as long as a few thousand samples.
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
    let mut buffer = DepthBuffer::new(samples);
    for number in nearest_first {
        buffer.draw(&frame.place(&facets[number as usize]));
    }
    let share = |facet: &Facet| {
        let facet = frame.place(facet);
        if !facet.faces_camera {
            return 0.0;
        }
        let parts = facet.parts();
        let Count { covered, seen } = buffer.count(&facet, parts * parts);
        if covered >= parts * parts {
            return seen as f64 / covered as f64;
        }
        let points = facet.centroids(parts);
        let seen = points.iter().filter(|point| buffer.sees(**point, facet.sample_in_front));
        seen.count() as f64 / points.len() as f64
    };
    facets.iter().map(share).collect()
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
