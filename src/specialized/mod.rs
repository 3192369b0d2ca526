//! Kernels for tables that are known when the program is compiled: `table!` calls them, once for
//! each part of the work.
//!
//! The kernels are the steps of [`Basis::project`](crate::Basis::project),
//! [`Basis::relight`](crate::Basis::relight), [`Basis::collapse`](crate::Basis::collapse) and
//! [`Scene::shade`](crate::Scene::shade), with constants for all sizes and positions.

pub mod project;

mod scene;
mod table;

pub use scene::{azimuth, blank_scene, collapse, pole, terms, terms_mut};

/// Relighting, part by part.
pub mod relight {
    pub use crate::relight::{GROUPS, run, sums, write};
}

pub use crate::index::{layout, material, pair, record};
pub use crate::shade::Block;

use crate::error::{Argument, Error};
use crate::index::record::{NONE, ProfilePlace};
use crate::light::Light;
use crate::material::Material;
use crate::normal::{Normal, Normals};
use crate::projection::Coefficients;
use crate::transfer::Transfer;

/// Shades normals one by one.
///
/// # Errors
///
/// [`Error::Length`] unless `irradiance` and `normals` have the same length.
#[inline(always)]
pub fn shade_each<N: Copy, I>(
    normals: &[N],
    irradiance: &mut [I],
    shade: impl Fn(N) -> I,
) -> Result<(), Error> {
    Error::check(Argument::Normals, normals.len(), irradiance.len())?;
    for (irradiance, &normal) in irradiance.iter_mut().zip(normals) {
        *irradiance = shade(normal);
    }
    Ok(())
}

/// Whether [`shade_normals`] is faster than [`Rgb::shade_slice`](crate::Rgb::shade_slice): the target
/// has no vectors.
pub const ONE_BY_ONE: bool = crate::shade::ONE_BY_ONE;

/// [`shade_each`] of normals in three slices; the same errors.
#[inline(always)]
pub fn shade_normals<I>(
    normals: Normals<'_>,
    irradiance: &mut [I],
    shade: impl Fn(Normal) -> I,
) -> Result<(), Error> {
    Error::check(Argument::Normals, normals.len(), irradiance.len())?;
    let axes = normals.x.iter().zip(normals.y).zip(normals.z);
    for (irradiance, ((&x, &y), &z)) in irradiance.iter_mut().zip(axes) {
        *irradiance = shade(Normal { x, y, z });
    }
    Ok(())
}

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

/// Whether a table of this degree takes a light.
///
/// # Errors
///
/// [`Error::Beyond`].
#[inline(always)]
pub fn accept_light(degree: usize, light: &Light<'_>) -> Result<(), Error> {
    Error::check_beyond(Argument::Light, degree, light.degree())
}

/// Whether a table of this order takes a material.
///
/// # Errors
///
/// [`Error::Beyond`].
#[inline(always)]
pub fn accept_material(order: usize, material: &Material<'_>) -> Result<(), Error> {
    Error::check_beyond(Argument::Material, order, material.order())
}

/// The numbers of a transfer.
///
/// # Errors
///
/// [`Error::Length`] if there are fewer, as in a transfer of another table.
#[inline(always)]
pub fn transfer<const N: usize>(transfer: &Transfer<N>) -> Result<&[f32; N], Error> {
    let (argument, found) = (Argument::Transfer, transfer.as_slice().len());
    let length = Error::Length { argument, expected: N, found };
    transfer.as_slice().try_into().map_err(|_| length)
}

/// The coefficients of an image, to be written.
///
/// # Errors
///
/// None: a buffer holds as many as its capacity.
#[inline(always)]
pub fn coefficients<const N: usize>(
    coefficients: &mut Coefficients<N>,
) -> Result<&mut [f32; N], Error> {
    let (argument, needed, capacity) = (Argument::Coefficients, N, N);
    coefficients.filled().ok_or(Error::Capacity { argument, needed, capacity })
}
