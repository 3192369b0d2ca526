//! A table in integers as Rust source: typed statics, a basis whose shape and bounds
//! are checked when they are compiled, and functions with every size a constant.

use crate::quantise::{Format, Place, QuantisedParts};
use eigenshade_index::{material, pair};
use std::fmt::Write;

/// The module's text. `command` is what made it, for the first line.
#[must_use]
pub fn module(parts: &QuantisedParts, command: &str) -> String {
    let format = name(parts.format);
    let degrees = parts.degree + 1;
    let transfer: usize =
        parts.profiles.iter().map(|place| degrees - usize::from(place.azimuth)).sum();
    let lengths = parts.lengths.iter().map(|&length| usize::from(length));
    let scene = 2 * lengths.sum::<usize>() - usize::from(parts.lengths[0]);
    let mut text = format!("// {command}\n// {} bytes of tables\n", bytes(parts));
    for (name, what, value) in [
        ("DEGREE", "Largest degree l of the light.", parts.degree),
        ("ORDER", "Largest order o of the BRDF.", parts.order),
        ("COMPONENTS", "Number of components K.", parts.components),
        (
            "WORKSPACE",
            "Wide numbers that folding needs room for.",
            degrees * (pair::count(parts.order) + 3),
        ),
        ("TRANSFER", "Numbers in a transfer.", transfer),
        ("PROFILES", "Number of slant profiles.", parts.profiles.len()),
        ("SCENE", "Numbers in a scene.", scene),
    ] {
        put(&mut text, format_args!("/// {what}\npub const {name}: usize = {value};"));
    }
    numbers(&mut text, "POLAR", format, &parts.polar);
    array(&mut text, "POLAR_EXPONENTS", "i8", &parts.polar_exponents);
    numbers(&mut text, "FACTORS", format, &parts.factors);
    array(&mut text, "FACTOR_EXPONENTS", "i8", &parts.factor_exponents);
    numbers(&mut text, "TERMS", format, &parts.terms);
    array(&mut text, "LENGTHS", "u8", &parts.lengths);
    let profiles: Vec<String> = parts.profiles.iter().map(profile).collect();
    array(&mut text, "PLACES", "eigenshade::quantised::Profile", &profiles);
    put(&mut text, format_args!("{}", basis(format)));
    text.push_str(&types(format));
    text.push_str(&fold(parts, format));
    text.push_str(&relight(parts, format));
    text.push_str(&collapse(parts, format));
    text.push_str(&shade(parts, format));
    text
}

/// The statics of a material folded into such a table, as `transfer` gives it, to stand
/// where its `BASIS` is in scope. Its bounds are checked when it is compiled.
#[must_use]
pub fn transfer(format: Format, mantissas: &[i32], exponents: &[i16]) -> String {
    let format = name(format);
    let mut text = String::new();
    numbers(&mut text, "FOLDED", format, mantissas);
    array(&mut text, "FOLDED_EXPONENTS", "i16", exponents);
    put(
        &mut text,
        format_args!(
            "/// The folded material.
pub static MATERIAL: eigenshade::quantised::Transfer<'static, eigenshade::{format}> =
    match BASIS.transfer(&FOLDED, &FOLDED_EXPONENTS) {{
        Ok(transfer) => transfer,
        Err(_) => panic!(\"the transfer is not of this basis\"),
    }};"
        ),
    );
    text
}

const fn name(format: Format) -> &'static str {
    match format {
        Format::Q15 => "Q15",
        Format::Q31 => "Q31",
    }
}

/// Bytes of all statics: mantissas, exponents and lengths, 10 a profile.
#[must_use]
pub fn bytes(parts: &QuantisedParts) -> usize {
    let mantissas = parts.polar.len() + parts.factors.len() + parts.terms.len();
    let small = parts.polar_exponents.len() + parts.factor_exponents.len() + parts.lengths.len();
    let each = if parts.format == Format::Q15 { 2 } else { 4 };
    each * mantissas + small + 10 * parts.profiles.len()
}

fn profile(place: &Place) -> String {
    let Place { azimuth, exponent, plus, minus, size, step } = place;
    format!(
        "eigenshade::quantised::Profile::new({azimuth}, {exponent}, [{plus}, {minus}], [{size}, {step}])"
    )
}

