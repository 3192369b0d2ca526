//! Memory of C for values that consist of numbers, with a mark once one was written.
#![expect(unsafe_code, reason = "memory of C")]

use crate::boundary::{Input, Mark, Output, Plain};
use crate::status::Status;
use core::borrow::Borrow;
use eigenshade::screen::LinearPalette;

/// The contents of such memory.
#[repr(C)]
pub(crate) struct Marked<T> {
    state: Mark,
    value: T,
}

impl Borrow<LinearPalette> for Marked<LinearPalette> {
    fn borrow(&self) -> &LinearPalette {
        &self.value
    }
}

/// Memory for a value that consists of numbers.
pub(crate) trait Memory: Plain {
    type Value;
    const MARK: Mark;
    const MISSING: Status;
}

/// Checks that the memory has the size and the alignment of its contents.
pub(crate) const fn assert_fits<M: Memory>() {
    assert!(size_of::<M>() == size_of::<Marked<M::Value>>());
    assert!(align_of::<M>() == align_of::<Marked<M::Value>>());
}

/// The value in this memory, unless none was written.
pub(crate) fn written<M: Memory>(memory: &Input<M>) -> Result<&M::Value, Status> {
    let memory = core::ptr::from_ref(memory.value()?).cast::<Marked<M::Value>>();
    // SAFETY: the memory has the size and the alignment of this, and any bytes are valid.
    let Marked { state, value } = unsafe { &*memory };
    if *state == M::MARK { Ok(value) } else { Err(M::MISSING) }
}

/// The values in an array of such memory, unless one was not written.
///
/// # Safety
///
/// C promises as many.
pub(crate) unsafe fn all_written<'a, M: Memory>(
    memory: &Input<M>,
    count: usize,
) -> Result<&'a [Marked<M::Value>], Status> {
    // SAFETY: this function's caller promises as much.
    let memory = unsafe { memory.array(count) }?.as_ptr().cast::<Marked<M::Value>>();
    // SAFETY: the pointer was checked; the rest is as in `written`.
    let all = unsafe { core::slice::from_raw_parts(memory, count) };
    if all.iter().all(|one| one.state == M::MARK) { Ok(all) } else { Err(M::MISSING) }
}

/// Writes the value in this memory, from zeros if none was written.
///
/// # Safety
///
/// The memory overlaps nothing that is in use.
pub(crate) unsafe fn write<M: Memory>(
    memory: &Output<M>,
    write: impl FnOnce(&mut M::Value),
) -> Result<(), Status> {
    if written(&Input(memory.0.cast_const())).is_err() {
        // SAFETY: this function's caller promises as much.
        unsafe { memory.zeroed() }?;
    }
    let write = |value: &mut _| {
        write(value);
        Ok(())
    };
    // SAFETY: this function's caller promises as much.
    unsafe { try_write(memory, write) }
}

/// Writes the value in this memory by a function that may fail, from any bytes if none was written.
///
/// # Safety
///
/// The memory overlaps nothing that is in use.
pub(crate) unsafe fn try_write<M: Memory>(
    memory: &Output<M>,
    write: impl FnOnce(&mut M::Value) -> Result<(), Status>,
) -> Result<(), Status> {
    Input(memory.0.cast_const()).value()?;
    let memory = memory.0.cast::<Marked<M::Value>>();
    // SAFETY: the pointer was checked; the rest is as in `written`.
    let Marked { state, value } = unsafe { &mut *memory };
    write(value)?;
    *state = M::MARK;
    Ok(())
}
