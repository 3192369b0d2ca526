//! The functions of a table in integers as Rust source: a material, a light, a scene and a
//! pixel, with every size a constant.

use crate::quantize::{Place, QuantizedParts};
use crate::rust_quantized::put;
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
pub(crate) fn transfer(parts: &QuantizedParts, format: &str) -> String {
    let pairs = pair::count(parts.order);
    let (degrees, orders, modes) =
        (parts.degree + 1, parts.order + 1, material::count(parts.order));
    let (polar, rows) = (parts.polar.len(), parts.factor_exponents.len());
    let scatter = if polar > 0 { scatter(parts, format) } else { String::new() };
    let mut text = scatter
        + &format!(
            "/// The transfer of a material: see [`eigenshade::quantized::Basis::transfer`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn transfer(
    material: &eigenshade::quantized::Material<'_, eigenshade::{format}>,
) -> Result<Transfer, eigenshade::Error> {{
    let mut transfer = Transfer::default();
    transfer_into(material, &mut transfer)?;
    Ok(transfer)
}}
/// [`transfer`] into an existing transfer, without moving it.
///
/// # Errors
///
/// The same; `transfer` is then left unspecified.
pub fn transfer_into(
    material: &eigenshade::quantized::Material<'_, eigenshade::{format}>,
    transfer: &mut Transfer,
) -> Result<(), eigenshade::Error> {{
"
        );
    if polar > 0 {
        text.push_str(&format!(
            "    use eigenshade::quantized::kernels::transfer as kernels;
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
            "    transfer_generally(material, transfer)
}}
#[cold]
#[inline(never)]
fn transfer_generally(
    material: &eigenshade::quantized::Material<'_, eigenshade::{format}>,
    transfer: &mut Transfer,
) -> Result<(), eigenshade::Error> {{
    *transfer = BASIS.transfer::<WORKSPACE, TRANSFER, PROFILES>(material)?;
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
    degree: &eigenshade::quantized::kernels::transfer::Degree<eigenshade::{format}, {pairs}, {}>,
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
        "/// A new light on a transferred material: see [`eigenshade::quantized::Basis::relight`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn relight(
    transfer: &eigenshade::quantized::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantized::Light<'_, eigenshade::{format}>,
) -> Result<Coefficients, eigenshade::Error> {{
    let mut coefficients = Coefficients::default();
    relight_into(transfer, light, &mut coefficients)?;
    Ok(coefficients)
}}
/// [`relight`] into existing coefficients, without moving them.
///
/// # Errors
///
/// The same; `coefficients` is then left unspecified.
pub fn relight_into(
    transfer: &eigenshade::quantized::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantized::Light<'_, eigenshade::{format}>,
    coefficients: &mut Coefficients,
) -> Result<(), eigenshade::Error> {{
    use eigenshade::quantized::kernels::relight as kernels;
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
    transfer: &eigenshade::quantized::Transfer<'_, eigenshade::{format}>,
    light: &eigenshade::quantized::Light<'_, eigenshade::{format}>,
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
        "/// Sums the components of each azimuth: see [`eigenshade::quantized::Basis::collapse`].
///
/// # Errors
///
/// The same, except that no capacity can be too small.
pub fn collapse(coefficients: &Coefficients) -> Result<Scene, eigenshade::Error> {
    let mut scene = Scene::default();
    collapse_into(coefficients, &mut scene)?;
    Ok(scene)
}
/// [`collapse`] into an existing scene, without moving it.
///
/// # Errors
///
/// The same; `scene` is then left unspecified.
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
    *scene = Scene(BASIS.collapse::<SCENE>(coefficients.mantissas(), coefficients.exponent())?);
    Ok(())
}
",
    );
    text
}

/// The steps of a scene.
fn scene(parts: &QuantizedParts, format: &str) -> String {
    let mut text = String::from(
        "    use eigenshade::quantized::kernels::collapse as kernels;
    if let (Some(d), Some(terms)) = (kernels::mantissas(coefficients), kernels::terms(&BASIS, &mut scene.0)) {
",
    );
    let count = azimuths(parts).count();
    put(&mut text, format_args!("        let size = kernels::Size::<{count}>::empty()"));
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
        "            kernels::finish(coefficients, &shifts, &mut scene.0);
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
        "impl Scene {{
    /// The irradiance of one normal, times 2 to the power of the scene's negative
    /// [`exponent`](eigenshade::quantized::Scene::exponent): bit for bit that of
    /// [`eigenshade::quantized::Scene::shade`], with every length a constant.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: eigenshade::quantized::Normal<eigenshade::{format}>) -> i32 {{
        shade(&self.0, normal)
    }}
    /// [`shade`](Self::shade) for many normals.
    ///
    /// # Errors
    ///
    /// [`Error::Length`](eigenshade::Error::Length) unless `irradiance` and `normals` have the same
    /// length.
    pub fn shade_slice(
        &self,
        normals: &[eigenshade::quantized::Normal<eigenshade::{format}>],
        irradiance: &mut [i32],
    ) -> Result<(), eigenshade::Error> {{
        eigenshade::specialized::shade_each(normals, irradiance, |normal| shade(&self.0, normal))
    }}
}}
/// [`Scene::shade`] for a scene in a buffer of any type. The irradiance is 0 if the scene has fewer
/// terms than one of this table.
#[inline]
#[must_use]
pub fn shade<B: AsRef<[i32]>>(
    scene: &eigenshade::quantized::Scene<'_, eigenshade::{format}, B>,
    normal: eigenshade::quantized::Normal<eigenshade::{format}>,
) -> i32 {{
    let Some(terms) = scene.terms().first_chunk::<SCENE>() else {{ return 0 }};
    eigenshade::quantized::kernels::Pixel::new::<{}, SCENE>(terms, normal)
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
