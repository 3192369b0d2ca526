//! The ten scenes with the light and the material of each, and their times on this machine,
//! relative to a pixel by the nine-term formula in the same run.

use crate::accuracy_cost::times::least;
use eigenshade::{Light, Material, NineTerms, Rotation, sphere};
use eigenshade_generator::scene_file;
use eigenshade_index::effect::Effect;
use eigenshade_index::{light, material};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::shipped;
use eigenshade_table::{Table, decode, parts};
use eigenshade_testing::fixtures::disc;
use eigenshade_testing::images::single;
use std::hint::black_box;
use std::path::PathBuf;

/// A scene of `firmware/scenes`.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// Its name there and in `firmware/counts.csv`.
    pub name: &'static str,
    /// The scene whose table it uses.
    pub table: &'static str,
    pub title: &'static str,
    /// The shipped light under which it is measured.
    pub light: &'static str,
    /// The number of channels: 1 for luminance, or 3.
    pub channels: usize,
    pub turns: bool,
    /// The allowed error of table, terms and format under its light, relative to the peak. The
    /// tolerance in the scene file is relative to the mean peak of all lights, and is lower where
    /// the peak of this light is lower.
    pub tolerance: f64,
}

const fn still(name: &'static str, title: &'static str, light: &'static str) -> Scene {
    Scene { name, table: name, title, light, channels: 1, turns: false, tolerance: 1e-3 }
}

const LEATHER: Scene = still("sun_leather", "sun on leather", "esplanade");
const TURNING: Scene = Scene { channels: 3, turns: true, ..LEATHER };
/// The scenes, in the order of the page.
pub const SCENES: [Scene; 10] = [
    still("ambient_lambertian", "ambient on Lambertian", "sky"),
    still("ambient_velvet", "ambient on velvet", "sky"),
    still("sky_lambertian", "sky of degree 2 on Lambertian", "sky"),
    Scene { tolerance: 1e-2, ..still("park_lambertian", "park on Lambertian to 1e-2", "park") },
    still("park_lambertian_fine", "park on Lambertian to 1e-3", "park"),
    still("studio_plaster", "studio on plaster, no gloss", "studio"),
    still("studio_velvet", "studio on velvet", "studio"),
    LEATHER,
    Scene { name: "sun_leather_color", title: "sun on leather in color", channels: 3, ..LEATHER },
    Scene { name: "sun_leather_turning", title: "sun on leather in color, turning", ..TURNING },
];

impl Scene {
    pub fn named(name: &str) -> Self {
        *SCENES.iter().find(|scene| scene.name == name).expect("a scene of the page")
    }

    /// The scene's table, as `eigenshade basis` makes it.
    pub fn whole_table(&self) -> Table {
        let path = format!("firmware/scenes/{}.bin", self.table);
        let bytes = std::fs::read(eigenshade_testing::repository().join(&path)).expect(&path);
        decode(&bytes).expect("a table")
    }

    pub fn path(&self) -> PathBuf {
        eigenshade_testing::repository().join(format!("firmware/scenes/{}.toml", self.name))
    }

    /// The number of terms of one channel's polynomials on the boards.
    pub fn terms(&self) -> usize {
        Size::of(&self.whole_table()).terms
    }

    /// The size of the scene's table, or of the table that is made without an effect to the same
    /// tolerance; `None` if the scene does not have the effect.
    pub fn size(&self, without: Option<Effect>) -> Option<Size> {
        let mut loaded = scene_file::load(self.path()).expect("a scene");
        let wanted = &mut loaded.scene.effects.wanted;
        if without.is_some_and(|effect| !wanted.contains(&effect)) {
            return None;
        }
        wanted.retain(|&one| Some(one) != without);
        Some(Size::of(&loaded.build().expect("a table")))
    }

    /// The shipped lights up to a degree, as luminances if the scene has one channel.
    pub fn lights(&self, degree: usize) -> Lights {
        let mut lights = shipped::lights().expect("the shipped lights").truncated(degree);
        if self.channels == 1 {
            lights.entries.iter_mut().for_each(Named::remove_color);
        }
        lights
    }

