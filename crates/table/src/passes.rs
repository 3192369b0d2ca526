//! The layout of transfers: passes along m, as defined in [`eigenshade_index::layout`].

use crate::parts::{NONE, ProfilePlace, Row};
use eigenshade_index::layout::{LANES, PASS, first_order, lowest_degree};
use std::collections::BTreeSet;

/// A pass: the orders `first`..`first` + LANES, and the number of profiles of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pass {
    /// The first order m.
    pub first: i16,
    /// Number of profiles of each order.
    pub profiles: u16,
}

/// Arranges profiles, sorted by azimuth, in passes and sets the rows of their `places`.
///
/// Also returns, for each pass, profile and lane, the component that it computes, or [`NONE`].
pub fn arrange(degree: usize, places: &mut [ProfilePlace]) -> (Vec<Pass>, Vec<u16>) {
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
            passes.push(Pass { first: first as i16, profiles: count as u16 });
            start += LANES * count * (degree + 1 - lowest_degree(first));
        }
    }
    (passes, slots)
}

fn short(place: usize) -> u32 {
    u32::try_from(place).expect("a transfer of fewer than four billion numbers")
}
