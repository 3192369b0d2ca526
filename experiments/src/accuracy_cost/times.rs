//! Times of operations on this machine, in the same run as the nine-term formula, and the growth of
//! times, bytes and multiplications with degree, order, components, pixels, materials and maps.

use super::images::{Numbers, Pair, Work};
use super::numbers::numbers;
use super::scope::{Bases, Scope};
use super::settings::{DEGREE, ORDER, Recipe, Setting};
use crate::multiplications::Multiplications;
use crate::numbers::median;
use crate::sheet::Record;
use eigenshade::Material;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection;
use eigenshade_index::light;
use eigenshade_model::database::Named;
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::{Table, parts};
use eigenshade_testing::fixtures::spiral;
use std::hint::black_box;
use std::time::Instant;

/// Pixels per run.
pub const PIXELS: usize = 4096;
/// The least duration of a timing in seconds; shorter operations are repeated.
const SHORTEST: f64 = 3e-5;

/// A setting ready to be timed on one image.
pub struct Case {
    numbers: Box<dyn Numbers>,
    pair: Pair,
    /// Buffer for the lengths of a scene within a tolerance.
    lengths: Vec<u16>,
}

impl Case {
    pub fn new(setting: &Setting, table: &Table, pair: &Pair) -> Result<Self> {
        let numbers = numbers(setting, table, &hemisphere(PIXELS))?;
        let lengths = vec![0; setting.recipe.degree + 1];
        Ok(Self { numbers, pair: pair.clone(), lengths })
    }

    /// All pixels, and a new light.
    pub fn works(&mut self) -> Result<[Work<'_>; 2]> {
        self.numbers.works(&self.pair, &mut self.lengths)
    }
}

/// The median nanoseconds of a pixel and of a new light over interleaved rounds.
pub fn costs(works: Vec<[Work<'_>; 2]>, rounds: usize) -> Vec<[f64; 2]> {
    let times = interleaved(works.into_iter().flatten().collect(), rounds);
    let medians: Vec<f64> = times.iter().map(|times| median(times)).collect();
    medians.chunks_exact(2).map(|pair| [pair[0] / PIXELS as f64, pair[1]]).collect()
}

/// The least time of each work in nanoseconds: other activity of the machine only adds time.
pub fn least(works: Vec<Work<'_>>, rounds: usize) -> Vec<f64> {
    let least = |times: &Vec<f64>| times.iter().copied().fold(f64::INFINITY, f64::min);
    interleaved(works, rounds).iter().map(least).collect()
}

/// Nanoseconds of each work in each round. The works run one after the other, so that a temporary
/// slowdown of the machine affects all of them. Each first runs untimed, because the others have
/// replaced the contents of the cache.
fn interleaved(works: Vec<Work<'_>>, rounds: usize) -> Vec<Vec<f64>> {
    let timed = |work: &mut Work<'_>, repeats: u32| {
        let start = Instant::now();
        (0..repeats).for_each(|_| work());
        start.elapsed().as_secs_f64() / f64::from(repeats)
    };
    let mut works: Vec<_> = works
        .into_iter()
        .map(|mut work| {
            work();
            let once = timed(&mut work, 1).max(1e-9);
            let repeats = (SHORTEST / once).ceil().clamp(1.0, 1e4) as u32;
            (work, repeats, Vec::new())
        })
        .collect();
    for _ in 0..rounds {
        for (work, repeats, times) in &mut works {
            work();
            times.push(1e9 * timed(work, *repeats));
        }
    }
    works.into_iter().map(|(_, _, times)| times).collect()
}

/// Normals spread over the visible hemisphere.
pub fn hemisphere(count: usize) -> Vec<[f64; 3]> {
    spiral((0..count).map(|k| (k as f64 + 0.5) / count as f64))
}

/// The number of components where it is fixed.
const COMPONENTS: usize = 50;
const ROUNDS: usize = 15;
/// The quantities that grow: three of a table, then three to which all measures are proportional.
pub const QUANTITIES: [&str; 6] = ["degree", "order", "components", "materials", "pixels", "maps"];
/// Bytes of a table, with their exponents in theory against its degree, order and components.
const BYTES: [(&str, [f64; 3]); 3] = [
    ("rows of the components", [1.0, 2.0, 1.0]),
    ("polar integrals", [1.0, 2.0, 0.0]),
    ("a transferred material", [1.0, 0.0, 1.0]),
];
const OPERATIONS: [&str; 3] = ["a pixel", "a new light", "a new material"];

