//! Which part of each facet of a mesh the camera sees: an orthographic depth buffer.

use super::facet::Facet;

/// How near another surface may come to a facet's plane and not hide it, of the longest
/// side of the mesh's box: corners in f32 are that coarse.
pub const CONTACT: f64 = 1e-6;

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

/// A facet in units of samples: those of column i and row k stand at i + 1/2, k + 1/2.
struct Placed {
    /// x and y in samples, z as it comes.
    corners: [[f64; 3]; 3],
    faces_camera: bool,
    /// How far along z something in contact may be.
    contact: f64,
}

fn placed(facets: &[Facet], samples: usize) -> Vec<Placed> {
    let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for corner in facets.iter().flat_map(|facet| &facet.corners) {
        for axis in 0..3 {
            least[axis] = least[axis].min(corner[axis]);
            most[axis] = most[axis].max(corner[axis]);
        }
    }
    let sides = [0, 1, 2].map(|axis| most[axis] - least[axis]);
    let longest = sides.iter().copied().fold(0.0, f64::max);
    let place = |corner: [f64; 3]| {
        let across = |axis: usize| {
            // A box without width has no facet with a projection.
            let side = if sides[axis] > 0.0 { sides[axis] } else { 1.0 };
            (corner[axis] - least[axis]) / side * samples as f64
        };
        [across(0), across(1), corner[2]]
    };
    let facet = |facet: &Facet| Placed {
        corners: facet.corners.map(place),
        faces_camera: facet.projected_area > 0.0,
        // Of a plane at a distance CONTACT; infinite if it is seen edge on.
        contact: CONTACT * longest / facet.normal[2].abs(),
    };
    facets.iter().map(facet).collect()
}

impl Placed {
    /// In how many parts each edge is cut for points of its own: 1, 2 or 4.
    fn parts(&self) -> usize {
        let longest = [0, 1].map(|axis| self.range(axis)).map(|[low, high]| high - low);
        match longest[0].max(longest[1]) {
            ..=2.0 => 1,
            ..=4.0 => 2,
            _ => 4,
        }
    }

    /// The centroids of the facets that it is cut into, `parts` along each edge.
    fn centroids(&self, parts: usize) -> Vec<[f64; 3]> {
        let [a, b, c] = self.corners;
        let mut points = Vec::new();
        // In thirds of a part: upright ones stand at 1, 1, inverted ones at 2, 2.
        for (i, j, third) in (0..parts)
            .flat_map(|i| (0..parts - i).map(move |j| (i, j)))
            .flat_map(|(i, j)| [(i, j, 1), (i, j, 2)])
            .filter(|(i, j, third)| i + j + third <= parts)
        {
            let [u, v] = [i, j].map(|k| (3 * k + third) as f64 / (3 * parts) as f64);
            points.push([0, 1, 2].map(|k| a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k])));
        }
        points
    }

    /// Least and largest coordinate.
    fn range(&self, axis: usize) -> [f64; 2] {
        let [a, b, c] = self.corners.map(|corner| corner[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// Least and largest x where y is in this range, a little widened for rounding.
    fn band(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let [a, b, c] = self.corners;
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let [from, to] = if from[1] <= to[1] { [from, to] } else { [to, from] };
            if to[1] < low || from[1] > high {
                continue;
            }
            for y in [from[1].max(low), to[1].min(high)] {
                let share = (y - from[1]) / (to[1] - from[1]);
                // An edge along the row: both of its ends.
                let ends = if share.is_finite() { [share, share] } else { [0.0, 1.0] };
                for share in ends {
                    let x = from[0] + share * (to[0] - from[0]);
                    (left, right) = (left.min(x), right.max(x));
                }
            }
        }
        [left - 1e-6, right + 1e-6]
    }

    /// Each sample that the facet covers: its place row by row, and the depth there.
    fn visit(&self, samples: usize, mut with: impl FnMut(usize, f64)) {
        let plane = Plane::new(self);
        // Samples from..to lie in a range; casts take what is negative for 0.
        let within = |[low, high]: [f64; 2]| {
            let (from, to) = ((low - 0.5).ceil() as usize, (high + 0.5).floor() as usize);
            from..to.min(samples)
        };
        for row in within(self.range(1)) {
            let y = row as f64 + 0.5;
            for column in within(self.band([y, y])) {
                if let Some(depth) = plane.depth(column as f64 + 0.5, y) {
                    with(row * samples + column, depth);
                }
            }
        }
    }
}

/// A facet's depth, and where it has any.
struct Plane {
    /// Opposite each corner: x and y of a point of the edge, and the edge's run, by which its
    /// inner side is positive.
    edges: [[f64; 4]; 3],
    /// Of each corner, over twice the projected area.
    depths: [f64; 3],
    range: [f64; 2],
}

impl Plane {
    fn new(facet: &Placed) -> Self {
        let [a, b, c] = facet.corners;
        let edges = [edge(b, c), edge(c, a), edge(a, b)];
        let area = side(&edges[2], c[0], c[1]);
        let edges = edges.map(|[x, y, u, v]| [x, y, u * area.signum(), v * area.signum()]);
        let depths = facet.corners.map(|corner| corner[2] / area.abs());
        Self { edges, depths, range: facet.range(2) }
    }

    /// The depth at a point, if the facet's projection has it, edges included.
    fn depth(&self, x: f64, y: f64) -> Option<f64> {
        let sides = self.edges.each_ref().map(|edge| side(edge, x, y));
        let is_inside = sides[0] >= 0.0 && sides[1] >= 0.0 && sides[2] >= 0.0;
        let [a, b, c] = self.depths;
        let depth = sides[0] * a + sides[1] * b + sides[2] * c;
        // Of a sliver the sides are rounding; and no number if it has no area at all.
        (is_inside && !depth.is_nan()).then(|| depth.max(self.range[0]).min(self.range[1]))
    }
}

/// An edge's point and run. Those of the way back are exactly the same but for the run's sign:
/// a point on the edge of two facets is in one of them at least.
fn edge(from: [f64; 3], to: [f64; 3]) -> [f64; 4] {
    if (from[0], from[1]) < (to[0], to[1]) {
        [from[0], from[1], to[0] - from[0], to[1] - from[1]]
    } else {
        [to[0], to[1], to[0] - from[0], to[1] - from[1]]
    }
}

/// Twice the area between an edge and a point, positive on its left.
fn side(&[from_x, from_y, run_x, run_y]: &[f64; 4], x: f64, y: f64) -> f64 {
    run_x * (y - from_y) - run_y * (x - from_x)
}
