//! Floating-point rotations as a twist about the view axis and a swing.

use super::degree::{Arithmetic, Multiples, Turn};
use crate::mathematics::Mathematics;
use crate::rotation::Rotation;
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// The arithmetic of a floating-point format.
pub(super) struct Floats<S>(PhantomData<S>);

impl<S: Scalar> Arithmetic for Floats<S> {
    type Number = S;
    type Factor = S;
    type Element = S;
    type Sum = S;
    #[inline(always)]
    fn product([c, s]: [S; 2], [x, y]: [S; 2]) -> [S; 2] {
        [(c * x).add_product(-s, y), (c * y).add_product(s, x)]
    }
    #[inline(always)]
    fn add_product(sum: S, element: S, number: S) -> S {
        sum.add_product(element, number)
    }
    #[inline(always)]
    fn number(sum: S) -> S {
        sum
    }
}

impl<S: Scalar> Rotation<S> {
    /// This rotation, prepared. A rotation and its inverse have the same numbers, so that one
    /// undoes the other up to the rounding of the coefficients.
    pub(super) fn turn<M: Mathematics<S>>(&self) -> Turn<S> {
        let (Self { matrix }, is_inverse) = self.upright();
        let [[xx, xy, xz], [yx, yy, yz], [_, _, zz]] = matrix;
        let flips = zz < S::ZERO;
        let [xx, yx, xz, yz, zz] =
            if flips { [-xx, -yx, -xz, -yz, -zz] } else { [xx, yx, xz, yz, zz] };
        // The upper left block is 1 + cos b times the rotation by γ, but for a symmetric part of
        // trace zero.
        let scale = (S::ONE + zz).reciprocal();
        let twist = [(xx + yy) * scale, (yx - xy) * scale];
        // The swing moves the view axis to this column. Its square is a normal number, or it is
        // moved by less than the rounding of any coefficient.
        let square = xz * xz + yz * yz;
        let (axis, sine) = if square > S::from_f64(1e-37) {
            let inverse = M::inverse_root(square);
            ([xz * inverse, yz * inverse], square * inverse)
        } else {
            ([S::ONE, S::ZERO], S::ZERO)
        };
        let [twist, swing] = match is_inverse {
            false => [twist, [zz, -sine]],
            true => [[twist[0], -twist[1]], [zz, sine]],
        };
        let [twist, axis, swing] = [twist, axis, swing].map(multiples);
        Turn { flips, is_inverse, twist, axis, swing }
    }

    /// Either this rotation or its inverse, chosen the same way for both, and whether it is the
    /// inverse.
    pub(super) fn upright(&self) -> (Self, bool) {
        let [[_, xy, xz], [yx, _, yz], [zx, zy, _]] = self.matrix;
        let apart = [xy - yx, xz - zx, yz - zy].into_iter().find(|&apart| apart != S::ZERO);
        match apart {
            Some(apart) if apart < S::ZERO => (self.inverse(), true),
            _ => (*self, false),
        }
    }
}

/// The multiples of an angle, by the product of (1 + x) and (1 + y) less 1.
fn multiples<S: Scalar>([c, s]: [S; 2]) -> Multiples<S> {
    let first = unit([c - S::ONE, s]);
    let [a, b] = first;
    let mut next = first;
    core::array::from_fn(|_: usize| {
        let [c, s] = next;
        next = unit([a + c + (a * c - b * s), b + s + (a * s + b * c)]);
        [c, s]
    })
}

/// Makes 1 + c + is a number of absolute value 1, by a step of Newton's method.
fn unit<S: Scalar>([c, s]: [S; 2]) -> [S; 2] {
    let excess = c * (c + S::from_whole(2)) + s * s;
    let half = S::from_f64(0.5) * excess;
    [c - (S::ONE + c) * half, s - s * half]
}
