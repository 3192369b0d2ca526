//! A table as Rust source: typed statics for the runtime.

use crate::parts::{NONE, Parts, Pass, ProfilePlace, Row};
use crate::table::{General, Table};
use crate::{rust_kernels, rust_scene};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::layout;
use std::fmt::Write;

/// The body of a module with the table's statics in f32, its capacities and its
/// types; it names the runtime as `eigenshade`.
///
/// `command` is what made it, for the first line. Domain: a table that
/// [projects](Table::has_projection).
#[must_use]
pub fn module(table: &Table, command: &str) -> String {
    let parts = Parts::new(table);
    let row = layout::row(parts.effects.factored_order(parts.order));
    let degrees = parts.degree + 1;
    let along = layout::LANES * layout::groups(parts.degree);
    let workspace = degrees * (row + 2) + row * along;
    let span = match &table.general {
        Some(_) => parts.components,
        None => 0,
    };
    let mut text =
        format!("// {command}\n// {} bytes of tables\n", bytes(&parts) + general_bytes(table));
    for (name, what, value) in [
        ("DEGREE", "Largest degree l of the light.", parts.degree),
        ("ORDER", "Largest order o of the BRDF.", parts.order),
        ("COMPONENTS", "Number of components K.", table.count()),
        ("WORKSPACE", "Numbers in the workspace of a projection.", workspace + span),
        ("TRANSFER", "Numbers in a [`Transfer`].", transfer_length(&parts)),
        ("SCENE", "Numbers in a [`Scene`].", scene_length(&parts)),
    ] {
        line(&mut text, format_args!("/// {what}\npub const {name}: usize = {value};"));
    }
    for (name, values) in floats(&parts) {
        array(&mut text, name, "f32", values.iter().map(|&value| format!("{:?}", value as f32)));
    }
    let pairs = parts.recurrences.iter().map(|[at, below]| format!("[{at:?}, {below:?}]"));
    array(&mut text, "RECURRENCES", "[f32; 2]", pairs);
    array(&mut text, "LENGTHS", "u16", parts.lengths.iter().map(u16::to_string));
    array(&mut text, "SLOTS", "u16", parts.slots.iter().map(u16::to_string));
    array(&mut text, "SELECTION", "bool", parts.selection.iter().map(bool::to_string));
    let passes = parts.passes.iter();
    let passes =
        passes.map(|pass| format!("eigenshade::Pass::new({}, {})", pass.first, pass.profiles));
    array(&mut text, "PASSES", "eigenshade::Pass", passes);
    let couplings = parts.couplings.iter();
    let couplings = couplings.map(|[o, p]| format!("eigenshade::Coupling::new({o}, {p})"));
    array(&mut text, "COUPLINGS", "eigenshade::Coupling", couplings);
    array(&mut text, "PROFILES", "eigenshade::ProfilePlace", parts.profiles.iter().map(place));
    text.push_str(TYPES);
    if let Some(knots) = table.scene.basis.knots {
        sampling(&mut text, &parts, knots);
    }
    match &table.general {
        None => {
            basis(&mut text, "BASIS", "The basis", parts.components, &effects(parts.effects));
            text.push_str(SPHERE);
            text.push_str(&rust_kernels::functions(&parts));
            text.push_str(&rust_scene::collapse(&parts));
            text.push_str(&rust_scene::shade(&parts));
        }
        Some(general) => {
            let effects = effects(parts.effects);
            basis(&mut text, "SPAN", "The span of the basis", parts.components, &effects);
            for (name, values) in general_floats(general) {
                let values = values.iter().map(|&value| format!("{:?}", value as f32));
                array(&mut text, name, "f32", values);
            }
            text.push_str(GENERAL);
            text.push_str(&rust_scene::shade(&parts));
        }
    }
    text
}

