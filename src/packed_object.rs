//! Pictures of textured objects, six bytes a pixel, in the format of
//! [`object`](crate::index::object).

use crate::color::Rgb;
use crate::error::Error;
use crate::index::object::{MAGIC, RECORD};
use crate::nodes::Nodes;
use crate::normal::Normal;
use crate::normal_code::NormalCode;
use crate::q15;
use crate::region::Region;
use crate::rows::Rows;
use crate::srgb::LINEAR;

/// A picture of an object: for each pixel a normal, a base color, a coverage and a [`Region`] of the
/// same metallic and roughness. It is drawn under any light from a
/// [`LinearPalette`](crate::screen::LinearPalette) for each region.
///
/// `eigenshade pack-object` makes one from a `.glb` or from another file of an object with materials.
/// Occlusion is in the base colors of what is matte.
///
/// ```
/// use eigenshade::object::Object;
///
/// // Two pixels of one region, in two rows.
/// let object: [&[u8]; 6] = [
///     b"eigob\x01\x02\0\x02\0\x01\0",         // 2 x 2 pixels, 1 region
///     &[0, 0, 0, 0x40, 0, 0x7b],              // metallic 0, roughness 0.5, matte share 0.96
///     &[0, 0, 0, 0, 2, 0, 0, 0, 4, 0, 0, 0],  // two records a row
///     &[1, 0, 1, 0, 0, 0],                    // from column 1 on, 1 pixel of region 0
///     &[0, 0, 200, 90, 10, 255],              // facing the camera, orange
///     &[0, 0, 1, 0, 0, 0, 20, 0, 9, 9, 9, 128],
/// ];
/// let bytes = object.concat();
/// let object = Object::new(&bytes)?;
/// let pixel = object.pixels().next().expect("it has two");
/// assert_eq!((pixel.column(), pixel.row(), pixel.coverage()), (1, 0, 255));
/// assert_eq!(object.regions().count(), 1);
/// assert!(Object::new(&bytes[..40]).is_err());
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Object<'a> {
    width: u16,
    height: u16,
    regions: &'a [[u8; RECORD]],
    rows: Rows<'a, RECORD>,
}

impl<'a> Object<'a> {
    /// The object of a file that `eigenshade pack-object` wrote. Bytes after it are ignored.
    ///
    /// Cost: some instructions for each row and each run.
    ///
    /// # Errors
    ///
    /// [`Error::Object`] if the bytes are something else, were cut or changed.
    pub const fn new(bytes: &'a [u8]) -> Result<Self, Error> {
        Self::of_rows(bytes, [0, usize::MAX])
    }

    /// [`new`](Self::new), but only some rows have their runs checked: a first row and a number of
    /// rows. Other rows may be drawn in part.
    #[doc(hidden)]
    pub const fn of_rows(bytes: &'a [u8], rows: [usize; 2]) -> Result<Self, Error> {
        match Self::read(bytes, rows) {
            Some(object) => Ok(object),
            None => Err(Error::Object),
        }
    }

    const fn read(bytes: &'a [u8], checked: [usize; 2]) -> Option<Self> {
        let Some((&MAGIC, rest)) = bytes.split_first_chunk() else { return None };
        let Some((sizes, rest)) = rest.split_first_chunk() else { return None };
        let [width, height, regions] = words(*sizes);
        let Some((of_regions, rest)) = rest.split_at_checked(regions as usize * RECORD) else {
            return None;
        };
        let Some(rows) = Rows::read(rest, height) else { return None };
        let object = Self { width, height, regions: of_regions.as_chunks().0, rows };
        if width > 0 && object.has_regions() && object.has_rows(checked) {
            Some(object)
        } else {
            None
        }
    }

    const fn has_regions(&self) -> bool {
        let mut rest = self.regions;
        while let [region, others @ ..] = rest {
            if Region::of_bytes(*region).is_none() {
                return false;
            }
            rest = others;
        }
        true
    }

    /// Whether each of these rows has whole runs from left to right.
    const fn has_rows(&self, [mut row, mut count]: [usize; 2]) -> bool {
        while count > 0 && row < self.height() {
            match self.rows.get(row) {
                Some(records) if self.has_runs(records) => {}
                _ => return false,
            }
            (row, count) = (row + 1, count - 1);
        }
        true
    }

    const fn has_runs(&self, mut row: &[[u8; RECORD]]) -> bool {
        let mut column = 0;
        while let [run, rest @ ..] = row {
            let [first, count, region] = words(*run);
            let end = first as usize + count as usize;
            let is_placed = first as usize >= column && end <= self.width as usize;
            let Some((_, after)) = rest.split_at_checked(count as usize) else { return false };
            if !is_placed || count == 0 || region as usize >= self.regions.len() {
                return false;
            }
            (row, column) = (after, end);
        }
        true
    }

