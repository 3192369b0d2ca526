//! What each change redoes with the shipped table, in multiplications
//! and in what was counted.

use super::cells::{line, number};
use super::counts::{Column, Counts, M0, M3, M4F, RV32};
use eigenshade_cli::shipped;
use eigenshade_table::parts::NONE;
use eigenshade_table::{Parts, decode};

/// Multiplications of each step, of the shipped table's 50 components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Multiplications {
    /// A light on a folded material: one for each number of a transfer that is not padding.
    pub relight: usize,
    /// Components to polynomials: one for each term of each component.
    pub collapse: usize,
    /// A material: polar integrals, then factors, padding apart.
    pub transfer: usize,
    /// Elements of the rotation matrices.
    pub turn: usize,
    /// A pixel: terms, and four for each azimuth's cosine and sine, two for its sum.
    pub pixel: usize,
}

/// Those of the shipped table.
pub fn multiplications() -> Multiplications {
    let parts = Parts::new(&decode(shipped::TABLE).expect("the shipped table"));
    let (degree, order) = (parts.degree, parts.order);
    let mut all = Multiplications { relight: 0, collapse: 0, transfer: 0, turn: 0, pixel: 0 };
    let pairs: usize = (0..=order).map(|q| (order - q) / 2 + 1).sum();
    for place in &parts.profiles {
        let azimuth = usize::from(place.azimuth);
        let signs = [place.plus, place.minus].iter().filter(|&&index| index != NONE).count();
        all.relight += signs * (degree + 1 - azimuth);
        all.collapse += signs * usize::from(parts.lengths[azimuth]);
        all.transfer += (degree + 1 - azimuth) * pairs;
    }
    for q in 0..=order {
        all.transfer += ((order - q) / 2 + 1).pow(2) * (degree + 1 - q);
    }
    all.turn = (1..=degree).map(|l| (2 * l + 1).pow(2)).sum();
    for (azimuth, &length) in parts.lengths.iter().enumerate().filter(|(_, length)| **length > 0) {
        all.pixel += usize::from(length) * if azimuth == 0 { 1 } else { 2 };
        all.pixel += if azimuth == 0 { 0 } else { 6 };
    }
    all
}

/// The table of the page; `host` has the ratios of times, row by row.
pub fn changes(counts: &Counts, host: &[f64]) -> String {
    let found = multiplications();
    let mut text = String::from(
        "
## Only when it changes

What has to be done again, of the shipped table (degree 9, order 7, K = 50), one channel; the rest is kept. Multiplications are those of the method, without padding; instructions up to the image's
polynomials; host times are in nine-term pixels, of calls that return their answer.

| what is new | redone | kept | multiplications | M4F `f32` | M0 `q15` | M3 `q15` | RV32 `q15` | host |
|---|---|---|---:|---:|---:|---:|---:|---:|
",
    );
    let instructions = |on, operations: &[&str]| -> String {
        let of = |operation: &&str| counts.get(on, operation, Column::Instructions);
        number(operations.iter().map(of).sum())
    };
    // Of three channels.
    let turn = counts.get(M4F, "sun_leather_turning/turn", Column::Instructions);
    let light = counts.get(M4F, "relight_collapse", Column::Instructions);
    let turned = turn.zip(light).map(|(turn, light)| turn / 3 + light);
    let boards = [M4F, M0, M3, RV32];
    let relit = boards.map(|on| instructions(on, &["relight_collapse"]));
    let folded = boards.map(|on| instructions(on, &["transfer", "relight_collapse"]));
    let shaded = boards.map(|on| instructions(on, &["shade"]));
    let none = || String::from("-");
    let relight = found.relight + found.collapse;
    for (k, (what, redone, kept, products, counts)) in [
        (
            "light",
            "`relight`, `collapse`",
            "the material's transfer",
            number(Some(relight as u64)),
            relit,
        ),
        (
            "light, turned",
            "`Light::turned`, `relight`, `collapse`",
            "the material's transfer",
            format!(
                "{} matrix elements of some twenty each, then {}",
                number(Some(found.turn as u64)),
                number(Some(relight as u64))
            ),
            [number(turned), none(), none(), none()],
        ),
        (
            "material",
            "`transfer`, `relight`, `collapse`",
            "the light's coefficients",
            number(Some((found.transfer + relight) as u64)),
            folded,
        ),
        (
            "view of the same light: normals",
            "each pixel: `shade`",
            "the scene, all of it",
            format!("{} a pixel", found.pixel),
            shaded,
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let mut cells = vec![what.into(), redone.into(), kept.into(), products];
        cells.extend(counts);
        cells.push(format!("×{}", number(Some(host[k].round() as u64))));
        line(&mut text, &cells);
    }
    text += "
A pixel on the boards is one of `shade`, a scene of 130 components to 1e-4; the shipped table's is shorter. A camera that moves turns the light in its frame, and shows other normals: both rows. Nothing on the boards turns light in integers.
`Light::turned` makes the matrices anew for each channel: three channels take three times as long.
";
    text
}
