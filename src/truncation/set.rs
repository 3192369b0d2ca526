//! Several images for one loop over pixels: as many components, and polynomials as long.

use super::accounts::Accounts;
use super::report::{Tolerance, Truncation, larger, peak};
use super::terms::{Polynomials, trimmed};
use crate::basis::Basis;
use crate::checked_slice::rows_mut;
use crate::error::{Argument, Error};
use crate::float;
use crate::mathematics;
use crate::scene::{Scene, count};

/// The fraction of the squared tolerance reserved for components, a sixteenth. The rest is for
/// terms, because these are what a pixel costs.
const COMPONENTS: f32 = 0.0625;

/// One in `FLOOR` components, the last, estimates the table's error: see [`Truncation::floor`].
const FLOOR: usize = 5;

/// The common shape of several scenes: one loop over pixels draws all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shape<'l> {
    /// Number of components that suffice: see [`Truncation::components`].
    pub components: usize,
    /// Number of terms of the polynomials of azimuths |m| = 0, 1, ...
    pub lengths: &'l [u16],
}

impl<'l> Shape<'l> {
    /// Number of terms of all polynomials, of +m and of -m.
    #[must_use]
    pub fn terms(&self) -> usize {
        count(self.lengths)
    }

    /// Number of azimuths |m|, from 0 to the highest that has terms.
    #[must_use]
    pub fn azimuths(&self) -> usize {
        trimmed(self.lengths).len()
    }

    /// The scene of polynomials that were made in this shape. The irradiances are meaningless for
    /// any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are fewer numbers than [`terms`](Self::terms).
    pub fn scene<B: AsRef<[f32]>>(self, buffer: B) -> Result<Scene<'l, B>, Error> {
        let (expected, found) = (self.terms(), buffer.as_ref().len());
        let enough = expected.min(found);
        Error::check(Argument::Scene, expected, enough)?;
        Ok(Scene::of(self.lengths, buffer))
    }

    /// Completes the report of an image in this shape, converting squared errors into irradiances.
    fn settle(self, image: &[f32], report: &mut Truncation) {
        let (components, terms) = (report.left_out_by_components, report.left_out_by_terms);
        let floor = floor(image, report);
        let unit = report.unit();
        let irradiance = |square| mathematics::square_root(square) * unit;
        *report = Truncation {
            components: image.len().min(self.components),
            azimuths: self.azimuths(),
            terms: self.terms(),
            bound: irradiance(components + terms),
            left_out_by_components: irradiance(components),
            left_out_by_terms: irradiance(terms),
            floor: irradiance(floor),
            peak: report.peak,
        };
    }
}

