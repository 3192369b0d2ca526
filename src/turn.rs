//! Rotates light: real Wigner matrices, degree by degree.
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

use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::index::light;
use crate::invariant::{part, part_mut, split_mut};
use crate::light::{Light, LightBuffer};
use crate::mathematics::{Libm, Mathematics};
use crate::rotation::Rotation;
use crate::scalar::Scalar;

impl<S: Scalar> Light<'_, S> {
    /// Workspace length for rotating a light of this degree: the matrices of two degrees, and some
    /// numbers for each order. `usize::MAX` if that overflows.
    #[must_use]
    pub const fn turn_len(degree: usize) -> usize {
        let orders = degree.saturating_mul(2).saturating_add(1);
        // 2 orders² + 2 orders, plus degree + 1.
        let of_orders = orders.saturating_mul(orders.saturating_add(1)).saturating_mul(2);
        of_orders.saturating_add(degree).saturating_add(1)
    }

    /// The coefficients of this light after rotation: L'(Rω) = L(ω).
    ///
    /// `N` must be at least (degree + 1)², `W` at least [`turn_len`](Self::turn_len).
    ///
    /// The energy of each degree is preserved. A light of degree 9 in f32 that is rotated and
    /// rotated back matches the original within 1e-6 of its largest coefficient. Cost: for each
    /// degree l, (2l + 1)² elements of some twenty operations each, and three roots for each order.
    /// This is set-up work, not work for each pixel.
    ///
    /// ```
    /// use eigenshade::mathematics::SinglePrecision;
    /// use eigenshade::{Light, Rotation};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?; // brightest at the camera
    /// let quarter = core::f32::consts::FRAC_PI_2;
    /// let rotation = Rotation::from_euler::<SinglePrecision>(0.0, quarter, 0.0)?;
    /// const WORKSPACE: usize = Light::<f32>::turn_len(1);
    /// let turned = light.turned::<4, WORKSPACE>(&rotation)?; // now from the right
    /// assert!(turned[2].abs() < 1e-6 && (turned[3].abs() - 1.0).abs() < 1e-6);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` or `W` is too small.
    pub fn turned<const N: usize, const W: usize>(
        &self,
        rotation: &Rotation<S>,
    ) -> Result<LightBuffer<S, N>, Error> {
        let mut turned = zeros::<S, N>(Argument::Light, light::count(self.degree()))?;
        let mut workspace = zeros::<S, W>(Argument::Workspace, Self::turn_len(self.degree()))?;
        self.turn_into::<Libm>(rotation, &mut workspace, &mut turned)?;
        Ok(turned)
    }

    /// [`turned`](Self::turned) with slices, and with a choice of implementation for the roots.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `workspace` has [`turn_len`](Self::turn_len) numbers and `turned`
    /// has (degree + 1)².
    pub fn turn_into<M: Mathematics<S>>(
        &self,
        rotation: &Rotation<S>,
        workspace: &mut [S],
        turned: &mut [S],
    ) -> Result<(), Error> {
        let degree = self.degree();
        Error::check(Argument::Light, light::count(degree), turned.len())?;
        Error::check(Argument::Workspace, Self::turn_len(degree), workspace.len())?;
        let (columns, rest) = split_mut(workspace, degree + 1);
        let (images, matrices) = split_mut(rest, 2 * (2 * degree + 1));
        let half = matrices.len() / 2;
        let (mut before, mut now) = split_mut(matrices, half);
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
            let from = part(self.coefficients(), range.clone());
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
        Ok(())
    }
}

impl<S: Scalar> Light<'_, S> {
    /// The coefficients of this light after a rotation about the view axis z, from x toward y, by
    /// the angle with this cosine and sine: [`turned`](Self::turned) at a fraction of its cost,
    /// without a workspace.
    ///
    /// ```
    /// use eigenshade::Light;
    ///
    /// let light = Light::new(&[3.5, 0.0, 0.0, 1.0])?; // brightest at the left
    /// let turned = light.turned_about_view::<4>([0.0, 1.0])?; // now from below
    /// assert_eq!(turned.as_slice(), [3.5, 1.0, 0.0, 0.0]);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: four products for each degree and order above 0.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is below (degree + 1)².
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [S; 2],
    ) -> Result<LightBuffer<S, N>, Error> {
        let mut turned = zeros::<S, N>(Argument::Light, light::count(self.degree()))?;
        self.turn_about_view_into(angle, &mut turned)?;
        Ok(turned)
    }

    /// [`turned_about_view`](Self::turned_about_view) with a slice.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `turned` has (degree + 1)² numbers.
    pub fn turn_about_view_into(&self, [c, s]: [S; 2], turned: &mut [S]) -> Result<(), Error> {
        let degree = self.degree();
        Error::check(Argument::Light, light::count(degree), turned.len())?;
        let from = self.coefficients();
        for l in 0..=degree {
            let place = light::position(l, 0);
            if let (Some(to), Some(&mean)) = (turned.get_mut(place), from.get(place)) {
                *to = mean;
            }
        }
        let [mut cosine, mut sine] = [c, s];
        for m in 1..=degree {
            // The harmonics of odd m > 0 have the sign -1.
            let signed = if m % 2 == 0 { sine } else { -sine };
            // The orders -m and m of degree l stand 2m apart, the next pair 2l + 2 further.
            let mut place = light::position(m, -m.cast_signed());
            for l in m..=degree {
                let pair = place..=place + 2 * m;
                if let (Some(&[minus, .., plus]), Some([to_minus, .., to_plus])) =
                    (from.get(pair.clone()), turned.get_mut(pair))
                {
                    *to_minus = minus * cosine - plus * signed;
                    *to_plus = plus * cosine + minus * signed;
                }
                place += 2 * l + 2;
            }
            [cosine, sine] = [cosine * c - sine * s, sine * c + cosine * s];
        }
        Ok(())
    }
}

impl<S: Scalar> Rotation<S> {
    /// Either this rotation or its inverse, chosen the same way for both, and whether it is the
    /// inverse.
    fn upright(&self) -> (Self, bool) {
        let [[_, xy, xz], [yx, _, yz], [zx, zy, _]] = self.matrix;
        let apart = [xy - yx, xz - zx, yz - zy].into_iter().find(|&apart| apart != S::ZERO);
        match apart {
            Some(apart) if apart < S::ZERO => (self.inverse(), true),
            _ => (*self, false),
        }
    }
}

/// Replaces x by D (x + (x - DᵀD x) / 2). `images` has room for two vectors like x.
fn apply<S: Scalar>(matrix: Matrix<'_, S>, x: &mut [S], images: &mut [S]) {
    let (image, rest) = split_mut(images, x.len());
    let back = part_mut(rest, ..x.len());
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

/// Converts between our harmonics and those without the phase, which the recursion uses. The
/// conversion is its own inverse.
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

/// The matrix of degree l >= 2, from that of l - 1.
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

/// The inputs of the recursion.
struct Previous<'a, S> {
    rotation: &'a Rotation<S>,
    l: isize,
    /// The matrix of degree l - 1.
    elements: &'a [S],
}

impl<S: Scalar> Previous<'_, S> {
    /// _i P^l of (order, n): products of an element of degree 1 and one of degree l - 1.
    ///
    /// Not inlined: the caller uses it fourteen times, which would add 2 KB of code.
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

    /// An element of degree l - 1; 0 for orders that this degree does not have, whose factors are
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
