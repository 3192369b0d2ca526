//! What a pixel and a new light take on this machine, in one run with the nine-term formula.

use super::images::Image;
use super::nine_terms;
use super::setting::{Format, Scaling, Setting, Way};
use super::shading::{LENGTHS, hemisphere, scaled};
use crate::integer_shader;
use crate::median::median;
use crate::owned_basis::OwnedBasis;
use crate::owned_quantised::{Integer, OwnedQuantised};
use crate::shader::{OwnedNormals, fault};
use eigenshade::{
    Basis, Light, MapPoint, Material, Normal, Q15, Q31, Scalar, Tolerance, quantised,
};
use eigenshade_generator::error::{Error, Result};
use eigenshade_table::{Table, quantise};
use std::hint::black_box;
use std::time::Instant;

/// Pixels of a run.
const PIXELS: usize = 4096;
/// A run of new lights is repeated to take at least so long, seconds.
const SHORTEST: f64 = 3e-5;

/// Medians, nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// A pixel.
    pub pixel: f64,
    /// A new light on a folded material, up to the first pixel.
    pub light: f64,
}

/// Something to be timed.
pub type Work<'a> = Box<dyn FnMut() + 'a>;

/// A setting ready to be timed.
pub struct Case {
    way: Way,
    scaling: Scaling,
    numbers: Numbers,
    /// Room for the lengths of a scene within a tolerance.
    lengths: Vec<u16>,
}

enum Numbers {
    Double(Floats<f64>),
    Single(Floats<f32>),
    Maps(Floats<f32>, Vec<quantised::Normal<Q15>>),
    Q31(Integers<Q31>),
    Q15(Integers<Q15>),
}

struct Floats<S> {
    basis: OwnedBasis<S>,
    degree: usize,
    light: Vec<S>,
    transfer: Vec<S>,
    d: Vec<S>,
    normals: OwnedNormals<S>,
    each: Vec<Normal<S>>,
    nine: [f64; 9],
}

struct Integers<Q> {
    basis: OwnedQuantised<Q>,
    degree: usize,
    light: (Vec<Q>, i32),
    transfer: (Vec<Q>, Vec<i16>),
    d: (Vec<i32>, i32),
    normals: Vec<quantised::Normal<Q>>,
}

impl Case {
    /// The setting on one image.
    ///
    /// # Errors
    ///
    /// A table that has no form in the setting's numbers.
    pub fn new(setting: &Setting, table: &Table, image: &Image) -> Result<Self> {
        let numbers = match (setting.format, setting.way) {
            (Format::F64, _) => Numbers::Double(Floats::new(table, image)?),
            (Format::F32, _) => Numbers::Single(Floats::new(table, image)?),
            (Format::Q15, Way::Bilinear(_)) => {
                let normals = integer_shader::normals(&hemisphere(PIXELS))?;
                Numbers::Maps(Floats::new(table, image)?, normals)
            }
            (Format::Q31, _) => Numbers::Q31(Integers::new(table, image)?),
            (Format::Q15, _) => Numbers::Q15(Integers::new(table, image)?),
        };
        let lengths = vec![0; table.gram.degree + 1];
        Ok(Self { way: setting.way, scaling: setting.scaling, numbers, lengths })
    }

    /// All pixels, and a new light.
    fn works(&mut self) -> Result<[Work<'_>; 2]> {
        let lengths = &mut self.lengths;
        match &self.numbers {
            Numbers::Double(floats) => {
                Ok([floats.pixels(self.way, lengths)?, floats.relit(self.way)?])
            }
            Numbers::Single(floats) => {
                let pixels = match (self.way, self.scaling) {
                    (Way::NineTerms, _) => floats.nine_terms(),
                    (way, Scaling::None) => floats.pixels(way, lengths)?,
                    (_, Scaling::Libm) => floats.scaled(Scaling::Libm)?,
                    (_, Scaling::Single) => floats.scaled(Scaling::Single)?,
                    (_, Scaling::Tabled) => floats.scaled(Scaling::Tabled)?,
                    (_, Scaling::Micromath) => floats.scaled(Scaling::Micromath)?,
                };
                Ok([pixels, floats.relit(self.way)?])
            }
            Numbers::Maps(floats, normals) => floats.maps(self.way, normals),
            Numbers::Q31(integers) => integers.works(),
            Numbers::Q15(integers) => integers.works(),
        }
    }
}

impl<S: Scalar> Floats<S> {
    fn new(table: &Table, image: &Image) -> Result<Self> {
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
        let nine = nine_terms::coefficients(&image.light, image.material[0]);
        let each = normals.each()?;
        Ok(Self { degree, light, transfer, d, normals, each, nine, basis: owned })
    }

