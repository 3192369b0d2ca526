//! What the paper's truncation costs.

use super::table::{percent, table};
use super::{COUNTS, Report};
use crate::number::grouped;

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
    format!(
        "## What the truncation to 1,000 modes costs\n\n\
         Ties stay whole, so {} modes are kept: of degrees 0 to 9 {}, with |m| up to {}. They carry {} of the modes' summed \
         variance. But a mode of low variance may have a large coefficient:\n\n\
         * **As a direct sum** the 1,000 modes miss {} of an image's variance in the median, {} on average and {} at worst \
         (`{}` under `{}`). That is more than 10 components of all modes leave.\n\
         * **As a space for eigenimages** they do much better, for a fit finds the best image in their span: {} components \
         instead of {}, and all of them leave {} on average.\n\n\
         Mean errors of the whole images, fitted by the image-centred components of either:\n\n{}\n\
         Up to ten components the truncation costs nothing. Figures: [selected_modes.csv](paper/selected_modes.csv).\n",
        grouped(selected.kept),
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
        table(header, &rows)
    )
}
