//! `eigenshade render` of an object with materials of its own.

use super::drawing::Drawing;
use super::options::{Sources, WindowChoice, input_file};
use super::render::{Format, Render};
use super::shadows;
use eigenshade_asset::asset::Asset;
use eigenshade_asset::picture::{Picture, Settings};
use eigenshade_cli::messages::{dark_light_warning, print_message, spinner};
use eigenshade_cli::object::SIZE;
use eigenshade_cli::picture_file::PictureFile;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;

/// The table of pictures of glTF's materials.
const TABLE: &str = "pbr";

impl Render {
    /// The object to draw, if it has materials of its own and no other is asked for.
    pub fn own_materials(&self) -> Result<Option<(InputFile, Asset)>> {
        if self.inputs.material.is_some() {
            return Ok(None);
        }
        let file = input_file(&self.normals);
        Ok(Asset::read(&file)?.map(|asset| (file, asset)))
    }

    /// Draws an object with its own materials.
    pub fn run_own(&self, kind: PictureFile, file: &InputFile, asset: &Asset) -> Result<()> {
        if matches!(self.format, Format::F64) {
            let what = "an object's own materials are drawn in f32";
            return Err(Error::new(what, "leave --format out, or give a --material"));
        }
        let pose = self.pose.options(self.size, self.green);
        pose.check(file)?;
        let choice = self.table.or(TABLE);
        let table = choice.read()?;
        self.choices.check_rotation(&table)?;
        let components = self.choices.components(&table, choice.path())?;
        let light = &self.inputs.light;
        let dark = dark_light_warning(&light.lights()?);
        let settings = Settings {
            size: self.size.unwrap_or(SIZE),
            view: pose.view(),
            table: Some(&table),
            components: Some(components),
            effects: self.choices.effects(&table)?,
            rotation: self.choices.rotation(),
            sources: match self.sources {
                Some(Sources::Most(most)) => Some(most),
                None | Some(Sources::Auto) => None,
            },
            tolerance: self.tolerance,
            window: match self.choices.window() {
                Some(WindowChoice::Given(window)) => Some(window),
                None | Some(WindowChoice::Auto) => None,
            },
            exposure: self.exposure,
            tone: self.tone.unwrap_or_default(),
        };
        let progress = spinner("drawing the object");
        let picture = Picture::of(file, asset, light, &settings)?;
        progress.finish_and_clear();
        let Picture { size, sources, window, .. } = picture;
        let mut draw = |show: &mut dyn FnMut(_, _)| {
            picture.draw(show);
            Ok(())
        };
        kind.write(&self.out, [size; 2], picture.development(), &mut draw)?;
        print_message(Drawing { table: choice.path(), components, sources, window });
        let shadows =
            if sources > 0 { shadows::warning(&self.normals, &pose.view())? } else { None };
        dark.into_iter().chain(shadows).chain(picture.note).for_each(print_message);
        Ok(())
    }
}
