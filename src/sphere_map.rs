//! The codes of a sphere, made once for many frames.

use crate::disc::{Disc, coverage};
use crate::error::{Argument, Error};
use crate::normal_code::NormalCode;
use crate::normal_map::NormalMap;

/// Steps of a coverage.
const STEPS: i32 = 32;

impl NormalMap<'_> {
    /// Writes the codes of a sphere that fills a square picture, row by row from the top. The pixels
    /// of the rim have a coverage.
    ///
    /// ```
    /// use eigenshade::object::NormalMap;
    ///
    /// static CODES: [[u8; 2]; 64 * 64] = {
    ///     let mut codes = [NormalMap::BACKGROUND; 64 * 64];
    ///     assert!(NormalMap::sphere(64, &mut codes).is_ok());
    ///     codes
    /// };
    /// let map = NormalMap::new(64, 64, CODES.as_flattened())?;
    /// assert_eq!(map.pixels().filter(|pixel| pixel.coverage() == 255).count(), 3_112);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Codes take two bytes a pixel, 115 KB for 240 x 240. In a static, which is in flash, the
    /// compiler computes them in a second. At run time it takes a root and divisions of 64 bits for a
    /// quarter of the pixels.
    ///
    /// # Errors
    ///
    /// [`Error::Size`] unless `size` is 1 to [`Disc::MOST`], [`Error::Length`] unless there are as
    /// many codes as pixels.
    pub const fn sphere(size: usize, codes: &mut [[u8; 2]]) -> Result<(), Error> {
        if size == 0 || size > Disc::MOST {
            return Err(Error::Size { found: size });
        }
        if let Err(error) = Error::check(Argument::NormalMap, size * size, codes.len()) {
            return Err(error);
        }
        // A quarter at the top right, and its mirror images.
        let (mut row, half) = (0, size / 2);
        while row < size - half {
            let mut column = half;
            while column < size {
                let (left, below) = (size - 1 - column, size - 1 - row);
                let part = part([column, row], size);
                put(codes, row * size + column, part.code([1, 1]));
                put(codes, row * size + left, part.code([-1, 1]));
                put(codes, below * size + column, part.code([1, -1]));
                put(codes, below * size + left, part.code([-1, -1]));
                column += 1;
            }
            row += 1;
        }
        Ok(())
    }
}

/// Sets a code. Without a path to a panic: constant functions have no `get_mut`.
const fn put(codes: &mut [[u8; 2]], index: usize, code: [u8; 2]) {
    if let Some((_, [to, ..])) = codes.split_at_mut_checked(index) {
        *to = code;
    }
}

/// The part of a pixel that a sphere covers. The pixel is to the upper right of the center.
enum Part {
    /// All of it: the code of the normal.
    Whole([i8; 2]),
    /// A share in units of 1/[`STEPS`]. The pixel has the normal of its neighbor to the lower left.
    Share(i32),
    /// Nothing.
    None,
}

impl Part {
    /// The code of the pixel or of its mirror images, which are at the left or below.
    const fn code(&self, [right, up]: [i8; 2]) -> [u8; 2] {
        match *self {
            Self::Whole([u, v]) => [(u * right).cast_unsigned(), (v * up).cast_unsigned()],
            Self::Share(share) => NormalMap::edge_code((share * 8) as u8, [-right, up]),
            Self::None => NormalMap::BACKGROUND,
        }
    }
}

/// A pixel to the upper right of the center.
const fn part([column, row]: [usize; 2], size: usize) -> Part {
    let size = size as i32;
    // In half pixels.
    let (x, y) = (2 * column as i32 + 1 - size, size - 1 - 2 * row as i32);
    let square = x * x + y * y;
    if square > (size + 2) * (size + 2) {
        return Part::None;
    }
    let inner = size - 2;
    if inner > 0 && square <= inner * inner {
        return Part::Whole(own([x, y], size));
    }
    let share = coverage([x, y], size);
    if share >= STEPS {
        return Part::Whole(own([x, y], size));
    }
    // The neighbor to the lower left, or beyond the center, whose place is as far from it.
    let is_covered = coverage([x - 2, y - 2], size) >= STEPS;
    match share {
        1.. if is_covered => Part::Share(share),
        16.. if square <= size * size => Part::Whole(own([x, y], size)),
        _ => Part::None,
    }
}

/// The code of the normal at a place inside the circle.
const fn own([x, y]: [i32; 2], size: i32) -> [i8; 2] {
    let (square, whole) = ((x * x + y * y) as u64, (size as u64) * (size as u64));
    // The size is above zero, which a compiler does not see.
    let Some(rest) = ((whole - square) << 30).checked_div(whole) else { return [0; 2] };
    let z = rest.isqrt() as i32;
    let z = if z < 32_767 { z } else { 32_767 };
    match ((x << 15).checked_div(size), (y << 15).checked_div(size)) {
        (Some(x), Some(y)) => NormalCode::of_sphere([x, y], z).point(),
        _ => [0; 2],
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]
mod tests {
    use super::*;
    use crate::normal::Normal;

    #[test]
    fn codes_are_those_of_exact_normals_and_coverages_sum_to_the_area() {
        for size in [1, 2, 3, 4, 5, 8, 17, 64, 240, 333] {
            let mut codes = [NormalMap::BACKGROUND; 333 * 333];
            let codes = &mut codes[..size * size];
            NormalMap::sphere(size, codes).unwrap();
            let map = NormalMap::new(size, size, codes.as_flattened()).unwrap();
            let mut area = 0.0;
            for pixel in map.pixels() {
                area += f64::from(pixel.coverage()) / 255.0;
                if pixel.coverage() < 255 {
                    continue;
                }
                let place = |k: usize| (2.0 * k as f64 + 1.0) / size as f64 - 1.0;
                let (x, y) = (place(pixel.column()), -place(pixel.row()));
                let z = libm::sqrt((1.0 - x * x - y * y).max(0.0));
                let exact = NormalCode::of(Normal { x: x as f32, y: y as f32, z: z as f32 });
                let pairs = exact.bytes().into_iter().zip(pixel.code().bytes());
                for (exact, found) in pairs {
                    assert!(exact.cast_signed().abs_diff(found.cast_signed()) <= 1, "{size}");
                }
            }
            let circle = core::f64::consts::PI / 4.0 * (size * size) as f64;
            let allowed = (size as f64)
                * if size < 5 {
                    0.5
                } else if size < 10 {
                    0.12
                } else {
                    0.04
                };
            assert!((area - circle).abs() <= allowed, "{size}: {area} {circle}");
            // Every code is drawn.
            let drawn = codes.iter().filter(|&&code| code != NormalMap::BACKGROUND).count();
            assert_eq!(map.pixels().count(), drawn, "{size}");
        }
        for (size, count) in [(0, 0), (4_097, 0), (4, 15)] {
            assert!(NormalMap::sphere(size, &mut [[0; 2]; 16][..count]).is_err());
        }
    }
}
