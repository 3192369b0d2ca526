//! Computes the irradiance of many normals from a light and a material, in f32.

use crate::owned_basis::OwnedTransfer;
use eigenshade::{Basis, Light, Material, Normal, Normals, Scene};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::overflow;
use eigenshade_model::reference::{light_products, material_products};
use eigenshade_table::Table;
use eigenshade_table::effect::Effects;
use eigenshade_table::layout::{MAX_DEGREE, MAX_ORDER};
use eigenshade_table::reduce::fingerprint;
use std::path::Path;

/// Truncates lights and materials to a table's degree and order. For a table without color it also
/// reduces them to their luminance.
#[must_use]
pub fn fitted(table: &Table, lights: &Lights, materials: &Materials) -> (Lights, Materials) {
    let (mut lights, mut materials) =
        (lights.truncated(table.gram.degree), materials.truncated(table.gram.order));
    if !table.scene.effects.color {
        lights.entries.iter_mut().chain(&mut materials.entries).for_each(Named::remove_color);
    }
    (lights, materials)
}

/// The warning for a material file, or the name of a shipped material, of a higher order than the
/// table; `None` if the order is not higher.
#[must_use]
pub fn of_higher_order(
    (path, is_shipped): (&Path, bool),
    found: usize,
    order: usize,
) -> Option<String> {
    (found > order).then(|| {
        let (unless, again) = if is_shipped {
            ("", String::new())
        } else {
            let again =
                format!("create them again with `eigenshade material --order {order}`, or ");
            (" unless made with --measure solid-angle", again)
        };
        format!(
            "warning: {}: its materials have order {found}, the table order {order}: higher \
             coefficients are ignored, and the rest are not the projection to order \
             {order}{unless}; {again}use a table of order {found}",
            path.display()
        )
    })
}

/// One channel of a light and one channel of a material.
pub type Lit<'a> = (&'a [f64], &'a [f64]);

/// A basis with its work buffers.
#[derive(Clone, Debug)]
pub struct Shader<'a> {
    pub(crate) basis: Basis<'a>,
    pub(crate) components: usize,
    pub(crate) workspace: Vec<f32>,
    coefficients: Vec<f32>,
    scene: Vec<f32>,
    transfers: &'a [OwnedTransfer],
    effects: Effects,
}

/// Normals as one array per component, in f32.
#[derive(Clone, Debug)]
pub struct OwnedNormals([Vec<f32>; 3]);

impl OwnedNormals {
    /// Rounds unit normals with z >= 0 to f32.
    #[must_use]
    pub fn new(normals: &[[f64; 3]]) -> Self {
        Self([0, 1, 2].map(|axis| normals.iter().map(|n| n[axis] as f32).collect()))
    }

    /// The normals, for [`Scene::shade_slice`].
    ///
    /// # Errors
    ///
    /// Cannot fail in practice, because the three arrays have the same length.
    pub fn view(&self) -> Result<Normals<'_>> {
        let [x, y, z] = &self.0;
        Normals::from_unit(x, y, z).map_err(fault)
    }

    /// The normals one by one.
    ///
    /// # Errors
    ///
    /// If one is not a visible normal.
    pub fn each(&self) -> Result<Vec<Normal>> {
        let [x, y, z] = &self.0;
        let triples = x.iter().zip(y).zip(z);
        triples.map(|((&x, &y), &z)| Normal::new(x, y, z).map_err(fault)).collect()
    }
}

impl<'a> Shader<'a> {
    /// A shader that uses the first `components` of the basis.
    #[must_use]
    pub fn new(basis: Basis<'a>, components: usize) -> Self {
        let all = basis.components();
        Self {
            components: components.min(all),
            workspace: vec![0.0; basis.workspace_len()],
            coefficients: vec![0.0; all],
            scene: vec![0.0; basis.scene_len()],
            basis,
            transfers: &[],
            effects: Effects::ALL,
        }
    }

    /// Restricts the shader to some effects.
    ///
    /// # Errors
    ///
    /// If the basis has transfers and some effects are left out: transfers contain all of them.
    pub fn with_effects(self, effects: Effects) -> Result<Self> {
        if !effects.is_all() && !self.basis.projects() {
            let what = "the table has transfers, which contain all its effects";
            let remedy = "leave --effects out, or make a table with store = \"projection\"";
            return Err(Error::new(what, remedy));
        }
        Ok(Self { effects, ..self })
    }

    /// Adds the stored transfers of a table. A basis without projection accepts only these
    /// materials.
    #[must_use]
    pub fn with_transfers(self, transfers: &'a [OwnedTransfer]) -> Self {
        Self { transfers, ..self }
    }

