//! Splits slices into rows of equal length, with loops that compile without a path to a panic. The
//! standard library's chunk iterators reject a length of 0, and divide by the length when zipped.

/// Consecutive rows of `width` numbers. Numbers left over at the end are skipped; there are no rows
/// if `width` is 0.
pub(crate) fn rows<T>(numbers: &[T], width: usize) -> impl Iterator<Item = &[T]> {
    let mut rest = if width > 0 { numbers } else { &[] };
    core::iter::from_fn(move || {
        let (row, after) = rest.split_at_checked(width.max(1))?;
        rest = after;
        Some(row)
    })
}

/// Mutable [`rows`].
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
