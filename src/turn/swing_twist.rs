//! Floating-point rotations as a twist about the view axis and a swing.

use super::degree::{Arithmetic, Multiples, Turn};
use super::exchange::LARGEST;
use crate::mathematics::Mathematics;
use crate::rotation::Rotation;
use crate::scalar::Scalar;
use core::marker::PhantomData;

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
    pub(super) fn turn<M: Mathematics<S>>(&self, degree: usize) -> Turn<S> {
        let (Self { matrix }, is_inverse) = self.upright();
        let [[xx, xy, xz], [yx, yy, yz], [_, _, zz]] = matrix;
        let flips = zz < S::ZERO;
        let [xx, yx, xz, yz, zz] =
            if flips { [-xx, -yx, -xz, -yz, -zz] } else { [xx, yx, xz, yz, zz] };
        // The upper left block is 1 + cos b times the rotation by γ, plus a symmetric part of trace
        // zero.
        let ([cosine, of_cosine], [sine, of_sine]) = (sum(xx, yy), sum(yx, -xy));
        let twist = Angle::new([cosine, sine], [of_cosine, of_sine], (S::ONE + zz).reciprocal());
        // The swing moves the view axis to (xz, yz, zz). Below 1e-18 it changes no coefficient.
        let square = xz * xz + yz * yz;
        let (inverse, column) = match square > S::from_f64(1e-36) {
            true => (M::inverse_root(square), [xz, yz]),
            false => (S::ONE, [S::ONE, S::ZERO]),
        };
        let axis = Angle::new(column, [S::ZERO; 2], inverse);
        let sine = square * inverse;
        // Twice the sine times what it lacks.
        let [x, y] = if xz * xz > yz * yz { [xz, yz] } else { [yz, xz] };
        let error = (x * x - sine * sine + y * y)
            + (residual(x, x) + residual(y, y) - residual(sine, sine));
        let swing = Angle::new([zz, sine], [S::ZERO, S::from_f64(0.5) * error * inverse], S::ONE);
        let sign = if is_inverse { -S::ONE } else { S::ONE };
        Turn {
            flips,
            is_inverse,
            swings: sine > S::ZERO,
            is_small: zz > S::from_f64(0.99),
            twist: twist.multiples(sign, degree),
            axis: axis.multiples(S::ONE, degree),
            swing: swing.multiples(-sign, degree),
        }
    }

    /// This rotation or its inverse, chosen the same way for both, and whether it is the inverse.
    pub(super) fn upright(&self) -> (Self, bool) {
        let [[_, xy, xz], [yx, _, yz], [zx, zy, _]] = self.matrix;
        let apart = [xy - yx, xz - zx, yz - zy].into_iter().find(|&apart| apart != S::ZERO);
        match apart {
            Some(apart) if apart < S::ZERO => (self.inverse(), true),
            _ => (*self, false),
        }
    }
}

/// An angle as its cosine and sine, rounded, and what they lack of it.
#[derive(Clone, Copy)]
struct Angle<S> {
    rounded: [S; 2],
    rest: S,
}

impl<S: Scalar> Angle<S> {
    /// The angle of (x, y), to more than the precision of the format: multiples amplify its error.
    /// x and y are sums of two numbers, the second of which are roundings. Times `scale` the length
    /// is nearly 1.
    #[inline(never)]
    fn new([x, y]: [S; 2], [dx, dy]: [S; 2], scale: S) -> Self {
        let rounded @ [c, s] = [x * scale, y * scale];
        let turned = (y * c - x * s) + (residual(y, c) - residual(x, s)) + (dy * c - dx * s);
        Self { rounded, rest: turned * scale }
    }

    /// The multiples of this angle or of its negative, up to the degree.
    #[inline(never)]
    fn multiples(self, sign: S, degree: usize) -> Multiples<S> {
        let Self { rounded: first, rest } = self;
        let ([mut c, mut s], mut small) = (first, rest);
        let mut multiples = [[S::ZERO; 2]; LARGEST];
        for multiple in multiples.iter_mut().take(degree) {
            let [re, im] = unit([c - S::ONE - small * s, s + small * c]);
            *multiple = [re, sign * im];
            [c, s] = [c * first[0] - s * first[1], s * first[0] + c * first[1]];
            small += rest;
        }
        multiples
    }
}

/// Makes 1 + x + iy a number of absolute value 1, by a step of Newton's method.
fn unit<S: Scalar>([x, y]: [S; 2]) -> [S; 2] {
    let excess = x * (x + S::from_whole(2)) + y * y;
    let half = S::from_f64(0.5) * excess;
    [x - (S::ONE + x) * half, y - y * half]
}

/// a + b, rounded, and the rounding.
fn sum<S: Scalar>(a: S, b: S) -> [S; 2] {
    let sum = a + b;
    let of_b = sum - a;
    [sum, (a - (sum - of_b)) + (b - of_b)]
}

/// The rounding error of the product a b, by Dekker's method: halves of 12 or 26 bits.
fn residual<S: Scalar>(a: S, b: S) -> S {
    let is_single = S::from_f64(1.0 + f64::EPSILON) == S::ONE;
    let splitter = S::from_whole(if is_single { (1 << 12) + 1 } else { (1 << 27) + 1 });
    let split = |number: S| {
        let shifted = splitter * number;
        let high = shifted - (shifted - number);
        [high, number - high]
    };
    let ([a1, a0], [b1, b0]) = (split(a), split(b));
    ((a1 * b1 - a * b) + a1 * b0 + a0 * b1) + a0 * b0
}

#[cfg(test)]
mod tests {
    use super::residual;

    #[test]
    fn residuals_are_what_a_product_lacks() {
        for k in 1..200 {
            let [a, b] = [f64::from(k).recip() - 0.3, 0.7 + 1.0 / f64::from(3 * k)];
            assert_eq!(residual(a, b), libm::fma(a, b, -a * b));
            let [a, b] = [a as f32, b as f32];
            assert_eq!(residual(a, b), libm::fmaf(a, b, -a * b));
        }
    }
}