/// A measure, in "ns", "bytes" or "multiplications", as a function of a growing quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub quantity: String,
    pub measure: String,
    pub unit: String,
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

pub fn curves(rows: &[Record]) -> Vec<Curve> {
    let name = |row: &Record| ["quantity", "measure", "unit"].map(|one| row.text(one).to_owned());
    let point =
        |row: &Record| row.number("size").zip(row.number("counted").or(row.number("host_ns")));
    let curve = |of_curve: &[Record]| {
        let [quantity, measure, unit] = name(&of_curve[0]);
        let points = of_curve.iter().filter_map(point).collect();
        Curve { quantity, measure, unit, points, theory: None }
    };
    let mut curves: Vec<_> = rows.chunk_by(|a, b| name(a) == name(b)).map(curve).collect();
    let theories: Vec<_> = curves.iter().map(|curve| theory(curve, &curves)).collect();
    curves.iter_mut().zip(theories).for_each(|(curve, theory)| curve.theory = theory);
    curves
}

fn theory(curve: &Curve, curves: &[Curve]) -> Option<f64> {
    let Curve { quantity, measure, unit, .. } = curve;
    let Some(place) = QUANTITIES[..3].iter().position(|one| one == quantity) else {
        return Some(1.0);
    };
    if unit == "ns" {
        let count = (&**quantity, &**measure, "multiplications");
        let is_count = |other: &&Curve| (&*other.quantity, &*other.measure, &*other.unit) == count;
        return curves.iter().find(is_count)?.exponent();
    }
    BYTES.iter().find(|(one, _)| one == measure).map(|(_, exponents)| exponents[place])
}

fn records(
    [quantity, measure, unit]: [&str; 3],
    points: impl IntoIterator<Item = (usize, f64)>,
) -> impl Iterator<Item = Record> {
    points.into_iter().map(move |(size, value)| {
        let mut row = Record::default();
        row.put("quantity", quantity);
        row.put("measure", measure);
        row.put("unit", unit);
        row.put("size", size);
        match unit {
            "ns" => row.measure("host_ns", value),
            _ => row.put("counted", value),
        }
        row
    })
}

pub fn rows(quick: bool, timed: bool) -> Result<Vec<Record>> {
    let first = Recipe::first;
    let degrees = [4, 6, 9, 12, 16, 24, 32].map(|l| (l, first(l, ORDER, COMPONENTS)));
    let orders = [8, 12, 16, 24].map(|o| (o, first(DEGREE, o, COMPONENTS)));
    let counts = [10, 25, COMPONENTS, 100, 200].map(|count| (count, first(DEGREE, ORDER, count)));
    let [degrees, orders] =
        if quick { [&degrees[..3], &orders[..1]] } else { [&degrees[..], &orders[..]] };
    let mut rows = of_tables("degree", &made(degrees)?, timed)?;
    rows.extend(of_tables("order", &made(orders)?, timed)?);
    let tables = made(&counts)?;
    rows.extend(of_tables("components", &tables, timed)?);

    let Made { table, pair, .. } = &tables[2];
    let owned = OwnedBasis::new(table);
    let basis = owned.basis().map_err(fault)?;
    let new_materials = |count| new_materials(&owned, pair, count);
    let bytes = basis.transfer_len() * size_of::<f32>();
    let names = ["materials", "transfers", "transferring"];
    rows.extend(proportional(names, bytes, [1, 4, 16, 64, 256], timed, new_materials)?);

    let mut shader = Shader::new(basis, usize::MAX);
    shader.project(&pair.light, &pair.material)?;
    let scene = &shader.scene()?;
    let pixels = |count| -> Result<Work<'_>> {
        let normals = OwnedNormals::new(&hemisphere(count));
        let mut out = vec![0.0; count];
        Ok(Box::new(move || {
            let normals = black_box(&normals).view().ok();
            let done = normals.map(|normals| scene.shade_slice(normals, &mut out));
            black_box((done.is_some_and(|done| done.is_ok()), &out));
        }))
    };
    let sizes = [16usize, 32, 64, 128, 256].map(|across| across * across);
    let names = ["pixels", "a picture's f32", "shading"];
    rows.extend(proportional(names, size_of::<f32>(), sizes, timed, pixels)?);

    let (width, height) = (64, 32);
    let texels = (0..width * height).map(|k| [1.0 + (k % 7) as f32, 1.0, (k % 3) as f32]);
    let map = &EnvironmentMap::new(width, height, texels.collect())?;
    let maps = |count| -> Result<Work<'_>> {
        Ok(Box::new(move || {
            for _ in 0..count {
                black_box(projection::project(black_box(map), DEGREE));
            }
        }))
    };
    let bytes = 3 * light::count(DEGREE) * size_of::<f64>();
    let names = ["maps", "coefficients", "projection"];
    rows.extend(proportional(names, bytes, [1, 2, 4, 8, 16], timed, maps)?);
    Ok(rows)
}

