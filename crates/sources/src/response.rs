//! The irradiance of a material under each spherical harmonic, for any normal.

use eigenshade_generator::material::brdf::{Brdf, Ggx, Measure, projection};
use eigenshade_index::light;
use eigenshade_model::error::Result;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::source::Gloss;
use eigenshade_model::special::spherical_harmonic::azimuth;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::f64::consts::{FRAC_PI_2, PI};

/// The number of slants at which a response is computed. Between them it is interpolated: it is a
/// smooth function of the slant, a sum of powers of sines and cosines below degree + order.
const NODES: usize = 64;

/// The response of one material to the harmonics up to a degree.
#[derive(Clone, Debug)]
pub struct Response {
    degree: usize,
    /// Slants, and for each the irradiance at tilt 0 of each harmonic without its azimuth.
    nodes: Vec<(f64, Vec<f64>)>,
}

impl Response {
    /// Of the coefficients of a material of an order, by the direct sum (15).
    #[must_use]
    pub fn new((degree, order): (usize, usize), material: &[f64]) -> Self {
        let sum = DirectSum::new(degree, order);
        let node = |k: usize| {
            let slant = 0.5 * FRAC_PI_2 * (1.0 - angle(k).cos());
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
            (slant, values)
        };
        Self { degree, nodes: (0..NODES).into_par_iter().map(node).collect() }
    }

    /// Largest degree l.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The irradiance under each harmonic at a unit normal with z >= 0.
    #[must_use]
    pub fn at(&self, normal: [f64; 3]) -> Vec<f64> {
        let (mut values, waves) = interpolated(&self.nodes, normal, self.degree);
        for ((_, m), value) in light::indices(self.degree).zip(&mut values) {
            *value *= waves[place(m, self.degree)];
        }
        values
    }

    /// The image under a light of the same degree.
    #[must_use]
    pub fn under(&self, light: &[f64]) -> Image {
        let profiles = |(slant, values): &(f64, Vec<f64>)| {
            let mut profiles = vec![0.0; 2 * self.degree + 1];
            for (((_, m), value), light) in light::indices(self.degree).zip(values).zip(light) {
                profiles[place(m, self.degree)] += value * light;
            }
            (*slant, profiles)
        };
        Image { degree: self.degree, nodes: self.nodes.iter().map(profiles).collect() }
    }
}

/// The image of a material under one light.
#[derive(Clone, Debug)]
pub struct Image {
    degree: usize,
    /// Slants, and for each the factor of each azimuth.
    nodes: Vec<(f64, Vec<f64>)>,
}

impl Image {
    /// The irradiance at a unit normal with z >= 0.
    #[must_use]
    pub fn irradiance(&self, normal: [f64; 3]) -> f64 {
        let (profiles, waves) = interpolated(&self.nodes, normal, self.degree);
        profiles.iter().zip(&waves).map(|(profile, wave)| profile * wave).sum()
    }
}

/// The place of an order of the azimuth among those from -`degree` to `degree`.
fn place(m: isize, degree: usize) -> usize {
    degree.wrapping_add_signed(m)
}

/// What the nodes hold, at the slant of a normal, by barycentric interpolation at Chebyshev points;
/// and the azimuths at its tilt, from -`degree` to `degree`.
fn interpolated(
    nodes: &[(f64, Vec<f64>)],
    [x, y, z]: [f64; 3],
    degree: usize,
) -> (Vec<f64>, Vec<f64>) {
    let (slant, tilt) = (x.hypot(y).atan2(z), y.atan2(x));
    let mut sums = vec![0.0; nodes.first().map_or(0, |(_, values)| values.len())];
    let mut total = 0.0;
    for (k, (node, values)) in nodes.iter().enumerate() {
        let apart = slant - node;
        // At a node, its weight exceeds all others by far.
        let apart = if apart.abs() < 1e-14 { 1e-14 } else { apart };
        let weight = if k % 2 == 0 { angle(k).sin() } else { -angle(k).sin() } / apart;
        total += weight;
        sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
    }
    sums.iter_mut().for_each(|sum| *sum /= total);
    let highest = degree as isize;
    (sums, (-highest..=highest).map(|m| azimuth(m, tilt)).collect())
}

fn angle(node: usize) -> f64 {
    PI * (node as f64 + 0.5) / NODES as f64
}

/// One channel of a GGX material, with its responses at several sizes.
pub struct Glossy {
    /// Its parameters, the same in each channel.
    pub gloss: Gloss,
    /// The BRDF.
    pub brdf: Box<dyn Brdf>,
    /// One for each size.
    pub responses: Vec<Response>,
}

impl Glossy {
    /// The material with responses at these degrees and orders.
    ///
    /// # Errors
    ///
    /// Those of [`Ggx::new`].
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
