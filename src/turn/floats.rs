//! Floating-point rotations as a twist about the view axis and a swing.

use super::exchange;
use super::swing_twist::{Arithmetic, Multiples, SwingTwist};
use crate::float;
use crate::index::light::MAX_DEGREE;
use crate::mathematics;
use crate::rotation::Rotation;

pub(super) struct Floats;

/// The matrices in `f32`.
#[expect(clippy::indexing_slicing, reason = "a constant has no iterators")]
static EXCHANGE: [f32; exchange::ELEMENTS] = {
    let (mut elements, mut k) = ([0.0; exchange::ELEMENTS], 0);
    while k < exchange::ELEMENTS {
        elements[k] = exchange::EXCHANGE[k] as f32;
        k += 1;
    }
    elements
};

impl Arithmetic for Floats {
    type Coefficient = f32;
    type Scale = ();
    type Number = f32;
    type Factor = f32;
    type Element = f32;
    type Sum = f32;
    const EXCHANGE: &'static [f32] = &EXCHANGE;
    #[inline(always)]
    fn scale(_: &[f32]) {}
    #[inline(always)]
    fn scaled((): ()) -> impl Fn(f32) -> f32 {
        |coefficient| coefficient
    }
    #[inline(always)]
    fn coefficient(number: f32) -> f32 {
        number
    }
    #[inline(always)]
    fn product([c, s]: [f32; 2], [x, y]: [f32; 2]) -> [f32; 2] {
        [float::add_product(c * x, -s, y), float::add_product(c * y, s, x)]
    }
    #[inline(always)]
    fn add_product(sum: f32, element: f32, number: f32) -> f32 {
        float::add_product(sum, element, number)
    }
    #[inline(always)]
    fn number(sum: f32) -> f32 {
        sum
    }
}

impl Rotation {
    /// This rotation, prepared. A rotation and its inverse have the same numbers, so that one
    /// undoes the other up to the rounding of the coefficients.
    pub(super) fn swing_twist(&self, degree: usize) -> SwingTwist<f32> {
        let (Self { matrix }, is_inverse) = self.canonical();
        let [[xx, xy, xz], [yx, yy, yz], [_, _, zz]] = matrix;
        let flips = zz < 0.0;
        let [xx, yx, xz, yz, zz] =
            if flips { [-xx, -yx, -xz, -yz, -zz] } else { [xx, yx, xz, yz, zz] };
        // The upper left block is 1 + cos b times the rotation by γ, plus a symmetric part of trace
        // zero.
        let ([cosine, of_cosine], [sine, of_sine]) = (sum(xx, yy), sum(yx, -xy));
        let twist = Angle::new([cosine, sine], [of_cosine, of_sine], (1.0 + zz).recip());
        // The swing moves the view axis to (xz, yz, zz). Below 1e-18 it changes no coefficient.
        let square = xz * xz + yz * yz;
        let (inverse, column) = match square > 1e-36 {
            true => (mathematics::inverse_root(square), [xz, yz]),
            false => (1.0, [1.0, 0.0]),
        };
        let axis = Angle::new(column, [0.0; 2], inverse);
        let sine = square * inverse;
        // Twice the sine times what it lacks.
        let [x, y] = if xz * xz > yz * yz { [xz, yz] } else { [yz, xz] };
        let error = (x * x - sine * sine + y * y)
            + (residual(x, x) + residual(y, y) - residual(sine, sine));
        let swing = Angle::new([zz, sine], [0.0, 0.5 * error * inverse], 1.0);
        let sign = if is_inverse { -1.0 } else { 1.0 };
        SwingTwist {
            flips,
            is_inverse,
            swings: sine > 0.0,
            is_small: zz > 0.99,
            twist: twist.multiples(sign, degree),
            axis: axis.multiples(1.0, degree),
            swing: swing.multiples(-sign, degree),
        }
    }

    /// This rotation or its inverse, chosen the same way for both, and whether it is the inverse.
    fn canonical(&self) -> (Self, bool) {
        let [[_, xy, xz], [yx, _, yz], [zx, zy, _]] = self.matrix;
        let apart = [xy - yx, xz - zx, yz - zy].into_iter().find(|&apart| apart != 0.0);
        match apart {
            Some(apart) if apart < 0.0 => (self.inverse(), true),
            _ => (*self, false),
        }
    }
}

/// An angle as its cosine and sine, rounded, and what they lack of it.
#[derive(Clone, Copy)]
struct Angle {
    rounded: [f32; 2],
    rest: f32,
}

impl Angle {
    /// The angle of (x, y), to more than the precision of f32: multiples amplify its error.
    /// x and y are sums of two numbers, the second of which are roundings. Times `scale` the length
    /// is nearly 1.
    #[inline(never)]
    fn new([x, y]: [f32; 2], [dx, dy]: [f32; 2], scale: f32) -> Self {
        let rounded @ [c, s] = [x * scale, y * scale];
        let turned = (y * c - x * s) + (residual(y, c) - residual(x, s)) + (dy * c - dx * s);
        Self { rounded, rest: turned * scale }
    }

    /// The multiples of this angle or of its negative, up to the degree.
    #[inline(never)]
    fn multiples(self, sign: f32, degree: usize) -> Multiples<f32> {
        let Self { rounded: first, rest } = self;
        let ([mut c, mut s], mut small) = (first, rest);
        let mut multiples = [[0.0; 2]; MAX_DEGREE];
        for multiple in multiples.iter_mut().take(degree) {
            let [re, im] = unit([c - 1.0 - small * s, s + small * c]);
            *multiple = [re, sign * im];
            [c, s] = [c * first[0] - s * first[1], s * first[0] + c * first[1]];
            small += rest;
        }
        multiples
    }
}

/// Makes 1 + x + iy a number of absolute value 1, by a step of Newton's method.
fn unit([x, y]: [f32; 2]) -> [f32; 2] {
    let excess = x * (x + 2.0) + y * y;
    let half = 0.5 * excess;
    [x - (1.0 + x) * half, y - y * half]
}

/// a + b, rounded, and the rounding.
fn sum(a: f32, b: f32) -> [f32; 2] {
    let sum = a + b;
    let of_b = sum - a;
    [sum, (a - (sum - of_b)) + (b - of_b)]
}

/// The rounding error of the product a b, by Dekker's method: halves of 12 bits.
fn residual(a: f32, b: f32) -> f32 {
    let splitter = ((1 << 12) + 1) as f32;
    let split = |number: f32| {
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
            let [a, b] = [a as f32, b as f32];
            assert_eq!(residual(a, b), libm::fmaf(a, b, -a * b));
        }
    }
}
