//! `docs/ablation.md`.

use super::changes::multiplications;
use super::counts::{Column, Counts, M0, M3, M4F, RV32};
use super::errors::{errors, terms_within};
use super::nine_terms;
use super::scenes::{SCENES, Scene};
use super::shares::shares;
use super::tolerances;
use eigenshade_cli::median::median;
use eigenshade_index::effect::Effect;
use eigenshade_table::Parts;
use std::fmt::Write;

/// What makes the page.
pub const COMMAND: &str = "cargo run --release --example ablation -- --out docs/ablation.md";

const HEAD: &str = "\
# Only what a scene calls for

Ten scenes of `firmware/scenes`, each of which asks for more than the one before: what it costs, and what each of its effects is worth. A scene
has tables and code for the effects, degree, order and components that its file names; what it does not name costs no flash, no RAM and no instruction.
`tests/ablation.rs` computes the errors and the sentences again; the counts are those of `firmware/counts.csv`.

## What it costs

Cortex-M0 in Q15 and Cortex-M4F in f32, programs of `firmware/programs/src/scenes.rs`. Bytes of flash and RAM (without the stack) are what a program has more than an empty one: the scene's table, its code,
its material folded in when it starts, and the making of its inputs. *Pixel* is all channels of one normal, *light* a new light up to the image's polynomials, *turn* the turning before it. Terms are those of
a channel's polynomials; ratios are to a pixel of one channel by the nine-term formula, host times (f32, pictures of 96 x 96, this build's vectors) in the same run.

| scene | effects | terms | flash M0, M4F | RAM M0, M4F | pixel M0 | pixel M4F | light M0 | light M4F | turn M4F | pixel, in nine-term pixels: M0, M4F, host |
|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|
";

const ERRORS: &str = "
Integers do not turn light: the last scene has no program on the M0, which takes turned lights from elsewhere. Integers refuse a table whose ambient takes orders that no other effect of it does, so the
second scene names all effects (at degree 0 the others have no modes), and the plaster has its order lowered to 3 instead of only its gloss left out.

## What it is worth

Root mean square over the sphere, of the peak of the whole picture, by direct sums in f64. *If left out*: the picture of the effect alone; for colour, luminance shown instead; for turning, a light that turns by 30 degrees about the vertical while
the picture does not. *The scene leaves out* is its distance from degree 9, order 7 and all effects, in its channels.

| scene | light | ambient | diffuse | broad | gloss | colour | turning | the scene leaves out |
|---|---|---:|---:|---:|---:|---:|---:|---:|
";

const OWN: &str = "
And what table, terms and format lose of that: against the direct sum of the scene's own effects, degree and order.

| scene | asked for | f32, its light | f32, the worst of 26 lights | Q15, its light |
|---|---:|---:|---:|---:|
";

/// The page; `host` gives the ratios of times of a scene and, of none, those of the changes.
pub fn page(host: impl Fn(Option<&Scene>) -> Vec<f64>) -> String {
    let counts = Counts::recorded();
    let mut text = format!("<!-- {COMMAND} -->\n{HEAD}");
    for scene in &SCENES {
        line(&mut text, &costs(scene, &counts, host(Some(scene))[0]));
    }
    text += ERRORS;
    for scene in &SCENES {
        line(&mut text, &worth(scene));
    }
    text += OWN;
    for scene in &SCENES {
        let found = errors(scene);
        let asked = scene.tolerance;
        let cells = [scene.title.into(), format!("{asked:e}")];
        let errors = [found.f32, found.worst, found.q15].map(|error| format!("{error:.1e}"));
        line(&mut text, &[&cells[..], &errors[..]].concat());
    }
    text += &sentences(&counts);
    text += &changes(&counts, &host(None));
    text
}

fn line(text: &mut String, cells: &[String]) {
    writeln!(text, "| {} |", cells.join(" | ")).expect("a string takes everything");
}

