//! A density of slants, given as a formula or a CSV file, converted to weighted normals.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::sheet::Sheet;
use eigenshade_model::special::quadrature::gauss_legendre;
use exmex::{Express, FlatEx, FloatOpsFactory, MatchLiteral, literal_matcher_from_pattern};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;

/// Number of panels for a formula, and minimum number of nodes over all panels.
const PANELS: usize = 8;
const NODES: usize = 192;

literal_matcher_from_pattern!(Number, r"^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?");

/// A formula; its numbers may have an exponent.
type Formula = FlatEx<f64, FloatOpsFactory<f64>, Number>;

/// Maximum number of characters of a formula: the parser's time grows with its square.
const MOST_LETTERS: usize = 1000;

/// Maximum number of slants in a CSV file: steps of a hundredth of a degree.
const MOST_SLANTS: usize = 9001;

/// Whether a density is a file name rather than a formula.
pub(crate) fn is_file(density: &str) -> bool {
    Path::new(density).extension().is_some_and(|end| end.eq_ignore_ascii_case("csv"))
}

/// Weighted normals of an object with the given density of normals per solid angle over the visible
/// hemisphere. The density may have any scale and is the same for all tilts.
///
/// `density` is a formula in the slant `a` in radians (`cos(a)` is the sphere), or the name of a
/// CSV file with the columns `slant,density` in `folder`: linear between its rows, zero beyond
/// them. Quadrature is Gauss-Legendre in the slant and uniform in the tilt. It is exact for images
/// of light up to `degree` if the density is smooth within each panel, which is an eighth of the
/// hemisphere or an interval of the CSV.
///
/// # Errors
///
/// If a formula does not parse, has variables other than `a` or has more than a thousand
/// characters; if a CSV is broken or its slants do not rise within \[0, π/2\]; if a density is
/// negative or not finite.
pub fn read(density: &str, folder: &Path, degree: usize) -> Result<Vec<([f64; 3], f64)>> {
    if is_file(density) {
        let path = folder.join(density);
        let rows = slants(&path)?;
        let panels = rows.windows(2).map(|two| (two[0].0, two[1].0)).collect::<Vec<_>>();
        let linear = |a: f64| {
            let after = rows.partition_point(|row| row.0 <= a).clamp(1, rows.len() - 1);
            let ((low, first), (high, second)) = (rows[after - 1], rows[after]);
            Ok(first + (second - first) * (a - low) / (high - low))
        };
        return ring(&panels, degree, linear).map_err(|error| error.in_file(path));
    }
    let formula = formula(density)?;
    let width = FRAC_PI_2 / PANELS as f64;
    let panels: Vec<(f64, f64)> =
        (0..PANELS).map(|k| (k as f64 * width, (k + 1) as f64 * width)).collect();
    ring(&panels, degree, |a| {
        let variables: &[f64] = if formula.var_names().is_empty() { &[] } else { &[a] };
        formula.eval(variables).map_err(|_| wrong(density, "it has no value"))
    })
}

fn formula(text: &str) -> Result<Formula> {
    if text.len() > MOST_LETTERS {
        let what = format!("geometry.density is a formula of {} letters", text.len());
        let remedy = format!("write it with at most {MOST_LETTERS}, or give a CSV `slant,density`");
        return Err(Error::new(what, remedy));
    }
    let written = signed(text)?;
    // The parser's own message refers to its tokens, so it is replaced.
    let formula = Formula::parse(&written).map_err(|_| wrong(text, "it is not a formula"))?;
    match formula.var_names().iter().find(|name| *name != "a") {
        Some(name) => Err(wrong(text, &format!("it has a variable `{name}`"))),
        None => Ok(formula),
    }
}

/// Rewrites each leading minus as a factor -1, so that `-a^2` is -(a^2) by the usual convention;
/// the parser would read it as (-a)^2.
fn signed(text: &str) -> Result<String> {
    let mut written = String::new();
    let mut before = '(';
    for letter in text.chars() {
        if letter == '-' && "(,+-*/^%".contains(before) {
            if "/^%".contains(before) {
                let why = format!("a minus right after `{before}`");
                return Err(wrong(text, &why).with_remedy("put what follows in parentheses"));
            }
            written.push_str("(0-1)*");
        } else {
            written.push(letter);
        }
        if !letter.is_whitespace() {
            before = letter;
        }
    }
    Ok(written)
}

fn wrong(text: &str, why: &str) -> Error {
    Error::new(
        format!("geometry.density = \"{text}\": {why}"),
        "write a formula in the slant `a`, like \"cos(a)\", or name a .csv",
    )
}

fn slants(path: &Path) -> Result<Vec<(f64, f64)>> {
    let sheet = Sheet::read(path, "slant,density")?;
    let [slant, density] =
        sheet.columns(["slant", "density"]).ok_or_else(|| sheet.wrong_header("`slant,density`"))?;
    let mut rows: Vec<(f64, f64)> = Vec::new();
    for row in sheet.rows() {
        let a = row.number(slant)?;
        if !(0.0..=FRAC_PI_2 + 1e-9).contains(&a) {
            return Err(row.fault(
                format!("slant {a} is not in [0, π/2]"),
                "give slants in radians, from 0 at the camera to π/2 at the rim",
            ));
        }
        if rows.last().is_some_and(|last| a <= last.0) {
            return Err(row.fault(format!("slant {a} does not rise"), "sort the rows by slant"));
        }
        let value = row.number(density)?;
        if value < 0.0 {
            return Err(row.fault(format!("density {value}"), "give it zero or more"));
        }
        rows.push((a.min(FRAC_PI_2), value));
    }
    if !(2..=MOST_SLANTS).contains(&rows.len()) {
        let what = format!("{} slants", rows.len());
        let remedy = format!("give 2 to {MOST_SLANTS}: between them the density is linear");
        return Err(Error::new(what, remedy).in_file(path));
    }
    Ok(rows)
}

/// Rings of normals at the nodes of all panels.
fn ring(
    panels: &[(f64, f64)],
    degree: usize,
    density: impl Fn(f64) -> Result<f64>,
) -> Result<Vec<([f64; 3], f64)>> {
    let nodes = (NODES / panels.len()).max(4);
    let tilts = 2 * degree + 1;
    let mut pairs = Vec::new();
    for &(low, high) in panels {
        for (a, weight) in gauss_legendre(nodes, low, high) {
            let density = density(a)?;
            if !(density >= 0.0 && density.is_finite()) {
                return Err(Error::new(
                    format!("the density at slant {a:.6} is {density}"),
                    "make it finite and not negative over all slants from 0 to π/2",
                ));
            }
            let (sine, z) = a.sin_cos();
            for k in 0..tilts {
                let (y, x) = (TAU * k as f64 / tilts as f64).sin_cos();
                pairs.push(([sine * x, sine * y, z], weight * sine * density));
            }
        }
    }
    Ok(pairs)
}