impl<'a> Basis<'a> {
    /// Computes scenes of one shape, each within a tolerance of its image: for several materials
    /// under one light, for one material under several lights, or for the channels of a color.
    ///
    /// `images` holds a slice of coefficients for each image. Each run of `channels` consecutive
    /// images is one color, whose peak is the largest of its channels: use 3 for colors, or 1 to
    /// give each image its own peak. The error of each channel is at most the tolerance, and so is
    /// the root mean square over all channels.
    ///
    /// The polynomials of the k-th scene are written to the beginning of the k-th
    /// [`scene_len`](Self::scene_len) numbers of `buffer`, for [`Shape::scene`], and its cost and
    /// peak to the k-th of `reports`. The lengths are written to `lengths`, which needs room for
    /// [`azimuths`](Self::azimuths). The [`Shape`] has as many components as the most demanding
    /// image needs. No azimuth's polynomials can lose further terms, if a pixel would save by it,
    /// without some image exceeding its tolerance.
    ///
    /// Set-up cost: as [`collapse_within`](Self::collapse_within) for each image.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::truncation::{Truncation, Tolerance};
    /// use eigenshade::{Light, Material, Normal, sphere};
    ///
    /// let matte = Material::new(&[2.0])?;
    /// let of = |light: &[f32]| sphere::project(&Light::new(light)?, &matte);
    /// let color = [of(&[3.5, 0.0, 1.0, 0.0])?, of(&[3.0, 0.2, 1.0, 0.0])?, of(&[2.0; 4])?];
    /// let (mut lengths, mut report) = ([0; sphere::DEGREE + 1], [Truncation::default(); 3]);
    /// let mut buffer = [0.0; 3 * sphere::SCENE];
    /// let tolerance = Tolerance::OfPeak(1e-2);
    /// let basis = sphere::BASIS;
    /// let shape =
    ///     basis.collapse_set_within(&color, 3, tolerance, &mut lengths, &mut buffer, &mut report)?;
    /// for (numbers, report) in buffer.chunks_exact(sphere::SCENE).zip(report) {
    ///     let channel = shape.scene(numbers)?;
    ///     assert!(channel.shade(Normal::new(0.0, 0.0, 1.0)?) > 0.0 && report.bound < 1e-2 * report.peak);
    /// }
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The same as [`collapse_within`](Self::collapse_within), except that `buffer` must have
    /// [`scene_len`](Self::scene_len) numbers for each image; [`Error::Length`] unless the number
    /// of images is a multiple of `channels` and equals the number of `reports`.
    pub fn collapse_set_within<'l, C: AsRef<[f32]>>(
        &self,
        images: &[C],
        channels: usize,
        tolerance: Tolerance,
        lengths: &'l mut [u16],
        buffer: &mut [f32],
        reports: &mut [Truncation],
    ) -> Result<Shape<'l>, Error>
    where
        'a: 'l,
    {
        let (count, len) = (images.len(), self.scene_len());
        // No number of images is a whole number of colors without channels, not even 0.
        let whole = count.checked_next_multiple_of(channels).unwrap_or(usize::from(count == 0));
        Error::check(Argument::Images, whole, count)?;
        Error::check(Argument::Images, count, reports.len())?;
        Error::check(Argument::Scene, count.saturating_mul(len), buffer.len())?;
        // Check the tolerance even if there are no images.
        tolerance.irradiance(1.0)?;
        for (image, numbers, report) in each(images, buffer, len, reports) {
            let peak = peak(&self.collapse_into(image, numbers)?);
            *report = Truncation { peak, ..Truncation::default() };
        }
        for channels in rows_mut(reports, channels) {
            let peak = channels.iter().fold(0.0, |most, report| larger(most, report.peak));
            channels.iter_mut().for_each(|report| report.peak = peak);
        }
        let mut components = 0;
        for (image, _, report) in each(images, buffer, len, reports) {
            // Holds the square of the allowed error until the bound is known.
            report.bound = report.allowed(tolerance)?;
            components = components.max(needed(image, report));
        }
        for (image, _, report) in each(images, buffer, len, reports) {
            report.left_out_by_components = left_out(image, components, report);
        }
        let (polynomials, found) = (self.polynomials(), lengths.len());
        let expected = polynomials.lengths.len();
        let lengths = lengths.get_mut(..expected);
        let lengths =
            lengths.ok_or(Error::Length { argument: Argument::Lengths, expected, found })?;
        lengths.copy_from_slice(polynomials.lengths);
        Accounts { polynomials, numbers: buffer, len, reports }.truncate_azimuths(lengths);
        for (_, numbers, report) in each(images, buffer, len, reports) {
            polynomials.orthonormalize(lengths, numbers, report.scale());
        }
        Accounts { polynomials, numbers: buffer, len, reports }.truncate(lengths);
        let lengths = trimmed(lengths);
        let shape = Shape { components, lengths };
        for (image, numbers, report) in each(images, buffer, len, reports) {
            polynomials.restore(shape.lengths, numbers, report.unit());
            shape.settle(image, report);
        }
        Ok(shape)
    }

    /// Computes the scene of `coefficients` in a given shape, chosen earlier or for other images,
    /// and its cost. After [`collapse_into`](Self::collapse_into), everything that the shape lacks
    /// is left out in polynomials that are orthogonal over a sphere's normals. The result is
    /// therefore the nearest image with that number of terms.
    ///
    /// The polynomials of the scene are written to the beginning of `buffer`, of length
    /// [`scene_len`](Self::scene_len). Set-up cost: as [`collapse_within`](Self::collapse_within),
    /// without the choice of a shape.
    ///
    /// # Errors
    ///
    /// The same as [`collapse_into`](Self::collapse_into); [`Error::Length`] if the shape has more
    /// azimuths or terms than the basis, or fewer terms of a polynomial that
    /// [`collapse_within`](Self::collapse_within) keeps as it is.
    pub fn collapse_as<'l, B: AsMut<[f32]> + AsRef<[f32]>>(
        &self,
        coefficients: &[f32],
        shape: Shape<'l>,
        mut buffer: B,
    ) -> Result<(Scene<'l, B>, Truncation), Error>
    where
        'a: 'l,
    {
        let polynomials = self.polynomials();
        if !polynomials.can_become(shape.lengths) {
            let (expected, found) = (self.scene_len(), shape.terms());
            return Err(Error::Length { argument: Argument::Lengths, expected, found });
        }
        let numbers = buffer.as_mut();
        let peak = peak(&self.collapse_into(coefficients, &mut *numbers)?);
        let mut report = Truncation { peak, ..Truncation::default() };
        polynomials.orthonormalize(polynomials.lengths, numbers, report.scale());
        report.left_out_by_components = left_out(coefficients, shape.components, &report);
        report.left_out_by_terms = polynomials.left_out(shape.lengths, numbers);
        polynomials.restore(shape.lengths, numbers, report.unit());
        shape.settle(coefficients, &mut report);
        Ok((Scene::of(shape.lengths, buffer), report))
    }

    fn polynomials(&self) -> Polynomials<'a> {
        Polynomials { lengths: self.parts.lengths }
    }
}

fn each<'s, C: AsRef<[f32]>>(
    images: &'s [C],
    buffer: &'s mut [f32],
    len: usize,
    reports: &'s mut [Truncation],
) -> impl Iterator<Item = (&'s [f32], &'s mut [f32], &'s mut Truncation)> {
    let scenes = rows_mut(buffer, len).zip(reports);
    let images = images.iter().map(AsRef::as_ref);
    images.zip(scenes).map(|(image, (numbers, report))| (image, numbers, report))
}

/// The fewest components that keep the error within the share reserved for components.
fn needed(image: &[f32], report: &Truncation) -> usize {
    let (mut sum, scale) = (0.0, report.scale());
    let last = image.iter().rposition(|&d| {
        sum = float::add_product(sum, d * scale, d * scale);
        let within = sum <= COMPONENTS * report.bound;
        !within
    });
    last.map_or(0, |last| last + 1)
}

/// The squared error of the table, as estimated: see [`Truncation::floor`].
pub(super) fn floor(image: &[f32], report: &Truncation) -> f32 {
    left_out(image, image.len() - image.len().div_ceil(FLOOR), report)
}

/// The squared error if this many components are kept.
fn left_out(image: &[f32], components: usize, report: &Truncation) -> f32 {
    let scale = report.scale();
    let gone = image.iter().skip(components).map(|&d| d * scale);
    gone.fold(0.0, |sum, d| float::add_product(sum, d, d))
}
