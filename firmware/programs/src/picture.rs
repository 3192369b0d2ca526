//! A picture in color, in three characters a pixel, on the way out at once: what a
//! display takes.

use eigenshade::Q15;
use eigenshade::quantized::Normal;

/// Pixels along a side.
const SIDE: i32 = 16;

/// Says the upper bytes of what `shade` gives, as letters from `a` to `p`.
pub fn draw(shade: impl Fn(Normal<Q15>) -> [i32; 3]) {
    for row in 0..SIDE {
        for column in 0..SIDE {
            let x = (2 * column + 1 - SIDE) * (32768 / SIDE);
            let y = (SIDE - 2 * row - 1) * (32768 / SIDE);
            let square = (1 << 30) - x * x - y * y;
            let mut pixel = [0; 3];
            if square > 0 {
                let z = crate::drawing::root(square.cast_unsigned()).cast_signed();
                let [x, y, z] = [x, y, z.min(32767)].map(|one| Q15(one as i16));
                pixel = Normal::<Q15>::new(x, y, z).map_or(pixel, &shade);
            }
            for value in pixel {
                board::print_byte(b'a' + (value.max(0) >> 14).min(15) as u8);
            }
        }
        board::print_byte(b'\n');
    }
}
