//! Growth of times, bytes and multiplications with degree, order, components, pixels, materials and
//! maps.

use super::bases::Bases;
use super::floats::Work;
use super::images::Pair;
use super::materials::Scope;
use super::setting::{Recipe, Setting};
use super::settings::{DEGREE, ORDER};
use super::sheet::Record;
use super::times::{Case, costs, hemisphere, least};
use crate::multiplications::Multiplications;
use eigenshade::Material;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection;
use eigenshade_index::light;
use eigenshade_model::database::Named;
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::{Parts, Table};
use std::hint::black_box;

/// The number of components where it is fixed.
const COMPONENTS: usize = 50;
/// Rounds of the timed runs.
const ROUNDS: usize = 15;
/// Width and height in texels of the maps whose number grows.
const MAP: (usize, usize) = (64, 32);

/// Exponents of bytes in theory: quantity, measure, exponent.
const THEORY: [(&str, &str, f64); 9] = [
    ("degree", "rows of the components", 1.0),
    ("order", "rows of the components", 2.0),
    ("components", "rows of the components", 1.0),
    ("degree", "polar integrals", 1.0),
    ("order", "polar integrals", 2.0),
    ("components", "polar integrals", 0.0),
    ("degree", "a folded material", 1.0),
    ("order", "a folded material", 0.0),
    ("components", "a folded material", 1.0),
];
/// Quantities to which all measures are proportional.
const PROPORTIONAL: [&str; 3] = ["materials", "pixels", "maps"];

/// A measured quantity as a function of a growing one.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The quantity that grows.
    pub quantity: String,
    /// The quantity that is measured.
    pub measure: String,
    /// "ns", "bytes" or "multiplications".
    pub unit: String,
    /// The measured points.
    pub points: Vec<(f64, f64)>,
    /// The theoretical exponent; for a time, the fitted exponent of its multiplications.
    pub theory: Option<f64>,
}

impl Curve {
    /// The fitted exponent; `None` for fewer than two points.
    pub fn exponent(&self) -> Option<f64> {
        power_law(&self.points).map(|(_, exponent)| exponent)
    }
}

/// a and b of y = a x^b, fitted in logarithms to the upper half of the points, where the highest
/// power dominates. `None` for fewer than two points.
pub fn power_law(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let upper = &points[points.len() / 2 - usize::from(points.len() == 3 || points.len() == 2)..];
    if upper.len() < 2 {
        return None;
    }
    let logs: Vec<(f64, f64)> = upper.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|log| log.0), mean(|log| log.1));
    let product: f64 = logs.iter().map(|log| (log.0 - x) * (log.1 - y)).sum();
    let square: f64 = logs.iter().map(|log| (log.0 - x).powi(2)).sum();
    (square > 0.0).then(|| ((y - product / square * x).exp(), product / square))
}

/// The curves of these rows.
pub fn curves(rows: &[Record]) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for row in rows {
        let [quantity, measure, unit] =
            ["quantity", "measure", "unit"].map(|column| row.text(column).to_owned());
        let value = row.number("counted").or(row.number("host_ns"));
        let Some(point) = row.number("size").zip(value) else { continue };
        let is_it = |one: &&mut Curve| {
            (&one.quantity, &one.measure, &one.unit) == (&quantity, &measure, &unit)
        };
        if let Some(curve) = curves.iter_mut().find(is_it) {
            curve.points.push(point);
        } else {
            curves.push(Curve { quantity, measure, unit, points: vec![point], theory: None });
        }
    }
    let theories = curves.iter().map(|curve| theory(curve, &curves)).collect::<Vec<_>>();
    curves.iter_mut().zip(theories).for_each(|(curve, theory)| curve.theory = theory);
    curves
}

fn theory(curve: &Curve, curves: &[Curve]) -> Option<f64> {
    let Curve { quantity, measure, unit, .. } = curve;
    if PROPORTIONAL.contains(&quantity.as_str()) {
        return Some(1.0);
    }
    if unit == "ns" {
        let is_count = |other: &&Curve| {
            (&other.quantity, &other.measure) == (quantity, measure)
                && other.unit == "multiplications"
        };
        return curves.iter().find(is_count)?.exponent();
    }
    let found = THEORY.iter().find(|(one, of, _)| (*one, *of) == (&**quantity, &**measure));
    found.map(|(.., exponent)| *exponent)
}

/// Collects measured rows.
struct Rows {
    rows: Vec<Record>,
    timed: bool,
}

