//! Matcaps: squares that show a sphere, in which engines look up the color of a normal.

use crate::error::{Argument, Error};
use crate::mathematics;
use crate::normal::Normal;

/// Iterates over the texels of a matcap of `size` x `size`, row by row from the top.
///
/// The texel in column i and row j has the normal whose x is 2 (i + 1/2) / N - 1 and whose y is
/// 1 - 2 (j + 1/2) / N: an engine looks up (n_x, n_y) / 2 + 1/2, with y up. Outside the disc a
/// texel has the nearest normal of the rim, so that a bilinear look-up is right there too.
///
/// The image falls steeply just inside the rim, where z does, so bilinear look-ups are worst there.
/// The table below has the rms errors of bilinear look-ups over a disc, against the scene, as
/// fractions of the peak of the brightest channel: in the median and at worst, for gold paint under
/// each shipped light and for each shipped material in the lobby.
///
/// | N | median | worst |
/// |---:|---:|---:|
/// | 64 | 1.3e-2 | 4e-2 |
/// | 128 | 6e-3 | 1.9e-2 |
/// | 256 | 2.8e-3 | 8.6e-3 |
/// | 512 | 1.3e-3 | 4e-3 |
/// | 1024 | 6e-4 | 1.8e-3 |
///
/// ```
/// use eigenshade::object::Matcap;
///
/// let mut matcap = [[0.0; 3]; 8 * 8];
/// for texel in Matcap::new(8)? {
///     matcap[texel.index()] = texel.normal().components();
/// }
/// assert_eq!(matcap[3 * 8 + 4][..2], [0.125, 0.125]);
/// assert_eq!(matcap[0][2], 0.0);
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Matcap {
    size: usize,
    /// Of 1/2 the width of the square.
    radius: f32,
    /// The next texel.
    column: usize,
    row: usize,
}

impl Matcap {
    /// The radius of the disc that three.js looks up: it multiplies normals by 0.495.
    pub const THREE_JS: f32 = 0.99;

    /// The radius of the disc that Blender looks up: it multiplies normals by 0.496.
    pub const BLENDER: f32 = 0.992;

    /// The texels of a matcap.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] if the size is 0.
    pub const fn new(size: usize) -> Result<Self, Error> {
        if size == 0 {
            return Err(Error::Size { found: size });
        }
        Ok(Self { size, radius: 1.0, column: 0, row: 0 })
    }

    /// The texels of a side.
    #[must_use]
    pub const fn size(&self) -> usize {
        self.size
    }

    /// This matcap for an engine that looks up a disc of this radius; 1 fills the square. The
    /// margin around the disc has the rim's values.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] unless the radius is above 0 and at most 1.
    pub const fn with_radius(self, radius: f32) -> Result<Self, Error> {
        if radius > 0.0 && radius <= 1.0 {
            Ok(Self { radius, ..self })
        } else {
            Err(Error::Outside { argument: Argument::Radius })
        }
    }
}

impl Iterator for Matcap {
    type Item = MatcapTexel;

    fn next(&mut self) -> Option<MatcapTexel> {
        let (column, row, size) = (self.column, self.row, self.size);
        if row >= size {
            return None;
        }
        (self.column, self.row) = if column + 1 < size { (column + 1, row) } else { (0, row + 1) };
        let scale = 1.0 / (size as f32 * self.radius);
        let [x, y] =
            [2 * column + 1, 2 * row + 1].map(|twice| (twice as f32 - size as f32) * scale);
        Some(MatcapTexel { column, row, size, x, y: -y })
    }
}

/// A texel of a [`Matcap`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MatcapTexel {
    column: usize,
    row: usize,
    size: usize,
    x: f32,
    y: f32,
}

impl MatcapTexel {
    /// The column, from 0 at the left.
    #[must_use]
    pub const fn column(self) -> usize {
        self.column
    }

    /// The row, from 0 at the top.
    #[must_use]
    pub const fn row(self) -> usize {
        self.row
    }

    /// The index in a picture stored row by row from the top.
    #[must_use]
    pub const fn index(self) -> usize {
        self.row * self.size + self.column
    }

    /// The normal. Costs a root.
    #[must_use]
    pub fn normal(self) -> Normal {
        let Self { x, y, .. } = self;
        let square = x * x + y * y;
        if square <= 1.0 {
            Normal { x, y, z: mathematics::square_root(1.0 - square) }
        } else {
            let scale = mathematics::inverse_root(square);
            Normal { x: x * scale, y: y * scale, z: 0.0 }
        }
    }
}
