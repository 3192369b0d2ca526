//! Errors of truncated sums and of tables against direct integration under environment maps.
//!
//! The error of a map is the rms over the sphere's normals and the three channels, relative to the
//! largest |I| of the direct integration over all of them.
//!
//! And errors of the runtime in floats against the direct sum over modes, with all components: GGX
//! dielectrics and metals of roughness 0.2 to 1 and a Lambertian under three captured maps.

use crate::accuracy_cost::errors::compare;
use crate::accuracy_cost::images::Images;
use crate::accuracy_cost::scope::{Scope, scene};
use crate::accuracy_cost::settings::{Format, Recipe, Setting, Way};
use crate::sphere::{self, Picture, Sphere};
use eigenshade_generator::basis;
use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::material::brdf::{Brdf, Measure, Part, Surface};
use eigenshade_index::{light, material};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_shading::sphere_rings::rings;
use eigenshade_shading::{parallel, shipped};
use eigenshade_table::Table;
use eigenshade_testing::glossy;
use indicatif::ProgressBar;

/// The widest spacing of normals in radians.
const WIDEST: f64 = 0.06;
/// Spacing of the normals, in widths of the narrowest lobe.
const SPACING: f64 = 1.25;
/// The number of normals integrated at a time.
const BATCH: usize = 16;

/// A surface under environment maps, integrated directly.
pub struct Reference<'a> {
    surface: &'a Surface,
    sphere: Sphere,
    /// The picture under each map.
    pictures: Vec<Picture>,
    /// The peak of each map.
    peaks: Vec<f64>,
}

/// The lights of these names, in order.
pub fn named<'a>(all: &Lights, names: impl Iterator<Item = &'a str>) -> Result<Lights> {
    let find = |name: &str| {
        let found = all.entries.iter().find(|light| light.name == name).cloned();
        found.ok_or_else(|| {
            let what = format!("no light has the name of the map `{name}`");
            Error::new(what, "make the light of the map with `eigenshade light`")
        })
    };
    Ok(Lights { degree: all.degree, entries: names.map(find).collect::<Result<_>>()? })
}

