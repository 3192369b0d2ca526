//! Which image to draw: options that `shade` and `render` share.

use super::options::{WindowChoice, angles, count, effect, window};
use clap::Args;
use eigenshade::Effect;
use eigenshade_cli::table;
use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::Source;
use eigenshade_table::Table;
use eigenshade_table::effect::Effects;
use std::path::Path;

/// Options that change an image.
#[derive(Args, Debug)]
pub struct Choices {
    /// Only the first K components; not for the method modes
    #[arg(long, value_name = "K", value_parser = count(1, u64::from(u16::MAX)))]
    pub components: Option<usize>,
    /// Rotate the light by Rz(A) Ry(B) Rz(C), radians
    #[arg(long, value_name = "A,B,C", value_parser = angles, allow_hyphen_values = true)]
    rotate: Option<Rotation>,
    /// Only these effects: ambient, diffuse, broad, gloss; their pictures sum to the whole
    /// [default: all]
    #[arg(long, value_name = "A,B", value_delimiter = ',', value_parser = effect)]
    effects: Vec<Effect>,
    /// Multiply degree l of the light by sinc^4, (sin x / x)^4 with x = pi l / W, zero from degree
    /// W on. `auto` takes the weakest that leaves no dark rings: no channel below -0.02 of white
    /// [default: auto for `render`, none for `shade`]
    #[arg(long, value_name = "W|auto|none", value_parser = window)]
    window: Option<WindowChoice>,
}

impl Choices {
    /// Whether all effects are drawn. Images of some effects may be negative.
    pub fn has_all_effects(&self) -> bool {
        self.effects.is_empty()
    }

    /// The rotation of the light, if there is one.
    #[cfg(feature = "generate")]
    pub fn rotation(&self) -> Option<Rotation> {
        self.rotate
    }

    /// The window that is asked for.
    pub fn window(&self) -> Option<WindowChoice> {
        self.window
    }

    /// The number of components to use. Fails if the table at `path` has fewer.
    pub fn components(&self, table: &Table, path: &Path) -> Result<usize> {
        table::components(table, self.components, path)
    }

    /// The requested effects. Fails if the table lacks one of them.
    pub fn effects(&self, table: &Table) -> Result<Effects> {
        let all = table.effects();
        if let Some(effect) = self.effects.iter().find(|&&effect| !all.has(effect)) {
            let what = format!("the table has no {}", effect.name());
            return Err(Error::new(what, format!("it has {}", table::effect_names(all))));
        }
        let requested = self.effects.iter().copied().collect();
        Ok(if self.effects.is_empty() { Effects::ALL } else { requested })
    }

    /// Checks that the table allows a rotation, if one is requested. Fails if the table is for
    /// fixed light.
    pub fn check_rotation(&self, table: &Table) -> Result<()> {
        if self.rotate.is_some() && !table.scene.effects.rotation {
            let what = "the table is for fixed light: its scene has effects.rotation = false";
            let remedy = "leave --rotate out, or make a table with effects.rotation = true";
            return Err(Error::new(what, remedy));
        }
        Ok(())
    }

    /// A source after the rotation of the light.
    pub fn turned(&self, source: &Source) -> Source {
        self.rotate.map_or(*source, |rotation| source.turned(rotation.matrix()))
    }

    /// Rotates lights.
    pub fn rotate(&self, lights: &mut Lights) {
        let degree = lights.degree;
        for channel in lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb) {
            if let Some(rotation) = self.rotate {
                *channel = rotation.turn(degree, channel);
            }
        }
    }
}