impl Rows {
    /// Adds the rows of a curve.
    fn add(&mut self, names: [&str; 3], points: impl IntoIterator<Item = (usize, f64)>) {
        let [quantity, measure, unit] = names;
        for (size, value) in points {
            let mut row = Record::default();
            row.put("quantity", quantity);
            row.put("measure", measure);
            row.put("unit", unit);
            row.put("size", size);
            match unit {
                "ns" => row.measure("host_ns", value),
                _ => row.put("counted", value),
            }
            self.rows.push(row);
        }
    }

    /// The measures of these tables: bytes, multiplications, and times in the same order.
    fn of_tables(&mut self, quantity: &str, tables: &[Made]) -> Result<()> {
        let sizes = || tables.iter().map(|made| made.size);
        let mut counts: [Vec<usize>; 6] = Default::default();
        for Made { table, .. } in tables {
            let parts = Parts::new(table);
            let owned = OwnedBasis::<f32>::new(table);
            let folded = owned.basis().map_err(fault)?.transfer_len();
            let bytes = [parts.factors.len() + parts.terms.len(), parts.polar.len(), folded]
                .map(|count| count * size_of::<f32>());
            let Multiplications { pixel, relight, collapse, transfer, .. } =
                Multiplications::of(table)?;
            let of_table = bytes.into_iter().chain([pixel, relight + collapse, transfer]);
            counts.iter_mut().zip(of_table).for_each(|(counts, count)| counts.push(count));
        }
        let operations = ["a pixel", "a new light", "a new material"];
        let measures = ["rows of the components", "polar integrals", "a folded material"]
            .map(|measure| [quantity, measure, "bytes"])
            .into_iter()
            .chain(operations.map(|measure| [quantity, measure, "multiplications"]));
        for (names, counts) in measures.zip(counts) {
            self.add(names, sizes().zip(counts.into_iter().map(|count| count as f64)));
        }
        if self.timed {
            let owned: Vec<_> =
                tables.iter().map(|made| OwnedBasis::<f32>::new(&made.table)).collect();
            let (mut cases, mut folds) = (Vec::new(), Vec::new());
            for (Made { recipe, table, pair, .. }, owned) in tables.iter().zip(&owned) {
                cases.push(Case::new(&Setting::of(*recipe), table, pair)?);
                folds.push(folding(owned, pair, 1)?);
            }
            let folds = least(folds, ROUNDS);
            let costs = costs(&mut cases, ROUNDS)?;
            let [pixels, lights] =
                [0, 1].map(|kind| costs.iter().map(|cost| cost[kind]).collect::<Vec<f64>>());
            for (measure, times) in operations.into_iter().zip([pixels, lights, folds]) {
                self.add([quantity, measure, "ns"], sizes().zip(times));
            }
        }
        Ok(())
    }
}

/// A table of a size, and an image of it.
struct Made {
    size: usize,
    recipe: Recipe,
    table: Table,
    pair: Pair,
}

/// The tables of recipes of one degree and order.
fn made(recipes: &[(usize, Recipe)]) -> Result<Vec<Made>> {
    let Recipe { degree, order, .. } = recipes[0].1;
    let scope = Scope::seen(degree, order)?;
    let bases = Bases::new(&scope, recipes.iter().map(|(_, recipe)| *recipe))?;
    let [light, material] =
        [&scope.lights.entries[0], &scope.seen.entries[0]].map(Named::luminance);
    let pair = Pair { light, material };
    let one = |&(size, recipe): &(usize, Recipe)| {
        Ok(Made { size, recipe, table: bases.table(&recipe)?, pair: pair.clone() })
    };
    recipes.iter().map(one).collect()
}

/// All growth curves.
pub fn rows(quick: bool, timed: bool) -> Result<Vec<Record>> {
    let mut rows = Rows { rows: Vec::new(), timed };
    let first = |degree, order| Recipe::first(degree, order, COMPONENTS);
    let degrees = [4, 6, 9, 12, 16, 24, 32].into_iter().take(if quick { 5 } else { 7 });
    let of_degrees: Result<Vec<_>> = degrees.map(|l| made(&[(l, first(l, ORDER))])).collect();
    rows.of_tables("degree", &of_degrees?.into_iter().flatten().collect::<Vec<_>>())?;
    let orders = [8, 12, 16, 24].into_iter().take(if quick { 2 } else { 4 });
    let of_orders: Result<Vec<_>> = orders.map(|o| made(&[(o, first(DEGREE, o))])).collect();
    rows.of_tables("order", &of_orders?.into_iter().flatten().collect::<Vec<_>>())?;
    let counts = [10, 25, 50, 100, 200];
    let of_counts = made(&counts.map(|count| (count, Recipe::first(DEGREE, ORDER, count))))?;
    rows.of_tables("components", &of_counts)?;
    let Made { table, pair, .. } = &of_counts[2];
    let owned = OwnedBasis::<f32>::new(table);
    of_materials(&mut rows, &owned, pair)?;
    of_pixels(&mut rows, &owned, pair)?;
    of_maps(&mut rows)?;
    Ok(rows.rows)
}

