//! Where objects are drawn.

use crate::error::{Argument, Error};
use crate::pixel::Pixel;
use core::ops::Range;

/// Pixels that objects are drawn into: a screen, a part of it, or the buffer of a row, and the place
/// of the object.
///
/// What is outside is not drawn. Pixels that an object covers in part are mixed with what is there,
/// so clear a buffer before each frame, or draw one object over another.
///
/// ```
/// use eigenshade::object::Disc;
/// use eigenshade::screen::Target;
///
/// let mut screen = [0x0000_u16; 320 * 240];
/// let mut screen = Target::new(&mut screen, 320)?;
/// // A white disc, half of which is beyond the left border.
/// for pixel in Disc::new(100)? {
///     pixel.put(&mut screen.at(-50, 70), 0xffff);
/// }
/// assert_eq!(screen.pixel(0, 120), Some(&mut 0xffff));
/// assert_eq!(screen.pixel(60, 120), Some(&mut 0x0000));
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Debug, PartialEq, Eq)]
pub struct Target<'a, P = u16> {
    /// From the first pixel on.
    pixels: &'a mut [P],
    /// From a row to the next.
    stride: usize,
    width: usize,
    height: usize,
    /// Where objects have their top left corner.
    corner: [i32; 2],
}

impl<'a, P> Target<'a, P> {
    /// Pixels row by row from the top, `width` in each row. Objects are drawn at the top left corner.
    /// Pixels after the last whole row are not used.
    ///
    /// # Errors
    ///
    /// [`Error::Empty`] if the width is 0, [`Error::Length`] if there is no whole row.
    pub const fn new(pixels: &'a mut [P], width: usize) -> Result<Self, Error> {
        let argument = Argument::Picture;
        let Some(height) = pixels.len().checked_div(width) else {
            return Err(Error::Empty { argument });
        };
        if height == 0 {
            return Err(Error::Length { argument, expected: width, found: pixels.len() });
        }
        Ok(Self { pixels, stride: width, width, height, corner: [0; 2] })
    }

    /// The part of the target from this column and row of it on, of this width and height or up to
    /// the borders. Objects are drawn at its top left corner, wherever [`at`](Self::at) had them.
    #[must_use]
    pub fn part(&mut self, [left, top]: [usize; 2], [width, height]: [usize; 2]) -> Target<'_, P> {
        let width = self.width.saturating_sub(left).min(width);
        let height = self.height.saturating_sub(top).min(height);
        let first = top.saturating_mul(self.stride).saturating_add(left);
        let pixels = self.pixels.get_mut(first..).unwrap_or_default();
        Target { pixels, stride: self.stride, width, height, corner: [0; 2] }
    }

    /// The same pixels. Objects have their top left corner `x` pixels to the right of the target's
    /// and `y` pixels below it; both may be below 0.
    #[must_use]
    pub const fn at(&mut self, x: i32, y: i32) -> Target<'_, P> {
        let Self { stride, width, height, .. } = *self;
        Target { pixels: &mut *self.pixels, stride, width, height, corner: [x, y] }
    }

    /// The pixel in this column and row of an object, if the target has it.
    #[inline]
    #[must_use]
    pub fn pixel(&mut self, column: usize, row: usize) -> Option<&mut P> {
        let [x, y] = self.corner;
        let column = column.checked_add_signed(x as isize).filter(|&one| one < self.width)?;
        let row = row.checked_add_signed(y as isize).filter(|&one| one < self.height)?;
        self.pixels.get_mut(row * self.stride + column)
    }

    /// The rows of an object of this height that the target has.
    pub(crate) fn rows(&self, height: usize) -> Range<usize> {
        let [_, [before, after]] = self.corner.map(parts);
        let end = self.height.saturating_add(before).saturating_sub(after).min(height);
        before.min(end)..end
    }

    /// Of a row of an object, the first column that the target has, and the pixels from there on.
    pub(crate) fn row(&mut self, row: usize) -> (usize, &mut [P]) {
        let [[first, start], _] = self.corner.map(parts);
        let [_, y] = self.corner;
        let row = row.checked_add_signed(y as isize).filter(|&row| row < self.height);
        let pixels = row.and_then(|row| self.pixels.get_mut(row * self.stride..));
        let pixels = pixels.and_then(|pixels| pixels.get_mut(..self.width)?.get_mut(start..));
        (first, pixels.unwrap_or_default())
    }
}

/// The pixels of an object before the target's border, or those of the target before the object.
fn parts(corner: i32) -> [usize; 2] {
    let size = corner.unsigned_abs() as usize;
    if corner < 0 { [size, 0] } else { [0, size] }
}

impl<P: Pixel> Target<'_, P> {
    /// Draws over the pixel in this column and row of an object, which it covers by `coverage` /
    /// 255.
    #[inline]
    pub(crate) fn put(&mut self, [column, row]: [usize; 2], color: P, coverage: u8) {
        if let Some(below) = self.pixel(column, row) {
            *below = if coverage == u8::MAX { color } else { color.over(*below, coverage) };
        }
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    #[test]
    fn only_the_pixels_of_the_target_are_drawn() {
        // A part of 4 x 3 pixels of a screen of 7 x 5, and objects of 3 x 2 around it.
        for (x, y) in (-4..6).flat_map(|x| (-4..6).map(move |y| (x, y))) {
            let mut screen = [0_u16; 7 * 5 + 3];
            let mut target = Target::new(&mut screen, 7).unwrap();
            let mut part = target.part([2, 1], [4, 3]);
            let mut part = part.at(x, y);
            for (row, column) in (0..2).flat_map(|row| (0..3).map(move |column| (row, column))) {
                part.put([column, row], 1, 255);
            }
            for row in part.rows(2) {
                let (column, pixels) = part.row(row);
                pixels.iter_mut().take(3_usize.saturating_sub(column)).for_each(|one| *one += 1);
            }
            for (index, &found) in screen.iter().enumerate() {
                let [column, row] = [(index % 7) as i32 - 2, (index / 7) as i32 - 1];
                let is_inside = (0..4).contains(&column) && (0..3).contains(&row);
                let is_object = (x..x + 3).contains(&column) && (y..y + 2).contains(&row);
                let expected = if is_inside && is_object { 2 } else { 0 };
                assert_eq!(found, expected, "{x} {y} {column} {row}");
            }
        }
    }

    #[test]
    fn parts_end_at_the_borders() {
        let mut screen = [0_u16; 6];
        let mut target = Target::new(&mut screen, 3).unwrap();
        assert!(target.part([3, 0], [1, 1]).pixel(0, 0).is_none());
        assert!(target.part([0, usize::MAX], [1, usize::MAX]).pixel(0, 0).is_none());
        assert!(target.part([2, 1], [9, 9]).pixel(1, 0).is_none());
        assert!(target.part([2, 1], [9, 9]).pixel(0, 0).is_some());
        assert!(target.at(i32::MIN, i32::MAX).pixel(0, 0).is_none());
        assert!(target.at(i32::MIN, i32::MIN).rows(usize::MAX).count() <= 2);
        let argument = Argument::Picture;
        assert_eq!(Target::new(&mut screen, 0), Err(Error::Empty { argument }));
        let short = Error::Length { argument, expected: 7, found: 6 };
        assert_eq!(Target::new(&mut screen, 7), Err(short));
    }
}
