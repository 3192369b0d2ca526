//! Memory that the page shares.

use core::cell::UnsafeCell;

/// A place in linear memory that the page reads and writes between calls, 16 bytes
/// aligned.
#[repr(C, align(16))]
pub struct Shared<T>(UnsafeCell<T>);

// SAFETY: this module has no shared memory, so an instance runs on one thread.
unsafe impl<T> Sync for Shared<T> {}

impl<T> Shared<T> {
    /// A place with this in it.
    pub const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// What is in it.
    ///
    /// # Safety
    ///
    /// Nothing else borrows it: each exported function borrows a place once, and none
    /// calls another or the page.
    #[expect(clippy::mut_from_ref, reason = "that it is the only borrow is the caller's word")]
    pub unsafe fn borrow(&self) -> &mut T {
        // SAFETY: the caller's.
        unsafe { &mut *self.0.get() }
    }
}
