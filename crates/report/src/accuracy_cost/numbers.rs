//! The ways to a pixel in every number format, for images and for timing.

use super::images::{Numbers, Pair, Pixels, Shaded, Shading, Work, each};
use super::settings::{Format, Scaling, Setting, Way};
use eigenshade::object::MapPoint;
use eigenshade::truncation::Tolerance;
use eigenshade::{Basis, Highlights, Light, Material, Normal, Normals, Q15, Source, q15};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::evaluation::{Eigenimages, Evaluator};
use eigenshade_shading::integer_shader::{self, IntegerShader, OwnedQuantized};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::quantize::{self, TOLERANCE};
use eigenshade_table::{Table, wire};
use std::fmt::Display;
use std::hint::black_box;

/// The numbers of a setting without its sources. Fails if its format cannot represent the table.
pub fn numbers(setting: &Setting, table: &Table, normals: &[[f64; 3]]) -> Result<Box<dyn Numbers>> {
    let scale: Scale = match setting.scaling {
        Scaling::None => None,
        Scaling::Newton => Some(|raw, to| scale(Normal::new, raw, to)),
        Scaling::Micromath => Some(|raw, to| scale(Normal::approximate, raw, to)),
    };
    Ok(match (setting.format, setting.way) {
        (Format::F64, Way::Polynomial | Way::Eigen) => Box::new(Doubles::new(table, normals)),
        // Maps of 16 bits are made from scenes in f32.
        (Format::F32, _) | (Format::Q15, Way::Bilinear(_)) => {
            Box::new(Floats::new(*setting, table, normals, scale)?)
        }
        (Format::Q15, Way::Polynomial) => Box::new(Integers::new(table, normals)?),
        _ => return Err(unrepresentable("the format has no such way to a pixel")),
    })
}

fn unrepresentable(error: impl Display) -> Error {
    Error::new(error.to_string(), "take another format")
}

/// Bytes of the table in flash, as `eigenshade pack` writes it.
///
/// Domain: a format of the runtime, not f64.
pub fn table_bytes(setting: &Setting, table: &Table) -> Result<usize> {
    let format = match (setting.format, setting.way) {
        (_, Way::NineTerms) => return Ok(0),
        (Format::Q15, Way::Polynomial) => wire::NumberFormat::Q15,
        _ => wire::NumberFormat::F32,
    };
    Ok(wire::encode(table, format, wire::Endian::Little).map_err(unrepresentable)?.len())
}

/// Bytes in RAM for each source: its lobe and, in floats, which turn it, itself.
pub fn source_bytes(setting: &Setting) -> usize {
    type Integers<const N: usize> = q15::Highlights<i32, N>;
    type Floats<const N: usize> = Highlights<N>;
    match setting.format {
        Format::Q15 => size_of::<Integers<2>>() - size_of::<Integers<1>>(),
        _ => size_of::<Source>() + size_of::<Floats<2>>() - size_of::<Floats<1>>(),
    }
}

/// Lengths of the normals that are to be scaled, in turn: like cross products, over an octave.
const LENGTHS: [f32; 5] = [0.37, 0.61, 1.0, 1.43, 2.3];

/// What scales vectors to unit length, if needed, into an array for each component.
type Scale = Option<fn(&[[f32; 3]], &mut [Vec<f32>; 3])>;

struct Floats {
    setting: Setting,
    basis: OwnedBasis,
    normals: OwnedNormals,
    each: Vec<Normal>,
    /// The normals for maps of 16 bits.
    quantized: Vec<q15::Normal>,
    scale: Scale,
}

/// From the coefficients d to the data that a pixel reads.
type Collapse<'a> = Box<dyn FnMut(&[f32]) -> std::result::Result<(), eigenshade::Error> + 'a>;

/// The pixels of an image, their number of terms, and how their data are made, in how many bytes.
struct Operations<'a> {
    pixels: Box<dyn Pixels + 'a>,
    terms: usize,
    collapse: Collapse<'a>,
    bytes: usize,
}

