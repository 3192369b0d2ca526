//! Consistency checks on the parts of a table, so that decoding is total.

use crate::effect::Effects;
use crate::record::NONE;
use crate::scene::{Criterion, is_share};
use crate::table::Table;
use crate::{material, mode, pair};

/// The largest degree and order of a valid table. The limit keeps the counts below from
/// overflowing.
const MAX: usize = 256;

/// No polynomial up to this degree and order has more terms.
const MAX_TERMS: usize = 4 * MAX;

impl Table {
    /// Checks that the parts of the table are consistent.
    ///
    /// # Errors
    ///
    /// The name of the first part whose shape contradicts the others or that contains a number that
    /// is not finite.
    pub(crate) fn check(&self) -> Result<(), String> {
        let gram = &self.gram;
        let (degree, order) = (gram.degree, gram.order);
        if degree > MAX || order > MAX {
            return Err(format!("degree {degree} or order {order} above {MAX}"));
        }
        if self.effects() == Effects::NONE {
            return Err("a scene without effects".into());
        }
        if (degree, order) != (self.scene.degree(), self.scene.order()) {
            return Err(format!("degree {degree} and order {order} differ from the scene's"));
        }
        if let Some(share) = self.scene.basis.trim.filter(|share| !is_share(*share)) {
            return Err(format!("basis.trim = {share}"));
        }
        let nodes = gram.nodes.len();
        let pairs = pair::count(order);
        let frequencies: usize = (0..=degree).map(|l| (l + 1) * (l.min(order) + 1)).sum();
        let selection = if self.selection.is_empty() { 0 } else { gram.places() };
        numbers("nodes", &gram.nodes, nodes)?;
        numbers("root weights", &gram.root_weights, nodes)?;
        let projects = usize::from(self.has_projection());
        numbers("gains", &gram.gains, projects * material::count(order))?;
        numbers("polar integrals", &gram.polar_integrals, projects * pairs * (degree + 1))?;
        numbers("radials", &gram.radials, projects * pairs * nodes)?;
        numbers("rotations", &gram.rotations, projects * frequencies * nodes)?;
        length("selection", self.selection.len(), selection)?;
        self.check_summary(nodes)?;
        for profile in &self.profiles {
            let azimuth = profile.azimuth;
            if azimuth > degree {
                return Err(format!("a profile of azimuth {azimuth} above degree {degree}"));
            }
            numbers("profile's node values", &profile.node_values, nodes)?;
            let modes = if self.has_modes() { mode::count(degree, order, azimuth) } else { 0 };
            numbers("profile's modes", &profile.modes, modes)?;
            let factors = projects * pairs * (degree - azimuth + 1);
            numbers("profile's factors", &profile.factors, factors)?;
            terms("profile's polynomial", &profile.chebyshev)?;
        }
        if !self.profiles.is_sorted_by_key(|profile| profile.azimuth) {
            return Err("profiles not sorted by azimuth".into());
        }
        if self.has_projection() {
            length("transfers", self.transfers.len(), 0)?;
        }
        for transfer in &self.transfers {
            numbers("a material's transfer", &transfer.numbers, self.transfer_length())?;
        }
        self.check_components()?;
        let standard = self.scene.basis.criterion == Criterion::Standard;
        if self.mean.is_some() != standard {
            return Err("a mean image is present exactly with criterion = \"standard\"".into());
        }
        if let Some(mean) = &self.mean {
            terms("mean image", &mean.chebyshev)?;
            numbers("mean's coefficients", &mean.coefficients, self.components.len())?;
        }
        Ok(())
    }

    fn check_summary(&self, nodes: usize) -> Result<(), String> {
        let summary = &self.summary;
        length("ranks", summary.ranks.len(), self.gram.degree + 1)?;
        if summary.ranks.iter().any(|&rank| rank > nodes) {
            return Err(format!("a rank above the number of nodes, {nodes}"));
        }
        let figures = [
            summary.largest_singular_value,
            summary.energy,
            summary.energy_kept,
            summary.orthonormality,
        ];
        numbers("figures", &figures, figures.len())?;
        let errors: Vec<f64> =
            summary.roundings.iter().flat_map(|one| [one.largest, one.rms]).collect();
        numbers("errors of formats", &errors, errors.len())?;
        let spectrum = self.spectrum.iter().map(|(_, value)| *value);
        let components = self.components.iter().map(|component| component.eigenvalue);
        let values: Vec<f64> = spectrum.chain(components).flatten().collect();
        numbers("eigenvalues", &values, values.len())
    }

    /// Checks that each component has a profile of its own azimuth, and that each profile belongs
    /// to at most one component of each sign.
    fn check_components(&self) -> Result<(), String> {
        if self.components.len() > usize::from(NONE) {
            return Err(format!("{} components, more than {NONE}", self.components.len()));
        }
        let mut served = vec![[false; 2]; self.profiles.len()];
        for (index, component) in self.components.iter().enumerate() {
            let azimuth = component.order.unsigned_abs() as usize;
            let profile = self.profiles.get(component.profile);
            let taken = served.get_mut(component.profile);
            let (Some(profile), Some(taken)) = (profile, taken) else {
                return Err(format!("component {index} has no profile"));
            };
            if profile.azimuth != azimuth {
                return Err(format!("component {index} has a profile of another azimuth"));
            }
            let [plus, minus] = taken;
            if std::mem::replace(if component.order < 0 { minus } else { plus }, true) {
                return Err(format!("component {index} is a duplicate"));
            }
        }
        if served.contains(&[false; 2]) {
            return Err("a profile that no component uses".into());
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

/// Checks a polynomial: it has at least one term and at most [`MAX_TERMS`].
fn terms(what: &str, values: &[f64]) -> Result<(), String> {
    if values.is_empty() || values.len() > MAX_TERMS {
        return Err(format!("{what}: 1 to {MAX_TERMS} terms expected, {} found", values.len()));
    }
    numbers(what, values, values.len())
}
