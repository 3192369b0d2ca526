//! Chooses the cheapest setting whose error is below a limit.

use super::knobs::{DEGREE, ORDER};
use super::machine::Machine;
use super::points::Point;
use super::setting::Scaling;

/// The error limits.
pub const LIMITS: [f64; 7] = [0.1, 0.05, 0.01, 3e-3, 1e-3, 1e-4, 1e-5];
/// The number of pixels of the picture over which costs are summed.
pub const FRAME: usize = 96 * 96;

/// Times that differ by less than this factor count as equal, because runs differ by more.
pub const TIE: f64 = 1.05;

/// How often the light changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lighting {
    /// Never: only pixels are counted.
    Still,
    /// For every picture of [`FRAME`] pixels.
    Moving,
}

/// The cost of a picture; `None` if it is not known.
#[must_use]
pub fn frame(point: &Point, machine: Machine, lighting: Lighting) -> Option<f64> {
    let price = point.prices.get(&machine)?;
    let pixels = FRAME as f64 * price.pixel?;
    match lighting {
        Lighting::Still => Some(pixels),
        Lighting::Moving => price.light.map(|light| pixels + light),
    }
}

/// Whether a setting's error is below a limit. The error is that of the method, for 95 of 100 of
/// the lights on materials that its basis never saw. Below the paper's degree and order, the median
/// error of the model must be below the limit too.
#[must_use]
pub fn suffices(point: &Point, limit: f64) -> bool {
    let recipe = point.setting.recipe;
    let models = (recipe.degree, recipe.order) == (DEGREE, ORDER)
        || point.model.is_some_and(|model| model.median <= limit);
    point.setting.scaling == Scaling::None && point.method.unseen.rms.most <= limit && models
}

/// The index of the cheapest setting whose error is below a limit. Times that differ by no more
/// than [`TIE`] count as equal; among those, the setting with the least error, of method or model,
/// is chosen.
#[must_use]
pub fn cheapest(
    points: &[Point],
    machine: Machine,
    lighting: Lighting,
    limit: f64,
) -> Option<usize> {
    let able = points.iter().enumerate().filter(|(_, point)| suffices(point, limit));
    let priced: Vec<_> = able
        .filter_map(|(k, point)| frame(point, machine, lighting).map(|cost| (k, cost)))
        .collect();
    let least = priced.iter().map(|(_, cost)| *cost).fold(f64::INFINITY, f64::min);
    let most = if machine.counts() { least } else { least * TIE };
    let errors = |k: usize| {
        let method = points[k].method.unseen.rms.most;
        let model = points[k].model.map_or(f64::INFINITY, |model| model.median);
        [method.max(model), method]
    };
    let tied = priced.into_iter().filter(|(_, cost)| *cost <= most).map(|(k, _)| k);
    tied.min_by(|&a, &b| {
        let [[worse_a, a], [worse_b, b]] = [errors(a), errors(b)];
        worse_a.total_cmp(&worse_b).then(a.total_cmp(&b))
    })
}
