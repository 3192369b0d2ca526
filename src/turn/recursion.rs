//! Turns light of any degree, by real Wigner matrices, degree by degree.
//!
//! The matrix of degree l is computed from those of degrees 1 and l - 1 (J. Ivanic and K.
//! Ruedenberg, "Rotation matrices for real spherical harmonics. Direct determination by recursion",
//! J. Phys. Chem. 100, 1996, with the corrections of 1998). The notation is theirs. The recursion
//! uses the elements of the rotation's own matrix and roots of integers; it needs no angle and has
//! no singularity at the poles.
//!
//! A computed matrix D is orthogonal except for the rounding errors of all degrees. Instead of D,
//! the nearest orthogonal matrix is applied, which is D (3 - DᵀD) / 2 up to the square of these
//! errors. A rotation and its inverse use the same D, one of them transposed. Light that is rotated
//! and rotated back therefore loses no more than the last bits of some sums.

use crate::float;
use crate::index::light as index;
use crate::invariant::{part, part_mut, split_mut};
use crate::light::Light;
use crate::mathematics;
use crate::rotation::Rotation;

/// Workspace length for a degree: the matrices of two degrees, and some numbers for each order.
/// `usize::MAX` if that overflows.
pub(super) const fn workspace_len(degree: usize) -> usize {
    let orders = degree.saturating_mul(2).saturating_add(1);
    // 2 orders² + 2 orders, plus degree + 1.
    let of_orders = orders.saturating_mul(orders.saturating_add(1)).saturating_mul(2);
    of_orders.saturating_add(degree).saturating_add(1)
}

/// Turns a light. `workspace` has [`workspace_len`] numbers, `turned` as many as the light.
pub(super) fn turn(
    light: &Light<'_>,
    rotation: &Rotation,
    workspace: &mut [f32],
    turned: &mut [f32],
) {
    let degree = light.degree();
    let (columns, rest) = split_mut(workspace, degree + 1);
    let (images, matrices) = split_mut(rest, 2 * (2 * degree + 1));
    let half = matrices.len() / 2;
    let (mut before, mut now) = split_mut(matrices, half);
    if let (Some(to), Some(&from)) = (turned.first_mut(), light.coefficients().first()) {
        *to = from;
    }
    let (rotation, transposed) = rotation.upright();
    for l in 1..=degree {
        if l == 1 {
            first(&rotation, now);
        } else {
            next(&rotation, l, before, now, columns);
        }
        let range = index::count(l - 1)..index::count(l);
        let from = part(light.coefficients(), range.clone());
        let to = part_mut(turned, range);
        for ((to, &from), m) in to.iter_mut().zip(from).zip(-l.cast_signed()..) {
            *to = signed(m, from);
        }
        apply(Matrix { elements: now, transposed }, to, images);
        for (to, m) in to.iter_mut().zip(-l.cast_signed()..) {
            *to = signed(m, *to);
        }
        core::mem::swap(&mut before, &mut now);
    }
}

/// Replaces x by D (x + (x - DᵀD x) / 2). `images` has room for two vectors like x.
fn apply(matrix: Matrix<'_>, x: &mut [f32], images: &mut [f32]) {
    let (image, rest) = split_mut(images, x.len());
    let back = part_mut(rest, ..x.len());
    matrix.times(x, image);
    matrix.flipped().times(image, back);
    for (x, &back) in x.iter_mut().zip(back.iter()) {
        *x += 0.5 * (*x - back);
    }
    matrix.times(x, image);
    x.iter_mut().zip(image.iter()).for_each(|(x, &image)| *x = image);
}

/// A square matrix, row by row, or its transpose.
#[derive(Clone, Copy)]
struct Matrix<'a> {
    elements: &'a [f32],
    transposed: bool,
}

