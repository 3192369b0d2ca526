//! Pictures of a sphere, computed in integers.

use eigenshade::Q15;
use eigenshade::q15::Normal;

/// Rows of text; a character is twice as high as wide.
const ROWS: i32 = 18;

/// From dark to bright.
const SHADES: &[u8; 10] = b" .:-=+*#%@";

/// Draws a sphere as text. `shade` gets a normal in fractions of 2^31.
pub fn as_text(shade: impl Fn(i32, i32, i32) -> Option<i32>) {
    let irradiance = |row: i32, column: i32| {
        // Fractions of 2^15, from the middle of each character.
        let x = (2 * column + 1 - 2 * ROWS) * (32768 / (2 * ROWS));
        let y = (ROWS - 2 * row - 1) * (32768 / ROWS);
        let rest = (1 << 30) - x * x - y * y;
        let z = root(u32::try_from(rest).ok()?);
        // Not quite 1: that has no mantissa.
        let [x, y, z] = [x, y, z.cast_signed()].map(|one| (one << 16) - one);
        shade(x, y, z)
    };
    let mut peak = 1;
    for row in 0..ROWS {
        for column in 0..2 * ROWS {
            peak = peak.max(irradiance(row, column).unwrap_or(0));
        }
    }
    for row in 0..ROWS {
        for column in 0..2 * ROWS {
            let shade = irradiance(row, column).map_or(0, |value| {
                // Bright from 0 to 9, in steps of the square root, as screens are.
                let share = (value.max(0) / (peak / 256 + 1)).cast_unsigned();
                (root(share << 8) * 10 / 257) as usize
            });
            board::print_byte(SHADES.get(shade).copied().unwrap_or(b'@'));
        }
        board::print_byte(b'\n');
    }
}

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
