//! The number of sources of a light and the terms of its harmonics, chosen together.

use super::report::{Tolerance, Truncation, larger, peak};
use super::set::{Shape, floor};
use crate::basis::Basis;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::gloss::Gloss;
use crate::index::highlights::PRODUCTS;
use crate::lanes::{rows, rows_mut};
use crate::mathematics::{Libm, Mathematics};
use crate::scalar::Scalar;
use crate::scene::Scene;
use crate::source::Source;
use crate::source_set::SourceSet;

/// The least share of the squared tolerance that a set leaves to terms. With less, rounding would
/// decide what they may lose.
const LEAST: f64 = 1e-4;

/// The scenes of a glossy material in three channels, and the sources to be added: see
/// [`Basis::collapse_sources_within`].
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GlossyScenes<'l, 'b, 's, S> {
    /// The scenes of the light without the sources.
    pub scenes: Rgb<Scene<'l, &'b [S]>>,
    /// The shape of the scenes. With [`Basis::collapse_as`] it serves the light after a rotation,
    /// too: turn the residual and the sources.
    pub shape: Shape<'l>,
    /// The sources, for [`Highlights`](crate::Highlights).
    pub sources: &'s [Source<S>],
    /// The cost of each scene, and its bound against the scene of all terms.
    pub reports: Rgb<Truncation<S>>,
    /// The largest of 41 pixels of the picture without sources, in which highlights are dim: at
    /// most the true peak.
    pub peak: S,
    /// An estimate of the error against the whole light, without degree or order: root mean square
    /// over normals and channels, relative to the peak.
    ///
    /// The true error of metals under five shipped lights, with the shipped table and tolerances of
    /// 1 to 5 %, is at most 1.2 times this, and less than 0.8 times in the median.
    pub error: S,
    /// Whether the error is within the tolerance; false if all sets of sources leave more.
    pub is_within: bool,
}

/// Sources, the square of the error of them and the table, and the tolerance of the terms.
#[derive(Clone, Copy)]
struct Chosen<'s, S> {
    sources: &'s [Source<S>],
    error: S,
    of_terms: Tolerance<S>,
}

