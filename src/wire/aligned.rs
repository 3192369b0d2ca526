//! Bytes aligned to [`ALIGNMENT`](crate::index::wire::ALIGNMENT).

use super::WireError;
use crate::index::wire::ALIGNMENT;
use zerocopy::IntoBytes;

/// Bytes embedded at compile time, aligned to four: `static TABLE: &Aligned<[u8]> =
/// &Aligned(*include_bytes!("table.esw"));`.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C, align(4))]
pub struct Aligned<T: ?Sized>(pub T);

const _: () = assert!(align_of::<Aligned<u8>>() == ALIGNMENT && align_of::<u32>() <= ALIGNMENT);

/// Copies bytes to an aligned place. `room` needs one number for every four bytes, rounded up.
///
/// # Errors
///
/// [`WireError::Room`] if `room` is too short.
pub fn aligned<'r>(bytes: &[u8], room: &'r mut [u32]) -> Result<&'r [u8], WireError> {
    let (needed, found) = (bytes.len().div_ceil(ALIGNMENT), room.len());
    let to = room.as_mut_bytes().get_mut(..bytes.len()).ok_or(WireError::Room { needed, found })?;
    for (to, &from) in to.iter_mut().zip(bytes) {
        *to = from;
    }
    Ok(to)
}
