//! The materials of the total error: no table is made of any of them.

use crate::material_errors::windowed;
use eigenshade_generator::material::brdf::{Ggx, Measure, OrenNayar, Surface};
use eigenshade_generator::material::published_fits;
use eigenshade_model::database::{Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::Sheet;
use eigenshade_shading::{parallel, shipped};

/// Roughnesses of GGX, between those of `tables/inputs/pbr-materials.toml`.
const ROUGHNESSES: [f64; 9] = [0.22, 0.28, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95];
/// σ of Oren and Nayar, between those of the same file.
const DEVIATIONS: [f64; 3] = [0.1, 0.27, 0.43];
/// The reflectance of metals.
const METAL: f64 = 0.8;
/// The reflectance of dielectrics.
const DIELECTRIC: f64 = 0.04;
/// The albedo of the matte base of dielectrics, and of the surfaces of Oren and Nayar.
const ALBEDO: f64 = 0.7;

/// A kind of material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// GGX without a matte base, of roughness 0.22 to 0.95.
    Metal,
    /// GGX over a matte base, as in glTF, of the same roughnesses.
    Dielectric,
    /// Oren and Nayar.
    Matte,
    /// The materials in color that `tables/color.toml` does not list.
    Measured,
}

/// Several kinds by the name that they have together in the file.
pub const GROUPS: [(&str, &[Kind]); 6] = [
    ("metal", &[Kind::Metal]),
    ("dielectric", &[Kind::Dielectric]),
    ("gltf", &[Kind::Metal, Kind::Dielectric]),
    ("matte", &[Kind::Matte]),
    ("measured", &[Kind::Measured]),
    ("all", &ALL),
];
/// All kinds.
pub const ALL: [Kind; 4] = [Kind::Metal, Kind::Dielectric, Kind::Matte, Kind::Measured];

/// The parameters of a glTF material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gltf {
    pub roughness: f64,
    pub f0: f64,
    pub albedo: f64,
}

/// A material.
pub struct Subject {
    pub kind: Kind,
    pub surface: Surface,
    /// Its parameters, if it is a glTF material.
    pub gltf: Option<Gltf>,
}

impl Gltf {
    /// The gray surface with these parameters.
    pub fn surface(self, name: String) -> Result<Surface> {
        let Self { roughness, f0, albedo } = self;
        Ok(Surface::gray(name, Box::new(Ggx::new(roughness, f0, albedo)?)))
    }
}

/// The materials of these kinds.
pub fn of_kinds(kinds: &[Kind]) -> Result<Vec<Subject>> {
    let mut subjects = Vec::new();
    for (kind, name, f0, albedo) in
        [(Kind::Metal, "metal", METAL, 0.0), (Kind::Dielectric, "dielectric", DIELECTRIC, ALBEDO)]
    {
        for roughness in ROUGHNESSES {
            let gltf = Gltf { roughness, f0, albedo };
            let surface = gltf.surface(format!("{name}-{roughness}"))?;
            subjects.push(Subject { kind, surface, gltf: Some(gltf) });
        }
    }
    for sigma in DEVIATIONS {
        let brdf = Box::new(OrenNayar::new(ALBEDO, sigma)?);
        let surface = Surface::gray(format!("oren-nayar-{sigma}"), brdf);
        subjects.push(Subject { kind: Kind::Matte, surface, gltf: None });
    }
    let text = include_bytes!("../../../../tables/inputs/merl-abc.csv");
    let sheet = Sheet::parse(text.to_vec(), "tables/inputs/merl-abc.csv".as_ref(), "name,kd_r,..")?;
    let unseen = shipped::unseen_materials()?.entries;
    let mut measured = published_fits::of_sheet(&sheet)?.unwrap_or_default();
    measured.retain(|surface| unseen.iter().any(|one| one.name == surface.name));
    let subject = |surface| Subject { kind: Kind::Measured, surface, gltf: None };
    subjects.extend(measured.into_iter().map(subject));
    subjects.retain(|subject| kinds.contains(&subject.kind));
    Ok(subjects)
}

/// The coefficients at each of these orders, made as the shipped ones are: those of measured
/// materials have a window.
pub fn coefficients(subjects: &[Subject], orders: &[usize]) -> Vec<Materials> {
    let project = |k: usize| -> Vec<Named> {
        let Subject { kind, surface, .. } = &subjects[k];
        let projected = surface.project_orders(orders, Measure::Projected).into_iter();
        let finish = |named| if *kind == Kind::Measured { windowed(named) } else { named };
        projected.map(|one| finish(one.material)).collect()
    };
    let projected = parallel::map(subjects.len(), &(), project);
    let of_order = |(k, &order): (usize, &usize)| {
        let entries = projected.iter().map(|of_subject| of_subject[k].clone()).collect();
        Materials { order, entries }
    };
    orders.iter().enumerate().map(of_order).collect()
}
