//! A setting with its basis and normals: images of it, and its operations for timing.

use super::floats::{Floats, Shade, Work};
use super::images::Pair;
use super::setting::{Format, Scaling, Setting, Way};
use eigenshade::{Q15, Q31, quantized};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::integer_shader::{self, Integer, IntegerShader, OwnedQuantized};
use eigenshade_shading::shader::fault;
use eigenshade_table::{Table, quantize};
use std::hint::black_box;

/// A basis and normals in a setting's number format.
pub enum Numbers {
    Double(Floats<f64>),
    Single(Floats<f32>),
    /// f32, except for the maps of 16 bits.
    Maps(Floats<f32>, Vec<quantized::Normal<Q15>>),
    Q31(Integers<Q31>),
    Q15(Integers<Q15>),
}

/// The shader of images, and what the timed operations read.
pub struct Integers<Q: Integer> {
    shader: IntegerShader<Q>,
    basis: OwnedQuantized<Q>,
    normals: Vec<quantized::Normal<Q>>,
}

impl Numbers {
    /// # Errors
    ///
    /// If the table cannot be represented in the setting's number format.
    pub fn new(setting: &Setting, table: &Table, normals: &[[f64; 3]]) -> Result<Self> {
        Ok(match (setting.format, setting.way) {
            (Format::F64, _) => Self::Double(Floats::new(table, normals)?),
            (Format::F32, _) => Self::Single(Floats::new(table, normals)?),
            (Format::Q15, Way::Bilinear(_)) => {
                Self::Maps(Floats::new(table, normals)?, integer_shader::normals(normals)?)
            }
            (Format::Q31, _) => Self::Q31(Integers::new(table, normals)?),
            (Format::Q15, _) => Self::Q15(Integers::new(table, normals)?),
        })
    }

    /// The irradiance of every normal, and the number of terms of the polynomials.
    pub fn image(&self, setting: &Setting, pair: &Pair, count: usize) -> Result<(Vec<f64>, usize)> {
        let mut lengths = vec![0; setting.recipe.degree + 1];
        match self {
            Self::Double(floats) => Ok(run(floats.pixels(pair, setting.way, &mut lengths)?, count)),
            Self::Single(floats) => Ok(run(single(floats, setting, pair, &mut lengths)?, count)),
            Self::Maps(floats, normals) => {
                let (shade, exponent) = floats.map(pair, side(setting)?, normals)?;
                let (values, _) = run((shade, 0), count);
                Ok((values.iter().map(|value| 2f64.powi(exponent) * value).collect(), 0))
            }
            Self::Q31(integers) => integers.image(setting, pair),
            Self::Q15(integers) => integers.image(setting, pair),
        }
    }

    /// All pixels, and a new light. `lengths` has a number for each azimuth.
    pub fn works<'a>(
        &'a self,
        setting: &Setting,
        pair: &Pair,
        count: usize,
        lengths: &'a mut [u16],
    ) -> Result<[Work<'a>; 2]> {
        let way = setting.way;
        match self {
            Self::Double(floats) => {
                let (shade, _) = floats.pixels(pair, way, lengths)?;
                Ok([repeated(shade, count), floats.new_light(pair, way, false)?])
            }
            Self::Single(floats) => {
                let (shade, _) = single(floats, setting, pair, lengths)?;
                Ok([repeated(shade, count), floats.new_light(pair, way, false)?])
            }
            Self::Maps(floats, normals) => {
                let (shade, _) = floats.map(pair, side(setting)?, normals)?;
                Ok([repeated(shade, count), floats.new_light(pair, way, true)?])
            }
            Self::Q31(integers) => integers.works(setting, pair),
            Self::Q15(integers) => integers.works(setting, pair),
        }
    }
}

fn single<'a>(
    floats: &'a Floats<f32>,
    setting: &Setting,
    pair: &Pair,
    lengths: &'a mut [u16],
) -> Result<(Shade<'a, f32>, usize)> {
    match (setting.way, setting.scaling) {
        (Way::NineTerms, _) => floats.nine_terms(pair),
        (way, Scaling::None) => floats.pixels(pair, way, lengths),
        (_, scaling) => floats.scaled(pair, scaling),
    }
}

