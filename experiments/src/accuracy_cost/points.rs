//! Every setting with its errors, bytes and prices.

use super::bases::Bases;
use super::boards::Boards;
use super::images::Images;
use super::knobs::{Knob, settings};
use super::machine::{Machine, Price};
use super::materials::Scope;
use super::method::{Found, Spread, compare};
use super::model::{self, Row};
use super::setting::Setting;
use super::sizes::{Bytes, bytes};
use super::times::{Case, Cost, costs};
use super::wasm::Wasm;
use super::{Extent, Times};
use eigenshade_model::error::{Error, Result};
use indicatif::ProgressBar;
use std::collections::BTreeMap;

/// Rounds of the timed runs.
const ROUNDS: usize = 25;

/// A setting and its measurements.
#[derive(Clone, Debug)]
pub struct Point {
    /// The parameter that it varies.
    pub knob: &'static str,
    /// The setting.
    pub setting: Setting,
    /// The error of the method.
    pub method: Found,
    /// The error of the model at its degree and order, over all surfaces and maps; `None` in a
    /// quick run.
    pub model: Option<Spread>,
    /// Its bytes.
    pub bytes: Bytes,
    /// Times on this machine; `None` if nothing was timed.
    pub cost: Option<Cost>,
    /// Prices by machine.
    pub prices: BTreeMap<Machine, Price>,
}

/// Measures every setting, or a part of them.
///
/// # Errors
///
/// Never in practice.
pub fn measure(
    Extent { quick, times }: Extent<'_>,
    models: &[Row],
    progress: &ProgressBar,
) -> Result<Vec<Point>> {
    let knobs = settings(quick);
    let sizes: std::collections::BTreeSet<(usize, usize)> = knobs.iter().map(size).collect();
    let (boards, wasm) = (Boards::new()?, Wasm::new()?);
    let mut points: Vec<Option<Point>> = knobs.iter().map(|_| None).collect();
    let mut cases = Vec::new();
    progress.set_length(knobs.len() as u64);
    for (degree, order) in sizes {
        let scope = Scope::new(degree, order)?;
        let images = Images::new(&scope);
        let of_size = knobs.iter().enumerate().filter(|(_, knob)| size(knob) == (degree, order));
        let of_size: Vec<(usize, &Knob)> = of_size.collect();
        let bases = Bases::new(&scope, of_size.iter().map(|(_, knob)| knob.setting.recipe))?;
        for (k, knob) in of_size {
            let setting = knob.setting;
            let of = |error: Error| error.of(format_args!("`{setting}`"));
            let missing = || Error::new("a basis is missing", "report it");
            let table = bases.table(&setting.recipe).ok_or_else(missing)?;
            let method = compare(&setting, &table, &images).map_err(of)?;
            if matches!(times, Times::Measured) {
                let image = &images.images[method.typical];
                cases.push((k, Case::new(&setting, &table, image).map_err(of)?));
            }
            let mut prices: BTreeMap<Machine, Price> =
                Machine::BOARDS.map(|board| (board, boards.price(board, &setting))).into();
            prices.insert(Machine::Wasm, wasm.price(&setting));
            points[k] = Some(Point {
                knob: knob.knob,
                setting,
                model: (!quick).then(|| model::spread(models, degree, order)).flatten(),
                bytes: bytes(&setting, &table).map_err(of)?,
                method,
                cost: None,
                prices,
            });
            progress.inc(1);
        }
    }
    let mut points: Vec<Point> = points.into_iter().flatten().collect();
    if let Times::Kept(kept) = times {
        kept.give(&mut points)?;
        return Ok(points);
    }
    let (places, mut cases): (Vec<usize>, Vec<Case>) = cases.into_iter().unzip();
    let costs = costs(&mut cases, ROUNDS)?;
    // The nine-term formula is the first setting.
    let nine = places.iter().position(|&k| k == 0).map_or(f64::NAN, |first| costs[first].pixel);
    for (k, cost) in places.into_iter().zip(costs) {
        let price = Price {
            pixel: Some(cost.pixel / nine),
            light: Some(cost.light / nine),
            ..Price::default()
        };
        points[k].cost = Some(cost);
        points[k].prices.insert(Machine::Host, price);
    }
    Ok(points)
}

fn size(knob: &Knob) -> (usize, usize) {
    (knob.setting.recipe.degree, knob.setting.recipe.order)
}
