//! A table in integers: mantissas of 15 or 31 bits, a power of two for each row.
//!
//! Rounding is to nearest, ties away from zero. A row of factors is scaled so that no
//! sum over it, of products with mantissas, can leave an accumulator of twice as many
//! bits and one: Σ |mantissa| < 2^(bits + 1).

use crate::parts::NONE;
use crate::polynomials::polynomial;
use crate::table::{Profile, Table};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::{layout, material, pair};
use serde::{Deserialize, Serialize};
use std::fmt;

/// An integer format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// 15 bits and a sign.
    Q15,
    /// 31 bits and a sign.
    Q31,
}

impl Format {
    /// Bits of a mantissa's size.
    #[must_use]
    pub const fn bits(self) -> i32 {
        match self {
            Self::Q15 => 15,
            Self::Q31 => 31,
        }
    }

    /// Its name on a command line, and of its module.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Q15 => "q15",
            Self::Q31 => "q31",
        }
    }

    /// What the polynomials of this format may leave out, of the database's rms: less
    /// than what the format's rounding costs.
    #[must_use]
    pub const fn tolerance(self) -> f64 {
        match self {
            Self::Q15 => 1e-5,
            Self::Q31 => 1e-8,
        }
    }
}

/// The runtime's arrays in integers; each field is the one of the same name in
/// `eigenshade::quantised::Parts`.
#[derive(Clone, Debug, PartialEq)]
pub struct QuantisedParts {
    /// The format.
    pub format: Format,
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// The effects that it is for.
    pub effects: Effects,
    /// Number of components.
    pub components: usize,
    /// Slant profiles, by |m|.
    pub profiles: Vec<Place>,
    /// Number of polynomial terms for each |m|.
    pub lengths: Vec<u8>,
    /// Polar integrals: for each l a row over the pairs.
    pub polar: Vec<i32>,
    /// An exponent for each of them.
    pub polar_exponents: Vec<i8>,
    /// Factors: for each profile, each l, a row over the pairs.
    pub factors: Vec<i32>,
    /// An exponent for each row.
    pub factor_exponents: Vec<i8>,
    /// Polynomials in powers of t, highest first.
    pub terms: Vec<i32>,
}

/// A profile's azimuth, the exponent of its terms, and its components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// |m|.
    pub azimuth: u8,
    /// Of its terms.
    pub exponent: i8,
    /// Component of +m (or 0), or 65,535.
    pub plus: u16,
    /// Component of -m, or 65,535.
    pub minus: u16,
    /// Its largest value, in sixteenths, rounded up.
    pub size: u16,
    /// Its polynomial's largest term or step of Horner's rule on the way there.
    pub step: u16,
}

/// The most profiles, and degrees, of `eigenshade::quantised::Basis`.
const MOST_PROFILES: usize = layout::MOST_WEIGHTS / 2;

/// Why a table has no integer form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum QuantiseError {
    /// It is of the criterion that subtracts a mean image.
    Mean,
    /// It keeps a selection of modes.
    Selection,
    /// Its object is not a sphere.
    General,
    /// It keeps transfers alone.
    Folded,
    /// Its effect ambient takes orders that no other of its effects does.
    Apart,
    /// A polynomial is longer than [`layout::POWERS`].
    Long {
        /// Its |m|.
        azimuth: usize,
        /// Its number of terms.
        terms: usize,
    },
    /// It has more profiles or degrees than the runtime's sums have room for.
    Many,
    /// A profile, a term of its polynomial or a step of it exceeds 4,095.
    Large {
        /// Its |m|.
        azimuth: usize,
    },
}

impl fmt::Display for QuantiseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mean => f.write_str(
                "integers take no mean image; make the table with criterion = \"image-centered\"",
            ),
            Self::Selection => {
                f.write_str("integers take no selection of modes; make the table with modes = 0")
            }
            Self::General => f.write_str("integers take the sphere's tables alone"),
            Self::Folded => {
                f.write_str("the table keeps transfers alone; make it with store = \"projection\"")
            }
            Self::Apart => f.write_str(
                "integers take ambient only where another effect takes all its orders; make the \
                 table without ambient, with gloss, or with a lower material.order",
            ),
            Self::Long { azimuth, terms } => write!(
                f,
                "a polynomial of |m| = {azimuth} has {terms} terms, integers take {}; make the \
                 table with a larger profile_tolerance or a lower degree",
                layout::POWERS
            ),
            Self::Many => write!(
                f,
                "integers take at most {MOST_PROFILES} profiles and degrees below that; make the \
                 table with fewer components or a lower degree"
            ),
            Self::Large { azimuth } => write!(
                f,
                "a profile of |m| = {azimuth} is beyond 4095; make the table with fewer components \
                 or a lower degree"
            ),
        }
    }
}

impl std::error::Error for QuantiseError {}

