//! Rotations in three dimensions, from a quaternion, from Euler angles or from a matrix.

use crate::error::Error;
use crate::mathematics;

/// A rotation R of light: light that came from ω comes from Rω afterward.
///
/// R is stored as a matrix that stays orthonormal to within sixteen rounding errors, however many
/// rotations are composed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rotation {
    pub(crate) matrix: [[f32; 3]; 3],
}

impl Rotation {
    /// The identity.
    pub const NONE: Self = Self { matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };

    /// R = Rz(`beta`) Ry(`alpha`) Rz(`gamma`), in radians: first about z by γ, then about y by α,
    /// then about z by β. So (angle, 0, 0) is about the view, z, and (0, angle, 0) about the
    /// vertical, y.
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] if an angle is beyond 1e9 rad or not a number.
    pub fn from_euler(beta: f32, alpha: f32, gamma: f32) -> Result<Self, Error> {
        Self::euler([beta, alpha, gamma], mathematics::sine_and_cosine)
    }

    /// [`from_euler`](Self::from_euler) by the sines and cosines of the crate `micromath`. The matrix
    /// is orthonormal; for angles up to 10 rad its elements are off by up to 3e-3. The same errors.
    #[cfg(feature = "micromath")]
    pub fn approximate_from_euler(beta: f32, alpha: f32, gamma: f32) -> Result<Self, Error> {
        use micromath::F32Ext;
        let sine_and_cosine = |angle| (F32Ext::sin(angle), F32Ext::cos(angle));
        Self::euler([beta, alpha, gamma], sine_and_cosine).map(Self::orthonormal)
    }

    #[inline]
    fn euler(angles: [f32; 3], sine_and_cosine: impl Fn(f32) -> (f32, f32)) -> Result<Self, Error> {
        let [(sb, cb), (sa, ca), (sg, cg)] = angles.map(sine_and_cosine);
        let rotation = Self {
            matrix: [
                [cb * ca * cg - sb * sg, -cb * ca * sg - sb * cg, cb * sa],
                [sb * ca * cg + cb * sg, -sb * ca * sg + cb * cg, sb * sa],
                [-sa * cg, sa * sg, ca],
            ],
        };
        // Beyond, the next angle is several turns away.
        let is_angle = |angle: f32| angle <= 1e9 && -angle <= 1e9;
        if angles.into_iter().all(is_angle) { Ok(rotation) } else { Err(Error::Rotation) }
    }

    /// The rotation of the quaternion x i + y j + z k + w, of any length whose square is a normal
    /// number of f32. Takes no root and no angle.
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] if the squared length is not a normal number.
    pub fn from_quaternion([x, y, z, w]: [f32; 4]) -> Result<Self, Error> {
        let square = x * x + y * y + z * z + w * w;
        let scale = square.recip();
        let twice = scale + scale;
        // Infinite if the square is below 5.9e-39, 0 if it is infinite.
        if !(twice > 0.0 && twice.is_finite()) {
            return Err(Error::Rotation);
        }
        let (sx, sy, sz) = (twice * x, twice * y, twice * z);
        let (xx, yy, zz) = (sx * x, sy * y, sz * z);
        let (xy, yz, zx) = (sx * y, sy * z, sz * x);
        let (xw, yw, zw) = (sx * w, sy * w, sz * w);
        Ok(Self {
            matrix: [
                [1.0 - (yy + zz), xy - zw, zx + yw],
                [xy + zw, 1.0 - (zz + xx), yz - xw],
                [zx - yw, yz + xw, 1.0 - (xx + yy)],
            ],
        })
    }

    /// The rotation nearest to a matrix, given row by row. A matrix that is orthonormal to within
    /// sixteen rounding errors is kept as it is.
    ///
    /// # Errors
    ///
    /// [`Error::Rotation`] unless the rows are orthonormal and right-handed to within 1e-3.
    pub fn from_matrix(matrix: [[f32; 3]; 3]) -> Result<Self, Error> {
        let [x, y, z] = matrix;
        let [a, b, c] = cross(x, y);
        let pairs = [
            dot(x, x) - 1.0,
            dot(y, y) - 1.0,
            dot(x, y),
            a - dot(z, [1.0, 0.0, 0.0]),
            b - dot(z, [0.0, 1.0, 0.0]),
            c - dot(z, [0.0, 0.0, 1.0]),
        ];
        let most = 1e-3;
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
            off[0][0] += 1.0;
            off[1][1] += 1.0;
            off[2][2] += 1.0;
            let is_rounding = |off: &f32| {
                let sixteenth = *off * (1.0 / 16.0);
                1.0 + sixteenth == 1.0 && 1.0 - sixteenth == 1.0
            };
            if off.as_flattened().iter().all(is_rounding) {
                break;
            }
            let columns = self.inverse().matrix;
            for (row, off) in self.matrix.iter_mut().zip(off) {
                for (element, column) in row.iter_mut().zip(columns) {
                    *element += 0.5 * dot(off, column);
                }
            }
        }
        self
    }

    /// R as a matrix, row by row.
    #[must_use]
    pub const fn matrix(self) -> [[f32; 3]; 3] {
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
    pub fn turn_direction(self, direction: [f32; 3]) -> [f32; 3] {
        self.matrix.map(|row| dot(row, direction))
    }
}

pub(crate) fn dot([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> f32 {
    a * x + b * y + c * z
}

pub(crate) fn cross([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
