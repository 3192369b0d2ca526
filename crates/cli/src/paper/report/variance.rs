//! Fig. 2.

use super::Report;
use super::table::{percent, table};
use crate::number::grouped;
use crate::paper::variance::SURFACES;
use eigenshade_index::mode;

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
    format!(
        "## Fig. 2: the variance of the modes\n\n\
         ![Variance of each mode](paper/variance.svg)\n\n\
         One chart where the paper has three, one for each of its surfaces: they are outlined, with their numbers of modes. As \
         there, the variance is that of E_lop^mq itself over the sphere's normals, summed over m: no coefficient enters, of \
         neither the lights nor the materials. A material of order o \
         passes degrees up to about o; beyond, the variance falls by orders of magnitude.\n\n\
         ![Variance beyond each degree](paper/variance_beyond.svg)\n\n{}\n\
         All three of the paper's cuts leave out the same share. Figures: [variance.csv](paper/variance.csv), \
         [variance_beyond.csv](paper/variance_beyond.csv).\n",
        table(["surface", "l up to", "modes", "variance beyond", "beyond one degree less"], &rows)
    )
}
