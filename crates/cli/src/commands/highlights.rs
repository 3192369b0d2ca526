//! Small sources of a light on the gloss of a material, which `render` and `shader` share.

use super::choices::Choices;
use super::options::{Inputs, Memory, TableChoice};
use eigenshade::mathematics::Libm;
use eigenshade::{Effect, Highlights, Scalar};
use eigenshade_cli::messages::print_message;
use eigenshade_cli::sharpness::{Choice, Sharpness, counted, matte_note, shipped_note};
use eigenshade_index::highlights::{MAX_SOURCES, PRODUCTS};
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::source::{Gloss, NamedGloss, Source};
use eigenshade_shading::highlights;
use eigenshade_shading::shader::fault;
use eigenshade_table::Table;

/// The inputs of `Highlights`: small sources, and the gloss that reflects them.
pub struct HighlightInputs {
    gloss: Gloss,
    sources: Vec<Source>,
}

/// The shipped tables that a tolerance chooses from, with degree and order.
const TABLES: [(&str, (usize, usize)); 2] = [("color", (9, 7)), ("pbr", (12, 12))];

/// The table and the most sources that take the fewest multiply-adds of those that leave at most
/// `tolerance`, or, if all leave more, those that leave least. A report says which. Only the given
/// table is used, if one is given. Fails if the gloss of the material or the errors of the light's
/// sources are not known, or a file cannot be read.
pub fn within(
    tolerance: f64,
    inputs: &Inputs,
    table: &TableChoice,
    (light, material): ((&str, usize), (&str, usize)),
    memory: Memory,
) -> Result<(TableChoice, usize)> {
    let ((light, degree), (material, order)) = (light, material);
    let NamedGloss { gloss, .. } = inputs.material.known_gloss(material, memory.of_file())?;
    let sharpness = Sharpness::under(&inputs.light, light, memory.of_file())?;
    // It takes no sources, whatever their errors are.
    if !sharpness.is_of_the_light() && !highlights::gloss::<f64>(&gloss)?.needs_sources() {
        return Ok((table.or(TABLES[0].0), 0));
    }
    let fits = |size: (usize, usize)| size == TABLES[0].1 || (size.0 <= degree && size.1 <= order);
    let mut best: Option<(usize, Choice, TableChoice, (usize, usize))> = None;
    for (name, size) in TABLES {
        if !fits(size) || table.is_given() && best.is_some() {
            continue;
        }
        let table = table.or(name);
        let read = table.read(memory)?;
        let size = (read.gram.degree.min(degree), read.gram.order.min(order));
        let choice = sharpness.fewest(size, &gloss, tolerance)?;
        let products = 3 * read.terms() + PRODUCTS * choice.most;
        let is_better = best.as_ref().is_none_or(|(least, other, ..)| {
            match (choice.error <= tolerance, other.error <= tolerance) {
                (true, true) => products < *least,
                (false, false) => choice.error < other.error,
                (is_within, _) => is_within,
            }
        });
        if is_better {
            best = Some((products, choice, table, size));
        }
    }
    let Some((_, choice, table, size)) = best else { return Ok((table.or(TABLES[0].0), 0)) };
    print_message(choice.report(size, tolerance));
    Ok((table, choice.most))
}

impl HighlightInputs {
    /// Up to `most` sources of the first light, which they are taken out of, for the first
    /// material. A matte material has none, with a note. Fails if the table has no gloss, the light
    /// has no sources, or the gloss of the material is not known.
    pub fn taken_out(
        inputs: &Inputs,
        table: &Table,
        (lights, materials): (&mut Lights, &Materials),
        most: usize,
        memory: Memory,
    ) -> Result<Option<Self>> {
        if !table.effects().has(Effect::Gloss) {
            let what = "the table's scene has no gloss, and sources are for highlights";
            return Err(Error::new(what, "leave --sources out, or use --table color"));
        }
        let (light, material) = (&lights.entries[0].name, &materials.entries[0].name);
        let NamedGloss { gloss, .. } = inputs.material.known_gloss(material, memory.of_file())?;
        if !highlights::gloss::<f64>(&gloss)?.needs_sources() {
            inputs.light.sources(light, MAX_SOURCES, memory.of_file())?;
            let note = matte_note(material, &gloss);
            print_message(format_args!("{note}, and it is drawn without"));
            return Ok(None);
        }
        let sources = inputs.light.sources(light, most, memory.of_file())?;
        if sources.len() != most {
            let drawn = counted(sources.len());
            print_message(format_args!("note: {drawn}, the largest set of at most {most}"));
        }
        highlights::take_out(&mut lights.entries[0].rgb, lights.degree, &sources)?;
        Ok(Some(Self { gloss, sources }))
    }

    /// The number of sources.
    pub fn count(&self) -> usize {
        self.sources.len()
    }

    /// These sources after the rotation of the light.
    pub fn turned(self, choices: &Choices) -> Self {
        let sources = self.sources.iter().map(|source| choices.turned(source)).collect();
        Self { sources, ..self }
    }

    /// The highlights in a number format. Fails if the runtime refuses a source or the gloss.
    pub fn shaded<S: Scalar>(&self) -> Result<Highlights<S, MAX_SOURCES>> {
        let sources = self.sources.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
        Highlights::new::<Libm>(&highlights::gloss(&self.gloss)?, &sources).map_err(fault)
    }
}

/// A note if the picture of the first light on the first material, as they are drawn, is far off.
/// Fails if a file with errors or gloss cannot be read.
pub fn sharpness_note(
    inputs: &Inputs,
    table: &Table,
    (lights, materials): (&Lights, &Materials),
    sources: usize,
    memory: Memory,
) -> Result<Option<String>> {
    let (light, material) = (&lights.entries[0], &materials.entries[0].name);
    // Light that is the same from everywhere has no highlights.
    if light.rgb.iter().all(|channel| channel[1..].iter().all(|&coefficient| coefficient == 0.0)) {
        return Ok(None);
    }
    let size = (lights.degree, materials.order);
    let gloss = inputs.material.gloss(material, memory.of_file())?;
    let note = match (inputs.material.total_error(size).filter(|_| sources == 0), &gloss) {
        // A light of a lower degree may be whole.
        (Some((measured, _)), _) if lights.degree < measured.0.min(table.gram.degree) => None,
        (Some((measured, error)), _) => shipped_note(material, measured, size, error),
        (None, Some(gloss)) => Sharpness::under(&inputs.light, &light.name, memory.of_file())?
            .note(gloss, size, sources)?,
        (None, None) => None,
    };
    let Some(mut note) = note else { return Ok(None) };
    if lights.degree < table.gram.degree {
        note += &format!(
            "; the light ends at degree {}, and the table shows {}",
            lights.degree, table.gram.degree
        );
    }
    let is_glossy = gloss.is_some() && table.effects().has(Effect::Gloss);
    let known = || inputs.light.sources(&light.name, MAX_SOURCES, memory.of_file());
    if sources == 0 && is_glossy && known().is_ok_and(|known| !known.is_empty()) {
        note += "; `--sources 4` draws small bright sources sharply";
    }
    Ok(Some(note))
}
