//! How coefficients are written: the names, indices and ranges that distinguish lights from
//! materials, and numbers as text, exactly or rounded to fewer digits for smaller files.

use crate::database::Lights;
use eigenshade_table::{light, material};

/// The largest degree or order that is accepted.
const LARGEST: usize = 1024;

/// The properties that distinguish lights from materials.
pub(crate) struct Kind<const N: usize> {
    /// `light` or `material`.
    pub(crate) thing: &'static str,
    /// `degree` or `order`.
    pub(crate) size: &'static str,
    /// The names of the index columns.
    pub(crate) names: [&'static str; N],
    /// The rule that a valid index obeys, for the remedy.
    pub(crate) rule: &'static str,
    /// Degree or order, and position, of an index; `None` if it is out of range.
    pub(crate) place: fn([i64; N]) -> Option<(usize, usize)>,
    /// Number of coefficients up to a degree or order.
    pub(crate) count: fn(usize) -> usize,
    /// The indices of these coefficients, in storage order.
    pub(crate) indices: fn(usize) -> Box<dyn Iterator<Item = [i64; N]>>,
}

/// L_l^m.
pub(crate) const LIGHT: Kind<2> = Kind {
    thing: "light",
    size: "degree",
    names: ["l", "m"],
    rule: "0 <= l <= 1024 and -l <= m <= l",
    place: |[l, m]| {
        let degree = usize::try_from(l).ok().filter(|&l| l <= LARGEST)?;
        (m.unsigned_abs() as usize <= degree).then(|| (degree, light::position(degree, m as isize)))
    },
    count: light::count,
    indices: |degree| Box::new(light::indices(degree).map(|(l, m)| [l as i64, m as i64])),
};

/// b_op^q.
pub(crate) const MATERIAL: Kind<3> = Kind {
    thing: "material",
    size: "order",
    names: ["o", "p", "q"],
    rule: "1024 >= o >= p >= q >= 0, all even or all odd",
    place: |index| {
        let [o, p, q] = index.map(|i| usize::try_from(i).unwrap_or(usize::MAX));
        let in_range = o <= LARGEST && p <= o && q <= p && (o - q) % 2 == 0 && (p - q) % 2 == 0;
        in_range.then(|| (o, material::position(o, p, q)))
    },
    count: material::count,
    indices: |order| {
        Box::new(material::indices(order).map(|(o, p, q)| [o as i64, p as i64, q as i64]))
    },
};

impl<const N: usize> Kind<N> {
    /// The expected header of a file.
    pub(crate) fn header(&self, values: &str) -> String {
        format!("name,{},{values}", self.names.join(","))
    }

    /// Formats an index, such as `l = 2, m = -1`.
    pub(crate) fn spell(&self, index: [i64; N]) -> String {
        let parts = self.names.iter().zip(index).map(|(name, i)| format!("{name} = {i}"));
        parts.collect::<Vec<_>>().join(", ")
    }
}

/// Significant digits of the shipped light files: two more than the 32-bit texels of any map.
pub const LIGHT_DIGITS: usize = 9;

/// The same lights with every coefficient rounded to `digits` significant decimal digits.
///
/// A coefficient changes by at most half a unit in the last digit: 5e-9 of its value for
/// [`LIGHT_DIGITS`].
#[must_use]
pub fn rounded(lights: &Lights, digits: usize) -> Lights {
    let mut lights = lights.clone();
    let channels = lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb);
    channels.flatten().for_each(|value| *value = significant(*value, digits));
    lights
}

/// Rounds to this many significant decimal digits. The result comes from parsing decimal text, so
/// writing and reading it back does not change it.
pub(crate) fn significant(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// The shortest decimal text that reads back as the same number, to the last bit.
///
/// A number that was converted from f32 reads back correctly both as f32 and as f64.
#[must_use]
pub fn exact(number: f64) -> String {
    let (plain, scientific) = (format!("{number}"), format!("{number:e}"));
    if scientific.len() < plain.len() { scientific } else { plain }
}
