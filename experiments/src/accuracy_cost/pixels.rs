//! Pixels and timed operations of a setting, independent of its number format.

use super::images::Pair;
use eigenshade_model::error::Result;
use std::hint::black_box;

/// An operation to be timed.
pub type Work<'a> = Box<dyn FnMut() + 'a>;

/// An image.
pub struct Shaded {
    /// The irradiance of every normal.
    pub irradiances: Vec<f64>,
    /// The number of terms of the polynomials.
    pub terms: usize,
    /// Bytes in RAM for one channel of an image whose light may change: the transferred material,
    /// d, and the data that a pixel reads.
    pub bytes: usize,
}

/// A basis and normals in a setting's number format.
pub trait Numbers: Sync {
    /// Shades every normal.
    fn image(&self, pair: &Pair) -> Result<Shaded>;

    /// All pixels, and a new light. `lengths` has a number for each azimuth.
    fn works<'a>(&'a self, pair: &Pair, lengths: &'a mut [u16]) -> Result<[Work<'a>; 2]>;
}

/// The pixels of an image.
pub trait Pixels {
    /// Computes them.
    fn shade(&mut self);

    /// Their irradiances, as last computed.
    fn irradiances(&self) -> Vec<f64>;
}

/// Writes irradiances as multiples of 2^`exponent`.
pub struct Shading<T, F> {
    out: Vec<T>,
    exponent: i32,
    shade: F,
}

impl<'a, T: Copy + Default + Into<f64> + 'a, F: FnMut(&mut [T]) + 'a> Shading<T, F> {
    /// A number of pixels.
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
