//! Buffers in linear memory, and their sizes.

use crate::table::{COMPONENTS, DEGREE, ORDER};
use core::cell::UnsafeCell;
use eigenshade_table as index;

/// A buffer in linear memory that the page reads and writes between calls, aligned to 16 bytes.
#[repr(C, align(16))]
pub struct Shared<T>(UnsafeCell<T>);

// SAFETY: this module has no shared memory, so an instance runs on one thread.
unsafe impl<T> Sync for Shared<T> {}

impl<T> Shared<T> {
    /// A buffer with this value.
    pub const fn new(value: T) -> Self {
        Self(UnsafeCell::new(value))
    }

    /// Borrows the value.
    ///
    /// # Safety
    ///
    /// There may be no other borrow: each exported function borrows a buffer once, and none calls
    /// another one or the page.
    #[expect(clippy::mut_from_ref, reason = "the caller promises that there is no other borrow")]
    pub unsafe fn borrow(&self) -> &mut T {
        // SAFETY: as this function asks of its caller.
        unsafe { &mut *self.0.get() }
    }
}

/// Number of coefficients of the largest light.
pub const LIGHT_COUNT: usize = index::light::count(DEGREE);
/// Number of coefficients of the largest material.
pub const MATERIAL_COUNT: usize = index::material::count(ORDER);
/// Maximum number of normals in a call.
pub const NORMALS: usize = 1024;
/// Degree, order, number of components, and maximum number of normals in a call.
#[unsafe(export_name = "shape")]
pub static SHAPE: [u32; 4] = [DEGREE as u32, ORDER as u32, COMPONENTS as u32, NORMALS as u32];
