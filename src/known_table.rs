//! Tables that are known when the program is compiled: their parts as constants.

use crate::error::Error;
use crate::index::record::{NONE, ProfilePlace};

/// A constant of a table or of the presets.
///
/// # Panics
///
/// If it is invalid; for a static that is an error of compilation.
#[must_use]
#[expect(clippy::panic, reason = "while the program is compiled")]
pub const fn checked<B: Copy>(basis: Result<B, Error>) -> B {
    match basis {
        Ok(basis) => basis,
        Err(_) => panic!("invalid numbers of a table or a preset"),
    }
}

/// A table that is known when the program is compiled, with a basis of type `B`.
pub trait KnownTable<B: 'static> {
    /// The basis.
    const BASIS: &'static B;
}

/// One of the items of a table.
#[expect(clippy::panic, reason = "while the program is compiled")]
pub(crate) const fn at<T>(items: &[T], position: usize) -> &T {
    match items.split_at_checked(position) {
        Some((_, [item, ..])) => item,
        _ => panic!("the table has fewer items"),
    }
}

/// The items of a table from one position on; none if there are fewer.
#[inline(always)]
pub(crate) const fn tail<T>(items: &[T], position: usize) -> &[T] {
    match items.split_at_checked(position) {
        Some((_, rest)) => rest,
        None => &[],
    }
}

/// The components of +m and of -m of `count` profiles, at most `N`. Constants are copied out of a
/// table: a compiler may not see what is in it.
pub(crate) const fn components<const N: usize>(
    profiles: &[ProfilePlace],
    first: usize,
    count: usize,
) -> [[u16; 2]; N] {
    let mut components = [[NONE; 2]; N];
    let (mut to, mut number) = (components.as_mut_slice(), 0);
    while let [of_profile, others @ ..] = to
        && number < count
    {
        *of_profile = at(profiles, first + number).components();
        (to, number) = (others, number + 1);
    }
    components
}

/// The first items of a table.
#[expect(clippy::panic, reason = "while the program is compiled")]
pub(crate) const fn head<T, const N: usize>(items: &[T]) -> &[T; N] {
    match items.first_chunk() {
        Some(items) => items,
        None => panic!("the table has fewer items"),
    }
}

/// Calls `with` with `N` numbers: these, and zeros if there are fewer.
#[inline(always)]
pub fn whole<S: Copy + Default, const N: usize>(numbers: &[S], with: impl FnOnce(&[S; N])) {
    match numbers.try_into() {
        Ok(whole) => with(whole),
        Err(_) => filled(numbers, with),
    }
}

/// [`whole`] of fewer numbers. Apart, so that their copy costs nothing where there is none.
#[cold]
#[inline(never)]
fn filled<S: Copy + Default, const N: usize>(numbers: &[S], with: impl FnOnce(&[S; N])) {
    let mut room = [S::default(); N];
    for (to, &from) in room.iter_mut().zip(numbers) {
        *to = from;
    }
    with(&room);
}
