//! Medians, and numbers in CSV files and in the tables of pages.

use eigenshade_cli::output::exact;

/// The median: the mean of the middle two if their number is even, NaN if there are none.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match sorted.len() {
        0 => f64::NAN,
        count if count % 2 == 1 => sorted[middle],
        _ => 0.5 * (sorted[middle - 1] + sorted[middle]),
    }
}

/// A number with this many significant digits, without needless ones.
pub fn digits(value: f64, count: usize) -> String {
    exact(format!("{value:.*e}", count - 1).parse().unwrap_or(value))
}

/// A share in percent, with this many significant digits but at most six decimal places.
pub fn percent(share: f64, digits: i32) -> String {
    let value = 100.0 * share;
    let magnitude = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    let places = usize::try_from(digits - 1 - magnitude).unwrap_or(0).min(6);
    format!("{value:.places$} %")
}

/// A limit in percent, without needless digits.
pub fn limit(share: f64) -> String {
    let value = format!("{:.6}", 100.0 * share);
    format!("{} %", value.trim_end_matches('0').trim_end_matches('.'))
}

/// The factor that scales the value below which a `share` lies to 1; 1 if it is not positive.
pub fn exposure(mut values: Vec<f64>, share: f64) -> f64 {
    values.retain(|value| value.is_finite());
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    let place = (share.clamp(0.0, 1.0) * last as f64).round() as usize;
    match values.get(place) {
        Some(&value) if value > 0.0 => value.recip(),
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{digits, exposure, limit, percent};

    #[test]
    fn shares_have_three_digits() {
        let shares = [0.0, 1e-5, 0.00744, -0.0744, 0.174, 0.9926, 1.0];
        let expected = ["0.00 %", "0.00100 %", "0.744 %", "-7.44 %", "17.4 %", "99.3 %", "100 %"];
        assert_eq!(shares.map(|share| percent(share, 3)), expected);
        assert_eq!(percent(0.00744, 2), "0.74 %");
    }

    #[test]
    fn limits_and_measures_have_no_needless_digits() {
        assert_eq!([0.3, 0.01, 1e-6].map(limit), ["30 %", "1 %", "0.0001 %"]);
        assert_eq!(
            [0.25, 1.0 / 3.0, 2e-7 / 3.0].map(|one| digits(one, 4)),
            ["0.25", "0.3333", "6.667e-8"]
        );
    }

    #[test]
    fn exposures_follow_the_percentile() {
        let values: Vec<f64> = (0..=100).map(f64::from).collect();
        assert_eq!(exposure(values, 0.5), 1.0 / 50.0);
        assert_eq!(exposure(vec![], 0.5), 1.0);
        assert_eq!(exposure(vec![-1.0], 1.0), 1.0);
    }
}
