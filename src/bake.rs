//! Images baked onto the paraboloid map: N x N texels instead of polynomials.
//!
//! The map takes the normal n to the point (n_x, n_y) / (1 + n_z). The visible hemisphere fills the
//! unit disc, and the normal toward the camera is its center. The map is conformal and its scale
//! varies by no more than a factor of two, so texels are used evenly. In (n_x, n_y) itself texels
//! would crowd at the center and be missing at the rim.
//!
//! The texel in row j and column k lies at u = 2k/(N-1) - 1, v = 2j/(N-1) - 1, so the outermost
//! texels lie on the bounding square of the unit disc. Points outside the disc are hidden normals,
//! z < 0. The scene's polynomials continue smoothly there, and the texels next to the disc hold
//! these continued values, so that bilinear look-ups are as accurate at the rim as elsewhere.
//! Texels that no look-up of a visible normal reads are zero.
//!
//! A texel holds (1 - δ_u²/12)(1 - δ_v²/12) I, where δ² is the second difference along u or v.
//! Linear interpolation of a curved function errs to one side, by h² f''/12 on average over an
//! interval h. Subtracting this mean makes the error 2.4 times smaller.

use crate::buffer::Buffer;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::float;
use crate::normal::Normal;
use crate::scene::Scene;
use core::ops::Range;

/// The smallest and largest N of a map.
pub(crate) const SIZES: core::ops::RangeInclusive<usize> = 2..=4096;

/// One image baked into N x N texels, in `texels`.
///
/// The table gives rms errors against the baked scene, as fractions of the peak. The first number
/// is the median over the shipped lights on the gray materials, the second the worst case.
///
/// | N | rms |
/// |---|---|
/// | 32 | 4e-4, 2.1e-3 |
/// | 64 | 1e-4, 5e-4 |
/// | 128 | 2.5e-5, 1.4e-4 |
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BakedMap<B> {
    size: usize,
    /// Half the width of the map, (N - 1) / 2, reduced by a millionth so that the rim, and points
    /// that rounding puts beyond it, stay within the last cell without clamping.
    half: f32,
    texels: B,
}

impl<C> Scene<'_, C> {
    /// Bakes the scene into N x N texels; `T` must be at least N².
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::object::MapPoint;
    /// use eigenshade::{Light, Material, Normal, sphere};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let scene = sphere::collapse(&sphere::project(&light, &Material::new(&[2.0])?)?);
    /// let map = scene.bake::<{ 32 * 32 }>(32)?;
    /// let normal = Normal::new(0.0, 0.6, 0.8)?;
    /// assert!((map.bilinear(MapPoint::of(normal)) - scene.shade(normal)).abs() < 1e-2);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: shading at most N² + 8 N pixels, and as many divisions.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless N is 2 to 4096, [`Error::Capacity`] if `T` is too small.
    pub fn bake<const T: usize>(&self, size: usize) -> Result<BakedMap<Buffer<f32, T>>, Error>
    where
        C: AsRef<[f32]>,
    {
        check_size(size)?;
        self.bake_into(size, crate::buffer::zeros::<f32, T>(Argument::Texels, size * size)?)
    }

    /// [`bake`](Self::bake) into a buffer of your own, of length N².
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless N is 2 to 4096, [`Error::Length`] if the buffer has another
    /// length.
    pub fn bake_into<B: AsMut<[f32]>>(
        &self,
        size: usize,
        mut texels: B,
    ) -> Result<BakedMap<B>, Error>
    where
        C: AsRef<[f32]>,
    {
        check_size(size)?;
        let to = texels.as_mut();
        Error::check(Argument::Texels, size * size, to.len())?;
        to.fill(0.0);
        let grid = Grid::new(size);
        for row in 0..size {
            let run = grid.run(row);
            let texels = to.iter_mut().skip(row * size + run.start);
            for (texel, column) in texels.zip(run) {
                *texel = self.continued(&grid, column + 1, row + 1);
            }
        }
        for column in 0..size {
            let run = grid.run(column);
            let ends = [run.start, run.end + 1].map(|row| self.continued(&grid, column + 1, row));
            fit(to, run.start * size + column, size, run.len(), ends);
        }
        for row in 0..size {
            let run = grid.run(row);
            let ends = [run.start, run.end + 1].map(|place| self.fitted_along_v(&grid, place, row));
            fit(to, row * size + run.start, 1, run.len(), ends);
        }
        Ok(BakedMap { size, half: within(size), texels })
    }

    /// The irradiance less a twelfth of its second difference along v, at a place in a row.
    fn fitted_along_v(&self, grid: &Grid, place: usize, row: usize) -> f32
    where
        C: AsRef<[f32]>,
    {
        fitted([row, row + 1, row + 2].map(|row| self.continued(grid, place, row)))
    }

    /// Calls a function with each texel that a look-up reads and its index, in storage order.
    /// [`bake_into`](Self::bake_into) writes the same texels, bit by bit. No other texel is kept,
    /// so this shades up to 3 N² + 6 N pixels.
    pub(crate) fn each_texel(&self, size: usize, mut take: impl FnMut(usize, f32))
    where
        C: AsRef<[f32]>,
    {
        let grid = Grid::new(size);
        for row in 0..size {
            let run = grid.run(row);
            let at = |place| self.fitted_along_v(&grid, place, row);
            let (mut before, mut here) = (at(run.start), at(run.start + 1));
            for column in run {
                let next = at(column + 2);
                take(row * size + column, fitted([before, here, next]));
                (before, here) = (here, next);
            }
        }
    }

    /// The irradiance at the places of a column and of a row, also outside the disc. Not inlined,
    /// because its callers use it several times.
    #[inline(never)]
    fn continued(&self, grid: &Grid, column: usize, row: usize) -> f32
    where
        C: AsRef<[f32]>,
    {
        let point = MapPoint { u: grid.place(column), v: grid.place(row) };
        let [x, y, z] = point.direction();
        self.shade(Normal { x, y, z })
    }
}

