//! The information in an image's pixels about its components, compressed to a few rows.
//!
//! Let E be the eigenimages at the pixels' normals, W the weights, m the mean image and I the
//! channels. Orthogonal transformations reduce √W (E m I) to no more rows than columns. Every
//! estimate and every residual by weighted least squares is the same from these rows as from the
//! pixels.

use super::linear::Reduction;
use crate::basis::profile;
use eigenshade_table::Table;
use faer::{Col, ColRef, Mat};
use std::f64::consts::SQRT_2;

/// The largest value, weight and noise of a pixel: its square times any number of pixels is finite.
/// The reciprocal is the least, but for zero.
pub const LARGEST: f64 = 1e100;

/// The pixels of an image in reduced form.
#[derive(Clone, Debug)]
pub struct Observation {
    /// √W E, one column for each component.
    pub design: Mat<f64>,
    /// √W m, the mean image; zeros if the table has none.
    pub mean: Col<f64>,
    /// √W I, one column for each channel.
    pub channels: Mat<f64>,
    /// Number of pixels with positive weight.
    pub pixels: usize,
    /// Σ w over the pixels.
    pub weight: f64,
    /// Σ w I over the pixels, for each channel.
    pub sums: Vec<f64>,
}

/// Collects pixels one by one.
#[derive(Clone, Debug)]
pub struct Observer<'a> {
    values: EigenimageValues<'a>,
    row: Vec<f64>,
    reduction: Reduction,
    pixels: usize,
    weight: f64,
    sums: Vec<f64>,
}

impl<'a> Observer<'a> {
    /// An observer for images with this number of channels, in these components.
    #[must_use]
    pub fn new(values: EigenimageValues<'a>, channels: usize) -> Self {
        let columns = values.components() + 1 + channels;
        Self {
            values,
            row: vec![0.0; columns],
            reduction: Reduction::new(columns),
            pixels: 0,
            weight: 0.0,
            sums: vec![0.0; channels],
        }
    }

    /// Adds one pixel: its unit normal, z >= 0, its irradiance in each channel, and its weight,
    /// which is the reciprocal of its noise variance up to a common factor.
    ///
    /// A weight of 0 or below leaves the pixel out. All numbers must be finite. Missing channels
    /// count as zero.
    pub fn see(&mut self, normal: [f64; 3], irradiance: &[f64], weight: f64) {
        if weight <= 0.0 {
            return;
        }
        let components = self.values.components();
        self.values.at(normal, &mut self.row[..=components]);
        let channels = &mut self.row[components + 1..];
        channels.fill(0.0);
        channels.iter_mut().zip(irradiance).for_each(|(channel, value)| *channel = *value);
        let root = weight.sqrt();
        self.row.iter_mut().for_each(|value| *value *= root);
        self.reduction.push(&self.row);
        self.pixels += 1;
        self.weight += weight;
        for (sum, value) in self.sums.iter_mut().zip(irradiance) {
            *sum += weight * value;
        }
    }

    /// Returns the observation of all added pixels.
    #[must_use]
    pub fn finish(self) -> Observation {
        let components = self.values.components();
        let rows = self.reduction.finish();
        Observation {
            design: rows.get(.., ..components).to_owned(),
            mean: rows.col(components).to_owned(),
            channels: rows.get(.., components + 1..).to_owned(),
            pixels: self.pixels,
            weight: self.weight,
            sums: self.sums,
        }
    }
}

impl Observation {
    /// Number of components.
    #[must_use]
    pub fn components(&self) -> usize {
        self.design.ncols()
    }

    /// √W I of one channel.
    #[must_use]
    pub fn channel(&self, channel: usize) -> ColRef<'_, f64> {
        self.channels.col(channel)
    }

    /// √W (I - m) of one channel, which d describes.
    #[must_use]
    pub fn centered(&self, channel: usize) -> Col<f64> {
        self.channel(channel) - &self.mean
    }
}

/// The first components of a table and its mean image, evaluated one normal at a time.
#[derive(Clone, Copy, Debug)]
pub struct EigenimageValues<'a> {
    table: &'a Table,
    components: usize,
}

impl<'a> EigenimageValues<'a> {
    /// Uses the first `components` components of the table, or all if it has fewer.
    #[must_use]
    pub fn new(table: &'a Table, components: usize) -> Self {
        Self { table, components: components.min(table.count()) }
    }

    /// Number of components.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components
    }

    /// Writes U_i of every component, then the mean image (0 if the table has none), at a unit
    /// normal with z >= 0. `values` must have room for the components and the mean.
    ///
    /// U_i = u_i(α) Φ_m(β). Error: the scene's `profile_tolerance` relative to the largest value of
    /// each profile.
    pub fn at(&self, [x, y, z]: [f64; 3], values: &mut [f64]) {
        let table = self.table;
        let (values, mean) = values.split_at_mut(self.components.min(values.len()));
        let mut previous = None;
        for (value, component) in values.iter_mut().zip(&table.components) {
            // +m and -m are adjacent and share h.
            let h = match previous {
                Some((profile, h)) if profile == component.profile => h,
                _ => profile::evaluate(&table.profiles[component.profile].chebyshev, z),
            };
            previous = Some((component.profile, h));
            *value = h * azimuth(component.order, x, y);
        }
        let of_mean = table.mean.as_ref();
        let of_mean = of_mean.map_or(0.0, |mean| profile::evaluate(&mean.chebyshev, z));
        mean.iter_mut().take(1).for_each(|mean| *mean = of_mean);
    }
}

/// sin^|m|(α) Φ_m(β) of the normal (x, y, ..): Re or -Im of (x + i y)^|m|, times √2
/// where m is not 0.
fn azimuth(order: i32, x: f64, y: f64) -> f64 {
    let (mut re, mut im) = (1.0, 0.0);
    for _ in 0..order.unsigned_abs() {
        (re, im) = (re * x - im * y, re * y + im * x);
    }
    match order {
        0 => 1.0,
        1.. => SQRT_2 * re,
        _ => -SQRT_2 * im,
    }
}
