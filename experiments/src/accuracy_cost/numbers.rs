//! The number formats of settings: floats, and integers.

use super::floats::{Floats, scale};
use super::images::Pair;
use super::images::{Numbers, Shaded, Work, each};
use super::settings::{Format, Scaling, Setting, Way};
use eigenshade::mathematics::{Libm, Micromath, SinglePrecision};
use eigenshade::{Q15, Q31, quantized};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::integer_shader::{self, Integer, IntegerShader, OwnedQuantized};
use eigenshade_shading::shader::fault;
use eigenshade_table::{Table, parts, quantize, wire};
use std::fmt::Display;
use std::hint::black_box;

/// The numbers of a setting without its sources, unless its format has no such way or cannot
/// represent the table.
pub fn numbers(setting: &Setting, table: &Table, normals: &[[f64; 3]]) -> Result<Box<dyn Numbers>> {
    let scale = match setting.scaling {
        Scaling::None => None,
        Scaling::Libm => Some(scale::<f32, Libm> as _),
        Scaling::Single => Some(scale::<f32, SinglePrecision> as _),
        Scaling::Micromath => Some(scale::<f32, Micromath> as _),
    };
    Ok(match (setting.format, setting.way) {
        (Format::F64, _) => Box::new(Floats::<f64>::new(setting, table, normals, None)?),
        // Maps of 16 bits are made from scenes in f32.
        (Format::F32, _) | (Format::Q15, Way::Bilinear(_)) => {
            Box::new(Floats::new(setting, table, normals, scale)?)
        }
        (Format::Q31, Way::Polynomial) => Box::new(Integers::<Q31>::new(table, normals)?),
        (Format::Q15, Way::Polynomial) => Box::new(Integers::<Q15>::new(table, normals)?),
        _ => return Err(unrepresentable("the format has no such way to a pixel")),
    })
}

fn unrepresentable(error: impl Display) -> Error {
    Error::new(error.to_string(), "take another format")
}

/// Bytes of the table in flash, as `eigenshade pack` writes it.
pub fn table_bytes(setting: &Setting, table: &Table) -> Result<usize> {
    let format = match (setting.format, setting.way) {
        (_, Way::NineTerms) => return Ok(0),
        (Format::Q31, _) => wire::NumberFormat::Q31,
        (Format::Q15, Way::Polynomial) => wire::NumberFormat::Q15,
        _ => wire::NumberFormat::F32,
    };
    let bytes = wire::encode(table, format, wire::Endian::Little).map_err(unrepresentable)?.len();
    if setting.format != Format::F64 {
        return Ok(bytes);
    }
    // A wire file has no f64: its numbers would take four bytes more each.
    let parts = parts::floats(table);
    Ok(bytes + 4 * (parts.polar.len() + parts.factors.len() + parts.terms.len()))
}

/// Bytes in RAM for each source: itself, to be turned, and its lobe; in integers, which turn none,
/// its lobe.
pub fn source_bytes(setting: &Setting) -> usize {
    use eigenshade::{Highlights as Lobes, Source};
    type Integers<const N: usize> = quantized::Highlights<i32, N>;
    match setting.format {
        Format::Q15 | Format::Q31 => size_of::<Integers<2>>() - size_of::<Integers<1>>(),
        _ => {
            let lobe = size_of::<Lobes<f32, 2>>() - size_of::<Lobes<f32, 1>>();
            size_of::<Source<f32>>() + lobe
        }
    }
}

/// The shader of images, and what the timed operations read.
struct Integers<Q: Integer> {
    shader: IntegerShader<Q>,
    basis: OwnedQuantized<Q>,
    normals: Vec<quantized::Normal<Q>>,
}

impl<Q: Integer> Integers<Q> {
    fn new(table: &Table, normals: &[[f64; 3]]) -> Result<Self> {
        let basis = OwnedQuantized::new(table, Q::FORMAT.tolerance()).map_err(unrepresentable)?;
        let shader = IntegerShader::new(table, usize::MAX)?;
        let normals = integer_shader::normals(normals)?;
        Ok(Self { shader, basis, normals })
    }
}

impl<Q: Integer<Wide: Sync> + Sync> Numbers for Integers<Q> {
    fn image(&self, pair: &Pair) -> Result<Shaded> {
        let basis = self.basis.view().map_err(fault)?;
        let (light, material) = pair.within(basis.degree(), basis.order());
        let mut shader = self.shader.clone();
        let irradiances = shader.polynomial(light, material, &self.normals)?;
        let terms = shader.terms();
        let transfer = size_of::<Q>() * basis.transfer_len() + size_of::<i16>() * basis.profiles();
        let bytes = transfer + size_of::<i32>() * (basis.components() + terms);
        Ok(Shaded { irradiances, terms, bytes, exponent: shader.unit() })
    }

    fn works<'a>(&'a self, pair: &Pair, _: &'a mut [u16]) -> Result<[Work<'a>; 2]> {
        let own = |numbers: &[i32]| numbers.iter().map(|&n| Q::of(n)).collect::<Vec<Q>>();
        let basis = self.basis.view().map_err(fault)?;
        let (light, material) = pair.within(basis.degree(), basis.order());
        let (mantissas, exponents) = quantize::material(basis.order(), material, Q::FORMAT);
        let mantissas = own(&mantissas);
        let material = quantized::Material::new(&exponents, &mantissas).map_err(fault)?;
        let (mantissas, exponent) = quantize::row(light, Q::FORMAT.bits(), i64::MAX);
        let (light, light_exponent) = (own(&mantissas), i32::from(exponent));
        let mut workspace = vec![Q::Wide::default(); basis.workspace_len()];
        let mut numbers = vec![Q::default(); basis.transfer_len()];
        let mut exponents = vec![0; basis.profiles()];
        basis
            .transfer_into(&material, &mut workspace, &mut numbers, &mut exponents)
            .map_err(fault)?;
        let relight = move |d: &mut [i32]| {
            let transfer = quantized::Transfer::new(&numbers, &exponents);
            let light = quantized::Light::new(light_exponent, black_box(&light))?;
            basis.relight_into(&transfer, &light, d)
        };
        let mut d = vec![0; basis.components()];
        let mut buffer = vec![0; basis.scene_len()];
        let exponent = relight(&mut d).map_err(fault)?;
        let scene = basis.collapse_into(&d, exponent, buffer.clone()).map_err(fault)?;
        let mut pixels = each(&self.normals, scene.exponent(), move |normal| scene.shade(normal));
        let new_light = move || {
            let done = relight(&mut d)
                .and_then(|exponent| basis.collapse_into(&d, exponent, &mut buffer[..]).map(drop));
            black_box((done.is_ok(), &buffer));
        };
        Ok([Box::new(move || pixels.shade()), Box::new(new_light)])
    }
}
