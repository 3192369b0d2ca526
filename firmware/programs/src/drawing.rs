//! A picture of a sphere, computed in integers.

use eigenshade::Q15;
use eigenshade::q15::Normal;

/// Pixels along a side of a picture in color.
const SIDE: i32 = 16;

/// Draws a sphere in color, three letters a pixel: the upper bits of `shade`, from `a` to `p`.
/// Each pixel is printed as soon as it is computed, so no frame buffer is needed.
pub fn in_color(shade: impl Fn(Normal) -> [i32; 3]) {
    for row in 0..SIDE {
        for column in 0..SIDE {
            let x = (2 * column + 1 - SIDE) * (32768 / SIDE);
            let y = (SIDE - 2 * row - 1) * (32768 / SIDE);
            let square = (1 << 30) - x * x - y * y;
            let mut pixel = [0; 3];
            if square > 0 {
                let z = root(square.cast_unsigned()).cast_signed();
                let [x, y, z] = [x, y, z.min(32767)].map(|one| Q15(one as i16));
                pixel = Normal::from_unit(x, y, z).map_or(pixel, &shade);
            }
            for value in pixel {
                board::print_byte(b'a' + (value.max(0) >> 14).min(15) as u8);
            }
        }
        board::print_byte(b'\n');
    }
}

/// The square root, rounded down.
fn root(number: u32) -> u32 {
    let (mut root, mut bit) = (0_u32, 1 << 15);
    while bit > 0 {
        let next = root | bit;
        if next * next <= number {
            root = next;
        }
        bit >>= 1;
    }
    root
}
