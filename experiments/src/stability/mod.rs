//! The numerically hard cases: the error measured against an oracle, and what a naive method would
//! give.
//!
//! `experiments stability` checks every bound and writes the figures to `docs/stability.md`, which
//! also describes each case.

pub mod databases;
mod exact_rank;
pub mod high_degree;
pub mod inputs;
pub mod maps;
pub mod objects;
pub mod ranges;
pub mod rotations;
pub mod special;
pub mod spectrum;
pub mod subnormal;
pub mod sums;

use crate::pages::{Page, Part, same_word, table};
use crate::tolerances;

/// A measured number and its bound.
#[derive(Clone, Debug)]
pub struct Figure {
    /// What was measured.
    pub what: String,
    /// The measured number.
    pub found: f64,
    /// Its bound.
    pub bound: Bound,
}

/// The bound of a figure.
#[derive(Clone, Copy, Debug)]
pub enum Bound {
    /// For our method: the error is at most this.
    Most(f64),
    /// For the naive method: the error is at least this; otherwise the case is not hard.
    Least(f64),
    /// For a count: exactly this number.
    Exactly(f64),
    /// No bound: a ratio of times, which depends on the host.
    Reported,
}

/// An error with an upper bound.
fn most(what: impl Into<String>, found: f64, bound: f64) -> Figure {
    Figure { what: what.into(), found: found.abs(), bound: Bound::Most(bound) }
}

/// An error of the naive method, with a lower bound.
fn least(what: impl Into<String>, found: f64, bound: f64) -> Figure {
    Figure { what: what.into(), found, bound: Bound::Least(bound) }
}

/// A count.
fn exactly(what: impl Into<String>, found: usize, bound: usize) -> Figure {
    Figure { what: what.into(), found: found as f64, bound: Bound::Exactly(bound as f64) }
}

/// A ratio of times.
fn report(what: impl Into<String>, found: f64) -> Figure {
    Figure { what: what.into(), found, bound: Bound::Reported }
}

impl Figure {
    /// Whether the figure is within its bound; false for NaN.
    #[must_use]
    pub fn holds(&self) -> bool {
        match self.bound {
            Bound::Most(bound) => self.found <= bound,
            Bound::Least(bound) => self.found >= bound,
            Bound::Exactly(bound) => self.found == bound,
            Bound::Reported => self.found > 0.0,
        }
    }

    /// The quantity, one digit of the error, and the bound.
    fn cells(&self) -> [String; 3] {
        let found = self.found;
        let (found, bound) = match self.bound {
            Bound::Most(bound) => (format!("{found:.0e}"), format!("≤ {bound:e}")),
            Bound::Least(bound) => (format!("{found:.0e}"), format!("≥ {bound:e}")),
            Bound::Exactly(bound) => (found.to_string(), format!("= {bound}")),
            Bound::Reported => (format!("×{found:.1}"), "-".into()),
        };
        // An unescaped bar would end the cell.
        [self.what.replace('|', "\\|"), found, bound]
    }
}

