//! What the page says of pixels beside the nine-term formula.

use super::cells::percent;
use super::counts::{Counts, M0, M4F};
use super::errors::terms_within;
use super::nine_terms;
use super::page::terms;
use super::scenes::Scene;
use super::tolerances;
use eigenshade_cli::median::median;

/// The sentences, each with what was counted and computed.
pub fn sentences(counts: &Counts) -> String {
    let pixel = |name: &str| ratios(counts, &format!("{name}/pixel"));
    let nine = nine_terms::errors();
    let [formula, best] = [0, 1].map(|k| nine.iter().map(|errors| errors[k]).collect::<Vec<_>>());
    let most = |errors: &[f64]| percent(errors.iter().copied().fold(0.0, f64::max));
    let enough = best.iter().filter(|&&error| error <= 1e-2).count();
    let within = terms_within(&Scene::named("park_lambertian_fine"), 1e-2);
    let kept = within.iter().filter(|&&terms| terms <= 9).count();
    let sorted: Vec<f64> = within.iter().map(|&terms| terms as f64).collect();
    format!(
        "
## Beside the nine-term formula

* **A Lambertian material under light of degree 2** costs what the formula costs, with the same answer: {} times its instructions a pixel (`shade_lambertian`; {} is asserted). In f32 its pictures are the formula's to 1e-6 of the peak.
* **A Lambertian material at 1e-2 under any shipped light** does *not* cost nine terms: light of degree 4 is part of the answer. The formula is off by {} in the median of the {} lights
  and by {} at worst; the nearest nine coefficients, found from the answer, by {} and {}, and within 1e-2 under {} of the lights. For 1e-2 `collapse_within` keeps {} terms in the median, {} to {}; nine or fewer under {} of the lights, and under all of them cut to degree 2.
  The scene made for 1e-2 has {} terms and costs {} times as much.
* **Typical scenes at 1e-3** cost less than {} times as much, which is asserted: plaster {}, velvet {}, leather {}.
* **Ambient light** on a Lambertian material is one term, a constant; on velvet {} terms in n_z alone.
* **On the host** the last column above is of these tables as they are, within 1e-3 under every light, in blocks of vectors of lengths that are learnt at run time. What one light needs of the shipped table is less: [performance.md](performance.md) has
  the median image within 1e-3, and mattes.
",
        ratios(counts, "shade_lambertian"),
        tolerances::OF_NINE_TERMS,
        percent(median(&formula)),
        nine.len(),
        most(&formula),
        percent(median(&best)),
        most(&best),
        enough,
        median(&sorted),
        within.iter().min().unwrap_or(&0),
        within.iter().max().unwrap_or(&0),
        kept,
        terms(&Scene::named("park_lambertian")),
        pixel("park_lambertian"),
        tolerances::TYPICAL_OF_NINE_TERMS,
        pixel("studio_plaster"),
        pixel("studio_velvet"),
        pixel("sun_leather"),
        terms(&Scene::named("ambient_velvet")),
    )
}

/// The instructions of a pixel over those of the formula.
fn ratios(counts: &Counts, operation: &str) -> String {
    let of = |on| counts.of_nine_terms(on, operation);
    format!("{:.2} (M0) and {:.2} (M4F)", of(M0), of(M4F))
}
