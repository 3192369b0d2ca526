//! The 3,704 modes in one order, the paper's 1,000 of the highest variance among them, and
//! the rows of UᵀM over them.

use crate::shipped::{Pair, Shipped};
use eigenshade::sphere;
use eigenshade_index::{light, material, mode};
use eigenshade_model::selection;
use eigenshade_table::Component;

/// l, m, o, p, q.
pub type Mode = (usize, isize, usize, usize, usize);

/// So many the paper kept.
pub const SELECTED: usize = 1000;

/// All modes, m by m.
pub fn all() -> Vec<Mode> {
    let top = sphere::DEGREE.cast_signed();
    let of = |m: isize| {
        let modes = mode::indices(sphere::DEGREE, sphere::ORDER, m.unsigned_abs());
        modes.map(move |(l, o, p, q)| (l, m, o, p, q))
    };
    (-top..=top).flat_map(of).collect()
}

/// Which of [`all`] the paper's selection keeps; ties stay whole.
pub fn selected(shipped: &Shipped) -> Vec<bool> {
    let gram = &shipped.table.gram;
    let kept = selection::highest(gram, eigenshade::Effects::ALL, SELECTED);
    let keeps = |(l, m, o, p, q): Mode| kept[gram.place(m.unsigned_abs(), l, o, p, q)];
    all().into_iter().map(keeps).collect()
}

/// What of `values`, one for each of [`all`], a selection keeps.
pub fn only<T: Copy>(values: &[T], kept: &[bool]) -> Vec<T> {
    let both = values.iter().zip(kept);
    both.filter_map(|(&value, &is_kept)| is_kept.then_some(value)).collect()
}

/// c of a pair.
pub fn coefficients(pair: &Pair) -> Vec<f64> {
    let c = |(l, m, o, p, q): Mode| {
        pair.light[light::position(l, m)] * pair.material[material::position(o, p, q)]
    };
    all().into_iter().map(c).collect()
}

/// UᵀM, a row for each component.
pub fn rows(shipped: &Shipped) -> Vec<Vec<f64>> {
    let table = &shipped.table;
    let row = |component: &Component| {
        let values = table.gram_row(&table.profiles[component.profile]);
        let mut values = values.into_iter();
        let sign = if component.order < 0 && component.order % 2 != 0 { -1.0 } else { 1.0 };
        let entry = |(_, m, ..): Mode| {
            if m as i32 == component.order {
                sign * values.next().expect("a value for each mode of its azimuth")
            } else {
                0.0
            }
        };
        all().into_iter().map(entry).collect()
    };
    table.components.iter().map(row).collect()
}
