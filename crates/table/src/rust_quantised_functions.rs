//! The functions of a table in integers as Rust source: a material, a light, a scene and a
//! pixel, with every size a constant.

use crate::quantize::{Place, QuantizedParts};
use crate::rust_kernels::put;
use eigenshade_index::{material, pair};

/// The profiles of each azimuth, and where they start among all.
fn azimuths(parts: &QuantizedParts) -> impl Iterator<Item = (usize, &[Place])> {
    let mut first = 0;
    parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth).map(move |block| {
        first += block.len();
        (first - block.len(), block)
    })
}

/// A new material, one call for its scattering and one for each azimuth.
pub(crate) fn fold(parts: &QuantizedParts, format: &str) -> String {
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
            *exponent = degree.normalize(sums);
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
fn scatter(parts: &QuantizedParts, format: &str) -> String {
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
        let coupled = |o: &usize| parts.effects.factored(p.max(*o));
        for o in (q..=parts.order).step_by(2).filter(coupled) {
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
pub(crate) fn relight(parts: &QuantizedParts, format: &str) -> String {
    let pair = |place: &Place| format!("[{}, {}]", place.plus, place.minus);
    let count = (parts.degree + 1) * (parts.degree + 1);
    let mut text = format!(
        "/// A new light on a folded material: see [`eigenshade::quantised::Basis::relight`].
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
"
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
    put(&mut text, format_args!("        let common = kernels::common(top);"));
    for (at, Place { plus, minus, .. }) in parts.profiles.iter().enumerate() {
        put(
            &mut text,
            format_args!(
                "        kernels::align::<{at}, {plus}, {minus}, PROFILES, COMPONENTS>(inputs.1, common, d);"
            ),
        );
    }
    put(
        &mut text,
        format_args!(
            "        kernels::finish::<eigenshade::{format}, COMPONENTS>(coefficients, common, light.exponent());
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

/// A scene: how large it gets, and one call for each azimuth. Where the sizes' sums may
/// not fit 32 bits, the general way alone.
pub(crate) fn collapse(parts: &QuantizedParts, format: &str) -> String {
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
",
    );
    let sum = |stated: fn(&Place) -> u16, profiles: &[Place]| {
        profiles.iter().map(|place| u32::from(stated(place))).sum::<u32>()
    };
    let steps = azimuths(parts).map(|(_, block)| sum(|place| place.step, block));
    let largest = steps.chain([2 * sum(|place| place.size, &parts.profiles)]).max();
    // Times 2^15, and what may be missing.
    if largest.unwrap_or(0) < 1 << 16 {
        text.push_str(&scene(parts, format));
    }
    text.push_str(
        "    collapse_generally(coefficients, scene)
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

/// The steps of a scene.
fn scene(parts: &QuantizedParts, format: &str) -> String {
    let mut text = String::from(
        "    use eigenshade::quantised::kernels::collapse as kernels;
    if let (Some(d), Some(terms)) = (kernels::mantissas(coefficients), kernels::terms(&BASIS, scene)) {
",
    );
    let count = azimuths(parts).count();
    put(&mut text, format_args!("        let size = kernels::Size::<{count}>::of_nothing()"));
    for (number, (_, block)) in azimuths(parts).enumerate() {
        for Place { plus, minus, size, step, .. } in block {
            put(
                &mut text,
                format_args!(
                    "            .profile::<{plus}, {minus}, {size}, {step}, COMPONENTS>(d)"
                ),
            );
        }
        put(&mut text, format_args!("            .azimuth::<{number}>()"));
    }
    let exponents = || parts.profiles.iter().map(|place| place.exponent);
    let (least, largest) = (exponents().min().unwrap_or(0), exponents().max().unwrap_or(0));
    put(
        &mut text,
        format_args!(
            "            .shifts::<eigenshade::{format}>(DEGREE, [{least}, {largest}]);
        if let Some(shifts) = size {{"
        ),
    );
    let total = parts.terms.len();
    let (mut start, mut to, mut azimuth) = (0, 0, 0);
    for (number, (_, block)) in azimuths(parts).enumerate() {
        while azimuth < usize::from(block[0].azimuth) {
            to += usize::from(parts.lengths[azimuth]) * if azimuth == 0 { 1 } else { 2 };
            azimuth += 1;
        }
        let (profiles, length) = (block.len(), usize::from(parts.lengths[azimuth]));
        let signs = if azimuth == 0 { 1 } else { 2 };
        let weights: Vec<String> = block.iter().map(|place| weights(place, format)).collect();
        put(
            &mut text,
            format_args!(
                "            let finer = shifts.finer::<{number}>();
            kernels::azimuth::<eigenshade::{format}, {start}, {to}, {profiles}, {signs}, {length}, {total}, SCENE>(&TERMS, &[{}], finer, terms);",
                weights.join(", ")
            ),
        );
        start += profiles * length;
    }
    text.push_str(
        "            kernels::finish(coefficients, &shifts, scene);
            return Ok(());
        }
    }
",
    );
    text
}

/// The weights of a profile's components.
fn weights(place: &Place, format: &str) -> String {
    let Place { azimuth, exponent, plus, minus, .. } = place;
    let weight = |component: &u16| {
        format!(
            "shifts.weight::<eigenshade::{format}, {component}, {exponent}, COMPONENTS>(d, finer)"
        )
    };
    // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
    if *azimuth == 0 {
        format!("[{}]", weight(plus))
    } else {
        format!("[{}, -{}]", weight(plus), weight(minus))
    }
}

/// The pixel, unrolled.
pub(crate) fn shade(parts: &QuantizedParts, format: &str) -> String {
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