impl Floats {
    /// With `scale`, the normals are first given lengths other than 1.
    fn new(setting: Setting, table: &Table, normals: &[[f64; 3]], scale: Scale) -> Result<Self> {
        let quantized = integer_shader::normals(normals)?;
        let (basis, normals) = (OwnedBasis::new(table)?, OwnedNormals::new(normals));
        Ok(Self { setting, basis, each: normals.each()?, normals, quantized, scale })
    }

    fn basis(&self) -> Result<Basis<'_>> {
        self.basis.basis().map_err(fault)
    }

    fn project(&self, pair: &Pair) -> Result<Vec<f32>> {
        let basis = self.basis()?;
        let (light, material) = pair.within(basis.degree(), basis.order());
        Shader::new(basis, usize::MAX).project(light, material).map(<[f32]>::to_vec)
    }

    /// `lengths` has a number for each azimuth.
    fn operations<'a>(&'a self, pair: &Pair, lengths: &'a mut [u16]) -> Result<Operations<'a>> {
        let Setting { way, format, .. } = self.setting;
        let (basis, d) = (self.basis()?, self.project(pair)?);
        let mut buffer = vec![0.0; basis.scene_len()];
        let scene = basis.collapse_into(&d, buffer.clone()).map_err(fault)?;
        let held = size_of::<f32>() * (basis.transfer_len() + basis.components());
        let of_scene = held + size_of_val(&buffer[..]);
        let (pixels, terms, collapse, bytes): (_, _, Collapse<'a>, _) = match way {
            Way::NineTerms => {
                let formula = pair.nine_terms()?;
                let pixels =
                    self.all(move |normals, out| black_box(&formula).shade_slice(normals, out))?;
                // A new light is its own coefficients, scaled.
                let coefficients = formula.coefficients();
                (pixels, coefficients.len(), Box::new(|_| Ok(())), size_of_val(coefficients))
            }
            Way::Eigen => {
                let pixel = move |normal| basis.reconstruct(&d, normal).unwrap_or(0.0);
                let terms = basis.parts().terms.len();
                (each(&self.each, 0, pixel), terms, Box::new(|_| Ok(())), held)
            }
            Way::Polynomial => {
                let pixels = self.all(move |normals, out| scene.shade_slice(normals, out))?;
                let collapse = move |d: &[f32]| {
                    basis.collapse_into(d, &mut buffer[..]).map(|scene| seen(&scene))
                };
                (pixels, basis.scene_len(), Box::new(collapse), of_scene)
            }
            Way::Within(share) => {
                let tolerance = Tolerance::OfPeak(share as f32);
                let lengths = &mut lengths[..basis.azimuths()];
                let mut again = lengths.to_vec();
                let within = basis.collapse_within(&d, tolerance, lengths, buffer.clone());
                let (scene, truncation) = within.map_err(fault)?;
                let pixels = self.all(move |normals, out| scene.shade_slice(normals, out))?;
                let collapse = move |d: &[f32]| {
                    let within = basis.collapse_within(d, tolerance, &mut again, &mut buffer[..]);
                    within.map(|found| seen(&found))
                };
                (pixels, truncation.terms, Box::new(collapse), of_scene)
            }
            Way::Bilinear(size) if format == Format::Q15 => {
                let mut texels = vec![0i16; size * size];
                let map = scene.bake_integers_into(size, texels.clone()).map_err(fault)?;
                let bytes = held + size_of_val(&texels[..]);
                let collapse = move |d: &[f32]| {
                    let scene = basis.collapse_into(d, &mut buffer[..])?;
                    scene.bake_integers_into(size, &mut texels[..]).map(|map| seen(&map))
                };
                (of_integers(map, &self.quantized), 0, Box::new(collapse), bytes)
            }
            Way::Bilinear(size) => {
                let mut texels = vec![0.0; size * size];
                let map = scene.bake_into(size, texels.clone()).map_err(fault)?;
                let bytes = held + size_of_val(&texels[..]);
                let pixels = each(&self.each, 0, move |n| map.bilinear(MapPoint::of(n)));
                let collapse = move |d: &[f32]| {
                    let scene = basis.collapse_into(d, &mut buffer[..])?;
                    scene.bake_into(size, &mut texels[..]).map(|map| seen(&map))
                };
                (pixels, 0, Box::new(collapse), bytes)
            }
        };
        Ok(Operations { pixels, terms, collapse, bytes })
    }

    /// All pixels at once. As in a renderer, normals that need it are all scaled before.
    fn all<'a>(
        &'a self,
        shade: impl Fn(Normals<'_>, &mut [f32]) -> std::result::Result<(), eigenshade::Error> + 'a,
    ) -> Result<Box<dyn Pixels + 'a>> {
        let Some(scale) = self.scale else {
            let normals = self.normals.view()?;
            return Ok(Shading::boxed(self.each.len(), 0, move |out| {
                black_box(shade(black_box(normals), out).is_ok());
            }));
        };
        let raw = self.each.iter().zip(LENGTHS.into_iter().cycle());
        let raw: Vec<[f32; 3]> =
            raw.map(|(one, length)| one.components().map(|x| length * x)).collect();
        let mut axes = [0, 1, 2].map(|_| vec![0.0; raw.len()]);
        Ok(Shading::boxed(raw.len(), 0, move |out| {
            scale(black_box(&raw), &mut axes);
            let [x, y, z] = &axes;
            let done = Normals::from_unit(x, y, z).and_then(|normals| shade(normals, out));
            black_box(done.is_ok());
        }))
    }
}