/// The arrays of the number format.
fn floats(parts: &Parts) -> [(&'static str, &[f64]); 6] {
    [
        ("POLAR", &parts.polar),
        ("FACTORS", &parts.factors),
        ("AMBIENT", &parts.ambient),
        ("TERMS", &parts.terms),
        ("MEAN", &parts.mean),
        ("MEAN_COEFFICIENTS", &parts.mean_coefficients),
    ]
}

/// Bytes of all statics: f32 and u16 arrays, bools, 4 bytes a pass or a
/// coupling, 24 a profile.
fn bytes(parts: &Parts) -> usize {
    let floats: usize = floats(parts).iter().map(|(_, values)| values.len()).sum();
    let shorts = parts.lengths.len() + parts.slots.len();
    let records = 4 * parts.passes.len() + 4 * parts.couplings.len() + 24 * parts.profiles.len();
    4 * floats + 8 * parts.recurrences.len() + 2 * shorts + parts.selection.len() + records
}

/// The arrays of a general basis.
fn general_floats(general: &General) -> [(&'static str, &[f64]); 4] {
    [
        ("PROJECTION", &general.projection),
        ("SYNTHESIS", &general.synthesis),
        ("SPAN_MEAN", &general.mean),
        ("IMAGE_MEAN", &general.mean_coefficients),
    ]
}

fn general_bytes(table: &Table) -> usize {
    let Some(general) = &table.general else { return 0 };
    general_floats(general).iter().map(|(_, values)| 4 * values.len()).sum()
}

fn transfer_length(parts: &Parts) -> usize {
    let of_pass = |pass: &Pass| {
        let degrees = parts.degree + 1 - layout::lowest_degree(pass.first.into());
        layout::LANES * usize::from(pass.profiles) * degrees
    };
    parts.passes.iter().map(of_pass).sum()
}

fn scene_length(parts: &Parts) -> usize {
    let lengths = parts.lengths.iter().map(|&length| usize::from(length));
    let both: usize = lengths.map(|length| 2 * length).sum();
    both - parts.lengths.first().map_or(0, |&length| usize::from(length))
}

fn place(place: &ProfilePlace) -> String {
    let number = |index: u16| {
        if index == NONE { "None".into() } else { format!("Some({index})") }
    };
    let row = |row: Row| format!("eigenshade::Row::new({}, {})", row.start, row.step);
    format!(
        "eigenshade::ProfilePlace::new({}, {}, {}, {}, {})",
        place.azimuth,
        number(place.plus),
        number(place.minus),
        row(place.plus_row),
        row(place.minus_row)
    )
}

/// A static array of these items.
fn array(text: &mut String, name: &str, kind: &str, items: impl Iterator<Item = String>) {
    let items: Vec<String> = items.collect();
    let count = items.len();
    line(text, format_args!("static {name}: [{kind}; {count}] = [{}];", items.join(", ")));
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}

/// The function that samples an image at the scene's knots.
fn sampling(text: &mut String, parts: &Parts, knots: usize) {
    let last = parts.lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    let room = (2 * last + 1) * (knots + 2);
    line(
        text,
        format_args!(
            "/// Knots of a [`SampledScene`].
pub const KNOTS: usize = {knots};
/// Numbers in a [`SampledScene`].
pub const SAMPLES: usize = {room};
/// One image, sampled.
pub type SampledScene = eigenshade::SampledScene<f32, eigenshade::SampledBuffer<f32, SAMPLES>>;
/// Samples an image: see [`eigenshade::Scene::sampled`].
///
/// # Errors
///
/// Never: the capacity and the number of knots are those of this table.
pub fn sampled(scene: &Scene) -> Result<SampledScene, eigenshade::Error> {{
    scene.sampled::<f32, SAMPLES>(KNOTS)
}}"
        ),
    );
}

/// A set of effects as an expression.
pub(crate) fn effects(effects: Effects) -> String {
    let mut text = String::from("eigenshade::Effects::NONE");
    if effects.is_all() {
        return "eigenshade::Effects::ALL".into();
    }
    for effect in Effect::ALL.into_iter().filter(|&effect| effects.has(effect)) {
        let _ = write!(text, ".with(eigenshade::Effect::{effect:?})");
    }
    text
}

/// The static of the basis, or of a general one's span.
fn basis(text: &mut String, name: &str, what: &str, components: usize, effects: &str) {
    line(
        text,
        format_args!(
            "/// {what}; its shape was checked when it was compiled.
pub static {name}: eigenshade::Basis<'static, f32> =
    match eigenshade::Basis::new(eigenshade::Parts {{
        degree: DEGREE,
        order: ORDER,
        effects: {effects},
        components: {components},
        profiles: &PROFILES,
        passes: &PASSES,
        slots: &SLOTS,
        couplings: &COUPLINGS,
        lengths: &LENGTHS,
        polar: &POLAR,
        factors: &FACTORS,
        ambient: &AMBIENT,
        terms: &TERMS,
        recurrences: &RECURRENCES,
        mean: &MEAN,
        mean_coefficients: &MEAN_COEFFICIENTS,
        selection: &SELECTION,
    }}) {{
        Ok(basis) => basis,
        Err(_) => panic!(\"the table's parts do not fit together\"),
    }};"
        ),
    );
}

/// The types of every table.
const TYPES: &str = "/// The coefficients d of one image.
pub type Coefficients = eigenshade::Coefficients<f32, COMPONENTS>;
/// The transfer of one material.
pub type Transfer = eigenshade::Transfer<f32, TRANSFER>;
/// A scene of this table's size.
type Collapsed = eigenshade::Scene<'static, eigenshade::SceneBuffer<f32, SCENE>>;
/// One image, ready to be shaded. It dereferences to an [`eigenshade::Scene`].
#[derive(Clone, Debug, PartialEq)]
pub struct Scene(Collapsed);
impl core::ops::Deref for Scene {
    type Target = Collapsed;
    #[inline]
    fn deref(&self) -> &Collapsed {
        &self.0
    }
}
/// Number of coefficients of a light.
pub const LIGHT: usize = (DEGREE + 1) * (DEGREE + 1);
/// Coefficients of a light of this table's degree.
pub type LightBuffer = eigenshade::LightBuffer<f32, LIGHT>;
/// The coefficients of a light after rotation: see [`eigenshade::Light::turned`].
///
/// # Errors
///
/// [`Error::Capacity`](eigenshade::Error::Capacity) if the light has a higher degree than this
/// table.
pub fn turned(
    light: &eigenshade::Light<'_, f32>,
    rotation: &eigenshade::Rotation<f32>,
) -> Result<LightBuffer, eigenshade::Error> {
    light.turned::<LIGHT, { eigenshade::Light::<f32>::turn_len(DEGREE) }>(rotation)
}
/// The coefficients of a light after a window: see [`eigenshade::Light::windowed`].
///
/// # Errors
///
/// [`Error::Capacity`](eigenshade::Error::Capacity) if the light has a higher degree than this
/// table.
pub fn windowed(
    light: &eigenshade::Light<'_, f32>,
    window: eigenshade::Window<f32>,
) -> Result<LightBuffer, eigenshade::Error> {
    light.windowed::<eigenshade::mathematics::SinglePrecision, LIGHT>(window)
}
";

/// The functions of a sphere's table, but those with kernels of their own.
const SPHERE: &str = "/// The transfer of a material: see [`eigenshade::Basis::transfer`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn transfer(material: &eigenshade::Material<'_, f32>) -> Result<Transfer, eigenshade::Error> {
    BASIS.transfer::<WORKSPACE, TRANSFER>(material)
}
/// [`project`] for some effects only: see [`eigenshade::Basis::project_effects_into`].
///
/// # Errors
///
/// The same.
pub fn project_effects(
    light: &eigenshade::Light<'_, f32>,
    material: &eigenshade::Material<'_, f32>,
    effects: eigenshade::Effects,
) -> Result<Coefficients, eigenshade::Error> {
    BASIS.project_effects::<WORKSPACE, COMPONENTS>(light, material, effects)
}
/// [`transfer`] for some effects only: see [`eigenshade::Basis::transfer_effects_into`].
///
/// # Errors
///
/// The same.
pub fn transfer_effects(
    material: &eigenshade::Material<'_, f32>,
    effects: eigenshade::Effects,
) -> Result<Transfer, eigenshade::Error> {
    BASIS.transfer_effects::<WORKSPACE, TRANSFER>(material, effects)
}
/// An estimate of the coefficients d from pixels.
pub type Estimate = eigenshade::Estimate<'static, f32, COMPONENTS>;
/// Starts an estimate from pixels: see [`eigenshade::Basis::estimate`].
///
/// # Errors
///
/// None: the capacity is that of this table.
pub fn estimate() -> Result<Estimate, eigenshade::Error> {
    BASIS.estimate()
}
/// The scene of some coefficients with as few terms as a tolerance allows: see
/// [`eigenshade::Basis::collapse_within`]. `lengths` receives the lengths of its polynomials.
///
/// # Errors
///
/// [`Error::Tolerance`](eigenshade::Error::Tolerance) unless the tolerance is above zero.
pub fn collapse_within<'l>(
    coefficients: &Coefficients,
    tolerance: eigenshade::Tolerance<f32>,
    lengths: &'l mut [u16; DEGREE + 1],
) -> Result<(Truncated<'l>, eigenshade::Truncation<f32>), eigenshade::Error> {
    let buffer = eigenshade::SceneBuffer::from([0.0; SCENE]);
    BASIS.collapse_within(coefficients, tolerance, lengths, buffer)
}
/// A scene with fewer terms than a [`Scene`].
pub type Truncated<'l> = eigenshade::Scene<'l, eigenshade::SceneBuffer<f32, SCENE>>;
";

/// The basis and the functions of a general table.
const GENERAL: &str = "/// The basis; its shape was checked when it was compiled.
pub static BASIS: eigenshade::GeneralBasis<'static, f32> =
    match eigenshade::GeneralBasis::new(SPAN, eigenshade::GeneralParts {
        components: COMPONENTS,
        projection: &PROJECTION,
        synthesis: &SYNTHESIS,
        mean: &SPAN_MEAN,
        mean_coefficients: &IMAGE_MEAN,
    }) {
        Ok(basis) => basis,
        Err(_) => panic!(\"the table's parts do not fit together\"),
    };
/// d = UᵀMc: see [`eigenshade::GeneralBasis::project`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn project(
    light: &eigenshade::Light<'_, f32>,
    material: &eigenshade::Material<'_, f32>,
) -> Result<Coefficients, eigenshade::Error> {
    BASIS.project::<WORKSPACE, COMPONENTS>(light, material)
}
/// The transfer of a material in the span: see [`eigenshade::Basis::transfer`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn transfer(material: &eigenshade::Material<'_, f32>) -> Result<Transfer, eigenshade::Error> {
    SPAN.transfer::<WORKSPACE, TRANSFER>(material)
}
/// A new light on a transferred material: see [`eigenshade::GeneralBasis::relight`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn relight(
    transfer: &Transfer,
    light: &eigenshade::Light<'_, f32>,
) -> Result<Coefficients, eigenshade::Error> {
    BASIS.relight::<TRANSFER, WORKSPACE, COMPONENTS>(transfer, light)
}
/// Sums the eigenimages azimuth by azimuth: see
/// [`eigenshade::GeneralBasis::collapse`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {
    BASIS.collapse::<WORKSPACE, SCENE>(coefficients).map(Scene)
}
";
