//! The mathematical functions that setup needs.

/// Roots and angles in the number format `S`.
///
/// The trait has functions, not methods. An implementation is a type without values, chosen at the
/// call, as in `Normal::with_mathematics::<SinglePrecision>(x, y, z)`.
pub trait Mathematics<S> {
    /// √x, for x >= 0.
    fn square_root(x: S) -> S;
    /// 1/√x, for x > 0.
    fn inverse_root(x: S) -> S;
    /// (sin a, cos a) of an angle a in radians.
    fn sine_and_cosine(angle: S) -> (S, S);
}
