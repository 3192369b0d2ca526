//! Vectors of three numbers.

pub type Vector = [f64; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn sum(a: Vector, weight: f64, b: Vector) -> Vector {
    [a[0] + weight * b[0], a[1] + weight * b[1], a[2] + weight * b[2]]
}

pub fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|component| component * factor)
}

pub fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / dot(a, a).sqrt())
}

pub const VIEW: Vector = [0.0, 0.0, 1.0];

/// The direction at an angle from the view, in an azimuth.
pub fn at(angle: f64, azimuth: f64) -> Vector {
    [angle.sin() * azimuth.cos(), angle.sin() * azimuth.sin(), angle.cos()]
}
