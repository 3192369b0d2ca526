//! Where objects are drawn.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Output, Place, disjoint};
use crate::row::Row;
use crate::status::Status;
use core::ffi::c_void;
use core::ops::Range;
use eigenshade::screen::{self, Pixel};

/// How the pixels of a target are stored.
#[derive(Clone, Copy)]
#[repr(i32)]
pub enum Encoding {
    /// RGB565 in the processor's byte order, red in the highest bits: frame buffers, and LVGL.
    Rgb565 = 0,
    /// RGB565 with the high byte first, as most displays on SPI take it.
    Rgb565HighFirst = 1,
    /// RGB888: the bytes red, green and blue.
    Rgb888 = 2,
    /// RGBA8888: the bytes red, green, blue and opacity. Over zeros, an object has the opacity of
    /// its coverage, and is transparent around it.
    Rgba8888 = 3,
}

impl Encoding {
    /// The encoding of this number in C.
    pub(crate) fn new(number: i32) -> Result<Self, Status> {
        let encodings = [Self::Rgb565, Self::Rgb565HighFirst, Self::Rgb888, Self::Rgba8888];
        encodings.into_iter().find(|&one| one as i32 == number).ok_or(Status::Encoding)
    }

    /// Bytes of a pixel.
    pub(crate) const fn bytes(self) -> usize {
        match self {
            Self::Rgb565 | Self::Rgb565HighFirst => 2,
            Self::Rgb888 => 3,
            Self::Rgba8888 => 4,
        }
    }
}

/// A window of pixels that objects are drawn into, such as a screen, a part of it or a band of its
/// rows, and the place of the object.
///
/// What is outside of the window is not drawn. Pixels that an object covers in part are mixed with
/// what is there, so clear a buffer before each frame.
#[repr(C)]
pub struct Target {
    /// The pixel at the window's top left; the caller's.
    pub pixels: *mut c_void,
    /// Number of bytes from there on, at least to the window's last pixel.
    pub length: usize,
    /// Bytes from a row to the next, an even number in `EIGENSHADE_ENCODING_RGB565`. Not used if
    /// there is one row.
    pub stride: usize,
    /// Pixels across the window.
    pub width: usize,
    /// Pixels down the window.
    pub height: usize,
    /// The column of the window where the object's left border is. May be below 0.
    pub x: i32,
    /// The row of the window where the object's upper border is, counted from the top. May be
    /// below 0.
    pub y: i32,
    /// One of `eigenshade_encoding`.
    pub encoding: i32,
}

/// An object that can be drawn into pixels of a type.
pub(crate) trait Drawn<P> {
    /// Draws the part that the target has.
    fn draw(&self, target: &mut screen::Target<'_, P>);
}

/// An object that can be drawn in every encoding.
pub(crate) trait DrawnInAny:
    Drawn<u16> + Drawn<[u8; 2]> + Drawn<[u8; 3]> + Drawn<[u8; 4]>
{
}
impl<D: Drawn<u16> + Drawn<[u8; 2]> + Drawn<[u8; 3]> + Drawn<[u8; 4]>> DrawnInAny for D {}

/// A target that was checked.
pub(crate) struct Window<'t> {
    target: &'t Target,
    pub(crate) encoding: Encoding,
    written: [Place; 1],
}

impl<'t> Window<'t> {
    pub(crate) fn of(target: &'t Input<Target>) -> Result<Self, Status> {
        let target = target.value()?;
        let encoding = Encoding::new(target.encoding)?;
        let &Target { pixels, length, stride, width, height, .. } = target;
        if pixels.is_null() {
            return Err(Status::NullPointer);
        }
        let row = width.saturating_mul(encoding.bytes());
        let before = height.saturating_sub(1).saturating_mul(stride);
        let is_aligned = match encoding {
            Encoding::Rgb565 if !pixels.cast::<u16>().is_aligned() => {
                return Err(Status::Unaligned);
            }
            Encoding::Rgb565 => stride.is_multiple_of(2),
            Encoding::Rgb565HighFirst | Encoding::Rgb888 | Encoding::Rgba8888 => true,
        };
        let fits = height == 1 || (stride >= row && is_aligned);
        if row == 0 || height == 0 || !fits || before.saturating_add(row) > length {
            return Err(Status::Target);
        }
        let written = [Output(pixels.cast::<u8>()).place_of_array(length)?];
        disjoint(&written, &[Place::of(target)])?;
        Ok(Self { target, encoding, written })
    }

    /// Checks that the pixels do not overlap what is read.
    pub(crate) fn apart_from(&self, read: &[Place]) -> Result<(), Status> {
        disjoint(&self.written, read)
    }

    /// The rows of an object of any height that the window has: the first one, and their number.
    pub(crate) fn rows_of(&self) -> [usize; 2] {
        let rows = visible(self.target.y, usize::MAX, self.target.height);
        [rows.start, rows.len()]
    }

    /// Draws an object of this size.
    ///
    /// # Safety
    ///
    /// As for [`rows`](Self::rows).
    pub(crate) unsafe fn draw(
        &self,
        size: [usize; 2],
        object: &impl DrawnInAny,
    ) -> Result<(), Status> {
        let draw = |row, columns: &Range<usize>, pixels: Row<'_>| {
            let corner = [columns.start, row].map(|place| (place as i32).wrapping_neg());
            match pixels {
                Row::Rgb565(pixels) => draw_row(object, corner, pixels),
                Row::HighFirst(pixels) => draw_row(object, corner, pixels),
                Row::Rgb888(pixels) => draw_row(object, corner, pixels),
                Row::Rgba8888(pixels) => draw_row(object, corner, pixels),
            }
        };
        // SAFETY: this function's caller promises as much.
        unsafe { self.rows(size, draw) }
    }

    /// Calls `draw` with each row of an object of this size that the window has, the row's columns
    /// that the window has, and their pixels.
    ///
    /// # Safety
    ///
    /// The pixels overlap nothing that is in use.
    pub(crate) unsafe fn rows(
        &self,
        [width, height]: [usize; 2],
        mut draw: impl FnMut(usize, &Range<usize>, Row<'_>) -> Result<(), Status>,
    ) -> Result<(), Status> {
        let Target { pixels, stride, x, y, .. } = *self.target;
        let columns = visible(x, width, self.target.width);
        if columns.is_empty() {
            return Ok(());
        }
        let left = columns.start.wrapping_add_signed(x as isize) * self.encoding.bytes();
        for row in visible(y, height, self.target.height) {
            let before = row.wrapping_add_signed(y as isize) * stride;
            let (first, count) = (pixels.wrapping_byte_add(before + left), columns.len());
            // SAFETY: the pixels are inside of the window, which C promises. The caller promises
            // the rest, and no other row is in use.
            let pixels = unsafe { Row::new(self.encoding, first, count) }?;
            draw(row, &columns, pixels)?;
        }
        Ok(())
    }
}

/// Draws the part of an object that is in one row of pixels.
fn draw_row<P: Pixel>(
    object: &impl Drawn<P>,
    [x, y]: [i32; 2],
    pixels: &mut [P],
) -> Result<(), Status> {
    let width = pixels.len();
    object.draw(&mut screen::Target::new(pixels, width)?.at(x, y));
    Ok(())
}

/// Of an object's places, of which there are `length`, those that are from 0 to `end` if the first is
/// at `at`.
fn visible(at: i32, length: usize, end: usize) -> Range<usize> {
    let (before, start) = (at.min(0).unsigned_abs() as usize, at.max(0).unsigned_abs() as usize);
    let count = length.saturating_sub(before).min(end.saturating_sub(start));
    before..before + count
}
