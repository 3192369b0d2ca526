//! Growth of times and bytes with degree, order, components, pixels, materials and maps.

use super::Times;
use super::bases::Bases;
use super::exponent;
use super::images::Image;
use super::knobs::{DEGREE, ORDER};
use super::materials::Scope;
use super::setting::{Recipe, Setting};
use super::times::{Case, Work, costs, interleaved};
use crate::multiplications::Multiplications;
use eigenshade::Material;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection;
use eigenshade_index::light;
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::fault;
use eigenshade_table::{Parts, Table};
use std::hint::black_box;

/// The number of components where it is fixed.
const COMPONENTS: usize = 50;
/// Rounds of the timed runs.
const ROUNDS: usize = 15;
/// Width and height in texels of the maps whose number grows.
const MAP: (usize, usize) = (64, 32);

/// The unit of multiplication counts.
pub const MULTIPLICATIONS: &str = "multiplications";

/// A measured quantity as a function of a growing one.
#[derive(Clone, Debug, PartialEq)]
pub struct Growth {
    /// The quantity that grows.
    pub quantity: &'static str,
    /// The quantity that is measured.
    pub measure: &'static str,
    /// "ns", "bytes" or [`MULTIPLICATIONS`].
    pub unit: &'static str,
    /// The measured points.
    pub points: Vec<(f64, f64)>,
    /// The theoretical exponent; for a time, the fitted exponent of its count.
    pub theory: Option<f64>,
    /// The reason for the theoretical exponent.
    pub reason: &'static str,
}

impl Growth {
    /// The fitted exponent; `None` for fewer than two points.
    #[must_use]
    pub fn exponent(&self) -> Option<f64> {
        exponent::fit(&self.points).map(|(_, exponent)| exponent)
    }
}

/// All growth curves.
///
/// # Errors
///
/// Never in practice.
pub fn all(quick: bool, times: Times<'_>) -> Result<Vec<Growth>> {
    let timed = matches!(times, Times::Measured);
    let mut growths = Vec::new();
    let degrees: &[usize] = if quick { &[4, 6, 9, 12, 16] } else { &[4, 6, 9, 12, 16, 24, 32] };
    let sizes: Vec<(usize, usize)> = degrees.iter().map(|&degree| (degree, ORDER)).collect();
    growths.extend(of_bases("degree", &sizes, timed)?);
    let orders: &[usize] = if quick { &[8, 12] } else { &[8, 12, 16, 24] };
    let sizes: Vec<(usize, usize)> = orders.iter().map(|&order| (DEGREE, order)).collect();
    growths.extend(of_bases("order", &sizes, timed)?);
    growths.extend(of_components(timed)?);
    growths.extend(of_materials(timed)?);
    growths.extend(of_pixels(timed)?);
    growths.extend(of_maps(timed));
    if let Times::Kept(kept) = times {
        for growth in growths.iter_mut().filter(|growth| growth.unit == "ns") {
            growth.points = kept.of(growth);
        }
    }
    growths.retain(|growth| !growth.points.is_empty());
    Ok(growths)
}

