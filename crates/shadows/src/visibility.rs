//! Which directions a point of a surface sees.

use crate::directions::{RAYS, cells};
use eigenshade_generator::object::facet::Facet;
use eigenshade_generator::object::points::Point;
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::Ray;
use obvhs::triangle::Triangle;

/// How far from its point a ray starts, along the facet's normal, in the unit of the surface, in which
/// no coordinate exceeds 1.
const START: f64 = 2e-5;

/// The triangles of a surface, which block light from both sides.
pub struct Occluders {
    bvh: CwBvh,
    triangles: Vec<Triangle>,
    rays: Vec<[f64; 3]>,
}

impl Occluders {
    /// All facets of a surface.
    #[must_use]
    pub fn new(facets: &[Facet]) -> Self {
        let corner = |[x, y, z]: [f64; 3]| Vec3A::new(x as f32, y as f32, z as f32);
        let triangle = |facet: &Facet| {
            let [v0, v1, v2] = facet.corners.map(corner);
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = facets.iter().map(triangle).collect();
        let bvh = build_cwbvh_from_tris(
            &triangles,
            BvhBuildParams::medium_build(),
            &mut std::time::Duration::default(),
        );
        // In the order of the hierarchy, so that the triangles of a leaf lie together.
        let triangles =
            bvh.primitive_indices.iter().map(|&place| triangles[place as usize]).collect();
        let rays = cells(RAYS).into_iter().map(|(direction, _)| direction).collect();
        Self { bvh, triangles, rays }
    }

    /// Whether points of similar normals see each cell of rays, which they take in turns. What is below
    /// the horizon of its point's normal is not seen.
    #[must_use]
    pub fn seen(&self, points: &[Point]) -> Vec<bool> {
        let starts: Vec<Vec3A> = points.iter().map(start).collect();
        let seen = |(cell, ray): (usize, &[f64; 3])| {
            let turn = (cell % RAYS + 2 * (cell / RAYS)) % points.len();
            let above = ray.iter().zip(points[turn].normal).map(|(a, b)| a * b).sum::<f64>() > 0.0;
            above && self.is_free(starts[turn], *ray)
        };
        self.rays.iter().enumerate().map(seen).collect()
    }

    fn is_free(&self, start: Vec3A, ray: [f64; 3]) -> bool {
        let direction = Vec3A::from_array(ray.map(|along| along as f32));
        let ray = Ray::new_inf(start, direction);
        self.bvh.ray_traverse_miss(ray, |ray, place| self.triangles[place].intersect(ray))
    }
}

/// The start of the rays of a point.
fn start(point: &Point) -> Vec3A {
    let start = [0, 1, 2].map(|axis| point.position[axis] + START * point.facet[axis]);
    Vec3A::from_array(start.map(|along| along as f32))
}
