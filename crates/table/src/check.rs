//! Whether the parts of a table fit together: decoding is total.

use crate::table::Table;
use eigenshade_index::{material, mode, pair};

/// Beyond these nothing of a table can be meant; they keep every count below
/// from overflowing.
const MOST: usize = 256;

impl Table {
    /// `Err` names the first part whose shape contradicts the others, or that
    /// holds a number that is not finite.
    pub(crate) fn check(&self) -> Result<(), String> {
        let gram = &self.gram;
        let (degree, order) = (gram.degree, gram.order);
        if degree > MOST || order > MOST {
            return Err(format!("degree {degree} or order {order} beyond {MOST}"));
        }
        let nodes = gram.nodes.len();
        let pairs = pair::count(order);
        let frequencies: usize = (0..=degree).map(|l| (l + 1) * (l.min(order) + 1)).sum();
        let selection = match self.selection.len() {
            0 => 0,
            _ => (degree + 1) * material::count(order) * (degree + 1),
        };
        numbers("nodes", &gram.nodes, nodes)?;
        numbers("root weights", &gram.root_weights, nodes)?;
        numbers("gains", &gram.gains, material::count(order))?;
        numbers("polar integrals", &gram.polar_integrals, pairs * (degree + 1))?;
        numbers("radials", &gram.radials, pairs * nodes)?;
        numbers("rotations", &gram.rotations, frequencies * nodes)?;
        length("selection", self.selection.len(), selection)?;
        length("ranks", self.summary.ranks.len(), degree + 1)?;
        for profile in &self.profiles {
            let azimuth = profile.azimuth;
            if azimuth > degree {
                return Err(format!("a profile of azimuth {azimuth} at degree {degree}"));
            }
            numbers("profile's node values", &profile.node_values, nodes)?;
            numbers("profile's modes", &profile.modes, mode::count(degree, order, azimuth))?;
            numbers("profile's factors", &profile.factors, pairs * (degree - azimuth + 1))?;
            numbers("profile's polynomial", &profile.chebyshev, profile.chebyshev.len())?;
        }
        if !self.profiles.is_sorted_by_key(|profile| profile.azimuth) {
            return Err("profiles out of order".into());
        }
        for (index, component) in self.components.iter().enumerate() {
            let profile = self.profiles.get(component.profile);
            let azimuth = component.order.unsigned_abs() as usize;
            if profile.is_none_or(|profile| profile.azimuth != azimuth) {
                return Err(format!("component {index} has no profile of its azimuth"));
            }
        }
        if let Some(mean) = &self.mean {
            numbers("mean image", &mean.chebyshev, mean.chebyshev.len())?;
            numbers("mean's coefficients", &mean.coefficients, self.components.len())?;
        }
        Ok(())
    }
}

fn numbers(what: &str, values: &[f64], expected: usize) -> Result<(), String> {
    length(what, values.len(), expected)?;
    if values.iter().all(|value| value.is_finite()) {
        Ok(())
    } else {
        Err(format!("{what} with a number that is not finite"))
    }
}

fn length(what: &str, found: usize, expected: usize) -> Result<(), String> {
    if found == expected {
        Ok(())
    } else {
        Err(format!("{what}: {expected} numbers expected, {found} found"))
    }
}
