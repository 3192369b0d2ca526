//! The hard cases, measured, as a page:
//! `cargo run --release --example stability -- --out docs/stability.md`, or with
//! `--check` instead of `--out` to compare the page with what is measured now.
//!
//! Hosts differ in the last bits. So a figure that was recorded may be another by a
//! factor of eight, or a rounding; all else has to be the same, and every bound has to hold.

#[path = "../tests/oracle/mod.rs"]
mod oracle;
#[path = "../tests/stability/mod.rs"]
mod stability;
#[path = "../tests/tolerances/mod.rs"]
mod tolerances;

use stability::{Bound, CASES, Case, Figure};
use std::fmt::Write;
use std::process::ExitCode;

const COMMAND: &str = "cargo run --release --example stability -- --out docs/stability.md";

const HEAD: &str = "\
# Stability

Cases in which arithmetic goes wrong if nobody looks: what goes wrong, what is done about it, and how far off the answer is, measured
against an oracle. Images are measured against the direct sum (15), and that in `tests/paper.rs` against quadrature of (3). `tests/hard_cases.rs`
asserts every bound; they stand with their reasons in `tests/tolerances/mod.rs`. An error of the naive way has to be at least its bound, or the
case is none; a count has to be exact.

| case | naively | here | measured (bound) |
|---|---|---|---|
";

const TAIL: &str = "
## Through the command line

`crates/cli/tests/hard_cases.rs` asserts these, or the file that is named; the bounds stand in the same place.

| case | naively | here |
|---|---|---|
| a map of half floats with infinities and NaN | one such texel spoils every coefficient | refused, with how many there are and where the first is |
| negative texels, the largest and the smallest half | clamped to zero | kept; their share is reported |
| maps of 2 x 1 and 8192 x 4096 | a division by height - 1; minutes | their closed forms, in a second |
| a light of zeros | an infinite exposure | refused by name, or taken with `normalise = \"none\"`; its images are exactly 0 |
| a material of zeros, alone or among others | 0/0 | a table; its images are exactly 0 |
| one light and one material; more components than rank | components of rounding | as many as there are, and it says so |
| normals of length 1e-320 and 1e308, zero, NaN, pointing away | a square that vanishes or overflows | scaled before they are squared; the others are refused with their line |
| coefficients at 1e-30 and 1e+30, light against material | infinity from a finite answer | linear to rounding in f64 and f32 |
| flat objects, a patch of 2e-4, two normals within 1e-9, weights over twelve decades (`flat_objects.rs`) | components of rounding; pictures of light normals lost | as many as the normals can tell apart; both criteria give the pictures |
| a mesh with degenerate triangles (`flat_objects.rs`) | NaN | the same eigenvalues, to the digit, as without them |
| a sun: one texel of 64 x 32 a million times the rest (`hard_databases.rs`) | coefficients without the sky | the sums of its texels' harmonics to the digits written; pictures under it against quadrature of (3) |
| all materials alike; Lambertian materials only; a covariance of rank one (`hard_databases.rs`) | components of rounding | as many as there are; eigenvalues, variance and pictures by other ways |
| the same scene again, and with 1, 2 and 3 threads (`thread_counts.rs`) | another order, another sign | the same bytes; the linear algebra is built for one thread |
| ten thousand facets that fill the picture (`visible_facets.rs` of the generator) | every sample of every facet: minutes | what lies behind whole tiles of samples is settled at once |
| a PNG with a colour profile or a text that unpacks to a thousand times its size (`png_memory.rs` of the generator) | it is unpacked before it is refused | what is not the picture stays packed |
| images of 1e155 or 1e-180 | eigenvalues, squares, infinite or all zero: a table that cannot be read | refused, before a table is written |

## Properties

`tests/properties` draws scenes at random: degrees to 8, orders to 7, sizes of lights and materials over up to 120 decades, empty and copied
materials, selections of modes, cut-offs from 1e-12 to 1e-5. Of each it asserts WᵀW = I and UᵀMU = I (that to what the cut-off may
take), |d|² + residual = cᵀMc, linearity, that turning light and normals about the view changes nothing, that fewer components or a coarser cut-off give a
prefix, the order and sign of components, and reciprocity. Light, view and normal turned by any rotation of SO(3), and the normal's frame by any γ, change nothing.

So it does with objects: lists of normals with weights over up to six decades, half circles, rims, patches of 1e-9 to 0.1, densities of slants, under light
that is turned freely, about the vertical axis, or not, with all modes or some. Parseval over the object's normals, linearity in light and material, prefixes; of all but densities, which are
hundreds of normals, UᵀMU = I over modes and pixel by pixel (to what the cut-offs may take), that a coarser cut-off moves singular values by no more than it takes, and that object and
light turned about the view have the same eigenvalues.

