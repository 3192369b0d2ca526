//! Fig. 7.

use super::Report;
use super::claims::{highlight, is_thirty_to_fifty};
use super::table::{components, percent, table};

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
    let highlight = highlight(report.reconstructions);
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
         Leather's shading is there with a few components; its highlight is right to 10 % from {} on, {}. Velvet's rim is \
         narrow: its shading is right with ten, the last of the rim's brightness takes more than leather's highlight. \
         Figures: [reconstruction.csv](paper/reconstruction.csv).\n",
        table(header, &rows),
        components(highlight),
        if is_thirty_to_fifty(highlight) {
            "within the paper's 30 to 50"
        } else {
            "not within the paper's 30 to 50"
        }
    )
}
