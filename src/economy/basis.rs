//! A polynomial in one basis rewritten in another, both with a recurrence of three terms.

use crate::index::layout::Form;
use crate::scalar::Scalar;

/// Most terms of what is rewritten.
pub(super) const MOST: usize = 64;

/// Polynomials e_k with t e_k = above e_k+1 + at e_k + below e_k-1.
pub(super) trait Recurrence<S> {
    /// above, at and below of e_k.
    fn term(&self, k: usize) -> [S; 3];
}

impl<S: Scalar> Recurrence<S> for Form {
    fn term(&self, k: usize) -> [S; 3] {
        let [above, below] = self.recurrence(k).map(S::from_f64);
        [above, S::ZERO, below]
    }
}

/// Rewrites terms, highest first, by Clenshaw's recurrence on polynomials: of `from` in `to`.
/// More than [`MOST`] stay as they are.
///
/// Cost: four products and four sums for each pair of terms.
pub(super) fn rewrite<S: Scalar>(
    terms: &mut [S],
    from: &impl Recurrence<S>,
    to: &impl Recurrence<S>,
) {
    if terms.len() > MOST {
        return;
    }
    // b_k = c_k + (t - at_k) / above_k b_k+1 - below_k+1 / above_k+1 b_k+2, lowest first; zero
    // beyond the terms that each has.
    let (mut one, mut two, mut three) = ([S::ZERO; MOST], [S::ZERO; MOST], [S::ZERO; MOST]);
    let (mut sum, mut next, mut after) = (&mut one, &mut two, &mut three);
    for (place, k) in (0..terms.len()).rev().enumerate() {
        let ([above, at, _], [above_next, _, below_next]) = (from.term(k), from.term(k + 1));
        let (scale, past) = (above.reciprocal(), -below_next * above_next.reciprocal());
        // t e_j-1 has above_j-1 of e_j.
        let (mut previous, mut above) = (S::ZERO, S::ZERO);
        let later = next.iter().skip(1).copied().chain([S::ZERO]);
        let of_next = next.iter().zip(later).zip(after.iter());
        for (j, (sum, ((&this, later), &after))) in
            sum.iter_mut().zip(of_next).enumerate().take(place + 1)
        {
            let ([above_here, here, _], [_, _, below]) = (to.term(j), to.term(j + 1));
            let times = (above * previous).add_product(here - at, this).add_product(below, later);
            *sum = (scale * times).add_product(past, after);
            (previous, above) = (this, above_here);
        }
        if let ([lowest, ..], Some(&term)) = (&mut *sum, terms.get(place)) {
            *lowest += term;
        }
        (sum, next, after) = (after, sum, next);
    }
    for (term, &rewritten) in terms.iter_mut().rev().zip(next.iter()) {
        *term = rewritten;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_become_other_forms_and_powers_again() {
        // t³ = (3 T_1 + T_3) / 4 = (t + tu) / 2; t² = (T_0 + T_2) / 2 = (1 + u) / 2.
        let cubic = [1.0f64, 3.0, 0.0, 0.0];
        for (form, other) in [
            (Form::Powers, cubic),
            (Form::Halves, [0.5, 1.5, 0.5, 1.5]),
            (Form::Series, [0.25, 1.5, 0.75, 1.5]),
        ] {
            let mut terms = cubic;
            rewrite(&mut terms, &Form::Powers, &form);
            assert_eq!(terms, other);
            rewrite(&mut terms, &form, &Form::Powers);
            assert_eq!(terms, cubic);
        }
    }
}
