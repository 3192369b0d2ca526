//! Describes the truncation that a tolerance chose.

use eigenshade::{Economy, Scalar};

/// Describes what was kept of `components` and what it costs, for one image in one channel or for
/// many images. Adds the error of the number format as a share of the peak.
#[must_use]
pub fn lines<S: Scalar + Into<f64>>(
    chosen: &[Economy<S>],
    components: usize,
    rounding: f64,
) -> Vec<String> {
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
        [one.bound, one.left_out_by_components, one.left_out_by_terms, one.floor].map(of)
    };
    let floor = chosen.iter().map(|one| share(one)[3]).fold(0.0, f64::max);
    let worst = chosen.iter().map(share).max_by(|a, b| a[0].total_cmp(&b[0]));
    let [worst, by_components, by_terms, _] = worst.unwrap_or_default();
    let worst = raised(worst + rounding);
    vec![
        format!(
            "kept: {} of {components} components, {} azimuths, {} polynomial terms",
            span(|one| one.components),
            span(|one| one.azimuths),
            span(|one| one.terms),
        ),
        format!(
            "left out of the image of {components} components, rms over a picture of a sphere: \
             at most {worst:.1e} of the brightest channel's peak, {by_components:.1e} by \
             components, {by_terms:.1e} by terms and {rounding:.1e} by rounding"
        ),
        format!(
            "estimated beyond these components, rms over a picture of a sphere: {floor:.1e} of \
             that peak"
        ),
    ]
}

/// Rounds up to two digits, so that a printed bound remains a bound.
fn raised(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let unit = 10f64.powf(value.log10().floor() - 1.0);
    (value / unit).ceil() * unit
}

#[cfg(test)]
mod tests {
    use super::raised;

    #[test]
    fn a_printed_bound_is_no_smaller() {
        for value in [0.0, 1.0, 0.0101, 9.91e-3, 9.99e-7, 1.234e-5, 3e-2] {
            let printed: f64 = format!("{:.1e}", raised(value)).parse().expect("a number");
            assert!(printed >= value && printed <= 1.1 * value, "{printed} of {value}");
        }
    }
}
