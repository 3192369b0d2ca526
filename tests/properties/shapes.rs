//! Random objects.

use eigenshade_generator::object::density;
use eigenshade_generator::object::geometry::WeightedNormals;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::listed;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

/// An object, by what it is made from.
#[derive(Clone, Debug)]
pub enum Shape {
    /// So many normals of all directions, weights over so many decades.
    Any(usize, f64),
    /// So many normals on a half circle, tilted by this.
    Line(usize, f64),
    /// So many normals on the rim.
    Rim(usize),
    /// So many normals within so small an angle.
    Patch(usize, f64),
    /// A density of slants, the same for all tilts.
    Slants(&'static str),
}

pub fn shapes() -> impl Strategy<Value = Shape> {
    let densities = ["cos(a)", "cos(a)^5", "sin(a)", "exp(-4*a)", "1", "a^2", "1/(1+(3*a)^4)"];
    prop_oneof![
        4 => (1usize..60, 0.0f64..6.0).prop_map(|(count, decades)| Shape::Any(count, decades)),
        1 => (1usize..40, -PI..PI).prop_map(|(count, tilt)| Shape::Line(count, tilt)),
        1 => (1usize..40).prop_map(Shape::Rim),
        1 => (1usize..40, -9.0f64..-1.0).prop_map(|(count, size)| Shape::Patch(count, 10f64.powf(size))),
        1 => prop::sample::select(densities.to_vec()).prop_map(Shape::Slants),
    ]
}

impl Shape {
    /// Its normals, for light of this degree.
    pub fn normals(&self, degree: usize, numbers: &mut Numbers) -> WeightedNormals {
        let around = |count: usize, numbers: &mut Numbers| -> Vec<f64> {
            (0..count).map(|_| PI * numbers.next()).collect()
        };
        match *self {
            Self::Any(count, decades) => listed((0..count).map(|_| {
                let normal = numbers.normal();
                (normal, 10f64.powf(-0.5 * decades * (1.0 + numbers.next())))
            })),
            Self::Line(count, tilt) => listed((0..count).map(|_| {
                let (sine, cosine) = (FRAC_PI_2 * numbers.next()).sin_cos();
                ([sine * tilt.cos(), sine * tilt.sin(), cosine.max(0.0)], 1.0)
            })),
            Self::Rim(count) => listed(
                around(count, numbers).iter().map(|tilt| ([tilt.cos(), tilt.sin(), 0.0], 1.0)),
            ),
            Self::Patch(count, size) => listed(
                (0..count)
                    .map(|_| ([0.3 + size * numbers.next(), size * numbers.next(), 0.9], 1.0)),
            ),
            Self::Slants(formula) => {
                listed(density::read(formula, Path::new(""), degree).expect("a formula"))
            }
        }
    }
}
