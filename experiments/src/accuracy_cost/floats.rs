//! The ways to a pixel in floats, for images and for timing.

use super::images::Pair;
use super::images::{Numbers, Pixels, Shaded, Shading, Work, each};
use super::settings::{Format, Setting, Way};
use eigenshade::mathematics::Mathematics;
use eigenshade::{
    Basis, Error, IntegerMap, Light, MapPoint, Material, Normal, Normals, Q15, Scalar, Tolerance,
    quantized,
};
use eigenshade_model::error::Result;
use eigenshade_shading::integer_shader;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::Table;
use std::hint::black_box;

/// Lengths of the normals that are to be scaled, used in turn. They span more than an octave, as
/// the lengths of cross products do.
const LENGTHS: [f64; 5] = [0.37, 0.61, 1.0, 1.43, 2.3];

/// Scales vectors to unit length, into an array for each component.
pub type Scale<S> = fn(&[[S; 3]], &mut [Vec<S>; 3]);

/// A basis and normals.
pub struct Floats<S> {
    setting: Setting,
    basis: OwnedBasis<S>,
    normals: OwnedNormals<S>,
    each: Vec<Normal<S>>,
    /// The normals for maps of 16 bits.
    quantized: Vec<quantized::Normal<Q15>>,
    scale: Option<Scale<S>>,
}

/// From the coefficients d to the data that a pixel reads.
type Collapse<'a, S> = Box<dyn FnMut(&[S]) -> std::result::Result<(), Error> + 'a>;

/// The pixels of an image; the number of terms of their polynomials; how the data that they read
/// are made, and the bytes of these.
struct Operations<'a, S> {
    pixels: Box<dyn Pixels + 'a>,
    terms: usize,
    collapse: Collapse<'a, S>,
    bytes: usize,
}

impl<S: Scalar + Into<f64>> Floats<S> {
    /// With `scale`, the normals are first given lengths other than 1.
    pub fn new(
        setting: &Setting,
        table: &Table,
        normals: &[[f64; 3]],
        scale: Option<Scale<S>>,
    ) -> Result<Self> {
        let quantized = integer_shader::normals(normals)?;
        let (basis, normals) = (OwnedBasis::new(table), OwnedNormals::new(normals));
        Ok(Self { setting: *setting, basis, each: normals.each()?, normals, quantized, scale })
    }