impl Numbers for Floats {
    fn image(&self, pair: &Pair) -> Result<Shaded> {
        let mut lengths = vec![0; self.setting.recipe.degree + 1];
        let Operations { mut pixels, terms, bytes, .. } = self.operations(pair, &mut lengths)?;
        pixels.shade();
        let (irradiances, exponent) = (pixels.irradiances(), pixels.exponent());
        Ok(Shaded { irradiances, terms, bytes, exponent })
    }

    fn works<'a>(&'a self, pair: &Pair, lengths: &'a mut [u16]) -> Result<[Work<'a>; 2]> {
        let Operations { mut pixels, mut collapse, .. } = self.operations(pair, lengths)?;
        let (basis, mut d) = (self.basis()?, self.project(pair)?);
        let (light, material) = pair.within(basis.degree(), basis.order());
        let rounded = |values: &[f64]| values.iter().map(|&v| v as f32).collect::<Vec<f32>>();
        let (light, material) = (rounded(light), rounded(material));
        let material = Material::new(&material).map_err(fault)?;
        let mut transfer = vec![0.0; basis.transfer_len()];
        let mut workspace = vec![0.0; basis.workspace_len()];
        basis.transfer_into(&material, &mut workspace, &mut transfer).map_err(fault)?;
        let new_light = move || {
            let light = Light::new(black_box(&light));
            let relit = light.and_then(|light| basis.relight_into(&transfer, &light, &mut d));
            black_box(relit.and_then(|()| collapse(&d)).is_ok());
        };
        Ok([Box::new(move || pixels.shade()), Box::new(new_light)])
    }
}

/// The host's sums of eigenimages.
struct Doubles {
    evaluator: Evaluator<Table>,
    eigenimages: Eigenimages,
    size: (usize, usize),
    terms: usize,
    bytes: usize,
}

impl Doubles {
    fn new(table: &Table, normals: &[[f64; 3]]) -> Self {
        let evaluator = Evaluator::new(table.clone());
        let degrees = table.profiles.iter().map(|profile| table.gram.degree + 1 - profile.azimuth);
        let terms = table.terms();
        Self {
            eigenimages: evaluator.eigenimages(normals),
            evaluator,
            size: (table.gram.degree, table.gram.order),
            terms,
            bytes: size_of::<f64>() * (degrees.sum::<usize>() + table.count() + terms),
        }
    }
}

impl Numbers for Doubles {
    fn image(&self, pair: &Pair) -> Result<Shaded> {
        let (light, material) = pair.within(self.size.0, self.size.1);
        let irradiances = self.eigenimages.reconstruct(&self.evaluator.project(light, material)?);
        Ok(Shaded { irradiances, terms: self.terms, bytes: self.bytes, exponent: 0 })
    }

