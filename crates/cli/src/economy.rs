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
        let peak: f64 = one.peak.into();
        let of = |part: S| if peak > 0.0 { part.into() / peak } else { 0.0 };
        [one.bound, one.left_out_by_components, one.left_out_by_terms].map(of)
    };
    let worst = chosen.iter().map(share).max_by(|a, b| a[0].total_cmp(&b[0]));
    let [worst, by_components, by_terms] = worst.unwrap_or_default();
    vec![
        format!(
            "kept: {} of {components} components, {} azimuths, {} polynomial terms",
            span(|one| one.components),
            span(|one| one.azimuths),
            span(|one| one.terms),
        ),
        format!(
            "left out of the image of {components} components, rms over a sphere: at most {worst:.1e} \
             of the brightest channel's peak, {by_components:.1e} by components and {by_terms:.1e} by terms"
        ),
    ]
}
