//! The cost of each change with the shipped table: the steps that are recomputed, as
//! multiplications and as counted instructions.

use super::cells::{line, number};
use super::counts::{Column, Counts, M0, M3, M4F, RV32};
use crate::multiplications::Multiplications;
use eigenshade_shading::shipped;
use eigenshade_table::decode;
use eigenshade_table::trim::trim;

/// The table that the boards' `shade` uses, and the share of the rms to which their build script
/// trims its polynomials.
const BOARDS: (&[u8], f64) = (include_bytes!("../../../firmware/tables/full.bin"), 2e-4);

/// Multiplications with the shipped table.
pub fn multiplications() -> Multiplications {
    let table = decode(shipped::TABLE).expect("the shipped table");
    Multiplications::of(&table).expect("a basis")
}

/// Multiplications with the boards' full scene.
fn on_the_boards() -> Multiplications {
    let mut table = decode(BOARDS.0).expect("the boards' table");
    trim(&mut table, BOARDS.1);
    Multiplications::of(&table).expect("a basis")
}

/// The table of the page. The boards use their own table to count a pixel. `host` holds the time
/// ratios, row by row.
pub fn changes(counts: &Counts, host: &[f64]) -> String {
    let found = multiplications();
    let mut text = String::from(
        "\
| what is new | redone | kept | multiplications | M4F `f32` | M0 `q15` | M3 `q15` | RV32 `q15` | host |
|---|---|---|---:|---:|---:|---:|---:|---:|
",
    );
    let instructions = |on, operations: &[&str]| -> String {
        let of = |operation: &&str| counts.get(on, operation, Column::Instructions);
        number(operations.iter().map(of).sum())
    };
    // For three channels.
    let turn = counts.get(M4F, "sun_leather_turning/turn", Column::Instructions);
    let light = counts.get(M4F, "relight_collapse", Column::Instructions);
    let turned = turn.zip(light).map(|(turn, light)| turn / 3 + light);
    let boards = [M4F, M0, M3, RV32];
    let relit = boards.map(|on| instructions(on, &["relight_collapse"]));
    let folded = boards.map(|on| instructions(on, &["transfer", "relight_collapse"]));
    let none = || String::from("-");
    let uncounted = || boards.map(|_| none());
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
            uncounted(),
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
    let on_boards = boards.map(|on| instructions(on, &["shade"]));
    let pixel = format!("{} a pixel", on_the_boards().pixel);
    let cells = ["the same, table `full.toml`", "each pixel: `shade`", "the scene", &pixel];
    let cells = cells.map(String::from).into_iter().chain(on_boards).chain([none()]);
    line(&mut text, &cells.collect::<Vec<_>>());
    text
}
