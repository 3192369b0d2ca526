//! Parts of slices whose lengths were checked when a basis, a scene or an input was made.
//!
//! If a part is missing all the same, this crate has a defect. With debug assertions, as in tests
//! and under a fuzzer, that is a panic. Without, what is missing is empty, and counts as zero.

use core::slice::SliceIndex;

#[inline(always)]
#[track_caller]
pub(crate) fn part<T, R: SliceIndex<[T], Output = [T]>>(items: &[T], range: R) -> &[T] {
    let found = items.get(range);
    debug_assert!(found.is_some(), "a part is beyond {} items", items.len());
    found.unwrap_or_default()
}

#[inline(always)]
#[track_caller]
pub(crate) fn part_mut<T, R: SliceIndex<[T], Output = [T]>>(items: &mut [T], range: R) -> &mut [T] {
    let found = items.get_mut(range);
    debug_assert!(found.is_some(), "a part is beyond them");
    found.unwrap_or_default()
}

#[inline(always)]
#[track_caller]
pub(crate) fn split<T>(items: &[T], first: usize) -> (&[T], &[T]) {
    let found = items.split_at_checked(first);
    debug_assert!(found.is_some(), "{first} of {} items", items.len());
    found.unwrap_or_default()
}

#[inline(always)]
#[track_caller]
pub(crate) fn split_mut<T>(items: &mut [T], first: usize) -> (&mut [T], &mut [T]) {
    let found = items.split_at_mut_checked(first);
    debug_assert!(found.is_some(), "the first {first} items are beyond their slice");
    found.unwrap_or_default()
}

/// The first items and the others; where they are missing, as many as there are. Loops over rows
/// compile to fewer instructions with it than with [`split`].
#[inline(always)]
#[track_caller]
pub(crate) fn split_row<T>(items: &[T], length: usize) -> (&[T], &[T]) {
    let found = items.split_at_checked(length);
    debug_assert!(found.is_some(), "a row of {length} of {} items", items.len());
    found.unwrap_or((items, &[]))
}
