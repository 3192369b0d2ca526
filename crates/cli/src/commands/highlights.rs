//! Small sources of a light on the gloss of a material, which `render` and `shader` share.

use super::choices::Choices;
use super::options::Inputs;
use eigenshade::{Effect, Highlights};
use eigenshade_cli::messages::print_message;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::highlights as model;
use eigenshade_model::source::{Gloss, NamedGloss, Source};
use eigenshade_shading::estimate::{Estimates, counted, matte_note, off_lobe_note};
use eigenshade_shading::highlights;
use eigenshade_shading::shader::fault;
use eigenshade_table::Table;
use eigenshade_table::highlights::MAX_SOURCES;

/// The inputs of `Highlights`: small sources, and the gloss that reflects them.
pub struct HighlightInputs {
    gloss: Gloss,
    sources: Vec<Source>,
}

/// The most sources that are taken without being asked for.
const MOST: usize = 8;

/// The number of sources that a picture needs at a degree and an order, with a note if it is not
/// close even so. None are needed if the gloss of the material or the sources of the light are not
/// known, or the table has no gloss. Fails if a file cannot be read.
pub fn needed(
    inputs: &Inputs,
    table: &Table,
    (lights, materials): (&Lights, &Materials),
    within: Option<f64>,
) -> Result<(usize, Option<String>)> {
    let (light, material) = (&lights.entries[0], &materials.entries[0].name);
    let gloss = shining(inputs, table, (lights, materials))?;
    let Some(NamedGloss { gloss, error, .. }) = gloss else { return Ok((0, None)) };
    let size = (lights.degree, materials.order);
    let estimates = Estimates::under(&inputs.light, &light.name)?;
    let most = if estimates.is_of_the_light() { MOST } else { 0 };
    let estimate = estimates.fewest(size, &gloss, within, most);
    let note = estimates.note(material, size, &gloss, estimate, within);
    let note = note.or_else(|| off_lobe_note(material, error).filter(|_| estimate.sources > 0));
    Ok((estimate.sources, note))
}

/// A note if a picture of the first light on the first material with this many sources is not
/// close. Fails if a file with errors or gloss cannot be read.
pub fn estimate_note(
    inputs: &Inputs,
    table: &Table,
    (lights, materials): (&Lights, &Materials),
    sources: usize,
) -> Result<Option<String>> {
    let (light, material) = (&lights.entries[0].name, &materials.entries[0].name);
    let gloss = shining(inputs, table, (lights, materials))?;
    let Some(gloss) = gloss else { return Ok(None) };
    let size = (lights.degree, materials.order);
    let estimates = Estimates::under(&inputs.light, light)?;
    let estimate = estimates.of(size, &gloss.gloss, sources);
    let note = estimates.note(material, size, &gloss.gloss, estimate, None);
    Ok(note.or_else(|| off_lobe_note(material, gloss.error).filter(|_| estimate.sources > 0)))
}

/// The gloss of the material, if it is known and shines: not with a table without gloss, nor under
/// light that is the same from everywhere. Fails if its file cannot be read.
fn shining(
    inputs: &Inputs,
    table: &Table,
    (lights, materials): (&Lights, &Materials),
) -> Result<Option<NamedGloss>> {
    let is_even = |channel: &Vec<f64>| channel[1..].iter().all(|&coefficient| coefficient == 0.0);
    if !table.effects().has(Effect::Gloss) || lights.entries[0].rgb.iter().all(is_even) {
        return Ok(None);
    }
    inputs.material.gloss(&materials.entries[0].name)
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
    ) -> Result<Option<Self>> {
        if !table.effects().has(Effect::Gloss) {
            let what = "the table's scene has no gloss, and sources are for highlights";
            return Err(Error::new(what, "leave --sources out, or use --table color"));
        }
        let (light, material) = (&lights.entries[0].name, &materials.entries[0].name);
        let NamedGloss { gloss, .. } = inputs.material.known_gloss(material)?;
        if !gloss.needs_sources() {
            inputs.light.sources(light, MAX_SOURCES)?;
            let note = matte_note(material, &gloss);
            print_message(format_args!("{note}, and it is drawn without"));
            return Ok(None);
        }
        let sources = inputs.light.sources(light, most)?;
        if sources.len() < most {
            let all = counted(sources.len());
            print_message(format_args!("note: `{light}` has {all}, of {most} asked for"));
        }
        model::take_out(&mut lights.entries[0].rgb, lights.degree, &sources);
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

    /// The highlights in f64.
    pub fn in_f64(&self) -> model::Highlights {
        model::Highlights::new(&self.gloss, &self.sources)
    }

    /// The highlights in f32. Fails if the runtime refuses a source or the gloss.
    pub fn shaded(&self) -> Result<Highlights<MAX_SOURCES>> {
        let sources = self.sources.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
        Highlights::new(&highlights::gloss(&self.gloss)?, &sources).map_err(fault)
    }
}
