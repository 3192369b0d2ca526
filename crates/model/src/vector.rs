//! Vectors of three components.

/// a · b.
#[must_use]
pub fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

/// a × b.
#[must_use]
pub fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// The vector times a factor.
#[must_use]
pub fn times(factor: f64, vector: [f64; 3]) -> [f64; 3] {
    vector.map(|component| factor * component)
}

/// a + b.
#[must_use]
pub fn plus([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a + x, b + y, c + z]
}

/// The vector at unit length, of one that is not zero.
#[must_use]
pub fn unit(vector: [f64; 3]) -> [f64; 3] {
    times(dot(vector, vector).sqrt().recip(), vector)
}
