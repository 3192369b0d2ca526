//! Projection and relighting of one table as Rust source: calls of the kernels in
//! `eigenshade::specialized`, every size and place a constant.

use crate::parts::{NONE, Parts, ProfilePlace, Row};
use eigenshade_index::{layout, light, material, pair};
use std::fmt::Write;

const LIGHT: &str = "light: &eigenshade::Light<'_, f32>";

/// The functions `project` and `relight` of the generated module.
///
/// A table with a selection of modes takes the general way, since its polar integrals
/// differ from azimuth to azimuth; so does one of effects that leave out orders between
/// others, or whose ambient stands apart.
pub(crate) fn functions(parts: &Parts) -> String {
    let whole = parts.ambient.is_empty() && !parts.couplings.contains(&[NONE; 2]);
    let fixed = parts.selection.is_empty() && whole;
    let body = |body: String| if fixed { body } else { String::new() };
    format!(
        "/// d = UᵀMc: see [`eigenshade::Basis::project`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn project(
    {LIGHT},
    material: &eigenshade::Material<'_, f32>,
) -> Result<Coefficients, eigenshade::Error> {{
{}    BASIS.project::<WORKSPACE, COMPONENTS>(light, material)
}}
/// A new light on a transferred material: see [`eigenshade::Basis::relight`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn relight(
    transfer: &Transfer,
    {LIGHT},
) -> Result<Coefficients, eigenshade::Error> {{
{}    let mut coefficients = eigenshade::specialized::blank_coefficients();
    relight_into(transfer, light, &mut coefficients)?;
    Ok(coefficients)
}}
/// [`relight`] into existing coefficients, without moving them.
///
/// # Errors
///
/// The same; `coefficients` is then left unspecified.
pub fn relight_into(
    transfer: &Transfer,
    {LIGHT},
    coefficients: &mut Coefficients,
) -> Result<(), eigenshade::Error> {{
{}    relight_generally(transfer, light, coefficients)
}}
#[cold]
#[inline(never)]
fn relight_generally(
    transfer: &Transfer,
    {LIGHT},
    coefficients: &mut Coefficients,
) -> Result<(), eigenshade::Error> {{
    *coefficients = BASIS.relight(transfer, light)?;
    Ok(())
}}
",
        body(project(parts)),
        body(by_passes(parts)),
        body(by_orders(parts)),
    )
}

/// One call for up to four profiles of one azimuth.
fn project(parts: &Parts) -> String {
    let (rows, groups) = (parts.degree + 1, layout::row(parts.order) / layout::LANES);
    let (along, padded) = (layout::groups(parts.degree), layout::row(parts.order));
    let (pairs, modes) = (pair::count(parts.order), material::count(parts.order));
    let (count, factors) = (light::count(parts.degree), parts.factors.len());
    let mut text = format!(
        "    if let (Some(light), Some(material), Some(polar)) = (
        eigenshade::specialized::light::<f32, {count}>(light),
        eigenshade::specialized::material::<f32, {modes}>(material),
        eigenshade::specialized::table_rows::<f32, {along}, {pairs}>(&POLAR),
    ) {{
        let mut sums = [[[0.0; {lanes}]; {along}]; {padded}];
",
        lanes = layout::LANES
    );
    for q in 0..=parts.order {
        let of_q = (parts.order - q) / 2 + 1;
        put(
            &mut text,
            format_args!(
                "        eigenshade::specialized::scatter::<f32, {q}, {of_q}, {along}, {modes}, {pairs}>(material, polar, &mut sums);"
            ),
        );
    }
    put(
        &mut text,
        format_args!(
            "        let scattered = eigenshade::specialized::transposed::<f32, {groups}, {rows}, {along}, {padded}>(&sums);"
        ),
    );
    let mut components = vec![String::new(); parts.components];
    let (mut start, mut call) = (0, 0);
    for profiles in parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        let azimuth = usize::from(profiles[0].azimuth);
        let degrees = rows - azimuth;
        put(
            &mut text,
            format_args!(
                "        let of_azimuth = eigenshade::specialized::lights::<f32, {azimuth}, {degrees}, {count}>(light);"
            ),
        );
        let length = layout::factors(parts.degree, parts.order, azimuth, 2);
        for four in profiles.chunks(4) {
            let shape = format!("{azimuth}, {groups}, {degrees}, {rows}, {factors}");
            let kernel = match four.len() {
                1 | 2 => format!("rows::<f32, {start}, {shape}>"),
                _ => format!("more_rows::<f32, {start}, {}, {shape}>", start + length),
            };
            put(
                &mut text,
                format_args!(
                    "        let r{call} = eigenshade::specialized::{kernel}(&FACTORS, &scattered, &of_azimuth);"
                ),
            );
            for (k, place) in four.iter().enumerate() {
                let half = if k % 2 == 0 { "first" } else { "second" };
                for (index, sum) in [(place.minus, k / 2 * 2 + 1), (place.plus, k / 2 * 2)] {
                    if index != NONE {
                        components[usize::from(index)] =
                            format!("eigenshade::specialized::{half}(r{call}[{sum}])");
                    }
                }
            }
            start += length * four.len().div_ceil(2);
            call += 1;
        }
    }
    finish(&mut text, &components);
    put(&mut text, format_args!("    }}"));
    text
}

