//! Quadrature: Gauss-Legendre rules, and panels of them for functions that change fast near known
//! places.

use std::f64::consts::PI;

/// `count` ascending nodes and their weights on \[low, high\], exact for polynomials of degree 2
/// `count` - 1 to a few ulp.
///
/// Newton's method on the three-term recurrence, from the usual cosine guess, converges
/// quadratically: a few steps reach the last bit.
#[must_use]
pub fn gauss_legendre(count: usize, low: f64, high: f64) -> Vec<(f64, f64)> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    (0..count)
        .rev()
        .map(|k| {
            let mut x = (PI * (k as f64 + 0.75) / (count as f64 + 0.5)).cos();
            for _ in 0..8 {
                let (value, slope) = legendre(count, x);
                x -= value / slope;
            }
            let (_, slope) = legendre(count, x);
            (middle + half * x, half * 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// P_n(x) and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0));
    }
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}

/// A place near which a function changes over a short distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature {
    /// The place, inside the interval or at one of its ends.
    pub at: f64,
    /// The distance, above zero. The function's singularities have at least this distance from the
    /// real axis at the feature, and proportionally more farther away.
    pub scale: f64,
}

/// Ascending nodes and weights on \[low, high\], from a Gauss-Legendre rule on \[0, 1\].
///
/// The rule is repeated on panels. Next to a feature a panel is as wide as the feature's scale; the
/// width doubles with the distance from it and never exceeds `widest`.
///
/// A pole one scale away from its feature causes an error of about 5^(-2 n) of the function's size,
/// with n nodes in the rule.
#[must_use]
pub fn spread(
    unit: &[(f64, f64)],
    low: f64,
    high: f64,
    features: &[Feature],
    widest: f64,
) -> Vec<(f64, f64)> {
    let mut stops: Vec<f64> = features.iter().map(|feature| feature.at).collect();
    stops.extend([low, high]);
    stops.retain(|stop| (low..=high).contains(stop));
    stops.sort_by(f64::total_cmp);
    stops.dedup();
    // The largest allowed width of a panel that begins or ends at a place.
    let allowed = |place: f64| {
        features
            .iter()
            .fold(widest, |most, feature| most.min((place - feature.at).abs().max(feature.scale)))
    };
    let mut nodes = Vec::new();
    for pair in stops.windows(2) {
        let &[start, end] = pair else { continue };
        // From both ends toward the middle.
        let (mut left, mut right) = (start, end);
        let mut panels = Vec::new();
        let mut mirrored = Vec::new();
        loop {
            let (from_left, from_right) = (allowed(left), allowed(right));
            let gap = right - left;
            if gap <= from_left.min(from_right) {
                panels.push((left, right));
                break;
            }
            if from_left <= from_right {
                let next = if gap < 2.0 * from_left { left + 0.5 * gap } else { left + from_left };
                panels.push((left, next));
                left = next;
            } else {
                let next =
                    if gap < 2.0 * from_right { left + 0.5 * gap } else { right - from_right };
                mirrored.push((next, right));
                right = next;
            }
        }
        panels.extend(mirrored.into_iter().rev());
        for (left, right) in panels {
            nodes.extend(
                unit.iter().map(|(x, weight)| (left + (right - left) * x, (right - left) * weight)),
            );
        }
    }
    nodes
}
