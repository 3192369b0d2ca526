//! Computes one image with any setting.

use super::images::{Image, Images};
use super::setting::{Format, Scaling, Setting, Way};
use eigenshade::mathematics::{Libm, Micromath, SinglePrecision, Tabled};
use eigenshade::{Basis, MapPoint, NineTerms, Normal, Q15, Q31, Scalar, Tolerance, quantised};
use eigenshade_model::error::Result;
use eigenshade_shading::integer_shader::{self, IntegerShader};
use eigenshade_shading::methods::LookUp;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::Table;

/// A setting with its basis and normals.
pub struct Shading {
    setting: Setting,
    degree: usize,
    order: usize,
    numbers: Numbers,
}

enum Numbers {
    Double(Floats<f64>),
    Single(Floats<f32>),
    /// f32, except for the maps of 16 bits.
    Maps(Floats<f32>, Vec<quantised::Normal<Q15>>),
    Q31(IntegerShader<Q31>, Vec<quantised::Normal<Q31>>),
    Q15(IntegerShader<Q15>, Vec<quantised::Normal<Q15>>),
}

/// A basis and normals in floats.
struct Floats<S> {
    basis: OwnedBasis<S>,
    normals: OwnedNormals<S>,
    each: Vec<Normal<S>>,
}

/// Lengths of the normals that are to be scaled, used in turn. They span more than an octave, as
/// the lengths of cross products do.
pub const LENGTHS: [f32; 5] = [0.37, 0.61, 1.0, 1.43, 2.3];

impl Shading {
    /// Prepares a setting.
    ///
    /// # Errors
    ///
    /// If the table cannot be represented in the setting's number format.
    pub fn new(setting: &Setting, table: &Table, images: &Images) -> Result<Self> {
        let normals = &images.normals;
        let numbers = match (setting.format, setting.way) {
            (Format::F64, _) => Numbers::Double(Floats::new(table, normals)?),
            (Format::F32, _) => Numbers::Single(Floats::new(table, normals)?),
            (Format::Q15, Way::Bilinear(_)) => {
                let quantised = integer_shader::normals(normals)?;
                Numbers::Maps(Floats::new(table, normals)?, quantised)
            }
            (Format::Q31, _) => {
                let normals = integer_shader::normals(normals)?;
                Numbers::Q31(IntegerShader::new(table, usize::MAX)?, normals)
            }
            (Format::Q15, _) => {
                let normals = integer_shader::normals(normals)?;
                Numbers::Q15(IntegerShader::new(table, usize::MAX)?, normals)
            }
        };
        Ok(Self { setting: *setting, degree: table.gram.degree, order: table.gram.order, numbers })
    }

    /// The irradiance of every normal, and the number of terms of the polynomials.
    ///
    /// # Errors
    ///
    /// Never in practice: lights and materials have the basis's degree and order.
    pub fn image(&self, image: &Image) -> Result<(Vec<f64>, usize)> {
        let (light, material) = image.within(self.degree, self.order);
        match &self.numbers {
            Numbers::Double(floats) => floats.image(self.setting.way, light, material),
            Numbers::Single(floats) => match (self.setting.way, self.setting.scaling) {
                (Way::NineTerms, _) => {
                    let formula = image.nine_terms()?;
                    Ok((floats.nine_terms(&formula)?, formula.coefficients().len()))
                }
                (way, Scaling::None) => floats.image(way, light, material),
                (_, scaling) => floats.scaled(scaling, light, material),
            },
            Numbers::Maps(floats, normals) => {
                let Way::Bilinear(size) = self.setting.way else { return Ok((Vec::new(), 0)) };
                let mut shader = Shader::new(floats.basis.any().map_err(fault)?, usize::MAX);
                shader.project(light, material)?;
                let texels = vec![0i16; size * size];
                let map = shader.scene()?.bake_integers_into(size, texels).map_err(fault)?;
                let scale = 2f64.powi(map.exponent());
                let at = |&normal| f64::from(map.bilinear(MapPoint::of_quantised(normal)));
                let values = normals.iter().map(|normal| scale * at(normal));
                Ok((values.collect(), 0))
            }
            Numbers::Q31(shader, normals) => {
                Ok((shader.clone().polynomial(light, material, normals)?, shader.terms()))
            }
            Numbers::Q15(shader, normals) => {
                Ok((shader.clone().polynomial(light, material, normals)?, shader.terms()))
            }
        }
    }
}

