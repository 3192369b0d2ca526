//! The page: the paper's statements, our results, and the reasons for differences.

mod table;

pub mod claims;

mod variance;

mod eigenimages;

mod spheres;

mod errors;

mod reconstruction;

mod bound;

mod selected;

use super::artefact::COMMAND;
use super::bound::Bounds;
use super::bound_spheres::Renderings;
use super::eigenimages::Eigenimages;
use super::error::Errors;
use super::highlight::Highlights;
use super::reconstruction::Reconstructions;
use super::rotated::Rotated;
use super::selected::Selected;
use super::spheres::Spheres;
use super::study::{Modes, Study};
use super::variance::Variance;
use eigenshade_cli::output::number::grouped;

/// The number of components from which the two criteria are compared: below it, they differ because
/// one counts the constant and the other does not.
pub const ALIKE_FROM: usize = 5;
/// Numbers of components in the page's tables.
const COUNTS: [usize; 8] = [5, 6, 9, 10, 20, 30, 50, 100];

/// The results that the page presents.
pub struct Report<'a> {
    /// Lights, materials and bases.
    pub study: &'a Study,
    /// Fig. 2.
    pub variance: &'a Variance,
    /// Fig. 3.
    pub eigenimages: &'a Eigenimages,
    /// Fig. 4.
    pub spheres: &'a Spheres,
    /// Fig. 5 and 6.
    pub errors: &'a Errors,
    /// Beside Fig. 6.
    pub rotated: &'a Rotated,
    /// Fig. 7.
    pub reconstructions: &'a Reconstructions,
    /// Leather's highlight.
    pub highlights: &'a Highlights,
    /// Section 4.4.
    pub bounds: &'a Bounds,
    /// Its spheres.
    pub renderings: &'a Renderings,
    /// The paper's truncation.
    pub selected: &'a Selected,
}

impl Report<'_> {
    /// The page, in Markdown.
    #[must_use]
    pub fn page(&self) -> String {
        let sections = [
            self.head(),
            claims::section(&claims::claims(
                self.variance,
                self.eigenimages,
                self.errors,
                self.rotated,
                self.highlights,
            )),
            variance::section(self),
            eigenimages::section(self),
            spheres::section(self.spheres),
            errors::all_images(self),
            errors::materials(self),
            reconstruction::section(self),
            bound::section(self.study, self.bounds, self.renderings),
            selected::section(self),
        ];
        sections.join("\n")
    }

    fn head(&self) -> String {
        let (lights, materials) = (self.study.luminances.len(), self.study.greys.len());
        format!(
            "<!-- {COMMAND} -->\n\
             # The paper's figures on our data\n\n\
             P. Nillius and J.-O. Eklundh, *Phenomenological Eigenfunctions for Image Irradiance*, ICCV 2003, \
             against what the shipped data give. `cargo run --release -p experiments -- paper --out docs` writes this page with its numbers and \
             [its figures](paper); `cargo run --release -p experiments -- paper --check docs` makes all of it again and compares.\n\n\
             **Data.** {lights} captured lights to degree 9, in luminance, each with L_0^0 = 1, in the pose in which they were \
             captured; the {materials} CUReT materials to order 7, grey. That is {} images of a sphere, with all {} modes. The \
             paper has other maps (Debevec's), its own fits of CUReT, and the {} modes of the highest variance; Fig. 3 to 7 \
             stand here for both choices of modes.\n\n\
             **Error** of an image, as in the paper: the variance within the residual over the variance within the image, 0 to \
             100 %. The scalar products are sums over quadrature nodes, not over pixels. Averages are over images, each with \
             the same weight.\n",
            grouped(lights * materials),
            grouped(Modes::All.count()),
            grouped(Modes::Selected.count()),
        )
    }
}
