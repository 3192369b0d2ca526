//! The Pareto front: the points that no other point beats in both error and cost.

/// A point: its cost and its error.
pub type Point = (f64, f64);

/// The indices of the points on the front, by rising cost. For each of them, every point that is as
/// cheap or cheaper has a larger error.
#[must_use]
pub fn front(points: &[Point]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.retain(|&k| points[k].0.is_finite() && points[k].1.is_finite());
    order.sort_by(|&a, &b| {
        let by_cost = points[a].0.total_cmp(&points[b].0);
        by_cost.then(points[a].1.total_cmp(&points[b].1))
    });
    let mut least = f64::INFINITY;
    order.retain(|&k| {
        let better = points[k].1 < least;
        least = least.min(points[k].1);
        better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::front;

    #[test]
    fn nothing_beats_a_point_of_the_front_and_something_every_other() {
        let points = [
            (3.0, 0.5),
            (1.0, 1.0),
            (2.0, 1.0),
            (3.0, 0.4),
            (4.0, 0.4),
            (9.0, 0.1),
            (f64::NAN, 0.0),
        ];
        assert_eq!(front(&points), [1, 3, 5]);
        assert!(front(&[]).is_empty());
    }
}
