//! The irradiance of a material under each spherical harmonic, for any normal.

use eigenshade_generator::material::brdf::{Brdf, Ggx, Measure, projection};
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::source::Gloss;
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_table::light;
use std::f64::consts::{FRAC_PI_2, PI};

/// The number of slants at which a response is computed. Between them it is interpolated: it is a
/// smooth function of the slant, a sum of powers of sines and cosines below degree + order.
const NODES: usize = 64;

/// The response of one material to the harmonics up to a degree.
#[derive(Clone, Debug)]
pub struct Response {
    degree: usize,
    /// For each slant the irradiance at tilt 0 of each harmonic without its azimuth.
    nodes: Vec<Vec<f64>>,
}

impl Response {
    /// The response of a material of an order, from its coefficients, by the direct sum (15).
    #[must_use]
    pub fn new((degree, order): (usize, usize), material: &[f64]) -> Self {
        let sum = DirectSum::new(degree, order);
        let node = |k: usize| {
            let slant = slant(k);
            let modes = sum.at([slant.sin(), 0.0, slant.cos()]);
            let scattered = modes.scatter(material);
            let mut values = vec![0.0; light::count(degree)];
            for l in 0..=degree {
                // One light has all orders of a degree: the profile separates them.
                let mut of_degree = vec![0.0; light::count(degree)];
                of_degree[l * l..light::count(l)].fill(1.0);
                let profile = modes.profile(&of_degree, &scattered);
                values[l * l..light::count(l)].copy_from_slice(&profile[degree - l..=degree + l]);
            }
            values
        };
        Self { degree, nodes: parallel::map(NODES, &(), node) }
    }

    /// Largest degree l.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The irradiance under each harmonic at a normal.
    #[must_use]
    pub fn at(&self, at: &Place) -> Vec<f64> {
        let mut values = at.interpolated(&self.nodes);
        for ((_, m), value) in light::indices(self.degree).zip(&mut values) {
            *value *= at.wave(m);
        }
        values
    }

    /// The irradiance under each harmonic at each of some normals.
    #[must_use]
    pub fn at_all(&self, normals: &[[f64; 3]]) -> Vec<Vec<f64>> {
        parallel::map(normals.len(), &(), |k| self.at(&Place::new(normals[k], self.degree)))
    }

    /// The image under a light of the same degree or a higher one.
    #[must_use]
    pub fn under(&self, light: &[f64]) -> Image {
        let profiles = |values: &Vec<f64>| {
            let mut profiles = vec![0.0; 2 * self.degree + 1];
            for (((_, m), value), light) in light::indices(self.degree).zip(values).zip(light) {
                profiles[self.degree.wrapping_add_signed(m)] += value * light;
            }
            profiles
        };
        Image { degree: self.degree, nodes: self.nodes.iter().map(profiles).collect() }
    }
}

/// The image of a material under one light.
#[derive(Clone, Debug)]
pub struct Image {
    degree: usize,
    /// For each slant the factor of each azimuth, from -degree to degree.
    nodes: Vec<Vec<f64>>,
}

impl Image {
    /// The irradiance at a normal.
    #[must_use]
    pub fn irradiance(&self, at: &Place) -> f64 {
        let highest = self.degree as isize;
        let profiles = at.interpolated(&self.nodes);
        profiles.iter().zip(-highest..).map(|(profile, m)| profile * at.wave(m)).sum()
    }
}

/// A normal, for responses and images of up to a degree.
#[derive(Clone, Debug)]
pub struct Place {
    /// The weights of the nodes at its slant: barycentric interpolation at Chebyshev points.
    weights: Vec<f64>,
    /// The azimuths at its tilt, from -degree to degree.
    waves: Vec<f64>,
}

impl Place {
    /// The place of a unit normal with z >= 0.
    #[must_use]
    pub fn new([x, y, z]: [f64; 3], degree: usize) -> Self {
        let (at, tilt) = (x.hypot(y).atan2(z), y.atan2(x));
        let weight = |k: usize| {
            let apart = at - slant(k);
            // At a node, its weight exceeds all others by far.
            let apart = if apart.abs() < 1e-14 { 1e-14 } else { apart };
            if k.is_multiple_of(2) { angle(k).sin() / apart } else { -angle(k).sin() / apart }
        };
        let mut weights: Vec<f64> = (0..NODES).map(weight).collect();
        let total: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= total);
        let highest = degree as isize;
        Self { weights, waves: (-highest..=highest).map(|m| azimuth(m, tilt)).collect() }
    }

    fn wave(&self, m: isize) -> f64 {
        self.waves[(self.waves.len() / 2).wrapping_add_signed(m)]
    }

    fn interpolated(&self, nodes: &[Vec<f64>]) -> Vec<f64> {
        let mut sums = vec![0.0; nodes.first().map_or(0, Vec::len)];
        for (weight, values) in self.weights.iter().zip(nodes) {
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
        }
        sums
    }
}

fn angle(node: usize) -> f64 {
    PI * (node as f64 + 0.5) / NODES as f64
}

fn slant(node: usize) -> f64 {
    0.5 * FRAC_PI_2 * (1.0 - angle(node).cos())
}

/// One channel of a GGX material, with its responses at several sizes.
pub struct Glossy {
    /// The parameters, the same in each channel.
    pub gloss: Gloss,
    /// The BRDF.
    pub brdf: Box<dyn Brdf>,
    /// The response at each size.
    pub responses: Vec<Response>,
}

impl Glossy {
    /// The material with responses at these degrees and orders.
    ///
    /// # Errors
    ///
    /// As [`Ggx::new`].
    pub fn new(
        [roughness, reflectance, albedo]: [f64; 3],
        sizes: &[(usize, usize)],
    ) -> Result<Self> {
        let brdf = Ggx::new(roughness, reflectance, albedo)?;
        let orders: Vec<usize> = sizes.iter().map(|size| size.1).collect();
        let projections = projection::project_orders(&brdf, &orders, Measure::default());
        let responses = sizes.iter().zip(&projections);
        let responses = responses.map(|(&size, of)| Response::new(size, &of.coefficients));
        let responses = responses.collect();
        let [reflectance, albedo] = [reflectance, albedo].map(|number| [number; 3]);
        let gloss = Gloss { roughness, reflectance, grazing: [1.0; 3], albedo };
        Ok(Self { gloss, brdf: Box::new(brdf), responses })
    }
}
