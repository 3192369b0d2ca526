//! Fig. 5 and 6.

use super::table::{components, percent, sorted, table};
use super::{COUNTS, Report};
use crate::paper::error::needed;
use crate::paper::study::Modes;
use eigenshade_table::scene::Criterion;

/// The section, in Markdown.
pub fn all_images(report: &Report<'_>) -> String {
    let rows: Vec<[String; 5]> = COUNTS
        .iter()
        .map(|&count| {
            let [a, b, c, d] = report.errors.mean.each_ref().map(|errors| percent(errors[count]));
            [count.to_string(), a, b, c, d]
        })
        .collect();
    let header = [
        "components",
        "image-centred",
        "standard",
        "image-centred, 1,000 modes",
        "standard, 1,000 modes",
    ];
    format!(
        "## Fig. 5: the error of all images\n\n\
         ![Mean error against the number of components](paper/error.svg)\n\n{}\n\
         Image-centred counts the constant, standard does not count the mean image that it subtracts first. Below five \
         components standard is the worse for that: its first one is mostly the constant, which the variance within an \
         image does not see. Figures: [error.csv](paper/error.csv).\n",
        table(header, &rows)
    )
}

/// The section, in Markdown.
pub fn materials(report: &Report<'_>) -> String {
    let rows: Vec<[String; 6]> = [0.1, 0.05, 0.01, 0.001]
        .iter()
        .map(|&error| {
            let all = report.errors.materials().map(|(_, errors)| {
                needed(errors, error).map_or(f64::INFINITY, |count| count as f64)
            });
            let all = sorted(all);
            let of = |name| {
                let errors = report.errors.of_material(name, Criterion::ImageCentered, Modes::All);
                components(needed(errors, error))
            };
            let [least, median, most] =
                [0, all.len() / 2, all.len() - 1].map(|k| format!("{}", all[k]));
            let words = format!("{} %", 100.0 * error);
            [words, least, median, most, of("07-velvet"), of("05-leather")]
        })
        .collect();
    let header = ["mean error within", "fewest", "median", "most", "velvet", "leather"];
    let mut lights: Vec<(&str, f64)> =
        report.errors.lights().map(|(name, errors)| (name, errors[5])).collect();
    lights.sort_by(|a, b| a.1.total_cmp(&b.1));
    let (best, worst) = (lights[0], lights[lights.len() - 1]);
    format!(
        "## Fig. 6: the error of each material\n\n\
         ![Error of each of 61 materials](paper/error_by_material.svg)\n\n\
         Image-centred, all modes, averaged over the lights; [the same for the 1,000 modes](paper/error_by_material_1000.svg). \
         Components that it takes, over the 61 materials:\n\n{}\n\
         As in the paper, materials differ widely, and matte ones need fewer than glossy ones. They need more here than the \
         paper's five. Which light it is counts for more than which material: with five components the mean error over all \
         materials is {} under `{}`, but {} under `{}`. Much of that goes with light from behind: the rank correlation of the \
         error with L_1^0 / L_0^0, which is positive where more light comes from the front, is {:.2} over the {} lights, \
         and {} of them come more from behind. What is left of the difference we cannot tell: the paper's maps are others, \
         it does not say at which error a material counts as represented, and its velvet is another fit of the same \
         measurements (at the rim nothing was measured). Figures: [error_by_material.csv](paper/error_by_material.csv), \
         [error_by_light.csv](paper/error_by_light.csv).\n",
        table(header, &rows),
        percent(best.1),
        best.0,
        percent(worst.1),
        worst.0,
        report.errors.correlation(5),
        lights.len(),
        report.errors.fronts.iter().filter(|front| **front < 0.0).count()
    )
}