/// The color of a surface under a map, from that of each part.
pub fn color(parts: &[Part<'_>], of_parts: &[Vec<[f64; 3]>], map: usize) -> [f64; 3] {
    let of_channel =
        |c: usize| parts.iter().zip(of_parts).map(move |(p, i)| p.shares[c] * i[map][c]);
    [0, 1, 2].map(|c| of_channel(c).sum())
}

impl<'a> Reference<'a> {
    /// Integrates the surface.
    pub fn new(surface: &'a Surface, maps: &Surroundings, progress: &ProgressBar) -> Self {
        let parts = surface.parts();
        let brdfs: Vec<&dyn Brdf> = parts.iter().map(|part| part.brdf).collect();
        // The narrowest lobe is resolved.
        let width = brdfs.iter().map(|brdf| brdf.width()).fold(1.0, f64::min);
        let sphere = Sphere::new(rings((SPACING * width).min(WIDEST)));
        let batches: Vec<&[[f64; 3]]> = sphere.normals.chunks(BATCH).collect();
        progress.set_length(batches.len() as u64);
        let irradiance = |k: usize| maps.irradiance(&brdfs, batches[k], 1.0);
        let integrated = parallel::map(batches.len(), progress, irradiance).concat();
        let of_map = |map: usize| {
            [0, 1, 2].map(|c| integrated.iter().map(|image| color(&parts, image, map)[c]).collect())
        };
        let pictures: Vec<Picture> = (0..maps.maps()).map(of_map).collect();
        // A narrow lobe peaks where it mirrors the sun, which is between the normals of the rings.
        let mirrors: Vec<[f64; 3]> = (0..maps.maps()).map(|map| maps.mirror(map)).collect();
        let at_mirrors = maps.irradiance(&brdfs, &mirrors, 1.0);
        let largest = |(map, picture): (usize, &Picture)| {
            let values =
                picture.iter().flatten().copied().chain(color(&parts, &at_mirrors[map], map));
            values.fold(0.0, |most: f64, i| most.max(i.abs()))
        };
        let peaks = pictures.iter().enumerate().map(largest).collect();
        Self { surface, sphere, pictures, peaks }
    }

    /// The reference made of the surface's pictures, one for each map. Normals without weight count
    /// for peaks and worst pixels only.
    pub fn of_pictures(surface: &'a Surface, sphere: &Sphere, pictures: Vec<Picture>) -> Self {
        let peaks = pictures.iter().map(sphere::peak).collect();
        Self { surface, sphere: sphere.clone(), pictures, peaks }
    }

    /// The number of normals.
    pub fn normals(&self) -> usize {
        self.sphere.normals.len()
    }

    /// The error for each map of the direct sum (15) up to a degree and an order. `lights` are the
    /// projections of the maps and must reach the degree; `material` is that of the surface, of
    /// this order.
    pub fn of_sum(&self, lights: &Lights, size: (usize, usize), material: &Named) -> Vec<f64> {
        self.errors(self.sums(lights, size, material).into_iter())
    }

    /// [`of_sum`](Self::of_sum) and, for each map, the largest difference of a pixel in any
    /// channel, relative to the peak.
    pub fn of_sum_and_pixel(
        &self,
        lights: &Lights,
        size: (usize, usize),
        material: &Named,
    ) -> [Vec<f64>; 2] {
        let found = self.sums(lights, size, material);
        let pixel = |((found, expected), peak): ((&Picture, &Picture), &f64)| {
            let values = found.iter().flatten().zip(expected.iter().flatten());
            values.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / peak
        };
        let pixels = found.iter().zip(&self.pictures).zip(&self.peaks).map(pixel).collect();
        [self.errors(found.into_iter()), pixels]
    }

    /// The picture of the direct sum under each map.
    fn sums(
        &self,
        lights: &Lights,
        (degree, order): (usize, usize),
        material: &Named,
    ) -> Vec<Picture> {
        let count = light::count(degree);
        let channel = |c: usize| {
            let lights = lights.entries.iter().map(|light| &light.rgb[c][..count]);
            (lights.collect(), &material.rgb[c][..])
        };
        let images = self.sphere.direct((degree, order), &[0, 1, 2].map(channel));
        let maps = self.peaks.len();
        (0..maps).map(|map| [0, 1, 2].map(|c| images[c * maps + map].clone())).collect()
    }

    /// The error for each map of a table with all of its components, in f64.
    pub fn of_table(&self, lights: &Lights, table: &Table) -> Result<Vec<f64>> {
        let (degree, order) = (table.gram.degree, table.gram.order);
        let lights = lights.truncated(degree);
        let mut material = self.surface.project(order, Measure::Projected).material;
        for channel in &mut material.rgb {
            channel.truncate(material::count(order));
        }
        let basis = OwnedBasis::<f64>::new(table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, table.count());
        let normals = OwnedNormals::new(&self.sphere.normals);
        let pictures: Result<Vec<Picture>> = lights
            .entries
            .iter()
            .map(|light| shader.color((degree, light), (order, &material), &normals))
            .collect();
        Ok(self.errors(pictures?.into_iter()))
    }

    /// The first map under which the material is black.
    pub fn black(&self) -> Option<usize> {
        self.peaks.iter().position(|peak| *peak == 0.0)
    }

    /// The rms over normals and channels relative to the peak, by map.
    fn errors(&self, found: impl Iterator<Item = Picture>) -> Vec<f64> {
        let expected = self.pictures.iter().zip(&self.peaks);
        let error = |(found, (expected, peak))| self.sphere.apart(&found, expected) / peak;
        found.zip(expected).map(error).collect()
    }
}

/// Degrees and orders.
pub const SHAPES: [[usize; 2]; 5] = [[9, 7], [12, 12], [16, 16], [24, 24], [32, 32]];

/// Three captured maps: small lamps, a low sun, a soft sky.
const LIGHTS: [&str; 3] = ["studio", "sunset", "park"];

/// Writes the errors as CSV to standard output.
pub fn print(shapes: &[[usize; 2]]) {
    println!("degree,order,components,method,format,max,rms");
    for &[degree, order] in shapes {
        for Errors { components, method, format, largest, rms } in errors([degree, order]) {
            println!("{degree},{order},{components},{method},{format},{largest:.1e},{rms:.1e}");
        }
    }
}

/// Errors of the worst pair of a light and a material, as shares of the image's peak.
pub struct Errors {
    pub components: usize,
    pub method: &'static str,
    pub format: String,
    pub largest: f64,
    pub rms: f64,
}

/// The errors of each method and format at this degree and order.
pub fn errors([degree, order]: [usize; 2]) -> Vec<Errors> {
    let (table, mut lights, mut seen) = table([degree, order]);
    // Their lobes are too narrow for any order here.
    seen.entries.retain(|material| !material.name.ends_with("-0.1"));
    lights.entries.retain(|light| LIGHTS.contains(&light.name.as_str()));
    let unseen = Materials { order, entries: Vec::new() };
    let images = Images::new(&Scope { degree, order, lights, seen, unseen });
    // The number that `shade` uses.
    let knots = (64 * degree).next_power_of_two();
    let ways = [Way::Polynomial, Way::Eigen, Way::Cubic(knots)];
    let error = |format: Format, way, method| {
        let setting = Setting::of(Recipe::all(degree, order)).by(way).in_format(format);
        let errors = compare(&setting, &table, &images).expect("a basis in floats").seen;
        let (largest, rms) = (errors.largest.worst, errors.rms.worst);
        Errors { components: table.count(), method, format: format.to_string(), largest, rms }
    };
    let methods = || ways.into_iter().zip(["polynomial", "eigen", "sampled"]);
    let of = |format| methods().map(move |(way, method)| error(format, way, method));
    [Format::F32, Format::F64].into_iter().flat_map(of).collect()
}

/// The table of all components at this degree and order, with its lights and materials.
pub fn table([degree, order]: [usize; 2]) -> (Table, Lights, Materials) {
    let scene = scene(degree, order, usize::MAX).expect("the shipped scene");
    let mut materials = glossy::materials(order);
    let mut matte = vec![0.0; eigenshade_index::material::count(order)];
    matte[0] = 2.0;
    let rgb = [matte.clone(), matte.clone(), matte];
    materials.entries.push(Named { name: "lambertian".into(), rgb });
    let lights = shipped::lights().expect("the shipped lights").truncated(degree);
    let table = basis::build(&scene, &lights, &materials).expect("a table");
    (table, lights, materials)
}
