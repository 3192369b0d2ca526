//! The section about Fig. 3.

use super::Report;
use super::table::percent;
use crate::paper::eigenimages::{SCALE, SHOWN};
use crate::paper::shape::sequence;
use crate::paper::study::{Modes, place};
use eigenshade_table::scene::Criterion;

/// Two eigenimages look the same if their scalar product is at least this.
const SAME: f64 = 0.99;

/// The section, in Markdown.
pub fn section(report: &Report<'_>) -> String {
    let shares = Modes::BOTH.map(|modes| {
        let table = &report.study.tables[place(Criterion::ImageCentered, modes)];
        percent(table.energy_left(SHOWN) / table.summary.energy)
    });
    let found = report.eigenimages;
    let [outside, nearest] = found.beyond;
    let colours = if outside > 0.0 {
        format!(
            "{} of the discs, nowhere nearer the middle than {nearest:.3} of the radius, is beyond the colours' end",
            percent(outside)
        )
    } else {
        "nothing is beyond the colours' end".into()
    };
    let differs = |product: &f64| *product < SAME;
    let same = found.products.iter().position(differs).unwrap_or(found.products.len());
    let least = found.products.iter().take(same).copied().fold(1.0, f64::min);
    format!(
        "## Fig. 3: the first twelve eigenimages\n\n\
         ![The first twelve eigenimages](paper/eigenimages.png)\n\n\
         Image-centred, the constant first. Each has mean square 1 over the sphere; red is positive, blue negative, to \
         {SCALE} and -{SCALE}; {colours}. Below stand its m and its share of the variance within images. One after the other: \
         {}. +m and -m have one eigenvalue, so each pair may be turned at will. Beyond these twelve lie {} of the variance. \
         Of [those of the 1,000 modes](paper/eigenimages_1000.png) the first {same} are the same images: their scalar \
         products with these are {least:.3} or more. {} of the variance that these modes give lies beyond twelve. Figures: \
         [eigenimages.csv](paper/eigenimages.csv), [eigenimages_1000.csv](paper/eigenimages_1000.csv).\n",
        sequence(&found.shapes),
        shares[0],
        shares[1]
    )
}
