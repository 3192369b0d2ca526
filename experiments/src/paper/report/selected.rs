//! The section about the cost of the paper's truncation.

use super::table::{percent, table};
use super::{COUNTS, Report};
use crate::paper::study::SELECTED;
use eigenshade_cli::output::number::grouped;

/// An increase of a mean error by at most this factor counts as negligible.
const FREE: f64 = 1.02;

/// The section, in Markdown.
pub fn section(report: &Report<'_>) -> String {
    let selected = report.selected;
    let rows: Vec<[String; 4]> = COUNTS
        .iter()
        .map(|&count| {
            let [all, some] = [0, 2].map(|basis| report.errors.mean[basis][count]);
            let times = format!("{:.2}", some / all);
            [count.to_string(), percent(all), percent(some), times]
        })
        .collect();
    let header = ["components", "all modes", "1,000 modes", "ratio"];
    let [all, some] = [0, 2].map(|basis| &report.errors.mean[basis]);
    // The number of components whose error is no less than that of the truncated sum.
    let as_bad = all.iter().take_while(|error| **error >= selected.image_error[1]).count();
    let times = selected.image_error[1] / selected.floor;
    let costs = |count: &usize| some[*count] > FREE * all[*count];
    let free = (0..all.len()).find(costs).unwrap_or(all.len()).saturating_sub(1);
    let ties = match selected.kept.checked_sub(SELECTED) {
        Some(more) if more > 0 => {
            format!("Ties stay whole, so {} modes are kept", grouped(selected.kept))
        }
        _ => format!("{} modes are kept", grouped(selected.kept)),
    };
    format!(
        "## What the truncation to 1,000 modes costs\n\n\
         {ties}: of degrees 0 to 9 {}, with |m| up to {}. They carry {} of the modes' summed \
         variance. But a mode of low variance may have a large coefficient:\n\n\
         * **As a direct sum** the 1,000 modes miss {} of an image's variance in the median, {} on average and {} at worst \
         (`{}` under `{}`). On average {as_bad} components of all modes do as well.\n\
         * **As a space for eigenimages** they leave {times:.0} times less, for a fit finds the best image in their span: there \
         are {} components instead of {}, and all of them leave {} on average.\n\n\
         Mean errors of the whole images, fitted by the image-centred components of either:\n\n{}\n\
         Up to {free} components the truncation costs at most {:.0} % of the error. Figures: [selected_modes.csv](paper/selected_modes.csv).\n",
        selected.by_degree.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
        selected.largest_order,
        percent(1.0 - selected.variance_left),
        percent(selected.image_error[0]),
        percent(selected.image_error[1]),
        percent(selected.image_error[2]),
        selected.worst[1],
        selected.worst[0],
        selected.components[1],
        selected.components[0],
        percent(selected.floor),
        table(header, &rows),
        100.0 * (FREE - 1.0)
    )
}