/// Texels along a side of a setting's map.
fn side(setting: &Setting) -> Result<usize> {
    match setting.way {
        Way::Bilinear(size) => Ok(size),
        _ => Err(Error::new("maps of 16 bits are bilinear", "report it")),
    }
}

/// The pixels, and the number of terms.
fn run<T>((mut shade, terms): (Shade<'_, T>, usize), count: usize) -> (Vec<f64>, usize)
where
    T: Default + Copy + Into<f64>,
{
    let mut out = vec![T::default(); count];
    shade(&mut out);
    (out.into_iter().map(Into::into).collect(), terms)
}

/// The pixels, as often as needed.
fn repeated<T: Default + Clone + 'static>(mut shade: Shade<'_, T>, count: usize) -> Work<'_> {
    let mut out = vec![T::default(); count];
    Box::new(move || {
        shade(&mut out);
        black_box(&out);
    })
}

impl<Q: Integer> Integers<Q> {
    fn new(table: &Table, normals: &[[f64; 3]]) -> Result<Self> {
        let basis = OwnedQuantized::new(table, Q::FORMAT.tolerance())
            .map_err(|error| Error::new(error.to_string(), "take another format"))?;
        let normals = integer_shader::normals(normals)?;
        Ok(Self { shader: IntegerShader::new(table, usize::MAX)?, basis, normals })
    }

    fn image(&self, setting: &Setting, pair: &Pair) -> Result<(Vec<f64>, usize)> {
        let (light, material) = pair.within(setting.recipe.degree, setting.recipe.order);
        let mut shader = self.shader.clone();
        Ok((shader.polynomial(light, material, &self.normals)?, shader.terms()))
    }

    fn works(&self, setting: &Setting, pair: &Pair) -> Result<[Work<'_>; 2]> {
        let ((_, light), (order, material)) =
            pair.within(setting.recipe.degree, setting.recipe.order);
        let own = |numbers: &[i32]| numbers.iter().map(|&n| Q::of(n)).collect::<Vec<Q>>();
        let basis = self.basis.view().map_err(fault)?;
        let (mantissas, exponents) = quantize::material(order, material, Q::FORMAT);
        let mantissas = own(&mantissas);
        let material = quantized::Material::new(&exponents, &mantissas).map_err(fault)?;
        let (mantissas, exponent) = quantize::row(light, Q::FORMAT.bits(), i64::MAX);
        let (light, light_exponent) = (own(&mantissas), i32::from(exponent));
        let mut workspace = vec![Q::Wide::default(); basis.workspace_len()];
        let mut transfer = vec![Q::default(); basis.transfer_len()];
        let mut exponents = vec![0; basis.profiles()];
        basis
            .transfer_into(&material, &mut workspace, &mut transfer, &mut exponents)
            .map_err(fault)?;
        let mut d = vec![0; basis.components()];
        let folded = quantized::Transfer::new(&transfer, &exponents);
        let first = quantized::Light::new(light_exponent, &light).map_err(fault)?;
        let exponent = basis.relight_into(&folded, &first, &mut d).map_err(fault)?;
        let buffer = vec![0; basis.scene_len()];
        let scene = basis.collapse_into(&d, exponent, buffer).map_err(fault)?;
        let mut out = vec![0; self.normals.len()];
        let pixels = Box::new(move || {
            for (out, &normal) in out.iter_mut().zip(black_box(&self.normals)) {
                *out = scene.shade(normal);
            }
            black_box(&out);
        });
        let mut buffer = vec![0; basis.scene_len()];
        let new_light = Box::new(move || {
            let folded = quantized::Transfer::new(&transfer, &exponents);
            let done = quantized::Light::new(light_exponent, black_box(&light))
                .and_then(|light| basis.relight_into(&folded, &light, &mut d))
                .and_then(|exponent| basis.collapse_into(&d, exponent, &mut buffer[..]).map(drop));
            black_box((done.is_ok(), &buffer));
        });
        Ok([pixels, new_light])
    }
}
