//! A twist, which is a rotation about z: it turns each pair of orders m and -m by m times the angle.

use crate::index::light;
use crate::light::degree;

/// A twist in a number format.
pub(crate) trait Twist {
    type Coefficient: Copy;
    type Factor: Copy;
    /// The result for a coefficient of order 0.
    fn zonal(&self, coefficient: Self::Coefficient) -> Self::Coefficient;
    /// Cosine and sine of m times the angle. Called for m = 1, 2, ... in turn.
    fn factor(&mut self, m: usize) -> Self::Factor;
    /// The pair (x, y) turned from x toward y, and whether the results fit.
    fn pair(
        &self,
        factor: Self::Factor,
        pair: [Self::Coefficient; 2],
    ) -> ([Self::Coefficient; 2], bool);
}

/// Turns a light of a degree that is known at run time. Stops where a result does not fit, and
/// returns whether all do.
#[inline(always)]
pub(crate) fn turn<T: Twist>(
    mut twist: T,
    degree: usize,
    from: &[T::Coefficient],
    to: &mut [T::Coefficient],
) -> bool {
    zonal(&twist, degree, from, to);
    (1..=degree).all(|m| {
        let factor = twist.factor(m);
        (m..=degree).all(|l| pair(&twist, factor, [l, m], from, to))
    })
}

/// For each order m up to the degree, which is at most 12, a first step, then one for each degree l
/// from m on. All are literals: the compiler would keep the longest loops, and addresses with them.
macro_rules! unrolled {
    ($m:ident in 1..=$degree:ident { $first:stmt; $l:ident => $step:expr }) => {
        unrolled!(@ $m $degree $l $first; $step;
            1 [0 1 2 3 4 5 6 7 8 9 10 11] 2 [0 1 2 3 4 5 6 7 8 9 10] 3 [0 1 2 3 4 5 6 7 8 9]
            4 [0 1 2 3 4 5 6 7 8] 5 [0 1 2 3 4 5 6 7] 6 [0 1 2 3 4 5 6] 7 [0 1 2 3 4 5]
            8 [0 1 2 3 4] 9 [0 1 2 3] 10 [0 1 2] 11 [0 1] 12 [0])
    };
    (@ $m:ident $degree:ident $l:ident $first:stmt; $step:expr; $($order:literal $above:tt)*) => {
        $({
            let $m: usize = $order;
            if $m <= $degree {
                $first
                unrolled!(# $m $degree $l $step; $above);
            }
        })*
    };
    (# $m:ident $degree:ident $l:ident $step:expr; [$($above:literal)*]) => {
        $({
            let $l: usize = $m + $above;
            if $l <= $degree {
                $step;
            }
        })*
    };
}

/// [`turn`] for as many coefficients as a light of a degree of at most 12 has, without a loop.
#[inline(always)]
pub(crate) fn turn_unrolled<T: Twist, const N: usize>(
    mut twist: T,
    from: &[T::Coefficient; N],
    to: &mut [T::Coefficient; N],
) -> bool {
    // No light has another length.
    let degree = const { if let Ok(degree) = degree(N) { degree } else { 0 } };
    zonal(&twist, degree, from, to);
    unrolled!(m in 1..=degree {
        let factor = twist.factor(m);
        l => if !pair(&twist, factor, [l, m], from, to) { return false }
    });
    true
}

#[inline(always)]
fn zonal<T: Twist>(twist: &T, degree: usize, from: &[T::Coefficient], to: &mut [T::Coefficient]) {
    for place in (0..=degree).map(|l| light::position(l, 0)) {
        if let (Some(to), Some(&coefficient)) = (to.get_mut(place), from.get(place)) {
            *to = twist.zonal(coefficient);
        }
    }
}

/// Turns the orders -m and m of degree l. Returns whether the results fit.
#[inline(always)]
fn pair<T: Twist>(
    twist: &T,
    factor: T::Factor,
    [l, m]: [usize; 2],
    from: &[T::Coefficient],
    to: &mut [T::Coefficient],
) -> bool {
    let first = light::position(l, -m.cast_signed());
    let pair = first..=first + 2 * m;
    match (from.get(pair.clone()), to.get_mut(pair)) {
        (Some(&[minus, .., plus]), Some([to_minus, .., to_plus])) => {
            // The harmonics of odd m > 0 have the sign -1, so the pair turns the other way.
            let ([x, y], fits);
            if m.is_multiple_of(2) {
                ([x, y], fits) = twist.pair(factor, [minus, plus]);
            } else {
                ([y, x], fits) = twist.pair(factor, [plus, minus]);
            }
            (*to_minus, *to_plus) = (x, y);
            fits
        }
        _ => true,
    }
}
