//! The ways to a pixel in floats, for images and for timing.

use super::images::Pair;
use super::setting::{Scaling, Way};
use eigenshade::mathematics::{Libm, Micromath, SinglePrecision, Tabled};
use eigenshade::{
    Basis, Light, MapPoint, Material, Normal, Normals, Q15, Scalar, Tolerance, quantized,
};
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::Table;
use std::hint::black_box;

/// Lengths of the normals that are to be scaled, used in turn. They span more than an octave, as
/// the lengths of cross products do.
const LENGTHS: [f32; 5] = [0.37, 0.61, 1.0, 1.43, 2.3];

/// A basis and normals.
pub struct Floats<S> {
    basis: OwnedBasis<S>,
    normals: OwnedNormals<S>,
    each: Vec<Normal<S>>,
}

/// An operation to be timed.
pub type Work<'a> = Box<dyn FnMut() + 'a>;

/// Writes the irradiance of every normal.
pub type Shade<'a, T> = Box<dyn FnMut(&mut [T]) + 'a>;

impl<S: Scalar> Floats<S> {
    pub fn new(table: &Table, normals: &[[f64; 3]]) -> Result<Self> {
        let normals = OwnedNormals::new(normals);
        let each = normals.each()?;
        Ok(Self { basis: OwnedBasis::new(table), normals, each })
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

    /// All pixels, and the number of terms of the polynomials. `lengths` has a number for each
    /// azimuth.
    pub fn pixels<'a>(
        &'a self,
        pair: &Pair,
        way: Way,
        lengths: &'a mut [u16],
    ) -> Result<(Shade<'a, S>, usize)> {
        let basis = self.basis()?;
        let d = self.project(pair)?;
        let buffer = vec![S::ZERO; basis.scene_len()];
        let (normals, each) = (self.normals.view()?, &self.each);
        macro_rules! each_by {
            ($pixel:expr) => {
                Box::new(move |out| {
                    for (out, normal) in out.iter_mut().zip(black_box(each)) {
                        *out = $pixel(*normal);
                    }
                })
            };
        }
        if let Way::Within(share) = way {
            let tolerance = Tolerance::OfPeak(S::from_f64(share));
            let lengths = &mut lengths[..basis.azimuths()];
            let (scene, economy) =
                basis.collapse_within(&d, tolerance, lengths, buffer).map_err(fault)?;
            let shade = move |out: &mut [S]| {
                black_box(scene.shade_slice(black_box(normals), out).is_ok());
            };
            return Ok((Box::new(shade), economy.terms));
        }
        let scene = basis.collapse_into(&d, buffer).map_err(fault)?;
        let shade: Shade<'a, S> = match way {
            Way::Polynomial | Way::NineTerms | Way::Within(_) => {
                let shade = move |out: &mut [S]| {
                    black_box(scene.shade_slice(black_box(normals), out).is_ok());
                };
                return Ok((Box::new(shade), basis.scene_len()));
            }
            Way::Eigen => {
                let terms = basis.parts().terms.len();
                let pixel = move |normal| basis.reconstruct(&d, normal).unwrap_or(S::ZERO);
                return Ok((each_by!(pixel), terms));
            }
            Way::Linear(knots) | Way::Cubic(knots) => {
                let samples = vec![S::ZERO; scene.sampled_len(knots)];
                let table = scene.sampled_into(knots, samples).map_err(fault)?;
                match way {
                    Way::Linear(_) => each_by!(|normal| table.linear(normal)),
                    _ => each_by!(|normal| table.cubic(normal)),
                }
            }
            Way::Bilinear(size) | Way::Nearest(size) => {
                let map = scene.bake_into(size, vec![S::ZERO; size * size]).map_err(fault)?;
                match way {
                    Way::Bilinear(_) => each_by!(|normal| map.bilinear(MapPoint::of(normal))),
                    _ => each_by!(|normal| map.nearest(MapPoint::of(normal))),
                }
            }
        };
        Ok((shade, 0))
    }

    /// A new light on a transferred material: d, then the data that a pixel reads. With `integers`,
    /// a map has texels of 16 bits.
    pub fn new_light(&self, pair: &Pair, way: Way, integers: bool) -> Result<Work<'_>> {
        let basis = self.basis()?;
        let ((_, light), (_, material)) = pair.within(basis.degree(), basis.order());
        let rounded = |values: &[f64]| values.iter().map(|&v| S::from_f64(v)).collect::<Vec<S>>();
        let (light, material) = (rounded(light), rounded(material));
        let material = Material::new(&material).map_err(fault)?;
        let mut transfer = vec![S::ZERO; basis.transfer_len()];
        let mut workspace = vec![S::ZERO; basis.workspace_len()];
        basis.transfer_into(&material, &mut workspace, &mut transfer).map_err(fault)?;
        let mut d = self.project(pair)?;
        let mut buffer = vec![S::ZERO; basis.scene_len()];
        let mut lengths = vec![0; basis.azimuths()];
        let (mut samples, mut texels) = (Vec::new(), Vec::new());
        match way {
            Way::Linear(knots) | Way::Cubic(knots) => {
                let scene = basis.collapse_into(&d, &mut buffer[..]).map_err(fault)?;
                samples = vec![S::ZERO; scene.sampled_len(knots)];
            }
            Way::Bilinear(size) if integers => texels = vec![0i16; size * size],
            Way::Bilinear(size) | Way::Nearest(size) => samples = vec![S::ZERO; size * size],
            _ => {}
        }
        Ok(Box::new(move || {
            let light = Light::new(black_box(&light));
            let relit = light.and_then(|light| basis.relight_into(&transfer, &light, &mut d));
            let done = relit.and_then(|()| match way {
                // The coefficients of the light, scaled.
                Way::NineTerms | Way::Eigen => Ok(()),
                Way::Within(share) => {
                    let tolerance = Tolerance::OfPeak(S::from_f64(share));
                    basis
                        .collapse_within(&d, tolerance, &mut lengths, &mut buffer[..])
                        .map(|found| seen(&found))
                }
                _ => basis.collapse_into(&d, &mut buffer[..]).and_then(|scene| match way {
                    Way::Linear(knots) | Way::Cubic(knots) => {
                        scene.sampled_into(knots, &mut samples[..]).map(|table| seen(&table))
                    }
                    Way::Bilinear(size) if integers => {
                        scene.bake_integers_into(size, &mut texels[..]).map(|map| seen(&map))
                    }
                    Way::Bilinear(size) | Way::Nearest(size) => {
                        scene.bake_into(size, &mut samples[..]).map(|map| seen(&map))
                    }
                    _ => {
                        seen(&scene);
                        Ok(())
                    }
                }),
            });
            black_box((done.is_ok(), &texels));
        }))
    }
}