fn costs(scene: &Scene, counts: &Counts, host: f64) -> Vec<String> {
    let of = |operation: &str| format!("{}/{operation}", scene.name);
    let get = |on, operation: &str, column| number(counts.get(on, &of(operation), column));
    let both = |column| [M0, M4F].map(|on| get(on, "scene", column)).join(", ");
    let ratio = |on| match counts.get(on, &of("pixel"), Column::Instructions) {
        Some(_) => format!("{:.2}", counts.of_nine_terms(on, &of("pixel"))),
        None => "-".into(),
    };
    let instructions = |on, operation| get(on, operation, Column::Instructions);
    let terms: usize = terms(scene);
    vec![
        scene.title.into(),
        effects(scene).join(", "),
        terms.to_string(),
        both(Column::Flash),
        both(Column::Ram),
        instructions(M0, "pixel"),
        instructions(M4F, "pixel"),
        instructions(M0, "light"),
        instructions(M4F, "light"),
        instructions(M4F, "turn"),
        format!("{}, {}, ×{host:.2}", ratio(M0), ratio(M4F)),
    ]
}

/// Terms of a channel's polynomials on the boards.
pub fn terms(scene: &Scene) -> usize {
    let lengths = Parts::new(&scene.trimmed_table()).lengths;
    let both: usize = lengths.iter().map(|&length| 2 * usize::from(length)).sum();
    both - lengths.first().map_or(0, |&length| usize::from(length))
}

/// The effects and demands that a scene names.
fn effects(scene: &Scene) -> Vec<String> {
    let table = scene.whole_table();
    let wanted = table.effects();
    let has_modes = |effect: &Effect| *effect == Effect::Ambient || table.gram.degree > 0;
    let effects = Effect::ALL.into_iter().filter(|&effect| wanted.has(effect)).filter(has_modes);
    let mut names: Vec<String> = effects.map(|effect| effect.name().into()).collect();
    names.extend((scene.channels == 3).then(|| "colour".into()));
    names.extend(scene.turns.then(|| "turning".into()));
    names
}

fn worth(scene: &Scene) -> Vec<String> {
    let shares = shares(scene, &scene.whole_table());
    let mut cells = vec![scene.title.into(), scene.light.into()];
    for name in ["ambient", "diffuse", "broad", "gloss", "colour", "turning"] {
        let mut all = shares.effects.iter().chain(&shares.demands);
        let found = all.find(|(one, _)| *one == name);
        cells.push(found.map_or(String::new(), |(_, share)| percent(*share)));
    }
    cells.push(percent(shares.left_out));
    cells
}

fn sentences(counts: &Counts) -> String {
    let pixel = |name: &str| ratios(counts, &format!("{name}/pixel"));
    let nine = nine_terms::errors();
    let enough = nine.iter().filter(|&&error| error <= 1e-2).count();
    let terms = terms_within(&Scene::named("park_lambertian_fine"), 1e-2);
    let kept = terms.iter().filter(|&&terms| terms <= 9).count();
    let sorted: Vec<f64> = terms.iter().map(|&terms| terms as f64).collect();
    format!(
        "
## Beside the nine-term formula

* **A Lambertian material under light of degree 2** costs what the formula costs, with the same answer: {} times a pixel (`shade_lambertian`; at most {}). Here, with three polynomials by azimuth,
  nothing depends on its being Lambertian: any nine eigenimages of such lengths would cost that.
* **A Lambertian material at 1e-2 under any shipped light** does *not* stay at nine terms, and cannot: light of degree 4 and more is part of the answer. The formula itself is off by {} in the median of the
  {} shipped lights and by {} at worst (of the peak); under {} of them it is within 1e-2. Within that tolerance `collapse_within`, whose bound is about twice the error, keeps {} terms in the median, from {} to {}; nine or fewer under {}.
  The scene made for 1e-2 has {} terms and costs {}.
* **Typical scenes at 1e-3** cost at most {} times: plaster {}, velvet {}, leather {}.
* **Ambient light** on a Lambertian material is one term, a constant; on velvet {} terms in n_z alone.
",
        ratios(counts, "shade_lambertian"),
        tolerances::OF_NINE_TERMS,
        percent(median(&nine)),
        nine.len(),
        percent(nine.iter().copied().fold(0.0, f64::max)),
        enough,
        median(&sorted),
        terms.iter().min().unwrap_or(&0),
        terms.iter().max().unwrap_or(&0),
        kept,
        self::terms(&Scene::named("park_lambertian")),
        pixel("park_lambertian"),
        tolerances::TYPICAL_OF_NINE_TERMS,
        pixel("studio_plaster"),
        pixel("studio_velvet"),
        pixel("sun_leather"),
        self::terms(&Scene::named("ambient_velvet")),
    )
}