/// One call a pass, where numbers are taken in groups.
fn by_passes(parts: &Parts) -> String {
    let count = light::count(parts.degree);
    let mut text = format!(
        "    if let (true, Some(light)) =
        (eigenshade::specialized::GROUPS, eigenshade::specialized::light::<f32, {count}>(light))
    {{
        let transfer = transfer.as_slice();
"
    );
    let mut components = vec![String::new(); parts.components];
    let (mut start, mut slots) = (0, parts.slots.as_slice());
    for (call, pass) in parts.passes.iter().enumerate() {
        let profiles = usize::from(pass.profiles);
        let degrees = parts.degree + 1 - layout::lowest_degree(pass.first.into());
        let (of_pass, rest) = slots.split_at(profiles * layout::LANES);
        // Its profiles may serve other orders alone, where +m is the last component.
        if of_pass.iter().any(|&slot| slot != NONE) {
            put(
                &mut text,
                format_args!(
                    "        let p{call} = eigenshade::specialized::pass::<f32, {start}, {}, {profiles}, {degrees}, {count}>(transfer, light);",
                    pass.first
                ),
            );
        }
        for (k, &slot) in of_pass.iter().enumerate() {
            if slot != NONE {
                components[usize::from(slot)] =
                    format!("p{call}[{}][{}]", k / layout::LANES, k % layout::LANES);
            }
        }
        slots = rest;
        start += layout::LANES * profiles * degrees;
    }
    finish(&mut text, &components);
    put(&mut text, format_args!("    }}"));
    text
}

/// One call for each order and pass, elsewhere.
fn by_orders(parts: &Parts) -> String {
    let count = light::count(parts.degree);
    let mut text = format!(
        "    if let (Some(transfer), Some(light), Some(coefficients)) = (
        eigenshade::specialized::transfer::<f32, TRANSFER>(transfer),
        eigenshade::specialized::light::<f32, {count}>(light),
        eigenshade::specialized::coefficients_mut(coefficients),
    ) {{
"
    );
    for profiles in parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        let azimuth = usize::from(profiles[0].azimuth);
        let degrees = parts.degree + 1 - azimuth;
        let signs = if azimuth == 0 { &[1][..] } else { &[1, -1] };
        for sign in signs {
            let served = |place: &ProfilePlace| match sign {
                1 => (place.plus, place.plus_row),
                _ => (place.minus, place.minus_row),
            };
            let served: Vec<_> = profiles.iter().map(served).collect();
            // Rows of one pass stand side by side.
            for rows in served.chunk_by(|(_, a), (_, b)| {
                b.step == a.step && b.start == a.start + layout::LANES as u32
            }) {
                let (order, Row { start, step }) = (sign * azimuth.cast_signed(), rows[0].1);
                let components: Vec<String> = rows.iter().map(|(one, _)| one.to_string()).collect();
                put(
                    &mut text,
                    format_args!(
                        "        eigenshade::specialized::order::<f32, {order}, {start}, {step}, {}, {degrees}, TRANSFER, {count}, COMPONENTS>(transfer, light, &[{}], coefficients);",
                        rows.len(),
                        components.join(", ")
                    ),
                );
            }
        }
    }
    text.push_str(
        "        eigenshade::specialized::subtract(coefficients, &MEAN_COEFFICIENTS);
        return Ok(());
    }
",
    );
    text
}

/// The answer, from the expressions of its components.
fn finish(text: &mut String, components: &[String]) {
    put(text, format_args!("        let coefficients = [{}];", components.join(", ")));
    put(
        text,
        format_args!(
            "        return Ok(eigenshade::specialized::coefficients(coefficients, &MEAN_COEFFICIENTS));"
        ),
    );
}

pub(crate) fn put(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
