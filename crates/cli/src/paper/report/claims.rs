//! The paper's statements beside ours.

use super::table::{components, percent, table};
use super::{ALIKE_FROM, Report};
use crate::number::grouped;
use crate::paper::error::needed;
use crate::paper::study::Modes;
use crate::paper::variance::SURFACES;
use eigenshade_index::mode;
use eigenshade_table::scene::Criterion;

/// The section, in Markdown.
pub fn section(report: &Report<'_>) -> String {
    let beyond = SURFACES.map(|(order, degree, _)| report.variance.beyond(order)[degree]);
    let modes = SURFACES.map(|(order, degree, _)| grouped(mode::total(degree, order)));
    let [low, high] = criteria_ratio(report);
    let of = |name: &str| report.errors.of_material(name, Criterion::ImageCentered, Modes::All);
    let (plaster, velvet, leather) = (of("11-plaster-b"), of("07-velvet"), of("05-leather"));
    let within = |count: usize, error: f64| {
        report.errors.materials().filter(|(_, errors)| errors[count] <= error).count()
    };
    let rows = [
        [
            format!("degrees to l = 2 carry the Lambertian variance, {} modes", modes[0]),
            format!("holds: {} lies beyond", percent(beyond[0])),
        ],
        [
            format!("o <= 4 needs l to about 5, {} modes", modes[1]),
            format!("holds: {} lies beyond", percent(beyond[1])),
        ],
        [
            format!("o <= 7 needs l to 7, {} modes", modes[2]),
            format!("holds: {} lies beyond", percent(beyond[2])),
        ],
        [
            "standard and image-centred PCA give similar errors".into(),
            format!(
                "holds: from {ALIKE_FROM} components on, the mean error by standard is {low:.3} to {high:.3} times \
                 that by image-centred"
            ),
        ],
        [
            "about five components for many materials, the matte among them".into(),
            format!(
                "not in these lights: five leave {} of plaster b, the mattest, and {} of all; within 10 % are {} of \
                 61 materials with five, {} with eight, {} with ten",
                percent(plaster[5]),
                percent(report.errors.mean[0][5]),
                within(5, 0.1),
                within(8, 0.1),
                within(10, 0.1)
            ),
        ],
        [
            "about five for velvet".into(),
            format!(
                "differs: five leave {}, nine {}: it takes component 8, counted from 0, a ring along the rim",
                percent(velvet[5]),
                percent(velvet[9])
            ),
        ],
        [
            "30 to 50 for leather's specularity".into(),
            format!(
                "holds: {} left with 30, {} with 50; 1 % takes {}, 0.1 % takes {}",
                percent(leather[30]),
                percent(leather[50]),
                components(needed(leather, 0.01)),
                components(needed(leather, 0.001))
            ),
        ],
    ];
    format!("## In short\n\n{}", table(["the paper", "ours"], &rows))
}

/// The least and the largest ratio of the mean errors, standard over image-centred.
fn criteria_ratio(report: &Report<'_>) -> [f64; 2] {
    let [centred, standard] = [0, 1].map(|basis| &report.errors.mean[basis]);
    let ratios = centred.iter().zip(standard).skip(ALIKE_FROM).map(|(a, b)| b / a);
    ratios.fold([f64::INFINITY, 0.0], |[low, high], ratio| [ratio.min(low), ratio.max(high)])
}
