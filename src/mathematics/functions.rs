//! What set-up needs of mathematics.

/// Roots and angles in the number format `S`.
///
/// Functions, not methods: an implementation is a type without values, chosen where a
/// function is called, as in `Normal::with_mathematics::<SinglePrecision>(x, y, z)`.
pub trait Mathematics<S> {
    /// √x, x >= 0.
    fn square_root(x: S) -> S;
    /// 1/√x, x > 0.
    fn inverse_root(x: S) -> S;
    /// (sin a, cos a) of an angle in radians.
    fn sine_and_cosine(angle: S) -> (S, S);
}
