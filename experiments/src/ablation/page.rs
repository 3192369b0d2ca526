//! The generated parts of `docs/ablation.md`.

use super::beside::beside;
use super::cells::{line, number, percent};
use super::changes::changes;
use super::counts::{Column, Counts, M0, M4F};
use super::errors::errors;
use super::savings::savings;
use super::scenes::{SCENES, Scene};
use super::shares::shares;
use crate::pages::Part;
use eigenshade_index::effect::Effect;
use eigenshade_table::Parts;

/// The command that regenerates the parts.
pub const COMMAND: &str = "cargo run --release -p experiments -- ablation --out docs/ablation.md";

/// The parts of the page. `host` returns the time ratios of a scene, or those of the changes for
/// `None`.
pub fn parts(host: impl Fn(Option<&Scene>) -> Vec<f64>) -> Vec<Part> {
    let counts = Counts::recorded();
    let rows = |row: &dyn Fn(&Scene) -> Vec<String>| {
        let mut text = String::new();
        SCENES.iter().for_each(|scene| line(&mut text, &row(scene)));
        text
    };
    let own = |scene: &Scene| {
        let found = errors(scene);
        let cells = [scene.title.into(), format!("{:e}", scene.tolerance)];
        let errors = [found.f32, found.worst, found.q15].map(|error| format!("{error:.1e}"));
        [&cells[..], &errors[..]].concat()
    };
    vec![
        (
            "costs",
            HEAD_COSTS.to_owned() + &rows(&|scene| costs(scene, &counts, host(Some(scene))[0])),
        ),
        ("savings", savings()),
        ("worth", HEAD_WORTH.to_owned() + &rows(&|scene| worth(scene))),
        ("own", HEAD_OWN.to_owned() + &rows(&own)),
        ("beside", beside(&counts)),
        ("changes", changes(&counts, &host(None))),
    ]
}

const HEAD_COSTS: &str = "\
| scene | effects | terms | flash M0, M4F | RAM M0, M4F | pixel M0 | pixel M4F | light M0 | light M4F | turn M4F | pixel, in nine-term pixels: M0, M4F, host |
|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|
";
const HEAD_WORTH: &str = "\
| scene | light | ambient | diffuse | broad | gloss | colour | turning | the scene leaves out |
|---|---|---:|---:|---:|---:|---:|---:|---:|
";
const HEAD_OWN: &str = "\
| scene | within | f32, its light | f32, the worst of 26 lights | Q15, its light |
|---|---:|---:|---:|---:|
";

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

/// The number of terms of one channel's polynomials on the boards.
pub fn terms(scene: &Scene) -> usize {
    let lengths = Parts::new(&scene.whole_table()).lengths;
    let both: usize = lengths.iter().map(|&length| 2 * usize::from(length)).sum();
    both - lengths.first().map_or(0, |&length| usize::from(length))
}

/// The names of a scene's effects and requirements.
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
