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

/// The rest of a slice, padded with zeros to a block.
pub(crate) fn padded<const N: usize>(rest: &[f32]) -> [f32; N] {
    let mut block = [0.0; N];
    for (to, &from) in block.iter_mut().zip(rest) {
        *to = from;
    }
    block
}

/// Rows of `width` numbers, without what is left over at the end; none if `width` is 0. A loop over
/// them compiles without a path to a panic: the standard library's chunk iterators reject a length
/// of 0, and divide by the length when zipped.
pub(crate) fn rows<T>(numbers: &[T], width: usize) -> impl Iterator<Item = &[T]> {
    let mut rest = if width > 0 { numbers } else { &[] };
    core::iter::from_fn(move || {
        let (row, after) = rest.split_at_checked(width.max(1))?;
        rest = after;
        Some(row)
    })
}

/// [`rows`] to be written.
pub(crate) fn rows_mut<T>(numbers: &mut [T], width: usize) -> impl Iterator<Item = &mut [T]> {
    let mut rest = if width > 0 { numbers } else { &mut [] };
    core::iter::from_fn(move || {
        let (row, after) = core::mem::take(&mut rest).split_at_mut_checked(width.max(1))?;
        rest = after;
        Some(row)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_whole() {
        let mut numbers = [1, 2, 3, 4, 5];
        assert!(rows(&numbers, 2).eq([[1, 2], [3, 4]]));
        rows_mut(&mut numbers, 2).for_each(<[i32]>::reverse);
        assert_eq!(numbers, [2, 1, 4, 3, 5]);
        for width in [0, 6] {
            assert!(
                rows(&numbers, width).next().is_none()
                    && rows_mut(&mut numbers, width).next().is_none()
            );
        }
    }
}
