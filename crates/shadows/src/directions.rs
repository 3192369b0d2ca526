//! Directions on a square map of the sphere, octahedral: nested cells with a center and a solid angle.

/// Rays along each side of the map.
pub const RAYS: usize = 64;

/// Directions along each side of the map, in cells of whole rays.
pub const FINE: usize = 128;

/// The directions of a map of `side` x `side` cells, each with its solid angle.
#[must_use]
pub fn cells(side: usize) -> Vec<([f64; 3], f64)> {
    let step = 2.0 / side as f64;
    let corner = |i: usize, j: usize| direction([i, j].map(|k| k as f64 * step - 1.0));
    let mut cells = Vec::with_capacity(side * side);
    for j in 0..side {
        for i in 0..side {
            let [a, b, c, d] =
                [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            let center = direction([i, j].map(|k| (k as f64 + 0.5) * step - 1.0));
            cells.push((center, solid_angle([a, b, c]) + solid_angle([a, c, d])));
        }
    }
    // Cells that the edges of the octahedron cut are not two triangles exactly.
    let all: f64 = cells.iter().map(|(_, angle)| angle).sum();
    let scale = 4.0 * std::f64::consts::PI / all;
    cells.iter_mut().for_each(|(_, angle)| *angle *= scale);
    cells
}

/// The number of the cell of a map of `side` x `side` cells that has a unit direction.
#[must_use]
pub fn cell_of(side: usize, [x, y, z]: [f64; 3]) -> usize {
    let sum = x.abs() + y.abs() + z.abs();
    let [u, v] = [x / sum, y / sum];
    let [u, v] = if z < 0.0 { folded([u, v]) } else { [u, v] };
    let [column, row] = [u, v].map(|along| {
        let place = 0.5 * (along + 1.0) * side as f64;
        (place as usize).min(side - 1)
    });
    row * side + column
}

/// The number of the cell of rays that has a fine cell.
#[must_use]
pub fn ray_of(cell: usize) -> usize {
    let (row, column) = (cell / FINE, cell % FINE);
    let each = FINE / RAYS;
    row / each * RAYS + column / each
}

/// The direction at a point of the map, each coordinate from -1 to 1.
fn direction([u, v]: [f64; 2]) -> [f64; 3] {
    let z = 1.0 - u.abs() - v.abs();
    let [x, y] = if z < 0.0 { folded([u, v]) } else { [u, v] };
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|along| along / length)
}

/// Exchanges the two sides of the edges of the upper half.
fn folded([u, v]: [f64; 2]) -> [f64; 2] {
    [(1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v)]
}

/// Of a spherical triangle: A. Van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983.
fn solid_angle([a, b, c]: [[f64; 3]; 3]) -> f64 {
    use eigenshade_model::vector::{cross, dot};
    let volume = dot(a, cross(b, c)).abs();
    2.0 * volume.atan2(1.0 + dot(a, b) + dot(b, c) + dot(c, a))
}
