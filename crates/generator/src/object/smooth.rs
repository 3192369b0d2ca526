//! Smooth normals at the corners of facets, for meshes that have none.

use crate::object::facet::Facet;
use eigenshade_model::vector::{cross, dot};

/// The cosine of the largest angle between the facets of a smooth edge: 30 degrees, and rounding.
const SMOOTH: f64 = 0.866_02;

/// The facets of an edge that are compared with each other; an edge of a surface has two.
const COMPARED: usize = 8;

/// The unit normal of each corner of each facet.
///
/// An edge is smooth if its two facets meet at 30 degrees or less, and equal positions are one
/// point. At a point, the facets that smooth edges connect share a normal: the mean of their own,
/// weighted by the angle of each at the point times its area. A facet that runs the wrong way round
/// has the opposite normal of its neighbors, and shares none with them.
#[must_use]
pub fn corner_normals(facets: &[Facet]) -> Vec<[[f64; 3]; 3]> {
    let points = Points::new(facets);
    let mut normals: Vec<_> = facets.iter().map(|facet| [facet.normal; 3]).collect();
    let mut group = Group::default();
    for corners in points.corners.chunk_by(|a, b| a.0 == b.0) {
        group.join(facets, &points.of_corner, corners);
        for (member, (_, corner)) in corners.iter().enumerate() {
            if let Some(normal) = group.normal(member) {
                normals[*corner as usize / 3][*corner as usize % 3] = normal;
            }
        }
    }
    normals
}

/// The points of a mesh, and the corners of facets there. Corner 3 i + k is number k of facet i.
struct Points {
    /// The point of each corner.
    of_corner: Vec<u32>,
    /// The point and number of each corner, in the order of the points.
    corners: Vec<(u32, u32)>,
}

impl Points {
    fn new(facets: &[Facet]) -> Self {
        // Adding 0 makes -0 equal to 0.
        let position = |corner: u32| {
            facets[corner as usize / 3].corners[corner as usize % 3].map(|x| (x + 0.0).to_bits())
        };
        let mut order: Vec<u32> = (0..3 * facets.len() as u32).collect();
        order.sort_unstable_by_key(|corner| position(*corner));
        let mut of_corner = vec![0; order.len()];
        let mut corners = Vec::with_capacity(order.len());
        for (point, same) in (0..).zip(order.chunk_by(|a, b| position(*a) == position(*b))) {
            for corner in same {
                of_corner[*corner as usize] = point;
                corners.push((point, *corner));
            }
        }
        Self { of_corner, corners }
    }
}

/// The corners at a point, and which of them share a normal.
#[derive(Default)]
struct Group {
    /// Another corner that shares the normal of this one, or the corner itself.
    shares: Vec<usize>,
    /// The sum of the weighted normals, of the corners that refer to themselves.
    sums: Vec<[f64; 3]>,
    /// The point at the other end of each edge, and the corner.
    edges: Vec<(u32, usize)>,
}

impl Group {
    /// Joins the corners at a point across smooth edges.
    fn join(&mut self, facets: &[Facet], of_corner: &[u32], corners: &[(u32, u32)]) {
        let place = |member: usize| {
            let corner = corners[member].1 as usize;
            (corner / 3, corner % 3)
        };
        self.shares.clear();
        self.shares.extend(0..corners.len());
        self.edges.clear();
        for member in 0..corners.len() {
            let (facet, k) = place(member);
            let end = |step: usize| (of_corner[3 * facet + (k + step) % 3], member);
            self.edges.extend([end(1), end(2)]);
        }
        self.edges.sort_unstable();
        for first in 0..self.edges.len() {
            let (point, one) = self.edges[first];
            for second in first + 1..self.edges.len().min(first + COMPARED) {
                let (end, other) = self.edges[second];
                if end != point {
                    break;
                }
                let [a, b] = [one, other].map(|member| facets[place(member).0].normal);
                if dot(a, b) >= SMOOTH {
                    let [a, b] = [one, other].map(|member| self.root(member));
                    self.shares[a.max(b)] = a.min(b);
                }
            }
        }
        self.sums.clear();
        self.sums.resize(corners.len(), [0.0; 3]);
        for member in 0..corners.len() {
            let (facet, k) = place(member);
            let (weight, root) = (weight(&facets[facet], k), self.root(member));
            let sum = &mut self.sums[root];
            sum.iter_mut().zip(facets[facet].normal).for_each(|(sum, n)| *sum += weight * n);
        }
    }

