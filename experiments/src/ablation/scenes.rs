//! The ten scenes, and the light and the material of each.

use eigenshade_index::material;
use eigenshade_model::database::{Lights, Named};
use eigenshade_shading::shipped;
use eigenshade_table::{Table, decode};

/// A scene of `firmware/scenes`.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// Its name there and in `firmware/counts.csv`.
    pub name: &'static str,
    /// Whose table it has.
    pub table: &'static str,
    /// What the page calls it.
    pub title: &'static str,
    /// The shipped light that it is measured under.
    pub light: &'static str,
    /// Channels: 1, luminance, or 3.
    pub channels: usize,
    /// Whether its light turns.
    pub turns: bool,
    /// What table, terms and format may cost under its light, of the peak. The file's own
    /// tolerance is of the mean peak of all lights, and lower where this one's is.
    pub tolerance: f64,
}

const fn still(name: &'static str, title: &'static str, light: &'static str) -> Scene {
    Scene { name, table: name, title, light, channels: 1, turns: false, tolerance: 1e-3 }
}

const LEATHER: Scene = still("sun_leather", "sun on leather", "esplanade");

/// In the order of the page.
pub const SCENES: [Scene; 10] = [
    still("ambient_lambertian", "ambient on Lambertian", "sky"),
    still("ambient_velvet", "ambient on velvet", "sky"),
    still("sky_lambertian", "sky of degree 2 on Lambertian", "sky"),
    Scene { tolerance: 1e-2, ..still("park_lambertian", "park on Lambertian to 1e-2", "park") },
    still("park_lambertian_fine", "park on Lambertian to 1e-3", "park"),
    still("studio_plaster", "studio on plaster, no gloss", "studio"),
    still("studio_velvet", "studio on velvet", "studio"),
    LEATHER,
    Scene { name: "sun_leather_colour", title: "sun on leather in colour", channels: 3, ..LEATHER },
    Scene {
        name: "sun_leather_turning",
        title: "sun on leather in colour, turning",
        channels: 3,
        turns: true,
        ..LEATHER
    },
];

impl Scene {
    /// The scene of this name.
    pub fn named(name: &str) -> Self {
        *SCENES.iter().find(|scene| scene.name == name).expect("a scene of the page")
    }

    /// Its table, as `eigenshade basis` makes it.
    pub fn whole_table(&self) -> Table {
        let path = format!("firmware/scenes/{}.bin", self.table);
        let bytes = std::fs::read(eigenshade_testing::repository().join(&path)).expect(&path);
        decode(&bytes).expect("a table")
    }

    /// Its light to a degree, by channel.
    pub fn light(&self, degree: usize) -> Vec<Vec<f64>> {
        let lights = lights(degree).entries;
        let light = lights.into_iter().find(|light| light.name == self.light);
        self.channels_of(&light.expect("a shipped light"))
    }

    /// A light by channel: its luminance where there is one.
    pub fn channels_of(&self, light: &Named) -> Vec<Vec<f64>> {
        if self.channels == 1 { vec![light.luminance()] } else { light.rgb.to_vec() }
    }
}

/// The shipped lights to a degree.
pub fn lights(degree: usize) -> Lights {
    shipped::lights().expect("the shipped lights").truncated(degree)
}

/// A material of a table to an order: the one that its scene names, or the white Lambertian.
pub fn material(table: &Table, order: usize) -> Vec<f64> {
    let mut coefficients = match table.scene.material.names.as_slice() {
        [name] => {
            let materials = shipped::materials().expect("the shipped materials");
            let found = materials.entries.iter().find(|one| one.name == *name);
            found.expect("a shipped material").luminance()
        }
        _ => vec![2.0],
    };
    coefficients.resize(material::count(order), 0.0);
    coefficients
}
