//! A table as the runtime needs it: the numbers for a device, padded and in the order of the
//! runtime's loops. The numbers are in f64; rounding to the device's format comes last.

use crate::chebyshev::{Form, polynomial};
use crate::format_error::FormatError;
use crate::layout::{LANES, PASS, first_order, lowest_degree};
use crate::record::floats::OwnedParts;
use crate::record::{Azimuth, NONE, Pass, ProfilePlace, Row, Run};
use crate::scene::Criterion;
use crate::table::{Profile, Table};
use crate::{layout, pair};
use std::collections::BTreeSet;

/// Whether the runtime takes this table.
///
/// # Errors
///
/// [`FormatError::TransfersOnly`] if it stores only transfers, [`FormatError::Selection`] if it has a
/// selection of modes, [`FormatError::Mean`] if it has a mean image, [`FormatError::High`] beyond
/// degree or order 12, [`FormatError::Long`] if a polynomial has more than 40 terms.
pub fn check(table: &Table) -> Result<(), FormatError> {
    let (degree, order) = (table.gram.degree, table.gram.order);
    if !table.has_projection() {
        return Err(FormatError::TransfersOnly);
    }
    if !table.selection.is_empty() {
        return Err(FormatError::Selection);
    }
    if table.scene.basis.criterion == Criterion::Standard {
        return Err(FormatError::Mean);
    }
    if degree > layout::MAX_DEGREE || order > layout::MAX_ORDER {
        return Err(FormatError::High { degree, order });
    }
    let most = layout::MAX_TERMS;
    let lengths = lengths(table).into_iter().map(usize::from);
    match lengths.enumerate().find(|(_, terms)| *terms > most) {
        Some((azimuth, terms)) => Err(FormatError::Long { azimuth, terms, most }),
        None => Ok(()),
    }
}

/// The arrays of a table.
#[must_use]
pub fn floats(table: &Table) -> OwnedParts<f64> {
    let gram = &table.gram;
    let (degree, order) = (gram.degree, gram.order);
    let pairs = pair::count(order);
    let roots: Vec<f64> = pair::indices(order).map(|(o, _)| ((o + 1) as f64).sqrt()).collect();
    let lengths = lengths(table);
    let (polar, factors) = if table.has_projection() {
        let polar = grouped(degree, pairs, |l, pair| {
            roots[pair] * gram.polar_integrals[pair * (degree + 1) + l]
        });
        (polar, factors(table, degree, order))
    } else {
        (Vec::new(), Vec::new())
    };
    let terms = table.profiles.iter().flat_map(|profile| {
        let scale = if profile.azimuth == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
        let terms = polynomial(&profile.chebyshev, lengths[profile.azimuth].into(), Form::Halves);
        terms.into_iter().map(move |term| scale * term)
    });
    let mut profiles = places(table);
    let (passes, slots) = arrange(degree, &mut profiles);
    for place in profiles.iter_mut().filter(|place| place.azimuth == 0) {
        place.minus_row = place.plus_row;
    }
    OwnedParts {
        degree,
        order,
        components: table.components.len(),
        azimuths: azimuths(degree, &profiles, &lengths),
        runs: runs(&profiles),
        profiles,
        passes,
        slots,
        polar,
        factors,
        terms: terms.collect(),
        lengths,
    }
}

/// Arranges one of the table's transfers in the order of the runtime.
#[must_use]
pub fn transfer(parts: &OwnedParts<f64>, numbers: &[f64]) -> Vec<f64> {
    let length = parts.passes.iter().filter_map(|pass| pass.length(parts.degree)).sum();
    let mut transfer = vec![0.0; length];
    let mut rest = numbers.iter();
    for place in &parts.profiles {
        let sign = if place.azimuth % 2 == 1 { -1.0 } else { 1.0 };
        let degrees = parts.degree + 1 - usize::from(place.azimuth);
        for (row, number) in rest.by_ref().take(degrees).enumerate() {
            // For m = 0 both rows are the same and the sign is +.
            for (of, value) in [(place.minus_row, sign * number), (place.plus_row, *number)] {
                transfer[of.start as usize + row * of.step as usize] = value;
            }
        }
    }
    transfer
}

/// Number of terms for each azimuth: as many as its longest profile has.
fn lengths(table: &Table) -> Vec<u16> {
    let mut lengths = vec![0; table.gram.degree + 1];
    for Profile { azimuth, chebyshev, .. } in &table.profiles {
        let length = u16::try_from(chebyshev.len()).expect("a polynomial's length is small");
        lengths[*azimuth] = length.max(lengths[*azimuth]);
    }
    lengths
}

/// Where the numbers of each azimuth are, for these lengths of polynomials.
fn azimuths(degree: usize, profiles: &[ProfilePlace], lengths: &[u16]) -> Vec<Azimuth> {
    let of = |azimuth| profiles.iter().filter(move |one| one.azimuth() == azimuth).count();
    let lengths = lengths.iter().copied();
    positions((0..=degree).map(of), lengths, |azimuth, count| layout::rows(degree, azimuth, count))
}

/// Where the numbers of each azimuth are, from its number of profiles, the length of its polynomials
/// and its number of rows.
pub(crate) fn positions(
    counts: impl IntoIterator<Item = usize>,
    lengths: impl IntoIterator<Item = impl Into<u32>>,
    rows: impl Fn(usize, usize) -> usize,
) -> Vec<Azimuth> {
    let mut next = Azimuth { first: 0, profiles: 0, start: 0, terms: 0, rows: 0 };
    let place = |(azimuth, (count, length)): (usize, (usize, u32))| {
        let profiles = small(count);
        let place = Azimuth { profiles, ..next };
        next.first += profiles;
        next.start += if azimuth == 0 { length } else { 2 * length };
        next.terms += u32::from(profiles) * length;
        next.rows += short(rows(azimuth, count));
        place
    };
    let lengths = lengths.into_iter().map(Into::into);
    counts.into_iter().zip(lengths).enumerate().map(place).collect()
}

