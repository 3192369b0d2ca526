//! Compares pixels with the nine-term formula.

use super::cells::{line, percent};
use super::counts::{Counts, M0, M4F};
use super::errors::terms_within;
use super::nine_terms;
use super::page::terms;
use super::scenes::Scene;
use crate::median::median;
use crate::tolerances;

/// The table of the page; instruction counts are relative to the formula.
pub fn beside(counts: &Counts) -> String {
    let pixel = |name: &str| ratios(counts, &format!("{name}/pixel"));
    let nine = nine_terms::errors();
    let [formula, best] = [0, 1].map(|k| nine.iter().map(|errors| errors[k]).collect::<Vec<_>>());
    let most = |errors: &[f64]| percent(errors.iter().copied().fold(0.0, f64::max));
    let enough = best.iter().filter(|&&error| error <= 1e-2).count();
    let within = terms_within(&Scene::named("park_lambertian_fine"), 1e-2);
    let kept = within.iter().filter(|&&terms| terms <= 9).count();
    let sorted: Vec<f64> = within.iter().map(|&terms| terms as f64).collect();
    let mut text = String::from(
        "\
| a Lambertian or typical scene, beside the nine-term formula | found |
|---|---:|
",
    );
    let count = |number: usize| number.to_string();
    for (what, found) in [
        (
            "Lambertian under light of degree 2: instructions of a pixel",
            ratios(counts, "shade_lambertian"),
        ),
        ("the same: at most, asserted", format!("{}", tolerances::OF_NINE_TERMS)),
        ("Lambertian under the shipped lights: how many", count(nine.len())),
        ("error of the formula, median", percent(median(&formula))),
        ("error of the formula, worst", most(&formula)),
        ("error of the nearest nine coefficients, median", percent(median(&best))),
        ("error of the nearest nine coefficients, worst", most(&best)),
        ("lights under which nine coefficients are within 1e-2", count(enough)),
        ("terms that `collapse_within` keeps at 1e-2, median", median(&sorted).to_string()),
        ("terms, fewest", count(within.iter().min().copied().unwrap_or(0))),
        ("terms, most", count(within.iter().max().copied().unwrap_or(0))),
        ("lights under which nine terms or fewer are kept", count(kept)),
        ("the scene made for 1e-2: terms", count(terms(&Scene::named("park_lambertian")))),
        ("the scene made for 1e-2: instructions of a pixel", pixel("park_lambertian")),
        ("plaster at 1e-3: instructions of a pixel", pixel("studio_plaster")),
        ("velvet at 1e-3", pixel("studio_velvet")),
        ("leather at 1e-3", pixel("sun_leather")),
        ("the same three: at most, asserted", format!("{}", tolerances::TYPICAL_OF_NINE_TERMS)),
        ("ambient light on velvet: terms", count(terms(&Scene::named("ambient_velvet")))),
    ] {
        line(&mut text, &[what.into(), found]);
    }
    text
}

/// The instruction counts of a pixel relative to the formula.
fn ratios(counts: &Counts, operation: &str) -> String {
    let of = |on| counts.of_nine_terms(on, operation);
    format!("{:.2} (M0) and {:.2} (M4F)", of(M0), of(M4F))
}