    /// d for one channel of a light and one channel of a material, of at most the basis's degree
    /// and order.
    ///
    /// # Errors
    ///
    /// If the coefficients do not have the number of a degree and of an order, or exceed the
    /// basis's; if a basis of transfers does not have the material; or if d is not finite.
    pub fn project(&mut self, light: &[f64], material: &[f64]) -> Result<&[f32]> {
        self.projected(light, material)?;
        overflow::check(&self.coefficients, light, material)?;
        Ok(&self.coefficients[..self.components])
    }

    fn projected(&mut self, light: &[f64], material: &[f64]) -> Result<()> {
        if !self.basis.projects() {
            let fingerprint = fingerprint(material);
            let of = self.transfers.iter().find(|one| one.fingerprint == fingerprint);
            let of = of.ok_or_else(|| {
                let what = "the table has transfers only for its scene's materials, and a material \
                            is not one of them";
                let remedy =
                    "use the scene's material file, or make a table with store = \"projection\"";
                Error::new(what, remedy)
            })?;
            let light = rounded(light);
            let light = Light::from_finite(&light).map_err(fault)?;
            let coefficients = &mut self.coefficients;
            return self.basis.relight_into(&of.transfer, &light, coefficients).map_err(fault);
        }
        let degree = Light::from_finite(&rounded(light)).map_err(fault)?.degree();
        let order = Material::from_finite(&rounded(material)).map_err(fault)?.order();
        let lights = light_products(degree, light, self.effects);
        let materials = material_products(order, material, self.effects);
        let mut sums = vec![0.0; self.coefficients.len()];
        for (light, material) in lights.iter().zip(&materials) {
            let (light, material) = (rounded(light), rounded(material));
            let light = Light::from_finite(&light).map_err(fault)?;
            let material = Material::from_finite(&material).map_err(fault)?;
            let (workspace, coefficients) = (&mut self.workspace, &mut self.coefficients);
            self.basis.project_into(&light, &material, workspace, coefficients).map_err(fault)?;
            sums.iter_mut().zip(coefficients).for_each(|(sum, d)| *sum += *d);
        }
        self.coefficients = sums;
        Ok(())
    }

    /// The collapsed image of the last projection.
    ///
    /// # Errors
    ///
    /// Cannot fail in practice, because the buffers have the lengths that the basis requires.
    pub fn scene(&mut self) -> Result<Scene<'a, &mut Vec<f32>>> {
        let coefficients = &self.coefficients[..self.components];
        self.basis.collapse_into(coefficients, &mut self.scene).map_err(fault)
    }

    /// One channel of the image, from the collapsed polynomials.
    ///
    /// # Errors
    ///
    /// As [`project`](Self::project), and if an irradiance is not finite.
    pub fn polynomial(
        &mut self,
        light: &[f64],
        material: &[f64],
        normals: &OwnedNormals,
    ) -> Result<Vec<f32>> {
        self.project(light, material)?;
        let normals = normals.view()?;
        let mut irradiance = vec![0.0; normals.len()];
        self.scene()?.shade_slice(normals, &mut irradiance).map_err(fault)?;
        overflow::check(&irradiance, light, material)?;
        Ok(irradiance)
    }

    /// All three channels of the image, from the collapsed polynomials.
    ///
    /// # Errors
    ///
    /// See [`project`](Self::project).
    pub fn color(
        &mut self,
        light: &Named,
        material: &Named,
        normals: &OwnedNormals,
    ) -> Result<[Vec<f32>; 3]> {
        let mut channel = |c: usize| {
            self.polynomial(&light.rgb[c], &material.rgb[c], normals)
                .map_err(|error| error.of(overflow::pair(light, material)))
        };
        Ok([channel(0)?, channel(1)?, channel(2)?])
    }
}

fn rounded(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

/// Converts an error of the runtime about its inputs.
#[must_use]
pub fn fault(error: eigenshade::Error) -> Error {
    if let eigenshade::Error::High { degree, order } = error {
        return beyond(degree, order);
    }
    Error::new(error.to_string(), "check the inputs against `eigenshade info` of the table")
}

/// The error for a table that only f64 draws.
pub(crate) fn beyond(degree: usize, order: usize) -> Error {
    let what = format!(
        "the table has degree {degree} and order {order}; f32 and q15 go to {MAX_DEGREE} and \
         {MAX_ORDER}"
    );
    Error::new(what, "use --format f64, or a smaller table with --sources")
}