/// The instructions of a pixel over those of the formula.
fn ratios(counts: &Counts, operation: &str) -> String {
    let of = |on| counts.of_nine_terms(on, operation);
    format!("{:.2} on the M0, {:.2} on the M4F", of(M0), of(M4F))
}

fn changes(counts: &Counts, host: &[f64]) -> String {
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
        ("light", "`relight`, `collapse`", "the material's transfer", relight.to_string(), relit),
        (
            "light, turned",
            "`Light::turned`, `relight`, `collapse`",
            "the material's transfer",
            format!("{} matrix elements of some twenty, then {relight}", found.turn),
            [number(turned), none(), none(), none()],
        ),
        (
            "material",
            "`transfer`, `relight`, `collapse`",
            "the light's coefficients",
            (found.transfer + relight).to_string(),
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
        cells.push(format!("×{:.1}", host[k]));
        line(&mut text, &cells);
    }
    text += "
A pixel on the boards is one of `shade`, a scene of 130 components to 1e-4; the shipped table's is shorter. A camera that moves turns the light in its frame, and shows other normals: both rows. Nothing on the boards turns light in integers.
`Light::turned` makes the matrices anew for each channel: three channels take three times as long.
";
    text
}

/// With commas between thousands; a dash for nothing.
fn number(number: Option<u64>) -> String {
    let Some(number) = number else { return "-".into() };
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Two digits.
fn percent(share: f64) -> String {
    match 100.0 * share {
        zero if zero < 1e-10 => "0".into(),
        large if large >= 9.95 => format!("{large:.0}%"),
        middle if middle >= 0.995 => format!("{middle:.1}%"),
        small => format!("{small:.2}%"),
    }
}

/// Compares a page with what is measured now: word by word. Errors and shares, which have an
/// exponent or a per cent sign, may differ by [`tolerances::ABLATION_PAGE`] of themselves, or
/// both be below [`tolerances::ABLATION_ROUNDING`]; times are not compared.
///
/// # Errors
///
/// The first line that differs.
pub fn compare(recorded: &str, page: &str) -> Result<(), String> {
    let (old, new): (Vec<_>, Vec<_>) = (recorded.lines().collect(), page.lines().collect());
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        let words =
            |text: &str| -> Vec<String> { text.split_whitespace().map(Into::into).collect() };
        let (before, now) = (words(old), words(new));
        let same = before.len() == now.len() && before.iter().zip(&now).all(|(a, b)| near(a, b));
        if !same {
            return Err(format!("line {}: it says\n{old}\nwhere it is\n{new}", line + 1));
        }
    }
    if old.len() == new.len() { Ok(()) } else { Err("it has other lines".into()) }
}

fn near(old: &str, new: &str) -> bool {
    let number = |word: &str| {
        let share = word.trim_end_matches([',', '.', ';']).strip_suffix('%');
        let error = word.contains('e').then_some(word);
        share
            .map(|share| (share, 1e-2))
            .or(error.map(|error| (error, 1.0)))
            .and_then(|(text, unit)| Some(unit * text.parse::<f64>().ok()?))
    };
    match (number(old), number(new)) {
        (Some(old), Some(new)) => {
            let most = old.abs().max(new.abs());
            (old - new).abs() <= tolerances::ABLATION_PAGE * most
                || most < tolerances::ABLATION_ROUNDING
        }
        _ => old == new || old.starts_with('×') && new.starts_with('×'),
    }
}
