//! Turns C's pointers into references; nothing else does.
#![expect(unsafe_code, reason = "pointers come from C")]

use crate::status::Status;
use eigenshade::Q15;

/// Types for which any bytes are a valid value, including zeros: C may pass uninitialized arrays.
///
/// # Safety
///
/// Any bytes must be a valid value of the type.
pub(crate) unsafe trait Plain {}

macro_rules! plain {
    ($($number:ty)*) => {$(
        // SAFETY: a number, all of whose bits count; Q15 is a transparent integer.
        unsafe impl Plain for $number {}
    )*};
}
plain!(f32 i8 u8 i16 u16 i32 i64 usize Q15);

// SAFETY: consists of plain values.
unsafe impl<T: Plain, const N: usize> Plain for [T; N] {}
// SAFETY: an address, which is checked before anything is read.
unsafe impl<T> Plain for *const T {}

/// Marks a record that this library wrote. Zeros do not have the mark, nor does memory that nobody
/// wrote, except by a chance of 2^-32.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(transparent)]
pub(crate) struct Mark(u32);

// SAFETY: a number.
unsafe impl Plain for Mark {}

impl Mark {
    /// A picture.
    pub(crate) const COMPUTED: Self = Self(0x6e67_6965);
    pub(crate) const NODES: Self = Self(0x6e67_6966);
    pub(crate) const PALETTE: Self = Self(0x6e67_6967);
    pub(crate) const LINEAR_PALETTE: Self = Self(0x6e67_6968);
    pub(crate) const OBJECT_COEFFICIENTS: Self = Self(0x6e67_6969);
}

/// A pointer from C to what a function reads. It may be NULL or unaligned. If it is neither, C
/// promises that it points to a value, which does not change during the call.
pub(crate) struct Input<T>(pub(crate) *const T);

/// A pointer from C to what a function writes. It may be NULL or unaligned. If it is neither, C
/// promises that it points to memory for a value, which only the arguments refer to during the call.
pub(crate) struct Output<T>(pub(crate) *mut T);

/// Bytes of `count` values of `T`.
fn bytes<T>(count: usize) -> Result<usize, Status> {
    let bytes = count.checked_mul(size_of::<T>());
    bytes.filter(|&bytes| bytes <= isize::MAX.unsigned_abs()).ok_or(Status::Count)
}

/// Checks that a pointer may point to `count` values.
fn usable<T>(pointer: *const T, count: usize) -> Result<(), Status> {
    if pointer.is_null() {
        Err(Status::NullPointer)
    } else if !pointer.is_aligned() {
        Err(Status::Unaligned)
    } else {
        bytes::<T>(count).map(drop)
    }
}

impl<T> Input<T> {
    /// The value.
    pub(crate) fn value(&self) -> Result<&T, Status> {
        usable(self.0, 1)?;
        // SAFETY: neither NULL nor unaligned, the rest is C's promise.
        Ok(unsafe { &*self.0 })
    }

    /// `N` numbers.
    ///
    /// # Safety
    ///
    /// C promises as many.
    pub(crate) unsafe fn numbers<const N: usize>(&self) -> Result<&[T; N], Status> {
        usable(self.0, N)?;
        // SAFETY: neither NULL nor unaligned, the rest is the caller's promise.
        Ok(unsafe { &*self.0.cast() })
    }

    /// An array of numbers. If `count` is 0, it is empty for any pointer.
    ///
    /// # Safety
    ///
    /// C promises as many numbers.
    pub(crate) unsafe fn array<'a>(&self, count: usize) -> Result<&'a [T], Status>
    where
        T: Plain,
    {
        if count == 0 {
            return Ok(&[]);
        }
        usable(self.0, count)?;
        // SAFETY: neither NULL nor unaligned, not beyond what an object may have, the rest is
        // the caller's promise.
        Ok(unsafe { core::slice::from_raw_parts(self.0, count) })
    }
}

impl<T: Plain> Output<T> {
    /// The memory, filled with zeros.
    ///
    /// # Safety
    ///
    /// It overlaps nothing that is in use: [`disjoint`] says so.
    pub(crate) unsafe fn zeroed<'a>(&self) -> Result<&'a mut T, Status> {
        usable(self.0, 1)?;
        // SAFETY: neither NULL nor unaligned, zeros are a `T`, the rest is the promise of C and of
        // the caller.
        Ok(unsafe {
            self.0.write_bytes(0, 1);
            &mut *self.0
        })
    }

    /// An array of numbers, as it is. If `count` is 0, it is empty for any pointer.
    ///
    /// # Safety
    ///
    /// C promises as many numbers. They overlap nothing that is in use.
    pub(crate) unsafe fn array<'a>(&self, count: usize) -> Result<&'a mut [T], Status> {
        if count == 0 {
            return Ok(&mut []);
        }
        usable(self.0, count)?;
        // SAFETY: neither NULL nor unaligned, not beyond what an object may have, the rest is the
        // caller's promise.
        Ok(unsafe { core::slice::from_raw_parts_mut(self.0, count) })
    }

    /// An array of numbers, filled with zeros. If `count` is 0, it is empty for any pointer.
    ///
    /// # Safety
    ///
    /// C promises memory for as many numbers. It overlaps nothing that is in use.
    pub(crate) unsafe fn zeroed_array<'a>(&self, count: usize) -> Result<&'a mut [T], Status> {
        if count > 0 {
            usable(self.0, count)?;
            // SAFETY: neither NULL nor unaligned, zeros are numbers, the rest is the caller's
            // promise.
            unsafe { self.0.write_bytes(0, count) };
        }
        // SAFETY: this function's caller promises as much.
        unsafe { self.array(count) }
    }

    /// Where the value lies.
    pub(crate) fn place(&self) -> Place {
        // NULL is rejected when the pointer is used.
        let bytes = if self.0.is_null() { 0 } else { size_of::<T>() };
        Place { start: self.0.addr(), bytes }
    }

    /// Where `count` numbers lie.
    pub(crate) fn place_of_array(&self, count: usize) -> Result<Place, Status> {
        let bytes = bytes::<T>(count)?;
        Ok(Place { bytes: if self.0.is_null() { 0 } else { bytes }, ..self.place() })
    }
}

/// The address range of an argument.
#[derive(Clone, Copy, Default)]
pub(crate) struct Place {
    start: usize,
    bytes: usize,
}

impl Place {
    /// The range of a value or an array.
    pub(crate) fn of<T: ?Sized>(value: &T) -> Self {
        Self { start: core::ptr::from_ref(value).addr(), bytes: size_of_val(value) }
    }

    fn overlaps(self, other: Self) -> bool {
        let (first, second) = if self.start < other.start { (self, other) } else { (other, self) };
        second.bytes > 0 && second.start - first.start < first.bytes
    }
}

/// Checks that the places that are written to overlap neither each other nor those that are read.
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
