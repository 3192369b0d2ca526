//! The page: what the paper says, what ours gives, and why the two differ.

use super::artefact::COMMAND;
use super::bound::Bounds;
use super::error::{Errors, needed};
use super::reconstruction::Reconstructions;
use super::report_table::{percent, sorted, table};
use super::selected::Selected;
use super::study::{Modes, Study, place};
use super::variance::{SURFACES, Variance};
use crate::number::grouped;
use eigenshade_index::mode;
use eigenshade_table::scene::Criterion;

/// Components from which the two criteria are compared: below, one counts the constant
/// and the other does not.
pub const ALIKE_FROM: usize = 5;
const COUNTS: [usize; 8] = [5, 6, 9, 10, 20, 30, 50, 100];

/// What the page tells of.
pub struct Report<'a> {
    /// Lights, materials and bases.
    pub study: &'a Study,
    /// Fig. 2.
    pub variance: &'a Variance,
    /// Fig. 5 and 6.
    pub errors: &'a Errors,
    /// Fig. 7.
    pub reconstructions: &'a Reconstructions,
    /// Section 4.4.
    pub bounds: &'a Bounds,
    /// The paper's truncation.
    pub selected: &'a Selected,
}

impl Report<'_> {
    /// The page, in Markdown.
    #[must_use]
    pub fn page(&self) -> String {
        let sections = [
            self.head(),
            self.claims(),
            self.variances(),
            self.eigenimages(),
            self.spheres(),
            self.mean_errors(),
            self.material_errors(),
            self.reconstruction(),
            self.bound(),
            self.truncation(),
        ];
        sections.join("\n")
    }

    fn head(&self) -> String {
        let (lights, materials) = (self.study.luminances.len(), self.study.greys.len());
        format!(
            "<!-- {COMMAND} -->\n\
             # The paper's figures on our data\n\n\
             P. Nillius and J.-O. Eklundh, *Phenomenological Eigenfunctions for Image Irradiance*, ICCV 2003, \
             against what the shipped data give. `eigenshade paper --out docs` writes this page with its numbers and \
             [its figures](paper); `eigenshade paper --check docs` makes the numbers again and compares.\n\n\
             **Data.** {lights} captured lights to degree 9, in luminance, each with L_0^0 = 1, in the pose in which they were \
             captured; the {materials} CUReT materials to order 7, grey. That is {} images of a sphere, with all {} modes. The \
             paper has other maps (Debevec's), its own fits of CUReT, and the {} modes of the highest variance; every figure \
             stands here for both choices of modes.\n\n\
             **Error** of an image, as in the paper: the variance within the residual over the variance within the image, 0 to \
             100 %. The scalar products are sums over quadrature nodes, not over pixels. Averages are over images, each with \
             the same weight.\n",
            grouped(lights * materials),
            grouped(Modes::All.count()),
            grouped(Modes::Selected.count()),
        )
    }

    fn claims(&self) -> String {
        let beyond = SURFACES.map(|(order, degree, _)| self.variance.beyond(order)[degree]);
        let modes = SURFACES.map(|(order, degree, _)| grouped(mode::total(degree, order)));
        let [low, high] = self.criteria_ratio();
        let of = |name: &str| self.errors.of_material(name, Criterion::ImageCentered, Modes::All);
        let (plaster, velvet, leather) = (of("11-plaster-b"), of("07-velvet"), of("05-leather"));
        let within = |count: usize, error: f64| {
            self.errors.materials().filter(|(_, errors)| errors[count] <= error).count()
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
                    percent(self.errors.mean[0][5]),
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
                    count(needed(leather, 0.01)),
                    count(needed(leather, 0.001))
                ),
            ],
        ];
        format!("## In short\n\n{}", table(["the paper", "ours"], &rows))
    }

    /// The least and the largest ratio of the mean errors, standard over image-centred.
    fn criteria_ratio(&self) -> [f64; 2] {
        let [centred, standard] = [0, 1].map(|basis| &self.errors.mean[basis]);
        let ratios = centred.iter().zip(standard).skip(ALIKE_FROM).map(|(a, b)| b / a);
        ratios.fold([f64::INFINITY, 0.0], |[low, high], ratio| [ratio.min(low), ratio.max(high)])
    }

    fn variances(&self) -> String {
        let rows: Vec<[String; 5]> = SURFACES
            .iter()
            .map(|&(order, degree, name)| {
                let beyond = self.variance.beyond(order);
                [
                    name.into(),
                    degree.to_string(),
                    grouped(mode::total(degree, order)),
                    percent(beyond[degree]),
                    percent(beyond[degree - 1]),
                ]
            })
            .collect();
        format!(
            "## Fig. 2: the variance of the modes\n\n\
             ![Variance of each mode](paper/variance.svg)\n\n\
             Summed over m. The outlines are the paper's three surfaces with their numbers of modes. A material of order o \
             passes degrees up to about o; beyond, the variance falls by orders of magnitude.\n\n\
             ![Variance beyond each degree](paper/variance_beyond.svg)\n\n{}\n\
             All three of the paper's cuts leave out the same share. Figures: [variance.csv](paper/variance.csv), \
             [variance_beyond.csv](paper/variance_beyond.csv).\n",
            table(
                ["surface", "l up to", "modes", "variance beyond", "beyond one degree less"],
                &rows
            )
        )
    }

    fn eigenimages(&self) -> String {
        let shares = Modes::BOTH.map(|modes| {
            let table = &self.study.tables[place(Criterion::ImageCentered, modes)];
            percent(table.energy_left(12) / table.summary.energy)
        });
        format!(
            "## Fig. 3: the first twelve eigenimages\n\n\
             ![The first twelve eigenimages](paper/eigenimages.png)\n\n\
             Image-centred, the constant first. Red is positive, blue negative; an image whose square is 1 on average over the \
             sphere, so the colours end at 3 and a thin ring at the rim is beyond. Below each its m and its share of the \
             variance within images. The paper's order: the constant, two slopes, a bowl, two saddles, then the same with a \
             rim. +m and -m have one eigenvalue, so each pair may be turned at will. These twelve leave {}; of the 1,000 modes \
             ([plate](paper/eigenimages_1000.png)) {}. Figures: [eigenimages.csv](paper/eigenimages.csv), \
             [eigenimages_1000.csv](paper/eigenimages_1000.csv).\n",
            shares[0], shares[1]
        )
    }

    fn spheres(&self) -> String {
        "## Fig. 4: rendered spheres\n\n\
         ![Velvet, leather and orange peel](paper/spheres.png)\n\n\
         The direct sum (15) in three channels: velvet with its bright rim in a forest, leather with its specularity in a \
         studio, orange peel at sunset. The materials are grey, the colours are the lights'. Above by all modes, below by the \
         1,000 of the highest variance.\n"
            .into()
    }

    fn mean_errors(&self) -> String {
        let rows: Vec<[String; 5]> = COUNTS
            .iter()
            .map(|&count| {
                let [a, b, c, d] = self.errors.mean.each_ref().map(|errors| percent(errors[count]));
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

    fn material_errors(&self) -> String {
        let rows: Vec<[String; 6]> = [0.1, 0.05, 0.01, 0.001]
            .iter()
            .map(|&error| {
                let all = self.errors.materials().map(|(_, errors)| {
                    needed(errors, error).map_or(f64::INFINITY, |count| count as f64)
                });
                let all = sorted(all);
                let of = |name| {
                    let errors =
                        self.errors.of_material(name, Criterion::ImageCentered, Modes::All);
                    count(needed(errors, error))
                };
                let [least, median, most] =
                    [0, all.len() / 2, all.len() - 1].map(|k| format!("{}", all[k]));
                let words = format!("{} %", 100.0 * error);
                [words, least, median, most, of("07-velvet"), of("05-leather")]
            })
            .collect();
        let header = ["mean error within", "fewest", "median", "most", "velvet", "leather"];
        let mut lights: Vec<(&str, f64)> =
            self.errors.lights().map(|(name, errors)| (name, errors[5])).collect();
        lights.sort_by(|a, b| a.1.total_cmp(&b.1));
        let (best, worst) = (lights[0], lights[lights.len() - 1]);
        format!(
            "## Fig. 6: the error of each material\n\n\
             ![Error of each of 61 materials](paper/error_by_material.svg)\n\n\
             Image-centred, all modes, averaged over the lights; [the same for the 1,000 modes](paper/error_by_material_1000.svg). \
             Components that it takes, over the 61 materials:\n\n{}\n\
             As in the paper, materials differ widely, and matte ones need fewer than glossy ones. They need more here than the \
             paper's five. Which light it is counts for more than which material: with five components the mean error over all \
             materials is {} under `{}`, but {} under `{}`. Most of that is light from behind: the rank correlation of the \
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
            self.errors.correlation(5),
            lights.len(),
            self.errors.fronts.iter().filter(|front| **front < 0.0).count()
        )
    }

    fn reconstruction(&self) -> String {
        let rows: Vec<[String; 5]> = [5, 10, 20, 30, 40, 50, 70]
            .iter()
            .map(|&count| {
                let mut fields = vec![count.to_string()];
                for course in self.reconstructions.courses.iter().take(2) {
                    fields.push(percent(course.errors[count]));
                    fields.push(percent(course.brightest[count]));
                }
                <[String; 5]>::try_from(fields).unwrap_or_default()
            })
            .collect();
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
             Leather's shading is there with a few components, its highlight takes 30 to 50 and more, as in the paper. Velvet's \
             rim is narrow: its shading is right with ten, the last of the rim's brightness takes as many as the leather. \
             Figures: [reconstruction.csv](paper/reconstruction.csv).\n",
            table(header, &rows)
        )
    }

    fn bound(&self) -> String {
        super::report_bound::section(self.bounds)
    }

    fn truncation(&self) -> String {
        let selected = self.selected;
        let rows: Vec<[String; 4]> = COUNTS
            .iter()
            .map(|&count| {
                let [all, some] = [0, 2].map(|basis| self.errors.mean[basis][count]);
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
}

/// A number of components, or that there are not enough.
fn count(count: Option<usize>) -> String {
    count.map_or("more than 100".into(), |count| count.to_string())
}
