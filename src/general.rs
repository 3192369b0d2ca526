//! The eigenbasis of arbitrary normals, whose eigenimages are sums over several azimuths.
//!
//! Each eigenimage is a sum of the functions of a span, which is itself a [`Basis`]. The
//! coordinates a of an image in the span give its coefficients d = P a, and coefficients d give the
//! image with coordinates Σ d_i a_i. Everything else works as for the sphere: a pixel of the
//! collapsed scene costs the same.

use crate::basis::Basis;
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::split_mut;
use crate::error::{Argument, Error};
use crate::float;
use crate::index::record::floats;
use crate::light::Light;
use crate::material::Material;
use crate::normal::Normal;
use crate::projection::buffered;
use crate::relight::Coefficients;
use crate::scene::Scene;
use crate::transfer::Transfer;

/// The arrays of a general basis: [`GeneralBasis::new`] checks that they are consistent.
pub type GeneralParts<'a> = floats::GeneralParts<'a, f32>;

/// An eigenbasis of arbitrary normals.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GeneralBasis<'a> {
    span: Basis<'a>,
    parts: GeneralParts<'a>,
}

impl<'a> GeneralBasis<'a> {
    /// Creates a basis from a span and these parts. The components of the span are its functions.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if a part does not have the length that the others require.
    pub const fn new(span: Basis<'a>, parts: GeneralParts<'a>) -> Result<Self, Error> {
        let functions = span.components();
        let length = functions.saturating_mul(parts.components);
        let checked = Error::first(&[
            Error::check(Argument::Projection, length, parts.projection.len()),
            Error::check(Argument::Synthesis, length, parts.synthesis.len()),
        ]);
        match checked {
            Ok(()) => Ok(Self { span, parts }),
            Err(error) => Err(error),
        }
    }

    /// The parts of this basis, without the span.
    #[must_use]
    pub const fn parts(&self) -> &GeneralParts<'a> {
        &self.parts
    }

    /// The span.
    #[must_use]
    pub const fn span(&self) -> &Basis<'a> {
        &self.span
    }

    /// Number of eigenimages K.
    #[must_use]
    pub const fn components(&self) -> usize {
        self.parts.components
    }

    /// Length of the workspace that [`project`](Self::project) and [`collapse`](Self::collapse)
    /// need: the span's workspace, and the coordinates of an image in the span.
    #[must_use]
    pub const fn workspace_len(&self) -> usize {
        self.span.workspace_len() + self.span.components()
    }
}

impl<'a> GeneralBasis<'a> {
    /// The coefficients d of a light on a material, as [`Basis::project`], with one more
    /// multiplication for each pair of an eigenimage and a function of the span; the same errors.
    ///
    /// `N` must be at least [`workspace_len`](Self::workspace_len), `K` at least
    /// [`components`](Self::components).
    pub fn project<const N: usize, const K: usize>(
        &self,
        light: &Light<'_>,
        material: &Material<'_>,
    ) -> Result<Coefficients<K>, Error> {
        buffered::<N, K>(self.workspace_len(), self.components(), |workspace, d| {
            self.project_into(light, material, workspace, d)
        })
    }

    /// [`project`](Self::project) with slices; errors as [`Basis::project_into`].
    pub fn project_into(
        &self,
        light: &Light<'_>,
        material: &Material<'_>,
        workspace: &mut [f32],
        coefficients: &mut [f32],
    ) -> Result<(), Error> {
        Error::check(Argument::Workspace, self.workspace_len(), workspace.len())?;
        let (workspace, coordinates) = split_mut(workspace, self.span.workspace_len());
        self.span.project_into(light, material, workspace, coordinates)?;
        self.coefficients(coordinates, coefficients)
    }