    pub fn light(&self, degree: usize) -> Lights {
        let mut lights = self.lights(degree);
        lights.entries.retain(|light| light.name == self.light);
        lights
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub components: usize,
    /// Terms of the polynomials of all azimuths; each costs a pixel one multiplication.
    pub terms: usize,
    /// Numbers in all statics of the table.
    pub numbers: usize,
}

impl Size {
    fn of(table: &Table) -> Self {
        let parts = parts::floats(table);
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

/// The gray material of a table up to an order: that of its scene, or the white Lambertian.
pub fn material(table: &Table, order: usize) -> Materials {
    let mut material = match table.scene.material.names.as_slice() {
        [name] => {
            let materials = shipped::materials().expect("the shipped materials").entries;
            let found = materials.into_iter().find(|one| one.name == *name);
            found.expect("a shipped material")
        }
        _ => Named { name: "white".into(), rgb: [vec![2.0], vec![2.0], vec![2.0]] },
    };
    material.remove_color();
    material.rgb.iter_mut().for_each(|channel| channel.resize(material::count(order), 0.0));
    Materials { order, entries: vec![material] }
}

/// Rounds, of which the fastest counts.
const ROUNDS: usize = 41;

/// Times relative to a pixel by the nine-term formula.
pub struct Times {
    /// Of a pixel of each scene, in all channels.
    pub scenes: Vec<f64>,
    /// With the shipped table: a new light, a turned light, a new material, and a pixel.
    pub changes: [f64; 4],
}

impl Times {
    pub fn measured() -> Self {
        Self { scenes: SCENES.iter().map(of_scene).collect(), changes: of_changes() }
    }
}

fn normals() -> OwnedNormals {
    OwnedNormals::new(&disc(96))
}

/// The time of an operation relative to that of a nine-term pixel.
fn of_nine_terms(operation: impl FnMut()) -> f64 {
    let owned = normals();
    let normals = owned.view().expect("as many of each");
    let formula = NineTerms::new([0.7f32, -0.1, 0.1, 0.2, -0.03, 0.05, 0.04, 0.02, 0.1]);
    let mut irradiance = vec![0.0f32; normals.len()];
    let nine_terms = || {
        let (formula, normals) = black_box((&formula, normals));
        formula.shade_slice(normals, black_box(&mut irradiance)).expect("a place for each");
    };
    let times = least(vec![Box::new(operation), Box::new(nine_terms)], ROUNDS);
    times[0] / times[1] * normals.len() as f64
}

fn of_scene(scene: &Scene) -> f64 {
    let table = scene.whole_table();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let (light, material) = (scene.light(degree), material(&table, order));
    let basis = OwnedBasis::new(&table);
    let basis = basis.basis().expect("a basis");
    let mut shader = Shader::new(basis, table.count());
    let lights = light.entries[0].rgb.iter().take(scene.channels);
    let scenes = lights.map(|light| {
        let d = shader.project(light, &material.entries[0].rgb[0]).expect("it fits");
        basis.collapse_into(d, vec![0.0; basis.scene_len()]).expect("room")
    });
    let scenes: Vec<_> = scenes.collect();
    let normals = normals();
    let normals = normals.view().expect("as many of each");
    let mut irradiance = vec![0.0; normals.len()];
    let picture = of_nine_terms(|| {
        for scene in &scenes {
            scene.shade_slice(normals, &mut irradiance).expect("a place for each");
            black_box(&mut irradiance);
        }
    });
    picture / normals.len() as f64
}

fn of_changes() -> [f64; 4] {
    const LIGHT: usize = light::count(sphere::DEGREE);
    let scene = Scene::named("sun_leather");
    let coefficients = single(scene.light(sphere::DEGREE).entries[0].luminance());
    let material = material(&scene.whole_table(), sphere::ORDER);
    let material = single(material.entries[0].luminance());
    let light = Light::new(&coefficients).expect("100 coefficients");
    let material = Material::new(&material).expect("40 coefficients");
    let transfer = sphere::transfer(&material).expect("it fits");
    let collapsed = |light: &Light<'_, f32>, transfer: &sphere::Transfer| {
        let d = sphere::relight(transfer, light).expect("it fits");
        sphere::collapse(&d).expect("it fits")
    };
    let rotation = Rotation::from_quaternion([0.1, 0.2, 0.3, 1.0]).expect("a rotation");
    let normals = normals();
    let normals = normals.view().expect("as many of each");
    let mut irradiance = vec![0.0; normals.len()];
    let image = collapsed(&light, &transfer);
    let picture = of_nine_terms(|| {
        image.shade_slice(normals, &mut irradiance).expect("a place for each");
        black_box(&mut irradiance);
    });
    [
        of_nine_terms(|| {
            black_box(collapsed(black_box(&light), &transfer));
        }),
        of_nine_terms(|| {
            let turned = black_box(&light).turned::<LIGHT>(&rotation).expect("room");
            let light = Light::new(&turned).expect("100 coefficients");
            black_box(collapsed(&light, &transfer));
        }),
        of_nine_terms(|| {
            let transfer = sphere::transfer(black_box(&material)).expect("it fits");
            black_box(collapsed(&light, &transfer));
        }),
        picture / normals.len() as f64,
    ]
}
