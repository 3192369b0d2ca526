//! Errors of the runtime in floats against the direct sum over modes, with all components: GGX
//! dielectrics and metals of roughness 0.2 to 1 and a Lambertian under three captured maps.

use eigenshade::Scalar;
use eigenshade_cli::messages::progress_bar;
use eigenshade_generator::basis;
use eigenshade_generator::scene_file;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_shading::methods::LookUp;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::reference_image;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::Table;
use eigenshade_table::scene::Store;
use eigenshade_testing::glossy;

/// Degrees and orders.
pub const SHAPES: [[usize; 2]; 5] = [[9, 7], [12, 12], [16, 16], [24, 24], [32, 32]];

/// Three captured maps: small lamps, a low sun, a soft sky.
const LIGHTS: [&str; 3] = ["studio", "sunset", "park"];

/// Writes the errors as CSV to standard output.
pub fn print(shapes: &[[usize; 2]]) {
    println!("degree,order,components,method,format,max,rms");
    for &[degree, order] in shapes {
        for Errors { components, method, format, largest, rms } in errors([degree, order]) {
            println!("{degree},{order},{components},{method},{format},{largest:.1e},{rms:.1e}");
        }
    }
}

/// Errors of the worst pair of a light and a material, as shares of the image's peak.
pub struct Errors {
    pub components: usize,
    pub method: &'static str,
    pub format: &'static str,
    pub largest: f64,
    pub rms: f64,
}

/// The errors of each method and format at this degree and order.
pub fn errors(shape: [usize; 2]) -> Vec<Errors> {
    let inputs = Inputs::new(shape);
    let mut errors = inputs.compare::<f32>("f32");
    errors.extend(inputs.compare::<f64>("f64"));
    errors
}

struct Inputs {
    table: Table,
    lights: Lights,
    materials: Materials,
    normals: Vec<[f64; 3]>,
    /// Irradiances by normal, then by light, then by material.
    reference: Vec<Vec<[f64; 3]>>,
}

/// The table of all components at this degree and order, with its lights and materials.
pub fn table([degree, order]: [usize; 2]) -> (Table, Lights, Materials) {
    let root = eigenshade_testing::repository();
    let mut scene = scene_file::load(root.join("tables/sphere.toml")).expect("a scene").scene;
    scene.light.degree = degree;
    scene.material.order = order;
    scene.basis.components = Some(usize::MAX);
    scene.basis.store = Store::Projection;
    let mut materials = glossy::materials(order);
    let mut matte = vec![0.0; eigenshade_index::material::count(order)];
    matte[0] = 2.0;
    let rgb = [matte.clone(), matte.clone(), matte];
    materials.entries.push(Named { name: "lambertian".into(), rgb });
    let path = root.join("tables/inputs/lights.csv");
    let lights = read_lights(path.as_path(), Some(degree)).expect("the shipped lights");
    let table = basis::build(&scene, &lights, &materials).expect("a table");
    (table, lights, materials)
}

impl Inputs {
    fn new(shape: [usize; 2]) -> Self {
        let (table, mut lights, mut materials) = table(shape);
        // Their lobes are too narrow for any order here.
        materials.entries.retain(|material| !material.name.ends_with("-0.1"));
        lights.entries.retain(|light| LIGHTS.contains(&light.name.as_str()));
        lights.entries.iter_mut().for_each(Named::remove_color);
        let normals = normals();
        let progress = progress_bar("normals", normals.len());
        let reference = reference_image::images(&lights, &materials, &normals, &progress);
        Self { table, lights, materials, normals, reference }
    }

    fn compare<S: Scalar + Into<f64>>(&self, format: &'static str) -> Vec<Errors> {
        let owned = OwnedBasis::<S>::new(&self.table);
        let mut shader = Shader::new(owned.any().expect("a basis"), usize::MAX);
        let Self { lights, materials, normals, reference, .. } = self;
        let rounded = OwnedNormals::<S>::new(normals);
        let each = rounded.each().expect("normals");
        // The number that `shade` uses.
        let knots = (64 * lights.degree).next_power_of_two();
        let mut of_method = |method| {
            let (mut largest, mut rms): (f64, f64) = (0.0, 0.0);
            for (i, light) in lights.entries.iter().enumerate() {
                for (j, material) in materials.entries.iter().enumerate() {
                    let light = (lights.degree, light.rgb[0].as_slice());
                    let material = (materials.order, material.rgb[0].as_slice());
                    let image = match method {
                        "polynomial" => shader.polynomial(light, material, &rounded),
                        "eigen" => shader.eigen(light, material, &each),
                        _ => shader.looked_up(light, material, &each, LookUp::Cubic { knots }),
                    };
                    let exact = reference.iter().map(|one| one[i * materials.entries.len() + j][0]);
                    let peak = exact.clone().map(f64::abs).fold(0.0, f64::max);
                    let pairs = image.expect("an image").into_iter().zip(exact);
                    let off: Vec<f64> =
                        pairs.map(|(found, exact)| (found.into() - exact).abs() / peak).collect();
                    let square: f64 = off.iter().map(|off| off * off).sum();
                    largest = off.iter().copied().fold(largest, f64::max);
                    rms = rms.max((square / off.len() as f64).sqrt());
                }
            }
            Errors { components: self.table.count(), method, format, largest, rms }
        };
        ["polynomial", "eigen", "table"].map(&mut of_method).into()
    }
}

/// The axis, a spiral of equal areas on the disc, and the rim.
fn normals() -> Vec<[f64; 3]> {
    let spiral = (0..250).map(|k| ((f64::from(k) + 0.5) / 250.0, 2.399_963 * f64::from(k)));
    let rim = (0..24).map(|k| (1.0, 0.26 * f64::from(k)));
    let at = |(square, tilt): (f64, f64)| {
        let (sine, (y, x)) = (square.sqrt(), tilt.sin_cos());
        [sine * x, sine * y, (1.0 - square).sqrt()]
    };
    std::iter::once((0.0, 0.0)).chain(spiral).chain(rim).map(at).collect()
}
