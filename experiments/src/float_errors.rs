//! Errors of the runtime in floats against the direct sum over modes, with all components: GGX
//! dielectrics and metals of roughness 0.2 to 1 and a Lambertian under three captured maps.

use crate::accuracy_cost::errors::compare;
use crate::accuracy_cost::images::Images;
use crate::accuracy_cost::scope::{Scope, scene};
use crate::accuracy_cost::settings::{Format, Recipe, Setting, Way};
use eigenshade_generator::basis;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_shading::shipped;
use eigenshade_table::Table;
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
    pub format: String,
    pub largest: f64,
    pub rms: f64,
}

/// The errors of each method and format at this degree and order.
pub fn errors([degree, order]: [usize; 2]) -> Vec<Errors> {
    let (table, mut lights, mut seen) = table([degree, order]);
    // Their lobes are too narrow for any order here.
    seen.entries.retain(|material| !material.name.ends_with("-0.1"));
    lights.entries.retain(|light| LIGHTS.contains(&light.name.as_str()));
    let unseen = Materials { order, entries: Vec::new() };
    let images = Images::new(&Scope { degree, order, lights, seen, unseen });
    // The number that `shade` uses.
    let knots = (64 * degree).next_power_of_two();
    let ways = [Way::Polynomial, Way::Eigen, Way::Cubic(knots)];
    let error = |format: Format, way, method| {
        let setting = Setting::of(Recipe::all(degree, order)).by(way).in_format(format);
        let errors = compare(&setting, &table, &images).expect("a basis in floats").seen;
        let (largest, rms) = (errors.largest.worst, errors.rms.worst);
        Errors { components: table.count(), method, format: format.to_string(), largest, rms }
    };
    let methods = || ways.into_iter().zip(["polynomial", "eigen", "sampled"]);
    let of = |format| methods().map(move |(way, method)| error(format, way, method));
    [Format::F32, Format::F64].into_iter().flat_map(of).collect()
}

/// The table of all components at this degree and order, with its lights and materials.
pub fn table([degree, order]: [usize; 2]) -> (Table, Lights, Materials) {
    let scene = scene(degree, order, usize::MAX).expect("the shipped scene");
    let mut materials = glossy::materials(order);
    let mut matte = vec![0.0; eigenshade_index::material::count(order)];
    matte[0] = 2.0;
    let rgb = [matte.clone(), matte.clone(), matte];
    materials.entries.push(Named { name: "lambertian".into(), rgb });
    let lights = shipped::lights().expect("the shipped lights").truncated(degree);
    let table = basis::build(&scene, &lights, &materials).expect("a table");
    (table, lights, materials)
}
