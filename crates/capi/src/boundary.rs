//! Turns C's pointers into references; nothing else does.
#![expect(unsafe_code, reason = "pointers come from C")]

use crate::status::Status;
use eigenshade::{Q15, Q31};

/// Types for which any bytes are a valid value, including zeros: C may pass uninitialized arrays.
///
/// # Safety
///
/// Any bytes must be a valid value of the type.
pub(crate) unsafe trait Plain {}

// SAFETY: numbers, all of whose bits count.
unsafe impl Plain for f32 {}
// SAFETY: as above.
unsafe impl Plain for i8 {}
// SAFETY: as above.
unsafe impl Plain for i16 {}
// SAFETY: as above.
unsafe impl Plain for i32 {}
// SAFETY: as above.
unsafe impl Plain for usize {}
// SAFETY: a transparent i16.
unsafe impl Plain for Q15 {}
// SAFETY: a transparent i32.
unsafe impl Plain for Q31 {}

fn usable<T>(pointer: *const T) -> Result<(), Status> {
    if pointer.is_null() {
        Err(Status::NullPointer)
    } else if !pointer.is_aligned() {
        Err(Status::Unaligned)
    } else {
        Ok(())
    }
}

/// The value that a pointer points to.
///
/// # Safety
///
/// A pointer that is neither NULL nor unaligned points to a `T` that no one writes to
/// while it is borrowed.
pub(crate) unsafe fn shared<'a, T>(pointer: *const T) -> Result<&'a T, Status> {
    usable(pointer)?;
    // SAFETY: not NULL, aligned, the rest is the caller's promise.
    Ok(unsafe { &*pointer })
}

/// The memory that a pointer points to, filled with zeros, to be written to.
///
/// # Safety
///
/// A pointer that is neither NULL nor unaligned points to room for a `T` that no one else
/// reads or writes while it is borrowed.
pub(crate) unsafe fn exclusive<'a, T: Plain>(pointer: *mut T) -> Result<&'a mut T, Status> {
    usable(pointer)?;
    // SAFETY: not NULL, aligned, zeros are a `T`, the rest is the caller's promise.
    Ok(unsafe {
        pointer.write_bytes(0, 1);
        &mut *pointer
    })
}

/// Bytes of `count` values of `T`, or `None` if memory cannot hold them.
fn bytes<T>(count: usize) -> Option<usize> {
    count.checked_mul(size_of::<T>()).filter(|&bytes| bytes <= isize::MAX.unsigned_abs())
}

/// An array of numbers. If `count` is 0, it is empty for any pointer.
///
/// # Safety
///
/// A pointer that is neither NULL nor unaligned points to `count` numbers that no one
/// writes to while they are borrowed.
pub(crate) unsafe fn slice<'a, T: Plain>(
    pointer: *const T,
    count: usize,
) -> Result<&'a [T], Status> {
    if count == 0 {
        return Ok(&[]);
    }
    usable(pointer)?;
    bytes::<T>(count).ok_or(Status::Count)?;
    // SAFETY: not NULL, aligned, not beyond what an object may have, the rest is the
    // caller's promise.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
}

/// An array of numbers, to be read and written to.
///
/// # Safety
///
/// A pointer that is neither NULL nor unaligned points to `count` numbers that no one else
/// reads or writes while they are borrowed.
pub(crate) unsafe fn slice_to_change<'a, T: Plain>(
    pointer: *mut T,
    count: usize,
) -> Result<&'a mut [T], Status> {
    if count == 0 {
        return Ok(&mut []);
    }
    usable(pointer)?;
    bytes::<T>(count).ok_or(Status::Count)?;
    // SAFETY: not NULL, aligned, not beyond what an object may have, the rest is the
    // caller's promise.
    Ok(unsafe { core::slice::from_raw_parts_mut(pointer, count) })
}

/// An array of numbers, filled with zeros, to be written to.
///
/// # Safety
///
/// A pointer that is neither NULL nor unaligned points to room for `count` numbers that no
/// one else reads or writes while they are borrowed.
pub(crate) unsafe fn slice_to_write<'a, T: Plain>(
    pointer: *mut T,
    count: usize,
) -> Result<&'a mut [T], Status> {
    if count > 0 {
        usable(pointer)?;
        bytes::<T>(count).ok_or(Status::Count)?;
        // SAFETY: not NULL, aligned, the caller promises room for `count` numbers, and zeros are
        // numbers.
        unsafe { pointer.write_bytes(0, count) };
    }
    // SAFETY: this function's caller promises as much.
    unsafe { slice_to_change(pointer, count) }
}

/// The address range of an array.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    start: usize,
    bytes: usize,
}

impl Place {
    /// The range of one `T`.
    pub(crate) fn of<T>(pointer: *const T) -> Self {
        // NULL is rejected when the pointer is read.
        let bytes = if pointer.is_null() { 0 } else { size_of::<T>() };
        Self { start: pointer.addr(), bytes }
    }

    /// The range of `count` numbers.
    pub(crate) fn many<T>(pointer: *const T, count: usize) -> Result<Self, Status> {
        let bytes = bytes::<T>(count).ok_or(Status::Count)?;
        Ok(Self { bytes: if pointer.is_null() { 0 } else { bytes }, ..Self::of(pointer) })
    }

    fn overlaps(self, other: Self) -> bool {
        let (first, second) = if self.start < other.start { (self, other) } else { (other, self) };
        second.bytes > 0 && second.start - first.start < first.bytes
    }
}

/// Checks that the places that are written to overlap neither each other nor those that are read.
///
/// Must come before [`exclusive`] and [`slice_to_write`], which fill memory with zeros.
pub(crate) fn disjoint(written: &[Place], read: &[Place]) -> Result<(), Status> {
    let mut rest = written;
    while let [one, others @ ..] = rest {
        if others.iter().chain(read).any(|other| one.overlaps(*other)) {
            return Err(Status::Overlap);
        }
        rest = others;
    }
    Ok(())
}
