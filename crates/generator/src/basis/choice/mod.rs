//! Chooses the sizes that a tolerance requires: the degree L of the light, the order O of the
//! material, the number of components and the number of polynomial terms.
//!
//! The tolerance bounds the root mean square error of the database's images, with the light turned
//! by all rotations, relative to the database's [`peak`](database::peak). The reference is the
//! image at the degree and order that the scene gives. Let D be the mean energy of the images in
//! degrees above L, O' the energy in orders above O at degrees up to L, R the energy in the omitted
//! components and P the energy that the polynomials omit. Then error² <= D + (√O' + √(R + P))²:
//!
//! Degrees are uncorrelated over all rotations, (38), and so are the coefficients of components.
//! Orders are correlated, so they use the triangle inequality. Every energy is a sum of squares of
//! the database's images in the coordinates of their profile spaces: no pixel is shaded.

mod candidates;
mod report;

use report::Remaining;
pub use report::{Choice, Reach, Share};

use crate::basis::analysis::Analysis;
use crate::basis::choice::report::{POLYNOMIALS, budget};
use crate::basis::database;
use crate::basis::profile::evaluate;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::trim::trim;
use eigenshade_table::{Scene, Table};

/// Before polynomials are shortened, each is within this fraction of the tolerance, relative to its
/// profile's largest value.
const WHOLE: f64 = 0.01;

/// The lower limit of that accuracy, set by rounding.
const NEAREST: f64 = 1e-13;

/// Relative amount by which the total may exceed the tolerance, to allow for rounding in sums.
const ROUNDING: f64 = 1e-9;

/// Makes the smallest table within a tolerance, and reports what was chosen. The databases have
/// exactly the scene's degree and order.
///
/// # Errors
///
/// The errors of `basis::build`.
pub(crate) fn within(
    tolerance: f64,
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Table, Choice)> {
    let peak = database::peak(scene, lights, materials)?;
    database::in_range(peak)?;
    let allowed = (tolerance * peak).powi(2);
    let mut picked = scene.clone();
    let mut left = [0.0; 2];
    let reach = if scene.basis.modes > 0 {
        Reach::AsAsked("basis.modes chooses among the modes of all")
    } else if allowed == 0.0 {
        Reach::AsAsked("all images are black")
    } else {
        let found = candidates::least(scene, lights, materials, allowed)?;
        (picked.light.degree, picked.material.order) = (found.degree, found.order);
        left = [found.degrees_left, found.orders_left];
        found.reach(scene, peak)
    };
    let lights = lights.truncated(picked.light.degree);
    let analysis = Analysis::new(&picked, &lights, &materials.truncated(picked.material.order))?;
    let spectrum = analysis.spectrum();
    let remaining = Remaining::new(&spectrum, analysis.dropped());
    let budget = budget(allowed, left);
    let count = remaining.least((1.0 - POLYNOMIALS) * budget);
    let leaves = remaining.left(count);

    let start = scene.basis.profile_tolerance.min((WHOLE * tolerance).max(NEAREST));
    let mut table = analysis.table(count, start);
    let mean = analysis.mean_values();
    let most_terms = table.terms();
    let lost = left_out(&table, mean.as_deref());
    let allowed = ((budget - leaves).max(0.0).sqrt() - lost.sqrt()).max(0.0);
    let size = table.summary.energy.sqrt();
    if size > 0.0 {
        trim(&mut table, allowed / size);
    }
    let lost = left_out(&table, mean.as_deref());
    let share = |energy| report::of_peak(energy, peak);
    let choice = Choice {
        tolerance,
        peak,
        reach,
        components: remaining.share(count, share),
        terms: Share { kept: table.terms(), of: most_terms, leaves: share(lost), one_less: None },
        total: share(left[0] + (left[1].sqrt() + (leaves + lost).sqrt()).powi(2)),
    };
    if choice.total > tolerance * (1.0 + ROUNDING) {
        return Err(Error::new(
            format!("basis.tolerance = {tolerance:e} is not met, only {:.1e}", choice.total),
            "use a smaller rank_cutoff, or a larger tolerance",
        ));
    }
    Ok((table, choice))
}

/// Mean energy of the database's images that the polynomials omit. The coefficients of components
/// are uncorrelated, so each profile's squared error at the nodes is weighted by the eigenvalues of
/// its components. The mean image's error counts once; its weighted node values are `mean`.
fn left_out(table: &Table, mean: Option<&[f64]>) -> f64 {
    let gram = &table.gram;
    let error = |azimuth: usize, series: &[f64], values: &[f64]| -> f64 {
        let nodes = gram.nodes.iter().zip(&gram.root_weights).zip(values);
        let squares = nodes.map(|((&z, root), value)| {
            let sine = ((1.0 - z) * (1.0 + z)).sqrt().powi(azimuth as i32);
            (root * sine * evaluate(series, z) - value).powi(2)
        });
        squares.sum()
    };
    let of_mean =
        table.mean.iter().zip(mean).map(|(mean, values)| error(0, &mean.chebyshev, values));
    let mut lost: f64 = of_mean.sum();
    for (k, profile) in table.profiles.iter().enumerate() {
        let of_profile = table.components.iter().filter(|component| component.profile == k);
        let variance: f64 = of_profile.filter_map(|component| component.eigenvalue).sum();
        lost += variance * error(profile.azimuth, &profile.chebyshev, &profile.node_values);
    }
    lost
}
