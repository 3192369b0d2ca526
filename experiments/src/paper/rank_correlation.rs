//! Spearman's rank correlation.

/// The rank correlation of two sequences, in [-1, 1]; it is 1 if the two have the same order. Equal
/// numbers share their lowest rank.
#[must_use]
pub fn rank_correlation(a: &[f64], b: &[f64]) -> f64 {
    let [a, b] = [a, b].map(|values| {
        let below = |value: &f64| values.iter().filter(|other| *other < value).count() as f64;
        let middle = 0.5 * (values.len() as f64 - 1.0);
        values.iter().map(|value| below(value) - middle).collect::<Vec<f64>>()
    });
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    product(&a, &b) / (product(&a, &a) * product(&b, &b)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::rank_correlation;

    #[test]
    fn ranks_alone_count() {
        let near = |a: &[f64], b: &[f64], expected: f64| {
            assert!((rank_correlation(a, b) - expected).abs() < 1e-15);
        };
        near(&[1.0, 2.0, 9.0], &[-7.0, 0.1, 0.2], 1.0);
        near(&[1.0, 2.0, 9.0], &[3.0, 2.0, 1.0], -1.0);
        // 1 - 6 Σ d² / (n (n² - 1)), where d are the differences of the ranks 1 2 3 4 and 2 1 4 3.
        near(&[1.0, 2.0, 3.0, 4.0], &[2.0, 1.0, 4.0, 3.0], 1.0 - 24.0 / 60.0);
    }
}
