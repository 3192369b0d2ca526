//! The section about Fig. 4.

use super::table::{percent, table};
use crate::paper::spheres::{Spheres, title};
use crate::paper::study::Modes;

/// The section, in Markdown.
pub fn section(spheres: &Spheres) -> String {
    let row = |pair: &[crate::paper::spheres::Sphere]| {
        let [whole, selected] = pair else { return Default::default() };
        let [material, light] = whole.names;
        [
            format!("{}, {light}", title(material)),
            format!("{:.0}°", whole.slant),
            percent(whole.negative),
            percent(selected.negative),
            percent(selected.off),
            percent(selected.error),
        ]
    };
    let rows: Vec<[String; 6]> = spheres.all.chunks(Modes::BOTH.len()).map(row).collect();
    let header = [
        "sphere",
        "brightest at slant",
        "below zero",
        "below zero, 1,000 modes",
        "1,000 modes: off by (rms)",
        "1,000 modes: error",
    ];
    format!(
        "## Fig. 4: rendered spheres\n\n\
         ![Velvet, leather and orange peel](paper/spheres.png)\n\n\
         The direct sum (15) in three channels: velvet, of which the paper shows the bright rim, in a forest; leather, of which \
         it shows the specularity, in a studio; orange peel at sunset. The materials are grey, the colours are the lights'. \
         Above by all modes, below by the 1,000 of the highest variance.\n\n{}\n\
         Slant is the angle from the optical axis, 90° at the rim. Below zero is a share of the disc: a light that ends at a \
         degree rings, and a fit may be negative; it is shown black. The rms is over pixels and channels, of the brightest \
         pixel by all modes; the error is the paper's, of the luminance. \
         Figures: [spheres.csv](paper/spheres.csv) has exposures and means, [spheres_values.csv](paper/spheres_values.csv) \
         irradiances on a grid of normals.\n",
        table(header, &rows)
    )
}
