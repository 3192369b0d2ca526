//! Buffers with a capacity fixed at compile time.

use crate::error::{Error, What};

/// A buffer of `needed` zeros.
#[inline]
pub(crate) fn zeros<S: Copy + Default, const N: usize>(
    what: What,
    needed: usize,
) -> Result<heapless::Vec<S, N>, Error> {
    if needed > N {
        return Err(Error::Capacity { what, needed, capacity: N });
    }
    let mut buffer = heapless::Vec::from_array([S::default(); N]);
    buffer.truncate(needed);
    Ok(buffer)
}
