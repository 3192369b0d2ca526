//! Chooses the sizes that a tolerance requires: the degree L of the light, the order O of the
//! material, the number of components and the number of polynomial terms.
//!
//! The tolerance bounds the root mean square error of the database's images, with the light turned
//! by all rotations, relative to the database's [`peak`]. The reference is the image at the degree
//! and order that the scene gives. Let D be the mean energy of the images in degrees above L, O'
//! the energy in orders above O at degrees up to L, R the energy in the omitted components and P
//! the energy that the polynomials omit. Then
//! error² <= D + (√O' + √(R + P))²:
//!
//! Degrees are uncorrelated over all rotations, (38), and so are the coefficients of components.
//! Orders are correlated, so they use the triangle inequality. Every energy is a sum of squares of
//! the database's images in the coordinates of their profile spaces: no pixel is shaded.

mod below;
mod candidates;
mod energies;
mod polynomials;
mod said;

pub use said::{Choice, Reach, Share};

pub(crate) use below::Below;

use crate::basis;
use crate::basis::analysis::Analysis;
use crate::basis::peak;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::trim::trim;
use eigenshade_table::{Scene, Table};

/// The smallest fraction that the polynomials get of the energy that components and polynomials may
/// omit.
const POLYNOMIALS: f64 = 0.1;

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
/// The errors of [`basis::build`].
pub(crate) fn within(
    tolerance: f64,
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Table, Choice)> {
    let peak = peak::of(scene, lights, materials)?;
    basis::in_range(peak)?;
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
    let below = Below::new(&spectrum, analysis.dropped());
    let budget = budget(allowed, left);
    let count = below.least((1.0 - POLYNOMIALS) * budget);
    let leaves = below.left(count);

    let start = scene.basis.profile_tolerance.min((WHOLE * tolerance).max(NEAREST));
    let mut table = analysis.table(count, start);
    let mean = analysis.mean_values();
    let of_terms = polynomials::terms(&table);
    let lost = polynomials::left_out(&table, mean.as_deref());
    let spare = ((budget - leaves).max(0.0).sqrt() - lost.sqrt()).max(0.0);
    let size = table.summary.energy.sqrt();
    if size > 0.0 {
        trim(&mut table, spare / size);
    }
    let lost = polynomials::left_out(&table, mean.as_deref());
    let share = |energy| said::of_peak(energy, peak);
    let choice = Choice {
        tolerance,
        peak,
        reach,
        components: below.share(count, share),
        terms: Some(Share {
            kept: polynomials::terms(&table),
            of: of_terms,
            leaves: share(lost),
            one_less: None,
        }),
        total: share(left[0] + (left[1].sqrt() + (leaves + lost).sqrt()).powi(2)),
    };
    if choice.total > tolerance * (1.0 + ROUNDING) {
        return Err(Error::new(
            format!("basis.tolerance = {tolerance:e} is not met: {:.1e} is", choice.total),
            "take a smaller rank_cutoff, or a larger tolerance",
        ));
    }
    Ok((table, choice))
}

/// The energy R + P that is allowed after degrees and orders are left out.
fn budget(allowed: f64, [degrees, orders]: [f64; 2]) -> f64 {
    ((allowed - degrees).max(0.0).sqrt() - orders.sqrt()).max(0.0).powi(2)
}
