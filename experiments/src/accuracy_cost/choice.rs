//! Chooses settings: the cheapest below an error, and those that no other beats.

use super::machines::Machine;
use crate::sheet::Record;

/// The error limits.
pub const LIMITS: [f64; 7] = [0.1, 0.05, 0.01, 3e-3, 1e-3, 1e-4, 1e-5];
/// The number of pixels of the picture over which costs are summed.
pub const PIXELS: f64 = 96.0 * 96.0;
/// Times that differ by less than this factor count as equal, because runs differ by more.
pub const TIE: f64 = 1.05;

/// How often the light changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lighting {
    /// Never: only pixels are counted.
    Still,
    /// For every picture of [`PIXELS`].
    Moving,
}

/// The cost of a picture; `None` if it is not known.
pub fn picture(row: &Record, machine: &Machine, lighting: Lighting) -> Option<f64> {
    let pixels = PIXELS * machine.number(row, "pixel")?;
    match lighting {
        Lighting::Still => Some(pixels),
        Lighting::Moving => machine.number(row, "light").map(|light| pixels + light),
    }
}

/// Whether a setting has the shipped degree and order and takes normals of unit length; only such
/// settings have comparable errors.
pub fn is_comparable(row: &Record) -> bool {
    (row.text("degree"), row.text("order")) == ("9", "7") && row.text("knob") != "mathematics"
}

/// Whether a setting's error is below a limit. The error is that of the method, for 95 of 100 of
/// the lights on materials that its basis never saw. Below the paper's degree and order, the median
/// error of the model must be below the limit too.
pub fn suffices(row: &Record, limit: f64) -> bool {
    let is_below = |column| row.number(column).is_some_and(|error| error <= limit);
    let models = is_comparable(row) || is_below("model_median");
    models && row.text("knob") != "mathematics" && is_below("unseen_rms_most")
}

/// The cheapest setting whose error is below a limit. Times that differ by no more than [`TIE`]
/// count as equal; among those, the setting with the least error, of method or model, is chosen.
pub fn cheapest<'a>(
    rows: &'a [Record],
    machine: &Machine,
    lighting: Lighting,
    limit: f64,
) -> Option<&'a Record> {
    let able = rows.iter().filter(|row| suffices(row, limit));
    let priced: Vec<(&Record, f64)> =
        able.filter_map(|row| picture(row, machine, lighting).map(|cost| (row, cost))).collect();
    let least = priced.iter().map(|(_, cost)| *cost).fold(f64::INFINITY, f64::min);
    let most = if machine.board.is_some() { least } else { least * TIE };
    let errors = |row: &Record| {
        let [method, model] = ["unseen_rms_most", "model_median"]
            .map(|column| row.number(column).unwrap_or(f64::INFINITY));
        [method.max(model), method]
    };
    let tied = priced.into_iter().filter(|(_, cost)| *cost <= most).map(|(row, _)| row);
    tied.min_by(|a, b| {
        let [[worse_a, a], [worse_b, b]] = [errors(a), errors(b)];
        worse_a.total_cmp(&worse_b).then(a.total_cmp(&b))
    })
}

/// The points (cost, error) of the Pareto front, by rising cost. For each of them, every other
/// point that is as cheap or cheaper has a larger error.
pub fn pareto(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut points = points.to_vec();
    points.retain(|point| point.0.is_finite() && point.1.is_finite());
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut least = f64::INFINITY;
    points.retain(|point| {
        let is_better = point.1 < least;
        least = least.min(point.1);
        is_better
    });
    points
}