impl QuantisedParts {
    /// A table in this format, its polynomials trimmed so that of each component no
    /// more than `tolerance` is left out (of the rms of the database's images, which the
    /// eigenvalues tell).
    ///
    /// # Errors
    ///
    /// A table that integers do not serve.
    pub fn new(table: &Table, format: Format, tolerance: f64) -> Result<Self, QuantiseError> {
        for (fault, error) in [
            (table.mean.is_some(), QuantiseError::Mean),
            (!table.selection.is_empty(), QuantiseError::Selection),
            (table.general.is_some(), QuantiseError::General),
            (!table.has_projection(), QuantiseError::Folded),
            (table.effects().apart_count(table.gram.order) > 0, QuantiseError::Apart),
            (table.profiles.len().max(table.gram.degree + 1) > MOST_PROFILES, QuantiseError::Many),
        ] {
            if fault {
                return Err(error);
            }
        }
        let (gram, effects) = (&table.gram, table.effects());
        let (degree, order) = (gram.degree, gram.order);
        let pairs = pair::count(order);
        let bits = format.bits();
        let lengths = lengths(table, tolerance)?;
        let (mut polar, mut polar_exponents) = (Vec::new(), Vec::new());
        for l in 0..=degree {
            for (k, (o, _)) in pair::indices(order).enumerate() {
                let kept = l > 0 || effects.has(Effect::Ambient);
                let value = gram.polar_integrals[k * (degree + 1) + l] * ((o + 1) as f64).sqrt();
                let value = if kept { value } else { 0.0 };
                let (mantissas, exponent) = row(&[value], bits, i64::MAX);
                polar.extend(mantissas);
                polar_exponents.push(exponent);
            }
        }
        let (mut factors, mut factor_exponents) = (Vec::new(), Vec::new());
        let (mut terms, mut profiles) = (Vec::new(), Vec::new());
        for (k, profile) in table.profiles.iter().enumerate() {
            for numbers in profile.factors.chunks_exact(pairs) {
                let (mantissas, exponent) = row(numbers, bits, 1 << (bits + 1));
                factors.extend(mantissas);
                factor_exponents.push(exponent);
            }
            let azimuth = profile.azimuth;
            let scale = if azimuth == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
            let length = usize::from(lengths[azimuth]);
            let kept = &profile.chebyshev[..length.min(profile.chebyshev.len())];
            let powers: Vec<f64> =
                polynomial(kept, length).iter().map(|term| scale * term).collect();
            let (mantissas, exponent) = row(&powers, bits, i64::MAX);
            let sizes = sizes(&mantissas, exponent, azimuth);
            let [size, step] = sizes.ok_or(QuantiseError::Large { azimuth })?;
            terms.extend(mantissas);
            let of = |is_minus: bool| {
                let mut components = table.components.iter();
                let found =
                    components.position(|one| one.profile == k && (one.order < 0) == is_minus);
                found.map_or(NONE, |index| u16::try_from(index).expect("few components"))
            };
            profiles.push(Place {
                azimuth: u8::try_from(azimuth).expect("a small degree"),
                exponent,
                plus: of(false),
                minus: of(true),
                size,
                step,
            });
        }
        Ok(Self {
            format,
            degree,
            order,
            effects,
            components: table.components.len(),
            polar,
            polar_exponents,
            factors,
            factor_exponents,
            profiles,
            lengths,
            terms,
        })
    }
}

/// Mantissas of these numbers and their exponent: each below 2^`bits`, their sizes' sum
/// below `sum`. Numbers below 2^-128 of the format are lost; beyond 2^127 they are as
/// large as can be.
#[must_use]
pub fn row(numbers: &[f64], bits: i32, sum: i64) -> (Vec<i32>, i8) {
    in_range(numbers, bits, sum).unwrap_or_else(|| {
        let most = ((1 << bits) - 1).min((sum - 1) / numbers.len() as i64) as f64;
        let saturated = numbers.iter().map(|number| (number * 2f64.powi(-127)).clamp(-most, most));
        (saturated.map(|number| number as i32).collect(), 127)
    })
}

/// [`row`] of numbers that the format holds: none if one of them is too large.
#[must_use]
fn in_range(numbers: &[f64], bits: i32, sum: i64) -> Option<(Vec<i32>, i8)> {
    let largest = numbers.iter().fold(0.0f64, |most, number| most.max(number.abs()));
    if largest == 0.0 {
        return Some((vec![0; numbers.len()], i8::MIN));
    }
    // From the least exponent that may do.
    let least = (largest.log2().floor() as i32 - bits).clamp(-128, 127);
    (least..=127).find_map(|exponent| {
        let scale = 2f64.powi(-exponent);
        let rounded = numbers.iter().map(|number| (number * scale).round() as i64);
        let sizes = rounded.clone().map(i64::saturating_abs);
        let fits =
            sizes.clone().all(|size| size < 1 << bits) && sizes.fold(0, i64::saturating_add) < sum;
        fits.then(|| (rounded.map(|number| number as i32).collect(), exponent as i8))
    })
}

