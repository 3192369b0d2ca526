//! `docs/ablation.md`.

use super::cells::{line, number, percent};
use super::changes::changes;
use super::counts::{Column, Counts, M0, M4F};
use super::errors::errors;
use super::savings::savings;
use super::scenes::{SCENES, Scene};
use super::sentences::sentences;
use super::shares::shares;
use eigenshade_index::effect::Effect;
use eigenshade_table::Parts;

/// What makes the page.
pub const COMMAND: &str = "cargo run --release --example ablation -- --out docs/ablation.md";

const HEAD: &str = "\
# Only what a scene calls for

Ten scenes of `firmware/scenes`, each of which asks for more than the one before: what each costs, and what its effects are worth. A scene has the modes, components, azimuths and terms
that its file calls for; its neighbours tell what one effect more costs. `tests/ablation_page.rs` makes the tables again, computes the errors and asserts the sentences; counts are those of `firmware/counts.csv`.

## What it costs

On a Cortex-M0 in Q15 and a Cortex-M4F in f32, by programs of `firmware/programs/src/scenes.rs`. Flash and RAM (without stack) are what a program has more than an empty one: table, code, and the making of its inputs. The
material is one that does not change: in Q15 it was folded in when the program was compiled; in f32 it is folded in when the program starts, and the factors for it are in the flash. *Pixel* is one normal in all channels, *light* a new light up to
the image's polynomials, *turn* what comes before that if the light turns. Terms are those of one channel. The last column is in pixels of one channel by the nine-term formula; on the host in f32, over pictures of 96 x 96 in blocks, in the same run.

| scene | effects | terms | flash M0, M4F | RAM M0, M4F | pixel M0 | pixel M4F | light M0 | light M4F | turn M4F | pixel, in nine-term pixels: M0, M4F, host |
|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|
";

const ERRORS: &str = "
Integers do not turn light: the last scene has no program on the M0, which takes turned lights from elsewhere. Integers refuse a table whose ambient takes orders that no other effect of it takes: so the
second scene's file names all effects, of which the others have no modes at degree 0, and the plaster is of order 3, which takes its ambient of higher orders away as well.

## What it is worth

The error if an effect is left out: root mean square over the sphere, of the peak of the scene's whole picture, by direct sums in f64. Of an effect it is its own picture; of colour the difference to luminance; of turning that to a picture that stays
while its light turns by 30 degrees about the vertical. *The scene leaves out* is its distance from degree 9, order 7 and all effects, in its channels.

| scene | light | ambient | diffuse | broad | gloss | colour | turning | the scene leaves out |
|---|---|---:|---:|---:|---:|---:|---:|---:|
";

const OWN: &str = "
And what table, terms and format lose of that: against the direct sum of the scene's own effects, degree and order.

| scene | within | f32, its light | f32, the worst of 26 lights | Q15, its light |
|---|---:|---:|---:|---:|
";

/// The page; `host` gives the ratios of times of a scene and, of none, those of the changes.
pub fn page(host: impl Fn(Option<&Scene>) -> Vec<f64>) -> String {
    let counts = Counts::recorded();
    let mut text = format!("<!-- {COMMAND} -->\n{HEAD}");
    for scene in &SCENES {
        line(&mut text, &costs(scene, &counts, host(Some(scene))[0]));
    }
    text += &savings();
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
    let lengths = Parts::new(&scene.whole_table()).lengths;
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
