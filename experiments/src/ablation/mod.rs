//! The ablation: the cost of the ten scenes of `firmware/scenes`, each of which adds an effect or a
//! requirement to the previous one, and the contribution of each effect, for `docs/ablation.md`.

pub mod pictures;
pub mod scenes;

use crate::multiplications::Multiplications;
use crate::numbers::median;
use crate::pages::{Page, Part, same_word, table};
use crate::sheet::{Counts, M0, M3, M4F, RV32};
use crate::tolerances;
use eigenshade_cli::messages::grouped;
use eigenshade_index::effect::Effect;
use eigenshade_shading::shipped;
use eigenshade_table::decode;
use eigenshade_table::trim::trim;
use pictures::{errors, of_nine_terms, shares, terms_within};
use scenes::{SCENES, Scene, Size, Times};

/// Allowed relative difference of the page's figures, which have two digits.
const DIFFERENCE: f64 = 0.1;
/// Errors on the page below this are f32 rounding and differ between hosts.
const ROUNDING: f64 = 1e-6;
pub const PAGE: Page = Page {
    name: "ablation",
    same: |_, old, new| {
        same_word(old, new, |old, new| {
            let most = old.abs().max(new.abs());
            (old - new).abs() <= DIFFERENCE * most || most < ROUNDING
        })
    },
};

/// The table of the boards' `shade`, and the share of the rms to which they trim its polynomials.
const BOARDS: (&[u8], f64) = (include_bytes!("../../../firmware/tables/full.bin"), 2e-4);

/// The parts of the page, or the scenes beyond their tolerances.
pub fn parts(times: &Times) -> Result<Vec<Part>, String> {
    let counts = Counts::recorded();
    Ok(vec![
        ("costs", costs(&counts, &times.scenes)),
        ("savings", savings()),
        ("worth", worth()),
        ("own", own()?),
        ("beside", beside(&counts)),
        ("changes", changes(&counts, times.changes)),
    ])
}

/// A number with commas between thousands; a dash if there is none.
fn number(number: Option<u64>) -> String {
    number.map_or_else(|| "-".into(), |number| grouped(number as usize))
}

/// A percentage with two digits.
fn percent(share: f64) -> String {
    match 100.0 * share {
        zero if zero < 1e-10 => "0".into(),
        large if large >= 9.95 => format!("{large:.0}%"),
        middle if middle >= 0.995 => format!("{middle:.1}%"),
        small => format!("{small:.2}%"),
    }
}

/// The cost of each scene. `host` holds the times of a pixel.
fn costs(counts: &Counts, host: &[f64]) -> String {
    let columns = "\
        scene | effects | terms: | flash M0, M4F: | RAM M0, M4F: | pixel M0: | pixel M4F: | \
        light M0: | light M4F: | turn M4F: | pixel, in nine-term pixels: M0, M4F, host:";
    let row = |(scene, host): (&Scene, &f64)| {
        let of = |operation: &str| format!("{}/{operation}", scene.name);
        let get = |on, operation: &str, column| number(counts.get(on, &of(operation), column));
        let both = |column| [M0, M4F].map(|on| get(on, "scene", column)).join(", ");
        let ratio = |on| match counts.get(on, &of("pixel"), "instructions") {
            Some(_) => format!("{:.2}", counts.of_nine_terms(on, &of("pixel"))),
            None => "-".into(),
        };
        let instructions = |on, operation| get(on, operation, "instructions");
        vec![
            scene.title.into(),
            effects(scene).join(", "),
            scene.terms().to_string(),
            both("flash_bytes"),
            both("ram_bytes"),
            instructions(M0, "pixel"),
            instructions(M4F, "pixel"),
            instructions(M0, "light"),
            instructions(M4F, "light"),
            instructions(M4F, "turn"),
            format!("{}, {}, ×{host:.2}", ratio(M0), ratio(M4F)),
        ]
    };
    table(columns, SCENES.iter().zip(host).map(row))
}

