//! A table in integers: mantissas of 15 bits, with a power of two for each row.
//!
//! Rounding is to nearest, ties away from zero. The scale of a row of factors ensures that no sum
//! over the row, of products with mantissas, overflows an accumulator of twice as many bits plus
//! one: Σ |mantissa| < 2^(bits + 1).

use crate::chebyshev::{Form, polynomial};
use crate::format_error::{FormatError, MAX_PROFILES};
use crate::parts;
use crate::record::integers::{OwnedParts, Profile as Place};
use crate::record::{NONE, Q15};
use crate::table::{Profile, Table};
use crate::{layout, material, pair};

/// Number of bits of a mantissa, without the sign.
const BITS: i32 = Q15::BITS.cast_signed();

/// The truncation error that is allowed for polynomials, relative to the database's rms; smaller
/// than the rounding error.
pub const TOLERANCE: f64 = 1e-5;

/// The arrays of a table in integers. Trims its polynomials so that each component loses at most
/// `tolerance`, relative to the rms of the database's images, which follows from the eigenvalues:
/// [`TOLERANCE`] suits the format.
///
/// # Errors
///
/// If the table cannot be converted to integers.
pub fn integers(table: &Table, tolerance: f64) -> Result<OwnedParts<Q15>, FormatError> {
    parts::check(table)?;
    if table.profiles.len() > MAX_PROFILES {
        return Err(FormatError::Many);
    }
    let gram = &table.gram;
    let (degree, order) = (gram.degree, gram.order);
    let pairs = pair::count(order);
    let lengths = lengths(table, tolerance)?;
    let (mut polar, mut polar_exponents) = (Vec::new(), Vec::new());
    for l in 0..=degree {
        for (k, (o, _)) in pair::indices(order).enumerate() {
            let value = gram.polar_integrals[k * (degree + 1) + l] * ((o + 1) as f64).sqrt();
            let (mantissas, exponent) = row(&[value], i64::MAX);
            polar.extend(mantissas);
            polar_exponents.push(exponent);
        }
    }
    let (mut factors, mut factor_exponents) = (Vec::new(), Vec::new());
    let (mut terms, mut profiles) = (Vec::new(), Vec::new());
    let mut large = None;
    for (k, profile) in table.profiles.iter().enumerate() {
        for numbers in profile.factors.chunks_exact(pairs) {
            let (mantissas, exponent) = row(numbers, 1 << (BITS + 1));
            factors.extend(mantissas);
            factor_exponents.push(exponent);
        }
        let azimuth = profile.azimuth;
        let scale = if azimuth == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
        let length = usize::from(lengths[azimuth]);
        let kept = &profile.chebyshev[..length.min(profile.chebyshev.len())];
        let powers: Vec<f64> =
            polynomial(kept, length, Form::Powers).iter().map(|term| scale * term).collect();
        let (mantissas, exponent) = row(&powers, i64::MAX);
        let Some([size, step]) = sizes(&mantissas, exponent, azimuth) else {
            let first = table.components.iter().position(|one| one.profile == k);
            large = large.into_iter().chain(first.or(Some(table.components.len()))).min();
            continue;
        };
        terms.extend(mantissas);
        let of = |is_minus: bool| {
            let mut components = table.components.iter();
            let found = components.position(|one| one.profile == k && (one.order < 0) == is_minus);
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
    if let Some(component) = large {
        return Err(FormatError::Large { component });
    }
    let count = |azimuth| profiles.iter().filter(|one| one.azimuth() == azimuth).count();
    let azimuths =
        parts::positions((0..=degree).map(count), lengths.iter().copied(), |azimuth, count| {
            count * (degree + 1 - azimuth)
        });
    Ok(OwnedParts {
        azimuths,
        degree,
        order,
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

/// Converts numbers to mantissas with a common exponent. Each mantissa is below 2^15, and the
/// sum of their absolute values is below `sum`. Numbers below 2^-128 of the format become 0;
/// numbers beyond 2^127 saturate.
#[must_use]
pub fn row(numbers: &[f64], sum: i64) -> (Vec<Q15>, i8) {
    in_range(numbers, sum).unwrap_or_else(|| {
        let most = ((1 << BITS) - 1).min((sum - 1) / numbers.len() as i64) as f64;
        let saturated = numbers.iter().map(|number| (number * 2f64.powi(-127)).clamp(-most, most));
        (saturated.map(|number| Q15(number as i16)).collect(), 127)
    })
}

/// Like [`row`]; `None` if a number is too large for the format.
#[must_use]
fn in_range(numbers: &[f64], sum: i64) -> Option<(Vec<Q15>, i8)> {
    let largest = numbers.iter().fold(0.0f64, |most, number| most.max(number.abs()));
    if largest == 0.0 {
        return Some((vec![Q15(0); numbers.len()], i8::MIN));
    }
    // Starts from the smallest exponent that is possible.
    let least = (largest.log2().floor() as i32 - BITS).clamp(-128, 127);
    (least..=127).find_map(|exponent| {
        let scale = 2f64.powi(-exponent);
        let rounded = numbers.iter().map(|number| (number * scale).round() as i64);
        let sizes = rounded.clone().map(i64::saturating_abs);
        let fits =
            sizes.clone().all(|size| size < 1 << BITS) && sizes.fold(0, i64::saturating_add) < sum;
        fits.then(|| (rounded.map(|number| Q15(number as i16)).collect(), exponent as i8))
    })
}

/// Number of terms for each azimuth: as few as possible while each component loses at most
/// `tolerance` of the database's rms at any normal.
fn lengths(table: &Table, tolerance: f64) -> Result<Vec<u8>, FormatError> {
    let values = table.spectrum.iter().filter_map(|(_, value)| *value);
    let energy: f64 = values.sum();
    let mut lengths = vec![0; table.gram.degree + 1];
    for (k, profile) in table.profiles.iter().enumerate() {
        let served = table.components.iter().filter(|component| component.profile == k);
        // The coefficient of the constant is the mean, which is as large as everything else.
        let weight = served
            .map(|component| component.eigenvalue.map_or(1.0, |value| (value / energy).sqrt()))
            .fold(0.0, f64::max);
        let needed = needed(profile, tolerance / weight);
        let length = &mut lengths[profile.azimuth];
        *length = needed.max(*length);
    }
    for (azimuth, &terms) in lengths.iter().enumerate() {
        let most = layout::MAX_INTEGER_TERMS;
        if terms > most {
            return Err(FormatError::Long { azimuth, terms, most });
        }
    }
    Ok(lengths.into_iter().map(|length| length as u8).collect())
}

/// The smallest number of terms, at least one, such that the rest is at most `tolerance`
/// everywhere.
fn needed(profile: &Profile, tolerance: f64) -> usize {
    let mut rest = 0.0;
    let count = profile.chebyshev.len();
    let kept = profile.chebyshev.iter().rev().take_while(|term| {
        rest += term.abs();
        rest <= tolerance
    });
    (count - kept.count()).max(1)
}

/// The coefficients of a material as mantissas, with one exponent for each o.
#[must_use]
pub fn material(order: usize, coefficients: &[f64]) -> (Vec<Q15>, Vec<i8>) {
    let (mut mantissas, mut exponents) = (Vec::new(), Vec::new());
    for o in 0..=order {
        let of_order = &coefficients[material::position(o, o % 2, o % 2)..material::count(o)];
        let (of_order, exponent) = row(of_order, i64::MAX);
        mantissas.extend(of_order);
        exponents.push(exponent);
    }
    (mantissas, exponents)
}

/// Whether the coefficients of a light or a material fit the format without saturation.
#[must_use]
pub fn holds(numbers: &[f64]) -> bool {
    in_range(numbers, i64::MAX).is_some()
}

/// Number of grid points per degree in the search for a polynomial's largest value. The largest
/// value on a grid of this many Chebyshev points is at least cos(π / 2 POINTS) times the maximum.
const POINTS: usize = 16;

/// The largest |u| of a profile, and the largest term of its polynomial or intermediate sum in
/// Horner's rule, in sixteenths, rounded up. `None` if one of them exceeds 16 bits.
fn sizes(terms: &[Q15], exponent: i8, azimuth: usize) -> Option<[u16; 2]> {
    let scale = 2f64.powi(exponent.into());
    // The grid covers squares of the polynomial times powers of 1 - z².
    let count = POINTS * 2 * (terms.len() + azimuth).max(1);
    let (mut size, mut largest) = (0.0f64, 0.0f64);
    for k in 0..=count {
        let t = (std::f64::consts::PI * k as f64 / count as f64).cos();
        let mut step = 0.0;
        for term in terms.iter().map(|&term| scale * f64::from(term.0)) {
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
        let sum = 1 << (BITS + 1);
        assert_eq!(row(&[1e-60, -1e-70], i64::MAX), (vec![Q15(0), Q15(0)], -128));
        let (mantissas, exponent) = row(&[1e60, -1e300, 1.0], sum);
        assert_eq!((mantissas[2].0, exponent), (0, 127));
        assert!(mantissas[0].0 > 0 && mantissas[1].0 == -mantissas[0].0);
        assert!(mantissas.iter().map(|one| i64::from(one.0.abs())).sum::<i64>() < sum);
        assert_eq!(row(&[1.0], i64::MAX), (vec![Q15(1 << (BITS - 1))], (1 - BITS) as i8));
    }

    #[test]
    fn saturation_is_recognized() {
        // The largest mantissa times 2^127.
        let most = (2f64.powi(BITS) - 1.0) * 2f64.powi(127);
        assert!(holds(&[most, -most, 1e-300, 0.0]));
        assert!(!holds(&[2f64.powi(BITS + 127)]));
        assert!(!holds(&[1.0, -f64::MAX]));
        assert!(holds(&[]) && holds(&[0.0]));
    }

    #[test]
    fn profiles_beyond_sixteen_bits_have_no_size() {
        assert_eq!(sizes(&[1, 0, 0].map(Q15), 0, 0), Some([17, 17]));
        assert_eq!(sizes(&[30_000, 0, 0].map(Q15), 0, 0), None);
    }
}