    fn root(&mut self, member: usize) -> usize {
        let mut root = member;
        while self.shares[root] != root {
            self.shares[root] = self.shares[self.shares[root]];
            root = self.shares[root];
        }
        root
    }

    /// The unit normal of a corner; `None` if the sum has no direction.
    fn normal(&mut self, member: usize) -> Option<[f64; 3]> {
        let root = self.root(member);
        let sum = self.sums[root];
        let length = dot(sum, sum).sqrt();
        (length > 0.0).then(|| sum.map(|x| x / length))
    }
}

/// The angle of a facet at one of its corners, times twice its area.
fn weight(facet: &Facet, corner: usize) -> f64 {
    let at = |step: usize| facet.corners[(corner + step) % 3];
    let edge = |step: usize| {
        let (from, to) = (at(0), at(step));
        [0, 1, 2].map(|axis| to[axis] - from[axis])
    };
    let (u, v) = (edge(1), edge(2));
    let area = cross(u, v);
    let area = dot(area, area).sqrt();
    area * area.atan2(dot(u, v))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facet(corners: [[f64; 3]; 3]) -> Facet {
        Facet::new(corners).expect("an area")
    }

    /// Two facets that meet along an edge at this angle.
    fn bent(angle: f64) -> [Facet; 2] {
        let (s, c) = angle.to_radians().sin_cos();
        let [a, b] = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        [facet([a, b, [-1.0, 0.5, 0.0]]), facet([b, a, [c, 0.5, -s]])]
    }

    #[test]
    fn edges_are_smooth_up_to_30_degrees() {
        for (angle, is_smooth) in [(0.0, true), (12.0, true), (30.0, true), (31.0, false)] {
            let facets = bent(angle);
            let [one, other] = corner_normals(&facets)[..] else { panic!("two facets") };
            let middle = (0.5 * angle).to_radians().sin_cos();
            for k in 0..2 {
                let expected = [middle.0, 0.0, middle.1];
                let near = |normal: [f64; 3], expected: [f64; 3]| {
                    normal.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12)
                };
                assert_eq!(near(one[k], expected), is_smooth || angle == 0.0, "{angle}");
                assert_eq!(one[k] == other[1 - k], is_smooth);
            }
            let near = |corner: [f64; 3], facet: &Facet| dot(corner, facet.normal) > 1.0 - 1e-12;
            assert!(near(one[2], &facets[0]) && near(other[2], &facets[1]), "{angle}");
        }
    }

    /// Neither a facet that runs the other way round, nor the other side of a sheet, changes a
    /// normal.
    #[test]
    fn mirrored_facets_share_nothing() {
        let [one, other] = bent(10.0);
        let back = |facet: &Facet| {
            let [a, b, c] = facet.corners;
            self::facet([a, c, b])
        };
        let single = corner_normals(&[one]);
        assert_eq!(corner_normals(&[one, back(&other)])[..1], single);
        assert_eq!(corner_normals(&[one, back(&one)])[..1], single);
        assert_eq!(corner_normals(&[one, other, back(&one)])[..2], corner_normals(&[one, other]));
    }

    /// A fan of a hundred thousand facets around one point takes no time to speak of.
    #[test]
    fn many_facets_at_a_point() {
        let count = 100_000;
        let rim = |k: u32| {
            let (s, c) =
                (f64::from(k % count) * std::f64::consts::TAU / f64::from(count)).sin_cos();
            [c, s, 0.0]
        };
        let facets: Vec<_> =
            (0..count).map(|k| facet([[0.0, 0.0, 0.2], rim(k), rim(k + 1)])).collect();
        let top = corner_normals(&facets)[count as usize / 2][0];
        assert!(top[0].abs() < 1e-9 && top[1].abs() < 1e-9 && top[2] == 1.0, "{top:?}");
    }
}
