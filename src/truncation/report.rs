//! The tolerance requested, the peak to which it is relative, and a report of the result.

use crate::error::Error;
use crate::float;
use crate::index::layout::LANES;
use crate::scene::Scene;
use crate::shade::{doubled, value, values};

/// The allowed error of an image, root mean square over a sphere's normals, relative to the image
/// of all components. The error of the components themselves is additional: see
/// [`Truncation::floor`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Tolerance {
    /// A share of white under an exposure, both above 0.
    OfWhite {
        /// The share of white.
        share: f32,
        /// The factor from irradiance to white: see [`Exposure::factor`](crate::screen::Exposure::factor).
        exposure: f32,
    },
    /// A fraction of the image's peak, above 0. For a channel of a color, a fraction of the largest
    /// peak of all channels. The peak of light with lamps is many times white.
    OfPeak(f32),
    /// An irradiance, above 0.
    Irradiance(f32),
}

/// The cost of a scene, and bounds on its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Truncation {
    /// Number of leading components that suffice: a scene made from these alone also stays within
    /// the bound. The scene itself uses all components, which costs a pixel nothing.
    pub components: usize,
    /// Number of azimuths |m|, from 0 to the highest that is left.
    pub azimuths: usize,
    /// Number of terms of all polynomials. A pixel costs one multiplication for each term except
    /// the first of each polynomial, and 4m - 2 for azimuths up to m.
    pub terms: usize,
    /// Upper bound on the difference from the image of all components, root mean square over a
    /// sphere's normals, apart from rounding. The square of `bound` is the sum of the squares of
    /// the next two fields.
    pub bound: f32,
    /// Upper bound on the part of the difference that comes from omitting the components beyond
    /// [`components`](Self::components).
    pub left_out_by_components: f32,
    /// The part of the difference that comes from the azimuths and terms that are left out.
    pub left_out_by_terms: f32,
    /// An estimate of the error of the image due to the table's limited number of components, root
    /// mean square over a sphere's normals: the root of the sum of the squares of the last fifth of
    /// the coefficients. A tolerance below the floor is met only relative to the image of all
    /// components.
    ///
    /// For unseen materials under the shipped lights, with the shipped table, the estimate matches
    /// the error in the median. For nine images in ten the estimate is within a factor of 1.6 for
    /// measured materials and of 3.1 for GGX, and for all images within a factor of 8.
    pub floor: f32,
    /// The largest of 41 pixels of the image, which is at most its peak. If the image is a channel
    /// of a color, the largest of all channels.
    pub peak: f32,
}

/// Slants at which the peak is sought, apart from the camera's direction, given by their cosines
/// and sines: one for each lane, and one where t is 0.
const SLANTS: [(f32, f32); LANES + 1] = [
    (0.92, 0.391_918_36),
    (0.75, 0.661_437_8),
    (0.25, 0.968_245_86),
    (0.0, 1.0),
    (0.5, 0.866_025_4),
];

/// The unit of an image that is black at the normals where its peak is sought.
const DARK: f32 = 1e-19;

/// The error of any image is less than this many of its units.
const MOST: f32 = 1e9;

impl Truncation {
    /// The unit of an image's numbers: its peak, so that no square is too small or too large.
    pub(super) fn unit(&self) -> f32 {
        match (self.peak.is_finite(), self.peak > 0.0 && self.peak.recip().is_finite()) {
            (true, true) => self.peak,
            (true, false) => DARK,
            (false, _) => 1.0,
        }
    }

    pub(super) fn scale(&self) -> f32 {
        self.unit().recip()
    }

    /// The allowed sum of squared errors of an image; finite, however dim the image is.
    pub(super) fn allowed(&self, tolerance: Tolerance) -> Result<f32, Error> {
        let (share, most) = (tolerance.irradiance(self.peak)? * self.scale(), MOST);
        let share = if share > most { most } else { share };
        Ok(share * share)
    }

    /// The part of the allowed sum of squared errors that is left.
    pub(super) fn left(&self) -> f32 {
        let left = self.bound - self.left_out_by_components - self.left_out_by_terms;
        if left > 0.0 { left } else { 0.0 }
    }
}