/// The rows of a transfer, order by order: those that stand side by side in one run.
fn runs(profiles: &[ProfilePlace]) -> Vec<Run> {
    let (mut runs, mut first) = (Vec::new(), 0);
    for of_azimuth in profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        let order = of_azimuth[0].azimuth().cast_signed() as i16;
        for sign in if order == 0 { &[1][..] } else { &[1, -1] } {
            let row = |place: &ProfilePlace| place.row(*sign);
            let beside = |a: &ProfilePlace, b: &ProfilePlace| {
                row(b).step == row(a).step && row(b).start == row(a).start + LANES as u32
            };
            let mut of_run = first;
            for run in of_azimuth.chunk_by(beside) {
                let Row { start, step } = row(&run[0]);
                let (profiles, step) = (small(run.len()), small(step as usize));
                let order = *sign as i16 * order;
                runs.push(Run { order, profiles, first: small(of_run), step, start });
                of_run += run.len();
            }
        }
        first += of_azimuth.len();
    }
    runs
}

/// One row over l for each pair, padded to whole groups with zeros.
fn grouped(degree: usize, pairs: usize, value: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    let mut values = Vec::new();
    for pair in 0..pairs {
        let degrees = 0..layout::LANES * layout::groups(degree);
        values.extend(degrees.map(|l| if l <= degree { value(l, pair) } else { 0.0 }));
    }
    values
}

/// The factors of all profiles, two profiles of an azimuth at a time.
fn factors(table: &Table, degree: usize, order: usize) -> Vec<f64> {
    let (pairs, lanes) = (pair::count(order), layout::LANES);
    let mut factors = Vec::new();
    for block in table.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        for two in block.chunks(2) {
            for l in 0..=degree - two[0].azimuth {
                for group in (0..layout::row(order)).step_by(lanes) {
                    for profile in 0..2 {
                        factors.extend((group..group + lanes).map(|pair| {
                            let found = two.get(profile).filter(|_| pair < pairs);
                            found.map_or(0.0, |profile| profile.factors[l * pairs + pair])
                        }));
                    }
                }
            }
        }
    }
    factors
}

fn places(table: &Table) -> Vec<ProfilePlace> {
    let place = |profile: &Profile| ProfilePlace {
        azimuth: u16::try_from(profile.azimuth).expect("checked degree"),
        plus: NONE,
        minus: NONE,
        plus_row: Row::default(),
        minus_row: Row::default(),
    };
    let mut places: Vec<_> = table.profiles.iter().map(place).collect();
    for (index, component) in table.components.iter().enumerate() {
        let index = u16::try_from(index).expect("fewer components than 65,535");
        let place = &mut places[component.profile];
        *(if component.order < 0 { &mut place.minus } else { &mut place.plus }) = index;
    }
    places
}

/// Arranges profiles, sorted by azimuth, in passes and sets the rows of their `places`.
///
/// Also returns, for each pass, profile and lane, the component that it computes, or [`NONE`].
fn arrange(degree: usize, places: &mut [ProfilePlace]) -> (Vec<Pass>, Vec<u16>) {
    let orders = |place: &ProfilePlace| [i32::from(place.azimuth), -i32::from(place.azimuth)];
    let firsts: BTreeSet<isize> =
        places.iter().flat_map(orders).map(|order| first_order(order as isize)).collect();
    let (mut passes, mut slots, mut start) = (Vec::new(), Vec::new(), 0);
    for first in firsts {
        let lanes: Vec<Vec<usize>> = (first..first + LANES.cast_signed())
            .map(|order| {
                let of = |k: &usize| usize::from(places[*k].azimuth) == order.unsigned_abs();
                (0..places.len()).filter(of).collect()
            })
            .collect();
        let most = lanes.iter().map(Vec::len).max().unwrap_or(0);
        for chunk in (0..most).step_by(PASS) {
            let count = PASS.min(most - chunk);
            for profile in 0..count {
                for (lane, order) in (first..).take(LANES).enumerate() {
                    let Some(&k) = lanes[lane].get(chunk + profile) else {
                        slots.push(NONE);
                        continue;
                    };
                    let place = &mut places[k];
                    let skipped = order.unsigned_abs() - lowest_degree(first);
                    let row = Row {
                        start: short(start + LANES * (skipped * count + profile) + lane),
                        step: short(LANES * count),
                    };
                    let (to, slot) = if order < 0 {
                        (&mut place.minus_row, place.minus)
                    } else {
                        (&mut place.plus_row, place.plus)
                    };
                    *to = row;
                    slots.push(slot);
                }
            }
            let of_pass = LANES * count;
            passes.push(Pass {
                first: first as i16,
                profiles: small(count),
                start: short(start),
                slots: short(slots.len() - of_pass),
            });
            start += of_pass * (degree + 1 - lowest_degree(first));
        }
    }
    (passes, slots)
}

fn small(count: usize) -> u16 {
    u16::try_from(count).expect("as few as components")
}

fn short(place: usize) -> u32 {
    u32::try_from(place).expect("a transfer of fewer than four billion numbers")
}
