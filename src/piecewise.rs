//! Functions as tables of straight pieces.

/// Intervals of a piece, all of the same width.
pub(crate) const INTERVALS: usize = 128;

/// The values of a function at both ends of every interval, from 0 on.
pub(crate) type Piece = [u16; INTERVALS + 1];

/// The value at `place`, with intervals of 2^`width`: interpolated, rounded down. The function must
/// rise. 0 beyond the end of the piece.
#[inline(always)]
pub(crate) fn interpolated(piece: &Piece, place: u32, width: u32) -> u16 {
    let interval = piece.get((place >> width) as usize..);
    let Some(&[from, to]) = interval.and_then(|rest| rest.first_chunk()) else { return 0 };
    let (from, to) = (u32::from(from), u32::from(to));
    let way = place & ((1 << width) - 1);
    (from + ((to.wrapping_sub(from).wrapping_mul(way)) >> width)) as u16
}
