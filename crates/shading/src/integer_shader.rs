//! Computes the irradiance of many normals from a light and a material, in an integer format.

use crate::overflow;
use crate::owned_quantised::{Integer, OwnedQuantised};
use crate::shader::fault;
use eigenshade::quantised::{Light, Material, Normal, Transfer};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::Table;
use eigenshade_table::quantize;

/// An integer basis with its work buffers.
#[derive(Clone, Debug)]
pub struct IntegerShader<Q: Integer> {
    basis: OwnedQuantised<Q>,
    components: usize,
    workspace: Vec<Q::Wide>,
    numbers: Vec<Q>,
    exponents: Vec<i16>,
    mantissas: Vec<i32>,
    exponent: i32,
    scene: Vec<i32>,
}

impl<Q: Integer> IntegerShader<Q> {
    /// A shader that uses the first `components` of a table.
    ///
    /// # Errors
    ///
    /// If the table has no integer form.
    pub fn new(table: &Table, components: usize) -> Result<Self> {
        let remedy = "take --format f32";
        let basis = OwnedQuantised::new(table, Q::FORMAT.tolerance())
            .map_err(|error| Error::new(error.to_string(), remedy))?;
        let view = basis.view().map_err(fault)?;
        Ok(Self {
            components: components.min(view.components()),
            workspace: vec![Default::default(); view.workspace_len()],
            numbers: vec![Q::default(); view.transfer_len()],
            exponents: vec![0; view.profiles()],
            mantissas: vec![0; view.components()],
            exponent: 0,
            scene: vec![0; view.scene_len()],
            basis,
        })
    }

    /// Number of polynomial terms in a scene.
    #[must_use]
    pub fn terms(&self) -> usize {
        self.scene.len()
    }

    /// d for one channel of a light and one channel of a material, of at most the table's degree
    /// and order.
    ///
    /// # Errors
    ///
    /// If the coefficients do not match their stated degree or order, exceed the table's degree or
    /// order, or are so large that they would saturate or so small that they would be lost.
    pub fn project(
        &mut self,
        (degree, light): (usize, &[f64]),
        (order, material): (usize, &[f64]),
    ) -> Result<Vec<f64>> {
        // Only these numbers can saturate: all later ones are scaled by their bounds.
        if ![light, material].iter().all(|numbers| quantize::holds(numbers, Q::FORMAT)) {
            return Err(overflow::fault(Q::FORMAT.name(), light, material));
        }
        overflow::lost(Q::FORMAT.name(), light, material)?;
        let basis = self.basis.view().map_err(fault)?;
        let (mantissas, exponents) = quantize::material(order, material, Q::FORMAT);
        let mantissas = owned(&mantissas);
        let material = Material::new(order, &exponents, &mantissas).map_err(fault)?;
        let (mantissas, exponent) = quantize::row(light, Q::FORMAT.bits(), i64::MAX);
        let mantissas: Vec<Q> = owned(&mantissas);
        let light = Light::new(degree, exponent.into(), &mantissas).map_err(fault)?;
        let (numbers, exponents) = (&mut self.numbers, &mut self.exponents);
        basis.fold_into(&material, &mut self.workspace, numbers, exponents).map_err(fault)?;
        let transfer = Transfer::new(numbers, exponents);
        self.exponent =
            basis.relight_into(&transfer, &light, &mut self.mantissas).map_err(fault)?;
        let used = self.mantissas.iter().take(self.components);
        Ok(used.map(|&mantissa| scaled(mantissa, self.exponent)).collect())
    }

    /// One channel of the image, from the collapsed polynomials.
    ///
    /// # Errors
    ///
    /// See [`project`](Self::project).
    pub fn polynomial(
        &mut self,
        light: (usize, &[f64]),
        material: (usize, &[f64]),
        normals: &[Normal<Q>],
    ) -> Result<Vec<f64>> {
        self.project(light, material)?;
        let basis = self.basis.view().map_err(fault)?;
        let used = self.mantissas.get(..self.components).unwrap_or(&self.mantissas);
        let scene = basis.collapse_into(used, self.exponent, &mut self.scene).map_err(fault)?;
        if let Some(formula) = scene.nine_terms() {
            let one = |normal: &Normal<Q>| scaled(formula.shade(*normal), formula.exponent());
            return Ok(normals.iter().map(one).collect());
        }
        let one = |normal: &Normal<Q>| scaled(scene.shade(*normal), scene.exponent());
        Ok(normals.iter().map(one).collect())
    }
}

/// Rounds unit normals with z >= 0 to the format.
///
/// # Errors
///
/// If one is not a visible unit vector.
pub fn normals<Q: Integer>(normals: &[[f64; 3]]) -> Result<Vec<Normal<Q>>> {
    normals.iter().map(|normal| Q::normal(*normal).map_err(fault)).collect()
}

fn owned<Q: Integer>(mantissas: &[i32]) -> Vec<Q> {
    mantissas.iter().map(|&mantissa| Q::of(mantissa)).collect()
}

fn scaled(mantissa: i32, exponent: i32) -> f64 {
    f64::from(mantissa) * 2f64.powi(exponent)
}