/// Terms of each azimuth: as many as leave out of each component no more than the
/// tolerance of the database's rms, at any normal.
fn lengths(table: &Table, tolerance: f64) -> Result<Vec<u8>, QuantiseError> {
    let values = table.spectrum.iter().filter_map(|(_, value)| *value);
    let energy: f64 = values.sum();
    let mut lengths = vec![0; table.gram.degree + 1];
    for (k, profile) in table.profiles.iter().enumerate() {
        let served = table.components.iter().filter(|component| component.profile == k);
        // The constant's coefficient is the mean: as large as all the rest.
        let weight = served
            .map(|component| component.eigenvalue.map_or(1.0, |value| (value / energy).sqrt()))
            .fold(0.0, f64::max);
        let needed = needed(profile, tolerance / weight);
        let length = &mut lengths[profile.azimuth];
        *length = needed.max(*length);
    }
    for (azimuth, &terms) in lengths.iter().enumerate() {
        if terms > layout::POWERS {
            return Err(QuantiseError::Long { azimuth, terms });
        }
    }
    Ok(lengths.into_iter().map(|length| length as u8).collect())
}

/// The least number of terms, one at least, whose rest is at most `tolerance` everywhere.
fn needed(profile: &Profile, tolerance: f64) -> usize {
    let mut rest = 0.0;
    let count = profile.chebyshev.len();
    let kept = profile.chebyshev.iter().rev().take_while(|term| {
        rest += term.abs();
        rest <= tolerance
    });
    (count - kept.count()).max(1)
}

/// Mantissas of a material's coefficients, an exponent for each o.
#[must_use]
pub fn material(order: usize, coefficients: &[f64], format: Format) -> (Vec<i32>, Vec<i8>) {
    let (mut mantissas, mut exponents) = (Vec::new(), Vec::new());
    for o in 0..=order {
        let of_order = &coefficients[material::position(o, o % 2, o % 2)..material::count(o)];
        let (of_order, exponent) = row(of_order, format.bits(), i64::MAX);
        mantissas.extend(of_order);
        exponents.push(exponent);
    }
    (mantissas, exponents)
}

/// Whether a format holds the coefficients of a light or a material: none saturates.
#[must_use]
pub fn holds(numbers: &[f64], format: Format) -> bool {
    in_range(numbers, format.bits(), i64::MAX).is_some()
}

/// Points for each degree of a polynomial whose largest value is sought: the largest on
/// a grid of so many Chebyshev points is at least cos(π / 2 POINTS) of it.
const POINTS: usize = 16;

/// The largest |u| of a profile, and the largest term of its polynomial or step of
/// Horner's rule, in sixteenths, rounded up; none if they are beyond 16 bits.
fn sizes(terms: &[i32], exponent: i8, azimuth: usize) -> Option<[u16; 2]> {
    let scale = 2f64.powi(exponent.into());
    // Squares, times powers of 1 - z².
    let count = POINTS * 2 * (terms.len() + azimuth).max(1);
    let (mut size, mut largest) = (0.0f64, 0.0f64);
    for k in 0..=count {
        let t = (std::f64::consts::PI * k as f64 / count as f64).cos();
        let mut step = 0.0;
        for term in terms.iter().map(|&term| scale * f64::from(term)) {
            step = step * t + term;
            largest = largest.max(step.abs()).max(term.abs());
        }
        let z = 0.5 * (t + 1.0);
        size = size.max(step * step * (1.0 - z * z).powi(azimuth as i32));
    }
    let missed = (std::f64::consts::PI / (2 * POINTS) as f64).cos();
    let sizes = [size.sqrt(), largest].map(|value| (16.0 * value / missed).ceil());
    sizes.iter().all(|&size| size <= u16::MAX.into()).then(|| sizes.map(|size| size as u16))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_beyond_the_exponents_are_lost_or_saturate() {
        for bits in [15, 31] {
            let sum = 1 << (bits + 1);
            assert_eq!(row(&[1e-60, -1e-70], bits, i64::MAX), (vec![0, 0], -128));
            let (mantissas, exponent) = row(&[1e60, -1e300, 1.0], bits, sum);
            assert_eq!((mantissas[2], exponent), (0, 127));
            assert!(mantissas[0] > 0 && mantissas[1] == -mantissas[0]);
            assert!(mantissas.iter().map(|one| i64::from(one.abs())).sum::<i64>() < sum);
            assert_eq!(row(&[1.0], bits, i64::MAX), (vec![1 << (bits - 1)], (1 - bits) as i8));
        }
    }

    #[test]
    fn saturation_is_recognized() {
        for format in [Format::Q15, Format::Q31] {
            // The largest mantissa times 2^127.
            let most = (2f64.powi(format.bits()) - 1.0) * 2f64.powi(127);
            assert!(holds(&[most, -most, 1e-300, 0.0], format));
            assert!(!holds(&[2f64.powi(format.bits() + 127)], format));
            assert!(!holds(&[1.0, -f64::MAX], format));
            assert!(holds(&[], format) && holds(&[0.0], format));
        }
    }

    #[test]
    fn profiles_beyond_sixteen_bits_have_no_size() {
        assert_eq!(sizes(&[1, 0, 0], 0, 0), Some([17, 17]));
        assert_eq!(sizes(&[30_000, 0, 0], 0, 0), None);
    }
}
