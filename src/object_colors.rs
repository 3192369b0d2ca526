//! The colors of the codes of an object with shadows.

use crate::color::Rgb;
use crate::display::{Display, Exposure, Linear, NEAREST};
use crate::error::{Argument, Error};
use crate::index::shadowed::MOST_IMAGES;
use crate::object_coefficients::ObjectCoefficients;
use crate::pixel::Pixel;
use crate::q15;
use crate::shadowed::ShadowedObject;

/// Bits of an exposed irradiance after the binary point.
const POINT: i32 = 20;
/// The largest mean and the largest image: a mean and [`MOST_IMAGES`] images times -128 fit an `i32`.
const MEAN: i64 = 1 << 28;
const IMAGE: i64 = 1 << 19;

impl ShadowedObject<'_> {
    /// Exposes the irradiance of each code and calls a function with it, in the order of the codes. Up
    /// to white it is within 1e-3 of the sum of the file's numbers, unless addends far above white
    /// cancel.
    ///
    /// Cost: for each code, K products a channel; for each of the clusters, (K + 1) r products a
    /// channel.
    pub fn shade(
        &self,
        d: &Rgb<ObjectCoefficients>,
        exposure: Exposure,
        mut with: impl FnMut(Rgb<Linear>),
    ) {
        let mut rest = self.clusters;
        while let Some((cluster, after)) = Cluster::split(rest, self.rank, self.images) {
            rest = after;
            let shown = Shown::new(&cluster, d, exposure);
            if self.images == 0 {
                (0..cluster.codes).for_each(|_| with(shown.color(&[])));
                continue;
            }
            for weights in cluster.weights.chunks_exact(self.images) {
                with(shown.color(weights));
            }
        }
    }

    /// The colors of all codes on a display.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are as many colors as codes.
    pub fn colors<P: Pixel>(
        &self,
        d: &Rgb<ObjectCoefficients>,
        exposure: Exposure,
        display: &Display,
        colors: &mut [P],
    ) -> Result<(), Error> {
        Error::check(Argument::Colors, self.codes(), colors.len())?;
        let mut colors = colors.iter_mut();
        self.shade(d, exposure, |color| {
            if let Some(to) = colors.next() {
                *to = P::of_display(color.map(|channel| display.encode(channel)), NEAREST);
            }
        });
        Ok(())
    }
}

/// A cluster of a file.
struct Cluster<'a> {
    codes: usize,
    /// Of the mean, then of the images.
    exponents: &'a [u8],
    mean: &'a [[u8; 2]],
    images: &'a [u8],
    weights: &'a [u8],
}

impl<'a> Cluster<'a> {
    fn split(bytes: &'a [u8], rank: usize, images: usize) -> Option<(Self, &'a [u8])> {
        let (&codes, rest) = bytes.split_first_chunk()?;
        let codes = usize::from(u16::from_le_bytes(codes));
        let (exponents, rest) = rest.split_at_checked(1 + images)?;
        let (mean, rest) = rest.split_at_checked(2 * rank)?;
        let (of_images, rest) = rest.split_at_checked(images * rank)?;
        let (weights, rest) = rest.split_at_checked(images * codes)?;
        let mean = mean.as_chunks().0;
        Some((Self { codes, exponents, mean, images: of_images, weights }, rest))
    }
}

/// The exposed irradiances of a cluster's mean and of its images, in units of 2^-20 of white.
struct Shown {
    mean: [i32; 3],
    images: [[i32; 3]; MOST_IMAGES],
}

impl Shown {
    fn new(cluster: &Cluster<'_>, d: &Rgb<ObjectCoefficients>, exposure: Exposure) -> Self {
        let channels = <[_; 3]>::from(d.each_ref());
        let mut exponents = cluster.exponents.iter().map(|one| i32::from(one.cast_signed()));
        let exposed = |sum: i64, exponent: i32, most: i64| {
            let exposure = q15::Exposure::of_float(exposure, exponent + POINT - 16);
            exposure.signed(sum).min(most).max(-most) as i32
        };
        let (of_mean, mut shown) = (
            exponents.next().unwrap_or_default(),
            Self { mean: [0; 3], images: [[0; 3]; MOST_IMAGES] },
        );
        for (to, d) in shown.mean.iter_mut().zip(channels) {
            let products = cluster.mean.iter().zip(&d.mantissas);
            let sum = products
                .map(|(q, &one)| i64::from(i32::from(i16::from_le_bytes(*q)) * i32::from(one)))
                .sum();
            *to = exposed(sum, of_mean + d.exponent, MEAN);
        }
        let rank = cluster.mean.len().max(1);
        let images = cluster.images.chunks_exact(rank).zip(exponents);
        for ((image, exponent), to) in images.zip(&mut shown.images) {
            for (to, d) in to.iter_mut().zip(channels) {
                let sum = product(image, &d.mantissas);
                *to = exposed(i64::from(sum), exponent + d.exponent, IMAGE);
            }
        }
        shown
    }

    /// The color of a code with these weights.
    #[inline(always)]
    fn color(&self, weights: &[u8]) -> Rgb<Linear> {
        let mut sums = self.mean;
        for (image, weight) in self.images.iter().zip(weights) {
            let weight = i32::from(weight.cast_signed());
            for (sum, image) in sums.iter_mut().zip(image) {
                *sum += weight * image;
            }
        }
        Rgb::from(sums).map(|sum| Linear((sum.max(0) >> (POINT - 16)).cast_unsigned()))
    }
}

/// At most 2^7 x 2^15 x 100.
#[inline(never)]
fn product(image: &[u8], mantissas: &[i16]) -> i32 {
    image.iter().zip(mantissas).map(|(q, &one)| i32::from(q.cast_signed()) * i32::from(one)).sum()
}
