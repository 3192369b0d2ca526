//! The page's section about section 4.4 of the paper.

use super::table::{percent, table};
use crate::paper::bound::{Bounds, Row};
use crate::paper::bound_spheres::{Rendering, Renderings};
use crate::paper::spheres::title;
use crate::paper::study::{Modes, Study};
use eigenshade_cli::output::number::grouped;

/// The section, in Markdown.
pub fn section(study: &Study, bounds: &Bounds, renderings: &Renderings) -> String {
    let rows: Vec<[String; 8]> =
        bounds.rows.iter().filter(|row| row.modes == Modes::All).map(fields).collect();
    let header = [
        "accuracy",
        "terms: fewest",
        "median",
        "most",
        "that would do, median",
        "largest error",
        "error / bound, largest",
        "error above the uncorrelated sum",
    ];
    let reached: Vec<[String; 3]> = bounds
        .rows
        .iter()
        .filter(|row| row.modes == Modes::Selected)
        .map(|row| [share(row.accuracy), grouped(row.reached), percent_or_none(row)])
        .collect();
    let of_all = || bounds.rows.iter().filter(|row| row.modes == Modes::All);
    let images = study.luminances.len() * study.greys.len();
    let fewest = of_all().map(|row| row.reached).min().unwrap_or(0);
    let reached_all = if fewest == images {
        format!("all {} images reach every accuracy", grouped(images))
    } else {
        format!("of {} images {} reach every accuracy", grouped(images), grouped(fewest))
    };
    let floor = bounds.selected().unwrap_or_default();
    let worst = bounds.rows.iter().map(|row| row.excess).fold(0.0, f64::max);
    let of_percent = bounds.rows.iter().find(|row| row.accuracy == 0.01);
    let dear = of_percent.map_or(0.0, |row| row.terms[1] as f64 / row.sufficient.max(1) as f64);
    let never = match bounds.violations {
        0 => format!(
            "Of all {} partial sums of all images, none has an error above its bound.",
            grouped(bounds.compared)
        ),
        some => format!(
            "**{} of {} partial sums have an error above their bound: that is a defect.**",
            grouped(some),
            grouped(bounds.compared)
        ),
    };
    format!(
        "## Section 4.4: the direct sum to a stated accuracy\n\n\
         A term c_s E_s has the variance c_s² m_ss, and its size is the root of that. The paper renders by summing terms and \
         takes from their variances a bound for the error; it does not write the bound out. Leaving out a set of terms, with the \
         error as root mean square over the sphere:\n\n\
         * **Rigorous for every image.** The error is at most the sum of the sizes left out (triangle inequality). Images of \
         different m are orthogonal, so it is also at most the root of the sum over m of the squared sums of the sizes of that \
         m, which is never more. That is the bound here.\n\
         * **On average only.** Over all rotations of the light, and for a set that does not depend on the light, terms of \
         different (l, m) are uncorrelated, (37), and their mean squares add; inside one (l, m) the triangle inequality \
         remains.\n\
         * **No bound.** The root of the summed variances: terms of one (l, m) overlap, M is nearly singular. At the accuracies \
         below the error is at most {worst:.2} times that.\n\n\
         ![Bound and error against the number of terms](paper/bound.svg)\n\n\
         Leather in the studio. The accuracy is relative to the image's mean, (30), which is known before anything is rendered. \
         For each image the weakest terms are left out as long as the bound allows; {reached_all}:\n\n{}\n\
         {never} At an accuracy of 1 % the bound asks for {dear:.1} times as many terms as would do, in the \
         median. Where error / bound is 1, what is left out is one term for each m. {} of the 3,704 modes are zero, so {} terms \
         are all that there are.\n\n\
         With the 1,000 modes of the highest variance, what the selection drops counts as left out too: no sum has a smaller \
         bound than that of the dropped terms. In the drawn image it is {} of the mean, and the error there {}; the images whose \
         bound comes down to an accuracy:\n\n{}\n\
         {}\n\
         Figures: [bound.csv](paper/bound.csv), [bound_spheres.csv](paper/bound_spheres.csv).\n",
        table(header, &rows),
        bounds.zero_modes,
        grouped(3704 - bounds.zero_modes),
        percent(floor[1]),
        percent(floor[0]),
        table(["accuracy", "images that reach it", "terms, median"], &reached),
        rendered(renderings)
    )
}

/// The part about the spheres rendered to a stated accuracy.
fn rendered(renderings: &Renderings) -> String {
    let rows: Vec<[String; 7]> = renderings
        .all
        .iter()
        .map(|one| {
            let [material, light] = one.names;
            [
                format!("{}, {light}", title(material)),
                share(one.accuracy),
                grouped(one.terms),
                percent(one.bound),
                percent(one.error),
                percent(one.pixel_error),
                percent(one.largest),
            ]
        })
        .collect();
    let header = [
        "sphere",
        "stated",
        "terms",
        "bound",
        "error",
        "error over the pixels",
        "largest of a pixel",
    ];
    let over = renderings.all.iter().filter(|one| !is_within(one)).count();
    let verdict = match over {
        0 => "Every error is within its bound, every bound within what was stated.".into(),
        some => format!("**{some} of them exceed their bound: that is a defect.**"),
    };
    format!(
        "**Rendered so.** Each sphere is the sum of its strongest terms, the fewest whose bound is within the accuracy stated \
         above it:\n\n\
         ![Spheres rendered to a stated accuracy](paper/bound_spheres.png)\n\n\
         Below each image what it lacks (truth less sum), red and blue ending at half of what was stated; the numbers are the \
         bound and the error, of the mean. The truth is the sum of all 3,704, degree by degree instead of term by term. The error \
         is that of the quadrature's nodes, beside it that of the picture's own pixels; rms, so that a single pixel may \
         lack more.\n\n{}\n{verdict}\n",
        table(header, &rows)
    )
}

/// Whether the omitted part of a rendering is within its bound and its accuracy.
fn is_within(one: &Rendering) -> bool {
    one.error <= one.bound && one.bound <= one.accuracy && one.pixel_error <= one.accuracy
}

fn fields(row: &Row) -> [String; 8] {
    let [least, median, most] = row.terms.map(grouped);
    [
        share(row.accuracy),
        least,
        median,
        most,
        grouped(row.sufficient),
        percent(row.error),
        format!("{:.3}", row.ratio[1]),
        format!("{} of images", percent(row.exceeded)),
    ]
}

/// An accuracy in percent, without needless digits.
fn share(accuracy: f64) -> String {
    let value = format!("{:.6}", 100.0 * accuracy);
    format!("{} %", value.trim_end_matches('0').trim_end_matches('.'))
}

fn percent_or_none(row: &Row) -> String {
    if row.reached == 0 { "none".into() } else { grouped(row.terms[1]) }
}