/// A case's name on the page, and what measures its figures.
pub type Case = (&'static str, fn() -> Vec<Figure>);

/// All cases, in the order of the page.
pub const CASES: &[Case] = &[
    ("special functions to degree 64", special::functions),
    ("pole and rim", special::pole_and_rim),
    ("rotated frames, degree 64", rotations::composition),
    ("third Euler angle", rotations::third_angle),
    ("a thousand small rotations, f32", rotations::drift),
    ("a matrix that is almost a rotation, f32", rotations::almost),
    ("degree 32, order 32", high_degree::measure),
    ("M is singular", spectrum::root),
    ("rank of M", spectrum::ranks),
    ("more components than rank", spectrum::more_than_rank),
    ("order and sign of components", spectrum::order_and_sign),
    ("nearly equal eigenvalues", spectrum::nearly_equal),
    ("one light or one material", databases::few),
    ("identical materials", databases::alike),
    ("black lights and materials", databases::zeros),
    ("ambient lights, Lambertian materials", databases::plain),
    ("a covariance of rank one", databases::rank_one),
    ("a sun in a map", maps::sun),
    ("maps of 2 x 1 and 8192 x 4096", maps::sizes),
    ("flat objects", objects::flat),
    ("weights over twelve decades", objects::weights),
    ("degenerate triangles", objects::degenerate),
    ("coefficients at 1e-30 and 1e+30, f64", ranges::double),
    ("coefficients at 1e-30 and 1e+30, f32", ranges::single),
    ("light at 1e-30, f32", subnormal::measure),
    ("a million pixels, f32", sums::million),
    ("65,536 pixels at full weight, Q15", sums::full_weight),
    ("a normal map of 8 bits", inputs::eight_bits),
    ("normals behind the rim", inputs::behind),
    ("a sun, by every method", inputs::sun),
    ("light from one direction, by every method", inputs::delta),
];

/// Factor by which a figure on the page may differ from one measured now: errors are a few last
/// bits, which depend on a host's library and vector width.
const PAGE_FACTOR: f64 = 8.0;

/// Errors on the page below this may be zero on another host.
const PAGE_ROUNDING: f64 = 1e-13;

/// `docs/stability.md`.
pub const PAGE: Page = Page {
    name: "stability",
    same: |_, old, new| {
        same_word(old, new, |old, new| {
            let within = old / new <= PAGE_FACTOR && new / old <= PAGE_FACTOR;
            within || old.max(new) < PAGE_ROUNDING
        })
    },
};

/// Tolerances that only the hard cases use, and those of all components. Each is at most ten times
/// the largest figure that it bounds, up to the rounding of that figure to one digit.
const TIGHT: [f64; 16] = [
    tolerances::ALL_COMPONENTS,
    tolerances::ALL_COMPONENTS_SHIPPED,
    tolerances::ALL_COMPONENTS_FEW,
    tolerances::HIGH_PIXELS,
    tolerances::HIGH_PIXELS_F32,
    tolerances::ORTHONORMAL_HIGH,
    tolerances::SUN,
    tolerances::FACETS,
    tolerances::BEYOND_RANK,
    tolerances::EIGENVALUE_ULP,
    tolerances::POLAR_INTEGRAL,
    tolerances::SCALED_F32,
    tolerances::FLAT_PICTURES,
    tolerances::WEIGHTED_PICTURES,
    tolerances::MILLION_PIXELS,
    tolerances::RASTER,
];

/// Measures every case.
///
/// # Errors
///
/// The figures that exceed their bounds, and the bounds that are far above their figures.
pub fn parts(progress: impl Fn(&str)) -> Result<Vec<Part>, String> {
    let measure = |(name, measure): &Case| {
        progress(name);
        measure()
    };
    let measured: Vec<Vec<Figure>> = CASES.iter().map(measure).collect();
    let mut broken = loose(measured.iter().flatten());
    let mut rows = Vec::new();
    for ((name, _), figures) in CASES.iter().zip(&measured) {
        for (k, figure) in figures.iter().enumerate() {
            let cells = figure.cells();
            if !figure.holds() {
                broken.push(format!("{name}: {}", cells.join(" ")));
            }
            let name = if k == 0 { *name } else { "" };
            rows.push([&[name.to_owned()], &cells[..]].concat());
        }
    }
    let text = table("case | quantity | measured: | bound:", rows);
    if broken.is_empty() { Ok(vec![("figures", text)]) } else { Err(broken.join("; ")) }
}

/// The tolerances of [`TIGHT`] that bound no figure, or only much smaller ones.
fn loose<'a>(figures: impl Iterator<Item = &'a Figure> + Clone) -> Vec<String> {
    let mut loose = Vec::new();
    for tolerance in TIGHT {
        let bounded = figures.clone().filter_map(|figure| match figure.bound {
            Bound::Most(bound) if bound == tolerance => Some(figure.found),
            _ => None,
        });
        match bounded.reduce(f64::max) {
            None => loose.push(format!("no figure has the bound {tolerance:e}")),
            Some(most) if tolerance > 10.0 * most => {
                loose.push(format!("the bound {tolerance:e} is far above {most:.0e}"));
            }
            Some(_) => {}
        }
    }
    loose
}

#[cfg(test)]
mod tests {
    use super::{TIGHT, loose, most};

    #[test]
    fn a_bound_far_above_its_figures_is_found() {
        let tight = || TIGHT.map(|bound| most("tight", 0.1 * bound, bound));
        assert_eq!(loose(tight().iter()), Vec::<String>::new());
        let mut figures = tight();
        figures[3].found *= 0.5;
        assert_eq!(loose(figures.iter()), ["the bound 1e-5 is far above 5e-7"]);
        assert!(loose(tight()[1..].iter())[0].contains("no figure"));
    }
}