fn numbers(text: &mut String, name: &str, format: &str, values: &[i32]) {
    let count = values.len();
    if values.is_empty() {
        put(text, format_args!("static {name}: [eigenshade::{format}; 0] = [];"));
        return;
    }
    let values: Vec<String> = values.iter().map(|value| format!("q({value})")).collect();
    let inner = if format == "Q15" { "i16" } else { "i32" };
    put(
        text,
        format_args!(
            "static {name}: [eigenshade::{format}; {count}] = {{ const fn q(mantissa: {inner}) -> \
             eigenshade::{format} {{ eigenshade::{format}(mantissa) }} [{}] }};",
            values.join(", ")
        ),
    );
}

fn array(text: &mut String, name: &str, kind: &str, values: &[impl ToString]) {
    let values: Vec<String> = values.iter().map(ToString::to_string).collect();
    put(text, format_args!("static {name}: [{kind}; {}] = [{}];", values.len(), values.join(", ")));
}

fn basis(format: &str) -> String {
    format!(
        "/// The basis; its shape and its bounds were checked when it was compiled.
pub static BASIS: eigenshade::quantised::Basis<'static, eigenshade::{format}> =
    match eigenshade::quantised::Basis::<eigenshade::{format}>::new(eigenshade::quantised::Parts {{
        degree: DEGREE,
        order: ORDER,
        components: COMPONENTS,
        profiles: &PLACES,
        lengths: &LENGTHS,
        polar: &POLAR,
        polar_exponents: &POLAR_EXPONENTS,
        factors: &FACTORS,
        factor_exponents: &FACTOR_EXPONENTS,
        terms: &TERMS,
    }}) {{
        Ok(basis) => basis,
        Err(_) => panic!(\"the table's parts do not fit together\"),
    }};"
    )
}

fn types(format: &str) -> String {
    format!(
        "/// The coefficients d of one image.
pub type Coefficients = eigenshade::quantised::Coefficients<COMPONENTS>;
/// One material, folded into the basis.
pub type Transfer = eigenshade::quantised::TransferBuffer<eigenshade::{format}, TRANSFER, PROFILES>;
/// One image, ready to be shaded.
pub type Scene = eigenshade::quantised::Scene<'static, eigenshade::{format}, eigenshade::quantised::SceneBuffer<SCENE>>;
"
    )
}

/// The profiles of each azimuth, and where they start among all.
fn azimuths(parts: &QuantisedParts) -> impl Iterator<Item = (usize, &[Place])> {
    let mut first = 0;
    parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth).map(move |block| {
        first += block.len();
        (first - block.len(), block)
    })
}

