//! The saving from leaving an effect out of a scene: the scene's table is made without it, to the
//! same tolerance.

use super::cells::{line, number};
use super::scenes::Scene;
use eigenshade_generator::scene_file;
use eigenshade_index::effect::Effect;
use eigenshade_table::{Parts, Table};

/// The scenes with several effects.
const SCENES: [&str; 4] = ["sky_lambertian", "studio_plaster", "studio_velvet", "sun_leather"];

/// The size of a table: its components, the terms of a pixel, and the numbers in flash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// The number of components K.
    pub components: usize,
    /// Terms of the polynomials of all azimuths; each costs a pixel one multiplication.
    pub terms: usize,
    /// Numbers in all statics of the table.
    pub numbers: usize,
}

impl Size {
    /// The size of a table.
    fn of(table: &Table) -> Self {
        let parts = Parts::new(table);
        let both: usize = parts.lengths.iter().map(|&length| 2 * usize::from(length)).sum();
        let constant = parts.lengths.first().map_or(0, |&length| usize::from(length));
        let arrays = [&parts.polar, &parts.factors, &parts.ambient, &parts.terms];
        Self {
            components: table.count(),
            terms: both - constant,
            numbers: arrays.iter().map(|array| array.len()).sum(),
        }
    }
}

/// The size of a scene without an effect, or of the full scene; `None` if the scene does not have
/// the effect.
pub fn size(scene: &Scene, without: Option<Effect>) -> Option<Size> {
    let path =
        eigenshade_testing::repository().join(format!("firmware/scenes/{}.toml", scene.name));
    let mut loaded = scene_file::load(&path).expect("a scene");
    let wanted = &mut loaded.scene.effects.wanted;
    if without.is_some_and(|effect| !wanted.contains(&effect)) {
        return None;
    }
    wanted.retain(|&one| Some(one) != without);
    Some(Size::of(&loaded.build().expect("a table")))
}

/// The table of the page.
pub fn savings() -> String {
    let mut text = String::from(
        "\
| scene | all | no ambient | no diffuse | no broad | no gloss |
|---|---:|---:|---:|---:|---:|
",
    );
    for name in SCENES {
        let scene = Scene::named(name);
        let of = |without| match size(&scene, without) {
            Some(Size { components, terms, numbers }) => {
                format!("{components}, {terms}, {}", number(Some(numbers as u64)))
            }
            None => String::new(),
        };
        let without = Effect::ALL.map(Some);
        let cells = std::iter::once(None).chain(without).map(of);
        line(&mut text, &[vec![scene.title.into()], cells.collect()].concat());
    }
    text
}
