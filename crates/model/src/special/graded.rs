//! Quadrature of functions that change fast beside known places.

use super::gauss_legendre;

/// A place beside which a function changes over a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature {
    /// Where; within the interval or at its ends.
    pub at: f64,
    /// The distance, above zero: the function is analytic but for points that are as
    /// far from the axis here, and in proportion farther away.
    pub scale: f64,
}

/// Nodes and weights on \[low, high\], rising: Gauss-Legendre rules of `count` nodes on
/// panels that begin as wide as the scale beside each feature, double with the
/// distance from it, and are nowhere wider than `widest`.
///
/// A pole at the distance of the scale from its feature leaves some 5^(-2 count) of
/// the function's size.
#[must_use]
pub fn rule(
    count: usize,
    low: f64,
    high: f64,
    features: &[Feature],
    widest: f64,
) -> Vec<(f64, f64)> {
    let unit = gauss_legendre::rule(count, 0.0, 1.0);
    spread(&unit, low, high, features, widest)
}

/// The same with the rule of \[0, 1\] at hand.
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
    // The widest panel that may begin or end at a place.
    let allowed = |place: f64| {
        features
            .iter()
            .fold(widest, |most, feature| most.min((place - feature.at).abs().max(feature.scale)))
    };
    let mut nodes = Vec::new();
    for pair in stops.windows(2) {
        let &[start, end] = pair else { continue };
        // From both ends towards the middle.
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
