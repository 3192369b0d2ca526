//! The materials of the total error: no table is made of any of them.

use crate::accuracy_cost::scope::{projected, published, windowed};
use eigenshade_generator::material::brdf::{Ggx, OrenNayar, Surface};
use eigenshade_model::database::Materials;
use eigenshade_model::error::Result;
use eigenshade_model::shipped;
use eigenshade_model::source::Gloss;

/// Roughnesses of GGX, between those of `tables/inputs/pbr-materials.toml`.
const ROUGHNESSES: [f64; 9] = [0.22, 0.28, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95];
/// σ of Oren and Nayar, between those of the same file.
const DEVIATIONS: [f64; 3] = [0.1, 0.27, 0.43];
const METAL: f64 = 0.8;
const DIELECTRIC: f64 = 0.04;
/// The albedo of the matte base of dielectrics, and of the surfaces of Oren and Nayar.
const ALBEDO: f64 = 0.7;

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

/// Materials that have a row together.
pub struct Group {
    pub name: &'static str,
    pub count: usize,
    pub has: fn(&Subject) -> bool,
}

/// The groups. A check integrates the materials of the last two only.
pub const GROUPS: [Group; 8] = [
    Group { name: "metal", count: 9, has: |one| one.kind == Kind::Metal },
    Group { name: "dielectric", count: 9, has: |one| one.kind == Kind::Dielectric },
    Group { name: "gltf", count: 18, has: |one| one.gltf.is_some() },
    Group { name: "matte", count: 3, has: |one| one.kind == Kind::Matte },
    Group { name: "measured", count: 47, has: |one| one.kind == Kind::Measured },
    Group { name: ALL, count: 68, has: |_| true },
    Group { name: "few gltf", count: 3, has: |one| FEW[..3].contains(&&*one.surface.name) },
    Group { name: "few others", count: 2, has: |one| FEW[3..].contains(&&*one.surface.name) },
];
/// The name of the largest group.
pub const ALL: &str = "all";
/// The materials of a check: those of glTF, a matte one and a measured one.
const FEW: [&str; 5] =
    ["metal-0.28", "dielectric-0.45", "dielectric-0.75", "oren-nayar-0.27", "purple-paint"];

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gltf {
    pub roughness: f64,
    pub f0: f64,
    pub albedo: f64,
}

pub struct Subject {
    pub kind: Kind,
    pub surface: Surface,
    pub gltf: Option<Gltf>,
    /// Its lobe, if sources pay.
    pub gloss: Option<Gloss>,
}

impl Gltf {
    pub fn surface(self, name: String) -> Result<Surface> {
        let Self { roughness, f0, albedo } = self;
        Ok(Surface::gray(name, Box::new(Ggx::new(roughness, f0, albedo)?)))
    }
}

/// The materials of a check.
pub fn few() -> Result<Vec<Subject>> {
    let mut few = all()?;
    few.retain(|one| FEW.contains(&&*one.surface.name));
    Ok(few)
}

pub fn all() -> Result<Vec<Subject>> {
    let mut subjects = Vec::new();
    let metal = (Kind::Metal, "metal", METAL, 0.0);
    let dielectric = (Kind::Dielectric, "dielectric", DIELECTRIC, ALBEDO);
    for (kind, name, f0, albedo) in [metal, dielectric] {
        for roughness in ROUGHNESSES {
            let gltf = Gltf { roughness, f0, albedo };
            let surface = gltf.surface(format!("{name}-{roughness}"))?;
            let (reflectance, albedo) = ([f0; 3], [albedo; 3]);
            let gloss = shiny(Gloss { roughness, reflectance, grazing: [1.0; 3], albedo });
            subjects.push(Subject { kind, surface, gltf: Some(gltf), gloss });
        }
    }
    for sigma in DEVIATIONS {
        let brdf = Box::new(OrenNayar::new(ALBEDO, sigma)?);
        let surface = Surface::gray(format!("oren-nayar-{sigma}"), brdf);
        subjects.push(Subject { kind: Kind::Matte, surface, gltf: None, gloss: None });
    }
    let unseen = shipped::unseen_materials()?.entries;
    let glosses = shipped::glosses()?;
    for surface in published()? {
        if unseen.iter().all(|one| one.name != surface.name) {
            continue;
        }
        let fitted = glosses.iter().find(|one| one.name == surface.name);
        let gloss = fitted.and_then(|one| shiny(one.gloss));
        subjects.push(Subject { kind: Kind::Measured, surface, gltf: None, gloss });
    }
    Ok(subjects)
}

/// The gloss if sources pay.
fn shiny(gloss: Gloss) -> Option<Gloss> {
    Some(gloss).filter(Gloss::needs_sources)
}

/// The coefficients at these orders. As shipped, those of measured materials have a window.
pub fn coefficients(subjects: &[Subject], orders: &[usize]) -> Vec<Materials> {
    let surfaces: Vec<&Surface> = subjects.iter().map(|subject| &subject.surface).collect();
    let mut all = projected(&surfaces, orders);
    for (named, subject) in all.iter_mut().flat_map(|one| one.entries.iter_mut().zip(subjects)) {
        if subject.kind == Kind::Measured {
            *named = windowed(named.clone());
        }
    }
    all
}