impl Tolerance {
    pub(super) fn irradiance(self, peak: f32) -> Result<f32, Error> {
        let (share, of) = match self {
            Self::OfPeak(share) => (share, peak),
            Self::OfWhite { share, exposure } if exposure > 0.0 && exposure.is_finite() => {
                (share, exposure.recip())
            }
            Self::OfWhite { .. } => return Err(Error::Tolerance),
            Self::Irradiance(irradiance) => (irradiance, 1.0),
        };
        // A peak that is not finite has no fraction, and no comparison with it holds, so nothing is
        // left out.
        let of = if of.is_finite() { of } else { of * 0.0 };
        if share > 0.0 && share.is_finite() { Ok(share * of) } else { Err(Error::Tolerance) }
    }
}

/// The largest |I| at 41 normals: the one toward the camera, and eight azimuths for each slant. The
/// azimuths m and m + 8 agree at these normals, so each slant evaluates its polynomials once.
pub(super) fn peak<B: AsRef<[f32]>>(scene: &Scene<'_, B>) -> f32 {
    let [lanes @ .., _] = SLANTS;
    let t = lanes.map(|(z, _)| z + z - 1.0);
    let sines = SLANTS.map(|(_, sine)| sine);
    let mut power = [1.0; SLANTS.len()];
    // Sums of the factors of cos mβ and sin mβ, for m = 0 to 4.
    let mut sums = [[[0.0; 2]; SLANTS.len()]; 5];
    let mut most = 0.0;
    for (azimuth, (plus, minus)) in scene.azimuths().enumerate() {
        if plus.is_empty() {
            power.iter_mut().zip(&sines).for_each(|(power, &of_slant)| *power *= of_slant);
            continue;
        }
        // m = 0 has no sin mβ.
        let minus = if azimuth == 0 { plus } else { minus };
        if azimuth == 0 {
            most = size(value(plus, 1.0));
        }
        let [plus, minus] = [plus, minus].map(|terms| {
            let [a, b, c, d] = slants(terms, &t);
            [a, b, c, d, value(terms, 0.0)]
        });
        let (turns, sign) = match azimuth % 8 {
            turns @ 0..=4 => (turns, 1.0),
            turns => (8 - turns, -1.0),
        };
        let Some(sums) = sums.get_mut(turns) else { continue };
        let of_slants = plus.iter().zip(&minus).zip(power.iter_mut().zip(&sines));
        for ([cosine, sine], ((&plus, &minus), (power, &of_slant))) in
            sums.iter_mut().zip(of_slants)
        {
            *cosine = float::add_product(*cosine, plus, *power);
            *sine = float::add_product(*sine, sign * minus, *power);
            *power *= of_slant;
        }
    }
    let diagonal = core::f32::consts::FRAC_1_SQRT_2;
    let [zero, one, two, three, four] = sums;
    let of_slants = zero.iter().zip(&one).zip(two.iter().zip(&three)).zip(&four);
    of_slants.fold(most, |most, (((zero, one), (two, three)), four)| {
        let ([all, unseen], [half, also]) = (*zero, *four);
        // sin 4β is 0 at all of them, but a number that is not finite counts.
        let most = larger(most, 0.0 * (unseen + also));
        // The values at β and at β + π are the sum and the difference of these.
        let same =
            [all + half + two[0], all - half + two[1], all + half - two[0], all - half - two[1]];
        let opposite = [
            one[0] + three[0],
            diagonal * ((one[0] - three[0]) + (one[1] + three[1])),
            one[1] - three[1],
            diagonal * ((three[0] - one[0]) + (one[1] + three[1])),
        ];
        let both = same.into_iter().zip(opposite);
        both.fold(most, |most, (same, opposite)| larger(most, size(same) + size(opposite)))
    })
}

/// The values of a polynomial at the slants of the lanes. Not inlined: with t known, the compiler
/// would treat each lane separately.
#[inline(never)]
fn slants(terms: &[f32], t: &[f32; LANES]) -> [f32; LANES] {
    values(terms, [t, &t.map(doubled)])
}

/// The larger of two numbers; a number that is not finite is kept.
pub(super) fn larger(most: f32, one: f32) -> f32 {
    let more = !one.is_finite() || one > most;
    if most.is_finite() && more { one } else { most }
}

fn size(value: f32) -> f32 {
    if value < 0.0 { -value } else { value }
}
