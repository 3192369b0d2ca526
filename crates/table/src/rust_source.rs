//! A table as Rust source: typed statics for the runtime.

use crate::parts::{NONE, Parts};
use crate::table::Table;
use eigenshade_index::{layout, pair};
use std::fmt::Write;

/// The body of a module with the table's statics in f32, its capacities and its
/// types; it names the runtime as `eigenshade`.
///
/// `command` is what made it, for the first line.
#[must_use]
pub fn module(table: &Table, command: &str) -> String {
    let parts = Parts::new(table);
    let stride = layout::stride(parts.degree);
    let scattering = pair::count(parts.order) * stride;
    let groups = parts
        .profiles
        .iter()
        .map(|p| layout::groups(parts.degree, p.azimuth.into()));
    let transfer = layout::LANES * groups.sum::<usize>();
    let signs =
        |(azimuth, &length): (usize, &u16)| usize::from(length) * if azimuth == 0 { 1 } else { 2 };
    let terms: usize = parts.lengths.iter().enumerate().map(signs).sum();
    let arrays = [
        ("POLAR", &parts.polar),
        ("FACTORS", &parts.factors),
        ("TERMS", &parts.terms),
        ("MEAN", &parts.mean),
        ("MEAN_COEFFICIENTS", &parts.mean_coefficients),
    ];
    let floats: usize = arrays.iter().map(|(_, values)| values.len()).sum();
    let bytes =
        4 * floats + 6 * parts.profiles.len() + 2 * parts.lengths.len() + parts.selection.len();
    let mut text = format!("// {command}\n// {bytes} bytes of tables\n");
    let constants = [
        ("DEGREE", "Largest degree l of the light.", parts.degree),
        ("ORDER", "Largest order o of the BRDF.", parts.order),
        ("COMPONENTS", "Number of components K.", parts.components),
        (
            "SCATTERING",
            "Numbers that a folded material holds while it is projected.",
            scattering,
        ),
        ("TRANSFER", "Numbers in a [`Transfer`].", transfer),
        ("SCENE", "Numbers in a [`Scene`].", terms),
    ];
    for (name, what, value) in constants {
        line(
            &mut text,
            format_args!("/// {what}\npub const {name}: usize = {value};"),
        );
    }
    for (name, values) in arrays {
        let rounded: Vec<f32> = values.iter().map(|&value| value as f32).collect();
        line(
            &mut text,
            format_args!("static {name}: [f32; {}] = {rounded:?};", values.len()),
        );
    }
    line(
        &mut text,
        format_args!(
            "static LENGTHS: [u16; {}] = {:?};",
            parts.lengths.len(),
            parts.lengths
        ),
    );
    line(
        &mut text,
        format_args!(
            "static SELECTION: [bool; {}] = {:?};",
            parts.selection.len(),
            parts.selection
        ),
    );
    line(
        &mut text,
        format_args!(
            "static PROFILES: [eigenshade::ProfilePlace; {}] = [",
            parts.profiles.len()
        ),
    );
    for place in &parts.profiles {
        let number = |index: u16| {
            if index == NONE {
                "None".into()
            } else {
                format!("Some({index})")
            }
        };
        line(
            &mut text,
            format_args!(
                "    eigenshade::ProfilePlace::new({}, {}, {}),",
                place.azimuth,
                number(place.plus),
                number(place.minus)
            ),
        );
    }
    text.push_str(FACE);
    text
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}

/// What follows the numbers: the same for every table.
const FACE: &str = "];
/// The basis; its shape was checked when it was compiled.
pub static BASIS: eigenshade::Basis<'static, f32> =
    match eigenshade::Basis::new(eigenshade::Parts {
        degree: DEGREE,
        order: ORDER,
        components: COMPONENTS,
        profiles: &PROFILES,
        lengths: &LENGTHS,
        polar: &POLAR,
        factors: &FACTORS,
        terms: &TERMS,
        mean: &MEAN,
        mean_coefficients: &MEAN_COEFFICIENTS,
        selection: &SELECTION,
    }) {
        Ok(basis) => basis,
        Err(_) => panic!(\"the table's parts do not fit together\"),
    };
/// The coefficients d of one image.
pub type Coefficients = eigenshade::Coefficients<f32, COMPONENTS>;
/// One material, folded into the basis.
pub type Transfer = eigenshade::Transfer<f32, TRANSFER>;
/// One image, ready to be shaded.
pub type Scene = eigenshade::Scene<'static, eigenshade::SceneBuffer<f32, SCENE>>;
/// d = UᵀMc: see [`eigenshade::Basis::project`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn project(
    light: &eigenshade::Light<'_, f32>,
    material: &eigenshade::Material<'_, f32>,
) -> Result<Coefficients, eigenshade::Error> {
    BASIS.project::<SCATTERING, COMPONENTS>(light, material)
}
/// Folds a material into the basis: see [`eigenshade::Basis::transfer`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn transfer(material: &eigenshade::Material<'_, f32>) -> Result<Transfer, eigenshade::Error> {
    BASIS.transfer::<SCATTERING, TRANSFER>(material)
}
/// A new light on a folded material: see [`eigenshade::Basis::relight`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn relight(
    transfer: &Transfer,
    light: &eigenshade::Light<'_, f32>,
) -> Result<Coefficients, eigenshade::Error> {
    BASIS.relight(transfer, light)
}
/// Sums the components of each azimuth: see [`eigenshade::Basis::collapse`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {
    BASIS.collapse::<SCENE>(coefficients)
}
";