/// A measure, its unit, and its theoretical exponents in degree, order and components.
struct Theory {
    measure: &'static str,
    unit: &'static str,
    /// `None` if it is a count, or if the fitted exponent of the count serves as the theory.
    exponents: Option<[f64; 3]>,
    reasons: [&'static str; 3],
}

const EACH_DEGREE: &str = "a number for each component and each l from \\|m\\| on";
const PAIRS: &str = "pairs (p, q): (order / 2 + 1)²";
const FOLDED: &str = "the material is folded in: nothing of the order is left";
/// The reason where a count is the theory of a time.
const COUNTED: [&str; 3] = ["as its multiplications"; 3];

/// Bytes first, then counts, then times in the same order as the counts.
const THEORY: [Theory; 9] = [
    Theory {
        measure: "rows of the components",
        unit: "bytes",
        exponents: Some([1.0, 2.0, 1.0]),
        reasons: [
            "a row of pairs for each component and each l from \\|m\\| on",
            PAIRS,
            "rows for each",
        ],
    },
    Theory {
        measure: "polar integrals",
        unit: "bytes",
        exponents: Some([1.0, 2.0, 0.0]),
        reasons: ["one for each l and pair", PAIRS, "they are the light's and the material's"],
    },
    Theory {
        measure: "a folded material",
        unit: "bytes",
        exponents: Some([1.0, 0.0, 1.0]),
        reasons: [EACH_DEGREE, FOLDED, EACH_DEGREE],
    },
    Theory {
        measure: "a pixel",
        unit: MULTIPLICATIONS,
        exponents: None,
        reasons: [
            "polynomials of the azimuths that 50 components have: no more at a higher degree, but longer ones",
            "the same: longer polynomials, of as many azimuths",
            "polynomials of an azimuth are summed; azimuths grow as the root",
        ],
    },
    Theory {
        measure: "a new light",
        unit: MULTIPLICATIONS,
        exponents: None,
        reasons: [
            "the folded material's numbers, and every component's polynomial",
            "every component's polynomial: the rest is folded in",
            "rows and a polynomial for each",
        ],
    },
    Theory {
        measure: "a new material",
        unit: MULTIPLICATIONS,
        exponents: None,
        reasons: [EACH_DEGREE, PAIRS, "rows for each, and the polar integrals of all"],
    },
    Theory { measure: "a pixel", unit: "ns", exponents: None, reasons: COUNTED },
    Theory { measure: "a new light", unit: "ns", exponents: None, reasons: COUNTED },
    Theory { measure: "a new material", unit: "ns", exponents: None, reasons: COUNTED },
];

fn of_bases(quantity: &'static str, sizes: &[(usize, usize)], timed: bool) -> Result<Vec<Growth>> {
    let mut tables = Vec::new();
    for &(degree, order) in sizes {
        let scope = Scope::seen(degree, order)?;
        let recipe = Recipe::first(degree, order, COMPONENTS);
        let bases = Bases::new(&scope, [recipe])?;
        let size = if quantity == "degree" { degree } else { order };
        if let Some(table) = bases.table(&recipe) {
            tables.push((size, recipe, table, image(&scope)));
        }
    }
    measured(quantity, usize::from(quantity != "degree"), &tables, timed)
}

fn of_components(timed: bool) -> Result<Vec<Growth>> {
    let scope = Scope::seen(DEGREE, ORDER)?;
    let recipes = [10, 25, 50, 100, 200].map(|count| Recipe::first(DEGREE, ORDER, count));
    let bases = Bases::new(&scope, recipes)?;
    let tables = recipes.iter().filter_map(|recipe| {
        let table = bases.table(recipe)?;
        Some((recipe.components?, *recipe, table, image(&scope)))
    });
    measured("components", 2, &tables.collect::<Vec<_>>(), timed)
}

/// An image of the first light on the first material.
fn image(scope: &Scope) -> Image {
    Image {
        light: scope.lights.entries[0].luminance(),
        material: scope.seen.entries[0].luminance(),
        seen: true,
        reference: Vec::new(),
        peak: 0.0,
    }
}

type Made = (usize, Recipe, Table, Image);

fn measured(
    quantity: &'static str,
    place: usize,
    tables: &[Made],
    timed: bool,
) -> Result<Vec<Growth>> {
    let mut points = [const { Vec::new() }; THEORY.len()];
    for (size, _, table, _) in tables {
        let parts = Parts::new(table);
        let owned = OwnedBasis::<f32>::new(table);
        let folded = owned.basis().map_err(fault)?.transfer_len();
        let rows = parts.factors.len() + parts.terms.len();
        let bytes = [rows, parts.polar.len(), folded].map(|count| count * size_of::<f32>());
        let Multiplications { pixel, relight, collapse, transfer, .. } =
            Multiplications::of(table)?;
        let counted = bytes.into_iter().chain([pixel, relight + collapse, transfer]);
        for (points, count) in points.iter_mut().zip(counted) {
            points.push((*size as f64, count as f64));
        }
    }
    if timed {
        let mut cases = Vec::new();
        for (_, recipe, table, image) in tables {
            cases.push(Case::new(&Setting::of(*recipe), table, image)?);
        }
        let owned: Vec<_> = tables.iter().map(|made| OwnedBasis::<f32>::new(&made.2)).collect();
        let mut folds = Vec::new();
        for (owned, (.., image)) in owned.iter().zip(tables) {
            folds.push(folding(owned, image, 1)?);
        }
        let folds = least(folds);
        let costs = costs(&mut cases, ROUNDS)?;
        for (((size, ..), cost), fold) in tables.iter().zip(costs).zip(folds) {
            let times = [cost.pixel, cost.light, fold];
            for (points, time) in points.iter_mut().skip(6).zip(times) {
                points.push((*size as f64, time));
            }
        }
    }
    let counted = points.clone();
    let growth = THEORY.iter().zip(points).enumerate().map(|(k, (theory, points))| Growth {
        quantity,
        measure: theory.measure,
        unit: theory.unit,
        points,
        theory: match (theory.unit, theory.exponents) {
            ("ns", _) => exponent::fit(&counted[k - 3]).map(|(_, exponent)| exponent),
            (_, exponents) => exponents.map(|exponents| exponents[place]),
        },
        reason: theory.reasons[place],
    });
    Ok(growth.collect())
}

/// The least time of each work in nanoseconds: other activity of the machine only adds time.
fn least(works: Vec<Work<'_>>) -> Vec<f64> {
    let least = |times: &Vec<f64>| times.iter().copied().fold(f64::INFINITY, f64::min);
    interleaved(works, ROUNDS).iter().map(least).collect()
}

/// Transfers `count` materials.
fn folding<'a>(owned: &'a OwnedBasis<f32>, image: &Image, count: usize) -> Result<Work<'a>> {
    let basis = owned.basis().map_err(fault)?;
    let material: Vec<f32> = image.material.iter().map(|&value| value as f32).collect();
    let order = basis.order();
    Material::new(order, &material).map_err(fault)?;
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut transfers = vec![vec![0.0; basis.transfer_len()]; count];
    Ok(Box::new(move || {
        for transfer in &mut transfers {
            let done = Material::new(order, black_box(&material))
                .and_then(|material| basis.transfer_into(&material, &mut workspace, transfer));
            black_box(done.is_ok());
        }
        black_box(&transfers);
    }))
}