impl Matrix<'_> {
    fn flipped(self) -> Self {
        Self { transposed: !self.transposed, ..self }
    }

    fn times(self, from: &[f32], to: &mut [f32]) {
        to.fill(0.0);
        let rows = self.elements.chunks_exact(from.len().max(1));
        if self.transposed {
            for (row, &from) in rows.zip(from) {
                to.iter_mut().zip(row).for_each(|(to, &a)| *to = float::add_product(*to, a, from));
            }
        } else {
            for (to, row) in to.iter_mut().zip(rows) {
                *to = row.iter().zip(from).fold(0.0, |sum, (&a, &x)| float::add_product(sum, a, x));
            }
        }
    }
}

/// Converts to harmonics without the phase, which the recursion uses, and back.
fn signed(order: isize, value: f32) -> f32 {
    if index::graphics_sign(order) < 0 { -value } else { value }
}

/// The matrix of degree 1, whose orders -1, 0, 1 are y, z, x.
fn first(rotation: &Rotation, to: &mut [f32]) {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = rotation.matrix;
    for (to, from) in to.iter_mut().zip([yy, yz, yx, zy, zz, zx, xy, xz, xx]) {
        *to = from;
    }
}

/// The matrix of degree l >= 2, from that of l - 1.
fn next(rotation: &Rotation, l: usize, before: &[f32], to: &mut [f32], columns: &mut [f32]) {
    let root = |square: usize| mathematics::square_root(square as f32);
    for (n, column) in columns.iter_mut().enumerate().take(l + 1) {
        let square = if n < l { (l + n) * (l - n) } else { 2 * l * (2 * l - 1) };
        *column = mathematics::inverse_root(square as f32);
    }
    let previous = Previous { rotation, l: l.cast_signed(), elements: before };
    let (half, two) = (0.5, 2.0);
    let top = l.cast_signed();
    for (row, m) in to.chunks_exact_mut(2 * l + 1).zip(-top..=top) {
        let size = m.unsigned_abs();
        let u = root((l + size) * (l - size));
        let v = half * root((l + size - 1) * (l + size));
        let w = -half * root((l - size).saturating_sub(1) * (l - size));
        for (element, n) in row.iter_mut().zip(-top..=top) {
            let p = |i: isize, order: isize| previous.p(i, order, n);
            let of_u = p(0, m);
            let (of_v, of_w) = match m {
                0 => (-mathematics::square_root(two) * (p(1, 1) + p(-1, -1)), 0.0),
                1 => (mathematics::square_root(two) * p(1, 0), p(1, 2) + p(-1, -2)),
                -1 => (mathematics::square_root(two) * p(-1, 0), p(1, -2) - p(-1, 2)),
                2.. => (p(1, m - 1) - p(-1, 1 - m), p(1, m + 1) + p(-1, -m - 1)),
                _ => (p(1, m + 1) + p(-1, -m - 1), p(1, m - 1) - p(-1, 1 - m)),
            };
            let column = columns.get(n.unsigned_abs()).copied().unwrap_or(0.0);
            *element = column * (u * of_u + v * of_v + w * of_w);
        }
    }
}

struct Previous<'a> {
    rotation: &'a Rotation,
    l: isize,
    /// The matrix of degree l - 1.
    elements: &'a [f32],
}

impl Previous<'_> {
    /// _i P^l of (order, n): products of an element of degree 1 and one of degree l - 1. Not
    /// inlined: the caller uses it fourteen times, which would add 2 KB of code.
    #[inline(never)]
    fn p(&self, i: isize, order: isize, n: isize) -> f32 {
        let [x, y, z] = self.rotation.matrix;
        let [of_x, of_y, of_z] = match i {
            -1 => y,
            0 => z,
            _ => x,
        };
        let last = self.l - 1;
        if n == self.l {
            of_x * self.element(order, last) - of_y * self.element(order, -last)
        } else if n == -self.l {
            of_x * self.element(order, -last) + of_y * self.element(order, last)
        } else {
            of_z * self.element(order, n)
        }
    }

    /// An element of degree l - 1; 0 for orders beyond it, whose factors are zero.
    fn element(&self, m: isize, n: isize) -> f32 {
        let last = self.l - 1;
        if m.abs() > last {
            return 0.0;
        }
        let place = (m + last) * (2 * last + 1) + n + last;
        self.elements.get(place.cast_unsigned()).copied().unwrap_or(0.0)
    }
}