    fn basis(&self) -> Result<Basis<'_, S>> {
        self.basis.basis().map_err(fault)
    }

    /// The coefficients d.
    fn project(&self, pair: &Pair) -> Result<Vec<S>> {
        let basis = self.basis()?;
        let (light, material) = pair.within(basis.degree(), basis.order());
        Shader::new(basis, usize::MAX).project(light, material).map(<[S]>::to_vec)
    }

    /// `lengths` has a number for each azimuth.
    fn operations<'a>(&'a self, pair: &Pair, lengths: &'a mut [u16]) -> Result<Operations<'a, S>> {
        let Setting { way, format, .. } = self.setting;
        let (basis, d) = (self.basis()?, self.project(pair)?);
        let mut buffer = vec![S::ZERO; basis.scene_len()];
        let scene = basis.collapse_into(&d, buffer.clone()).map_err(fault)?;
        let held = size_of::<S>() * (basis.transfer_len() + basis.components());
        let of_scene = held + size_of_val(&buffer[..]);
        let (pixels, terms, collapse, bytes): (_, _, Collapse<'a, S>, _) = match way {
            Way::NineTerms => {
                let formula = pair.nine_terms()?;
                let pixels =
                    self.all(move |normals, out| black_box(&formula).shade_slice(normals, out))?;
                // A new light is its own coefficients, scaled.
                let coefficients = formula.coefficients();
                (pixels, coefficients.len(), Box::new(|_| Ok(())), size_of_val(coefficients))
            }
            Way::Eigen => {
                let pixel = move |normal| basis.reconstruct(&d, normal).unwrap_or(S::ZERO);
                let terms = basis.parts().terms.len();
                (each(&self.each, 0, pixel), terms, Box::new(|_| Ok(())), held)
            }
            Way::Polynomial => {
                let pixels = self.all(move |normals, out| scene.shade_slice(normals, out))?;
                let collapse = move |d: &[S]| {
                    basis.collapse_into(d, &mut buffer[..]).map(|scene| seen(&scene))
                };
                (pixels, basis.scene_len(), Box::new(collapse), of_scene)
            }
            Way::Within(share) => {
                let tolerance = Tolerance::OfPeak(S::from_f64(share));
                let lengths = &mut lengths[..basis.azimuths()];
                let mut again = lengths.to_vec();
                let within = basis.collapse_within(&d, tolerance, lengths, buffer.clone());
                let (scene, truncation) = within.map_err(fault)?;
                let pixels = self.all(move |normals, out| scene.shade_slice(normals, out))?;
                let collapse = move |d: &[S]| {
                    let within = basis.collapse_within(d, tolerance, &mut again, &mut buffer[..]);
                    within.map(|found| seen(&found))
                };
                (pixels, truncation.terms, Box::new(collapse), of_scene)
            }
            Way::Bilinear(size) if format == Format::Q15 => {
                let mut texels = vec![0i16; size * size];
                let map = scene.bake_integers_into(size, texels.clone()).map_err(fault)?;
                let bytes = held + size_of_val(&texels[..]);
                let collapse = move |d: &[S]| {
                    let scene = basis.collapse_into(d, &mut buffer[..])?;
                    scene.bake_integers_into(size, &mut texels[..]).map(|map| seen(&map))
                };
                (of_integers(map, &self.quantized), 0, Box::new(collapse), bytes)
            }
            Way::Bilinear(size) => {
                let mut texels = vec![S::ZERO; size * size];
                let map = scene.bake_into(size, texels.clone()).map_err(fault)?;
                let bytes = held + size_of_val(&texels[..]);
                let pixels = each(&self.each, 0, move |n| map.bilinear(MapPoint::of(n)));
                let collapse = move |d: &[S]| {
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
        shade: impl Fn(Normals<'_, S>, &mut [S]) -> std::result::Result<(), Error> + 'a,
    ) -> Result<Box<dyn Pixels + 'a>> {
        let Some(scale) = self.scale else {
            let normals = self.normals.view()?;
            return Ok(Shading::boxed(self.each.len(), 0, move |out| {
                black_box(shade(black_box(normals), out).is_ok());
            }));
        };
        let raw = self.each.iter().zip(LENGTHS.into_iter().map(S::from_f64).cycle());
        let raw: Vec<[S; 3]> =
            raw.map(|(one, length)| one.components().map(|x| length * x)).collect();
        let mut axes = [0, 1, 2].map(|_| vec![S::ZERO; raw.len()]);
        Ok(Shading::boxed(raw.len(), 0, move |out| {
            scale(black_box(&raw), &mut axes);
            let [x, y, z] = &axes;
            let done = Normals::new(x, y, z).and_then(|normals| shade(normals, out));
            black_box(done.is_ok());
        }))
    }
}

impl<S: Scalar + Into<f64> + Sync> Numbers for Floats<S> {
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
        let rounded = |values: &[f64]| values.iter().map(|&v| S::from_f64(v)).collect::<Vec<S>>();
        let (light, material) = (rounded(light), rounded(material));
        let material = Material::new(&material).map_err(fault)?;
        let mut transfer = vec![S::ZERO; basis.transfer_len()];
        let mut workspace = vec![S::ZERO; basis.workspace_len()];
        basis.transfer_into(&material, &mut workspace, &mut transfer).map_err(fault)?;
        let new_light = move || {
            let light = Light::new(black_box(&light));
            let relit = light.and_then(|light| basis.relight_into(&transfer, &light, &mut d));
            black_box(relit.and_then(|()| collapse(&d)).is_ok());
        };
        Ok([Box::new(move || pixels.shade()), Box::new(new_light)])
    }
}

/// The pixels of a map of 16 bits. A copy for each format of the scene would keep the compiler from
/// inlining the look-up, which would distort its time.
fn of_integers(
    map: IntegerMap<Vec<i16>>,
    normals: &[quantized::Normal<Q15>],
) -> Box<dyn Pixels + '_> {
    each(normals, map.exponent(), move |normal| map.bilinear(MapPoint::of_quantized(normal)))
}

/// Scales vectors with one implementation of mathematics.
pub fn scale<S: Scalar, M: Mathematics<S>>(raw: &[[S; 3]], [xs, ys, zs]: &mut [Vec<S>; 3]) {
    for (((to_x, to_y), to_z), &[x, y, z]) in xs.iter_mut().zip(ys).zip(zs).zip(raw) {
        if let Ok(normal) = Normal::with_mathematics::<M>(x, y, z) {
            [*to_x, *to_y, *to_z] = normal.components();
        }
    }
}

/// Keeps a value from being optimized away.
fn seen<T>(found: &T) {
    black_box(found);
}