    /// Pixels across.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width as usize
    }

    /// Pixels down.
    #[must_use]
    pub const fn height(&self) -> usize {
        self.height as usize
    }

    /// The regions, by number.
    #[must_use]
    pub fn regions(&self) -> impl ExactSizeIterator<Item = Region> + 'a {
        let region = |bytes: &[u8; RECORD]| Region::of_bytes(*bytes).unwrap_or_default();
        self.regions.iter().map(region)
    }

    /// The nodes of a palette that a region needs. Cost: some 80 instructions a pixel, once for an
    /// object.
    #[must_use]
    pub fn nodes(&self, region: usize) -> Nodes {
        let pixels = self.pixels().filter(|pixel| pixel.region() == region);
        pixels.map(ObjectPixel::code).collect()
    }

    /// The pixels that the object covers at least in part, row by row from the top.
    pub fn pixels(&self) -> impl Iterator<Item = ObjectPixel> + 'a {
        let object = *self;
        (0..object.height()).flat_map(move |row| {
            object.runs(row).flat_map(move |run| {
                run.pixels.iter().zip(run.column..).filter_map(move |(&record, column)| {
                    let (code, base, coverage) = pixel(record)?;
                    Some(ObjectPixel { column, row, region: run.region, code, base, coverage })
                })
            })
        })
    }

    /// The runs of a row, from the left.
    pub(crate) fn runs(&self, row: usize) -> Runs<'a> {
        Runs(self.rows.get(row).unwrap_or_default())
    }
}

/// Three numbers of 16 bits.
const fn words([a, b, c, d, e, f]: [u8; RECORD]) -> [u16; 3] {
    [u16::from_le_bytes([a, b]), u16::from_le_bytes([c, d]), u16::from_le_bytes([e, f])]
}

/// The parts of a pixel; `None` if its code is beyond the rim.
#[inline(always)]
pub(crate) fn pixel([u, v, r, g, b, coverage]: [u8; RECORD]) -> Option<(NormalCode, [u8; 3], u8)> {
    Some((NormalCode::inside([u, v])?, [r, g, b], coverage))
}

/// A linear base color in units of 2^-16.
#[inline(always)]
pub(crate) fn linear(base: [u8; 3]) -> Rgb<u16> {
    Rgb::from(base).map(|level| LINEAR.get(usize::from(level)).copied().unwrap_or_default())
}

/// Pixels of a row that follow one another in one region.
pub(crate) struct Run<'a> {
    pub(crate) column: usize,
    pub(crate) region: usize,
    pub(crate) pixels: &'a [[u8; RECORD]],
}

/// Iterates over the runs of a row.
#[derive(Clone, Debug)]
pub(crate) struct Runs<'a>(&'a [[u8; RECORD]]);

impl<'a> Iterator for Runs<'a> {
    type Item = Run<'a>;

    fn next(&mut self) -> Option<Run<'a>> {
        let (&run, rest) = self.0.split_first()?;
        let [column, count, region] = words(run).map(usize::from);
        let (pixels, after) = rest.split_at_checked(count)?;
        self.0 = after;
        Some(Run { column, region, pixels })
    }
}

/// A pixel of an [`Object`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ObjectPixel {
    column: usize,
    row: usize,
    region: usize,
    code: NormalCode,
    base: [u8; 3],
    coverage: u8,
}

impl ObjectPixel {
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

    /// The number of its region.
    #[must_use]
    pub const fn region(self) -> usize {
        self.region
    }

    /// The code of the normal.
    #[must_use]
    pub const fn code(self) -> NormalCode {
        self.code
    }

    /// The linear base color in units of 2^-16.
    #[must_use]
    pub fn base_color(self) -> Rgb<u16> {
        linear(self.base)
    }

    /// The share of the pixel that the object covers, of 255.
    #[must_use]
    pub const fn coverage(self) -> u8 {
        self.coverage
    }

    /// The normal of the pixel's code, each component within 2e-6 of the exact value.
    #[inline]
    #[must_use]
    pub fn normal(self) -> Normal {
        self.code.normal()
    }

    /// The normal of the pixel's code in integers, each component within 2.5 units of 2^-15 of the
    /// exact value.
    #[inline]
    #[must_use]
    pub fn normal_q15(self) -> q15::Normal {
        self.code.normal_q15()
    }
}
