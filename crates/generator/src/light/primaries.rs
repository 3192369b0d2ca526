//! Conversion of colors of other primaries to linear sRGB.

use eigenshade_model::vector::{cross, dot};

/// Chromaticities x and y of three primaries and of the color of three equal values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Primaries {
    pub(crate) rgb: [[f64; 2]; 3],
    pub(crate) white: [f64; 2],
}

/// Chromaticities of D65.
const D65: [f64; 2] = [0.3127, 0.329];

/// Those of linear sRGB.
const SRGB: Primaries = Primaries { rgb: [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06]], white: D65 };

/// Values that are CIE XYZ.
pub(crate) const XYZ: Primaries =
    Primaries { rgb: [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]], white: [1.0 / 3.0; 2] };

/// Chromaticities that differ by less are the same: files have three or four digits.
const SAME: f64 = 1e-3;

/// Bradford's matrix, from XYZ to the responses in which white points are adapted.
const BRADFORD: Matrix =
    [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];

type Matrix = [[f64; 3]; 3];

impl Primaries {
    /// Those of a list: x and y of red, green, blue and white.
    pub(crate) fn of_list(list: [f64; 8]) -> Self {
        let [a, b, c, d, e, f, x, y] = list;
        Self { rgb: [[a, b], [c, d], [e, f]], white: [x, y] }
    }

    /// Those of a code of ITU-T H.273 (`cICP`).
    pub(crate) fn of_code(code: u8) -> Option<Self> {
        Some(match code {
            1 => SRGB,
            9 => Self { rgb: [[0.708, 0.292], [0.17, 0.797], [0.131, 0.046]], white: D65 },
            12 => Self { rgb: [[0.68, 0.32], [0.265, 0.69], [0.15, 0.06]], white: D65 },
            _ => return None,
        })
    }

    fn is_near(&self, other: &Self) -> bool {
        let all = |one: &Self| [one.rgb.as_flattened(), &one.white].concat();
        all(self).iter().zip(all(other)).all(|(a, b)| (a - b).abs() < SAME)
    }

    /// Whether they are those of linear sRGB.
    pub(crate) fn is_srgb(&self) -> bool {
        self.is_near(&SRGB)
    }

    /// The matrix to linear sRGB; `None` if these are no primaries.
    ///
    /// White becomes white (Bradford's adaptation), as in programs that edit pictures: three equal
    /// values stay equal. CIE XYZ alone are converted as they are, because their white is none that
    /// anything was adapted to.
    pub(crate) fn to_srgb(self) -> Option<Matrix> {
        let from_srgb = SRGB.to_xyz()?;
        let to_xyz = self.to_xyz()?;
        let adapted = if self.is_near(&XYZ) {
            to_xyz
        } else {
            let of = |white| product(&BRADFORD, xyz(white));
            let (from, to) = (of(self.white), of(D65));
            let scaled = [0, 1, 2].map(|k| BRADFORD[k].map(|value| value * to[k] / from[k]));
            composed(&composed(&inverse(&BRADFORD)?, &scaled), &to_xyz)
        };
        let matrix = composed(&inverse(&from_srgb)?, &adapted);
        matrix.as_flattened().iter().all(|value| value.is_finite()).then_some(matrix)
    }

    /// The matrix to CIE XYZ, with Y = 1 for white.
    fn to_xyz(self) -> Option<Matrix> {
        let columns = self.rgb.map(|[x, y]| [x, y, 1.0 - x - y]);
        let matrix = transposed(&columns);
        let scale = product(&inverse(&matrix)?, xyz(self.white));
        Some(matrix.map(|row| [0, 1, 2].map(|k| row[k] * scale[k])))
    }
}

/// The color of this chromaticity with Y = 1.
fn xyz([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

/// A matrix times a color.
pub(crate) fn product(matrix: &Matrix, color: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| dot(row, color))
}

fn composed(after: &Matrix, before: &Matrix) -> Matrix {
    transposed(&transposed(before).map(|column| product(after, column)))
}

fn transposed(matrix: &Matrix) -> Matrix {
    [0, 1, 2].map(|k| matrix.map(|row| row[k]))
}

fn inverse(matrix: &Matrix) -> Option<Matrix> {
    let [a, b, c] = *matrix;
    let determinant = dot(a, cross(b, c));
    let columns = [cross(b, c), cross(c, a), cross(a, b)];
    (determinant.abs() > 1e-9)
        .then(|| transposed(&columns.map(|column| column.map(|value| value / determinant))))
}
