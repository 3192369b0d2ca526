//! Small sources of a light on the gloss of a material, which `render` and `shader` share.

use super::choices::Choices;
use super::options::{Inputs, Memory};
use eigenshade::mathematics::Libm;
use eigenshade::{Highlights, Scalar};
use eigenshade_cli::messages::print_message;
use eigenshade_model::database::Lights;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::source_csv::MOST;
use eigenshade_model::source::{Gloss, Source};
use eigenshade_shading::highlights;
use eigenshade_shading::shader::fault;

/// Small sources on a gloss.
pub struct Gleam {
    gloss: Gloss,
    sources: Vec<Source>,
}

/// The rms that a fitted gloss leaves, relative to pictures under a small source, from which on it is
/// worth a note.
const FAR: f64 = 0.15;

impl Gleam {
    /// Up to `most` sources of the first light, which they are taken out of. A matte material has
    /// none, with a note.
    ///
    /// # Errors
    ///
    /// If the light has no sources, or the gloss of the material is not known.
    pub fn taken_out(
        inputs: &Inputs,
        lights: &mut Lights,
        most: usize,
        memory: Memory,
    ) -> Result<Option<Self>> {
        let Inputs { light, material } = inputs;
        let (gloss, left) = material.gloss()?;
        let sources = light.sources(&lights.entries[0].name, most, memory.of_file())?;
        if !highlights::pay(&gloss) {
            print_message(format_args!(
                "note: `{}` is as matte as a roughness of {:.2}: its pictures are as near without \
                 sources, and it is drawn without",
                material.path().display(),
                gloss.roughness
            ));
            return Ok(None);
        }
        if left > FAR {
            print_message(format_args!(
                "note: the gloss of `{}` is not quite a GGX lobe: its highlights are off by {:.0} %",
                material.path().display(),
                100.0 * left
            ));
        }
        highlights::take_out(lights, &sources)?;
        Ok(Some(Self { gloss, sources }))
    }

    /// These sources after the rotation of the light.
    pub fn turned(self, choices: &Choices) -> Self {
        let sources = self.sources.iter().map(|source| choices.turned(source)).collect();
        Self { sources, ..self }
    }

    /// The highlights in a number format.
    ///
    /// # Errors
    ///
    /// If the runtime refuses a source or the gloss.
    pub fn shaded<S: Scalar>(&self) -> Result<Highlights<S, MOST>> {
        let sources = self.sources.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
        Highlights::new::<Libm>(&highlights::gloss(&self.gloss)?, &sources).map_err(fault)
    }
}