/// The names of a scene's effects and requirements.
fn effects(scene: &Scene) -> Vec<String> {
    let table = scene.whole_table();
    let wanted = table.effects();
    let has_modes = |effect: &Effect| *effect == Effect::Ambient || table.gram.degree > 0;
    let effects = Effect::ALL.into_iter().filter(|&effect| wanted.has(effect)).filter(has_modes);
    let mut names: Vec<String> = effects.map(|effect| effect.name().into()).collect();
    names.extend((scene.channels == 3).then(|| "color".into()));
    names.extend(scene.turns.then(|| "turning".into()));
    names
}

/// What leaving an effect out saves, for the scenes with several effects.
fn savings() -> String {
    let shown = |Size { components, terms, numbers }| {
        format!("{components}, {terms}, {}", grouped(numbers))
    };
    let row = |name| {
        let scene = Scene::named(name);
        let sizes = [None].into_iter().chain(Effect::ALL.map(Some));
        let sizes = sizes.map(|without| scene.size(without).map_or(String::new(), shown));
        [scene.title.into()].into_iter().chain(sizes).collect()
    };
    let columns = "scene | all: | no ambient: | no diffuse: | no broad: | no gloss:";
    table(columns, ["sky_lambertian", "studio_plaster", "studio_velvet", "sun_leather"].map(row))
}

/// What each effect contributes.
fn worth() -> String {
    let names = ["ambient", "diffuse", "broad", "gloss", "color", "turning", "left out"];
    let row = |scene: &Scene| {
        let shares = shares(scene);
        let share = |name| shares.get(name).map_or(String::new(), |share| percent(*share));
        [&[scene.title.into(), scene.light.into()], &names.map(share)[..]].concat()
    };
    let columns = "\
        scene | light | ambient: | diffuse: | broad: | gloss: | color: | turning: | \
        the scene leaves out:";
    table(columns, SCENES.iter().map(row))
}

/// Errors of the scenes' own tables, which must keep the scenes' tolerances.
fn own() -> Result<String, String> {
    let mut beyond = Vec::new();
    let mut row = |scene: &Scene| {
        let found = errors(scene);
        let [of_f32, _, of_q15] = found;
        if !(of_f32 <= scene.tolerance && of_q15 <= scene.tolerance) {
            beyond.push(format!("{}: {found:?}", scene.name));
        }
        let cells = [scene.title.into(), format!("{:e}", scene.tolerance)];
        [&cells[..], &found.map(|error| format!("{error:.1e}"))].concat()
    };
    let columns =
        "scene | within: | f32, its light: | f32, the worst of 26 lights: | Q15, its light:";
    let text = table(columns, SCENES.iter().map(&mut row));
    if beyond.is_empty() { Ok(text) } else { Err(beyond.join("; ")) }
}

