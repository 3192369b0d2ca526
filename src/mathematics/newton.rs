//! Roots by Newton's method, from an initial value of the reciprocal, without division.

/// 1/√x after `STEPS` steps from `first`. Each step turns a relative error e into 3/2 e².
#[inline]
pub fn inverse_root<const STEPS: usize>(x: f32, first: f32) -> f32 {
    let mut inverse = first;
    for _ in 0..STEPS {
        inverse += 0.5 * inverse * (1.0 - x * inverse * inverse);
    }
    inverse
}

/// √x from 1/√x, with one more step.
#[inline]
pub fn square_root(x: f32, inverse: f32) -> f32 {
    let root = x * inverse;
    root + 0.5 * inverse * (x - root * root)
}
