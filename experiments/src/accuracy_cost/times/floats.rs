//! Prepares a setting in floats for timing.

use super::{PIXELS, Work};
use crate::accuracy_cost::images::Image;
use crate::accuracy_cost::setting::{Scaling, Way};
use crate::accuracy_cost::shading::{LENGTHS, hemisphere, scaled};
use eigenshade::{
    Basis, Light, MapPoint, Material, NineTerms, Normal, Q15, Scalar, Tolerance, quantised,
};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, fault};
use eigenshade_table::Table;
use std::hint::black_box;

pub(super) struct Floats<S> {
    basis: OwnedBasis<S>,
    degree: usize,
    light: Vec<S>,
    transfer: Vec<S>,
    d: Vec<S>,
    normals: OwnedNormals<S>,
    each: Vec<Normal<S>>,
    nine_terms: NineTerms<f32>,
}

impl Floats<f32> {
    pub(super) fn nine_terms(&self) -> Result<Work<'_>> {
        let normals = self.normals.view()?;
        let mut out = vec![0.0; PIXELS];
        Ok(Box::new(move || {
            let done = black_box(&self.nine_terms).shade_slice(black_box(normals), &mut out);
            black_box((done.is_ok(), &out));
        }))
    }

    pub(super) fn scaled(&self, scaling: Scaling) -> Result<Work<'_>> {
        let basis = self.basis()?;
        let scene = basis.collapse_into(&self.d, vec![0.0; basis.scene_len()]).map_err(fault)?;
        let lengths = LENGTHS.iter().cycle();
        let raw = self.each.iter().zip(lengths);
        let raw: Vec<[f32; 3]> =
            raw.map(|(one, length)| one.components().map(|x| length * x)).collect();
        let mut out = vec![0.0; PIXELS];
        let mut axes = [0, 1, 2].map(|_| vec![0.0f32; PIXELS]);
        // As in a renderer: all normals are scaled first, then all are shaded.
        Ok(Box::new(move || {
            let [xs, ys, zs] = &mut axes;
            let places = xs.iter_mut().zip(ys).zip(zs).zip(black_box(&raw));
            for (((to_x, to_y), to_z), &[x, y, z]) in places {
                if let Ok(normal) = scaled(scaling, x, y, z) {
                    [*to_x, *to_y, *to_z] = normal.components();
                }
            }
            let [x, y, z] = &axes;
            let done = eigenshade::Normals::new(x, y, z)
                .and_then(|normals| scene.shade_slice(normals, &mut out));
            black_box((done.is_ok(), &out));
        }))
    }

    /// Maps of 16 bits, sampled with integers.
    pub(super) fn maps<'a>(
        &'a self,
        way: Way,
        normals: &'a [quantised::Normal<Q15>],
    ) -> Result<[Work<'a>; 2]> {
        let Way::Bilinear(size) = way else {
            return Err(Error::new("maps of 16 bits are bilinear", "report it"));
        };
        let basis = self.basis()?;
        let scene = basis.collapse_into(&self.d, vec![0.0; basis.scene_len()]).map_err(fault)?;
        let map = scene.bake_integers_into(size, vec![0i16; size * size]).map_err(fault)?;
        let mut out = vec![0; PIXELS];
        let pixels = Box::new(move || {
            for (out, &normal) in out.iter_mut().zip(black_box(normals)) {
                *out = map.bilinear(MapPoint::of_quantised(normal));
            }
            black_box(&out);
        });
        let mut d = self.d.clone();
        let mut buffer = vec![0.0; basis.scene_len()];
        let mut texels = vec![0i16; size * size];
        let light = Box::new(move || {
            let light = Light::new(self.degree, black_box(&self.light));
            let done = light
                .and_then(|light| basis.relight_into(&self.transfer, &light, &mut d))
                .and_then(|()| basis.collapse_into(&d, &mut buffer[..]))
                .and_then(|scene| scene.bake_integers_into(size, &mut texels[..]).map(|_| ()));
            black_box((done.is_ok(), &texels));
        });
        Ok([pixels, light])
    }
}