pub(crate) fn check_size(size: usize) -> Result<(), Error> {
    if SIZES.contains(&size) { Ok(()) } else { Err(Error::Size { found: size }) }
}

/// (N - 1) / 2.
fn half(size: usize) -> f32 {
    ((size - 1) as f32) * 0.5
}

/// (N - 1) / 2, less 2^-20 of it.
fn within(size: usize) -> f32 {
    half(size) * (1.0 - 1.0 / (1 << 20) as f32)
}

/// The value in the middle of three less a twelfth of their second difference, which is what linear
/// interpolation adds on average over a cell.
fn fitted([before, here, after]: [f32; 3]) -> f32 {
    here + (here + here - (before + after)) * (1.0 / 12.0)
}

/// Replaces the values of a row or a column by [`fitted`] ones, given the values at its ends.
#[inline(never)]
fn fit(
    texels: &mut [f32],
    start: usize,
    stride: usize,
    count: usize,
    [mut before, after]: [f32; 2],
) {
    let mut last: Option<&mut f32> = None;
    // `step_by` panics at 0, which no caller passes and the compiler cannot prove.
    for next in texels.iter_mut().skip(start).step_by(stride.max(1)).take(count) {
        if let Some(to) = last.take() {
            let here = *to;
            *to = fitted([before, here, *next]);
            before = here;
        }
        last = Some(next);
    }
    if let Some(to) = last {
        *to = fitted([before, *to, after]);
    }
}

struct Grid {
    size: usize,
    step: f32,
}

impl Grid {
    fn new(size: usize) -> Self {
        Self { size, step: half(size).recip() }
    }

    /// u or v of texel k - 1: place 0 lies before the first texel, place N + 1 after the last.
    fn place(&self, k: usize) -> f32 {
        ((k as f32) - 1.0) * self.step - 1.0
    }

    /// The columns of a row, or the rows of a column, that look-ups of visible normals read. Never
    /// empty: the middle of each is read.
    fn run(&self, k: usize) -> Range<usize> {
        // From the point nearest to the center whose look-up reads the texel.
        let near = |k: usize| toward_zero(self.place(k + 1), self.step);
        let square = near(k.min(self.size - 1 - k));
        let square = square * square;
        let is_read = |k: &usize| near(*k) * near(*k) + square <= 1.001;
        let start = (0..self.size / 2).find(is_read).unwrap_or(self.size / 2);
        start..self.size - start
    }
}