What a thousand cases of each found are tests by name, in `tests/properties/found.rs`: a prefix whose U differs in the last bits at a cut-off of 8e-11; the energy of an image that is
the mean image, and of a dark rim, which are right against their coefficients and not against themselves; a cut-off that takes a part of the constant, refused by its name.

## What is not covered

* Components whose eigenvalues differ by less than their rounding, 1e-16 of the largest, in one azimuth: their span is right, each alone is
  as the host's arithmetic has it.
* f32 pixels at high degree: see degree 32 above, and [method.md](method.md#limits).
* Ratios of times are told and not asserted: those above are of an x86-64 processor that hardly slows down for subnormal numbers. Others may take a hundred times
  as long for each, and a pixel at 1e-30 has about one. So in f32 a light is kept near 1, and the image scaled.
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (purpose, path) = match arguments.as_slice() {
        [purpose, path] if purpose == "--out" || purpose == "--check" => (purpose, path),
        _ => {
            eprintln!("usage: stability --out FILE | --check FILE");
            return ExitCode::from(2);
        }
    };
    let measured: Vec<(&Case, Vec<Figure>)> = CASES
        .iter()
        .map(|case| {
            eprintln!("{}", case.name);
            (case, (case.measure)())
        })
        .collect();
    let mut broken = false;
    for (case, figures) in &measured {
        for figure in figures.iter().filter(|figure| !figure.holds()) {
            eprintln!(
                "error: {}: {} is {:e}, not {}",
                case.name,
                figure.what,
                figure.found,
                bound(figure)
            );
            broken = true;
        }
    }
    if broken {
        return ExitCode::from(1);
    }
    let page = page(&measured);
    let answer = if purpose == "--out" {
        std::fs::write(path, page).map_err(|error| format!("{path}: {error}"))
    } else {
        std::fs::read_to_string(path)
            .map_err(|error| format!("{path}: {error}"))
            .and_then(|recorded| compare(path, &recorded, &page))
    };
    match answer {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}; make it again with `{COMMAND}`");
            ExitCode::from(1)
        }
    }
}

fn page(measured: &[(&Case, Vec<Figure>)]) -> String {
    let mut page = format!("<!-- {COMMAND} -->\n{HEAD}");
    for (case, figures) in measured {
        let cells: Vec<String> = figures.iter().map(cell).collect();
        let texts = [case.name, case.naively, case.here, &cells.join("<br>")];
        // A bar would end the table's cell.
        let texts = texts.map(|text| text.replace('|', "\\|"));
        writeln!(page, "| {} |", texts.join(" | ")).expect("a string takes everything");
    }
    page + TAIL
}

/// `what: found (bound)`, the error with one digit.
fn cell(figure: &Figure) -> String {
    let found = match figure.bound {
        Bound::Exactly(_) => figure.found.to_string(),
        Bound::Told => format!("×{:.1}", figure.found),
        _ => format!("{:.0e}", figure.found),
    };
    format!("{}: {found} ({})", figure.what, bound(figure))
}

fn bound(figure: &Figure) -> String {
    match figure.bound {
        Bound::Most(bound) => format!("≤ {bound:e}"),
        Bound::Least(bound) => format!("≥ {bound:e}"),
        Bound::Exactly(bound) => format!("= {bound}"),
        Bound::Told => "not asserted".to_owned(),
    }
}

/// Word by word; where both words are numbers with an exponent, they may differ by
/// [`tolerances::PAGE_FACTOR`], or both be [`tolerances::PAGE_ROUNDING`]; ratios of times are not compared.
fn compare(path: &str, recorded: &str, page: &str) -> Result<(), String> {
    let (old, new): (Vec<_>, Vec<_>) = (recorded.lines().collect(), page.lines().collect());
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        let (old, new) = (old.split_whitespace(), new.split_whitespace());
        let same = old.clone().count() == new.clone().count()
            && old.zip(new).all(|(old, new)| old == new || near(old, new));
        if !same {
            return Err(format!("{path}:{}: it says something else than is measured", line + 1));
        }
    }
    if old.len() == new.len() { Ok(()) } else { Err(format!("{path}: it has other cases")) }
}

fn near(old: &str, new: &str) -> bool {
    let number = |word: &str| word.contains('e').then(|| word.parse::<f64>().ok()).flatten();
    match (number(old), number(new)) {
        (Some(old), Some(new)) => {
            let within =
                old / new <= tolerances::PAGE_FACTOR && new / old <= tolerances::PAGE_FACTOR;
            within || old.max(new) < tolerances::PAGE_ROUNDING
        }
        _ => old.starts_with('×') && new.starts_with('×'),
    }
}
