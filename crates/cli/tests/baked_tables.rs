//! Tables of many kinds as compiled code: the generated source of each is compiled and
//! run, and gives what the table read at run time gives.

use crate::support::{Folder, compiled, lights, materials};
use crate::tolerances;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::{Table, decode, rust_source};
use std::fmt::Write;
use std::fs;

/// Cubics through 48 knots, of the largest irradiance of four normals: the fourth power of 1/48, 2e-7, times some fourth
/// derivative, and roundings of f32; twice what was measured, 1e-6 at degree 17.
const SAMPLED_CUBIC: f32 = 2e-6;

/// The same of an object's image: it is summed over the whole span, whose weakest polynomials are steep
/// and cancel; twice what was measured.
const SAMPLED_CUBIC_OBJECT: f32 = 5e-4;

const NORMALS: [[f64; 3]; 4] =
    [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.48, 0.6, 0.64], [0.28, -0.96, 0.0]];

/// Name, geometry, rotation, degree, order, criterion, components, modes.
type Kind = (&'static str, &'static str, &'static str, usize, usize, &'static str, usize, usize);

const KINDS: [Kind; 7] = [
    ("centred", "sphere", "any", 9, 7, "image-centered", 37, 0),
    ("standard", "sphere", "any", 4, 3, "standard", 20, 0),
    ("selected", "sphere", "any", 5, 4, "image-centered", 30, 200),
    ("lambertian", "sphere", "any", 2, 0, "image-centered", 9, 0),
    ("high", "sphere", "any", 17, 12, "image-centered", 60, 0),
    ("object", "object.csv", "vertical", 4, 3, "image-centered", 25, 0),
    ("captured", "object.csv", "none", 4, 3, "standard", 12, 0),
];

fn table(folder: &Folder, kind: &Kind) -> (Table, Lights, Materials) {
    let (name, normals, rotation, degree, order, criterion, components, modes) = kind;
    folder.write("lights.csv", lights(*degree, 3));
    folder.write("materials.csv", materials(*order, 4));
    folder.write("object.csv", "x,y,z\n0,0,1\n0.1,0.2,1\n1,0,1\n1,1,1\n0.5,-0.7,1\n-0.2,0.4,1\n");
    folder.write(
        "scene.toml",
        format!(
            "[geometry]\nnormals = \"{normals}\"\n\
             [light]\ndegree = {degree}\ndatabase = \"lights.csv\"\nrotation = \"{rotation}\"\n\
             [material]\norder = {order}\ndatabase = \"materials.csv\"\n\
             [basis]\ncriterion = \"{criterion}\"\ncomponents = {components}\nmodes = {modes}\nknots = 48\n"
        ),
    );
    let file = format!("{name}.bin");
    folder.ok(&format!("basis --scene scene.toml --out {file}"));
    let table = decode(&fs::read(folder.path(&file)).expect("a table")).expect("a table");
    let lights = read_lights(folder.path("lights.csv"), Some(*degree)).expect("lights");
    let materials = read_materials(folder.path("materials.csv"), Some(*order)).expect("materials");
    (table, lights, materials)
}

/// A program that prints d by `project`, d by `transfer` and `relight`, the irradiance of
/// the normals, and how far sampled profiles are from that at most.
fn program(names: &[&str], numbers: &[(Vec<f64>, Vec<f64>)]) -> String {
    let mut text = String::new();
    for name in names {
        writeln!(text, "mod {name} {{ include!(\"{name}.rs\"); }}").expect("text");
    }
    text.push_str("fn main() {\n");
    for (name, (light, material)) in names.iter().zip(numbers) {
        writeln!(
            text,
            "{{
    let light: &[f32] = &{light:?};
    let material: &[f32] = &{material:?};
    let light = eigenshade::Light::new({name}::DEGREE, light).unwrap();
    let material = eigenshade::Material::new({name}::ORDER, material).unwrap();
    let d = {name}::project(&light, &material).unwrap();
    let transfer = {name}::transfer(&material).unwrap();
    let relit = {name}::relight(&transfer, &light).unwrap();
    let scene = {name}::collapse(&d).unwrap();
    assert_eq!(d.len(), {name}::COMPONENTS);
    let normals: [[f32; 3]; {}] = {NORMALS:?};
    for value in d.iter().chain(&relit) {{ print!(\"{{value:?}} \"); }}
    let sampled = {name}::lookup(&scene).unwrap();
    assert_eq!({name}::KNOTS, 48);
    let mut apart = 0.0f32;
    for [x, y, z] in normals {{
        let normal = eigenshade::Normal::new(x, y, z).unwrap();
        apart = apart.max((sampled.cubic(normal) - scene.shade(normal)).abs());
        print!(\"{{:?}} \", scene.shade(normal));
    }}
    println!(\"{{apart:?}}\");
}}",
            NORMALS.len(),
        )
        .expect("text");
    }
    text.push_str("}\n");
    text
}

/// Luminance, rounded as the program has it.
fn rounded(values: Vec<f64>) -> Vec<f64> {
    values.into_iter().map(|value| f64::from(value as f32)).collect()
}

#[test]
fn compiled_tables_give_what_tables_read_give() {
    let folder = Folder::new();
    fs::create_dir(folder.path("src")).expect("a folder");
    let (mut expected, mut numbers) = (Vec::new(), Vec::new());
    for kind in &KINDS {
        let (table, lights, materials) = table(&folder, kind);
        let source = rust_source::module(&table, "a test");
        fs::write(folder.path("src").join(format!("{}.rs", kind.0)), source).expect("a file");
        let light = rounded(lights.entries[1].luminance());
        let material = rounded(materials.entries[2].luminance());
        let owned = OwnedBasis::<f32>::new(&table);
        let mut shader = Shader::new(owned.any().expect("a basis"), usize::MAX);
        let (of_light, of_material) =
            ((lights.degree, light.as_slice()), (materials.order, material.as_slice()));
        let d = shader.project(of_light, of_material).expect("d").to_vec();
        let normals = OwnedNormals::new(&NORMALS);
        let image = shader.polynomial(of_light, of_material, &normals).expect("an image");
        expected.push((d, image));
        numbers.push((light, material));
    }
    let names: Vec<&str> = KINDS.iter().map(|kind| kind.0).collect();
    fs::write(folder.path("src/main.rs"), program(&names, &numbers)).expect("a file");
    let text = compiled(&folder);
    assert_eq!(text.lines().count(), KINDS.len());
    for ((line, (d, image)), name) in text.lines().zip(&expected).zip(names) {
        let mut found: Vec<f32> =
            line.split_whitespace().map(|number| number.parse().expect("a number")).collect();
        let cubic = found.pop().expect("the last number");
        let wanted: Vec<f32> = d.iter().chain(d).chain(image).copied().collect();
        assert_eq!(found.len(), wanted.len(), "{name}");
        let peak = image.iter().fold(0.0f32, |most, value| most.max(value.abs()));
        let is_sphere = KINDS.iter().any(|kind| kind.0 == name && kind.1 == "sphere");
        let (off, allowed) = match is_sphere {
            true => (cubic / peak, SAMPLED_CUBIC),
            false => (cubic / peak, SAMPLED_CUBIC_OBJECT),
        };
        println!("{name}: cubics off by {off:.1e} of the peak");
        assert!(off <= allowed, "{name}: cubics off by {off:e}");
        let largest = wanted.iter().fold(0.0f32, |most, value| most.max(value.abs()));
        for (k, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
            let apart = (found - wanted).abs() / largest;
            assert!(apart <= tolerances::SAME_SUM_F32, "{name}, number {k}: {found} {wanted}");
        }
    }
}
