//! Images of every light on every material by the direct sum (15), the reference for the error of a
//! method; and pixels and timed operations of a setting, independent of its number format.

use super::scope::Scope;
use crate::sphere::Sphere;
use eigenshade::Light;
use eigenshade::lights::NineTerms;
use eigenshade_model::database::Named;
use eigenshade_model::error::Result;
use eigenshade_model::sphere_rings::{Ring, rings};
use eigenshade_shading::shader::fault;
use eigenshade_table::{light, material};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;

/// The widest spacing of the normals: in radians, and in radians over the highest degree.
const WIDEST: f64 = 0.08;
const IN_DEGREES: f64 = 1.5;
/// The number of normals on the rim: they count for the largest error but not for the rms.
const RIM: usize = 64;

/// The luminances of a light and of a material.
#[derive(Clone)]
pub struct Pair {
    pub light: Vec<f64>,
    pub material: Vec<f64>,
}

pub struct Image {
    pub pair: Pair,
    /// Whether the basis was made from this material.
    pub seen: bool,
    /// The irradiance at each normal.
    pub reference: Vec<f64>,
    /// The largest |I|.
    pub peak: f64,
}

impl Pair {
    /// The light and the material up to a degree and an order, at most its own.
    pub fn within(&self, degree: usize, order: usize) -> (&[f64], &[f64]) {
        (&self.light[..light::count(degree)], &self.material[..material::count(order)])
    }

    /// The nine-term formula, with the material treated as Lambertian.
    pub fn nine_terms(&self) -> Result<NineTerms> {
        let degree = (self.light.len().isqrt() - 1).min(2);
        let (light, _) = self.within(degree, 0);
        let light: Vec<f32> = light.iter().map(|&value| value as f32).collect();
        let light = Light::new(&light).map_err(fault)?;
        // b_00^0 is twice the albedo.
        Ok(NineTerms::lambertian(&light, 0.5 * self.material[0] as f32))
    }
}

/// Every light on every material of a scope.
pub struct Images {
    /// The weight of each normal is for the density cos α / π.
    pub sphere: Sphere,
    pub images: Vec<Image>,
}

impl Images {
    pub fn new(scope: &Scope) -> Self {
        let (degree, order) = (scope.degree, scope.order);
        let mut rings = rings(WIDEST.min(IN_DEGREES / degree.max(1) as f64));
        let tilts = (0..RIM).map(|k| TAU * k as f64 / RIM as f64).collect();
        rings.push(Ring { slant: FRAC_PI_2, tilts, weight: 0.0 });
        rings.push(Ring { slant: 0.0, tilts: vec![0.0], weight: 0.0 });
        let sphere = Sphere::new(rings);
        let lights: Vec<Vec<f64>> = scope.lights.entries.iter().map(Named::luminance).collect();
        let entries = scope.seen.entries.iter().chain(&scope.unseen.entries);
        let materials: Vec<Vec<f64>> = entries.map(Named::luminance).collect();
        let all: Vec<&[f64]> = lights.iter().map(Vec::as_slice).collect();
        let channels: Vec<_> = materials.iter().map(|one| (all.clone(), one.as_slice())).collect();
        let image = |(k, reference): (usize, Vec<f64>)| {
            let (material, light) = (k / lights.len(), k % lights.len());
            let peak = reference.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            let seen = material < scope.seen.entries.len();
            let [light, material] = [&lights[light], &materials[material]].map(Vec::clone);
            Image { pair: Pair { light, material }, seen, reference, peak }
        };
        let images = sphere.direct((degree, order), &channels);
        Self { images: images.into_iter().enumerate().map(image).collect(), sphere }
    }
}

/// An operation to be timed.
pub type Work<'a> = Box<dyn FnMut() + 'a>;

pub struct Shaded {
    pub irradiances: Vec<f64>,
    pub terms: usize,
    /// Bytes in RAM for one channel of an image whose light may change: the transferred material,
    /// d, and the data that a pixel reads.
    pub bytes: usize,
    /// Irradiances are multiples of 2 to this power in an integer format; otherwise it is 0.
    pub exponent: i32,
}

/// A basis and normals in a setting's number format.
pub trait Numbers: Sync {
    fn image(&self, pair: &Pair) -> Result<Shaded>;

    /// All pixels, and a new light. `lengths` has a number for each azimuth.
    fn works<'a>(&'a self, pair: &Pair, lengths: &'a mut [u16]) -> Result<[Work<'a>; 2]>;
}

/// The pixels of an image.
pub trait Pixels {
    fn shade(&mut self);

    /// Their irradiances, as last computed.
    fn irradiances(&self) -> Vec<f64>;

    /// Irradiances are multiples of 2 to this power.
    fn exponent(&self) -> i32;
}

/// Writes irradiances as multiples of 2^`exponent`.
pub struct Shading<T, F> {
    out: Vec<T>,
    exponent: i32,
    shade: F,
}

impl<'a, T: Copy + Default + Into<f64> + 'a, F: FnMut(&mut [T]) + 'a> Shading<T, F> {
    pub fn boxed(count: usize, exponent: i32, shade: F) -> Box<dyn Pixels + 'a> {
        Box::new(Self { out: vec![T::default(); count], exponent, shade })
    }
}

impl<T: Copy + Into<f64>, F: FnMut(&mut [T])> Pixels for Shading<T, F> {
    fn shade(&mut self) {
        (self.shade)(&mut self.out);
        black_box(&self.out);
    }

    fn irradiances(&self) -> Vec<f64> {
        let unit = 2f64.powi(self.exponent);
        self.out.iter().map(|&value| unit * value.into()).collect()
    }

    fn exponent(&self) -> i32 {
        self.exponent
    }
}

/// The pixels one by one.
pub fn each<'a, N: Copy, T: Copy + Default + Into<f64> + 'a>(
    normals: &'a [N],
    exponent: i32,
    pixel: impl Fn(N) -> T + 'a,
) -> Box<dyn Pixels + 'a> {
    Shading::boxed(normals.len(), exponent, move |out| {
        for (out, &normal) in out.iter_mut().zip(black_box(normals)) {
            *out = pixel(normal);
        }
    })
}