/// |x| less a step, but at least zero.
fn toward_zero(x: f32, step: f32) -> f32 {
    let size = if x < 0.0 { -x } else { x };
    if size > step { size - step } else { 0.0 }
}

impl<B: AsRef<[f32]>> BakedMap<B> {
    /// Creates a map from N x N texels that were baked before.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless N is 2 to 4096, [`Error::Length`] unless there are N² texels.
    pub fn new(size: usize, texels: B) -> Result<Self, Error> {
        check_size(size)?;
        Error::check(Argument::Texels, size * size, texels.as_ref().len())?;
        Ok(Self { size, half: within(size), texels })
    }

    /// The number of texels per side, N.
    #[must_use]
    pub const fn size(&self) -> usize {
        self.size
    }

    /// The texels, row by row from v = -1 upward, each row from u = -1 to the right.
    #[must_use]
    pub fn texels(&self) -> &[f32] {
        self.texels.as_ref()
    }

    /// The irradiance at a point, interpolated between the four texels around it; 0 well outside.
    ///
    /// Cost: nine additions and products. The only division is the one in [`MapPoint::of`].
    #[inline]
    #[must_use]
    pub fn bilinear(&self, point: MapPoint) -> f32 {
        let (column, across) = self.cell(point.u);
        let (row, up) = self.cell(point.v);
        let Some(&[a, b, .., c, d]) = four(self.texels.as_ref(), self.size, row, column) else {
            return 0.0;
        };
        let (below, above) =
            (float::add_product(a, b - a, across), float::add_product(c, d - c, across));
        float::add_product(below, above - below, up)
    }

    /// The index of the texel before a coordinate, and the fraction of the way from it to the next.
    #[inline]
    fn cell(&self, x: f32) -> (usize, f32) {
        let place = float::add_product(self.half, x, self.half);
        let cell = place as usize;
        (cell, place - (cell as f32))
    }
}

/// The texels from one to its diagonal neighbor: the first and last two are the cell's corners.
#[inline]
pub(crate) fn four<T>(texels: &[T], size: usize, row: usize, column: usize) -> Option<&[T]> {
    texels.get(row.wrapping_mul(size).wrapping_add(column)..)?.get(..size + 2)
}

/// A normal in map coordinates: u to the right, v up. Visible normals lie in the unit disc.
///
/// A buffer of normals can store map points instead: they take two numbers instead of three, and a
/// look-up then needs no division.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MapPoint {
    pub(crate) u: f32,
    pub(crate) v: f32,
}

impl MapPoint {
    /// The point (u, v), unchecked: a point outside the disc looks up a meaningless texel.
    #[inline]
    #[must_use]
    pub const fn new(u: f32, v: f32) -> Self {
        Self { u, v }
    }

    /// The coordinates u and v.
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [f32; 2] {
        [self.u, self.v]
    }

    /// The map point of a normal. Costs one division.
    #[inline]
    #[must_use]
    pub fn of(normal: Normal) -> Self {
        let scale = (1.0 + normal.z).recip();
        Self { u: normal.x * scale, v: normal.y * scale }
    }

    /// The unit vector at this point, (2u, 2v, 1 - r²) / (1 + r²) with r² = u² + v²: a visible
    /// normal inside the unit disc, a hidden one outside. Costs one division.
    #[must_use]
    pub fn direction(self) -> [f32; 3] {
        let square = self.u * self.u + self.v * self.v;
        let scale = (1.0 + square).recip();
        let twice = scale + scale;
        [twice * self.u, twice * self.v, (1.0 - square) * scale]
    }
}

impl<C> Rgb<Scene<'_, C>> {
    /// [`Scene::bake`] in each channel; the same errors.
    pub fn bake<const T: usize>(&self, size: usize) -> Result<Rgb<BakedMap<Buffer<f32, T>>>, Error>
    where
        C: AsRef<[f32]>,
    {
        self.each_ref().try_map(|scene| scene.bake(size))
    }
}

impl<B: AsRef<[f32]>> Rgb<BakedMap<B>> {
    /// [`BakedMap::bilinear`] in each channel.
    #[inline]
    #[must_use]
    pub fn bilinear(&self, point: MapPoint) -> Rgb<f32> {
        self.each_ref().map(|map| map.bilinear(point))
    }
}
