//! Compares the paper's statements with our results. The figures decide whether a statement holds.

use super::ALIKE_FROM;
use super::table::{components, percent, table};
use crate::paper::eigenimages::Eigenimages;
use crate::paper::error::{Errors, needed};
use crate::paper::highlight::{Highlights, LIMIT, MATERIAL, right_from};
use crate::paper::reconstruction::Reconstructions;
use crate::paper::rotated::Rotated;
use crate::paper::spheres::title;
use crate::paper::study::Modes;
use crate::paper::variance::{SURFACES, Variance};
use eigenshade_cli::output::number::grouped;
use eigenshade_index::mode;
use eigenshade_table::scene::Criterion;

/// A set of degrees carries the variance if less than this share lies beyond them.
const CARRIED: f64 = 0.01;
/// Two mean errors are alike if neither is more than this many times the other.
const ALIKE: f64 = 1.05;
/// An image is represented if its error is at most this.
pub const REPRESENTED: f64 = 0.1;
/// "About five components" means at most this number.
const ABOUT_FIVE: usize = 6;

/// A statement of the paper and our result.
pub struct Claim {
    /// The statement of the paper.
    pub paper: String,
    /// The condition under which it counts as holding here.
    pub condition: String,
    /// Whether it holds.
    pub holds: bool,
    /// Our result.
    pub found: String,
}

/// The section, in Markdown.
#[must_use]
pub fn section(claims: &[Claim]) -> String {
    let row = |claim: &Claim| {
        let verdict = if claim.holds { "holds" } else { "differs" };
        let found = format!("{verdict}: {}", claim.found);
        [claim.paper.clone(), claim.condition.clone(), found]
    };
    let rows: Vec<[String; 3]> = claims.iter().map(row).collect();
    format!("## In short\n\n{}", table(["the paper", "holds if", "ours"], &rows))
}

/// All statements, in the paper's order.
#[must_use]
pub fn claims(
    variance: &Variance,
    eigenimages: &Eigenimages,
    errors: &Errors,
    rotated: &Rotated,
    highlights: &Highlights,
) -> Vec<Claim> {
    let mut claims: Vec<Claim> =
        SURFACES.iter().map(|surface| carried(variance, *surface)).collect();
    let of = |name: &str| errors.of_material(name, Criterion::ImageCentered, Modes::All);
    claims.extend([
        alike(errors),
        many(errors, rotated),
        velvet(of("07-velvet"), rotated.of_material("07-velvet"), eigenimages),
        leather(of(MATERIAL), highlights),
    ]);
    claims
}

fn carried(variance: &Variance, (order, degree, name): (usize, usize, &str)) -> Claim {
    let beyond = variance.beyond(order);
    let modes = grouped(mode::total(degree, order));
    let found = beyond.iter().position(|beyond| *beyond < CARRIED);
    let paper = match order {
        0 => format!("degrees to l = {degree} carry the {name} variance, {modes} modes"),
        4 => format!("{name} needs l to about {degree}, {modes} modes"),
        _ => format!("{name} needs l to {degree}, {modes} modes"),
    };
    let less = beyond[degree - 1];
    Claim {
        paper,
        condition: format!(
            "l = {degree} is the first beyond which lies less than {}",
            whole(CARRIED)
        ),
        holds: found == Some(degree),
        found: format!(
            "{} lies beyond, {} beyond one degree less",
            percent(beyond[degree]),
            percent(less)
        ),
    }
}

fn alike(errors: &Errors) -> Claim {
    let [centred, standard] = [0, 1].map(|basis| &errors.mean[basis]);
    let ratios = centred.iter().zip(standard).skip(ALIKE_FROM).map(|(a, b)| b / a);
    let [low, high] = ratios
        .fold([f64::INFINITY, 0.0f64], |[low, high], ratio| [ratio.min(low), ratio.max(high)]);
    Claim {
        paper: "standard and image-centred PCA give similar errors".into(),
        condition: format!(
            "from {ALIKE_FROM} components on the mean errors are within {ALIKE} times of each other"
        ),
        holds: low >= 1.0 / ALIKE && high <= ALIKE,
        found: format!("by standard it is {low:.3} to {high:.3} times that by image-centred"),
    }
}