/// A new material, one call for its scattering and one for each azimuth.
fn fold(parts: &QuantisedParts, format: &str) -> String {
    let pairs = pair::count(parts.order);
    let (degrees, orders, modes) =
        (parts.degree + 1, parts.order + 1, material::count(parts.order));
    let (polar, rows) = (parts.polar.len(), parts.factor_exponents.len());
    let scatter = if polar > 0 { scatter(parts, format) } else { String::new() };
    let mut text = scatter
        + &format!(
            "/// Folds a material into the basis: see [`eigenshade::quantised::Basis::fold`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn fold(
    material: &eigenshade::quantised::Material<'_, eigenshade::{format}>,
) -> Result<Transfer, eigenshade::Error> {{
    let mut transfer = Transfer::default();
    fold_into(material, &mut transfer)?;
    Ok(transfer)
}}
/// [`fold`] in the place of another transfer: nothing is moved.
///
/// # Errors
///
/// As there; what the transfer is then is not said.
pub fn fold_into(
    material: &eigenshade::quantised::Material<'_, eigenshade::{format}>,
    transfer: &mut Transfer,
) -> Result<(), eigenshade::Error> {{
"
        );
    if polar > 0 {
        text.push_str(&format!(
            "    use eigenshade::quantised::kernels::fold as kernels;
    if let (Some(inputs), Some((numbers, exponents))) =
        (kernels::inputs::<_, {modes}, {orders}>(material), kernels::numbers(transfer))
    {{
        let (mut sums, mut of_sums) = ([[0; {pairs}]; {degrees}], [0; {degrees}]);
        let b = kernels::coefficients::<_, {modes}>(inputs.0, &[{}]);
        for (l, (sums, exponent)) in sums.iter_mut().zip(&mut of_sums).enumerate() {{
            let degree = kernels::Degree::new(l, &POLAR, &POLAR_EXPONENTS, inputs.1);
            let Some(degree) = degree else {{ continue }};
            scatter(&degree, &b, sums);
            *exponent = degree.normalise(sums);
        }}
",
            material::indices(parts.order)
                .map(|(o, p, _)| (o == p).to_string())
                .collect::<Vec<_>>()
                .join(", ")
        ));
        let (mut row, mut start) = (0, 0);
        for (first, block) in azimuths(parts) {
            let (azimuth, profiles) = (usize::from(block[0].azimuth), block.len());
            let length = degrees - azimuth;
            put(
                &mut text,
                format_args!(
                    "        kernels::azimuth::<eigenshade::{format}, {azimuth}, {profiles}, {length}, {row}, {start}, {first}, {pairs}, {degrees}, {}, {rows}, TRANSFER, PROFILES>(&FACTORS, &FACTOR_EXPONENTS, &sums, &of_sums, (&mut *numbers, &mut *exponents));",
                    parts.factors.len()
                ),
            );
            row += profiles * length;
            start += profiles * length;
        }
        text.push_str("        return Ok(());\n    }\n");
    }
    put(
        &mut text,
        format_args!(
            "    fold_generally(material, transfer)
}}
#[cold]
#[inline(never)]
fn fold_generally(
    material: &eigenshade::quantised::Material<'_, eigenshade::{format}>,
    transfer: &mut Transfer,
) -> Result<(), eigenshade::Error> {{
    *transfer = BASIS.fold::<WORKSPACE, TRANSFER, PROFILES>(material)?;
    Ok(())
}}"
        ),
    );
    text
}

/// The sums S of one degree, one line for each pair (p, q): over all o.
fn scatter(parts: &QuantisedParts, format: &str) -> String {
    let (pairs, modes) = (pair::count(parts.order), material::count(parts.order));
    let wide = if format == "Q15" { "i32" } else { "i64" };
    let mut text = format!(
        "#[inline(never)]
fn scatter(
    degree: &eigenshade::quantised::kernels::fold::Degree<eigenshade::{format}, {pairs}, {}>,
    b: &[{wide}; {modes}],
    sums: &mut [{wide}; {pairs}],
) {{
",
        parts.order + 1
    );
    for (to, (p, q)) in pair::indices(parts.order).enumerate() {
        put(&mut text, format_args!("    let sum = 0;"));
        for o in (q..=parts.order).step_by(2) {
            let (from, mode) = (pair::position(o, q), material::position(o.max(p), o.min(p), q));
            let of = o.max(p);
            put(
                &mut text,
                format_args!("    let sum = degree.add::<{from}, {mode}, {of}, {modes}>(sum, b);"),
            );
        }
        put(&mut text, format_args!("    if let Some(to) = sums.get_mut({to}) {{ *to = sum; }}"));
    }
    text.push_str("}\n");
    text
}

/// A new light, one call for each azimuth.
fn relight(parts: &QuantisedParts, format: &str) -> String {
    let pair = |place: &Place| format!("[{}, {}]", place.plus, place.minus);
    let pairs: Vec<String> = parts.profiles.iter().map(pair).collect();
    let count = (parts.degree + 1) * (parts.degree + 1);
    let mut text = format!(
        "static PAIRS: [[u16; 2]; PROFILES] = [{}];
/// A new light on a folded material: see [`eigenshade::quantised::Basis::relight`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn relight(
    transfer: &eigenshade::quantised::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantised::Light<'_, eigenshade::{format}>,
) -> Result<Coefficients, eigenshade::Error> {{
    let mut coefficients = Coefficients::default();
    relight_into(transfer, light, &mut coefficients)?;
    Ok(coefficients)
}}
/// [`relight`] in the place of other coefficients: nothing is moved.
///
/// # Errors
///
/// As there; what the coefficients are then is not said.
pub fn relight_into(
    transfer: &eigenshade::quantised::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantised::Light<'_, eigenshade::{format}>,
    coefficients: &mut Coefficients,
) -> Result<(), eigenshade::Error> {{
    use eigenshade::quantised::kernels::relight as kernels;
    if let (Some(inputs), Some(d)) =
        (kernels::inputs::<_, TRANSFER, PROFILES, {count}>(transfer, light), kernels::mantissas(coefficients))
    {{
        let top = kernels::NONE;
",
        pairs.join(", ")
    );
    let mut start = 0;
    for (first, block) in azimuths(parts) {
        let (azimuth, profiles) = (usize::from(block[0].azimuth), block.len());
        let degrees = parts.degree + 1 - azimuth;
        let of_block: Vec<String> = block.iter().map(pair).collect();
        put(
            &mut text,
            format_args!(
                "        let top = kernels::azimuth::<_, {azimuth}, {start}, {first}, {profiles}, {degrees}, TRANSFER, PROFILES, {count}, COMPONENTS>(inputs, &[{}], d, top);",
                of_block.join(", ")
            ),
        );
        start += profiles * degrees;
    }
    put(
        &mut text,
        format_args!(
            "        kernels::align::<eigenshade::{format}, PROFILES, COMPONENTS>(inputs.1, &PAIRS, top, light.exponent(), coefficients);
        return Ok(());
    }}
    relight_generally(transfer, light, coefficients)
}}
#[cold]
#[inline(never)]
fn relight_generally(
    transfer: &eigenshade::quantised::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantised::Light<'_, eigenshade::{format}>,
    coefficients: &mut Coefficients,
) -> Result<(), eigenshade::Error> {{
    *coefficients = BASIS.relight::<COMPONENTS>(transfer, light)?;
    Ok(())
}}"
        ),
    );
    text
}

/// A scene, one call for each azimuth.
fn collapse(parts: &QuantisedParts, format: &str) -> String {
    let mut text = String::from(
        "/// Sums the components of each azimuth: see [`eigenshade::quantised::Basis::collapse`].
///
/// # Errors
///
/// As there, but capacities cannot be too small.
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {
    let mut scene = Scene::default();
    collapse_into(coefficients, &mut scene)?;
    Ok(scene)
}
/// [`collapse`] in the place of another scene: nothing is moved.
///
/// # Errors
///
/// As there; what the scene is then is not said.
pub fn collapse_into(
    coefficients: &Coefficients,
    scene: &mut Scene,
) -> Result<(), eigenshade::Error> {
    use eigenshade::quantised::kernels::collapse as kernels;
    if let (Some(d), Some(terms)) = (kernels::mantissas(coefficients), kernels::terms(&BASIS, scene)) {
        let common = BASIS.common_exponent(d);
",
    );
    let total = parts.terms.len();
    let (mut start, mut to, mut azimuth) = (0, 0, 0);
    for (first, block) in azimuths(parts) {
        while azimuth < usize::from(block[0].azimuth) {
            to += usize::from(parts.lengths[azimuth]) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        let (profiles, length) = (block.len(), usize::from(parts.lengths[azimuth]));
        let signs = if azimuth == 0 { 1 } else { 2 };
        put(
            &mut text,
            format_args!(
                "        kernels::azimuth::<eigenshade::{format}, {first}, {start}, {to}, {profiles}, {signs}, {length}, {total}, PROFILES, COMPONENTS, SCENE>(&TERMS, &PLACES, common, d, terms);"
            ),
        );
        start += profiles * length;
    }
    text.push_str(
        "        kernels::finish(&BASIS, coefficients, common, scene);
        return Ok(());
    }
    collapse_generally(coefficients, scene)
}
#[cold]
#[inline(never)]
fn collapse_generally(
    coefficients: &Coefficients,
    scene: &mut Scene,
) -> Result<(), eigenshade::Error> {
    *scene = BASIS.collapse::<SCENE>(coefficients.mantissas(), coefficients.exponent())?;
    Ok(())
}
",
    );
    text
}

/// The pixel, unrolled.
fn shade(parts: &QuantisedParts, format: &str) -> String {
    let mut text = format!(
        "/// The irradiance of one normal, times 2 to the power of the scene's negative
/// exponent: [`eigenshade::quantised::Scene::shade`] with every length a constant, bit
/// for bit.
#[inline]
#[must_use]
pub fn shade<B: AsRef<[i32]>>(
    scene: &eigenshade::quantised::Scene<'_, eigenshade::{format}, B>,
    normal: eigenshade::quantised::Normal<eigenshade::{format}>,
) -> i32 {{
    let Some(terms) = scene.terms().first_chunk::<SCENE>() else {{ return 0 }};
    eigenshade::quantised::kernels::Pixel::new::<{}, SCENE>(terms, normal)
",
        parts.lengths[0]
    );
    let mut start = usize::from(parts.lengths[0]);
    let last = parts.lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    for (azimuth, &length) in parts.lengths.iter().enumerate().take(last + 1).skip(1) {
        if azimuth > 1 {
            put(&mut text, format_args!("        .turned()"));
        }
        put(&mut text, format_args!("        .azimuth::<{start}, {length}, SCENE>(terms)"));
        start += 2 * usize::from(length);
    }
    text.push_str("        .irradiance()\n}\n");
    text
}

fn put(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
