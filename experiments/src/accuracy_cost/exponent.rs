//! Fits the exponent of a power law.

/// a and b of y = a x^b, fitted in logarithms to the upper half of the points, where the highest
/// power dominates. `None` for fewer than two points.
#[must_use]
pub fn fit(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let upper = &points[points.len() / 2 - usize::from(points.len() == 3 || points.len() == 2)..];
    if upper.len() < 2 {
        return None;
    }
    let logs: Vec<(f64, f64)> = upper.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|log| log.0), mean(|log| log.1));
    let product: f64 = logs.iter().map(|log| (log.0 - x) * (log.1 - y)).sum();
    let square: f64 = logs.iter().map(|log| (log.0 - x).powi(2)).sum();
    (square > 0.0).then(|| ((y - product / square * x).exp(), product / square))
}

#[cfg(test)]
mod tests {
    use super::fit;

    #[test]
    fn powers_come_back() {
        let points: Vec<(f64, f64)> =
            (1..9).map(f64::from).map(|x| (x, 3.0 * x.powf(1.5))).collect();
        let (a, b) = fit(&points).unwrap();
        assert!((a - 3.0).abs() < 1e-12 && (b - 1.5).abs() < 1e-12);
        assert!(fit(&points[..2]).is_some() && fit(&points[..1]).is_none());
        assert!(fit(&[]).is_none());
    }
}
