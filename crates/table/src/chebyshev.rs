//! Chebyshev series.

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

/// How a polynomial in t is written, highest term first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// In 1, t, t², ...: the form of integers.
    Powers,
    /// In 1, t, u, tu, u², tu², ... with u = 2t² - 1: the form of floats.
    Halves,
}

/// Converts a Chebyshev series to a polynomial of `length` terms, highest first. `length` is at least
/// the length of the series.
pub(crate) fn polynomial(chebyshev: &[f64], length: usize, form: Form) -> Vec<f64> {
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
            // t times a term is the next one; t times tu^k is (u^k+1 + u^k) / 2.
            let halved = form == Form::Halves && k % 2 == 1;
            let product = factor * if halved { 0.5 * term } else { *term };
            if let Some(next) = next.get_mut(k + 1) {
                *next += product;
            }
            if halved {
                next[k - 1] += product;
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
    use super::Form::{Halves, Powers};
    use super::polynomial;

    #[test]
    fn chebyshev_series_become_powers() {
        // T_0 + 2 T_1 + 3 T_2 + 4 T_3 = 1 + 2t + 3(2t² - 1) + 4(4t³ - 3t).
        assert_eq!(polynomial(&[1.0, 2.0, 3.0, 4.0], 5, Powers), [0.0, 16.0, 6.0, -10.0, -2.0]);
        assert_eq!(polynomial(&[7.0], 1, Powers), [7.0]);
        assert_eq!(polynomial(&[], 2, Powers), [0.0, 0.0]);
    }

    #[test]
    fn chebyshev_series_become_halves() {
        // T_0 + 2 T_1 + 3 T_2 + 4 T_3 + 5 T_4 = 1 + 2t + 3u + 4(2tu - t) + 5(2u² - 1).
        let series = [1.0, 2.0, 3.0, 4.0, 5.0];
        assert_eq!(polynomial(&series, 6, Halves), [0.0, 10.0, 8.0, 3.0, -2.0, -4.0]);
        assert_eq!(polynomial(&series[..2], 2, Halves), [2.0, 1.0]);
    }
}