/// The table of the page that compares scenes with the formula.
fn beside(counts: &Counts) -> String {
    let ratios = |operation: &str| {
        let [m0, m4f] = [M0, M4F].map(|on| counts.of_nine_terms(on, operation));
        format!("{m0:.2} (M0) and {m4f:.2} (M4F)")
    };
    let pixel = |name: &str| ratios(&format!("{name}/pixel"));
    let terms = |name: &str| Scene::named(name).terms().to_string();
    let nine = of_nine_terms();
    let [formula, best] = [0, 1].map(|k| nine.iter().map(|errors| errors[k]).collect::<Vec<_>>());
    let most = |errors: &[f64]| percent(errors.iter().copied().fold(0.0, f64::max));
    let count = |number: usize| number.to_string();
    let enough = best.iter().filter(|&&error| error <= 1e-2).count();
    let within = terms_within(&Scene::named("park_lambertian_fine"), 1e-2);
    let kept = within.iter().filter(|&&terms| terms <= 9).count();
    let middle = median(&within.iter().map(|&terms| terms as f64).collect::<Vec<_>>());
    let [limit, typical] = [tolerances::OF_NINE_TERMS, tolerances::TYPICAL_OF_NINE_TERMS];
    let rows = [
        ("Lambertian, light of degree 2: instructions of a pixel", ratios("shade_lambertian")),
        ("the same, asserted limit", limit.to_string()),
        ("Lambertian, shipped lights: number", count(nine.len())),
        ("error of the formula, median", percent(median(&formula))),
        ("error of the formula, worst", most(&formula)),
        ("error of the nearest nine coefficients, median", percent(median(&best))),
        ("error of the nearest nine coefficients, worst", most(&best)),
        ("lights under which nine coefficients are within 1e-2", count(enough)),
        ("terms that `collapse_within` keeps at 1e-2, median", middle.to_string()),
        ("terms, fewest", count(within.iter().min().copied().unwrap_or(0))),
        ("terms, most", count(within.iter().max().copied().unwrap_or(0))),
        ("lights under which nine terms or fewer are kept", count(kept)),
        ("the scene made for 1e-2: terms", terms("park_lambertian")),
        ("the scene made for 1e-2: instructions of a pixel", pixel("park_lambertian")),
        ("plaster at 1e-3: instructions of a pixel", pixel("studio_plaster")),
        ("velvet at 1e-3", pixel("studio_velvet")),
        ("leather at 1e-3", pixel("sun_leather")),
        ("these three, asserted limit", typical.to_string()),
        ("ambient light on velvet: terms", terms("ambient_velvet")),
    ];
    let columns = "a Lambertian or typical scene, beside the nine-term formula | found:";
    table(columns, rows.map(|(what, found)| vec![what.into(), found]))
}

pub fn multiplications() -> Multiplications {
    Multiplications::of(&decode(shipped::TABLE).expect("the shipped table")).expect("a basis")
}

/// The work after each change with the shipped table, as multiplications and as counted
/// instructions. The boards use their own table to count a pixel.
fn changes(counts: &Counts, host: [f64; 4]) -> String {
    let found = multiplications();
    let boards = [M4F, M0, M3, RV32];
    let get = |on: [&str; 2], operation: &str| counts.get(on, operation, "instructions");
    let counted = |operations: &[&str]| {
        boards.map(|on| number(operations.iter().map(|one| get(on, one)).sum())).join(" | ")
    };
    let turned = boards.map(|on| {
        // The former is of three channels.
        let turned = get(on, "turn").zip(get(on, "relight_collapse"));
        number(turned.map(|(turn, light)| turn / 3 + light))
    });
    let relight = found.relight + found.collapse;
    let [of_light, of_turn, of_material] =
        [relight, found.turn, found.transfer + relight].map(grouped);
    let of_turn = format!("{of_turn}, then {of_light}");
    let mut full = decode(BOARDS.0).expect("the boards' table");
    trim(&mut full, BOARDS.1);
    let full = Multiplications::of(&full).expect("a basis").pixel;
    // What is new, redone and kept; multiplications; counts on the boards.
    let changes = [
        "light | `relight`, `collapse` | the material's transfer",
        "light, turned | `Light::turned`, `relight`, `collapse` | the material's transfer",
        "material | `transfer`, `relight`, `collapse` | the light's coefficients",
        "view of the same light: normals | each pixel: `shade` | the scene, all of it",
        "the same, table `full.toml` | each pixel: `shade` | the scene",
    ];
    let of_pixel = [found.pixel, full].map(|products| format!("{products} a pixel"));
    let products = [of_light, of_turn, of_material].into_iter().chain(of_pixel);
    let counts = [
        counted(&["relight_collapse"]),
        turned.join(" | "),
        counted(&["transfer", "relight_collapse"]),
        "- | - | - | -".into(),
        counted(&["shade"]),
    ];
    let times = host.map(|time| format!("×{}", grouped(time.round() as usize)));
    let times = times.into_iter().chain(["-".into()]);
    let columns = "\
        what is new | redone | kept | multiplications: | M4F `f32`: | M0 `q15`: | M3 `q15`: | \
        RV32 `q15`: | host:";
    let rows = changes.into_iter().zip(products).zip(counts).zip(times);
    table(columns, rows.map(|(((what, all), counts), time)| vec![what.into(), all, counts, time]))
}