fn of_materials(timed: bool) -> Result<Vec<Growth>> {
    let scope = Scope::seen(DEGREE, ORDER)?;
    let recipe = Recipe::first(DEGREE, ORDER, COMPONENTS);
    let Some(table) = Bases::new(&scope, [recipe])?.table(&recipe) else { return Ok(Vec::new()) };
    let image = image(&scope);
    let owned = OwnedBasis::<f32>::new(&table);
    let length = owned.basis().map_err(fault)?.transfer_len();
    let counts = [1usize, 4, 16, 64, 256];
    let held = counts.map(|n| (n as f64, (n * length * size_of::<f32>()) as f64));
    let mut folds = Vec::new();
    for count in counts.into_iter().filter(|_| timed) {
        folds.push(folding(&owned, &image, count)?);
    }
    let times = counts.iter().map(|&n| n as f64).zip(least(folds)).collect();
    let reason = "each has a transfer of its own";
    let growth = |measure, unit, points| Growth {
        quantity: "materials",
        measure,
        unit,
        points,
        theory: Some(1.0),
        reason,
    };
    Ok(vec![growth("transfers", "bytes", held.to_vec()), growth("folding", "ns", times)])
}

fn of_pixels(timed: bool) -> Result<Vec<Growth>> {
    let scope = Scope::seen(DEGREE, ORDER)?;
    let recipe = Recipe::first(DEGREE, ORDER, COMPONENTS);
    let Some(table) = Bases::new(&scope, [recipe])?.table(&recipe) else { return Ok(Vec::new()) };
    let across = [16usize, 32, 64, 128, 256];
    let pixels = across.map(|n| n * n);
    let held = pixels.map(|n| (n as f64, (n * size_of::<f32>()) as f64));
    let mut times = Vec::new();
    if timed {
        let owned = OwnedBasis::<f32>::new(&table);
        let image = image(&scope);
        let mut shader =
            eigenshade_shading::shader::Shader::new(owned.basis().map_err(fault)?, usize::MAX);
        shader.project((DEGREE, &image.light), (ORDER, &image.material))?;
        let scene = shader.scene()?;
        let mut works: Vec<Work<'_>> = Vec::new();
        for count in pixels {
            let normals = eigenshade_shading::shader::OwnedNormals::<f32>::new(
                &super::shading::hemisphere(count),
            );
            let (scene, mut out) = (&scene, vec![0.0; count]);
            works.push(Box::new(move || {
                let normals = black_box(&normals).view().ok();
                let done = normals.map(|normals| scene.shade_slice(normals, &mut out));
                black_box((done.is_some_and(|done| done.is_ok()), &out));
            }));
        }
        times = pixels.iter().map(|&n| n as f64).zip(least(works)).collect();
    }
    let growth = proportional("pixels", "each pixel is its own");
    Ok(vec![growth("a picture's f32", "bytes", held.to_vec()), growth("shading", "ns", times)])
}

/// A measure that is proportional to a quantity.
fn proportional(
    quantity: &'static str,
    reason: &'static str,
) -> impl Fn(&'static str, &'static str, Vec<(f64, f64)>) -> Growth {
    move |measure, unit, points| Growth {
        quantity,
        measure,
        unit,
        points,
        theory: Some(1.0),
        reason,
    }
}

fn of_maps(timed: bool) -> Vec<Growth> {
    let counts = [1usize, 2, 4, 8, 16];
    let numbers = 3 * light::count(DEGREE) * size_of::<f64>();
    let held = counts.map(|n| (n as f64, (n * numbers) as f64));
    let (width, height) = MAP;
    let texels = (0..width * height).map(|k| [1.0 + (k % 7) as f32, 1.0, (k % 3) as f32]);
    let mut times = Vec::new();
    if let Ok(map) = EnvironmentMap::new(width, height, texels.collect())
        && timed
    {
        let works = counts.map(|count| -> Work<'_> {
            let map = &map;
            Box::new(move || {
                for _ in 0..count {
                    black_box(projection::project(black_box(map), DEGREE));
                }
            })
        });
        times = counts.iter().map(|&n| n as f64).zip(least(works.into())).collect();
    }
    let growth = proportional("maps", "each map is projected by itself");
    vec![growth("coefficients", "bytes", held.to_vec()), growth("projection", "ns", times)]
}
