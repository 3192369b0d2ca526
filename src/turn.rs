//! Light turned by a rotation: real Wigner matrices, degree by degree.
//!
//! The matrix of degree l comes from those of degrees 1 and l - 1 (J. Ivanic and K. Ruedenberg, "Rotation matrices
//! for real spherical harmonics. Direct determination by recursion", J. Phys. Chem. 100,
//! 1996, with the corrections of 1998). Notation follows them. It takes the elements of
//! the rotation's own matrix and roots of whole numbers: no angle, nothing singular at
//! the poles.
//!
//! Of a matrix D that is orthogonal but for the roundings of all degrees, the orthogonal
//! one next to it is applied, D (3 - DᵀD) / 2 but for their square. A rotation and its inverse take the same D,
//! one of them transposed. So light turned there and back again has lost no more than
//! the last bits of some sums.

use crate::buffer::zeros;
use crate::error::{Error, What};
use crate::index::light;
use crate::light::Light;
use crate::mathematics::{Libm, Mathematics};
use crate::rotation::Rotation;
use crate::scalar::Scalar;

/// The coefficients of a light that was changed, in a buffer of fixed capacity.
pub type LightBuffer<S, const N: usize> = heapless::Vec<S, N>;

impl<S: Scalar> Light<'_, S> {
    /// Numbers that turning a light of this degree needs room for: the matrices of
    /// two degrees, and some numbers for each order; `usize::MAX` where that overflows.
    #[must_use]
    pub const fn turn_len(degree: usize) -> usize {
        let orders = degree.saturating_mul(2).saturating_add(1);
        // 2 orders² + 2 orders, and degree + 1.
        let of_orders = orders.saturating_mul(orders.saturating_add(1)).saturating_mul(2);
        of_orders.saturating_add(degree).saturating_add(1)
    }

    /// The coefficients of this light, turned: L'(Rω) = L(ω).
    ///
    /// `N` is at least (degree + 1)², `W` at least [`turn_len`](Self::turn_len).
    ///
    /// Energy is kept degree by degree. Turned and turned back, a light of degree 9 in f32
    /// is itself within 1e-6 of its largest coefficient. Cost: for each degree l (2l + 1)² elements of some twenty
    /// operations and three roots for each order: set-up, not a pixel's work.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` or `W` is too small.
    pub fn turned<const N: usize, const W: usize>(
        &self,
        rotation: &Rotation<S>,
    ) -> Result<LightBuffer<S, N>, Error> {
        let mut turned = zeros::<S, N>(What::Light, light::count(self.degree()))?;
        let mut workspace = zeros::<S, W>(What::Workspace, Self::turn_len(self.degree()))?;
        self.turn_into::<Libm>(rotation, &mut workspace, &mut turned)?;
        Ok(turned)
    }

    /// [`turned`](Self::turned) with slices, and with roots of one's choice.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if a slice is not as long as [`turn_len`](Self::turn_len) and
    /// (degree + 1)² say.
    pub fn turn_into<M: Mathematics<S>>(
        &self,
        rotation: &Rotation<S>,
        workspace: &mut [S],
        turned: &mut [S],
    ) -> Result<(), Error> {
        let degree = self.degree();
        Error::check(What::Light, light::count(degree), turned.len())?;
        Error::check(What::Workspace, Self::turn_len(degree), workspace.len())?;
        let (columns, rest) = workspace.split_at_mut_checked(degree + 1).unwrap_or_default();
        let (images, matrices) =
            rest.split_at_mut_checked(2 * (2 * degree + 1)).unwrap_or_default();
        let half = matrices.len() / 2;
        let (mut before, mut now) = matrices.split_at_mut_checked(half).unwrap_or_default();
        if let (Some(to), Some(&from)) = (turned.first_mut(), self.coefficients().first()) {
            *to = from;
        }
        let (rotation, transposed) = rotation.upright();
        for l in 1..=degree {
            if l == 1 {
                first(&rotation, now);
            } else {
                next::<S, M>(&rotation, l, before, now, columns);
            }
            let range = light::count(l - 1)..light::count(l);
            let from = self.coefficients().get(range.clone()).unwrap_or_default();
            let to = turned.get_mut(range).unwrap_or_default();
            for ((to, &from), m) in to.iter_mut().zip(from).zip(-l.cast_signed()..) {
                *to = signed(m, from);
            }
            apply(Matrix { elements: now, transposed }, to, images);
            for (to, m) in to.iter_mut().zip(-l.cast_signed()..) {
                *to = signed(m, *to);
            }
            core::mem::swap(&mut before, &mut now);
        }
        Ok(())
    }
}

