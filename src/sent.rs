//! Which parts of a frame changed since they were sent to a display.

use crate::pixel::Pixel;

/// A checksum of each part of a frame as it was last sent, such as of `N` rows: where little changes,
/// the bus of a display limits the frames, and only parts that changed need to be sent.
///
/// A change is missed if both checksums are equal, by chance one of 2^32.
///
/// ```
/// use eigenshade::screen::Sent;
///
/// let (mut sent, row) = (Sent::<240>::default(), [0x001f_u16; 240]);
/// let mut send = |row: &[u16]| Ok::<(), &str>(assert_eq!(row.len(), 240));
/// assert_eq!(sent.send(7, &row, &mut send), Ok(true));
/// assert_eq!(sent.send(7, &row, &mut send), Ok(false)); // It was sent.
/// assert_eq!(sent.send(8, &row, |_| Err("the bus is busy")), Err("the bus is busy"));
/// assert_eq!(sent.send(8, &row, &mut send), Ok(true));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sent<const N: usize> {
    sums: [Option<u32>; N],
}

/// Nothing was sent.
impl<const N: usize> Default for Sent<N> {
    fn default() -> Self {
        Self { sums: [None; N] }
    }
}

impl<const N: usize> Sent<N> {
    /// Sends a part, unless it was last sent with these pixels. Returns whether it was sent now. A
    /// part of number `N` or above always is.
    ///
    /// Cost: some five instructions a pixel.
    ///
    /// # Errors
    ///
    /// That of `send`; the part then counts as not sent.
    pub fn send<P: Pixel, E>(
        &mut self,
        part: usize,
        pixels: &[P],
        send: impl FnOnce(&[P]) -> Result<(), E>,
    ) -> Result<bool, E> {
        let sum = pixels.iter().fold(pixels.len() as u32, |sum, pixel| {
            // The factor is odd, so that no pixel is lost.
            (sum.rotate_left(5) ^ pixel.word()).wrapping_mul(0x9e37_79b9)
        });
        let mut alone = None;
        let last = self.sums.get_mut(part).unwrap_or(&mut alone);
        if *last == Some(sum) {
            return Ok(false);
        }
        *last = None;
        send(pixels)?;
        *last = Some(sum);
        Ok(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_sent<const N: usize, P: Pixel>(sent: &mut Sent<N>, part: usize, row: &[P]) -> bool {
        sent.send(part, row, |_| Ok::<(), ()>(())) == Ok(true)
    }

    #[test]
    fn a_change_of_any_pixel_is_seen() {
        let mut sent = Sent::<2>::default();
        let mut row = [[0_u8; 3]; 65];
        assert!(is_sent(&mut sent, 1, &row) && !is_sent(&mut sent, 1, &row));
        for (index, channel) in (0..65).flat_map(|index| (0..3).map(move |c| (index, c))) {
            if let Some(byte) = row.get_mut(index).and_then(|pixel| pixel.get_mut(channel)) {
                *byte ^= 1 << (index % 8);
            }
            assert!(is_sent(&mut sent, 1, &row) && !is_sent(&mut sent, 1, &row), "{index}");
        }
        assert!(is_sent(&mut sent, 0, &[0_u16; 4]) && is_sent(&mut sent, 0, &[0_u16; 5]));
        assert!(is_sent(&mut sent, 2, &row) && is_sent(&mut sent, 2, &row));
        assert!(is_sent(&mut Sent::<0>::default(), 0, &[[0_u8; 2]; 0]));
    }

    #[test]
    fn what_failed_was_not_sent() {
        let (mut sent, row) = (Sent::<1>::default(), [5_u16; 9]);
        assert_eq!(sent.send(0, &row, |_| Err(3)), Err(3));
        assert!(is_sent(&mut sent, 0, &row));
        assert_eq!(sent.send(0, &[6_u16; 9], |_| Err(4)), Err(4));
        assert!(is_sent(&mut sent, 0, &row) && !is_sent(&mut sent, 0, &row));
    }
}
