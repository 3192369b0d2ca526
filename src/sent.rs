//! Which parts of a frame changed since they were sent to a display.

use crate::pixel::Pixel;

/// A checksum of each part of a frame as it was last sent, such as of `N` rows: where little changes,
/// the bus of a display limits the frames, and only parts that changed need to be sent.
///
/// A change of one pixel is always seen. Other changes are missed with a probability of 2^-32.
///
/// ```
/// use eigenshade::screen::Sent;
///
/// let (mut sent, row) = (Sent::<240>::default(), [0x001f_u16; 240]);
/// assert!(sent.changed(7, &row)); // Send it.
/// assert!(!sent.changed(7, &row));
/// assert!(sent.changed(8, &row));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sent<const N: usize> {
    /// 0 where nothing was sent.
    sums: [u32; N],
}

/// Nothing was sent.
impl<const N: usize> Default for Sent<N> {
    fn default() -> Self {
        Self { sums: [0; N] }
    }
}

impl<const N: usize> Sent<N> {
    /// Whether this part has other pixels than at the last call with its number; then send it. A part
    /// of number `N` or above always has.
    ///
    /// Cost: some five instructions a pixel.
    pub fn changed<P: Pixel>(&mut self, part: usize, pixels: &[P]) -> bool {
        let sum = pixels.iter().fold(pixels.len() as u32 | 1, |sum, pixel| {
            // Odd, so that no pixel is lost.
            (sum.rotate_left(5) ^ pixel.word()).wrapping_mul(0x9e37_79b9)
        });
        let sum = sum.max(1);
        match self.sums.get_mut(part) {
            Some(last) => core::mem::replace(last, sum) != sum,
            None => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_of_any_pixel_is_seen() {
        let mut sent = Sent::<2>::default();
        let mut row = [[0_u8; 3]; 65];
        assert!(sent.changed(1, &row) && !sent.changed(1, &row));
        for (index, channel) in (0..65).flat_map(|index| (0..3).map(move |c| (index, c))) {
            if let Some(byte) = row.get_mut(index).and_then(|pixel| pixel.get_mut(channel)) {
                *byte ^= 1 << (index % 8);
            }
            assert!(sent.changed(1, &row) && !sent.changed(1, &row), "{index}");
        }
        assert!(sent.changed(0, &[0_u16; 4]) && sent.changed(0, &[0_u16; 5]));
        assert!(sent.changed(2, &row) && sent.changed(2, &row));
        assert!(Sent::<0>::default().changed(0, &[[0_u8; 2]; 0]));
    }
}