    /// The coefficients d of a new light on a material whose transfer the span's
    /// [`transfer_into`](Basis::transfer_into) computed. `workspace` has the same length as for
    /// [`project_into`](Self::project_into).
    ///
    /// # Errors
    ///
    /// The same as for [`Basis::relight_into`], and [`Error::Length`] for a `workspace` of another
    /// length.
    pub fn relight_into(
        &self,
        transfer: &[f32],
        light: &Light<'_>,
        workspace: &mut [f32],
        coefficients: &mut [f32],
    ) -> Result<(), Error> {
        Error::check(Argument::Workspace, self.workspace_len(), workspace.len())?;
        let (_, coordinates) = split_mut(workspace, self.span.workspace_len());
        self.span.relight_into(transfer, light, coordinates)?;
        self.coefficients(coordinates, coefficients)
    }

    /// [`relight_into`](Self::relight_into) with buffers of fixed capacity.
    ///
    /// # Errors
    ///
    /// The same as for `relight_into`; [`Error::Capacity`] if `N` or `K` is too small.
    pub fn relight<const T: usize, const N: usize, const K: usize>(
        &self,
        transfer: &Transfer<T>,
        light: &Light<'_>,
    ) -> Result<Coefficients<K>, Error> {
        buffered::<N, K>(self.workspace_len(), self.components(), |workspace, d| {
            self.relight_into(transfer.as_slice(), light, workspace, d)
        })
    }

    /// The coefficients d from coordinates in the span.
    fn coefficients(&self, coordinates: &[f32], coefficients: &mut [f32]) -> Result<(), Error> {
        Error::check(Argument::Coefficients, self.components(), coefficients.len())?;
        let functions = self.span.components().max(1);
        let rows = self.parts.projection.chunks(functions);
        for (coefficient, row) in coefficients.iter_mut().zip(rows) {
            let products = row.iter().zip(coordinates);
            *coefficient = products.fold(0.0, |sum, (&p, &a)| float::add_product(sum, p, a));
        }
        Ok(())
    }

    /// Sums the eigenimages azimuth by azimuth, as [`Basis::collapse`] does, with the same errors.
    ///
    /// `N` must be at least [`workspace_len`](Self::workspace_len), `C` at least the span's
    /// [`scene_len`](Basis::scene_len).
    pub fn collapse<const N: usize, const C: usize>(
        &self,
        coefficients: &[f32],
    ) -> Result<Scene<'a, Buffer<f32, C>>, Error> {
        let mut workspace = zeros::<f32, N>(Argument::Workspace, self.workspace_len())?;
        let scene = zeros::<f32, C>(Argument::Scene, self.span.scene_len())?;
        self.collapse_into(coefficients, &mut workspace, scene)
    }

    /// [`collapse`](Self::collapse) into buffers of your own.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than eigenimages, or if a buffer has
    /// another length.
    pub fn collapse_into<B: AsMut<[f32]>>(
        &self,
        coefficients: &[f32],
        workspace: &mut [f32],
        buffer: B,
    ) -> Result<Scene<'a, B>, Error> {
        let coordinates = self.coordinates(coefficients, workspace)?;
        self.span.collapse_into(coordinates, buffer)
    }

    /// The irradiance of one normal without collapsing, as [`Basis::reconstruct`]; errors as
    /// [`collapse_into`](Self::collapse_into).
    pub fn reconstruct(
        &self,
        coefficients: &[f32],
        normal: Normal,
        workspace: &mut [f32],
    ) -> Result<f32, Error> {
        let coordinates = self.coordinates(coefficients, workspace)?;
        self.span.reconstruct(coordinates, normal)
    }

    /// Writes the coordinates of an image in the span to the workspace and returns them.
    fn coordinates<'w>(
        &self,
        coefficients: &[f32],
        workspace: &'w mut [f32],
    ) -> Result<&'w [f32], Error> {
        Error::check(Argument::Workspace, self.workspace_len(), workspace.len())?;
        Error::check_components(self.components(), coefficients.len())?;
        let (_, coordinates) = split_mut(workspace, self.span.workspace_len());
        coordinates.fill(0.0);
        let rows = self.parts.synthesis.chunks(self.span.components().max(1));
        for (&coefficient, row) in coefficients.iter().zip(rows) {
            for (coordinate, &part) in coordinates.iter_mut().zip(row) {
                *coordinate = float::add_product(*coordinate, coefficient, part);
            }
        }
        Ok(coordinates)
    }
}
