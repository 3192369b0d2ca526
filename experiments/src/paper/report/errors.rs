//! The sections about Fig. 5 and 6.

use super::claims::{REPRESENTED, whole};
use super::table::{components, percent, sorted, table};
use super::{ALIKE_FROM, COUNTS, Report};
use crate::paper::error::{Errors, needed};
use crate::paper::study::Modes;
use eigenshade_table::scene::Criterion;

/// A rank correlation of at least this counts as strong.
const STRONG: f64 = 0.5;

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
         Image-centred counts the constant, standard does not count the mean image that it subtracts first. {} Figures: \
         [error.csv](paper/error.csv).\n",
        table(header, &rows),
        few(report.errors)
    )
}

/// The behavior of standard PCA with few components.
fn few(errors: &Errors) -> String {
    let ratio = |count: usize| errors.mean[1][count] / errors.mean[0][count];
    let worse = (1..ALIKE_FROM).filter(|count| ratio(*count) > 1.0).count();
    let largest = (1..ALIKE_FROM).map(ratio).fold(0.0, f64::max);
    let all = ALIKE_FROM - 1;
    let constant = percent(errors.first_constant);
    if worse == 0 {
        return format!("Of 1 to {all} components standard leaves no more for that.");
    }
    format!(
        "Of 1 to {all} components standard leaves more with {worse} of the {all} numbers, up to {largest:.2} times as much: its \
         first component is {constant} constant, in mean square, which the variance within an image does not see."
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
    format!(
        "## Fig. 6: the error of each material\n\n\
         ![Error of each of 61 materials](paper/error_by_material.svg)\n\n\
         Image-centred, all modes, averaged over the lights; [the same for the 1,000 modes](paper/error_by_material_1000.svg). \
         Components that it takes, over the 61 materials:\n\n{}\n\
         {}\n\n{}\n\n{}\n\n\
         Figures: [error_by_material.csv](paper/error_by_material.csv), [error_by_light.csv](paper/error_by_light.csv), \
         [error_rotated.csv](paper/error_rotated.csv).\n",
        table(header, &rows),
        of_materials(report.errors),
        of_lights(report.errors),
        of_rotations(report)
    )
}

/// The materials that need more components.
fn of_materials(errors: &Errors) -> String {
    let count = errors.materials().count();
    let within = errors.materials().filter(|(_, errors)| errors[5] <= REPRESENTED).count();
    let correlation = errors.gloss_correlation(10);
    let verdict = if correlation >= STRONG {
        "As in the paper, matte materials need fewer components than glossy ones"
    } else {
        "Other than in the paper, how glossy a material is tells little of the components it needs"
    };
    let five =
        if 2 * within >= count { "The paper's five do" } else { "The paper's five do not do" };
    format!(
        "{verdict}: the rank correlation of the error with ten components and the share that orders o >= 4 have of the squares \
         of a material's b is {correlation:.2} over the {count}. {five} for most: {within} are within {} with five.",
        whole(REPRESENTED)
    )
}

/// The influence of the light.
fn of_lights(errors: &Errors) -> String {
    let mut lights: Vec<(&str, f64)> =
        errors.lights().map(|(name, errors)| (name, errors[5])).collect();
    lights.sort_by(|a, b| a.1.total_cmp(&b.1));
    let (best, worst) = (lights[0], lights[lights.len() - 1]);
    let materials = sorted(errors.materials().map(|(_, errors)| errors[5]));
    let spreads = [worst.1 / best.1, materials[materials.len() - 1] / materials[0]];
    let verdict = if spreads[0] > spreads[1] {
        "Which light it is counts for more than which material"
    } else {
        "Which material it is counts for more than which light"
    };
    let correlation = errors.correlation(5);
    let behind = if correlation <= -STRONG {
        "Much of that goes with light from behind"
    } else {
        "Little of that goes with light from behind"
    };
    let backs = errors.fronts.iter().filter(|front| **front < 0.0).count();
    format!(
        "{verdict}: with five components the mean error over all materials is {} under `{}` and {} under `{}`, {:.1} times as \
         much; between materials, over all lights, it is {:.1} times. {behind}: the rank correlation of the error with \
         L_1^0 / L_0^0, which is positive where more light comes from the front, is {correlation:.2} over the {} lights, and \
         {backs} of them come more from behind.",
        percent(best.1),
        best.0,
        percent(worst.1),
        worst.0,
        spreads[0],
        spreads[1],
        lights.len()
    )
}

/// The difference that remains if the pose of the lights is averaged out.
fn of_rotations(report: &Report<'_>) -> String {
    let (errors, rotated) = (report.errors, report.rotated);
    let within =
        |count: usize| rotated.by_material.iter().filter(|one| one[count] <= REPRESENTED).count();
    let [captured, turned] = [errors.mean[0][5], rotated.all[5]];
    let pose = if turned < captured {
        "Part of the difference from the paper is this pose and this way of averaging"
    } else {
        "Neither the pose nor the way of averaging explains the difference from the paper"
    };
    let of = |name: &str| percent(rotated.of_material(name)[5]);
    format!(
        "{pose}. The components are made for lights that are turned every way; with every light turned every way, and the \
         variances averaged before they are divided, five leave {} of all, {} of velvet, {} of leather and {} of plaster b, \
         and {} of {} materials are within {} with five, {} with six. What is left of the difference we cannot tell: the \
         paper's maps are others, it does not say at which error a material counts as represented, and its velvet is another \
         fit of the same measurements (at the rim nothing was measured).",
        percent(turned),
        of("07-velvet"),
        of("05-leather"),
        of("11-plaster-b"),
        within(5),
        rotated.by_material.len(),
        whole(REPRESENTED),
        within(6)
    )
}