impl<S: Scalar> Floats<S> {
    pub(super) fn new(table: &Table, image: &Image) -> Result<Self> {
        let rounded = |values: &[f64]| values.iter().map(|&v| S::from_f64(v)).collect::<Vec<S>>();
        let (degree, order) = (table.gram.degree, table.gram.order);
        let ((_, light), (_, material)) = image.within(degree, order);
        let (light, material) = (rounded(light), rounded(material));
        let owned = OwnedBasis::new(table);
        let basis = owned.basis().map_err(fault)?;
        let mut transfer = vec![S::ZERO; basis.transfer_len()];
        let mut d = vec![S::ZERO; basis.components()];
        let mut workspace = vec![S::ZERO; basis.workspace_len()];
        let folded = Material::new(order, &material).map_err(fault)?;
        basis.transfer_into(&folded, &mut workspace, &mut transfer).map_err(fault)?;
        let light_view = Light::new(degree, &light).map_err(fault)?;
        basis.relight_into(&transfer, &light_view, &mut d).map_err(fault)?;
        let normals = OwnedNormals::new(&hemisphere(PIXELS));
        let nine_terms = image.nine_terms()?;
        let each = normals.each()?;
        Ok(Self { degree, light, transfer, d, normals, each, nine_terms, basis: owned })
    }

    fn basis(&self) -> Result<Basis<'_, S>> {
        self.basis.basis().map_err(fault)
    }

    pub(super) fn pixels<'a>(&'a self, way: Way, lengths: &'a mut [u16]) -> Result<Work<'a>> {
        let basis = self.basis()?;
        let mut out = vec![S::ZERO; PIXELS];
        let buffer = vec![S::ZERO; basis.scene_len()];
        let scene = basis.collapse_into(&self.d, buffer).map_err(fault)?;
        let (normals, each) = (self.normals.view()?, &self.each);
        macro_rules! each_by {
            ($look_up:expr) => {
                Box::new(move || {
                    for (out, normal) in out.iter_mut().zip(black_box(each)) {
                        *out = $look_up(*normal);
                    }
                    black_box(&out);
                })
            };
        }
        Ok(match way {
            Way::Polynomial | Way::NineTerms => Box::new(move || {
                let done = scene.shade_slice(black_box(normals), &mut out);
                black_box((done.is_ok(), &out));
            }),
            Way::Within(share) => {
                let tolerance = Tolerance::OfPeak(S::from_f64(share));
                let buffer = vec![S::ZERO; basis.scene_len()];
                let lengths = &mut lengths[..basis.azimuths()];
                let (scene, _) =
                    basis.collapse_within(&self.d, tolerance, lengths, buffer).map_err(fault)?;
                Box::new(move || {
                    let done = scene.shade_slice(black_box(normals), &mut out);
                    black_box((done.is_ok(), &out));
                })
            }
            Way::Eigen => each_by!(|normal| basis.reconstruct(&self.d, normal).unwrap_or(S::ZERO)),
            Way::Linear(knots) | Way::Cubic(knots) => {
                let samples = vec![S::ZERO; scene.lookup_len(knots)];
                let table = scene.lookup_into(knots, samples).map_err(fault)?;
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
        })
    }

    /// A new light: d, then the data that a pixel reads.
    pub(super) fn relit(&self, way: Way) -> Result<Work<'_>> {
        let basis = self.basis()?;
        let mut d = self.d.clone();
        let mut buffer = vec![S::ZERO; basis.scene_len()];
        let mut lengths = vec![0; basis.azimuths()];
        let mut more = match way {
            Way::Linear(knots) | Way::Cubic(knots) => {
                let scene = basis.collapse_into(&self.d, buffer.clone()).map_err(fault)?;
                vec![S::ZERO; scene.lookup_len(knots)]
            }
            Way::Bilinear(size) | Way::Nearest(size) => vec![S::ZERO; size * size],
            _ => Vec::new(),
        };
        Ok(Box::new(move || {
            let light = Light::new(self.degree, black_box(&self.light));
            let relit = light.and_then(|light| basis.relight_into(&self.transfer, &light, &mut d));
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
                        scene.lookup_into(knots, &mut more[..]).map(|table| seen(&table))
                    }
                    Way::Bilinear(size) | Way::Nearest(size) => {
                        scene.bake_into(size, &mut more[..]).map(|map| seen(&map))
                    }
                    _ => {
                        black_box(scene);
                        Ok(())
                    }
                }),
            });
            black_box(done.is_ok());
        }))
    }
}

/// Keeps a value from being optimized away.
fn seen<T>(found: &T) {
    black_box(found);
}
