//! The section about Fig. 2.

use super::Report;
use super::table::{percent, table};
use crate::paper::study::{DEGREE, ORDER};
use crate::paper::variance::{FURTHER, SURFACES};
use eigenshade_cli::output::number::grouped;
use eigenshade_index::mode;

/// Shares are nearly the same if none is more than this many times another.
const SAME: f64 = 1.1;

/// The section, in Markdown.
pub fn section(report: &Report<'_>) -> String {
    let rows: Vec<[String; 5]> = SURFACES
        .iter()
        .map(|&(order, degree, name)| {
            let beyond = report.variance.beyond(order);
            [
                name.into(),
                degree.to_string(),
                grouped(mode::total(degree, order)),
                percent(beyond[degree]),
                percent(beyond[degree - 1]),
            ]
        })
        .collect();
    let cuts = SURFACES.map(|(order, degree, _)| report.variance.beyond(order)[degree]);
    let low = cuts.into_iter().fold(f64::INFINITY, f64::min);
    let high = cuts.into_iter().fold(0.0, f64::max);
    let verdict = if high <= SAME * low { "nearly the same share" } else { "different shares" };
    // Only where there are enough degrees beyond l = o + 2.
    let passed = (1..ORDER).map(|o| report.variance.of_order_beyond(o, o + 2)).fold(0.0, f64::max);
    let further = report.variance.further.into_iter().fold(0.0, f64::max);
    format!(
        "## Fig. 2: the variance of the modes\n\n\
         ![Variance of each mode](paper/variance.svg)\n\n\
         One chart where the paper has three, one for each of its surfaces: they are outlined, with their numbers of modes. As \
         there, the variance is that of E_lop^mq itself over the sphere's normals, summed over m: no coefficient enters, of \
         neither the lights nor the materials. A mode passes degrees up to about its o: of the modes of one o from 1 to {}, \
         at most {} of the variance lies beyond l = o + 2.\n\n\
         ![Variance beyond each degree](paper/variance_beyond.svg)\n\n{}\n\
         The paper's three cuts leave out {verdict}, {} to {}. Shares are of the variance to degree {DEGREE}; of that to degree \
         {FURTHER} at most {} lies beyond {DEGREE}, for any of the three. Figures: [variance.csv](paper/variance.csv), \
         [variance_beyond.csv](paper/variance_beyond.csv).\n",
        ORDER - 1,
        percent(passed),
        table(["surface", "l up to", "modes", "variance beyond", "beyond one degree less"], &rows),
        percent(low),
        percent(high),
        percent(further)
    )
}
