//! Several images for one loop over pixels: the same number of components, and polynomials of the
//! same lengths.

use super::accounts::Accounts;
use super::report::{Tolerance, Truncation};
use super::report::{larger, peak};
use super::terms::Polynomials;
use crate::basis::Basis;
use crate::error::{Argument, Error};
use crate::mathematics::{Libm, Mathematics};
use crate::recurrences::Recurrences;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// The fraction of the squared tolerance reserved for components, a sixteenth. The rest is for
/// terms, because these are what a pixel costs.
const COMPONENTS: f64 = 0.0625;

/// The last fifth of the components (one in `FLOOR`) estimates the error of the table: see
/// [`Truncation::floor`].
const FLOOR: usize = 5;

/// The common shape of several scenes. A loop over pixels written for one of them serves all.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shape<'l> {
    /// Number of components that suffice: see [`Truncation::components`].
    pub components: usize,
    /// Number of terms of the polynomials of azimuths |m| = 0, 1, ...
    pub lengths: &'l [u16],
    /// The recurrences of the basis.
    pub recurrences: Recurrences<'l>,
}

impl<'l> Shape<'l> {
    /// Number of terms of all polynomials, of +m and of -m.
    #[must_use]
    pub fn terms(&self) -> usize {
        let both = self.lengths.iter().map(|&length| 2 * usize::from(length)).sum::<usize>();
        both - self.lengths.first().map_or(0, |&length| usize::from(length))
    }

    /// Number of azimuths |m|, from 0 to the highest that has terms.
    #[must_use]
    pub fn azimuths(&self) -> usize {
        self.lengths.iter().rposition(|&length| length > 0).map_or(0, |last| last + 1)
    }

    /// The scene of polynomials that were made in this shape. The irradiances are meaningless for
    /// any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are fewer numbers than [`terms`](Self::terms).
    pub fn scene<S: Scalar, B: AsRef<[S]>>(self, buffer: B) -> Result<Scene<'l, B>, Error> {
        let (expected, found) = (self.terms(), buffer.as_ref().len());
        let enough = expected.min(found);
        Error::check(Argument::Scene, expected, enough)?;
        Ok(Scene::of(self.lengths, self.recurrences, buffer))
    }
}

impl<'a, S: Scalar> Basis<'a, S> {
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
    /// Set-up cost: that of [`collapse_within`](Self::collapse_within) for each image.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Truncation, Light, Material, Normal, Tolerance, sphere};
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
    /// of images is a multiple of `channels` and equals that of `reports`.
    pub fn collapse_set_within<'l, C: AsRef<[S]>>(
        &self,
        images: &[C],
        channels: usize,
        tolerance: Tolerance<S>,
        lengths: &'l mut [u16],
        buffer: &mut [S],
        reports: &mut [Truncation<S>],
    ) -> Result<Shape<'l>, Error>
    where
        'a: 'l,
    {
        let (count, len) = (images.len(), self.scene_len());
        let whole = count.checked_next_multiple_of(channels).unwrap_or_default();
        Error::check(Argument::Images, whole, count)?;
        Error::check(Argument::Images, count, reports.len())?;
        Error::check(Argument::Scene, count.saturating_mul(len), buffer.len())?;
        // Check the tolerance even if there are no images.
        tolerance.irradiance(S::ONE)?;
        reports.fill(Truncation::default());
        for (image, numbers, report) in each(images, buffer, len, reports) {
            report.peak = peak(&self.collapse_into(image, numbers)?);
        }
        for channels in reports.chunks_exact_mut(channels.max(1)) {
            let peaks = channels.iter().map(|report| report.peak);
            let peak = peaks.fold(S::ZERO, larger);
            channels.iter_mut().for_each(|report| report.peak = peak);
        }
        let mut components = 0;
        for (image, _, report) in each(images, buffer, len, reports) {
            let account = Account::new(report.peak);
            // Holds the square of the allowed error until the bound is known.
            report.bound = account.allowed(tolerance.irradiance(report.peak)?);
            components = components.max(account.components(image, report.bound));
        }
        let (polynomials, found) = (self.polynomials(), lengths.len());
        let expected = polynomials.lengths.len();
        let lengths = lengths.get_mut(..expected);
        let lengths =
            lengths.ok_or(Error::Length { argument: Argument::Lengths, expected, found })?;
        lengths.copy_from_slice(polynomials.lengths);
        for (image, _, report) in each(images, buffer, len, reports) {
            let account = Account::new(report.peak);
            report.left_out_by_components = account.spent(image, components);
        }
        let scale = |report: &Truncation<S>| Account::new(report.peak).scale;
        Accounts { polynomials, numbers: buffer, len, report: reports }
            .truncate_azimuths(lengths, scale);
        for (_, numbers, report) in each(images, buffer, len, reports) {
            polynomials.orthonormalize(lengths, numbers, scale(report));
        }
        Accounts { polynomials, numbers: buffer, len, report: reports }.truncate(lengths);
        let lengths = &*lengths;
        let shape = Shape { components, lengths, recurrences: self.recurrences };
        let lengths = lengths.get(..shape.azimuths()).unwrap_or_default();
        let shape = Shape { lengths, ..shape };
        for (image, numbers, report) in each(images, buffer, len, reports) {
            let account = Account::new(report.peak);
            polynomials.restore(shape.lengths, numbers, account.unit);
            account.settle(image, shape, report);
        }
        Ok(shape)
    }

    /// Computes the scene of `coefficients` in a given shape, chosen earlier or for other images,
    /// and its cost. After [`collapse_into`](Self::collapse_into), everything that the shape lacks
    /// is left out in polynomials that are orthogonal over a sphere's normals. The result is
    /// therefore the nearest image with that number of terms.
    ///
    /// The polynomials of the scene are written to the beginning of `buffer`, of length
    /// [`scene_len`](Self::scene_len). Set-up cost: that of
    /// [`collapse_within`](Self::collapse_within) without choosing a shape.
    ///
    /// # Errors
    ///
    /// The same as [`collapse_into`](Self::collapse_into); [`Error::Length`] if the shape has more
    /// azimuths or terms than the basis, or fewer terms of a polynomial that
    /// [`collapse_within`](Self::collapse_within) keeps as it is.
    pub fn collapse_as<'l, B: AsMut<[S]> + AsRef<[S]>>(
        &self,
        coefficients: &[S],
        shape: Shape<'l>,
        buffer: B,
    ) -> Result<(Scene<'l, B>, Truncation<S>), Error>
    where
        'a: 'l,
    {
        let polynomials = self.polynomials();
        if !polynomials.can_become(shape.lengths) {
            let (expected, found) = (self.scene_len(), shape.terms());
            return Err(Error::Length { argument: Argument::Lengths, expected, found });
        }
        let scene = self.collapse_into(coefficients, buffer)?;
        let mut report = Truncation { peak: peak(&scene), ..Truncation::default() };
        let mut buffer = scene.into_buffer();
        let numbers = buffer.as_mut();
        let account = Account::new(report.peak);
        polynomials.orthonormalize(polynomials.lengths, numbers, account.scale);
        report.left_out_by_components = account.spent(coefficients, shape.components);
        report.left_out_by_terms = polynomials.left_out(shape.lengths, numbers);
        polynomials.restore(shape.lengths, numbers, account.unit);
        account.settle(coefficients, shape, &mut report);
        Ok((Scene::of(shape.lengths, shape.recurrences, buffer), report))
    }

    fn polynomials(&self) -> Polynomials<'a> {
        Polynomials { lengths: self.parts.lengths, recurrences: self.recurrences }
    }
}

