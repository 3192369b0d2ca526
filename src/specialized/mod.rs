//! Kernels for tables that are known when the program is compiled: `table!` calls them, once for
//! each part of the work.
//!
//! They compute the same as [`Basis::project`](crate::Basis::project),
//! [`Basis::relight`](crate::Basis::relight), [`Basis::collapse`](crate::Basis::collapse) and
//! [`Scene::shade`](crate::Scene::shade), with constants for all sizes and indices. If an argument
//! does not have the expected shape, the general functions are called instead.

pub mod project;

mod scene;
mod table;

pub use scene::{azimuth, blank_scene, collapse, pole, terms, terms_mut};

/// Relighting, part by part.
pub mod relight {
    pub use crate::relight::{GROUPS, inputs, run, sums, write};
}

pub use crate::index::{layout, material, pair, record};
pub use crate::places::KnownTable;

use crate::error::{Argument, Error};
use crate::normal::{Normal, Normals};

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

/// The basis of a table, or of a general one its span.
///
/// # Panics
///
/// If the parts contradict each other; for a static that is an error of compilation.
#[must_use]
#[expect(clippy::panic, reason = "while the program is compiled")]
pub const fn checked<B: Copy>(basis: Result<B, Error>) -> B {
    match basis {
        Ok(basis) => basis,
        Err(_) => panic!("the table's parts do not fit together"),
    }
}

/// Subtracts the coefficients of the mean image from those of an image.
#[inline(always)]
pub fn subtract(coefficients: &mut [f32], mean: &[f32]) {
    for (coefficient, &mean) in coefficients.iter_mut().zip(mean) {
        *coefficient -= mean;
    }
}
