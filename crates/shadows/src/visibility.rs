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

    /// For each cell of rays 1 if the point sees it, and 0 if not or if it is below the horizon of the
    /// point's normal.
    #[must_use]
    pub fn seen(&self, point: &Point) -> Vec<u8> {
        let start = [0, 1, 2].map(|axis| point.position[axis] + START * point.facet[axis]);
        let start = Vec3A::from_array(start.map(|along| along as f32));
        let seen = |ray: &[f64; 3]| {
            let above = |normal: [f64; 3]| ray.iter().zip(normal).map(|(a, b)| a * b).sum::<f64>();
            if above(point.normal) <= 0.0 {
                return 0;
            }
            let direction = Vec3A::from_array(ray.map(|along| along as f32));
            let ray = Ray::new_inf(start, direction);
            let is_free = self.bvh.ray_traverse_miss(ray, |ray, place| {
                self.triangles[place].intersect(ray)
            });
            u8::from(is_free)
        };
        self.rays.iter().map(seen).collect()
    }
}
