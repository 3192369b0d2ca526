//! Roots by Newton's method, from a first value of the reciprocal; no division.

/// 1/√x after so many steps; each squares the relative error and takes 3/2 of it.
#[inline]
pub fn inverse_root<const STEPS: usize>(x: f32, first: f32) -> f32 {
    let mut inverse = first;
    for _ in 0..STEPS {
        inverse += 0.5 * inverse * (1.0 - x * inverse * inverse);
    }
    inverse
}

/// √x of 1/√x, with a step of its own.
#[inline]
pub fn square_root(x: f32, inverse: f32) -> f32 {
    let root = x * inverse;
    root + 0.5 * inverse * (x - root * root)
}
