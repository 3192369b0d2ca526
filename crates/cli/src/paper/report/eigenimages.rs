//! Fig. 3.

use super::Report;
use super::table::percent;
use crate::paper::study::{Modes, place};
use eigenshade_table::scene::Criterion;

/// The section, in Markdown.
pub fn section(report: &Report<'_>) -> String {
    let shares = Modes::BOTH.map(|modes| {
        let table = &report.study.tables[place(Criterion::ImageCentered, modes)];
        percent(table.energy_left(12) / table.summary.energy)
    });
    format!(
        "## Fig. 3: the first twelve eigenimages\n\n\
         ![The first twelve eigenimages](paper/eigenimages.png)\n\n\
         Image-centred, the constant first. Each has mean square 1 over the sphere; red is positive, blue negative, and only a \
         thin ring at the rim is beyond the colours' end. Below stand its m and its share of the variance within images. The \
         constant, two slopes, a bowl, two saddles, then slopes again with a rim of the other sign. +m and -m have one \
         eigenvalue, so each pair may be turned at will. Beyond these twelve lie {} of the variance. With the 1,000 modes \
         the first eleven look [the same](paper/eigenimages_1000.png); {} of the variance that these modes give lies beyond. Figures: \
         [eigenimages.csv](paper/eigenimages.csv), [eigenimages_1000.csv](paper/eigenimages_1000.csv).\n",
        shares[0], shares[1]
    )
}
