//! Computes the irradiance of many normals from a light and a material, in integers.
//!
//! An [`OwnedQuantized`] is a table read at run time as a runtime basis; an [`IntegerShader`] adds
//! work buffers.

use crate::shader::{beyond, fault};
use eigenshade::Q15;
use eigenshade::q15::{Basis, Light, Material, Normal, Transfer};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::overflow;
use eigenshade_table::quantize::{self, TOLERANCE};
use eigenshade_table::record::integers::OwnedParts;
use eigenshade_table::{FormatError, Table};

/// The nearest representable normal.
///
/// # Errors
///
/// If the vector is not a visible unit vector.
pub fn normal(components: [f64; 3]) -> std::result::Result<Normal, eigenshade::Error> {
    let [x, y, z] = components.map(nearest);
    Normal::from_unit(x, y, z)
}

/// The nearest multiple of 2^-15; 1 becomes the largest mantissa.
fn nearest(component: f64) -> Q15 {
    Q15((32_768.0 * component).round().clamp(-32_767.0, 32_767.0) as i16)
}

/// The owned arrays of an integer basis.
#[derive(Clone, Debug)]
pub struct OwnedQuantized {
    parts: OwnedParts<Q15>,
}

impl OwnedQuantized {
    /// Converts a table to integers and trims its polynomials to `tolerance`.
    ///
    /// # Errors
    ///
    /// If the table has no integer form.
    pub fn new(table: &Table, tolerance: f64) -> std::result::Result<Self, FormatError> {
        Ok(Self { parts: quantize::integers(table, tolerance)? })
    }

    /// The basis.
    ///
    /// # Errors
    ///
    /// Cannot fail in practice, because the parts of a table are consistent.
    pub fn view(&self) -> std::result::Result<Basis<'_>, eigenshade::Error> {
        Basis::new(self.parts.borrow())
    }
}

/// An integer basis with its work buffers.
#[derive(Clone, Debug)]
pub struct IntegerShader {
    basis: OwnedQuantized,
    components: usize,
    workspace: Vec<i32>,
    numbers: Vec<Q15>,
    exponents: Vec<i16>,
    mantissas: Vec<i32>,
    exponent: i32,
    scene: Vec<i32>,
    unit: i32,
}

impl IntegerShader {
    /// A shader that uses the first `components` of a table.
    ///
    /// # Errors
    ///
    /// If the table has no integer form.
    pub fn new(table: &Table, components: usize) -> Result<Self> {
        let basis = OwnedQuantized::new(table, TOLERANCE).map_err(|error| {
            if let FormatError::High { degree, order } = error {
                return beyond(degree, order);
            }
            let line = error.to_string();
            let (what, remedy) = line.rsplit_once("; ").unwrap_or((&line, "another table"));
            let others = match error {
                FormatError::Large { .. } => {
                    ", fewer --components, or another table, as --table sphere".to_owned()
                }
                _ => format!(", or {remedy}"),
            };
            Error::new(what, format!("use --format f32{others}"))
        })?;
        let view = basis.view().map_err(fault)?;
        Ok(Self {
            components: components.min(view.components()),
            workspace: vec![0; view.workspace_len()],
            numbers: vec![Q15(0); view.transfer_len()],
            exponents: vec![0; view.profiles()],
            mantissas: vec![0; view.components()],
            exponent: 0,
            scene: vec![0; view.scene_len()],
            unit: 0,
            basis,
        })
    }

    /// Number of polynomial terms in a scene.
    #[must_use]
    pub fn terms(&self) -> usize {
        self.scene.len()
    }

    /// The exponent of the last image that [`polynomial`](Self::polynomial) made: its irradiances
    /// are multiples of 2 to that power.
    #[must_use]
    pub fn unit(&self) -> i32 {
        self.unit
    }

    /// d for one channel of a light and one channel of a material, of at most the table's degree
    /// and order.
    ///
    /// # Errors
    ///
    /// If the coefficients do not have the number of a degree and of an order, exceed the table's
    /// degree or order, or are so large that they would saturate or so small that they would be
    /// lost.
    pub fn project(&mut self, light: &[f64], material: &[f64]) -> Result<Vec<f64>> {
        // Only these numbers can saturate: all later ones are scaled by their bounds.
        if ![light, material].iter().all(|numbers| quantize::holds(numbers)) {
            return Err(overflow::fault("q15", light, material));
        }
        overflow::lost("q15", light, material)?;
        let basis = self.basis.view().map_err(fault)?;
        let rounded: Vec<f32> = material.iter().map(|&number| number as f32).collect();
        let order = eigenshade::Material::new(&rounded).map_err(fault)?.order();
        let (mantissas, exponents) = quantize::material(order, material);
        let material = Material::new(&exponents, &mantissas).map_err(fault)?;
        let (mantissas, exponent) = quantize::row(light, i64::MAX);
        let light = Light::new(exponent.into(), &mantissas).map_err(fault)?;
        let (numbers, exponents) = (&mut self.numbers, &mut self.exponents);
        basis.transfer_into(&material, &mut self.workspace, numbers, exponents).map_err(fault)?;
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
        light: &[f64],
        material: &[f64],
        normals: &[Normal],
    ) -> Result<Vec<f64>> {
        self.project(light, material)?;
        let basis = self.basis.view().map_err(fault)?;
        let used = self.mantissas.get(..self.components).unwrap_or(&self.mantissas);
        let scene = basis.collapse_into(used, self.exponent, &mut self.scene).map_err(fault)?;
        self.unit = scene.exponent();
        let one = |normal: &Normal| scaled(scene.shade(*normal), self.unit);
        Ok(normals.iter().map(one).collect())
    }
}

/// Rounds unit normals with z >= 0 to integers.
///
/// # Errors
///
/// If one is not a visible unit vector.
pub fn normals(normals: &[[f64; 3]]) -> Result<Vec<Normal>> {
    normals.iter().map(|normal| self::normal(*normal).map_err(fault)).collect()
}

fn scaled(mantissa: i32, exponent: i32) -> f64 {
    f64::from(mantissa) * 2f64.powi(exponent)
}
