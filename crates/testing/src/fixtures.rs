//! Scenes, lights, materials and normals shared by several tests.

use crate::oracle::Numbers;
use crate::{largest, largest_difference};
use eigenshade::{Basis, Light, Material, Normal};
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::reference::DirectSum;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, light, material};
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

/// The root of the repository.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The scene `tables/NAME.toml` with every available component.
pub fn shipped(name: &str) -> Loaded {
    let path = Path::new(ROOT).join(format!("tables/{name}.toml"));
    let mut loaded = scene_file::load(&path).expect("a shipped scene");
    loaded.scene.basis.components = Some(usize::MAX);
    loaded
}

/// The table `tables/NAME.bin`.
pub fn shipped_table(name: &str) -> Table {
    let path = Path::new(ROOT).join(format!("tables/{name}.bin"));
    eigenshade_table::decode(&std::fs::read(path).expect("a shipped table")).expect("a table")
}

/// A scene of these lights and materials at their degree and order, with every component and with
/// polynomials that are accurate to the last bits.
pub fn scene(lights: Lights, materials: Materials) -> Loaded {
    let mut loaded = shipped("curet");
    loaded.scene.light.degree = lights.degree;
    loaded.scene.material.order = materials.order;
    loaded.scene.basis.profile_tolerance = 1e-13;
    Loaded { lights, materials, ..loaded }
}

/// The table of a scene.
pub fn table(loaded: &Loaded) -> Table {
    basis::build(&loaded.scene, &loaded.lights, &loaded.materials).expect("a table")
}

/// The captured lights up to this degree.
pub fn captured(degree: usize) -> Lights {
    let path = Path::new(ROOT).join("tables/inputs/lights.csv");
    read_lights(path, Some(degree)).expect("the shipped lights")
}

/// The measured materials up to this order.
pub fn measured(order: usize) -> Materials {
    let path = Path::new(ROOT).join("tables/inputs/materials.csv");
    read_materials(path, Some(order)).expect("the shipped materials")
}

/// Gray coefficients with a name.
pub fn named(name: impl Into<String>, coefficients: Vec<f64>) -> Named {
    Named { name: name.into(), rgb: [coefficients.clone(), coefficients.clone(), coefficients] }
}

/// Lights with random coefficients that decrease with the degree, around a positive mean.
pub fn lights(degree: usize, count: usize, numbers: &mut Numbers) -> Lights {
    let mut one = |k: usize| {
        let coefficients = light::indices(degree)
            .map(|(l, _)| if l == 0 { 3.0 + numbers.next() } else { numbers.next() / l as f64 });
        named(format!("light-{k}"), coefficients.collect())
    };
    Lights { degree, entries: (0..count).map(&mut one).collect() }
}

/// Materials with random coefficients that decrease with the order, around a matte material.
pub fn materials(order: usize, count: usize, numbers: &mut Numbers) -> Materials {
    let mut one = |k: usize| {
        let coefficients = material::indices(order).map(|(o, p, q)| {
            if o == 0 { 1.5 + 0.5 * numbers.next() } else { numbers.next() / (o + p + q) as f64 }
        });
        named(format!("material-{k}"), coefficients.collect())
    };
    Materials { order, entries: (0..count).map(&mut one).collect() }
}

/// Slants that cover the edge cases.
pub const SLANTS: [f64; 7] = [0.0, 1e-9, 1e-5, 0.7, 1.3, FRAC_PI_2 - 1e-9, FRAC_PI_2];

/// The normal along a vector of the visible hemisphere.
pub fn normal(vector: [f64; 3]) -> Normal {
    let [x, y, z] = vector.map(|component| component as f32);
    Normal::new(x, y, z).expect("visible")
}

/// The components of normals, a list for each axis.
pub fn axes(normals: &[Normal]) -> [Vec<f32>; 3] {
    [0, 1, 2].map(|axis| normals.iter().map(|normal| normal.components()[axis]).collect())
}

/// d for a light and a material, which fit the basis.
pub fn projected(basis: &Basis<'_>, light: &[f32], material: &[f32]) -> Vec<f32> {
    let light = Light::new(light).expect("coefficients of a light");
    let material = Material::new(material).expect("coefficients of a material");
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut d = vec![0.0; basis.components()];
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("it fits");
    d
}

/// Normals of each slant at `tilts` tilts.
pub fn normals(slants: &[f64], tilts: usize) -> Vec<[f64; 3]> {
    let tilt = |k: usize| 2.0 * PI * (k as f64 + 0.3) / tilts as f64;
    let at = |alpha: f64, beta: f64| {
        let z = if alpha == FRAC_PI_2 { 0.0 } else { alpha.cos() };
        [alpha.sin() * beta.cos(), alpha.sin() * beta.sin(), z]
    };
    slants.iter().flat_map(|&alpha| (0..tilts).map(move |k| at(alpha, tilt(k)))).collect()
}

