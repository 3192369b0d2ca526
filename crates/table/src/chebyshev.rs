//! Chebyshev series.

use eigenshade_index::layout::Form;

/// t times a Chebyshev series: t T_0 = T_1, t T_k = (T_k-1 + T_k+1) / 2.
pub(crate) fn times_argument(series: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; series.len() + 1];
    for (k, term) in series.iter().enumerate() {
        let half = if k == 0 { *term } else { 0.5 * term };
        product[k + 1] += half;
        if k > 0 {
            product[k - 1] += half;
        }
    }
    product
}

/// The value of a Chebyshev series, by Clenshaw's recurrence.
pub(crate) fn clenshaw(series: &[f64], t: f64) -> f64 {
    let (mut next, mut after) = (0.0, 0.0);
    for coefficient in series.iter().skip(1).rev() {
        (next, after) = (coefficient + 2.0 * t * next - after, next);
    }
    series.first().copied().unwrap_or(0.0) + t * next - after
}

/// Converts a Chebyshev series to a polynomial of `length` terms, highest first, in the form that
/// this length determines. `length` is at least the length of the series.
pub(crate) fn polynomial(chebyshev: &[f64], length: usize) -> Vec<f64> {
    let form = Form::of(length);
    let mut terms = vec![0.0; length];
    // T_0 = 1, T_1 = t, T_k+1 = 2 t T_k - T_k-1; lowest term first.
    let mut before = vec![0.0; length];
    let mut current = vec![0.0; length];
    current.first_mut().into_iter().for_each(|one| *one = 1.0);
    let mut factor = 1.0;
    for coefficient in chebyshev {
        for (sum, term) in terms.iter_mut().zip(&current) {
            *sum += coefficient * term;
        }
        let mut next: Vec<f64> = before.iter().map(|before| -before).collect();
        for (k, term) in current.iter().enumerate() {
            let [above, below] = form.recurrence(k).map(|share| factor * share * term);
            if let Some(next) = next.get_mut(k + 1) {
                *next += above;
            }
            if let Some(next) = k.checked_sub(1).and_then(|k| next.get_mut(k)) {
                *next += below;
            }
        }
        before = std::mem::replace(&mut current, next);
        factor = 2.0;
    }
    terms.reverse();
    terms
}

#[cfg(test)]
mod tests {
    use super::polynomial;

    #[test]
    fn short_chebyshev_series_become_powers() {
        // T_0 + 2 T_1 + 3 T_2 + 4 T_3 = 1 + 2t + 3(2t² - 1) + 4(4t³ - 3t).
        assert_eq!(polynomial(&[1.0, 2.0, 3.0, 4.0], 5), [0.0, 16.0, 6.0, -10.0, -2.0]);
        assert_eq!(polynomial(&[7.0], 1), [7.0]);
        assert_eq!(polynomial(&[], 2), [0.0, 0.0]);
    }

    #[test]
    fn longer_ones_become_halves() {
        // T_0 + 2 T_1 + 3 T_2 + 4 T_3 + 5 T_4 = 1 + 2t + 3u + 4(2tu - t) + 5(2u² - 1).
        let mut halves = [0.0; 17];
        halves[12..].copy_from_slice(&[10.0, 8.0, 3.0, -2.0, -4.0]);
        assert_eq!(polynomial(&[1.0, 2.0, 3.0, 4.0, 5.0], 17), halves);
    }
}