    fn basis(&self) -> Result<Basis<'_, S>> {
        self.basis.basis().map_err(fault)
    }

    fn pixels<'a>(&'a self, way: Way, lengths: &'a mut [u16]) -> Result<Work<'a>> {
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

    /// A new light: d, then what a pixel reads.
    fn relit(&self, way: Way) -> Result<Work<'_>> {
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
                // Its coefficients are those of the light, scaled.
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

impl Floats<f32> {
    fn nine_terms(&self) -> Work<'_> {
        let c = self.nine.map(|value| value as f32);
        let mut out = vec![0.0; PIXELS];
        let axes: [Vec<f32>; 3] =
            [0, 1, 2].map(|axis| self.each.iter().map(|one| one.components()[axis]).collect());
        Box::new(move || {
            let axes = black_box(&axes).each_ref().map(Vec::as_slice);
            nine_terms::shade(black_box(&c), axes, &mut out);
            black_box(&out);
        })
    }

    fn scaled(&self, scaling: Scaling) -> Result<Work<'_>> {
        let basis = self.basis()?;
        let scene = basis.collapse_into(&self.d, vec![0.0; basis.scene_len()]).map_err(fault)?;
        let lengths = LENGTHS.iter().cycle();
        let raw = self.each.iter().zip(lengths);
        let raw: Vec<[f32; 3]> =
            raw.map(|(one, length)| one.components().map(|x| length * x)).collect();
        let mut out = vec![0.0; PIXELS];
        let mut axes = [0, 1, 2].map(|_| vec![0.0f32; PIXELS]);
        // As a renderer would: scaled first, then all at once.
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

    /// Maps of 16 bits, looked up with integers.
    fn maps<'a>(
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

impl<Q: Integer> Integers<Q> {
    fn new(table: &Table, image: &Image) -> Result<Self> {
        let (degree, order) = (table.gram.degree, table.gram.order);
        let own = |numbers: &[i32]| numbers.iter().map(|&n| Q::of(n)).collect::<Vec<Q>>();
        let basis = OwnedQuantised::new(table, Q::FORMAT.tolerance())
            .map_err(|error| Error::new(error.to_string(), "take another format"))?;
        let view = basis.view().map_err(fault)?;
        let ((_, light), (_, material)) = image.within(degree, order);
        let (mantissas, exponents) = quantise::material(order, material, Q::FORMAT);
        let mantissas = own(&mantissas);
        let material = quantised::Material::new(order, &exponents, &mantissas).map_err(fault)?;
        let (mantissas, exponent) = quantise::row(light, Q::FORMAT.bits(), i64::MAX);
        let light = (own(&mantissas), i32::from(exponent));
        let mut workspace = vec![Q::Wide::default(); view.workspace_len()];
        let mut transfer = (vec![Q::default(); view.transfer_len()], vec![0; view.profiles()]);
        view.fold_into(&material, &mut workspace, &mut transfer.0, &mut transfer.1)
            .map_err(fault)?;
        let mut d = (vec![0; view.components()], 0);
        let folded = quantised::Transfer::new(&transfer.0, &transfer.1);
        let as_light = quantised::Light::new(degree, light.1, &light.0).map_err(fault)?;
        d.1 = view.relight_into(&folded, &as_light, &mut d.0).map_err(fault)?;
        let normals = integer_shader::normals(&hemisphere(PIXELS))?;
        Ok(Self { degree, light, transfer, d, normals, basis })
    }

    fn works(&self) -> Result<[Work<'_>; 2]> {
        let view = self.basis.view().map_err(fault)?;
        let (mantissas, exponent) = (&self.d.0, self.d.1);
        let scene =
            view.collapse_into(mantissas, exponent, vec![0; view.scene_len()]).map_err(fault)?;
        let mut out = vec![0; PIXELS];
        let pixels = Box::new(move || {
            for (out, &normal) in out.iter_mut().zip(black_box(&self.normals)) {
                *out = scene.shade(normal);
            }
            black_box(&out);
        });
        let mut d = mantissas.clone();
        let mut buffer = vec![0; view.scene_len()];
        let light = Box::new(move || {
            let transfer = quantised::Transfer::new(&self.transfer.0, &self.transfer.1);
            let light = quantised::Light::new(self.degree, self.light.1, black_box(&self.light.0));
            let done = light
                .and_then(|light| view.relight_into(&transfer, &light, &mut d))
                .and_then(|exponent| view.collapse_into(&d, exponent, &mut buffer[..]).map(|_| ()));
            black_box((done.is_ok(), &buffer));
        });
        Ok([pixels, light])
    }
}

/// What has been looked at is not optimised away.
fn seen<T>(found: &T) {
    black_box(found);
}

/// Medians over interleaved rounds, of each case.
///
/// # Errors
///
/// None in truth.
pub fn costs(cases: &mut [Case], rounds: usize) -> Result<Vec<Cost>> {
    let mut works = Vec::new();
    for case in cases.iter_mut() {
        let [pixels, mut light] = case.works()?;
        // Once to warm up, then to see how long it takes.
        light();
        let start = Instant::now();
        light();
        let once = start.elapsed().as_secs_f64().max(1e-9);
        let repeats = (SHORTEST / once).ceil().clamp(1.0, 1e4) as u32;
        works.push((pixels, light, repeats, [Vec::new(), Vec::new()]));
    }
    for _ in 0..rounds {
        for (pixels, light, repeats, [of_pixel, of_light]) in &mut works {
            let start = Instant::now();
            pixels();
            of_pixel.push(1e9 * start.elapsed().as_secs_f64() / PIXELS as f64);
            let start = Instant::now();
            for _ in 0..*repeats {
                light();
            }
            of_light.push(1e9 * start.elapsed().as_secs_f64() / f64::from(*repeats));
        }
    }
    let costs = works
        .iter()
        .map(|(_, _, _, [pixel, light])| Cost { pixel: median(pixel), light: median(light) });
    Ok(costs.collect())
}