/// A table of a size, and an image of it.
struct Made {
    size: usize,
    recipe: Recipe,
    table: Table,
    pair: Pair,
}

/// The tables of recipes, of which neighbors may have the same degree and order.
fn made(recipes: &[(usize, Recipe)]) -> Result<Vec<Made>> {
    let mut all = Vec::new();
    for of_scope in recipes.chunk_by(|(_, a), (_, b)| a.size() == b.size()) {
        let (degree, order) = of_scope[0].1.size();
        let scope = Scope::seen(degree, order)?;
        let bases = Bases::new(&scope, of_scope.iter().map(|(_, recipe)| *recipe))?;
        let [light, material] =
            [&scope.lights.entries[0], &scope.seen.entries[0]].map(Named::luminance);
        let pair = Pair { light, material };
        for &(size, recipe) in of_scope {
            all.push(Made { size, recipe, table: bases.table(&recipe)?, pair: pair.clone() });
        }
    }
    Ok(all)
}

/// Bytes and multiplications of these tables, and times.
fn of_tables(quantity: &str, tables: &[Made], timed: bool) -> Result<Vec<Record>> {
    let mut rows = Vec::new();
    let mut add = |unit, measures: [&str; 3], values: &[[f64; 3]]| {
        for (k, measure) in measures.into_iter().enumerate() {
            let points = tables.iter().zip(values).map(|(made, values)| (made.size, values[k]));
            rows.extend(records([quantity, measure, unit], points));
        }
    };
    let (mut bytes, mut multiplications) = (Vec::new(), Vec::new());
    for Made { table, .. } in tables {
        let parts = parts::floats(table);
        let Multiplications { pixel, relight, collapse, transfer, .. } =
            Multiplications::of(table)?;
        // A light multiplies each number of the transferred material once.
        let numbers = [parts.factors.len() + parts.terms.len(), parts.polar.len(), relight];
        bytes.push(numbers.map(|count| (count * size_of::<f32>()) as f64));
        multiplications.push([pixel, relight + collapse, transfer].map(|count| count as f64));
    }
    add("bytes", BYTES.map(|(measure, _)| measure), &bytes);
    add("multiplications", OPERATIONS, &multiplications);
    if timed {
        let owned: Vec<_> = tables.iter().map(|made| OwnedBasis::new(&made.table)).collect();
        let case = |made: &Made| Case::new(&Setting::of(made.recipe), &made.table, &made.pair);
        let mut cases = tables.iter().map(case).collect::<Result<Vec<_>>>()?;
        let transfers =
            owned.iter().zip(tables).map(|(owned, made)| new_materials(owned, &made.pair, 1));
        let transfers = least(transfers.collect::<Result<_>>()?, ROUNDS);
        let works = cases.iter_mut().map(Case::works).collect::<Result<_>>()?;
        let costs = costs(works, ROUNDS).into_iter().zip(transfers);
        let times: Vec<_> =
            costs.map(|([pixel, light], material)| [pixel, light, material]).collect();
        add("ns", OPERATIONS, &times);
    }
    Ok(rows)
}

/// The curves of a quantity: `bytes` for each, and the times of its operation.
fn proportional<'a>(
    [quantity, counted, operation]: [&str; 3],
    bytes: usize,
    sizes: [usize; 5],
    timed: bool,
    work: impl Fn(usize) -> Result<Work<'a>>,
) -> Result<Vec<Record>> {
    let counts = sizes.map(|size| (size, (size * bytes) as f64));
    let mut rows: Vec<Record> = records([quantity, counted, "bytes"], counts).collect();
    if timed {
        let times = least(sizes.into_iter().map(work).collect::<Result<_>>()?, ROUNDS);
        rows.extend(records([quantity, operation, "ns"], sizes.into_iter().zip(times)));
    }
    Ok(rows)
}

fn new_materials<'a>(owned: &'a OwnedBasis, pair: &Pair, count: usize) -> Result<Work<'a>> {
    let basis = owned.basis().map_err(fault)?;
    let material: Vec<f32> = pair.material.iter().map(|&value| value as f32).collect();
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