fn many(errors: &Errors, rotated: &Rotated) -> Claim {
    let within = |count: usize| {
        errors.materials().filter(|(_, errors)| errors[count] <= REPRESENTED).count()
    };
    let turned = rotated.by_material.iter().filter(|errors| errors[ABOUT_FIVE] <= REPRESENTED);
    let all = errors.materials().count();
    let least = errors.materials().min_by(|a, b| a.1[5].total_cmp(&b.1[5]));
    let (least, left) = least.map_or(("", 0.0), |(name, errors)| (name, errors[5]));
    Claim {
        paper: "about five components for many materials, the matte among them".into(),
        condition: format!(
            "with {ABOUT_FIVE} half of the materials are within {}",
            whole(REPRESENTED)
        ),
        holds: 2 * within(ABOUT_FIVE) >= all,
        found: format!(
            "within are {} of {all} with five, {} with six, {} with eight, {} with ten; five leave {} of {}, the least of \
             any, and {} of all; with every light turned every way {} are within with six",
            within(5),
            within(6),
            within(8),
            within(10),
            percent(left),
            title(least),
            percent(errors.mean[0][5]),
            turned.count()
        ),
    }
}

fn velvet(errors: &[f64], turned: &[f64], eigenimages: &Eigenimages) -> Claim {
    let count = needed(errors, REPRESENTED);
    Claim {
        paper: "about five for velvet".into(),
        condition: format!("{ABOUT_FIVE} components leave at most {}", whole(REPRESENTED)),
        holds: count.is_some_and(|count| count <= ABOUT_FIVE),
        found: format!(
            "that takes {}; five leave {}{}; with every light turned every way {}, and five leave {}",
            components(count),
            percent(errors[5]),
            step(errors, eigenimages).unwrap_or_default(),
            components(needed(turned, REPRESENTED)),
            percent(turned[5])
        ),
    }
}

/// The component after the fifth, among those shown in Fig. 3, that reduces the error the most, and
/// its appearance.
fn step(errors: &[f64], eigenimages: &Eigenimages) -> Option<String> {
    let taken = |component: usize| errors[component] - errors[component + 1];
    let shown = 5..eigenimages.shapes.len();
    let component = shown.max_by(|a, b| taken(*a).total_cmp(&taken(*b)))?;
    let shape = eigenimages.shapes.get(component)?;
    Some(format!(
        ", and component {component}, counted from 0, takes {} off, more than any other of Fig. 3 from 5 on: m = {}, {} of \
         its square in the outer tenth of the disc",
        percent(taken(component)),
        shape.order,
        percent(shape.rim)
    ))
}

fn leather(errors: &[f64], highlights: &Highlights) -> Claim {
    let [least, middle, most] = highlights.spread();
    Claim {
        paper: "30 to 50 for leather's specularity".into(),
        condition: format!(
            "its brightest point is right to {} from 30 to 50 components on, under the median light",
            whole(LIMIT)
        ),
        holds: is_thirty_to_fifty(middle),
        found: format!(
            "from {} on in the median of {} lights, {} to {} among them; {} left with 30, {} with 50 over all lights; 1 % takes {}, 0.1 % takes {}",
            components(middle),
            highlights.lights.len(),
            components(least),
            components(most),
            percent(errors[30]),
            percent(errors[50]),
            components(needed(errors, 0.01)),
            components(needed(errors, 0.001))
        ),
    }
}

/// The number of components from which a material's brightest point is right and stays right, with
/// all modes.
#[must_use]
pub fn highlight(reconstructions: &Reconstructions, material: &str) -> Option<usize> {
    let is_it = |names: [&str; 2]| names[0] == material;
    let course = reconstructions
        .courses
        .iter()
        .find(|course| is_it(course.names) && course.modes == Modes::All)?;
    right_from(&course.brightest)
}

/// A limit in percent.
#[must_use]
pub fn whole(share: f64) -> String {
    format!("{} %", 100.0 * share)
}

/// Whether this agrees with the paper's statement about leather.
#[must_use]
pub fn is_thirty_to_fifty(count: Option<usize>) -> bool {
    count.is_some_and(|count| (30..=50).contains(&count))
}
