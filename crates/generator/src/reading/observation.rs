//! The information in an image's pixels about its components, compressed to a few rows.
//!
//! Let E be the eigenimages at the pixels' normals, W the weights, m the mean image and I the
//! channels. Orthogonal transformations reduce √W (E m I) to no more rows than columns. Every
//! estimate and every residual by weighted least squares is the same from these rows as from the
//! pixels.

use super::eigenimage_values::EigenimageValues;
use super::reduction::Reduction;
use faer::{Col, ColRef, Mat};

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
    pub fn centred(&self, channel: usize) -> Col<f64> {
        self.channel(channel) - &self.mean
    }
}