/// Normals of a sphere's picture and their weights, which sum to 1: Gauss-Legendre in z, equal
/// steps around.
pub fn rule(heights: usize, tilts: usize) -> Vec<([f64; 3], f64)> {
    let at = |(z, weight): (f64, f64)| {
        let sine = ((1.0 - z) * (1.0 + z)).sqrt();
        (0..tilts).map(move |k| {
            let (y, x) = (2.0 * PI * k as f64 / tilts as f64).sin_cos();
            ([sine * x, sine * y, z], 2.0 * z * weight / tilts as f64)
        })
    };
    gauss_legendre(heights, 0.0, 1.0).into_iter().flat_map(at).collect()
}

/// Normals of these z, each a golden angle on from the one before.
pub fn spiral(heights: impl IntoIterator<Item = f64>) -> Vec<[f64; 3]> {
    let at = |(k, z): (usize, f64)| {
        let (sine, tilt) = ((1.0 - z * z).sqrt(), 2.399_963 * k as f64);
        [sine * tilt.cos(), sine * tilt.sin(), z]
    };
    heights.into_iter().enumerate().map(at).collect()
}

/// A portable float map of these texels, whose rows are given from the top.
pub fn pfm(width: usize, texels: &[[f32; 3]]) -> Vec<u8> {
    let mut bytes = format!("PF\n{width} {}\n-1.0\n", texels.len() / width).into_bytes();
    for row in texels.chunks(width).rev() {
        bytes.extend(row.iter().flatten().flat_map(|value| value.to_le_bytes()));
    }
    bytes
}

/// Normals that each stand for an equal part of a picture of a sphere.
pub fn of_equal_areas(count: usize) -> Vec<[f64; 3]> {
    spiral((0..count).map(|k| ((k as f64 + 0.5) / count as f64).sqrt()))
}

/// The normals of a sphere that fills a picture of this width, one for each pixel inside.
pub fn disc(width: usize) -> Vec<[f64; 3]> {
    let along = |k: usize| (2 * k + 1) as f64 / width as f64 - 1.0;
    let pixels = (0..width * width).map(|k| (along(k % width), -along(k / width)));
    let inside = pixels.filter(|(x, y)| x * x + y * y < 1.0);
    inside.map(|(x, y)| [x, y, (1.0 - x * x - y * y).sqrt()]).collect()
}

/// A light, a material, and their irradiance at each normal.
pub type Image = (Vec<f64>, Vec<f64>, Vec<f64>);

/// The images of all lights on all materials by the direct sum, in luminance: sorted by material,
/// then light.
pub fn direct_images(lights: &Lights, materials: &Materials, normals: &[[f64; 3]]) -> Vec<Image> {
    let reference = DirectSum::new(lights.degree, materials.order);
    let modes: Vec<_> = normals.iter().map(|&normal| reference.at(normal)).collect();
    let mut images = Vec::new();
    for material in &materials.entries {
        let material = material.luminance();
        let scattered: Vec<_> = modes.iter().map(|modes| modes.scatter(&material)).collect();
        for light in &lights.entries {
            let light = light.luminance();
            let seen = modes.iter().zip(&scattered).map(|(at, of)| at.irradiance(&light, of));
            let seen = seen.collect();
            images.push((light, material.clone(), seen));
        }
    }
    images
}

/// The largest error of the whole basis in f64, by the host, against the direct sum, over the scene's lights and
/// materials. Each error is relative to the image's peak.
pub fn reconstruction_error(loaded: &Loaded, table: &Table) -> f64 {
    let projector = Projector::new(table);
    let normals = normals(&SLANTS, 12);
    let images = direct_images(&loaded.lights, &loaded.materials, &normals);
    let eigenimages = projector.0.eigenimages(&normals);
    largest(images.iter().map(|(light, material, expected)| {
        let found = eigenimages.reconstruct(&projector.project(light, material));
        let peak = largest(expected.iter().copied());
        let error = largest_difference(&found, expected);
        // A black image must stay black.
        if peak > 0.0 { error / peak } else { error }
    }))
}

/// A scene with the standard criterion.
pub fn standard(mut loaded: Loaded) -> Loaded {
    loaded.scene.basis.criterion = Criterion::Standard;
    loaded
}

/// A table evaluated in f64 by the host.
pub struct Projector(pub Evaluator<Table>);

impl Projector {
    pub fn new(table: &Table) -> Self {
        Self(Evaluator::new(table.clone()))
    }

    /// d for a light and a material.
    pub fn project(&self, light: &[f64], material: &[f64]) -> Vec<f64> {
        self.0.project(light, material).expect("a table that projects")
    }

    /// The mean image plus Σ d_i U_i at unit normals.
    pub fn shade(&self, d: &[f64], normals: &[[f64; 3]]) -> Vec<f64> {
        self.0.eigenimages(normals).reconstruct(d)
    }

    /// U_i at unit normals, without the mean image.
    pub fn eigenimage(&self, number: usize, normals: &[[f64; 3]]) -> Vec<f64> {
        self.0.eigenimages(normals).eigenimage(number)
    }
}
