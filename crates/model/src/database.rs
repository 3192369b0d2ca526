//! Named lights and materials as coefficients of three color channels.

use crate::error::{Error, Result};
use eigenshade_table::{light, material};
use std::collections::BTreeMap;

/// The coefficients of one light or one material, for each channel (r, g, b).
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// The name, unique in its set.
    pub name: String,
    /// Linear coefficients; all three channels have the same length.
    pub rgb: [Vec<f64>; 3],
}

/// The least similarity of a name that a message offers, from 0 to 1.
const SIMILAR: f64 = 0.75;

/// The most names that a message offers.
const OFFERED: usize = 3;

/// The remedy for a name that is none of `names`: `use`, the most similar ones, whatever their
/// case, and `otherwise`.
pub fn name_remedy<'a>(
    name: &str,
    names: impl IntoIterator<Item = &'a str>,
    otherwise: &str,
) -> String {
    let lower = name.to_lowercase();
    let name = lower.as_str();
    let similarity = |other: &'a str| (strsim::jaro_winkler(name, &other.to_lowercase()), other);
    let mut similar: Vec<_> = names.into_iter().map(similarity).collect();
    similar.retain(|(similarity, other)| {
        *similarity >= SIMILAR || other.to_lowercase().contains(name)
    });
    similar.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let offered = similar.iter().take(OFFERED).map(|(_, name)| format!("`{name}`, "));
    let offered = offered.collect::<String>();
    let or = if offered.is_empty() { "" } else { "or " };
    format!("use {offered}{or}{otherwise}")
}

/// 0.2126 R + 0.7152 G + 0.0722 B.
#[must_use]
pub fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

impl Named {
    /// The [`luminance`] of every coefficient.
    #[must_use]
    pub fn luminance(&self) -> Vec<f64> {
        let [r, g, b] = &self.rgb;
        r.iter().zip(g).zip(b).map(|((&r, &g), &b)| luminance([r, g, b])).collect()
    }

    /// Replaces all three channels by the luminance. An entry without color stays unchanged.
    pub fn remove_color(&mut self) {
        if !self.is_gray() {
            let luminance = self.luminance();
            self.rgb = [luminance.clone(), luminance.clone(), luminance];
        }
    }

    /// Whether all three channels are equal.
    #[must_use]
    pub fn is_gray(&self) -> bool {
        self.rgb[0] == self.rgb[1] && self.rgb[1] == self.rgb[2]
    }
}

/// Lights of one degree: L_l^m in radiance, in the order of [`eigenshade_table::light`].
#[derive(Clone, Debug, PartialEq)]
pub struct Lights {
    /// The common degree of the lights.
    pub degree: usize,
    /// The lights, each with (degree + 1)² coefficients per channel.
    pub entries: Vec<Named>,
}

/// Materials of one order: b_op^q in 1/sr, in the order of [`eigenshade_table::material`].
#[derive(Clone, Debug, PartialEq)]
pub struct Materials {
    /// The common order of the materials.
    pub order: usize,
    /// The materials.
    pub entries: Vec<Named>,
}

impl Lights {
    /// The same lights up to a lower degree.
    #[must_use]
    pub fn truncated(&self, degree: usize) -> Self {
        let degree = degree.min(self.degree);
        Self { degree, entries: prefix(&self.entries, light::count(degree)) }
    }
}

impl Materials {
    /// The same materials up to a lower order.
    #[must_use]
    pub fn truncated(&self, order: usize) -> Self {
        let order = order.min(self.order);
        Self { order, entries: prefix(&self.entries, material::count(order)) }
    }
}

/// The weight of each entry, from `by_name` or 1 by default, scaled so that the weights sum to 1.
///
/// # Errors
///
/// If a name belongs to no entry, a weight is negative or not finite, or no weight is above zero.
pub fn weights(entries: &[Named], by_name: &BTreeMap<String, f64>) -> Result<Vec<f64>> {
    for (name, weight) in by_name {
        if !entries.iter().any(|entry| entry.name == *name) {
            let what = format!("weights has `{name}`, which is not in the database");
            let names = entries.iter().map(|entry| entry.name.as_str());
            let remedy = name_remedy(name, names, "another name from the database");
            return Err(Error::new(what, remedy));
        }
        if !(*weight >= 0.0 && weight.is_finite()) {
            let what = format!("weights has {weight} for `{name}`");
            return Err(Error::new(what, "give it a finite weight of zero or more"));
        }
    }
    let of = |entry: &Named| by_name.get(&entry.name).copied().unwrap_or(1.0);
    let weights: Vec<f64> = entries.iter().map(of).collect();
    let largest = weights.iter().copied().fold(0.0, f64::max);
    if largest == 0.0 {
        return Err(Error::new("all entries have weight 0", "give one a weight above zero"));
    }
    // Dividing by the largest weight first keeps the sum finite.
    let sum: f64 = weights.iter().map(|weight| weight / largest).sum();
    Ok(weights.iter().map(|weight| weight / largest / sum).collect())
}

fn prefix(entries: &[Named], count: usize) -> Vec<Named> {
    let cut = |channel: &Vec<f64>| channel[..count.min(channel.len())].to_vec();
    entries
        .iter()
        .map(|entry| Named { name: entry.name.clone(), rgb: entry.rgb.each_ref().map(cut) })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::name_remedy;

    #[test]
    fn the_nearest_names_come_first() {
        let names = ["city", "park", "07-velvet", "parking-lot"];
        assert_eq!(name_remedy("parc", names, "others"), "use `park`, or others");
        assert_eq!(name_remedy("park", names, "others"), "use `park`, `parking-lot`, or others");
        assert_eq!(name_remedy("velvet", names, "others"), "use `07-velvet`, or others");
        assert_eq!(name_remedy("PARC", names, "others"), "use `park`, or others");
        assert_eq!(name_remedy("xyzzy", names, "another"), "use another");
    }
}