impl<S: Scalar + Into<f64>> Floats<S> {
    fn new(table: &Table, normals: &[[f64; 3]]) -> Result<Self> {
        let normals = OwnedNormals::new(normals);
        let each = normals.each()?;
        Ok(Self { basis: OwnedBasis::new(table), normals, each })
    }

    fn basis(&self) -> Result<Basis<'_, S>> {
        self.basis.basis().map_err(fault)
    }

    fn image(
        &self,
        way: Way,
        light: (usize, &[f64]),
        material: (usize, &[f64]),
    ) -> Result<(Vec<f64>, usize)> {
        let basis = self.basis()?;
        let mut shader = Shader::new(basis, usize::MAX);
        let mut look_up = |way| shader.looked_up(light, material, &self.each, way);
        let (values, terms) = match way {
            Way::Linear(knots) => (look_up(LookUp::Linear { knots })?, 0),
            Way::Cubic(knots) => (look_up(LookUp::Cubic { knots })?, 0),
            Way::Bilinear(size) => (look_up(LookUp::Bilinear { size })?, 0),
            Way::Nearest(size) => (look_up(LookUp::Nearest { size })?, 0),
            Way::Eigen => (shader.eigen(light, material, &self.each)?, basis.parts().terms.len()),
            Way::Within(share) => {
                let d = shader.project(light, material)?.to_vec();
                let mut lengths = vec![0; basis.azimuths()];
                let tolerance = Tolerance::OfPeak(S::from_f64(share));
                let buffer = vec![S::ZERO; basis.scene_len()];
                let (scene, economy) =
                    basis.collapse_within(&d, tolerance, &mut lengths, buffer).map_err(fault)?;
                let mut values = vec![S::ZERO; self.each.len()];
                scene.shade_slice(self.normals.view()?, &mut values).map_err(fault)?;
                (values, economy.terms)
            }
            Way::Polynomial | Way::NineTerms => {
                (shader.polynomial(light, material, &self.normals)?, basis.scene_len())
            }
        };
        Ok((values.into_iter().map(Into::into).collect(), terms))
    }
}

impl Floats<f32> {
    fn nine_terms(&self, formula: &NineTerms<f32>) -> Result<Vec<f64>> {
        let mut out = vec![0.0; self.each.len()];
        formula.shade_slice(self.normals.view()?, &mut out).map_err(fault)?;
        Ok(out.into_iter().map(f64::from).collect())
    }

    /// Shades normals of other lengths, scaled one by one.
    fn scaled(
        &self,
        scaling: Scaling,
        light: (usize, &[f64]),
        material: (usize, &[f64]),
    ) -> Result<(Vec<f64>, usize)> {
        let mut shader = Shader::new(self.basis()?, usize::MAX);
        shader.project(light, material)?;
        let scene = shader.scene()?;
        let lengths = LENGTHS.iter().cycle();
        let values: Result<Vec<f64>> = self
            .each
            .iter()
            .zip(lengths)
            .map(|(normal, length)| {
                let [x, y, z] = normal.components().map(|one| length * one);
                scaled(scaling, x, y, z).map(|normal| scene.shade(normal).into())
            })
            .collect();
        Ok((values?, self.basis()?.scene_len()))
    }
}

/// Scales a normal of any length.
///
/// # Errors
///
/// If its length is zero.
#[inline]
pub fn scaled(scaling: Scaling, x: f32, y: f32, z: f32) -> Result<Normal<f32>> {
    match scaling {
        Scaling::None | Scaling::Libm => Normal::with_mathematics::<Libm>(x, y, z),
        Scaling::Single => Normal::with_mathematics::<SinglePrecision>(x, y, z),
        Scaling::Tabled => Normal::with_mathematics::<Tabled>(x, y, z),
        Scaling::Micromath => Normal::with_mathematics::<Micromath>(x, y, z),
    }
    .map_err(fault)
}

/// Normals spread over the visible hemisphere, by components.
#[must_use]
pub fn hemisphere(count: usize) -> Vec<[f64; 3]> {
    let normal = |k: usize| {
        let z = (k as f64 + 0.5) / count as f64;
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
        [sine * tilt.cos(), sine * tilt.sin(), z]
    };
    (0..count).map(normal).collect()
}
