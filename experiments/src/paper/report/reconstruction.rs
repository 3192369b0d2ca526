//! The section about Fig. 7.

use super::Report;
use super::claims::{highlight, is_thirty_to_fifty};
use super::table::{components, percent, table};
use crate::paper::reconstruction::Course;
use crate::paper::study::Modes;

/// An image is shaded if its error is at most this.
const SHADED: f64 = 0.05;

/// The section, in Markdown.
pub fn section(report: &Report<'_>) -> String {
    let rows: Vec<[String; 5]> = [5, 10, 20, 30, 40, 50, 70]
        .iter()
        .map(|&count| {
            let mut fields = vec![count.to_string()];
            for course in report.reconstructions.courses.iter().take(2) {
                fields.push(percent(course.errors[count]));
                fields.push(percent(course.brightest[count]));
            }
            <[String; 5]>::try_from(fields).unwrap_or_default()
        })
        .collect();
    // The number of components from which the brightest point is right, and the error with ten
    // components.
    let [velvet, leather] = ["07-velvet", "05-leather"].map(|name| {
        let of = |course: &&Course| course.names[0] == name && course.modes == Modes::All;
        let course = report.reconstructions.courses.iter().find(of);
        (highlight(report.reconstructions, name), course.map_or(1.0, |course| course.errors[10]))
    });
    let [least, middle, most] = report.highlights.spread();
    let header = [
        "components",
        "velvet, forest: error",
        "its brightest point",
        "leather, studio: error",
        "its brightest point",
    ];
    format!(
        "## Fig. 7: velvet and leather reconstructed\n\n\
         ![Reconstructions and residuals](paper/reconstruction.png)\n\n\
         Above the image, below the residual (truth less reconstruction), red and blue ending at a tenth of the image's \
         largest value; the number is the error. [The same by the 1,000 modes](paper/reconstruction_1000.png). Brightest \
         point: the reconstruction there, of the truth.\n\n{}\n\
         {}: ten components leave {} of its variance, and its highlight in the studio is right to 10 % from {} on, {}. {}: velvet's ten leave {}, \
         and its brightest point is right to 10 % from {} on. \
         How many components leather's highlight takes is a matter of the light: right to 10 % from {} to {} on among the {} lights, {} in the median ([highlight.csv](paper/highlight.csv)). \
         Figures: [reconstruction.csv](paper/reconstruction.csv).\n",
        table(header, &rows),
        if leather.1 <= SHADED {
            "Leather's shading comes first"
        } else {
            "Leather's shading takes more"
        },
        percent(leather.1),
        components(leather.0),
        if is_thirty_to_fifty(leather.0) {
            "within the paper's 30 to 50"
        } else {
            "not within the paper's 30 to 50"
        },
        if later(velvet.0, leather.0) {
            "Velvet's brightest point takes more than leather's"
        } else {
            "Velvet's brightest point takes no more than leather's"
        },
        percent(velvet.1),
        components(velvet.0),
        components(least),
        components(most),
        report.highlights.lights.len(),
        components(middle),
    )
}

/// Whether one number of components is larger than another; `None` is larger than all that are
/// listed.
fn later(one: Option<usize>, other: Option<usize>) -> bool {
    one.unwrap_or(usize::MAX) > other.unwrap_or(usize::MAX)
}