impl<'a, S: Scalar> Basis<'a, S> {
    /// Computes the scenes of a glossy material in three channels under a light with small sources,
    /// within a tolerance of the picture under the whole light. The number of sources and the terms
    /// are chosen together: the fewest multiply-adds for a pixel, a source counted as
    /// [`PRODUCTS`](crate::index::highlights::PRODUCTS). To keep a table's own loop over all terms,
    /// choose by [`SourceSet::within`] instead.
    ///
    /// `sets` are those of the light, such as `presets::sources::STUDIO`, in order of their number
    /// of sources; the first may have none. `project` gives the coefficients of each channel under
    /// the light without the given sources, of which there may be none.
    ///
    /// The error has three parts, whose squares are added: that of the set
    /// ([`SourceSet::error`]), that of the table ([`Truncation::floor`]) and that of the terms left
    /// out. A set with a smaller error thus needs fewer terms. The scenes also keep the tolerance
    /// by themselves, without the sources; otherwise the surface beside a bright highlight could be
    /// black. If the error of every set exceeds the tolerance, the set with the least is taken. A
    /// material that [needs no sources](Gloss::needs_sources) gets the first set.
    ///
    /// `buffer` needs room for three scenes, each of [`scene_len`](Self::scene_len), and `lengths`
    /// for [`azimuths`](Self::azimuths).
    ///
    /// Set-up cost: `project` is called without sources, then for each set that is tried, and again
    /// for the chosen one. Each set takes three calls of
    /// [`collapse_within`](Self::collapse_within). Most of it is the residual of the larger sets: each
    /// source takes longer than a projection.
    ///
    /// ```
    /// # #[cfg(all(feature = "baked", feature = "presets"))] {
    /// use eigenshade::mathematics::SinglePrecision;
    /// use eigenshade::presets::{gloss, light::STUDIO, material::GOLD_METALLIC_PAINT, sources};
    /// use eigenshade::{Highlights, Normal, Tolerance, sphere};
    ///
    /// let transfer = sphere::color::transfer(GOLD_METALLIC_PAINT)?;
    /// let project = |sources: &[_]| {
    ///     let rest = STUDIO.residual::<SinglePrecision, { sphere::LIGHT }>(sources)?;
    ///     let channels = rest.lights()?.zip(transfer.each_ref());
    ///     channels.try_map(|(light, transfer)| sphere::relight(transfer, &light))
    /// };
    /// let (sets, gold) = (&sources::STUDIO, &gloss::GOLD_METALLIC_PAINT);
    /// let tolerance = Tolerance::OfPeak(0.02);
    /// let (mut lengths, mut buffer) = ([0; sphere::DEGREE + 1], [0.0; 3 * sphere::SCENE]);
    /// let chosen = sphere::BASIS
    ///     .collapse_sources_within(sets, gold, tolerance, project, &mut lengths, &mut buffer)?;
    ///
    /// assert!(chosen.is_within && chosen.sources.len() <= 2);
    /// assert!(chosen.shape.terms() < sphere::SCENE / 2);
    /// let highlights = Highlights::<f32, 16>::new::<SinglePrecision>(gold, chosen.sources)?;
    /// let normal = Normal::new(0.0, 0.0, 1.0)?;
    /// let color = chosen.scenes.map(|scene| scene.shade(normal)) + highlights.shade(normal);
    /// assert!(color.r > color.b);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`collapse_set_within`](Self::collapse_set_within) and of `project`;
    /// [`Error::Tolerance`] for an irradiance, as the errors of sets are relative to the peak;
    /// [`Error::Length`] if there are no sets.
    pub fn collapse_sources_within<'l, 'b, 's, C: AsRef<[S]>>(
        &self,
        sets: &[SourceSet<'s, S>],
        gloss: &Gloss<S>,
        tolerance: Tolerance<S>,
        project: impl Fn(&[Source<S>]) -> Result<Rgb<C>, Error>,
        lengths: &'l mut [u16],
        buffer: &'b mut [S],
    ) -> Result<GlossyScenes<'l, 'b, 's, S>, Error>
    where
        'a: 'l,
    {
        let sets = if gloss.needs_sources() { sets } else { sets.get(..1).unwrap_or(sets) };
        let (count, len) = (3, self.scene_len());
        Error::check(Argument::Scene, count * len, buffer.len())?;
        if matches!(tolerance, Tolerance::Irradiance(_)) {
            return Err(Error::Tolerance);
        }
        let all: [C; 3] = project(&[])?.into();
        let whole = Truncation { peak: self.peak_of(&all, buffer)?, ..Truncation::default() };
        // Squares in units of the peak.
        let allowed = whole.allowed(tolerance)?;
        let mut reports = [Truncation::default(); 3];
        let (mut nearest, mut best) = (None, None);
        for set in sets {
            let of_sources = PRODUCTS * set.sources().len();
            let least = best.map_or(usize::MAX, |(products, _)| products);
            if of_sources >= least {
                continue;
            }
            let rest: [C; 3];
            let images = if set.sources().is_empty() {
                &all
            } else {
                rest = project(set.sources())?.into();
                &rest
            };
            let error = set.error(gloss) * whole.peak * whole.scale();
            let of_table = mean(images.each_ref().map(|image| floor(image.as_ref(), &whole)));
            let error = of_table.add_product(error, error);
            let chosen = Chosen { sources: set.sources(), error, of_terms: tolerance };
            if nearest.is_none_or(|one: Chosen<'s, S>| error < one.error || !one.error.is_finite())
            {
                nearest = Some(chosen);
            }
            let rest = allowed - error;
            let is_near = rest > S::from_f64(LEAST) * allowed;
            if !is_near {
                continue;
            }
            let rest = Libm::square_root(rest) * whole.unit();
            let of_own = tolerance.irradiance(self.peak_of(images, buffer)?)?;
            let of_terms = if rest < of_own { Tolerance::Irradiance(rest) } else { tolerance };
            let shape =
                self.collapse_set_within(images, count, of_terms, lengths, buffer, &mut reports)?;
            let products = of_sources + count * shape.terms();
            if products < least {
                best = Some((products, Chosen { of_terms, ..chosen }));
            }
        }
        let none = Error::Length { argument: Argument::Sources, expected: 1, found: 0 };
        let is_within = best.is_some();
        let chosen = best.map(|(_, chosen)| chosen).or(nearest).ok_or(none)?;
        let Chosen { sources, error, of_terms } = chosen;
        let images: [C; 3] = project(sources)?.into();
        let shape =
            self.collapse_set_within(&images, count, of_terms, lengths, buffer, &mut reports)?;
        let left_out = mean(reports.map(|report| {
            let bound = report.bound * whole.scale();
            bound * bound
        }));
        let mut scenes = rows(&*buffer, len).map(|numbers| shape.scene(numbers));
        let mut scene = || scenes.next().unwrap_or_else(|| shape.scene(&[][..]));
        Ok(GlossyScenes {
            scenes: Rgb::new(scene()?, scene()?, scene()?),
            shape,
            sources,
            reports: reports.into(),
            peak: whole.peak,
            is_within,
            error: Libm::square_root(error + left_out),
        })
    }

    /// The largest peak of three images, whose scenes are written to `buffer`.
    fn peak_of<C: AsRef<[S]>>(&self, images: &[C; 3], buffer: &mut [S]) -> Result<S, Error> {
        let mut scenes = images.iter().zip(rows_mut(buffer, self.scene_len()));
        scenes.try_fold(S::ZERO, |most, (image, numbers)| {
            Ok(larger(most, peak(&self.collapse_into(image.as_ref(), numbers)?)))
        })
    }
}

fn mean<S: Scalar>([r, g, b]: [S; 3]) -> S {
    (r + g + b) * S::from_f64(1.0 / 3.0)
}
