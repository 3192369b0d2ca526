//! Rotations in three dimensions, from a quaternion, from Euler angles or from a matrix.

use crate::error::Error;
use crate::mathematics::Mathematics;
use crate::scalar::Scalar;

/// A rotation R of light: light that came from ω comes from Rω afterward.
///
/// R is stored as a matrix that stays orthonormal to within sixteen rounding errors, however many
/// rotations are composed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rotation<S> {
    pub(crate) matrix: [[S; 3]; 3],
}

impl<S: Scalar> Rotation<S> {
    /// The identity.
    pub const NONE: Self = Self {
        matrix: [
            [S::ONE, S::ZERO, S::ZERO],
            [S::ZERO, S::ONE, S::ZERO],
            [S::ZERO, S::ZERO, S::ONE],
        ],
    };

    /// R = Rz(`beta`) Ry(`alpha`) Rz(`gamma`), in radians: first about z by γ, then about y by α,
    /// then about z by β. So (angle, 0, 0) is about the view, z, and (0, angle, 0) about the
    /// vertical, y.
    ///
    /// For f32, [`SinglePrecision`](crate::mathematics::SinglePrecision) computes without f64.
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] if an angle is not finite.
    pub fn from_euler<M: Mathematics<S>>(beta: S, alpha: S, gamma: S) -> Result<Self, Error> {
        let (sb, cb) = M::sine_and_cosine(beta);
        let (sa, ca) = M::sine_and_cosine(alpha);
        let (sg, cg) = M::sine_and_cosine(gamma);
        let rotation = Self {
            matrix: [
                [cb * ca * cg - sb * sg, -cb * ca * sg - sb * cg, cb * sa],
                [sb * ca * cg + cb * sg, -sb * ca * sg + cb * cg, sb * sa],
                [-sa * cg, sa * sg, ca],
            ],
        };
        let finite = [beta, alpha, gamma].into_iter().all(S::is_finite);
        if finite { Ok(rotation) } else { Err(Error::Rotation) }
    }

    /// The rotation of the quaternion x i + y j + z k + w. Its length may be anything whose square
    /// is a normal number of the format. Takes no root and no angle.
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] if the squared length is not a normal number.
    pub fn from_quaternion([x, y, z, w]: [S; 4]) -> Result<Self, Error> {
        let square = x * x + y * y + z * z + w * w;
        let scale = square.reciprocal();
        let twice = scale + scale;
        // Infinite if the square is below the smallest normal number, 0 if it is infinite.
        if !(twice > S::ZERO && twice.is_finite()) {
            return Err(Error::Rotation);
        }
        let (sx, sy, sz) = (twice * x, twice * y, twice * z);
        let (xx, yy, zz) = (sx * x, sy * y, sz * z);
        let (xy, yz, zx) = (sx * y, sy * z, sz * x);
        let (xw, yw, zw) = (sx * w, sy * w, sz * w);
        Ok(Self {
            matrix: [
                [S::ONE - (yy + zz), xy - zw, zx + yw],
                [xy + zw, S::ONE - (zz + xx), yz - xw],
                [zx - yw, yz + xw, S::ONE - (xx + yy)],
            ],
        })
    }

    /// The rotation nearest to a matrix, given row by row. A matrix that is orthonormal to within
    /// sixteen rounding errors is kept as it is.
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] unless the rows are orthonormal and right-handed to within 1e-3.
    pub fn from_matrix(matrix: [[S; 3]; 3]) -> Result<Self, Error> {
        let [x, y, z] = matrix;
        let [a, b, c] = cross(x, y);
        let pairs = [
            dot(x, x) - S::ONE,
            dot(y, y) - S::ONE,
            dot(x, y),
            a - dot(z, [S::ONE, S::ZERO, S::ZERO]),
            b - dot(z, [S::ZERO, S::ONE, S::ZERO]),
            c - dot(z, [S::ZERO, S::ZERO, S::ONE]),
        ];
        let most = S::from_f64(1e-3);
        let fits = pairs.into_iter().all(|apart| apart <= most && -apart <= most);
        if fits { Ok(Self { matrix }.orthonormal()) } else { Err(Error::Rotation) }
    }

    /// The orthonormal matrix nearest to an almost orthonormal one, by Newton's method: R + (1 -
    /// RRᵀ) R / 2. An error of 1e-3, the largest that [`from_matrix`](Self::from_matrix) accepts,
    /// becomes 1e-6 after one step, 1e-12 after two and nothing after three.
    fn orthonormal(mut self) -> Self {
        for _ in 0..3 {
            let rows = self.matrix;
            let mut off = rows.map(|row| rows.map(|other| -dot(row, other)));
            off[0][0] += S::ONE;
            off[1][1] += S::ONE;
            off[2][2] += S::ONE;
            let is_rounding = |off: &S| {
                let sixteenth = *off * S::from_f64(1.0 / 16.0);
                S::ONE + sixteenth == S::ONE && S::ONE - sixteenth == S::ONE
            };
            if off.as_flattened().iter().all(is_rounding) {
                break;
            }
            let columns = self.inverse().matrix;
            for (row, off) in self.matrix.iter_mut().zip(off) {
                for (element, column) in row.iter_mut().zip(columns) {
                    *element += S::from_f64(0.5) * dot(off, column);
                }
            }
        }
        self
    }

    /// R as a matrix, row by row.
    #[must_use]
    pub const fn matrix(self) -> [[S; 3]; 3] {
        self.matrix
    }

    /// The inverse rotation.
    #[must_use]
    pub fn inverse(self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.matrix;
        Self { matrix: [[a, d, g], [b, e, h], [c, f, i]] }
    }

    /// This rotation applied after `first`: their product, with this one on the left.
    #[must_use]
    pub fn after(self, first: Self) -> Self {
        let columns = first.inverse().matrix;
        let matrix = self.matrix.map(|row| columns.map(|column| dot(row, column)));
        Self { matrix }.orthonormal()
    }

    /// Rotates a direction.
    #[must_use]
    pub fn turn_direction(self, direction: [S; 3]) -> [S; 3] {
        self.matrix.map(|row| dot(row, direction))
    }
}

pub(crate) fn dot<S: Scalar>([a, b, c]: [S; 3], [x, y, z]: [S; 3]) -> S {
    a * x + b * y + c * z
}

pub(crate) fn cross<S: Scalar>([a, b, c]: [S; 3], [x, y, z]: [S; 3]) -> [S; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