/// Each image with its scene and its report.
fn each<'s, S, C: AsRef<[S]>>(
    images: &'s [C],
    buffer: &'s mut [S],
    len: usize,
    reports: &'s mut [Truncation<S>],
) -> impl Iterator<Item = (&'s [S], &'s mut [S], &'s mut Truncation<S>)> {
    let scenes = buffer.chunks_exact_mut(len.max(1)).zip(reports);
    let images = images.iter().map(AsRef::as_ref);
    images.zip(scenes).map(|(image, (numbers, report))| (image, numbers, report))
}

/// The unit of an image's numbers: its peak, so that no square is too small or too large.
#[derive(Clone, Copy)]
struct Account<S> {
    unit: S,
    /// 1 / unit.
    scale: S,
}

/// The unit of an image that is black at the normals where its peak is sought.
const DARK: f64 = 1e-19;

/// The error of any image is less than this many of its units.
const MOST: f64 = 1e9;

impl<S: Scalar> Account<S> {
    fn new(peak: S) -> Self {
        let (dark, scale) = (S::from_f64(DARK), peak.reciprocal());
        match (peak.is_finite(), peak > S::ZERO && scale.is_finite()) {
            (true, true) => Self { unit: peak, scale },
            (true, false) => Self { unit: dark, scale: dark.reciprocal() },
            (false, _) => Self { unit: S::ONE, scale: S::ONE },
        }
    }

    /// The allowed sum of squared errors of an image; finite, however dim the image is.
    fn allowed(&self, tolerance: S) -> S {
        let (share, most) = (tolerance * self.scale, S::from_f64(MOST));
        let share = if share > most { most } else { share };
        share * share
    }

    /// The fewest components that keep the error within the share reserved for components.
    fn components(&self, image: &[S], allowed: S) -> usize {
        let mut sum = S::ZERO;
        let last = image.iter().rposition(|&d| {
            sum = sum.add_product(d * self.scale, d * self.scale);
            let within = sum <= S::from_f64(COMPONENTS) * allowed;
            !within
        });
        last.map_or(0, |last| last + 1)
    }

    /// The squared error if this many components are kept.
    fn spent(&self, image: &[S], components: usize) -> S {
        let gone = image.iter().skip(components).map(|&d| d * self.scale);
        gone.fold(S::ZERO, |sum, d| sum.add_product(d, d))
    }

    /// Completes a report, converting squared errors into irradiances.
    fn settle(&self, image: &[S], shape: Shape<'_>, report: &mut Truncation<S>) {
        let (components, terms) = (report.left_out_by_components, report.left_out_by_terms);
        let irradiance = |square| Libm::square_root(square) * self.unit;
        report.components = image.len().min(shape.components);
        report.azimuths = shape.azimuths();
        report.terms = shape.terms();
        report.left_out_by_components = irradiance(components);
        report.left_out_by_terms = irradiance(terms);
        report.bound = irradiance(components + terms);
        report.floor = irradiance(self.spent(image, image.len() - image.len().div_ceil(FLOOR)));
    }
}