impl<S: Scalar> Rotation<S> {
    /// One of this rotation and its inverse, the same one for both, and whether it is
    /// the inverse.
    fn upright(&self) -> (Self, bool) {
        let [[_, xy, xz], [yx, _, yz], [zx, zy, _]] = self.matrix;
        let apart = [xy - yx, xz - zx, yz - zy].into_iter().find(|&apart| apart != S::ZERO);
        match apart {
            Some(apart) if apart < S::ZERO => (self.inverse(), true),
            _ => (*self, false),
        }
    }
}

/// x becomes D (x + (x - DᵀD x) / 2). `images` has room for two more x.
fn apply<S: Scalar>(matrix: Matrix<'_, S>, x: &mut [S], images: &mut [S]) {
    let (image, rest) = images.split_at_mut_checked(x.len()).unwrap_or_default();
    let back = rest.get_mut(..x.len()).unwrap_or_default();
    matrix.times(x, image);
    matrix.flipped().times(image, back);
    for (x, &back) in x.iter_mut().zip(back.iter()) {
        *x += S::from_f64(0.5) * (*x - back);
    }
    matrix.times(x, image);
    x.iter_mut().zip(image.iter()).for_each(|(x, &image)| *x = image);
}

/// A square matrix, row by row, or its transpose.
#[derive(Clone, Copy)]
struct Matrix<'a, S> {
    elements: &'a [S],
    transposed: bool,
}

impl<S: Scalar> Matrix<'_, S> {
    fn flipped(self) -> Self {
        Self { transposed: !self.transposed, ..self }
    }

    fn times(self, from: &[S], to: &mut [S]) {
        to.fill(S::ZERO);
        let rows = self.elements.chunks_exact(from.len().max(1));
        if self.transposed {
            for (row, &from) in rows.zip(from) {
                to.iter_mut().zip(row).for_each(|(to, &a)| *to = to.add_product(a, from));
            }
        } else {
            for (to, row) in to.iter_mut().zip(rows) {
                *to = row.iter().zip(from).fold(S::ZERO, |sum, (&a, &x)| sum.add_product(a, x));
            }
        }
    }
}

/// From our harmonics to those without phase, in which the recurrence stands, or back.
fn signed<S: Scalar>(order: isize, value: S) -> S {
    if light::graphics_sign(order) < 0 { -value } else { value }
}

/// The matrix of degree 1, whose orders -1, 0, 1 are y, z, x.
fn first<S: Scalar>(rotation: &Rotation<S>, to: &mut [S]) {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = rotation.matrix;
    for (to, from) in to.iter_mut().zip([yy, yz, yx, zy, zz, zx, xy, xz, xx]) {
        *to = from;
    }
}

/// The matrix of degree l >= 2 from that of l - 1.
fn next<S: Scalar, M: Mathematics<S>>(
    rotation: &Rotation<S>,
    l: usize,
    before: &[S],
    to: &mut [S],
    columns: &mut [S],
) {
    let root = |square: usize| M::square_root(S::from_whole(square));
    for (n, column) in columns.iter_mut().enumerate().take(l + 1) {
        let square = if n < l { (l + n) * (l - n) } else { 2 * l * (2 * l - 1) };
        *column = M::inverse_root(S::from_whole(square));
    }
    let previous = Previous { rotation, l: l.cast_signed(), elements: before };
    let (half, two) = (S::from_f64(0.5), S::from_whole(2));
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
                0 => (-M::square_root(two) * (p(1, 1) + p(-1, -1)), S::ZERO),
                1 => (M::square_root(two) * p(1, 0), p(1, 2) + p(-1, -2)),
                -1 => (M::square_root(two) * p(-1, 0), p(1, -2) - p(-1, 2)),
                2.. => (p(1, m - 1) - p(-1, 1 - m), p(1, m + 1) + p(-1, -m - 1)),
                _ => (p(1, m + 1) + p(-1, -m - 1), p(1, m - 1) - p(-1, 1 - m)),
            };
            let column = columns.get(n.unsigned_abs()).copied().unwrap_or(S::ZERO);
            *element = column * (u * of_u + v * of_v + w * of_w);
        }
    }
}

/// What the recurrence reads.
struct Previous<'a, S> {
    rotation: &'a Rotation<S>,
    l: isize,
    /// Of degree l - 1.
    elements: &'a [S],
}

impl<S: Scalar> Previous<'_, S> {
    /// _i P^l of (order, n): products of an element of degree 1 and one of degree l - 1.
    ///
    /// Apart from its caller, which names it fourteen times: 2 KB of code where inlined.
    #[inline(never)]
    fn p(&self, i: isize, order: isize, n: isize) -> S {
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

    /// An element of degree l - 1; 0 for orders that it does not have, whose factors are
    /// zero.
    fn element(&self, m: isize, n: isize) -> S {
        let last = self.l - 1;
        if m.abs() > last {
            return S::ZERO;
        }
        let place = (m + last) * (2 * last + 1) + n + last;
        self.elements.get(place.cast_unsigned()).copied().unwrap_or(S::ZERO)
    }
}
