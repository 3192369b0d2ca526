//! An object of some hundred normals, and the runtime over its pixels.

use super::COUNT;
use super::oracle::Numbers;
use eigenshade::{GeneralBasis, Light, Material, Normal};
use eigenshade_generator::basis::general;
use eigenshade_generator::basis::light_statistics::LightStatistics;
use eigenshade_generator::basis::moments::{MaterialMoments, equal};
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_generator::reading::observation::{EigenimageValues, Observation, Observer};
use eigenshade_generator::reading::prior::Prior;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_model::database::Named;
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::{AnyBasis, OwnedBasis};
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation};
use nalgebra::{DMatrix, DVector};
use std::path::Path;

pub const DEGREE: usize = 4;
pub const ORDER: usize = 3;

/// An object of some hundred normals, and its table.
pub struct Object {
    pub loaded: Loaded,
    pub normals: WeightedNormals,
    pub table: Table,
}

impl Object {
    pub fn new(criterion: Criterion, rotation: LightRotation, components: usize) -> Self {
        let mut loaded = scene_file::load(Path::new("tables/sphere.toml")).expect("a scene");
        loaded.lights = loaded.lights.truncated(DEGREE);
        loaded.materials = loaded.materials.truncated(ORDER);
        loaded.lights.entries.truncate(12);
        loaded.materials.entries.truncate(20);
        let scene = &mut loaded.scene;
        (scene.light.degree, scene.material.order) = (DEGREE, ORDER);
        (scene.basis.criterion, scene.light.rotation) = (criterion, rotation);
        scene.basis.components = Some(components);
        scene.basis.profile_tolerance = 1e-13;
        let mut numbers = Numbers(3);
        let pairs = std::iter::from_fn(|| Some((numbers.normal(), 1.5 + numbers.next())));
        let pairs = pairs.filter(|([x, _, _], _)| *x > -0.4).take(COUNT);
        let normals = WeightedNormals::new(pairs).expect("normals");
        let geometry = Geometry::Listed(normals.clone());
        let (lights, materials) = (&loaded.lights, &loaded.materials);
        let table = general::build(&loaded.scene, &geometry, lights, materials).expect("a table");
        Self { loaded, normals, table }
    }

    /// The runtime's basis, its d and images.
    fn with_basis<T>(&self, work: impl FnOnce(GeneralBasis<'_, f64>) -> T) -> T {
        match OwnedBasis::<f64>::new(&self.table).any().expect("a basis") {
            AnyBasis::General(basis) => work(basis),
            AnyBasis::Sphere(_) => panic!("a table of the sphere"),
        }
    }

    /// d of lights on materials, (material, light) -> d.
    pub fn projected(&self, pairs: &[(&[f64], &[f64])]) -> Vec<DVector<f64>> {
        self.with_basis(|basis| {
            let mut workspace = vec![0.0; basis.workspace_len()];
            let project = |(light, material): &(&[f64], &[f64])| {
                let mut d = DVector::zeros(basis.components());
                let light = Light::new(light).expect("a light");
                let material = Material::new(material).expect("a material");
                basis
                    .project_into(&light, &material, &mut workspace, d.as_mut_slice())
                    .expect("a projection");
                d
            };
            pairs.iter().map(project).collect()
        })
    }

    /// √W E and √W m by the runtime.
    pub fn dense(&self) -> (DMatrix<f64>, DVector<f64>) {
        self.with_basis(|basis| {
            let mut workspace = vec![0.0; basis.workspace_len()];
            let mut value = |d: &[f64], pixel: usize| {
                let [x, y, z] = self.normals.normals()[pixel];
                let normal = Normal::new(x, y, z).expect("a visible normal");
                let value = basis.reconstruct(d, normal, &mut workspace).expect("an image");
                self.normals.weights()[pixel].sqrt() * value
            };
            let mut unit = vec![0.0; basis.components()];
            let mean = DVector::from_fn(COUNT, |pixel, _| value(&unit, pixel));
            let mut design = DMatrix::zeros(COUNT, basis.components());
            for component in 0..basis.components() {
                unit[component] = 1.0;
                for pixel in 0..COUNT {
                    design[(pixel, component)] = value(&unit, pixel) - mean[pixel];
                }
                unit[component] = 0.0;
            }
            (design, mean)
        })
    }

    /// The direct sum of a light on a material at the object's normals.
    pub fn image(&self, light: &[f64], material: &[f64]) -> DVector<f64> {
        let reference = DirectSum::new(DEGREE, ORDER);
        let value = |pixel: usize| {
            let modes = reference.at(self.normals.normals()[pixel]);
            modes.irradiance(light, &modes.scatter(material))
        };
        DVector::from_fn(COUNT, |pixel, _| value(pixel))
    }

    pub fn rooted(&self, image: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(COUNT, |pixel, _| self.normals.weights()[pixel].sqrt() * image[pixel])
    }

    pub fn observe(&self, image: &DVector<f64>) -> Observation {
        let values = EigenimageValues::new(&self.table, usize::MAX);
        let mut observer = Observer::new(values, 1);
        let weights = self.normals.weights();
        for ((normal, value), weight) in self.normals.normals().iter().zip(image).zip(weights) {
            observer.see(*normal, &[*value], *weight);
        }
        observer.finish()
    }

    /// The fifth light, at L_0^0 = 1 like all, and the seventh material.
    pub fn pair(&self) -> (Vec<f64>, Vec<f64>) {
        (self.lights()[4].clone(), self.loaded.materials.entries[6].luminance())
    }

    pub fn lights(&self) -> Vec<Vec<f64>> {
        let unit = |entry: &Named| {
            let light = entry.luminance();
            light.iter().map(|value| value / light[0]).collect()
        };
        self.loaded.lights.entries.iter().map(unit).collect()
    }

    pub fn prior(&self) -> (Transfers, Prior) {
        let transfers = Transfers::new(&self.table, usize::MAX);
        let lights = &self.loaded.lights;
        let (normalize, rotation) =
            (self.loaded.scene.light.normalize, self.loaded.scene.light.rotation);
        let weights = equal(lights.entries.len());
        let light =
            LightStatistics::new(lights, normalize, rotation, &weights).expect("statistics");
        let materials = MaterialMoments::new(&self.loaded.materials);
        let prior = Prior::new(&self.table, &transfers, &light, materials).expect("a prior");
        (transfers, prior)
    }
}