    fn works<'a>(&'a self, pair: &Pair, _: &'a mut [u16]) -> Result<[Work<'a>; 2]> {
        let (light, material) = pair.within(self.size.0, self.size.1);
        let (light, transfer) = (light.to_vec(), self.evaluator.transfer(material)?);
        let d = self.evaluator.relight(&transfer, &light);
        let pixels = move || seen(&self.eigenimages.reconstruct(black_box(&d)));
        let new_light = move || seen(&self.evaluator.relight(&transfer, black_box(&light)));
        Ok([Box::new(pixels), Box::new(new_light)])
    }
}

/// The pixels of a map of 16 bits. A copy for each format of the scene would keep the compiler from
/// inlining the look-up, which would distort its time.
fn of_integers(map: q15::BakedMap<Vec<i16>>, at: &[q15::Normal]) -> Box<dyn Pixels + '_> {
    each(at, map.exponent(), move |normal| map.bilinear(q15::MapPoint::of(normal)))
}

/// Scales vectors with a constructor.
fn scale(
    new: impl Fn(f32, f32, f32) -> std::result::Result<Normal, eigenshade::Error>,
    raw: &[[f32; 3]],
    [xs, ys, zs]: &mut [Vec<f32>; 3],
) {
    for (((to_x, to_y), to_z), &[x, y, z]) in xs.iter_mut().zip(ys).zip(zs).zip(raw) {
        if let Ok(normal) = new(x, y, z) {
            [*to_x, *to_y, *to_z] = normal.components();
        }
    }
}

/// Keeps a value from being optimized away.
fn seen<T>(found: &T) {
    black_box(found);
}

/// The shader of images, and what the timed operations read.
struct Integers {
    shader: IntegerShader,
    basis: OwnedQuantized,
    normals: Vec<q15::Normal>,
}

impl Integers {
    fn new(table: &Table, normals: &[[f64; 3]]) -> Result<Self> {
        let basis = OwnedQuantized::new(table, TOLERANCE).map_err(unrepresentable)?;
        let shader = IntegerShader::new(table, usize::MAX)?;
        let normals = integer_shader::normals(normals)?;
        Ok(Self { shader, basis, normals })
    }
}

impl Numbers for Integers {
    fn image(&self, pair: &Pair) -> Result<Shaded> {
        let basis = self.basis.view().map_err(fault)?;
        let (light, material) = pair.within(basis.degree(), basis.order());
        let mut shader = self.shader.clone();
        let irradiances = shader.polynomial(light, material, &self.normals)?;
        let terms = shader.terms();
        let transfer =
            size_of::<Q15>() * basis.transfer_len() + size_of::<i16>() * basis.profiles();
        let bytes = transfer + size_of::<i32>() * (basis.components() + terms);
        Ok(Shaded { irradiances, terms, bytes, exponent: shader.unit() })
    }

    fn works<'a>(&'a self, pair: &Pair, _: &'a mut [u16]) -> Result<[Work<'a>; 2]> {
        let basis = self.basis.view().map_err(fault)?;
        let (light, material) = pair.within(basis.degree(), basis.order());
        let (mantissas, exponents) = quantize::material(basis.order(), material);
        let material = q15::Material::new(&exponents, &mantissas).map_err(fault)?;
        let (light, exponent) = quantize::row(light, i64::MAX);
        let light_exponent = i32::from(exponent);
        let mut workspace = vec![0; basis.workspace_len()];
        let mut numbers = vec![Q15(0); basis.transfer_len()];
        let mut exponents = vec![0; basis.profiles()];
        let done = basis.transfer_into(&material, &mut workspace, &mut numbers, &mut exponents);
        done.map_err(fault)?;
        let relight = move |d: &mut [i32]| {
            let transfer = q15::Transfer::new(&numbers, &exponents);
            let light = q15::Light::new(light_exponent, black_box(&light))?;
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
