//! What a tolerance chose, in words.

use eigenshade::{Economy, Scalar};

/// For one image in one channel, or for many, what was kept of `components` and what it costs.
#[must_use]
pub fn lines<S: Scalar + Into<f64>>(chosen: &[Economy<S>], components: usize) -> Vec<String> {
    let span = |of: fn(&Economy<S>) -> usize| {
        let values = chosen.iter().map(of);
        match (values.clone().min(), values.max()) {
            (Some(least), Some(most)) if least == most => least.to_string(),
            (Some(least), Some(most)) => format!("{least} to {most}"),
            _ => "none".to_owned(),
        }
    };
    let share = |one: &Economy<S>| {
        let (bound, peak): (f64, f64) = (one.bound.into(), one.peak.into());
        if peak > 0.0 { bound / peak } else { 0.0 }
    };
    let worst = chosen.iter().map(share).fold(0.0, f64::max);
    vec![
        format!(
            "kept: {} of {components} components, {} azimuths, {} polynomial terms",
            span(|one| one.components),
            span(|one| one.azimuths),
            span(|one| one.terms),
        ),
        format!(
            "left out of the image of {components} components, rms over a sphere: at most {worst:.1e} \
             of the peak"
        ),
    ]
}