/// Transfers `count` materials.
fn folding<'a>(owned: &'a OwnedBasis<f32>, pair: &Pair, count: usize) -> Result<Work<'a>> {
    let basis = owned.basis().map_err(fault)?;
    let material: Vec<f32> = pair.material.iter().map(|&value| value as f32).collect();
    Material::new(&material).map_err(fault)?;
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut transfers = vec![vec![0.0; basis.transfer_len()]; count];
    Ok(Box::new(move || {
        for transfer in &mut transfers {
            let done = Material::new(black_box(&material))
                .and_then(|material| basis.transfer_into(&material, &mut workspace, transfer));
            black_box(done.is_ok());
        }
        black_box(&transfers);
    }))
}

fn of_materials(rows: &mut Rows, owned: &OwnedBasis<f32>, pair: &Pair) -> Result<()> {
    let each = owned.basis().map_err(fault)?.transfer_len() * size_of::<f32>();
    let counts = [1usize, 4, 16, 64, 256];
    rows.add(["materials", "transfers", "bytes"], counts.map(|n| (n, (n * each) as f64)));
    if rows.timed {
        let folds = counts.map(|count| folding(owned, pair, count));
        let times = least(folds.into_iter().collect::<Result<_>>()?, ROUNDS);
        rows.add(["materials", "folding", "ns"], counts.into_iter().zip(times));
    }
    Ok(())
}

fn of_pixels(rows: &mut Rows, owned: &OwnedBasis<f32>, pair: &Pair) -> Result<()> {
    let counts = [16usize, 32, 64, 128, 256].map(|across| across * across);
    let bytes = counts.map(|n| (n, (n * size_of::<f32>()) as f64));
    rows.add(["pixels", "a picture's f32", "bytes"], bytes);
    if rows.timed {
        let mut shader = Shader::new(owned.basis().map_err(fault)?, usize::MAX);
        shader.project((DEGREE, &pair.light), (ORDER, &pair.material))?;
        let scene = shader.scene()?;
        let works = counts.map(|count| -> Work<'_> {
            let normals = OwnedNormals::<f32>::new(&hemisphere(count));
            let (scene, mut out) = (&scene, vec![0.0; count]);
            Box::new(move || {
                let normals = black_box(&normals).view().ok();
                let done = normals.map(|normals| scene.shade_slice(normals, &mut out));
                black_box((done.is_some_and(|done| done.is_ok()), &out));
            })
        });
        rows.add(["pixels", "shading", "ns"], counts.into_iter().zip(least(works.into(), ROUNDS)));
    }
    Ok(())
}

fn of_maps(rows: &mut Rows) -> Result<()> {
    let counts = [1usize, 2, 4, 8, 16];
    let each = 3 * light::count(DEGREE) * size_of::<f64>();
    rows.add(["maps", "coefficients", "bytes"], counts.map(|n| (n, (n * each) as f64)));
    if rows.timed {
        let (width, height) = MAP;
        let texels = (0..width * height).map(|k| [1.0 + (k % 7) as f32, 1.0, (k % 3) as f32]);
        let map = EnvironmentMap::new(width, height, texels.collect())?;
        let works = counts.map(|count| -> Work<'_> {
            let map = &map;
            Box::new(move || {
                for _ in 0..count {
                    black_box(projection::project(black_box(map), DEGREE));
                }
            })
        });
        rows.add(["maps", "projection", "ns"], counts.into_iter().zip(least(works.into(), ROUNDS)));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::power_law;

    #[test]
    fn powers_come_back() {
        let points: Vec<(f64, f64)> =
            (1..9).map(f64::from).map(|x| (x, 3.0 * x.powf(1.5))).collect();
        let (a, b) = power_law(&points).unwrap();
        assert!((a - 3.0).abs() < 1e-12 && (b - 1.5).abs() < 1e-12);
        assert!(power_law(&points[..2]).is_some() && power_law(&points[..1]).is_none());
        assert!(power_law(&[]).is_none());
    }
}