impl Floats<f32> {
    /// The nine-term formula, and the number of its terms.
    pub fn nine_terms(&self, pair: &Pair) -> Result<(Shade<'_, f32>, usize)> {
        let (normals, formula) = (self.normals.view()?, pair.nine_terms()?);
        let terms = formula.coefficients().len();
        let shade = move |out: &mut [f32]| {
            black_box(black_box(&formula).shade_slice(black_box(normals), out).is_ok());
        };
        Ok((Box::new(shade), terms))
    }

    /// The polynomials at normals of other lengths. As in a renderer, all normals are scaled first,
    /// then all are shaded.
    pub fn scaled(&self, pair: &Pair, scaling: Scaling) -> Result<(Shade<'_, f32>, usize)> {
        let basis = self.basis()?;
        let d = self.project(pair)?;
        let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).map_err(fault)?;
        let raw = self.each.iter().zip(LENGTHS.iter().cycle());
        let raw: Vec<[f32; 3]> =
            raw.map(|(one, length)| one.components().map(|x| length * x)).collect();
        let mut axes = [0, 1, 2].map(|_| vec![0.0f32; raw.len()]);
        let shade = move |out: &mut [f32]| {
            let [xs, ys, zs] = &mut axes;
            let places = xs.iter_mut().zip(ys).zip(zs).zip(black_box(&raw));
            for (((to_x, to_y), to_z), &[x, y, z]) in places {
                let normal = match scaling {
                    Scaling::None | Scaling::Libm => Normal::with_mathematics::<Libm>(x, y, z),
                    Scaling::Single => Normal::with_mathematics::<SinglePrecision>(x, y, z),
                    Scaling::Tabled => Normal::with_mathematics::<Tabled>(x, y, z),
                    Scaling::Micromath => Normal::with_mathematics::<Micromath>(x, y, z),
                };
                if let Ok(normal) = normal {
                    [*to_x, *to_y, *to_z] = normal.components();
                }
            }
            let [x, y, z] = &axes;
            let done = Normals::new(x, y, z).and_then(|normals| scene.shade_slice(normals, out));
            black_box(done.is_ok());
        };
        Ok((Box::new(shade), basis.scene_len()))
    }

    /// A map of 16 bits, sampled with integers, and the exponent of its texels.
    pub fn map<'a>(
        &self,
        pair: &Pair,
        size: usize,
        normals: &'a [quantized::Normal<Q15>],
    ) -> Result<(Shade<'a, i32>, i32)> {
        let basis = self.basis()?;
        let d = self.project(pair)?;
        let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).map_err(fault)?;
        let map = scene.bake_integers_into(size, vec![0i16; size * size]).map_err(fault)?;
        let exponent = map.exponent();
        let shade = move |out: &mut [i32]| {
            for (out, &normal) in out.iter_mut().zip(black_box(normals)) {
                *out = map.bilinear(MapPoint::of_quantized(normal));
            }
        };
        Ok((Box::new(shade), exponent))
    }
}

/// Keeps a value from being optimized away.
fn seen<T>(found: &T) {
    black_box(found);
}
