//! The runtime in floats with all components, against the direct sum over modes: GGX dielectrics
//! and metals of roughness 0.2 to 1 and a Lambertian under three captured maps.

use eigenshade_generator::basis;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::shipped;
use eigenshade_table::Table;
use eigenshade_testing::fixtures::named;
use eigenshade_testing::{glossy, repository};
use report::accuracy_cost::errors::compare;
use report::accuracy_cost::images::Images;
use report::accuracy_cost::scope::{Scope, scene};
use report::accuracy_cost::settings::{Format, Recipe, Setting, Way};
use report::sheet::{Record, Sheet};

/// Degrees and orders.
const SHAPES: [[usize; 2]; 2] = [[9, 7], [12, 12]];
/// Three captured maps in their order: a soft sky, small lamps, a low sun.
const LIGHTS: [&str; 3] = ["park", "studio", "sunset"];
/// Errors of all components in f32 and f64 at each shape, relative to the peak: in f32 a few
/// roundings of each of three steps, in f64 the rank's cut-off of 1e-10, which the sharpest lobes
/// amplify. Up to twice what is measured, in f64 four times, as other linear algebra ends at other
/// components.
const ALL_COMPONENTS_AT: [[f64; 2]; 2] = [[2e-6, 4e-7], [1e-5, 2e-7]];

/// Errors of the worst pair of a light and a material, as shares of the image's peak.
struct Errors {
    components: usize,
    method: &'static str,
    format: String,
    largest: f64,
    rms: f64,
}

/// The errors of each method and format at this degree and order.
fn errors([degree, order]: [usize; 2]) -> Vec<Errors> {
    let (table, mut lights, mut seen) = table([degree, order]);
    // Their lobes are too narrow for any order here.
    seen.entries.retain(|material| !material.name.ends_with("-0.1"));
    lights.entries.retain(|light| LIGHTS.contains(&light.name.as_str()));
    assert!(lights.entries.iter().map(|light| light.name.as_str()).eq(LIGHTS));
    let unseen = Materials { order, entries: Vec::new() };
    let mut images = Images::new(&Scope { degree, order, lights, seen, unseen });
    let mut all = Vec::new();
    for (way, method) in [(Way::Polynomial, "polynomial"), (Way::Eigen, "eigen")] {
        if way == Way::Eigen {
            // They take ten times as long: the lamps of the studio are enough.
            let mut light = LIGHTS.into_iter().cycle();
            images.images.retain(|_| light.next() == Some("studio"));
        }
        for format in [Format::F32, Format::F64] {
            let setting = Setting::of(Recipe::all(degree, order)).by(way).in_format(format);
            let errors = compare(&setting, &table, &images).expect("a basis in floats").seen;
            let (largest, rms) = (errors.largest.worst, errors.rms.worst);
            let (components, format) = (table.count(), format.to_string());
            all.push(Errors { components, method, format, largest, rms });
        }
    }
    all
}

/// The table of all components at this degree and order, with its lights and materials.
fn table([degree, order]: [usize; 2]) -> (Table, Lights, Materials) {
    let scene = scene(degree, order, usize::MAX).expect("the shipped scene");
    let mut materials = glossy::materials(order);
    let mut matte = vec![0.0; eigenshade_table::material::count(order)];
    matte[0] = 2.0;
    materials.entries.push(named("lambertian", matte));
    let lights = shipped::lights().expect("the shipped lights").truncated(degree);
    let table = basis::build(&scene, &lights, &materials).expect("a table");
    (table, lights, materials)
}

/// Two methods with every component above a rank cut-off of 1e-10. `docs/float-errors.csv`
/// has the errors in f32.
#[test]
fn floats_are_right_up_to_the_highest_degree() {
    let recorded = Sheet::read(&repository().join("docs/float-errors.csv")).expect("a CSV");
    for (shape, [in_f32, in_f64]) in SHAPES.into_iter().zip(ALL_COMPONENTS_AT) {
        let errors = errors(shape);
        let key = [format!("{}, {}", shape[0], shape[1]), errors[0].components.to_string()];
        let is_it =
            |row: &&Record| ["degree and order", "components"].map(|one| row.text(one)) == key;
        let row = recorded.rows.iter().find(is_it).expect("a row of the table");
        let stated = recorded.columns[2..].iter().filter_map(|column| row.number(column));
        let found = errors.iter().filter(|one| one.format == "f32");
        // The largest error of each method in f32, then the rms and f64 of the polynomials.
        let found = found.map(|one| one.largest).chain([errors[0].rms, errors[1].largest]);
        let stated: Vec<f64> = stated.collect();
        assert_eq!(stated.len(), 4);
        for (column, (found, stated)) in found.zip(stated).enumerate() {
            // Compilers sum in other orders; in f64, other linear algebra ends elsewhere.
            let most = if column == 3 { 4.0 } else { 2.0 };
            let ratio = found / stated;
            assert!((1.0 / most..=most).contains(&ratio), "{shape:?}, {column}: {found:e}");
        }
        for one in errors {
            let method = format!("{shape:?}, {} components, {}", one.components, one.method);
            println!("{method}, {}: {:.1e}, rms {:.1e}", one.format, one.largest, one.rms);
            let allowed = if one.format == "f32" { in_f32 } else { in_f64 };
            assert!(one.largest <= allowed, "{method} in {}: {:e}", one.format, one.largest);
        }
    }
}
